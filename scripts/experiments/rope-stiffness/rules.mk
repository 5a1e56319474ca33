$(eval $(call experiment,rope-stiffness,gapnet,plot/rope-stiffness))
