#!/bin/sh
# The same input gives the same bytes; other threads, and other kernels of OpenBLAS, the same numbers.
#
# Tolerance: 1e-9 of a number, or 1e-9 of its unit.  Kernels and threads add products in another
# order, which changes the last digits, 1e-16.  Eigenvectors lose as many digits as their frequencies
# are close (in 400 elements 1e-11 was seen), growth is what is left of 1 - |multiplier| over a
# period (2e-11), the energy error is a difference of energies of 1e6 J (1e-10 J).
. "$(dirname "$0")/../tap.sh"
. "$top/tests/results.sh"
[ -z "${SEILWERK_SANITIZED:-}" ] || {
    skip 'not under the sanitizers'
    finish
}
unset OPENBLAS_CORETYPE OMP_NUM_THREADS

results "$scratch/one"
ok $? 'results of all tools'
results "$scratch/again, elsewhere"
diff -r "$scratch/one" "$scratch/again, elsewhere" >&2
ok $? 'the same bytes again, in another directory'

# other NAME VARIABLE=VALUE...
other()
{
    name=$1
    shift
    (
        for setting in "$@"; do
            export "${setting?}"
        done
        results "$scratch/$name"
    )
    ok $? "$name: results"
    alike "$scratch/one" "$scratch/$name" 1e-9 1e-9
    ok $? "$name: the same numbers"
}
other 'two threads' OPENBLAS_NUM_THREADS=2 OMP_NUM_THREADS=2
for instructions in Haswell:avx2 SkylakeX:avx512f; do
    kernel=${instructions%:*}
    needed=${instructions#*:}
    if grep -qw "$needed" /proc/cpuinfo; then
        other "kernel $kernel" OPENBLAS_CORETYPE="$kernel"
    else
        skip "kernel $kernel: this processor has no $needed"
    fi
done
# Threads of ours share rows, not sums.
cd "$scratch/one" || exit 1
for threads in 1 2; do
    diffverf --points points.csv --threads $threads --set time.end=20 -o "$threads.states" rope.ini \
        2>/dev/null || [ $? -eq 1 ]
    stabil --threads $threads --set stability.ratio_step=0.05 -o "$threads.map" rope.ini
done
same 1.states 2.states 'an ensemble on one thread and on two: the same bytes'
same 1.map 2.map 'a map on one thread and on two: the same bytes'

# What was written tells nothing of when, where and by whom: the names of this host and user, if they
# are no words of Seilwerk, and dates and times of day in their usual forms.
for word in "$(hostname)" "$(id -un)"; do
    grep -qwirF -e "$word" "$top/man" "$top/scripts" || printf '%s\n' "$word"
done >words
printf '%s\n' "$scratch" "$top" "$(date +%Y-%m)" "D:$(date +%Y)" "$(date +%b) [0-9 ][0-9] " >>words
"$top/scripts/single-cable" stay.ini pictures --set time.end=1 >/dev/null 2>&1
PICTURES=svg "$top/scripts/single-cable" stay.ini pictures --set time.end=1 >/dev/null 2>&1
PICTURES=pdf "$top/scripts/single-cable" stay.ini pictures --set time.end=1 >/dev/null 2>&1
mkdir repeated && cp pictures/*.png pictures/*.svg pictures/*.pdf repeated
[ "$(find repeated -type f | wc -l)" -eq 12 ]
ok $? 'pictures of three kinds'
sleep 1 # a time that is written would be another one
PICTURES=pdf "$top/scripts/single-cable" stay.ini pictures --set time.end=1 >/dev/null 2>&1
"$top/scripts/single-cable" stay.ini pictures --set time.end=1 >/dev/null 2>&1
for picture in pictures/*.pdf pictures/*.png; do
    cmp "$picture" "repeated/${picture#*/}" >&2 || echo "$picture"
done >bad
[ ! -s bad ]
ok $? 'the same bytes a second later'
grep -rawE -f words . --exclude=words --exclude=bad >&2
[ $? -eq 1 ]
ok $? 'no date, host, user or path of this machine'
grep -raE '(^|[^0-9.])([01][0-9]|2[0-3]):[0-5][0-9]:[0-5][0-9]' --include='*.csv' --include='*.ini' \
    --include='*.svg' . >&2
[ $? -eq 1 ]
ok $? 'no time of day'
finish
