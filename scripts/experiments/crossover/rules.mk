$(eval $(call experiment,crossover,catenary modal,plot/crossover experiments/study.sh))
