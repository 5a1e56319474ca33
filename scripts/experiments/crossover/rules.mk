# The modal crossover; see run.
experiments: experiment-crossover
experiment-crossover: $(BUILD)/experiments/crossover/table.txt
	@echo 'tables and pictures: $(<D)'
$(BUILD)/experiments/crossover/table.txt: scripts/experiments/crossover/run \
  scripts/experiments/crossover/case.ini scripts/plot/crossover $(STUDY)
	$(RUN_STUDY)
.PHONY: experiment-crossover
