# Stability maps of SEIL2; see run.
experiments: experiment-stability-seil2
experiment-stability-seil2: $(BUILD)/experiments/stability-seil2/table.txt
	@echo 'tables and pictures: $(<D)'
$(BUILD)/experiments/stability-seil2/table.txt: scripts/experiments/stability-seil2/run \
  scripts/experiments/stability-seil2/case.ini scripts/plot/stability scripts/check-point \
  $(BUILD)/bin/stabil $(BUILD)/bin/diffverf $(STUDY)
	$(RUN_STUDY)
.PHONY: experiment-stability-seil2
