$(eval $(call experiment,lift-uncertainty,sling,plot/distribution study))
