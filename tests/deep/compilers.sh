#!/bin/sh
# Another compiler, and other optimization, give the same numbers: gcc -O3 against gcc -O2 and
# against clang.
#
# Tolerance: 1e-9, as between kernels (tests/cross/reproducible.sh).  Without fused products, which
# the Makefile forbids, compilers may only order what the source leaves open, such as sums that the
# library's own functions make.
. "$(dirname "$0")/../tap.sh"
. "$top/tests/results.sh"
built=$PATH
results "$scratch/one"
ok $? 'results of all tools'

# other NAME ARGUMENT...: those of another build, which make makes with these arguments.
other()
{
    other=$1
    shift
    runs 0 "$other: build" make -s -C "$top" BUILD="$SEILWERK_BUILD/$other" "$@" all
    [ -x "$SEILWERK_BUILD/$other/bin/catenary" ] && (
        PATH=$SEILWERK_BUILD/$other/bin:$built
        results "$scratch/$other"
    )
    ok $? "$other: results"
    alike "$scratch/one" "$scratch/$other" 1e-9 1e-9
    ok $? "$other: the same numbers"
    diff -rq "$scratch/one" "$scratch/$other" | sed 's/^/# /'
}
other o2 CC=gcc CFLAGS='-O2 -g'
if command -v clang >/dev/null; then
    other clang CC=clang
else
    skip 'no clang'
fi
finish
