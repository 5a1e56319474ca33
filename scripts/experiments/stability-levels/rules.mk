$(eval $(call experiment,stability-levels,catenary modal stabil diffverf,plot/regions plot/stability check-point))
