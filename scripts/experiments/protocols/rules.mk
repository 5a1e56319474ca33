$(eval $(call experiment,protocols,catenary modal diffverf,plot/protocol))
