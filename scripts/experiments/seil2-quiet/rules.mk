$(eval $(call experiment,seil2-quiet,catenary modal diffverf stabil,single-cable plot/line plot/modes plot/response plot/path plot/history experiments/cable.sh check-point))
