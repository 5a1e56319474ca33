# Limit amplitudes of rope 2 over frequency and amplitude; see run.
experiments: experiment-ensemble-seil2
experiment-ensemble-seil2: $(BUILD)/experiments/ensemble-seil2/table.txt
	@echo 'tables and pictures: $(<D)'
$(BUILD)/experiments/ensemble-seil2/table.txt: scripts/experiments/ensemble-seil2/run \
  scripts/experiments/ensemble-seil2/case.ini scripts/plot/ensemble $(STUDY) $(BUILD)/bin/diffverf $(BUILD)/bin/stabil
	$(RUN_STUDY)
.PHONY: experiment-ensemble-seil2
