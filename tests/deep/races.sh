#!/bin/sh
# What threads share, under ThreadSanitizer: ensembles, maps, nets.  Archer tells it of the barriers
# and locks of LLVM's OpenMP; without it every one of them would be reported.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
archer=$(ls /usr/lib/llvm-*/lib/libarcher.so 2>/dev/null | head -n 1)
if [ ! -x "$SEILWERK_BUILD/tsan/bin/diffverf" ] || [ -z "$archer" ]; then
    echo '1..0 # SKIP no build under ThreadSanitizer (clang, libomp-dev)'
    exit 0
fi
PATH=$SEILWERK_BUILD/tsan/bin:$PATH
export PATH OMP_TOOL_LIBRARIES="$archer" TSAN_OPTIONS=ignore_noninstrumented_modules=1
cp "$top/scripts/experiments/seil2-whirl/case.ini" rope.ini
{
    echo 'motion deck.omega,time.scheme,nonlinear.terms'
    for w in 8.7 8.8 8.9 9.0 9.1 9.2 9.3 9.4 9.5 9.6; do echo "$w,,"; done
    printf '9.1,alpha,\n9.2,alpha,\n9.1,,1\nx,,\n'
} >points.csv
points='diffverf --points points.csv --set steady.tolerance=5e-3 --set time.end=100'
# shellcheck disable=SC2086
for threads in 2 4; do
    runs 1 "an ensemble on $threads threads" $points --threads $threads -o $threads.csv rope.ini
done
same 2.csv 4.csv 'the same on both'
# shellcheck disable=SC2086
runs 124 'a signal' timeout -s INT 0.5 $points --set time.end=1e4 --threads 3 -o cut.csv rope.ini
! grep -q ThreadSanitizer err
ok $? 'a signal: all threads may ask for it'
runs 0 'a map' stabil --threads 4 -o map.csv rope.ini
runs 0 'its answers' stabil --answers --threads 4 -o answers.csv rope.ini
runs 0 'multipliers' stabil --growth --set stability.method=floquet \
    --set stability.ratio_step=0.05 --threads 4 -o map.csv rope.ini
"$top/scripts/net/square" net 20
runs 0 'a net' env OMP_NUM_THREADS=4 gapnet -d solved net/system.ini
finish
