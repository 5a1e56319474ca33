#!/bin/sh
# The published case studies of heavy lifts, as the demo runs them, and the pictures of lifts.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
study=$top/scripts/experiments/lifts
plot=$top/scripts/plot

for script in "$study/run" "$study/computed" "$plot/lift" "$plot/righting" "$plot/heights"; do
    runs 2 "$(basename "$script"): usage" "$script"
    says 'usage: ' 'says how'
done
command -v gnuplot >/dev/null 2>&1 || {
    skip 'no gnuplot here'
    finish
}
runs 0 'the experiment' "$top/scripts/experiment" all "$study" made
[ ! -s err ] && [ ! -s out ]
ok $? 'says nothing'
# One line for each published number, equal in all digits by the document's formulas; columns are
# apart by two blanks.
awk -F '  +' '/^(1\.2|sheet)/ { n++; if ($5 !~ /(=|within)$/) { bad = 1; print "# " $0 } }
    END { exit bad || n != 19 }' made/comparison.txt
ok $? 'every published number in all printed digits'

for picture in spreader tandem truck pair righting heights swing shares; do
    png "made/$picture.png"
    ok $? "$picture.png is a picture"
done
sling "$study/cases.csv" >lifts.csv
same lifts.csv made/lifts.csv 'its table is that of sling'
printf 'name,type,v_m,z_m,base_long_m,base_cross_m,m_load_t\na,primary,6,2,6,4,60\nb,primary,6,7,6,4,60
c,single,,-1,,,\nd,primary,6,2,6,4,\n' >table.csv
for row in 1 c; do
    runs 0 "lift: row $row" "$plot/lift" table.csv $row row.png
    png row.png
    ok $? 'is a picture'
done
runs 0 'righting: primary slings' "$plot/righting" table.csv a row.png
png row.png
ok $? 'is a picture'
rm row.png
runs 2 'lift: no such row' "$plot/lift" table.csv x row.png
runs 2 'righting: an unstable row' "$plot/righting" table.csv b row.png
runs 2 'righting: a row without mass' "$plot/righting" table.csv d row.png
says "has no m_load_t" 'says so'
runs 2 'heights: no contour' "$plot/heights" table.csv row.png
[ ! -e row.png ]
ok $? 'and no picture'
finish
