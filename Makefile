# Seilwerk.  make help lists the targets; the README tells the rest.

PREFIX = /usr/local
DESTDIR =
PROGRAM_PREFIX =
BUILD = build

# The user's: they come last and win.
CFLAGS = -O3 -g
CPPFLAGS =
LDFLAGS =

VERSION := $(shell cat VERSION)
WARN = -Wall -Wextra -Wshadow -Wconversion
HARDEN_CPP = -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2
HARDEN = -fstack-protector-strong -fPIE
HARDEN_LD = -pie -Wl,-z,relro,-z,now
OWN_CPPFLAGS = -D_GNU_SOURCE -DSEILWERK_VERSION='"$(VERSION)"' -Icommon \
  $(if $(filter -O0,$(CFLAGS)),,$(HARDEN_CPP))
# No fused products that the source does not ask for: the same digits on every processor.
OWN_CFLAGS = -std=c11 -ffp-contract=off $(WARN) $(HARDEN)
COMPILE = $(CC) $(OWN_CPPFLAGS) $(OWN_CFLAGS) $(CPPFLAGS) $(CFLAGS)
LINK = $(CC) $(OWN_CFLAGS) $(HARDEN_LD) $(CFLAGS) $(LDFLAGS)
# OpenMP where the compiler has it; without it maps are computed in one thread.
OPENMP := $(shell echo 'int main(void) { return 0; }' | $(CC) -fopenmp -x c - -o /dev/null 2>/dev/null && \
  echo -fopenmp)
OWN_CFLAGS += $(if $(OPENMP),$(OPENMP),-Wno-unknown-pragmas)
LIBS = -Wl,--as-needed -lcholmod -larpack -llapacke -lopenblas -linih -lcsv -lm

TOOLS = $(patsubst tools/%.c,%,$(wildcard tools/*.c))
COMMON = $(patsubst %.c,$(BUILD)/obj/%.o,$(wildcard common/*/*.c))
LIB = $(BUILD)/libseilwerk.a
UNIT = $(patsubst tests/unit/%.c,$(BUILD)/tests/%,$(wildcard tests/unit/*_test.c))
FUZZ = $(patsubst tests/fuzz/%.c,$(BUILD)/tests/fuzz_%,$(wildcard tests/fuzz/*_fuzz.c))
HELPERS = $(BUILD)/tests/compare $(BUILD)/tests/faults.so
MAN = $(wildcard man/*.[1-9])

# Packages come before anything is compiled, if the goal is one that installs them.
FIRST = $(if $(filter check check-deep,$(MAKECMDGOALS)),deps-check) \
  $(if $(filter demo experiment%,$(MAKECMDGOALS)),deps-demo) \
  $(if $(filter report,$(MAKECMDGOALS)),deps-report) \
  $(if $(filter bench,$(MAKECMDGOALS)),deps-build) \
  $(if $(filter check-hosts,$(MAKECMDGOALS)),deps-hosts)

all: $(TOOLS:%=$(BUILD)/bin/%)

help:
	@echo 'all          build the tools into $(BUILD)/bin'
	@echo 'demo         run the pipeline on a real stay cable; tables, CSV and PNG in $(BUILD)/demo'
	@echo 'experiments  every table and figure of the documents in $(BUILD)/experiments; QUICK=yes: coarser,'
	@echo '             in $(BUILD)/quick; one of them: experiment-NAME, of'
	@printf '             %s %s %s %s\n' $(EXPERIMENTS)
	@echo 'report       experiments, then one HTML page and one PDF of them all'
	@echo 'check        all tests;  check-deep: sanitizers, valgrind, long fuzzing, 1e8 numbers'
	@echo 'coverage     lines and branches of common/num, phys, sys that the tests run, and the bounds'
	@echo 'mutate       change common/phys in 60 places, one at a time: does a test fail?'
	@echo 'check-hosts  studies over several hosts: sshd on loopback, a Slurm of one node, killed in mid-study'
	@echo 'fuzz         libFuzzer on every reader, SECONDS=60 each; fuzz-afl: AFL++'
	@echo 'analyze      gcc -fanalyzer, cppcheck, clang-tidy'
	@echo 'bench        rates beside their targets'
	@echo 'install, uninstall (PREFIX, DESTDIR, PROGRAM_PREFIX), clean'
	@echo 'dist, deb    source archive; Debian source and binary package in $(BUILD)/deb'
	@echo 'deps         install the Debian packages of the classes (deps-build, -check, -demo, -package ...)'

# Changed only when compiler or flags change: then everything is built again.
FLAGS = $(COMPILE) $(HARDEN_LD) $(LDFLAGS)
$(BUILD)/flags: always
	@mkdir -p $(@D)
	@printf '%s\n' '$(subst ','\'',$(FLAGS))' | cmp -s - $@ || \
	  printf '%s\n' '$(subst ','\'',$(FLAGS))' >$@

$(BUILD)/obj/%.o: %.c VERSION $(BUILD)/flags | $(FIRST)
	@mkdir -p $(@D)
	$(COMPILE) -MMD -MP -c -o $@ $<

$(LIB): $(COMMON)
	rm -f $@
	$(AR) rcs $@ $(COMMON)

$(BUILD)/bin/%: $(BUILD)/obj/tools/%.o $(LIB)
	@mkdir -p $(@D)
	$(LINK) -o $@ $< $(LIB) $(LIBS)

$(BUILD)/tests/%: $(BUILD)/obj/tests/unit/%.o $(LIB)
	@mkdir -p $(@D)
	$(LINK) -o $@ $< $(LIB) -lcmocka $(LIBS)

$(BUILD)/tests/compare: $(BUILD)/obj/tests/compare.o $(LIB)
	@mkdir -p $(@D)
	$(LINK) -o $@ $< $(LIB) $(LIBS)

$(BUILD)/tests/bench: $(BUILD)/obj/tests/bench.o $(LIB)
	@mkdir -p $(@D)
	$(LINK) -o $@ $< $(LIB) $(LIBS)

$(BUILD)/tests/faults.so: tests/fault/faults.c | $(FIRST)
	@mkdir -p $(@D)
	$(CC) $(OWN_CPPFLAGS) -std=c11 $(WARN) -O1 -fPIC -shared -o $@ $< -ldl

# A fuzz target without a fuzzer: replays the files that it is given.  In the one of the options exit
# comes back into the target.
WRAP = $(if $(filter %opt_fuzz,$@),-Wl$(comma)--wrap=exit)
comma = ,
$(BUILD)/tests/fuzz_%: $(BUILD)/obj/tests/fuzz/%.o $(BUILD)/obj/tests/fuzz/replay.o $(LIB)
	@mkdir -p $(@D)
	$(LINK) -o $@ $^ $(WRAP) $(LIBS)

# The same by libFuzzer and by AFL++: all of common once for each engine, then the targets.
# engine DIR,COMPILER,FLAGS,FLAGS OF THE LINK
FUZZED = $(patsubst %.c,%.o,$(wildcard common/*/*.c))
TARGETS = $(patsubst tests/fuzz/%.c,%,$(wildcard tests/fuzz/*_fuzz.c))
define engine
$(BUILD)/$(1)/obj/%.o: %.c $(wildcard common/*/*.h tests/fuzz/*.h)
	@mkdir -p $$(@D)
	$(2) $(OWN_CPPFLAGS) -std=c11 -g -O1 $(3) -c -o $$@ $$<
$(BUILD)/$(1)/lib.a: $(FUZZED:%=$(BUILD)/$(1)/obj/%)
	$(AR) rcs $$@ $$^
$(TARGETS:%=$(BUILD)/$(1)/%): $(BUILD)/$(1)/%: $(BUILD)/$(1)/obj/tests/fuzz/%.o $(BUILD)/$(1)/lib.a
	$(2) $(4) -o $$@ $$^ $$(WRAP) $(LIBS)
endef
$(eval $(call engine,fuzz,clang,-fsanitize=fuzzer-no-link$(comma)address$(comma)undefined,\
  -fsanitize=fuzzer$(comma)address$(comma)undefined))
$(eval $(call engine,afl,afl-clang-fast,,-fsanitize=fuzzer))
LIBFUZZ = $(TARGETS:%=$(BUILD)/fuzz/%)

# make fuzz SECONDS=600 grows the corpus under $(BUILD)/corpus, each reader for so long; fuzz-afl too.
# Every reader has its time, whatever another has found.
SECONDS = 60
fuzz: $(LIBFUZZ)
	@bad=0; for n in $(TARGETS); do mkdir -p $(BUILD)/corpus/$$n; \
	  $(BUILD)/fuzz/$$n -max_total_time=$(SECONDS) -max_len=4096 -timeout=10 -print_final_stats=1 \
	    -close_fd_mask=1 -artifact_prefix=$(BUILD)/corpus/$$n- $(BUILD)/corpus/$$n \
	    tests/fuzz/corpus/$${n%_fuzz} || bad=1; done; exit $$bad

fuzz-afl: deps-optional $(TARGETS:%=$(BUILD)/afl/%)
	@bad=0; for n in $(TARGETS); do mkdir -p $(BUILD)/corpus/afl; \
	  AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_SKIP_CPUFREQ=1 AFL_NO_UI=1 AFL_AUTORESUME=1 \
	    afl-fuzz -V $(SECONDS) -i tests/fuzz/corpus/$${n%_fuzz} -o $(BUILD)/corpus/afl/$$n \
	    -t 10000 -- $(BUILD)/afl/$$n >$(BUILD)/corpus/afl/$$n.log 2>&1 || bad=1; \
	  found=$$(find $(BUILD)/corpus/afl/$$n -path '*crashes/id*' -o -path '*hangs/id*'); \
	  echo "$$n: $$(grep -h execs_done $(BUILD)/corpus/afl/$$n/default/fuzzer_stats) $$found"; \
	  [ -z "$$found" ] || bad=1; done; exit $$bad

-include $(COMMON:.o=.d) $(wildcard $(BUILD)/obj/tools/*.d $(BUILD)/obj/tests/*.d $(BUILD)/obj/tests/*/*.d)

# Packages: scripts/packages is the one list.
deps: deps-build deps-check deps-demo deps-report deps-optional
deps-build:
	@scripts/deps build
deps-check:
	@scripts/deps build check
deps-demo:
	@scripts/deps build demo
deps-report:
	@scripts/deps build demo report
deps-optional:
	@scripts/deps optional
# Not among all: the tools of Debian packages; an ssh server and Slurm.
deps-package:
	@scripts/deps build package
deps-hosts:
	@scripts/deps build check hosts

demo: all
	@PATH='$(abspath $(BUILD))/bin':$$PATH OPENBLAS_NUM_THREADS=1 scripts/demo '$(BUILD)/demo'

# Experiments: every table and figure of the documents.  scripts/experiments/NAME/rules.mk tells with
# which tools and scripts one is made.  It is run again only when its folder, one of these, or what
# all share has changed; its comparison with published numbers when these have.
# QUICK=yes: coarser grids and shorter runs, beside the full ones.
QUICK =
BIN = $(BUILD)/bin
RESULTS = $(BUILD)/$(if $(QUICK),quick,experiments)
EXPERIMENTS = $(patsubst scripts/experiments/%/rules.mk,%,$(wildcard scripts/experiments/*/rules.mk))
WITH_TOOLS = @PATH='$(abspath $(BIN))':$$PATH QUICK='$(QUICK)' PICTURES=svg
COMPARED = about rules.mk published.csv computed

# experiment NAME,TOOLS,SCRIPTS
define experiment
experiments: experiment-$(1)
experiment-$(1): $$(RESULTS)/$(1)/done \
  $(if $(wildcard scripts/experiments/$(1)/published.csv),$$(RESULTS)/$(1)/comparison.csv)
	@echo '$(1): $$(RESULTS)/$(1)'
$$(RESULTS)/$(1)/done: $(filter-out $(COMPARED:%=scripts/experiments/$(1)/%),$(shell \
  find scripts/experiments/$(1) -type f)) scripts/experiment scripts/experiments/begin.sh \
  $(if $(filter plot/%,$(3)),scripts/plot/setup.sh) $(3:%=scripts/%) $(2:%=$$(BIN)/%)
	$$(WITH_TOOLS) scripts/experiment run scripts/experiments/$(1) $$(@D)
$$(RESULTS)/$(1)/comparison.csv: $$(RESULTS)/$(1)/done scripts/published scripts/experiments/compute.sh \
  $(wildcard scripts/experiments/$(1)/published.csv scripts/experiments/$(1)/computed)
	$$(WITH_TOOLS) scripts/experiment compare scripts/experiments/$(1) $$(@D)
.PHONY: experiment-$(1)
endef

experiments:
include $(EXPERIMENTS:%=scripts/experiments/%/rules.mk)

report: $(RESULTS)/report.pdf
	@echo 'report: $(RESULTS)/report.html and report.pdf'
$(RESULTS)/report.html: experiments scripts/report scripts/experiments/contents VERSION \
  $(wildcard scripts/experiments/*/about)
	@scripts/report $(if $(QUICK),--quick) scripts/experiments $(RESULTS) >$@
$(RESULTS)/report.pdf: $(RESULTS)/report.html scripts/html2pdf
	@scripts/html2pdf $< $@

# Tests send signals, which nohup would have them ignore.
TEST_ENV = env --default-signal=HUP,INT SEILWERK_BUILD='$(abspath $(BUILD))' PATH='$(abspath $(BUILD))/bin':$$PATH \
  OPENBLAS_NUM_THREADS=1 CMOCKA_MESSAGE_OUTPUT=TAP CC='$(CC)'
SUITES = $(UNIT) $(sort $(wildcard tests/cli/*.sh tests/cross/*.sh tests/fault/*.sh))

# Where clang and its fuzzer are, the readers are fuzzed for some seconds, too.
CAN_FUZZ = $(shell echo 'int LLVMFuzzerTestOneInput(void) { return 0; }' | \
  clang -fsanitize=fuzzer -x c - -o /dev/null 2>/dev/null && echo yes)
test-programs: all $(UNIT) $(FUZZ) $(HELPERS) $(if $(filter check,$(MAKECMDGOALS)),$(if $(CAN_FUZZ),$(LIBFUZZ)))

check: test-programs
	@$(TEST_ENV) prove -j2 $(SUITES)

check-unit: $(UNIT)
	@$(TEST_ENV) prove $(UNIT)

# The same tests under the sanitizers, then what takes long.  Other flags need another build tree:
# the one place where make calls itself.
SANITIZE = -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
RACES = -O1 -g -fno-omit-frame-pointer -fsanitize=thread
check-deep: deps-optional check
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/asan CFLAGS='$(SANITIZE)' HARDEN_CPP= test-programs
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/asan CFLAGS='$(SANITIZE)' HARDEN_CPP= check-sanitized
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/clang CC=clang test-programs
	-@$(MAKE) --no-print-directory BUILD=$(BUILD)/tsan CC=clang CFLAGS='$(RACES)' HARDEN_CPP= all
	@$(TEST_ENV) SEILWERK_DEEP=1 prove $(sort $(wildcard tests/deep/*.sh))
	@$(MAKE) --no-print-directory fuzz

check-sanitized:
	@$(TEST_ENV) SEILWERK_SANITIZED=1 ASAN_OPTIONS=detect_leaks=0 prove -j2 $(UNIT) \
	  $(sort $(wildcard tests/cli/*.sh))

# What the tests have run, in a build of its own: without functions folded into others, where each
# branch would be counted once more, and with the calls by which a dying process saves its counts.
# Old counts go first; a test that fails is told, and no matter.
COVERAGE = -O1 -g --coverage -fprofile-update=atomic -fno-inline \
  -Wl,-u,__gcov_dump,-u,__gcov_reset
coverage:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/coverage CFLAGS='$(COVERAGE)' HARDEN_CPP= test-programs
	@find $(BUILD)/coverage/obj -name '*.gcda' -delete
	-@$(MAKE) --no-print-directory BUILD=$(BUILD)/coverage CFLAGS='$(COVERAGE)' HARDEN_CPP= \
	  check-coverage
	@scripts/coverage $(BUILD)/coverage

check-coverage:
	@$(TEST_ENV) prove -j2 $(UNIT) $(sort $(wildcard tests/cli/*.sh tests/fault/*.sh))

# A sample of small changes of common/phys: does a test notice?  Not part of check.
mutate:
	@scripts/mutate --build $(BUILD) --count 60

# Not part of check: it starts servers, of ssh and of Slurm.
check-hosts: all
	@$(TEST_ENV) prove $(sort $(wildcard tests/hosts/*.sh))

# Findings are mended, or told beside the line why they are none; .clang-tidy has its own reasons.
# clang-tidy gets one file at a time: in a second one clang 14 takes every va_list for unset.
ANALYZE = $(OWN_CPPFLAGS) -std=c11
analyze: deps-optional
	@for f in $(wildcard common/*/*.c tools/*.c); do \
	  gcc $(ANALYZE) -O1 -fanalyzer -Werror -c -o /dev/null $$f || exit 1; done
	@cppcheck --enable=warning,performance,portability --inline-suppr --quiet --error-exitcode=1 \
	  $(filter -D%,$(ANALYZE)) -Icommon common tools tests
	@for f in $(wildcard common/*/*.c tools/*.c); do \
	  clang-tidy --quiet $$f -- $(ANALYZE) 2>/dev/null || exit 1; done

bench: all $(BUILD)/tests/bench
	@PATH='$(abspath $(BUILD))/bin':$$PATH OPENBLAS_NUM_THREADS=1 $(BUILD)/tests/bench

SHARE = $(PREFIX)/share
# Where scripts/study finds its parts, from the place and the name that it is installed with; and
# the list of the directories that were made, for make uninstall.
OWN = $(SHARE)/$(PROGRAM_PREFIX)seilwerk
# Completion: files of the names that the commands are installed with.
BASH_FILES = $(SHARE)/bash-completion/completions
ZSH_FILES = $(SHARE)/zsh/site-functions
COMMANDS = $(TOOLS) seilwerk-study

install: all
	@scripts/directories make '$(DESTDIR)' '$(OWN)/directories' '$(PREFIX)/bin' \
	  $(foreach s,1 5 7,'$(SHARE)/man/man$s') '$(OWN)/study' '$(BASH_FILES)' '$(ZSH_FILES)'
	@for t in $(TOOLS); do \
	  install -m 755 '$(BUILD)'/bin/$$t '$(DESTDIR)$(PREFIX)/bin/$(PROGRAM_PREFIX)'$$t || exit 1; done
	@install -m 755 scripts/study '$(DESTDIR)$(PREFIX)/bin/$(PROGRAM_PREFIX)seilwerk-study'
	@install -m 644 scripts/study.d/*.pl '$(DESTDIR)$(OWN)/study'
	@for m in $(MAN); do n=$${m##*/}; s=$${m##*.}; \
	  case $$s in 1) n='$(PROGRAM_PREFIX)'$$n ;; esac; \
	  install -m 644 $$m '$(DESTDIR)$(SHARE)/man/man'$$s/"$$n" || exit 1; done
	@umask 022; for t in $(COMMANDS); do n='$(PROGRAM_PREFIX)'$$t; \
	  '$(DESTDIR)$(PREFIX)/bin/'"$$n" --options >'$(DESTDIR)$(OWN)/options.part' && \
	  scripts/completion bash "$$n" <'$(DESTDIR)$(OWN)/options.part' >'$(DESTDIR)$(BASH_FILES)/'"$$n" && \
	  scripts/completion zsh "$$n" <'$(DESTDIR)$(OWN)/options.part' >'$(DESTDIR)$(ZSH_FILES)/_'"$$n" || \
	  exit 1; done; rm -f '$(DESTDIR)$(OWN)/options.part'

uninstall:
	@for t in $(COMMANDS); do n='$(PROGRAM_PREFIX)'$$t; rm -f '$(DESTDIR)$(PREFIX)/bin/'"$$n" \
	  '$(DESTDIR)$(BASH_FILES)/'"$$n" '$(DESTDIR)$(ZSH_FILES)/_'"$$n"; done
	@for p in scripts/study.d/*.pl; do rm -f '$(DESTDIR)$(OWN)/study/'"$${p##*/}"; done
	@for m in $(MAN); do n=$${m##*/}; s=$${m##*.}; \
	  case $$s in 1) n='$(PROGRAM_PREFIX)'$$n ;; esac; \
	  rm -f '$(DESTDIR)$(SHARE)/man/man'$$s/"$$n"; done
	@scripts/directories remove '$(DESTDIR)' '$(OWN)/directories'

clean:
	rm -rf $(BUILD)

# The same bytes whoever makes it, where and when: what is committed, in the order of the tree, with
# the date of the commit; no owner, umask or local attribute of this machine.
DIST = $(BUILD)/seilwerk-$(VERSION).tar.gz
dist:
	@mkdir -p '$(BUILD)'
	@scripts/dist >'$(DIST).part' && mv '$(DIST).part' '$(DIST)'
	@echo '$(DIST)'

deb: deps-package
	@scripts/deb '$(BUILD)/deb'

.PHONY: always all help deps deps-build deps-check deps-demo deps-report deps-optional deps-hosts \
  deps-package demo experiments report test-programs check check-unit check-deep check-sanitized \
  check-hosts fuzz fuzz-afl analyze coverage check-coverage mutate bench install uninstall clean dist \
  deb
.SECONDARY:
.DELETE_ON_ERROR:
