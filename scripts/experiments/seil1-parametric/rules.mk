$(eval $(call experiment,seil1-parametric,catenary modal diffverf,single-cable plot/line plot/modes plot/response plot/path plot/history experiments/cable.sh))
