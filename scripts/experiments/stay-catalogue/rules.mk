$(eval $(call experiment,stay-catalogue,catenary modal stabil,plot/catalogue nearest-resonance study))
