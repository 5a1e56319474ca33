$(eval $(call experiment,ensemble-seil2,catenary diffverf modal stabil,plot/ensemble experiments/study.sh))
