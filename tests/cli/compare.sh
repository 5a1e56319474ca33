#!/bin/sh
# The comparator of the tests: what it takes as equal, what it must not.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1

# differs TEXT NAME: the last run printed the text as the place of the difference.
differs()
{
    grep -qF -e "$1" out || sed 's/^/# /' out
    grep -qF -e "$1" out
    ok $? "$2"
}

# table NAME ROWS...
table()
{
    file=$1
    shift
    printf '%s\n' time_s,x_m,why "$@" >"$file"
}

table a.csv 0,1,start 1,2.5,run 2,-1e-9,end
table b.csv 0,1.0,start 1.00,25e-1,run 2,-0.000000001,end
table c.csv 0,1,start 1,2.500001,run 2,-1e-9,end
table d.csv 0,1,start 1,2.5,run 2,-1e-9,fin
table e.csv 0,1,start 1,2.5,run
table f.csv 0,1,start 1,nan,run 2,-1e-9,end
table g.csv 0,1,start 1,2.5,run 2,1e-9,end
table h.csv 0,1,start 1,2.5 2,-1e-9,end

runs 0 'a file equals itself' "$compare" a.csv a.csv
[ ! -s out ]
ok $? 'and nothing is printed'
runs 0 'numbers are compared, not their text' "$compare" a.csv b.csv
runs 1 'the default tolerance is nothing' "$compare" a.csv c.csv
differs "line 3, column 2 (x_m): '2.5' against '2.500001'" 'the place and both values are printed'
runs 0 'within the relative tolerance' "$compare" -r 5e-7 a.csv c.csv
runs 1 'beyond the relative tolerance' "$compare" -r 3e-7 a.csv c.csv
runs 0 'within the absolute tolerance' "$compare" -a 1.1e-6 a.csv c.csv
runs 1 'beyond the absolute tolerance' "$compare" -a 0.9e-6 a.csv c.csv
runs 0 'both tolerances add' "$compare" -a 6e-7 -r 2e-7 a.csv c.csv
runs 1 'a small number of the other sign' "$compare" -r 0.5 a.csv g.csv
runs 0 'but not with an absolute tolerance' "$compare" -a 2e-9 a.csv g.csv
runs 1 'other text' "$compare" -r 1 -a 1 a.csv d.csv
differs "line 4, column 3 (why): 'end' against 'fin'" 'the texts are printed'
runs 1 'fewer rows' "$compare" -r 1 a.csv e.csv
differs 'only a.csv has more rows' 'the longer file is named'
runs 1 'more rows' "$compare" -r 1 e.csv a.csv
differs 'only a.csv has more rows' 'the longer file is named in this order as well'
runs 1 'NaN does not equal a number' "$compare" -r 1e9 -a 1e9 a.csv f.csv
runs 1 'NaN does not equal itself' "$compare" -r 1 -a 1 f.csv f.csv
differs "'nan' against 'nan'" 'and is printed'
for nan in NaN -nan +NAN; do
    table nan.csv "0,$nan,x"
    runs 1 "$nan does not equal itself" "$compare" nan.csv nan.csv
done
runs 1 'a row with fewer cells' "$compare" -r 1 a.csv h.csv
differs 'line 3: 3 cells against 2' 'and says so'
printf 'x\n1\n2\n3\n' >one.csv
printf 'x\n1.1\n2.5\n3.1\n' >two.csv
runs 1 'three differences' "$compare" -a 0.01 one.csv two.csv
differs "line 3, column 1 (x): '2' against '2.5'" 'the worst one is printed'
printf 'x\n1e308\n' >big.csv
printf 'x\n-1e308\n' >gib.csv
runs 1 'a difference that overflows' "$compare" -r 1 big.csv gib.csv
printf 'x\ninf\n' >inf.csv
runs 1 'a number against infinity' "$compare" -r 1 big.csv inf.csv
runs 0 'infinity equals itself' "$compare" inf.csv inf.csv

sed 1s/x_m/x_mm/ a.csv >other.csv
runs 1 'another header' "$compare" -r 1 a.csv other.csv
differs "(header): 'x_m' against 'x_mm'" 'the header is the place'
cut -d, -f1,2 a.csv >short.csv
runs 1 'fewer columns' "$compare" -r 1 a.csv short.csv
differs 'header: 3 columns against 2' 'are counted'
runs 0 'only some columns' "$compare" -c time_s,x_m a.csv d.csv
runs 0 'columns that both have' "$compare" -c time_s,x_m a.csv short.csv
awk -F, -v OFS=, '{ print $2, $1 }' a.csv >turned.csv
runs 0 'columns in another order' "$compare" -c x_m,time_s a.csv turned.csv
runs 1 'a chosen column differs' "$compare" -c time_s,x_m a.csv c.csv
runs 2 'a missing column' "$compare" -c time_s,y_m a.csv a.csv
says "a.csv: has no column 'y_m'" 'is named'

# npy DESCR ORDER SHAPE NUMBERS: an array on stdout.
npy()
{
    perl -e 'my ($descr, $order, $shape, @x) = @ARGV;
        my $header = "{\x27descr\x27: \x27$descr\x27, \x27fortran_order\x27: $order, " .
            "\x27shape\x27: $shape, }\n";
        binmode STDOUT;
        print "\x93NUMPY\x01\x00", pack("v", length $header), $header, pack "d<*", @x;' -- "$@"
}
npy '<f8' True '(2, 2)' 1 2 3 4 >f.npy
npy '<f8' False '(2, 2)' 1 3 2 4 >c.npy
npy '<f8' True '(2, 2)' 1 2 3.0001 4.5 >g.npy
npy '<f8' True '(4,)' 1 2 3 4 >v.npy
npy '<f8' True '(4, 1)' 1 2 3 4 >w.npy
npy '<f8' True '(2, 2)' 1 nan 3 4 >n.npy
npy '<i8' True '(2, 2)' 1 2 3 4 >i.npy
runs 0 'npy: a file equals itself' "$compare" f.npy f.npy
runs 0 'npy: the order of storage does not matter' "$compare" f.npy c.npy
runs 1 'npy: other numbers' "$compare" f.npy g.npy
runs 1 'npy: beyond the tolerance' "$compare" -r 0.1 f.npy g.npy
differs '[1, 1]: 4 against 4.5' 'npy: the worst place, from 0'
runs 0 'npy: within the tolerance' "$compare" -r 0.12 f.npy g.npy
runs 1 'npy: another shape' "$compare" -r 1 f.npy v.npy
differs 'shape: 2 dimensions, 2 x 2 against 1, 4 x 1' 'npy: both shapes'
runs 1 'npy: a column is no vector' "$compare" -r 1 v.npy w.npy
runs 1 'npy: NaN does not equal itself' "$compare" -r 1 -a 1 n.npy n.npy

runs 2 'an integer array' "$compare" f.npy i.npy
runs 2 'one of each kind' "$compare" a.csv f.npy
says 'one is .npy' 'is named'
runs 2 'a missing file' "$compare" a.csv none.csv
says 'none.csv: cannot be opened' 'is named'
runs 2 'a directory' "$compare" . a.csv
: >empty.csv
runs 2 'an empty file' "$compare" a.csv empty.csv
printf 'x\n"1\n' >quote.csv
runs 2 'an open quote' "$compare" quote.csv quote.csv
says 'quote.csv:2:' 'has a line'
runs 2 'one operand' "$compare" a.csv
runs 2 'three operands' "$compare" a.csv a.csv a.csv
runs 2 'a tolerance that is no number' "$compare" -r much a.csv a.csv
runs 2 'a negative tolerance' "$compare" -a -1 a.csv a.csv
finish
