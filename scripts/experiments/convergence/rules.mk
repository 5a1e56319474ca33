$(eval $(call experiment,convergence,catenary modal,plot/convergence experiments/study.sh))
