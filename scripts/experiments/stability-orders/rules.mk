$(eval $(call experiment,stability-orders,catenary modal stabil,plot/regions experiments/hang.sh))
