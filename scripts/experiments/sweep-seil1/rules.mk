$(eval $(call experiment,sweep-seil1,catenary diffverf modal,plot/sweep experiments/study.sh))
