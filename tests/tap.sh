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

# png FILE: signature, 1200 x 800, checksums of all chunks, the end.
png()
{
    perl -e '
        open my $in, "<:raw", $ARGV[0] or exit 1;
        my $all = do { local $/; <$in> };
        my ($at, $name) = (8, "");
        my @crc = map {
            my $c = $_;
            $c = $c & 1 ? 0xedb88320 ^ ($c >> 1) : $c >> 1 for 1 .. 8;
            $c
        } 0 .. 255;
        substr($all, 0, 8) eq "\x89PNG\r\n\x1a\n" && substr($all, 12, 4) eq "IHDR" or exit 1;
        my ($width, $height) = unpack "NN", substr $all, 16, 8;
        while ($at < length $all) {
            my $length = unpack "N", substr $all, $at, 4;
            $at + 12 + $length <= length $all or exit 1;
            $name = substr $all, $at + 4, 4;
            my $crc = 0xffffffff;
            $crc = $crc[($crc ^ $_) & 255] ^ ($crc >> 8)
                for unpack "C*", substr $all, $at + 4, $length + 4;
            ($crc ^ 0xffffffff) == unpack "N", substr $all, $at + 8 + $length, 4 or exit 1;
            $at += 12 + $length;
        }
        exit !($name eq "IEND" && $width == 1200 && $height == 800 && length $all > 10000)' "$1"
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
