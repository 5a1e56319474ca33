#!/bin/sh
# diffverf as a user meets it: records, forces, wind, dampers, states and resumed runs, fields,
# energy.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
cp "$top/scripts/experiments/seil2-whirl/case.ini" whirl.ini
cat >cable.ini <<END
[cable]
unstressed_length = 100.429
mass_per_length = 0.704
axial_stiffness = 1.319e7
[supports]
span = 100.534
[mesh]
elements = 8
[damping]
alpha = 0.1
[time]
end = 3
output_every = 0.05
END

# close FILE FILE TOLERANCE NAME: displacements of two tables, in metres.
close()
{
    "$compare" -a "$3" -c v1_1_m,v2_1_m,v3_1_m "$1" "$2" >&2
    ok $? "$4"
}

# Records: a motion and a force sampled from a cosine beside the harmonic ones.
awk 'BEGIN { print "time_s,u1_m,u2_m,u3_m"
    for (i = 0; i <= 400; i++) printf "%.10g,%.17g,0,%.17g\n", i/100, 0.05*cos(9*i/100),
        0.02*cos(9*i/100) }' >motion.csv
sed 's/,u1_m,u2_m,u3_m/,f1_N,f2_N,f3_N/' motion.csv >force.csv
runs 0 'a recorded motion' diffverf --set motion.file=motion.csv -o a.csv cable.ini
runs 0 'a harmonic motion' diffverf --set 'motion.amplitude=0.05 0 0.02' --set motion.omega=9 \
    -o b.csv cable.ini
# the spline's first interval is a little off: its end slope is that of a parabola
close a.csv b.csv 5e-5 'move the cable alike'
runs 0 'a recorded force' diffverf --set force.file=force.csv --set force.position=all \
    -o a.csv cable.ini
runs 0 'a harmonic force' diffverf --set 'force.value=0.05 0 0.02' --set force.position=all \
    --set force.omega=9 -o b.csv cable.ini
close a.csv b.csv 1e-6 'move the cable alike'
mkdir away
cp cable.ini motion.csv away
runs 0 'a record beside the case, from elsewhere' diffverf --set motion.file=motion.csv \
    -o c.csv away/cable.ini
runs 2 'a record that is not there' diffverf --set motion.file=nothing.csv cable.ini
says 'nothing.csv: cannot be opened' 'is told'
runs 2 'a record of other columns' diffverf --set motion.file=force.csv cable.ini
says 'force.csv:1: the columns time_s,u1_m,u2_m,u3_m are expected' 'is told'
printf 'time_s,u1_m,u2_m,u3_m\n0,0,0,0\n1,0,x,0\n' >bad.csv
runs 2 'a record with a letter' diffverf --set motion.file=bad.csv cable.ini
says 'bad.csv:3: column 3' 'is told with its line'
printf 'time_s,u1_m,u2_m,u3_m\n0,0,0,0\n1,0,0,0\n1,0,0,0\n' >bad.csv
runs 2 'a record that stands still' diffverf --set motion.file=bad.csv cable.ini
says 'bad.csv:4: time_s must ascend' 'is told with its line'
printf 'time_s,u1_m,u2_m,u3_m\n0,0,0,0\n' >bad.csv
runs 2 'a record of one row' diffverf --set motion.file=bad.csv cable.ini
printf 'time_s,u1_m,u2_m,u3_m\n0,0,0\n1,1,1\n' >bad.csv
runs 2 'a record cut short' diffverf --set motion.file=bad.csv cable.ini
runs 2 'an empty record' diffverf --set motion.file=/dev/null cable.ini

# A constant force is statics: at rest from the first row on.
runs 0 'a constant force' diffverf --set 'force.value=0 5 -3' --set force.position=0.5 cable.ini
holds 'abs(f[1, 3] - f[n, 3]) < 1e-8 && f[1, 3] > 5e-3 && f[1, 4] < -3e-3' out \
    'the static start is its equilibrium'
runs 0 'wind' diffverf --set 'wind.speed=0 0 20' --set wind.drag_coefficient=1.2 \
    --set wind.diameter=0.012 cable.ini
holds 'abs(f[1, 4] - f[n, 4]) < 1e-6 && f[1, 4] > 0.05' out 'wind blows it aside, and it stays there'
# The support forces change by what the wind brings: 1.225/2 1.2 0.012 20^2 a metre.
holds 'abs((f[1, 8] + f[1, 11]) + 1.225/2*1.2*0.012*400*100.53) < 0.5' out \
    'the supports hold what the wind brings'
runs 2 'wind without diameter' diffverf --set 'wind.speed=0 0 20' --set wind.drag_coefficient=1 cable.ini
says 'diameter: is missing' 'is told'
runs 0 'a damper' diffverf --set damper.position=0.5 --set 'damper.direction=0 0 1' \
    --set damper.coefficient=20 --set 'time.start=mode 1 0.1' --set time.end=6 -o a.csv cable.ini
runs 0 'no damper' diffverf --set 'time.start=mode 1 0.1' --set time.end=6 -o b.csv cable.ini
awk -F, 'FNR > 80 { x = $4 < 0 ? -$4 : $4; if (x > most[FILENAME]) most[FILENAME] = x }
    END { exit !(most["a.csv"] < 0.4*most["b.csv"]) }' a.csv b.csv
ok $? 'takes the swing away'

# States: a run that is stopped again and again, and one that never is.
long='--set time.end=400 --energy'
runs 0 'a whole run' diffverf $long -o whole.csv --field whole.npy whirl.ini
again=
stopped=0
for delay in 0.2 0.3 0.2; do
    diffverf $long -o cut.csv --field cut.npy $again whirl.ini 2>err &
    pid=$!
    sleep $delay
    kill -s TERM $pid 2>kill.err
    wait $pid 2>wait.err
    [ $? -ne 143 ] || stopped=$((stopped + 1))
    [ ! -e cut.csv.state ] || again=--resume
done
[ $stopped -gt 0 ]
ok $? "was stopped $stopped times"
says '--resume goes on from' 'and said how to go on'
[ ! -e cut.csv ]
ok $? 'no result stands there meanwhile'
cp cut.csv.part torn.part
printf 'half a li' >>cut.csv.part # as a crash after the last checkpoint leaves it
runs 0 'resumed' diffverf $long -o cut.csv --field cut.npy --resume whirl.ini
same whole.csv cut.csv 'the same rows, byte for byte'
same whole.npy cut.npy 'the same fields, byte for byte'
[ ! -e cut.csv.state ] && [ ! -e cut.csv.part ] && [ ! -e cut.npy.part ]
ok $? 'nothing else is left'
runs 0 'checkpoints' diffverf --checkpoint 1 --set time.end=40 -o early.csv whirl.ini
runs 0 'a run with a state' diffverf --state run.state --set time.end=10 whirl.ini
cp out first.csv
runs 0 'goes on with another end' diffverf --state run.state --resume --set time.end=15 whirl.ini
cat first.csv out >both.csv
runs 0 'as one run' diffverf --set time.end=15 whirl.ini
same out both.csv 'the rows on standard output follow each other'
cp out one.csv
runs 0 'a finished file' diffverf --state file.state --set time.end=10 -o file.csv whirl.ini
runs 0 'grows' diffverf --state file.state --resume --set time.end=15 -o file.csv whirl.ini
same one.csv file.csv 'to the same as one run'
runs 2 'another case' diffverf --state run.state --resume --set damping.alpha=0 whirl.ini
says 'only time.end may change' 'is refused'
runs 2 'other columns' diffverf --state run.state --resume --energy whirl.ini
says 'or of other options' 'are refused'
runs 2 'another file' diffverf --state run.state --resume -o new.csv whirl.ini
says 'go on in the same way' 'is refused'
runs 2 'no state at all' diffverf --resume whirl.ini
says 'needs the state' 'is told'
runs 2 'a state of nothing' diffverf --state nothing --resume whirl.ini
runs 2 'a state that is none' diffverf --state whirl.ini --resume whirl.ini
head -c 1000 run.state >short.state
runs 2 'a state cut short' diffverf --state short.state --resume whirl.ini
rm -f file.csv
runs 2 'a result that is gone' diffverf --state file.state --resume -o file.csv --set time.end=20 whirl.ini
says 'neither it nor file.csv.part is there' 'is told'

# A state as a start: the cable goes on from it.
runs 0 'to 5 s' diffverf --state five.state --set time.end=5 --set 'time.start=mode 1 0.3' \
    -o a.csv cable.ini
runs 0 'to 8 s' diffverf --set time.end=8 --set 'time.start=mode 1 0.3' -o b.csv cable.ini
runs 0 'from 5 s on' diffverf --set time.start=five.state cable.ini
# The state is that of one step after the last row.
awk -F, 'FNR == NR { v[FNR] = $4; next } FNR > 1 && FNR < 60 {
    e = $4 - v[FNR + 100]; if (e < 0) e = -e; if (!(e < 5e-3)) bad = 1; n++ }
    END { exit bad || n < 50 }' b.csv out
ok $? 'a start from a state goes on with its motion'
runs 2 'a state of another mesh' diffverf --set time.start=run.state cable.ini
says 'is the state of 10 elements; the case has 8' 'is refused'
runs 2 'a start of no meaning' diffverf --set time.start=stopped cable.ini
says 'and there is no such state file' 'is told'

# Fields: node 4 of 8 is the probe in the middle.
runs 0 'a field' diffverf --field field.npy --set time.field_every=0.1 --set 'time.start=mode 1 0.3' \
    -o rows.csv cable.ini
"$top/scripts/npy2csv" field.npy >field.txt
awk -F, 'FNR == NR { if (FNR > 1) { v2[FNR - 2] = $3; v3[FNR - 2] = $4 } next }
    FNR == 14 || FNR == 15 { for (k = 1; k <= NF; k++) { w = FNR == 14 ? v2[2*k - 2] : v3[2*k - 2]
        if ((w - $k)^2 > 1e-24) bad = 1 }; columns = NF }
    END { exit bad || columns != 31 || FNR != 27 }' rows.csv field.txt
ok $? 'holds the rows of the probe at its node'

# Energy: closes to 1e-6 of what goes through, on fine steps; by the square of the step.
for step in 6e-4 6e-5; do
    runs 0 "energy, step $step" diffverf --energy --set time.end=10 --set time.step=$step whirl.ini
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i }
        END { e = $c["energy_error_J"]; t = $c["work_supports_J"]
            if (e < 0) e = -e; if (t < 0) t = -t; print e/t }' out >error-$step
done
awk 'FNR == 1 { e[FILENAME] = $1 } END { exit !(e["error-6e-5"] < 1e-6 &&
    e["error-6e-5"] < e["error-6e-4"]/50) }' error-6e-4 error-6e-5
ok $? "the balance closes: $(cat error-6e-4) and $(cat error-6e-5) of the work of the supports"
runs 2 'energy of terms 1' diffverf --energy --set nonlinear.terms=1 whirl.ini
says 'has no potential' 'is refused'

finish
