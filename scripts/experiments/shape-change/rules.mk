# The first symmetric shape through lambda^2 = 4 pi^2; see run.
experiments: experiment-shape-change
experiment-shape-change: $(BUILD)/experiments/shape-change/table.txt
	@echo 'tables and pictures: $(<D)'
$(BUILD)/experiments/shape-change/table.txt: scripts/experiments/shape-change/run \
  scripts/experiments/shape-change/case.ini scripts/plot/shape-change $(STUDY)
	$(RUN_STUDY)
.PHONY: experiment-shape-change
