#!/bin/sh
# Every fuzz target goes through its corpus, past findings included; where clang is, libFuzzer has
# five seconds for each reader, two at a time (SECONDS in the environment: more).
. "$(dirname "$0")/../tap.sh"
for program in "$SEILWERK_BUILD"/tests/fuzz_*_fuzz; do
    name=$(basename "$program" _fuzz)
    name=${name#fuzz_}
    runs 0 "$name: corpus" timeout 20 "$program" "$top/tests/fuzz/corpus/$name"
    grep -q '^[1-9][0-9]* inputs$' "$scratch/out"
    ok $? "$name: the corpus is not empty"
done
[ "$tests" -ge 26 ]
ok $? 'all readers have a target'

# fuzzed NAME: its status in $scratch/NAME.status
fuzzed()
{
    mkdir "$scratch/$1.new"
    timeout 60 "$SEILWERK_BUILD/fuzz/$1_fuzz" -max_total_time="${SECONDS:-5}" -max_len=4096 -timeout=10 \
        -close_fd_mask=1 -print_final_stats=1 -artifact_prefix="$scratch/$1-" "$scratch/$1.new" \
        "$top/tests/fuzz/corpus/$1" >"$scratch/$1.log" 2>&1
    echo $? >"$scratch/$1.status"
}
if [ -x "$SEILWERK_BUILD/fuzz/ini_fuzz" ] && [ -z "${SEILWERK_SANITIZED:-}" ]; then
    set -- "$top"/tests/fuzz/corpus/*
    while [ $# -gt 0 ]; do
        fuzzed "${1##*/}" &
        [ $# -lt 2 ] || fuzzed "${2##*/}"
        wait
        shift
        [ $# -eq 0 ] || shift
    done
    for status in "$scratch"/*.status; do
        name=$(basename "$status" .status)
        [ "$(cat "$status")" -eq 0 ] || tail -n 30 "$scratch/$name.log" | sed 's/^/# /'
        [ "$(cat "$status")" -eq 0 ]
        ok $? "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$scratch/$name.log") random inputs"
    done
else
    skip 'no clang here'
fi
finish
