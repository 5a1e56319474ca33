#!/bin/sh
# stabil as a user meets it: columns, modes from a directory, threads, stopped runs, forces, errors.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1

cat >bare.ini <<EOF
[cable]
unstressed_length = 100.429
mass_per_length = 0.704
youngs_modulus = 1.5556e11
area = 8.48e-5
[supports]
span = 100.534
[mesh]
elements = 10
law = thesis
[damping]
alpha = 0.10951
beta = 3.5061e-3
[stability]
amplitude_end = 0.05
EOF
printf '[motion deck]\namplitude = 0.05 0 0\nomega = 9.124\n' | cat bare.ini - >seil2.ini
printf '[force]\nposition = 0.3\nvalue = 0 2 0\nomega = 3\n' | cat bare.ini - >force.ini
printf '[motion deck]\nfile = record.csv\n' | cat bare.ini - >record.ini
printf 'time_s,u1_m,u2_m,u3_m\n0,0,0,0\n1,0.1,0,0\n2,0,0,0\n' >record.csv

three='--set stability.ratio_start=0.95 --set stability.ratio_step=0.05 --set stability.ratio_end=1.05'
floquet='--set stability.method=floquet --set stability.amplitude_step=0.01'

# The worked numbers, by the columns.
runs 0 'three ratios' stabil $three --set stability.ground=undamped seil2.ini
header out 'ratio,omega_rad_s,amplitude_m,period,mode,partner,order,share' 'boundaries: columns'
holds 'n == 5 && abs(f[1, 3] - 0.02281) < 5.1e-6 && abs(f[2, 3] - 0.00867) < 5.1e-6 &&
    abs(f[4, 3] - 0.01392) < 5.1e-6 && f[1, 4] == "2T" && f[1, 5] == 1 && f[4, 5] == 2' out \
    'smallest amplitudes and modes'
holds 'abs(f[2, 1] - 1) < 1e-12 && abs(f[2, 2] - 9.119036) < 1e-5 && f[2, 7] == 1' out 'frequencies'
runs 0 'the classical theory' stabil $three --set stability.ground=undamped \
    --set stability.theory=classical seil2.ini
holds 'abs(f[1, 3] - 0.02281) < 5.1e-6 && abs(f[2, 3] - 0.00867) < 5.1e-6 &&
    abs(f[4, 3] - 0.01520) < 5.1e-6' out 'narrower in the plane'
runs 0 'a grid of multipliers' stabil $three $floquet seil2.ini
header out 'ratio,omega_rad_s,amplitude_m,multiplier' 'grid: columns'
holds 'n == 18 && f[7, 4] < 1 && f[8, 4] > 1' out 'the boundary lies between'
cp out grid.csv
runs 0 'growth' stabil $three $floquet --growth seil2.ini
header out 'ratio,omega_rad_s,amplitude_m,multiplier,growth_1_s,crossing,mode,partner' \
    'growth: columns'
cut -d, -f1-4 out >cut.csv
same cut.csv grid.csv 'the same multipliers'
holds 'abs(f[8, 5] - log(f[8, 4])*f[8, 2]/6.283185307179586) < 1e-9 && f[8, 6] == "2T" &&
    f[8, 7] == 1' out 'growth of a multiplier over the period'
runs 0 'curves' stabil $three $floquet --trace seil2.ini
header out 'ratio,omega_rad_s,amplitude_m,multiplier,growth_1_s,crossing,mode,partner' \
    'curves: columns'
cp out curves.csv
runs 0 'Bolotin beside them' stabil $three seil2.ini
awk -F, 'FNR == 1 { next } NR == FNR { if (!($1 in low)) low[$1] = $3; next }
    { d = $3/low[$1] - 1; if (d < 0) d = -d; if (!(d < 1e-6)) bad = 1; rows++ }
    END { exit bad || rows != 3 }' out curves.csv
ok $? 'curves start on the boundaries'
runs 0 'answers' stabil --answers seil2.ini
header out 'period,mode,order,ratio,omega_rad_s,amplitude_m,damping_ratio,safe_factor,safe_damping_ratio' \
    'answers: columns'
holds 'n >= 3 && f[1, 6] < f[2, 6] && f[2, 6] < f[3, 6] && f[2, 8] > 1 &&
    abs(f[2, 9]/(f[2, 8]*f[2, 7]) - 1) < 1e-12' out 'lowest first, and damping that is enough'
factor=$(awk -F, 'NR == 3 { print $8 }' out)
awk -v k="$factor" '/^alpha/ { print "alpha =", k*0.10951; next }
    /^beta/ { print "beta =", k*3.5061e-3; next } { print }' seil2.ini >safe.ini
runs 0 'with that damping' stabil --answers --set stability.amplitude_end=0.051 safe.ini
awk -F, '$1 == "2T" && $2 == 1 && $6 > 0.04999 && $6 < 0.05001 { found = 1 } END { exit !found }' out
ok $? 'the region begins at the wanted amplitude'
runs 0 'answers by short steps' stabil --answers -o short.csv --set stability.ratio_step=0.0005 seil2.ini
runs 0 'answers by long steps' stabil --answers -o steps.csv --set stability.ratio_step=0.01 seil2.ini
"$compare" -r 1e-6 -c order,ratio,amplitude_m,safe_factor short.csv steps.csv >&2
ok $? 'the same answers'

# Modes of a directory, threads.
runs 0 'modal' modal -d model -o modal.csv --set mesh.elements=10 seil2.ini
runs 0 'a whole map' stabil -o whole.csv seil2.ini
runs 0 'from a directory' stabil -d model -o read.csv seil2.ini
"$compare" -r 1e-9 -c ratio,omega_rad_s,amplitude_m,order whole.csv read.csv >&2
ok $? 'the same map of the modes that modal left'
runs 0 'two threads' stabil --threads 2 -o two.csv seil2.ini
same whole.csv two.csv 'the same bytes by two threads'
runs 0 'multipliers by two threads' stabil --threads 2 $three $floquet seil2.ini
same grid.csv out 'the same bytes'
runs 0 'answers by one' stabil --answers -o one-answer.csv seil2.ini
runs 0 'answers by two' stabil --answers --threads 2 -o two-answers.csv seil2.ini
same one-answer.csv two-answers.csv 'the same answers'
[ ! -e whole.csv.state ]
ok $? 'no state is left'

# A run that is stopped and goes on.
long='--set stability.method=floquet --set stability.amplitude_step=0.00025 --growth
    --set stability.ratio_step=0.002'
runs 0 'a long map' stabil $long -o long.csv seil2.ini
again=
stopped=0
for delay in 0.2 0.1 0.15 0.2; do
    stabil $long -o stop.csv $again seil2.ini 2>err &
    pid=$!
    sleep $delay
    kill -s TERM $pid 2>kill.err
    wait $pid 2>wait.err
    if [ $? -eq 143 ]; then
        stopped=$((stopped + 1))
        cp err err.stopped
    fi
    [ ! -e stop.csv.state ] || again=--resume
    [ ! -e stop.csv ] || break
done
[ $stopped -gt 0 ]
ok $? "was stopped $stopped times"
grep -q -e '--resume goes on from stop.csv.state' err.stopped
ok $? 'and said how to go on'
if [ -e stop.csv.state ]; then
    runs 2 'another case' stabil $long -o stop.csv --resume --set damping.alpha=0.2 seil2.ini
    says 'another case' 'is refused'
    printf 'half a li' >>stop.csv.part
    runs 0 'resumed' stabil $long -o stop.csv --resume seil2.ini
else
    skip 'finished before it could be stopped'
fi
same long.csv stop.csv 'the same bytes'
[ ! -e stop.csv.state ] && [ ! -e stop.csv.part ]
ok $? 'nothing else is left'

# A force in place of the motion; its amplitude is in newtons, whatever the size of value.
runs 0 'a force' stabil --set stability.amplitude_end=800 force.ini
header out 'ratio,omega_rad_s,amplitude_N,period,mode,partner,order,share' 'is in newtons'
holds 'n > 3 && f[1, 3] > 0 && f[1, 3] < 800' out 'its boundaries'
cp out force.csv
sed 's/^value.*/value = 0 20 0/' force.ini >tenfold.ini
runs 0 'ten times the value' stabil --set stability.amplitude_end=800 tenfold.ini
"$compare" -r 1e-9 -c amplitude_N force.csv out >&2
ok $? 'is the same direction'
# A motion of both supports along the chord alike strains nothing but by its inertia.
sed 's/^\[motion deck\]/&\nsupport = right/' seil2.ini >both.ini
printf '[motion tower]\nsupport = left\namplitude = 0.05 0 0\nomega = 9.124\n' >>both.ini
runs 0 'both supports alike' stabil $three both.ini
holds 'n == 0' out 'make no resonance'

# Quadratic terms.
runs 0 'quadratic terms' stabil $three --set stability.quadratic=yes seil2.ini
holds 'n >= 3 && abs(f[1, 3] - 0.02281) < 2e-3 && f[1, 3] != 0.02281' out 'change little'
cp out quadratic.csv
runs 0 'their multipliers' stabil $three $floquet --trace --set stability.quadratic=yes seil2.ini
awk -F, 'FNR == 1 { next } NR == FNR { if (!($1 in low)) low[$1] = $3; next }
    { d = $3/low[$1] - 1; if (d < 0) d = -d; if (!(d < 1e-5)) bad = 1; rows++ }
    END { exit bad || rows != 3 }' quadratic.csv out
ok $? 'agree'

# Errors.
runs 2 'no excitation' stabil bare.ini
says 'nothing excites this cable' 'is told'
printf '[force]\nposition = 0.3\nvalue = 0 2 0\nomega = 3\n' | cat seil2.ini - >two.ini
runs 2 'motion and force' stabil two.ini
says 'either [motion] or [force]' 'is refused'
runs 2 'a record' stabil record.ini
says 'a map needs harmonic motions' 'is refused'
runs 2 '--growth of boundaries' stabil --growth seil2.ini
says 'belong to stability.method = floquet' 'is refused'
runs 2 '--trace of boundaries' stabil --trace seil2.ini
runs 2 '--answers by multipliers' stabil --answers $floquet seil2.ini
says '--answers and --change belong to stability.method = bolotin' 'is refused'
runs 2 '--resume to standard output' stabil --resume seil2.ini
says '--resume needs -o FILE' 'is refused'
runs 2 '--answers --resume' stabil --answers --resume -o a.csv seil2.ini
runs 2 'too many frequencies' stabil --set stability.ratio_step=1e-9 seil2.ini
says 'are more than can be done' 'are refused'
sed 's/^amplitude = 0.05 0 0/amplitude = 0 0 0/' seil2.ini >still.ini
runs 2 'a motion of no direction' stabil still.ini
says 'a direction is needed' 'is refused'
runs 0 'four modes' modal --modes 4 -d four -o four.csv seil2.ini
runs 2 'too few modes in the directory' stabil -d four --set stability.modes='1 5' seil2.ini
says 'holds 4 modes; mode 5 is wanted' 'is told'

runs 0 'a damper in the case' stabil --set damper.position=0.1 --set 'damper.direction=0 1 0' \
    --set damper.coefficient=10 --set stability.ratio_start=1 --set stability.ratio_end=1 seil2.ini
says '[damper] is not taken in' 'is told'

# An undamped resonance of the ground motion, to round-off.
runs 0 'an undamped resonance' stabil --set stability.ground=undamped \
    --set stability.reference_mode=2 --set stability.ratio_start=0.5 \
    --set stability.ratio_end=0.5 seil2.ini
says 'an undamped resonance of the ground motion: no row' 'is told'
holds 'n == 0' out 'and has no row'

# scripts/nearest-resonance: a deck at twice the first frequency, and one that is far from all.
first=$(modal --modes 1 seil2.ini | awk -F, 'NR == 2 { printf "%.10g", $3 }')
awk -v f="$first" 'BEGIN { print "mode,frequency_Hz"; printf "1,0.01\n2,%.10g\n", 2*f }' >deck.csv
runs 0 'a deck at twice the first frequency' "$top/scripts/nearest-resonance" deck.csv seil2.ini
cp out nearest.csv
runs 0 'the map at this frequency' stabil -q --set stability.modes=1 --set stability.ratio_start=1 \
    --set stability.ratio_end=1 --set stability.reference_mode=1 seil2.ini
awk -F, 'NR == FNR { if (FNR > 1 && $4 == "2T" && (least == "" || $3 < least)) least = $3; next }
    FNR == 2 { exit !($2 == 1 && $3 == "out" && $4 == 1 && $6*$6 < 1e-16 && least > 0 &&
        ($7/least - 1)^2 < 1e-12 && $8 == $1 && $9 == 1 && $10 == $7) }' out nearest.csv # deck: ten digits
ok $? 'is the principal resonance of mode 1, from the amplitude that stabil has'
echo 'mode,frequency' >deck.csv
runs 2 'a deck without frequencies' "$top/scripts/nearest-resonance" deck.csv seil2.ini
says 'deck.csv: has no column frequency_Hz with numbers above 0' 'is told'

finish
