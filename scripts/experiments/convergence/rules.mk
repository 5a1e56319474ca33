$(eval $(call experiment,convergence,catenary modal,plot/convergence experiments/hang.sh))
