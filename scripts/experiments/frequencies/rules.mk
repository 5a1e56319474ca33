$(eval $(call experiment,frequencies,catenary modal,plot/frequencies experiments/seil1-whirl/case.ini experiments/seil2-whirl/case.ini))
