$(eval $(call experiment,crossover,catenary modal,plot/crossover experiments/hang.sh))
