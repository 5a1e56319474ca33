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
    name=$1
    shift
    runs 0 "$name: build" make -s -C "$top" BUILD="$SEILWERK_BUILD/$name" "$@" all
    [ -x "$SEILWERK_BUILD/$name/bin/catenary" ] && (
        PATH=$SEILWERK_BUILD/$name/bin:$built
        results "$scratch/$name"
    )
    ok $? "$name: results"
    alike "$scratch/one" "$scratch/$name" 1e-9 1e-9
    ok $? "$name: the same numbers"
    diff -rq "$scratch/one" "$scratch/$name" | sed 's/^/# /'
}
other o2 CC=gcc CFLAGS='-O2 -g'
if command -v clang >/dev/null; then
    other clang CC=clang
else
    skip 'no clang'
fi
finish
