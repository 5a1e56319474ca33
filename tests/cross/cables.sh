#!/bin/sh
# The experiments of the single cables (Thalheim): each runs in the frame, its differences are
# explained, and its numbers are those of theory; their plot scripts.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
experiments=$top/scripts/experiments

# Called wrongly.
for plot in history regions frequencies damping protocol; do
    runs 2 "plot/$plot: usage" "$top/scripts/plot/$plot"
    says "usage: $plot " "plot/$plot: says how"
done
for study in frequencies damping stability-orders stability-modes seil1-vertical; do
    runs 2 "$study: usage" "$experiments/$study/run"
    says 'usage: run DIR' "$study: says how"
done
if ! command -v gnuplot >/dev/null 2>&1; then
    skip 'no gnuplot here'
    finish
fi
printf 'time_s,v2_1_m\n0,1\n1,2\n' >small.csv
runs 2 'plot/history: no such column' "$top/scripts/plot/history" small.csv none.png T v3_1_m,0,1
runs 2 'plot/history: no time there' "$top/scripts/plot/history" small.csv none.png T v2_1_m,3,4
runs 2 'plot/regions: no map' "$top/scripts/plot/regions" none.png T panel P 1 0 1 map small.csv 1 \
    fill1 name
says 'small.csv: is no map of stabil' 'says so'
runs 2 'plot/frequencies: no table' "$top/scripts/plot/frequencies" small.csv none.png
[ ! -e none.png ]
ok $? 'no picture without data'
runs 0 'plot/history: a table, a level' "$top/scripts/plot/history" small.csv small.png "it's" \
    v2_1_m,0,1,1.5
[ ! -s err ] && png small.png
ok $? 'a picture, nothing on stderr'

# tried NAME PICTURE...: runs in the frame; fails where a number differs without a reason.
tried()
{
    study=$1
    shift
    runs 0 "$study: runs, differences are explained" env QUICK=yes "$top/scripts/experiment" all \
        "$experiments/$study" "$study"
    [ ! -s err ]
    ok $? "$study: nothing on stderr"
    for picture in "$@"; do
        png "$study/$picture.png"
        ok $? "$study: $picture.png"
    done
}

# judge NAME COUNT WHAT: so many computed numbers of the comparison are "equal" or "within".
judge()
{
    got=$(perl -ne 's/"[^"]*"//g; $n++ if (split /,/)[6] =~ /^(equal|within)$/; END { print $n // 0 }' \
        "$1/comparison.csv")
    [ "$got" -eq "$2" ] || echo "# $got, wanted $2"
    [ "$got" -eq "$2" ]
    ok $? "$1: $3"
}

# value FILE QUANTITY BY CONDITION: over x, the computed number.
value()
{
    awk -F, -v quantity="$2" -v by="$3" '$1 == quantity && $2 == by { n++; x = $3 + 0 }
        END { if (n == 1 && ('"$4"')) exit 0; print "# " quantity ", " by ": " n " " x; exit 1 }' \
        "$1/computed.csv"
    ok $? "$1: $2, ${3:-computed}: $4"
}

tried frequencies frequencies
judge frequencies 258 'all 192 frequencies by law printed, the column of Irvine as a string'
awk -F, '$1 ~ /^rope . with/ && $7 == "equal" && $4 == "law printed" { n++ } END { exit n != 192 }' \
    frequencies/comparison.csv
ok $? 'frequencies: 192 in all printed digits'
# the mesh is what is left with law hooke: the finer, the nearer to theory
awk -F, 'NR > 1 && $3 >= 8 { e[$1, $2] += $7 < 0 ? -$7 : $7 }
    END { exit !(e[1, 10] > 20*e[1, 20] && e[1, 20] > 20*e[1, 50] && e[2, 10] > 100*e[2, 50]) }' \
    frequencies/deviations.csv
ok $? 'frequencies: the error falls with the mesh'

tried damping damping
judge damping 27 'all of its published numbers'
awk -F, 'NR > 1 { n++; if (!(($6/$4 - 1)^2 < 1e-16 && ($5/$4 - 1)^2 < 1e-16)) bad++ }
    END { exit !(n == 68 && !bad) }' damping/modes.csv
ok $? 'damping: the formula is met by the complex modes'

tried stability-orders orders
judge stability-orders 18 'tips at 1/j, what damping leaves'
# the power of the threshold, from a hundredth to a tenth of the damping: 1/j
awk -F, 'NR > 1 { t[$1, $2] = $4; if (!(($4/$5 - 1)^2 < 0.03^2)) bad++ }
    END {
        for (j = 1; j <= 4; j++) {
            if (j == 2) continue
            power = log(t["0.1", j]/t["0.01", j])/log(10)
            if (!((power*j - 1)^2 < 0.02^2)) bad++
        }
        exit bad > 0
    }' stability-orders/thresholds.csv
ok $? 'stability-orders: thresholds go with the root of order j, as the first-order formulas say'
value stability-orders 'tip of order 2 with delta 1 and the ground damped' '' 'x > 0.015 && x < 0.02'

tried stability-modes modes
judge stability-modes 24 'tips at the ratios of the frequencies'
value stability-modes 'combination resonances up to 10 cm' '' 'x == 0'
awk -F, '/^threshold/ { t[$1, $2] = $3; q[$1] = 1 }
    END { for (x in q) { n++; if (!((t[x, "together"]/t[x, "alone"] - 1)^2 < 1e-6)) bad++ }
        exit !(n == 8 && !bad) }' stability-modes/computed.csv
ok $? 'stability-modes: a mode by itself has the threshold that it has among eight'

for case in ben-ahin seil1-whirl seil1-parametric seil1-vertical seil2-whirl seil2-quiet \
    seil2-vertical seil2-ellipse; do
    tried $case history path response
done
judge ben-ahin 34 'static numbers, 17 frequencies, the column of the string, the first swing'
value ben-ahin 'largest |v2| until 20 s' 'law hooke' '(x - 1.38)^2 < 0.005^2'
value seil1-vertical 'double amplitude of v2 after 130 s' 'law thesis' '(x - 1.60)^2 < 0.01^2'
value seil1-vertical 'double amplitude of v2 at 4.40 rad/s' 'law thesis' 'x < 1.3'
value seil1-vertical 'frequency of v3 while it dies' 'law thesis' 'x > 4.96 && x < 5.02'
value seil1-vertical 'largest |v3| after 130 s' 'law thesis' 'x < 1e-3'
value seil1-parametric 'from side to side after 140 s' 'law thesis' '(x - 2.37)^2 < 0.02^2'
value seil2-whirl 'largest |v3| after 140 s' 'law thesis' '(x - 1.2035)^2 < 0.003^2'
value seil2-quiet 'largest |v3| after 140 s' 'law thesis' 'x < 1e-4'
value seil2-quiet 'decay of v3' 'law thesis' '(x/0.0912 - 1)^2 < 0.02^2'
value seil2-vertical 'greatest v2 after 200 s' 'law thesis' '(x - 1.033)^2 < 0.005^2'
value seil2-vertical 'largest |v3| after 200 s' 'law thesis' 'x < 1e-3'
value seil2-ellipse 'longer half axis after 180 s' 'law thesis' '(x - 1.158)^2 < 0.006^2'
value seil2-ellipse 'shorter half axis after 180 s' 'law thesis' '(x - 0.617)^2 < 0.004^2'
value seil1-whirl 'angle to the vertical after 140 s' 'law thesis' '(x - 12)^2 < 0.5^2'

finish
