$(eval $(call experiment,damping,catenary modal diffverf,plot/damping experiments/ben-ahin/case.ini experiments/seil1-whirl/case.ini experiments/seil2-whirl/case.ini))
