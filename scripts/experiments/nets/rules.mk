$(eval $(call experiment,nets,gapnet gapcheck,net/mooring net/square net/saddle plot/net plot/gaps plot/restoring))
