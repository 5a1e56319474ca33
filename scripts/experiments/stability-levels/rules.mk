$(eval $(call experiment,stability-seil2,catenary diffverf modal stabil,plot/stability check-point experiments/study.sh))
