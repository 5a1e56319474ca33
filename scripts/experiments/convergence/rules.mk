# Convergence with the mesh in the three laws; see run.
experiments: experiment-convergence
experiment-convergence: $(BUILD)/experiments/convergence/table.txt
	@echo 'tables and pictures: $(<D)'
$(BUILD)/experiments/convergence/table.txt: scripts/experiments/convergence/run \
  scripts/experiments/convergence/case.ini scripts/plot/convergence $(STUDY)
	$(RUN_STUDY)
.PHONY: experiment-convergence
