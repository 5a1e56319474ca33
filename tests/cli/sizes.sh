#!/bin/sh
# Sizes in the headers of binary files are not believed: a file that claims more than it holds is
# refused without the memory that it claims.  Forged states and models; a shell with little memory.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
if [ -n "${SEILWERK_SANITIZED:-}" ]; then
    little=unlimited # the sanitizer maps all of the address space
else
    little=600000 # KiB
fi
cp "$top/scripts/experiments/ben-ahin/case.ini" stay.ini
few='--set time.output_every= --set mesh.elements=4'
# shellcheck disable=SC2086 # two options
runs 0 'a state' diffverf $few --set time.end=0.5 --state state -o out.csv stay.ini
# shellcheck disable=SC2086 # two options
runs 0 'a model' modal -d model -o modes.csv $few stay.ini
cp state good

# forge FILE SHAPE: the shape in the header, whose length stays.
forge()
{
    perl -e '
        my ($file, $shape) = @ARGV;
        open my $in, "<:raw", $file or die;
        my $all = do { local $/; <$in> };
        my $header = substr $all, 10, unpack("v", substr $all, 8, 2);
        my $length = length $header;
        $header =~ s/\(\d[^)]*\)/$shape/ or die;
        $header =~ s/ *\n\z//;
        $header .= " " x ($length - 1 - length $header) . "\n";
        length $header == $length or die;
        substr($all, 10, $length) = $header;
        open my $out, ">:raw", $file or die;
        print $out $all;' "$1" "$2"
}

# refused NAME TEXT: diffverf goes on from the state, with little memory.
refused()
{
    # shellcheck disable=SC2086,SC3045 # two options; dash and bash have ulimit -v
    (
        ulimit -v $little
        exec timeout 20 diffverf $few --resume --set time.end=1 --state state -o out.csv stay.ini
    ) >out 2>err
    got=$?
    [ $got -eq 2 ] || { echo "# status $got"; sed 's/^/# /' err; }
    [ $got -eq 2 ]
    ok $? "$1: refused"
    says "$2" 'and says why'
}
for shape in '(100000000000,)' '(40, 2305843009213693951)' '(4611686018427387905, 4)' \
    '(18446744073709551615,)' '(99999999999999999999999,)' '(-5,)'; do
    cp good state
    forge state "$shape"
    case $shape in
    *100000000000,*) text='the data are cut short' ;;
    *) text='one or two dimensions' ;;
    esac
    refused "a state of $shape numbers" "$text"
done
cp good state
forge state '(3,)'
refused 'a state of fewer numbers than it holds' 'more data than the header tells'
# A header that is as long as 2^32 bytes.
{
    printf '\223NUMPY\002\000\377\377\377\377'
    tail -c +13 good
} >state
refused 'a header of 4 GiB' 'the header is absurdly long'
# Counters that are none.
for number in nan inf 1e300 0.5 -1; do
    perl -e '
        my ($number, $at) = @ARGV;
        open my $in, "<:raw", "good" or die;
        my $all = do { local $/; <$in> };
        my $start = 10 + unpack "v", substr $all, 8, 2;
        substr($all, $start + 8*$at, 8) = pack "d<", $number;
        open my $out, ">:raw", "state" or die;
        print $out $all;' -- "$number" \
        "$(awk '/STATE_STEP,/ { print n + 0 } /^    STATE_[A-Z_]+,/ { n++ }' "$top/common/form/state.h")"
    refused "a state at step $number" 'is damaged'
done
cp good state
# shellcheck disable=SC2086 # two options
runs 0 'the state as it was' diffverf $few --resume --set time.end=1 --state state -o out.csv stay.ini

for matrix in model/*.npy; do
    cp "$matrix" keep
    forge "$matrix" '(99999999, 9999999)' 2>/dev/null || forge "$matrix" '(9999999999,)'
    # shellcheck disable=SC2086,SC3045 # two options; dash and bash have ulimit -v
    (
        ulimit -v $little
        exec timeout 20 diffverf -d model -o out.csv $few --set time.end=0.5 stay.ini
    ) >out 2>err
    got=$?
    mv keep "$matrix"
    [ $got -eq 2 ] && grep -q "${matrix##*/}" err
    ok $? "$matrix that claims too much: refused"
done
finish
