# Sourced by the shell tests: TAP output, a scratch directory, small checks.
# shellcheck shell=sh
set -u
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
compare=$SEILWERK_BUILD/tests/compare
PATH=$SEILWERK_BUILD/bin:$PATH
export PATH OPENBLAS_NUM_THREADS=1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tests=0
failed=0

# ok STATUS NAME: passes if STATUS is 0.
ok()
{
    tests=$((tests + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $tests - $2"
    else
        echo "not ok $tests - $2"
        failed=$((failed + 1))
    fi
}

# same FILE FILE NAME: byte for byte.
same()
{
    cmp "$1" "$2" >&2
    ok $? "$3"
}

# runs STATUS NAME COMMAND...: exit status as expected; output in $scratch/out, $scratch/err.
runs()
{
    wanted=$1
    name=$2
    shift 2
    "$@" >"$scratch/out" 2>"$scratch/err" </dev/null
    got=$?
    [ "$got" -eq "$wanted" ] || { echo "# status $got, wanted $wanted"; sed 's/^/# /' "$scratch/err"; }
    [ "$got" -eq "$wanted" ]
    ok $? "$name"
}

# says TEXT NAME: the last run's stderr holds TEXT.
says()
{
    grep -qF -e "$1" "$scratch/err"
    found=$?
    [ $found -eq 0 ] || sed 's/^/# stderr: /' "$scratch/err"
    ok $found "$2"
}

# header FILE TEXT NAME: the first line of FILE.
header()
{
    [ "$(head -n 1 "$1")" = "$2" ] || echo "# $(head -n 1 "$1")"
    [ "$(head -n 1 "$1")" = "$2" ]
    ok $? "$3"
}

# holds AWK-CONDITION FILE NAME: the condition, over fields f[row, column] (header is row 0).
holds()
{
    awk -F, '{ for (i = 1; i <= NF; i++) f[NR - 1, i] = $i; n = NR - 1 }
        function abs(x) { return x < 0 ? -x : x }
        END { exit !('"$1"') }' "$2"
    ok $? "$3"
}

skip()
{
    tests=$((tests + 1))
    echo "ok $tests # SKIP $1"
}

finish()
{
    echo "1..$tests"
    exit $((failed > 0))
}
