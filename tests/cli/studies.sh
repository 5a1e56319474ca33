#!/bin/sh
# Sweeps, steady states, ensembles and the implicit scheme as a user meets them: options, columns,
# tables of points in any dress, rows that cannot be used, runs that are stopped.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
sed 's/^elements = .*/elements = 4/; /^\[disturbance\]/,/^$/d; s/^end = .*//; s/^output_every.*//' \
    "$top/scripts/experiments/seil2-whirl/case.ini" >rope.ini
printf '[disturbance push]\nmode = 1\namplitude = 0.02\n' >>rope.ini
sweep='--set sweep.from=8.8 --set sweep.to=9.4 --set sweep.rate=0.02'
short='--set time.end=60 --set steady.periods=10 --set steady.tolerance=1e-3'

# What goes together.
refused()
{
    name=$1
    text=$2
    shift 2
    runs 2 "refused: $name" diffverf "$@" rope.ini
    says "$text" 'says why'
    [ ! -s out ]
    ok $? 'prints nothing'
}
echo 'motion deck.omega' >none.csv
refused '--steady --points' 'for steady states already' --steady --points none.csv
for option in --energy '--field f.npy' '--state s'; do
    refused "--steady $option" 'belong to a motion that is printed' --steady $option
    refused "--points $option" 'belong to a motion that is printed' --points none.csv $option
done
refused '--steady --resume' 'keeps no state' --steady --resume
refused '--steady --checkpoint' 'keeps no state' --steady --checkpoint 5
refused '--threads alone' 'belongs to --points' --threads 2
refused '--steady of a sweep' 'has no steady state' --steady $sweep
refused '--points of a sweep' 'has no steady state' --points none.csv $sweep
refused '--energy of a sweep' 'a [sweep] prints orbits' --energy $sweep
refused 'a motion without end' '[time] end: is missing'
refused '--points --resume without -o' 'needs -o FILE' --points none.csv --resume
runs 2 'refused: a case from standard input' sh -c 'diffverf --points none.csv - <rope.ini'
says 'give it as a file' 'says why'

# Columns, as diffverf(1) has them.
orbit=
for p in 1 2; do
    for i in 1 2 3; do
        orbit="$orbit,v${i}_${p}_least_m,v${i}_${p}_greatest_m,v${i}_${p}_amplitude_m"
    done
    for i in 2 3; do
        orbit="$orbit,v${i}_${p}_half_m,v${i}_${p}_first_m,v${i}_${p}_second_m,v${i}_${p}_third_m"
    done
    orbit="$orbit,plane_$p,axes_ratio_$p,half_axis_${p}_m,minor_half_axis_${p}_m,tilt_${p}_deg"
    orbit="$orbit,phase_${p}_deg,tension_${p}_N"
done
state=kind,period_ratio,plane,support_phase,time_s,omega_rad_s,change,slack_time_s
set -- --set 'time.probes=0.5 0.25'
runs 0 'a steady state' diffverf --steady $short "$@" rope.ini
header out "$state$orbit" 'its columns'
awk -F, 'NF != 56' out >odd
[ ! -s odd ] && [ "$(wc -l <out)" -eq 2 ]
ok $? 'one row of as many cells'
runs 0 'a sweep' diffverf $sweep "$@" rope.ini
header out "direction,omega_rad_s,time_s$orbit" 'its columns'
holds 'f[1, 1] == "up" && f[1, 2] > 8.8 && f[n, 2] < 9.4 && f[n, 2] > 9.25 && n == 4' out 'its rows'
runs 0 'an empty table' diffverf --points none.csv "$@" rope.ini
header out "motion deck.omega,$state$orbit" 'has columns'
[ "$(wc -l <out)" -eq 1 ]
ok $? 'and no rows'
for name in $(echo "$state" | tr , ' '); do
    grep -qw "$name" "$top/man/diffverf.1"
    ok $? "diffverf(1) tells of $name"
done

# A sweep without an end of its own; back; in steps: rows of the dwells.
runs 0 'a sweep and back' diffverf $sweep --set sweep.back=yes rope.ini
holds 'f[1, 1] == "up" && f[n, 1] == "down" && abs(f[n, 2] - 8.8) < 0.1 && f[n, 3] > 55' out \
    'goes up, then down'
runs 0 'in steps' diffverf --set sweep.from=9.4 --set sweep.to=8.8 --set sweep.step=0.2 \
    --set sweep.dwell=12 --set sweep.window=4 rope.ini
cut -d, -f1,2 out >rows
printf 'down,%s\n' 9.4 9.2 9 8.8 >wanted
tail -n +2 rows | awk -F, '{ printf "%s,%.15g\n", $1, $2 }' >printed
same wanted printed 'a row for each frequency'
runs 0 'a sweep cut by time.end' diffverf $sweep --set time.end=15 rope.ini
holds 'f[n, 3] < 15 && n >= 1' out 'ends there'
says 'time.end = 15 s comes before the end of the sweep at ' 'is told'
runs 0 'without seed' diffverf $sweep --set sweep.seed=0 --set 'disturbance push.mode=' \
    --set 'disturbance push.amplitude=' rope.ini
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "v3_1_greatest_m") c = i; next }
    $c != 0 { bad = 1 } END { exit bad }' out
ok $? 'a motion in the plane stays there'

# The kinds: before a block is whole, where nothing moves, where all dies.
runs 0 'too short for a block' diffverf --steady --set time.end=3 rope.ini
says 'no steady state until t = ' 'is told'
holds 'f[1, 1] == "none" && f[1, 3] == "" && f[1, 7] == "" && f[1, 9] == "" && f[1, 32] == ""' out \
    'has empty cells, not zeros'
runs 0 'free vibration dies' diffverf --steady --set 'motion deck.amplitude=' --set \
    'motion deck.omega=' --set 'motion deck.support=' --set time.end=400 rope.ini
holds 'f[1, 1] == "decayed" && f[1, 2] == ""' out 'decayed, no ratio of periods'
runs 0 'a steady state in the plane' diffverf --steady $short --set 'motion deck.omega=7' \
    --set time.end=200 rope.ini
holds 'f[1, 1] == "periodic" && f[1, 2] == "1:1" && f[1, 3] == "in" && f[1, 4] == "in-phase"' out \
    'periodic 1:1, in the plane'
runs 2 'a record has no steady state' diffverf --steady --set motion.file=x.csv rope.ini
awk 'BEGIN { print "time_s,u1_m,u2_m,u3_m"; for (i = 0; i < 9; i++) print i ",0,0,0" }' >x.csv
runs 2 'a record has no steady state' diffverf --steady --set motion.file=x.csv rope.ini
says 'has no period to compare' 'says why'
runs 2 'two frequencies without a common period' diffverf --steady \
    --set 'motion b.amplitude=0 0.01 0' --set motion\ b.omega=12.3 rope.ini
says 'is no multiple of the lowest frequency' 'says why'

# Points from a file, from standard input, with names that need quotes, in any dress.
cat >points.csv <<END
name,motion deck.omega,motion deck.amplitude,damping.beta,time.scheme
plain,9.1,,,
"with, comma",9.2,0.04 0 0,,
"with ""quotes""",9.3,0.045 0 0,0,
implicit,9.1,,,alpha
coarse,9.15,0.03 0 0,,
END
runs 0 'points' diffverf $short --points points.csv -o points.out rope.ini
awk -F, 'NR == 1' points.out | cut -d, -f1-6 >head.out
echo 'name,motion deck.omega,motion deck.amplitude,damping.beta,time.scheme,kind' >wanted
same wanted head.out 'their columns come first'
grep -q '^"with, comma",9.2,0.04 0 0,,,[a-z]' points.out && grep -q '^"with ""quotes""",9.3,' points.out
ok $? 'cells are quoted where they must be'
runs 0 'from standard input' sh -c 'diffverf "$@" --points - rope.ini <points.csv' sh $short
same points.out out 'gives the same'
{ printf '\357\273\277'; sed 's/$/\r/' points.csv; } >dos.csv
runs 0 'CR LF and a byte order mark' diffverf $short --points dos.csv rope.ini
same points.out out 'give the same'
printf 'name,damping.beta\n,\n,0\n' >bare.csv
runs 0 'a point of empty cells' diffverf $short --points bare.csv rope.ini
[ "$(wc -l <out)" -eq 3 ]
ok $? 'is the case as it is'
tr , ';' <points.csv >semicolon.csv
runs 2 'semicolons' diffverf --points semicolon.csv rope.ini
says 'semicolon' 'are named'
for threads in 1 2 3; do
    runs 0 "on $threads threads" diffverf $short --threads $threads --points points.csv rope.ini
    same points.out out 'the same bytes'
done
{ head -n 1 points.csv; tail -n +2 points.csv | tac; } >turned.csv
runs 0 'in another order' diffverf $short --points turned.csv rope.ini
{ head -n 1 points.out; tail -n +2 points.out | tac; } >wanted
same wanted out 'the same rows'
# More points than lanes, so that lanes are used again: the same as in two tables.
awk 'BEGIN { print "motion deck.omega"; for (i = 0; i < 21; i++) print 8.9 + 0.02*i }' >many.csv
{ head -n 1 many.csv; tail -n 12 many.csv; } >last.csv
runs 0 '21 points' diffverf $short --points many.csv rope.ini
tail -n 12 out >wanted
runs 0 'the last twelve alone' diffverf $short --points last.csv rope.ini
tail -n 12 out >alone
same wanted alone 'in other lanes, the same bytes'

# Rows that cannot be used cost only themselves.
cat >bad.csv <<END
name,motion deck.omega,time.step
good,9.1,
letter,x,
short,9
far,1e10,
diverges,9.1,0.0100
good,9.1,
END
runs 1 'bad rows' diffverf $short --set nonlinear.terms=3 --points bad.csv rope.ini
sed 's/^diffverf: //' err >said
cat >wanted <<END
bad.csv:3: motion deck.omega: 'x': not a number
bad.csv:4: 2 cells; the header has 3
END
head -n 2 said >two
same wanted two 'each is told with its line'
grep -q '^bad.csv:5: motion deck.omega: 1' said && grep -q '^bad.csv:6: t = 0 s: would diverge' said
ok $? 'the others, too'
awk -F, '{ print NF, $4 }' out >cells
printf '%s\n' '35 kind' '35 KIND' '35 ' '35 ' '35 ' '35 ' '35 KIND' >wanted
sed -i 's/ \(none\|periodic\)$/ KIND/' cells
same wanted cells 'their result cells are empty, the rest goes on'
[ "$(sed -n 2p out)" = "$(sed -n 7p out)" ]
ok $? 'equal points have equal rows'
# One that diverges on its way, in a lane beside others.
printf 'name,motion deck.amplitude\na,0.05 0 0\nb,60 0 0\nc,0.05 0 0\n' >tear.csv
runs 1 'a point that is torn' diffverf $short --points tear.csv rope.ini
says 'tear.csv:3: ' 'is told with its line'
says 'diverged' 'and why'
[ "$(sed -n 2p out | cut -d, -f3-)" = "$(sed -n 4p out | cut -d, -f3-)" ] &&
    sed -n 3p out | grep -qE '^b,60 0 0,+$'
ok $? 'costs only itself'
# columns NAME HEADER: refused as a whole.
columns()
{
    printf '%s\n' "$2" >columns.csv
    runs 2 "$1" diffverf --points columns.csv rope.ini
    says "columns.csv:1: $3" 'is told'
}
columns 'a key of the model' cable.area "column 1: 'cable.area' belongs to the model"
columns 'a key of the mesh' name,mesh.elements "column 2: 'mesh.elements' belongs to the model"
columns 'a key of the sweep' sweep.from "column 1: 'sweep.from' cannot vary"
columns 'other probes' time.probes "column 1: 'time.probes' cannot vary"
columns 'no key' motion.colour "column 1: 'motion.colour' is no key"
columns 'no section' omega "column 1: 'omega': expected SECTION.KEY"
columns 'one twice' damping.alpha,damping.alpha 'columns 1 and 2 are both'
runs 2 'no table' diffverf --points nothing.csv rope.ini
runs 2 'an empty file' diffverf --points /dev/null rope.ini
cp points.csv own.csv
runs 2 'a result over the points' diffverf --points own.csv -o own.csv rope.ini
same points.csv own.csv 'is refused'

# Stopped in mid-run and resumed: the same bytes.  stops NAME FILE ARGUMENT...
stops()
{
    what=$1
    file=$2
    shift 2
    runs 0 "$what: a whole run" diffverf "$@" -o "whole-$file" rope.ini
    again=
    stopped=0
    for delay in 0.15 0.3 0.2; do
        diffverf "$@" -o "$file" $again rope.ini 2>err &
        pid=$!
        sleep $delay
        kill -s TERM $pid 2>kill.err
        wait $pid 2>wait.err
        [ $? -ne 143 ] || stopped=$((stopped + 1))
        [ ! -e "$file.state" ] || again=--resume
    done
    [ $stopped -gt 0 ] && [ ! -e "$file" ]
    ok $? "$what: was stopped $stopped times"
    runs 0 "$what: resumed" diffverf "$@" -o "$file" --resume rope.ini
    same "whole-$file" "$file" "$what: the same bytes"
    [ ! -e "$file.state" ] && [ ! -e "$file.part" ]
    ok $? "$what: nothing else is left"
}
stops 'a sweep' up.csv --set sweep.from=4 --set sweep.to=5.3 --set sweep.rate=2e-4 \
    --set sweep.back=yes
stops 'an implicit sweep' alpha.csv --set sweep.from=4 --set sweep.to=5.3 --set sweep.rate=5e-4 \
    --set sweep.back=yes --set time.scheme=alpha
stops 'an implicit motion' motion.csv --set time.end=3000 --set time.scheme=alpha
awk 'BEGIN { print "motion deck.omega"; for (i = 0; i < 700; i++) print 8.5 + 0.001*i }' >long.csv
stops 'points' table.csv --threads 2 --points long.csv --set time.end=200 \
    --set steady.tolerance=1e-12
diffverf --points long.csv --set time.end=100 -o table.csv rope.ini 2>err &
pid=$!
sleep 0.3
kill -s TERM $pid
wait $pid 2>wait.err
says '--resume goes on from table.csv.state' 'a stopped ensemble says how to go on'
echo 9.9 >>long.csv
runs 2 'with another point' diffverf --points long.csv --set time.end=100 -o table.csv --resume rope.ini
says 'is the state of another case' 'it does not go on'

# Where a point failed before the stop, the resumed run remembers.
{ printf 'motion deck.omega\nx\n'; tail -n +2 long.csv; } >failing.csv
diffverf -q --points failing.csv --set time.end=100 -o failing.out rope.ini 2>err &
pid=$!
sleep 0.5
kill -s TERM $pid
wait $pid 2>wait.err
runs 1 'a point that failed before the stop' diffverf --points failing.csv --set time.end=100 \
    --resume -o failing.out rope.ini

# Full disks, closed pipes.
for study in "$sweep" "--steady $short" "--points many.csv $short" "--set time.scheme=alpha $short"; do
    runs 1 "to a full disk: $study" diffverf -q $study -o /dev/full rope.ini
    says 'No space left on device' 'is told'
    { diffverf -q $study rope.ini 2>err; echo $? >status; } | true
    [ ! -s err ] && { [ "$(cat status)" -eq 0 ] || [ "$(cat status)" -eq 141 ]; }
    ok $? 'into a closed pipe: ends quietly'
done

# Keys that belong to another scheme, what cannot be swept.
runs 2 'a radius of central differences' diffverf --set time.radius=0.5 --set time.end=1 rope.ini
says 'belongs to scheme = alpha' 'is refused'
runs 2 'nothing to sweep' diffverf $sweep --set 'motion deck.amplitude=' \
    --set 'motion deck.omega=' --set 'motion deck.support=' rope.ini
says 'no harmonic [motion] or [force] to sweep' 'is told'
runs 2 'a sweep that never ends' diffverf --set sweep.from=4 --set sweep.to=6 \
    --set sweep.rate=1e-12 --set time.end= --set time.step=1e-5 rope.ini
says 'more than can be done' 'is told'
# From rest, nothing moving until a push: the implicit step has no scale before.
runs 0 'an implicit step at rest' diffverf --set time.scheme=alpha --set 'motion deck.amplitude=' \
    --set 'motion deck.omega=' --set 'motion deck.support=' --set 'disturbance push.time=2' \
    --set time.end=4 rope.ini
holds 'f[1, 4] == 0 && (f[n, 4] > 1e-4 || f[n, 4] < -1e-4)' out 'then moves'

finish
