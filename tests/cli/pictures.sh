#!/bin/sh
# Pictures of data that lack what a picture has else, and labels that must not run into each other.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
plot=$top/scripts/plot
if ! command -v gnuplot >/dev/null 2>&1; then
    skip 'gnuplot is missing'
    finish
fi

# quiet NAME SCRIPT ARGUMENT...: it draws, and says nothing.
quiet()
{
    name=$1
    script=$2
    shift 2
    runs 0 "$name" "$plot/$script" "$@"
    [ ! -s err ] || sed 's/^/# /' err
    [ ! -s err ]
    ok $? "$name: without a word"
}

# Heights: no line h = 0, and lines so short that the twentieth point is none.
bar='--set type=primary --set v_m=8 --set z_m=1 --set base_long_m=9'
# shellcheck disable=SC2086 # words without blanks
sling $bar --contour z_m=0:1:11,v_m=6:8:11 >high.csv
# shellcheck disable=SC2086
sling $bar --contour z_m=0:12:11,v_m=6:8:11 >both.csv
quiet 'heights above 0' heights high.csv high.svg
! grep -q 'bold line' high.svg
ok $? 'no line is promised'
grep -q '7.25' high.svg
ok $? 'short lines have their heights'
quiet 'heights above and below' heights both.csv both.svg
grep -q 'the bold line is h = 0' both.svg
ok $? 'the line is told'

# An ensemble without a boundary, and without a point that is crossed.
data=$top/tests/data/plots
head -n 1 "$data/boundary.csv" >none.csv
quiet 'ensemble without a boundary' ensemble "$data/states.csv" none.csv none.svg
! grep -q 'boundary of stabil' none.svg && grep -q 'no steady state' none.svg
ok $? 'which the legend leaves out'
quiet 'ensemble with one' ensemble "$data/states.csv" "$data/boundary.csv" some.svg
grep -q 'boundary of stabil' some.svg
ok $? 'which the legend names'

# Groups that are numbers have the name of their column.
printf 'x,y,turns,kind\n1,2,4,a\n2,3,4,a\n1,3,6.5,b\n2,5,6.5,b\n' >groups.csv
quiet 'curves' curves groups.csv x y turns turns.svg
grep -q 'turns = 4' turns.svg && grep -q 'turns = 6.5' turns.svg
ok $? 'name = value'
quiet 'curves of words' curves groups.csv x y kind kind.svg
! grep -q 'kind =' kind.svg
ok $? 'words stand for themselves'

# Steps of ticks, two to five in an extent.
(
    . "$plot/setup.sh"
    for extent in 1 1.01 2 4.9 5 5.1 9.9 0.0806 1e-5 1000 3e8; do
        echo "$extent $(ticks "$extent")"
    done
) >steps
awk '!($2 > 0) { exit bad = 1 }
    { n = $1/$2; m = $2; while (m < 0.999) m *= 10; while (m > 9.99) m /= 10
        if (n < 1.99 || n > 5.01 || (m - 1)^2*(m - 2)^2*(m - 5)^2 > 1e-6) { print "# " $0; bad = 1 } }
    END { exit bad || NR != 11 }' steps
ok $? 'ticks: steps of 1, 2 or 5'
[ "$(. "$plot/setup.sh"; ticks 0)" = autofreq ]
ok $? 'ticks: of nothing'
"$top/scripts/wire/helix" spring 0.02 0.01 6 12 0.004 100
wirebeam -d spring/solved spring/case.ini
quiet 'a small spring' wire spring/solved spring.svg
! grep -q -- '-0.03' spring.svg && grep -q -- '-0.02' spring.svg
ok $? 'has every second label'
"$top/scripts/net/mooring" spread 6 500 60 520
gapnet -q -d spread/solved spread/system.ini
quiet 'a wide spread' net spread/solved spread.svg
! grep -q -- '-300' spread.svg && grep -q -- '-400' spread.svg
ok $? 'has fewer labels'
[ ! -e 1000 ]
ok $? 'and leaves nothing behind'
finish
