$(eval $(call experiment,stability-modes,catenary modal stabil,plot/regions))
