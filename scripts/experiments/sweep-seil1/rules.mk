# Response curves of rope 1, up and down; see run.
experiments: experiment-sweep-seil1
experiment-sweep-seil1: $(BUILD)/experiments/sweep-seil1/table.txt
	@echo 'tables and pictures: $(<D)'
$(BUILD)/experiments/sweep-seil1/table.txt: scripts/experiments/sweep-seil1/run \
  scripts/experiments/sweep-seil1/case.ini scripts/plot/sweep $(STUDY) $(BUILD)/bin/diffverf
	$(RUN_STUDY)
.PHONY: experiment-sweep-seil1
