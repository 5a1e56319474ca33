$(eval $(call experiment,seil2-ellipse,catenary modal diffverf,single-cable plot/line plot/modes plot/response plot/path plot/history experiments/cable.sh orbit))
