#!/bin/sh
# The studies of scripts/experiments: their numbers against closed theory, their pictures, and when
# make runs them again.
. "$(dirname "$0")/../tap.sh"
experiments=$top/scripts/experiments

# column FILE AWK NAME: the awk program passes over all rows; cells by name as c["..."].
column()
{
    awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
        { for (i = 1; i <= NF; i++) c[name[i]] = $i }
        function size(x) { return x < 0 ? -x : x }
        function wrong(text) { if (++bad <= 5) print "# " FILENAME ":" NR ": " text ": " $0 }
        '"$2"'
        END { if (NR < 2 || rows_wanted && rows != rows_wanted) wrong("rows: " rows); exit bad > 0 }
        ' "$1"
    ok $? "$3"
}

# Called wrongly.
for study in crossover shape-change convergence; do
    runs 2 "$study: usage" "$experiments/$study/run"
    says 'usage: run DIR' "$study: says how"
    runs 2 "$study: an option" "$experiments/$study/run" -x
    runs 2 "plot/$study: usage" "$top/scripts/plot/$study"
    says "usage: $study " "plot/$study: says how"
done

# ask OPTION...: make about the table of $study in a tree where nothing is built.
ask()
{
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -C "$top" BUILD="$scratch/made" "$@" "$table"
}

# A study is run when its results are missing, and again when its case, a script or one of its tools
# is newer, but not when only what is said of it has changed.
for study in crossover shape-change convergence; do
    table=$scratch/made/experiments/$study/done
    runs 0 "make $study: no results" ask -n
    for part in bin/modal bin/catenary "run scripts/experiments/$study"; do
        grep -qF "$part" "$scratch/out"
        ok $? "make $study: $part"
    done
    runs 0 "make $study: its rule" ask -np
    grep -F "$table:" "$scratch/out" | tr ' ' '\n' >"$scratch/rule"
    for part in experiments/$study/case.ini experiments/$study/run experiments/begin.sh plot/$study \
        plot/setup.sh experiment; do
        grep -qxF "scripts/$part" "$scratch/rule"
        ok $? "make $study: again when $part is newer"
    done
    ! grep -q about "$scratch/rule"
    ok $? "make $study: not again for its description"
done

if ! command -v gnuplot >/dev/null 2>&1; then
    skip 'no gnuplot here'
    finish
fi

# judge_files NAME FILE...: files of a study; table.txt is what it printed; the picture is one.
judge_files()
{
    study=$1
    shift
    for file in "$@" table.txt; do
        [ -s "$scratch/$study/$file" ]
        ok $? "$study: $file"
    done
    same "$scratch/out" "$scratch/$study/table.txt" "$study: prints its table"
    [ ! -s "$scratch/err" ]
    ok $? "$study: nothing on stderr"
    png "$scratch/$study/$study.png"
    ok $? "$study: the picture"
}

# Theory of small sag against cables that sag: differences go with (sag/span)^2, seen with factors
# up to 11.7 in lambda^2 and 3.9 in frequencies.
runs 0 'crossover' env POINTS=7 "$experiments/crossover/run" "$scratch/crossover"
judge_files crossover frequencies.csv near.csv crossings.csv
column "$scratch/crossover/crossings.csv" '{
    rows++; rows_wanted = 12
    theory = (2*c["i"]*atan2(0, -1))^2
    if (size(c["theory_lambda2"]/theory - 1) > 1e-8) wrong("theory")
    if (size(c["lambda2"]/theory - 1 - c["difference"]) > 1e-8) wrong("difference")
    if (c["span_m"] != "" && !(size(c["difference"]) < 15*c["sag_ratio"]^2)) wrong("not of sag^2")
    if (c["span_m"] == "" && !(size(c["difference"]) < 1e-5)) wrong("not at (2 i pi)^2")
    if (c["span_m"] == "" && !(size(c["sag_ratio"]) == 0)) wrong("sag")
}' 'crossover: crossings at (2 i pi)^2, away from it with the square of the sag'
column "$scratch/crossover/frequencies.csv" '
    c["kind"] == "lateral" { theory = c["number"] }
    c["kind"] == "antisymmetric" { theory = 2*c["number"] }
    c["kind"] != "symmetric" && !(size(c["irvine_ratio"] - theory) < 1e-8) { wrong("theory") }
    c["kind"] == "symmetric" {
        y = c["irvine_ratio"]*atan2(0, -1)/2
        # sin y - (y - 4 y^3/lambda^2) cos y = 0
        cubic = 4*y^3/c["lambda2"]
        if (!(size(sin(y) - (y - cubic)*cos(y)) < 1e-6*cubic)) wrong("root")
        if (!(y > (c["number"] - 0.5)*atan2(0, -1) && y < (c["number"] + 0.5)*atan2(0, -1)))
            wrong("branch")
    }
    {
        rows++; rows_wanted = 84
        if (!(size(c["ratio"]/c["irvine_ratio"] - 1 - c["difference"]) < 1e-8)) wrong("difference")
        if (!(size(c["difference"]) < 5*(c["sag_m"]/c["span_m"])^2)) wrong("far from Irvine")
        if (!(c["sag_m"]/c["span_m"] < 1/30)) wrong("sag")
    }
    ' 'crossover: Irvine by another formula, and computed frequencies beside it'
awk -F, 'NR == 2 { first = $1/0.1 } { last = $1/1000 }
    END { exit !((first - 1)^2 < 1e-10 && (last - 1)^2 < 1e-10) }' "$scratch/crossover/frequencies.csv"
ok $? 'crossover: lambda^2 from 0.1 to 1000'

runs 0 'shape-change' "$experiments/shape-change/run" "$scratch/shape-change"
judge_files shape-change shapes.csv slopes.csv
column "$scratch/shape-change/slopes.csv" '{
    rows++; rows_wanted = 6
    part = c["lambda2"]/(2*atan2(0, -1))^2
    here = size(part - 1) < 1e-5
    if (here && !(size(c["slope"]) < 0.01)) wrong("the slope is not 0") # of 3.1 for a string
    if (!here && part < 1 && !(c["inner_nodes"] == 0 && c["slope"] > 0.5)) wrong("below")
    if (!here && part > 1 && !(c["inner_nodes"] == 2 && c["slope"] < -0.5)) wrong("above")
    if (!here && c["mode"] != (part < 1 ? 2 : 4)) wrong("order of the modes")
    # sag/span is 0.022 at most: theory within ten times its square
    if (!(size(c["slope"] - c["irvine_slope"]) < 5e-3*(1 + size(c["slope"])))) wrong("slope")
    if (!(size(c["tension"]/c["irvine_tension"] - 1) < 5e-3)) wrong("tension")
    if (!(c["tension_spread"] < 0.02*c["tension"])) wrong("tension varies")
}' 'shape-change: no node, tangent to the chord, two nodes; slopes and tension by Irvine'
column "$scratch/shape-change/shapes.csv" '
    { x = c["theta_L0"]; v = c["v2_m"]; rows++ }
    (x == 0 || x == 1) && v != 0 { wrong("moves at the support") }
    size(x - 0.5) < 1e-9 && size(v - 1) > 1e-9 { wrong("not largest in the middle") }
    x <= 0.5 { left[sprintf("%.6f", x)] = v }
    x > 0.5 && size(left[sprintf("%.6f", 1 - x)] - v) > 1e-6 { wrong("not symmetric") }
    ' 'shape-change: symmetric shapes, the middle at 1 m'

runs 0 'convergence' env FINEST=64 "$experiments/convergence/run" "$scratch/convergence"
judge_files convergence frequencies.csv laws.csv
column "$scratch/convergence/frequencies.csv" '{
    rows++; rows_wanted = 108
    # the order that the mesh of 64 shows too high by 1.6 per cent of an error
    if (c["elements"] == 32 && c["mode"] >= 3 && !(c["order"] > 5.7 && c["order"] < 6.2))
        wrong("order")
    if (c["elements"] == 8 && !(c["error"] > 0 && c["error"] < 5e-5 && c["order"] > 4.7))
        wrong("coarse")
    if (c["elements"] == 64 && !(c["error"] == 0)) wrong("finest")
}' 'convergence: order 6 in each law'
column "$scratch/convergence/laws.csv" '{
    rows++; rows_wanted = 6
    if (!(size(c["printed_above_hooke"]/c["printed_theory"] - 1) < 5e-3)) wrong("printed")
    if (!(size(c["thesis_above_hooke"] - c["thesis_theory"]) < 1e-2*c["thesis_theory"] + 1e-8))
        wrong("thesis")
    if (c["mode"] == 2 && !(size(c["thesis_above_hooke"]/2.3e-4 - 1) < 0.02)) wrong("2.3e-4")
}' 'convergence: what the laws differ by'

# No picture of what is no table, or of a run that failed.  (scripts/experiment gives a new directory
# to each run.)
for study in crossover convergence; do
    runs 2 "plot/$study: no table" "$top/scripts/plot/$study" "$experiments/$study/case.ini" \
        "$scratch/none.png"
done
runs 2 'plot/shape-change: no table' "$top/scripts/plot/shape-change" \
    "$experiments/crossover/case.ini" "$scratch/shape-change/slopes.csv" "$scratch/none.png"
[ ! -e "$scratch/none.png" ]
ok $? 'no picture without data'
mkdir "$scratch/bin"
printf '#!/bin/sh\nexit 1\n' >"$scratch/bin/modal"
chmod +x "$scratch/bin/modal"
for study in crossover shape-change convergence; do
    ! PATH=$scratch/bin:$PATH "$experiments/$study/run" "$scratch/failed/$study" >/dev/null 2>&1 &&
        [ ! -e "$scratch/failed/$study/table.txt" ] && [ ! -e "$scratch/failed/$study/$study.png" ]
    ok $? "$study: a failure leaves no table and no picture"
done

finish
