$(eval $(call experiment,shape-change,catenary modal,plot/shape-change experiments/hang.sh))
