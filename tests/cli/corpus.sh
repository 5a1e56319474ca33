#!/bin/sh
# Every fuzz target goes through its corpus, past findings included; five seconds of fuzzing each
# where clang has been used to build the targets (make fuzz builds them).
. "$(dirname "$0")/../tap.sh"
for program in "$SEILWERK_BUILD"/tests/fuzz_*_fuzz; do
    name=$(basename "$program" _fuzz)
    name=${name#fuzz_}
    runs 0 "$name: corpus" timeout 20 "$program" "$top/tests/fuzz/corpus/$name"
    grep -q '^[1-9][0-9]* inputs$' "$scratch/out"
    ok $? "$name: the corpus is not empty"
done
[ "$tests" -ge 10 ]
ok $? 'all readers have a target'
finish
