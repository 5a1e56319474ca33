#!/bin/sh
# Each request for memory of each tool fails in turn under AddressSanitizer: nothing is lost, nothing
# is read that is not there.  tests/fault/faults.sh judges what the tools tell and leave behind.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
. "$here/../everyrun.sh"
if [ ! -x "$SEILWERK_BUILD/asan/bin/diffverf" ]; then
    echo '1..0 # SKIP no build under AddressSanitizer'
    exit 0
fi
PATH=$SEILWERK_BUILD/asan/bin:$PATH
ASAN_OPTIONS=detect_leaks=1:exitcode=99:verify_asan_link_order=0
UBSAN_OPTIONS=exitcode=99
export PATH ASAN_OPTIONS UBSAN_OPTIONS

# The means: what is lost is seen, beside the library that lets requests fail.
printf '#include <stdlib.h>\nchar *p;\nint main(void) { p = malloc(7); p = NULL; return 0; }\n' >lost.c
"${CC:-cc}" -fsanitize=address -O0 -o lost lost.c
runs 99 'a program that loses seven bytes' env LD_PRELOAD="$faults" ./lost
says '7 byte(s) leaked' 'is found out'

for tool in $every_run; do
    n=0
    wrong=
    while [ $n -lt 2000 ] && [ ${#wrong} -lt 200 ]; do
        n=$((n + 1))
        rm -rf result mark
        mkdir result
        allocation $n "$tool" >said 2>err
        status=$?
        [ -e mark ] || break
        # the sanitizer's own need of memory for a name
        ! grep -q 'CHECK failed: sanitizer_' err || continue
        [ $status -le 1 ] && ! grep -qE 'Sanitizer|runtime error' err && continue
        wrong="$wrong $n: $status $(grep -m 1 -E '^ *#[0-9]+ .* in [a-z_]+ (common|tools)|runtime error' err)"
    done
    [ -z "$wrong" ] || echo "# $wrong"
    [ -z "$wrong" ] && [ $n -gt 10 ]
    ok $? "$tool: nothing is lost by any of $((n - 1)) requests that fail"
done
finish
