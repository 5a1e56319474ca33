$(eval $(call experiment,wires,wirebeam,plot/wire wire/arc wire/ring wire/straight wire/helix wire/spiral wire/strand wire/steel.sh))
