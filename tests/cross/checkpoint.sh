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
finish
