#!/bin/sh
# scripts/check-point: the nonlinear equations at points of the map of SEIL2 (Thalheim 6.2.4.2).
. "$(dirname "$0")/../tap.sh"
case=$top/scripts/experiments/seil2-whirl/case.ini
header='ratio,omega_rad_s,amplitude_m,mode,partner,crossing,predicted_1_s,measured_1_s,difference,verdict,component,limit_m,ground_m'

# point NAME RATIO AMPLITUDE CONDITION [OPTION...]: over fields f[1, column].
point()
{
    name=$1
    ratio=$2
    amplitude=$3
    condition=$4
    shift 4
    runs 0 "$name: runs" "$top/scripts/check-point" "$case" "$ratio" "$amplitude" "$@"
    header "$scratch/out" "$header" "$name: header"
    [ ! -s "$scratch/err" ]
    ok $? "$name: nothing on stderr"
    holds "n == 1 && $condition" "$scratch/out" "$name: $condition"
}

# mode 4, crossing 6, predicted 7, difference 9, verdict 10, component 11, limit 12
point 'point A' 1.00054 0.05 \
    'f[1,4] == 1 && f[1,6] == "2T" && abs(f[1,2] - 9.124) < 1e-4 && abs(f[1,9]) < 0.02'
holds 'f[1,10] == "grows" && f[1,11] == "v3" && abs(f[1,12]/1.2035 - 1) < 2e-3' "$scratch/out" \
    'point A: grows to the published limit cycle'
point 'point B' 0.8001 0.05 \
    'f[1,7] < -0.09 && abs(f[1,9]) < 0.01 && f[1,10] == "dies" && f[1,12] < 1e-6'
point 'below the threshold of 8.7 mm' 1 0.008 'f[1,7] < 0 && f[1,10] == "dies"'
point 'above it' 1 0.0095 'f[1,7] > 0 && f[1,10] == "grows" && abs(f[1,9]) < 0.05'
point 'a mode in the plane' 1.05 0.05 \
    'f[1,4] == 2 && f[1,10] == "grows" && f[1,11] == "v2" && abs(f[1,9]) < 0.02'
point 'without damping' 1 0.01 'f[1,10] == "grows" && abs(f[1,9]) < 0.02' \
    --set damping.alpha=0 --set damping.beta=0

runs 2 'check-point: usage' "$top/scripts/check-point" "$case" 1
says 'usage: check-point ' 'check-point: says how'
runs 2 'check-point: no number' "$top/scripts/check-point" "$case" one 0.05
runs 2 'check-point: no case' "$top/scripts/check-point" "$scratch/none.ini" 1 0.05
runs 2 'check-point: nothing moves' "$top/scripts/check-point" "$case" 1 0.05 \
    --set 'motion deck.amplitude=' --set 'motion deck.omega=' --set 'motion deck.support='
# The study of the map and its pictures.
study=$top/scripts/experiments/stability-levels
plot=$top/scripts/plot/stability
runs 2 'stability-levels: usage' "$study/run"
says 'usage: run DIR' 'stability-levels: says how'
runs 2 'plot/stability: usage' "$plot"
says 'usage: stability ' 'plot/stability: says how'
runs 2 'plot/stability: no map' "$plot" "$study/case.ini" "$scratch/none.png"
stabil --set stability.ratio_start=0.7 --set stability.ratio_end=0.71 "$study/case.ini" \
    >"$scratch/empty.csv"
runs 2 'plot/stability: a map without rows' "$plot" "$scratch/empty.csv" "$scratch/none.png"
[ ! -e "$scratch/none.png" ]
ok $? 'no picture without data'
if ! command -v gnuplot >/dev/null 2>&1; then
    skip 'no gnuplot here'
    finish
fi
runs 0 'stability-levels' "$study/run" "$scratch/study"
same "$scratch/out" "$scratch/study/table.txt" 'stability-levels: prints its table'
[ ! -s "$scratch/err" ]
ok $? 'stability-levels: nothing on stderr'
for map in levels floquet; do
    png "$scratch/study/$map.png"
    ok $? "stability-levels: $map.png"
done
# expected 5, computed 6: to the digits of theory
awk -F, 'NR > 1 { n++; if (($6 - $5)^2 > 0.55e-5^2) bad++ } END { exit !(n == 8 && !bad) }' \
    "$scratch/study/thresholds.csv"
ok $? 'stability-levels: eight thresholds, both theories, both ground motions'
runs 0 'stability-levels: differences are explained' "$top/scripts/experiment" compare "$study" \
    "$scratch/study"
# In its region of mode 2 the indifference theory is wider, in that of mode 1 the same.
awk -F, 'NR > 1 { w[$1, $2, $3] = $5 - $4; a[$2] = 1 }
    END {
        for (x in a) {
            n++
            if (!(w[2, x, "indifference"] > 1.08*w[2, x, "classical"])) bad++
            if (!((w[1, x, "indifference"] - w[1, x, "classical"])^2 < 1e-10)) bad++
        }
        exit !(n == 4 && !bad)
    }' "$scratch/study/widths.csv"
ok $? 'stability-levels: wider in the plane, the same out of it'
# lowest points of Bolotin are where Floquet's modulus goes through 1: on the same ratio
awk -F, '
    NR == FNR {
        if (FNR > 1 && $4 == "2T" && $5 == 1) bolotin[sprintf("%.4f", $1)] = $3
        next
    }
    FNR > 1 && sprintf("%.4f", $1) in bolotin && $1 > 0.75 && $1 < 1.03 {
        k = bolotin[sprintf("%.4f", $1)]
        if ($3 > k + 1e-6 && !($4 > 1) || $3 < k - 1e-6 && $4 > 1) bad++
        n++
    }
    END { exit !(n > 5000 && !bad) }' "$scratch/study/indifference-damped.csv" \
    "$scratch/study/floquet.csv"
ok $? 'stability-levels: Bolotin and Floquet agree in the region of mode 1'
stabil --trace --set stability.method=floquet --set stability.ratio_step=0.02 \
    "$study/case.ini" >"$scratch/trace.csv"
runs 0 'plot/stability: curves' "$plot" "$scratch/trace.csv" "$scratch/trace.png"
png "$scratch/trace.png"
ok $? 'plot/stability: the picture of curves'
finish
