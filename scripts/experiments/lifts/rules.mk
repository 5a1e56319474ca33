$(eval $(call experiment,lifts,sling,plot/lift plot/righting plot/heights plot/curves))
