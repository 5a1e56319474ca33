$(eval $(call experiment,ensemble-seil2,catenary diffverf modal stabil,study plot/ensemble))
