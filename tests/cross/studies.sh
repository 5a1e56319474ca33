#!/bin/sh
# Sweeps with their jumps and overhangs, steady states, the implicit scheme and ensembles against
# the numbers of theory section 3 and 10 c4, and against each other: ropes 1 and 2 of Reif's tests,
# law thesis, n = 10, the right support moved by 0.05 m along the chord.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
experiments=$top/scripts/experiments
# Rope 1 with the damping of table 6.3, without its disturbance; rope 2.
sed '/^\[disturbance\]/,/^$/d; s/^end = .*//; s/^omega = 5.15.*//' \
    "$experiments/seil1-whirl/case.ini" >rope1.ini
sed '/^output_every/d; s/^end = .*//' "$experiments/seil2-whirl/case.ini" >rope2.ini

# sweep FILE FROM TO OPTION...
sweep()
{
    file=$1
    from=$2
    to=$3
    shift 3
    runs 0 "sweep from $from to $to $*" diffverf --set sweep.from="$from" --set sweep.to="$to" \
        --set sweep.rate=0.001 "$@" -o "$file" rope1.ini
    [ ! -s err ]
    ok $? 'nothing on stderr, so never slack'
}

# curve CONDITION FILE NAME: rows by name, c["..."], all rows in r; bad++ or good++ in the body.
curve()
{
    awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
        { for (i = 1; i <= NF; i++) c[name[i]] = $i
          w = c["omega_rad_s"]; v2 = c["v2_1_amplitude_m"]; v3 = c["v3_1_amplitude_m"]
          up = c["direction"] == "up" }
        '"$1"'
        END { exit !(good > 0 && !bad) }' "$2"
    ok $? "$3"
}

# The first resonance, up and back.  On the way up the whirl is carried on to where nothing that
# starts from rest comes to whirl; it breaks down at 6.27.  On the way back the motion in the plane
# jumps at 5.41.
sweep whirl.csv 4 6.3 --set sweep.back=yes
curve 'up && w > 5.75 && w < 5.85 { good++; if (!(v3 > 1 && v2 > 1 && c["axes_ratio_1"] > 0.8)) bad++ }' \
    whirl.csv 'upward it whirls at 5.80, with |v3| > 1 m'
curve 'up && w < 5 { good++; if (!(v3 < 1e-3)) bad++ }' whirl.csv 'below 5.0 it stays in its plane'
curve '!up && w < 6.1 && w > 5.45 { good++; if (!(v3 < 1e-3 && v2 < 1.1)) bad++ }' whirl.csv \
    'downward it is in its plane down to 5.45: hysteresis'
curve '!up { if (w < before - 0.1) { first = v2; before = w } else if (!before) before = w }
    !up { for (k = n; k > 0 && at[k] - w <= 0.1; k--) if (v2 - size[k] > 0.5) good++
          at[++n] = w; size[n] = v2 }' whirl.csv \
    'the branch in the plane jumps by more than 0.5 m within 0.1 rad/s'
curve '!up && v3 > 0.5 { if (w > 5.4) bad++; good++ }' whirl.csv \
    'and whirls again from there, below 5.4'
# What it whirls with at 5.15 is the orbit that is found from rest, within what the rate shifts it.
curve 'up && w > 5.2 && w < 5.22 { good++; if (!(v2 > 1.1 && v2 < 1.25 && v3 > 0.75 && v3 < 0.9)) bad++ }' \
    whirl.csv 'at 5.21 it is the whirl of section 6.3.3'

# From rest at 5.80 each disturbance dies: below 1 mm after 200 s.
for size in 0.02 0.1 0.3; do
    runs 0 "from rest at 5.80, $size m" diffverf --set 'motion deck.omega=5.8' \
        --set disturbance.mode=1 --set disturbance.amplitude=$size --set time.end=220 rope1.ini
    awk -F, -v size=$size '$1 < 3 && $4 > size/2 { was = 1 } $1 > 200 { n++; if ($4^2 > 1e-6) bad = 1 }
        END { exit !(was && n > 100 && !bad) }' out
    ok $? 'dies below 1 mm'
done

# The first parametric region: upward the lateral vibration reaches 2 m at 11.3.  Downward from rest
# the motion is one of 0.07 m until 11.03, jumps to 2.2 m in the plane, and is lateral below 10.87.
sweep rise.csv 8.8 11.3
sweep fall.csv 11.3 8.8
curve 'w > 8.95 { good++; if (!(v3 > 0.55 && v3 > before && c["plane_1"] == "lateral")) bad++; before = v3 }' \
    rise.csv 'upward the lateral vibration grows all the way'
curve 'w > 11.2 { good++; if (!(v3 > 1.95 && v2 < 0.01)) bad++ }' rise.csv 'to 2 m above 11.2'
curve 'w > 11.05 { good++; if (!(v3 < 1e-3 && v2 < 0.21)) bad++ }' fall.csv \
    'downward from rest hardly anything moves above 11.05: the overhang'
curve 'w > 10.9 && w < 10.98 { good++; if (!(v3 < 0.02 && v2 > 1.7)) bad++ }' fall.csv \
    'then it jumps to 1.8 m and more in its plane'
curve 'w < 10.7 { good++; if (!(v3 > 0.4 && c["plane_1"] == "lateral")) bad++ }' fall.csv \
    'and lateral below 10.7'
# Where both are lateral they are one motion, but for the rate: 1.1 m per rad/s, 0.5 s late.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "v3_1_amplitude_m") c = i; next }
    FNR == 1 { next }
    FNR == NR { w[++n] = $2; v[n] = $c; next }
    $2 > 9.2 && $2 < 10.6 { for (k = 1; k < n; k++) if (w[k] <= $2 && $2 < w[k+1]) {
        between = v[k] + (v[k+1] - v[k])*($2 - w[k])/(w[k+1] - w[k])
        m++; d = $c - between; if (!(d*d < 0.01^2)) bad++ } }
    END { exit !(m > 30 && !bad) }' rise.csv fall.csv
ok $? 'between 9.2 and 10.6 both ways give the same within 1 cm'
sweep plane.csv 9.2 9.8 --set sweep.seed=0
curve '{ good++; if (!(v3 == 0)) bad++ }' plane.csv 'without seed it stays in its plane'

# The same curve by the implicit scheme: in the plane and where it whirls; not where the whirl grows
# from the seed, whose beginning depends on the last digit of a growth over a hundred seconds.
sweep implicit.csv 4 6 --set time.scheme=alpha
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    FNR == 1 { next }
    FNR == NR { if ($1 == "up") { n++; w[n] = $2; v2[n] = $c["v2_1_amplitude_m"]; v3[n] = $c["v3_1_amplitude_m"] }
        next }
    { m++; d2 = $c["v2_1_amplitude_m"]/v2[m] - 1; d3 = $c["v3_1_amplitude_m"] - v3[m]
      if (($2 - w[m])^2 > 1e-6 || $2 > 4.1 && $2 < 5.05 && d2*d2 > 0.005^2 ||
          $2 > 5.2 && (d2*d2 > 0.005^2 || d3*d3 > (0.005*v3[m])^2)) bad++ }
    END { exit !(m > 150 && !bad) }' whirl.csv implicit.csv
ok $? 'scheme = alpha: the same curve within 0.5 per cent'

# Steady states found by themselves, by both schemes; how long their steps are.
# steady SCHEME CASE OPTION...: the row by name as shell variables.
steady()
{
    scheme=$1
    case=$2
    shift 2
    runs 0 "steady, $scheme, $case $*" diffverf -v --steady --set time.scheme="$scheme" "$@" "$case"
    mv out "steady-$scheme-$case.csv"
    # alpha: as noted; central: the step of the case
    [ "$scheme" = central ] && diffverf -v --set time.scheme=central --set time.end=1 "$@" \
        --set time.output_every="$(awk -F, 'NR == 2 { printf "%.17g", 2*atan2(0, -1)/$6/50 }' \
        "steady-$scheme-$case.csv")" "$case" 2>err >/dev/null
    awk '/ steps of / { print $5 } / steps, / { print $4 }' err >"step-$scheme"
}

# finds CONDITION FILE NAME: over the columns of the one row by name, v["..."].
finds()
{
    awk -F, 'function near(name, wanted, relative) {
            d = v[name] - wanted; if (!(name in v)) exit 2
            return d*d <= (relative*wanted)^2
        }
        NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
        { for (i = 1; i <= NF; i++) v[name[i]] = $i }
        END { exit !('"$1"') }' "$2"
    ok $? "$3"
}

# agree CASE COLUMN...: both schemes within 0.5 per cent, alpha with a tenth of the steps at most.
agree()
{
    case=$1
    shift
    for column; do
        cut -d, -f"$(head -n 1 "steady-central-$case.csv" | tr , '\n' | grep -nx "$column" | cut -d: -f1)" \
            "steady-central-$case.csv" "steady-alpha-$case.csv" | awk 'NR % 2 == 0 { x[NR/2] = $1 }
            END { d = x[1]/x[2] - 1; print "# " x[1], x[2]; exit !(d*d <= 0.005^2) }'
        ok $? "$case: $column by both schemes within 0.5 per cent"
    done
    awk 'NR == FNR { a = $1; next } { print "# steps of " a " and " $1 " s"; exit !($1 >= 10*a) }' \
        step-central step-alpha
    ok $? "$case: at least ten times fewer steps per simulated second"
}
for scheme in central alpha; do
    steady $scheme rope2.ini
    finds 'v["kind"] == "periodic" && v["period_ratio"] == "1:2" && v["plane"] == "lateral"' \
        "steady-$scheme-rope2.ini.csv" "point A, $scheme: a lateral motion of two periods"
    finds 'near("v3_1_amplitude_m", 1.2035, 0.005) && near("v3_1_half_m", 1.2235, 0.005) &&
        v["axes_ratio_1"] < 0.001' "steady-$scheme-rope2.ini.csv" "point A, $scheme: +-1.2035 m"
done
agree rope2.ini v3_1_amplitude_m v3_1_half_m tension_1_N
for scheme in central alpha; do
    steady $scheme rope1.ini --set 'motion deck.omega=5.15' --set disturbance.mode=1 \
        --set disturbance.amplitude=0.02
    finds 'v["kind"] == "periodic" && v["period_ratio"] == "1:1" && v["support_phase"] == "counter" &&
        v["plane"] ~ /^whirling[+-]$/' "steady-$scheme-rope1.ini.csv" "SEIL1 5.15, $scheme: whirls"
    finds 'near("half_axis_1_m", 1.137, 0.005) && near("minor_half_axis_1_m", 0.641, 0.005) &&
        v["tilt_1_deg"]^2 > 11.5^2 && v["tilt_1_deg"]^2 < 12.5^2' "steady-$scheme-rope1.ini.csv" \
        "SEIL1 5.15, $scheme: half axes 1.137 and 0.641 m, 12 degrees"
done
agree rope1.ini v2_1_amplitude_m v3_1_amplitude_m half_axis_1_m minor_half_axis_1_m
# Others as rows of one table.
cat >points.csv <<END
motion deck.omega,disturbance.mode,disturbance.amplitude
4.71,1,0.1
4.40,1,0.02
9.68,1,0.02
5.80,1,0.3
END
runs 0 'SEIL1 at four points' diffverf --points points.csv --set 'motion deck.omega=5' rope1.ini
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    function near(name, wanted) { d = $c[name] - wanted; return d*d <= (0.005*wanted)^2 }
    NR == 2 && $4 $5 $6 == "periodic1:1in" && near("v2_1_least_m", -0.771) && near("v2_1_greatest_m", 0.825) ||
    NR == 3 && $4 $5 $6 == "periodic1:1in" && near("v2_1_least_m", -0.588) && near("v2_1_greatest_m", 0.635) ||
    NR == 4 && $4 $5 $6 == "periodic1:2lateral" && near("v3_1_amplitude_m", 1.185) ||
    NR == 5 && $4 $5 $6 $7 == "periodic1:1inin-phase" && $c["v3_1_amplitude_m"] < 1e-4 { good++ }
    END { exit good != 4 }' out
ok $? 'SEIL1 4.71, 4.40, 9.68, 5.80: the published orbits'

# An ensemble of 20 x 20 frequencies and amplitudes around point A against 400 single runs, row by
# row.  Lanes and the plain march differ by round-off, some 1e-16 in a step, and orbits that attract
# forget it: 2e-11 of the amplitude is seen, 1e-8 allowed.  A verdict could differ only where a change
# comes as near to the tolerance as that; in 400 points it does not.  Four elements, a loose tolerance
# and blocks of eight periods keep it short.
awk 'BEGIN { print "motion deck.omega,motion deck.amplitude"
    for (i = 0; i < 20; i++) for (j = 0; j < 20; j++)
        printf "%.6g,%.6g 0 0\n", 8.9 + 0.025*i, 0.006 + 0.004*j }' >grid.csv
set -- --set mesh.elements=4 --set time.end=90 --set steady.tolerance=1e-2 --set steady.periods=8 \
    --set disturbance.time=0 --set disturbance.amplitude=0.1
runs 0 'an ensemble of 400 points' diffverf "$@" --points grid.csv -o grid.out rope2.ini
[ ! -s err ] && [ "$(wc -l <grid.out)" -eq 401 ]
ok $? '400 rows, no failure'
# Every second single run, two at a time.
for part in 0 1; do
    (
        options=$*
        awk -F, -v part=$part 'NR > 1 && NR % 2 == part' grid.csv |
            while IFS=, read -r omega amplitude; do
                printf '%s,%s,' "$omega" "$amplitude"
                # shellcheck disable=SC2086
                diffverf -q --steady $options --set "motion deck.omega=$omega" \
                    --set "motion deck.amplitude=$amplitude" rope2.ini | tail -n 1
            done >"single-$part"
    ) &
done
wait
awk -F, 'FILENAME ~ /^single/ { row[$1 "," $2] = $0; next }
    FNR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
    {
        n++; split(row[$1 "," $2], s, ","); kinds[$3 $4]++
        size = $15 > $18 ? $15 : $18 # amplitudes of v2, v3
        for (i = 1; i <= 7; i++) if ($i != s[i] && i != 6) { bad++; print "# " $0 "\n# " row[$1 "," $2] }
        for (i = 11; i <= 27; i++) { d = $i - s[i]; if (!(d*d <= (1e-8*size)^2)) { bad++; print "# " name[i], $i, s[i] }
            if (d*d > most*most*size*size) most = (d < 0 ? -d : d)/size }
    }
    END { printf "# largest difference %.2g of the amplitude;", most
        for (k in kinds) printf " %s %d", k, kinds[k]
        print ""
        exit !(n == 400 && !bad && kinds["periodic1:2"] > 200 && kinds["periodic1:1"] > 5) }' \
    single-0 single-1 grid.out
ok $? 'row by row as single runs'

# The studies and their pictures, on coarser grids.
for study in protocols ensemble-seil2; do
    runs 2 "$study: usage" "$experiments/$study/run"
    says 'usage: run DIR' "$study: says how"
done
for plot in sweep ensemble protocol; do
    runs 2 "plot/$plot: usage" "$top/scripts/plot/$plot"
    says "usage: $plot " "plot/$plot: says how"
done
runs 2 'plot/sweep: no sweep' "$top/scripts/plot/sweep" points.csv points.csv - none.png
says 'are no sweeps of diffverf' 'plot/sweep: says so'
runs 2 'plot/ensemble: no table of points' "$top/scripts/plot/ensemble" rise.csv rise.csv none.png
says 'is no table of points' 'plot/ensemble: says so'
[ ! -e none.png ]
ok $? 'no picture without data'
if command -v gnuplot >/dev/null 2>&1; then
    runs 0 'plot/sweep: a table' "$top/scripts/plot/sweep" rise.csv fall.csv - curves.png
    png curves.png
    ok $? 'plot/sweep: a picture'
    { cat rise.csv; sed 1d fall.csv; } >both.csv
    runs 0 'plot/sweep: both ways in one table' "$top/scripts/plot/sweep" both.csv - - both.png
    cmp -s curves.png both.png && [ ! -s err ]
    ok $? 'plot/sweep: the same picture, nothing on stderr'
    runs 0 'protocols' env QUICK=yes "$top/scripts/experiment" all "$experiments/protocols" sweep
    [ ! -s err ]
    ok $? 'protocols: nothing on stderr'
    for part in seil1-a seil1-b seil2-a seil2-b; do
        png sweep/$part.png
        ok $? "protocols: $part.png"
    done
    # What the records saw, in their order; a quick sweep may add what rings down.
    order()
    {
        [ "$(awk -F, -v key="$1" '$1 "," $2 "," $3 == key { print $5 }' sweep/kinds.csv | paste -s -d : |
            grep -cE "$2")" -eq 1 ]
        ok $? "protocols: $1: $2"
    }
    order 1,a,up '^quasi-static:vertical:rotation:.*counter-phase$'
    order 1,a,down '^counter-phase:vertical:rotation:vertical:quasi-static$'
    order 2,a,up '^quasi-static:vertical:rotation:.*counter-phase$'
    order 2,a,rest '^quasi-static:vertical:rotation:counter-phase$'
    order 1,b,up 'lateral parametric$'
    order 1,b,down '^counter-phase:vertical parametric:lateral parametric'
    order 2,b,down '^counter-phase:vertical parametric:lateral parametric'
    runs 0 'ensemble-seil2' env SIDE=6 "$experiments/ensemble-seil2/run" ensemble
    same out ensemble/table.txt 'ensemble-seil2: prints its table'
    grep -q '^54 points:' out && [ "$(wc -l <ensemble/states.csv)" -eq 55 ]
    ok $? 'ensemble-seil2: 54 points'
    # the grid's amplitudes are 15 mm apart: none vibrates below the boundary by more than 3 mm where
    # the branch begins at zero, none above it by more than that distance stays in its plane
    awk '/^ *[89]\.[0-9]/ && $1 < 9.3 && $3 != "-" { n++
        if (!($2 > $3 - 0.003 && $2 < $3 + 0.0155)) bad++ } END { exit !(n >= 3 && !bad) }' out
    ok $? 'ensemble-seil2: lateral vibration begins at the boundary of stabil'
    png ensemble/ensemble-seil2.png
    ok $? 'ensemble-seil2: the picture'
else
    skip 'no gnuplot here'
fi

finish
