#!/bin/sh
# No wrong access and no leak under valgrind: the tools on a small case, the quick unit tests.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
command -v valgrind >/dev/null || {
    skip 'valgrind is not installed'
    finish
}
sed 's/^end = .*/end = 0.5/; s/^elements = .*/elements = 3/' \
    "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini

# OpenBLAS keeps its buffers to the end: reachable memory is no leak.
checked()
{
    valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,possible "$@"
}

runs 0 catenary checked catenary stay.ini
runs 0 'catenary --summary' checked catenary --summary -o summary.csv stay.ini
runs 0 'modal -d' checked modal -d model -o modes.csv stay.ini
runs 0 'diffverf -d' checked diffverf -d model --set disturbance.mode=1 \
    --set disturbance.amplitude=0.01 -o response.csv stay.ini
runs 0 'print-case' checked diffverf --print-case stay.ini
runs 2 'a bad case' checked diffverf --set cable.area=x stay.ini

cd "$top" || exit 1
for test in "$SEILWERK_BUILD"/tests/*_test; do
    case $test in */line_test | */march_test | */chain_test | */number_test) continue ;; esac
    runs 0 "$(basename "$test")" checked "$test"
done
finish
