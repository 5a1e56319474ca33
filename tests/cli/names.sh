#!/bin/sh
# Scripts where files and directories have names with blanks, quotes, newlines and what a shell would
# expand; and names that begin with a dash.  A table of all scripts: each runs in such a directory.
. "$(dirname "$0")/../tap.sh"
[ -z "${SEILWERK_SANITIZED:-}" ] || {
    skip 'not under the sanitizers: the tools are those of the other tests'
    finish
}
nasty="it's a \"name\" of
two lines, \$(touch hit) \`touch hit\` %s \\n {x} [y] *"
scripts=$top/scripts
mkdir "$scratch/$nasty"
cd "$scratch/$nasty" || exit 1
TMPDIR=$scratch
export TMPDIR

# Inputs, each made by the tools or as short as its script accepts it; FILE has a nasty name, too.
cp "$scripts/experiments/ben-ahin/case.ini" "stay $nasty.ini"
cp "$scripts/experiments/seil2-whirl/case.ini" "rope $nasty.ini"
cp "$scripts/experiments/lifts/cases.csv" "lifts $nasty.csv"
stay="stay $nasty.ini"
rope="rope $nasty.ini"
catenary -o "line $nasty.csv" "$stay"
modal -d "model $nasty" -o "modes $nasty.csv" "$stay"
diffverf -o "response $nasty.csv" --set time.end=3 "$stay"
stabil -q --set stability.ratio_step=0.02 -o "map $nasty.csv" "$rope"
stabil -q --set stability.reference_mode=1 --set stability.ratio_start=0.9 \
    --set stability.ratio_end=1.1 --set stability.ratio_step=0.01 -o "near $nasty.csv" "$rope"
sling -q --contour z_m=0:3:7,gamma_deg=-8:4:7 -o "contour $nasty.csv" - <<'END' || exit 1
type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t
primary-secondary,3.6,7.5,1.1,26,-4,2,60
END
printf 'name,type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t\na,primary-secondary,3.6,7.5,1.1,26,-4,2,60\nb,primary,10,,3,,,,50\n' \
    >"table $nasty.csv"
printf 'frequency_Hz\n1.2\n2.5\n' >"deck $nasty.csv"
printf 'time_s,a\n0,1\n1,2\n2,1\n3,2\n4,1\n5,2\n' >"wave $nasty.csv"
# What a cell of a table says is no command either.
# shellcheck disable=SC2016
printf 'x,y,g\n1,2,`touch hit`"; system("touch hit"); "\n2,3,`touch hit`"; system("touch hit"); "\n' \
    >"groups $nasty.csv"
: >"$scratch/inputs-are-made"

# script NAME ARGUMENT...: it succeeds, and nothing is run that a name or cell says.
script()
{
    script=$1
    shift
    runs 0 "$script" "$scripts/$script" "$@"
}
# draws NAME ARGUMENT...: it makes the picture, as well.
picture="picture $nasty.svg"
draws()
{
    plot=$1
    shift
    echo "$plot" >>"$scratch/drawn"
    rm -f "$picture"
    script "plot/$plot" "$@"
    grep -q '^</svg>' "$picture"
    ok $? "plot/$plot: the picture"
}

script envelope "response $nasty.csv" 7.86
script spectrum "response $nasty.csv" v2_1_m
# shellcheck disable=SC2016
runs 0 orbit sh -c 'exec "$0" 7.86 1 <"$1"' "$scripts/orbit" "response $nasty.csv"
script npy2csv "model $nasty/omega.npy"
script single-cable "$stay" "single $nasty" --set time.end=1 --set mesh.elements=4
script nearest-resonance "deck $nasty.csv" "$stay"
script check-point "$rope" 1 0.05 --set mesh.elements=4
script study --print-table --table "deck $nasty.csv"
runs 1 'study' "$scripts/study" -q -d "study $nasty" --table "deck $nasty.csv" false
runs 0 'study with a tool' "$scripts/study" -q -d "another $nasty" --grid cable.area=8e-3,9e-3 \
    catenary --summary "$stay"
# shellcheck disable=SC2016
mkdir "experiment $nasty" && printf '#!/bin/sh\ncp "$(dirname "$0")/published.csv" "$1/made.csv"\n' \
    >"experiment $nasty/run"
printf '#!/bin/sh\nprintf "quantity,by,computed\\nq,a,2\\n"\n' >"experiment $nasty/computed"
printf 'quantity,unit,published,source,why\nq,m,2,Bild 1,\n' >"experiment $nasty/published.csv"
chmod +x "experiment $nasty/run" "experiment $nasty/computed"
script experiment run "experiment $nasty" "done $nasty"
for generator in "$scripts"/net/* "$scripts"/wire/*; do
    case $generator in
    */steel.sh) continue ;;
    esac
    made="made by ${generator##*/} $nasty"
    runs 0 "${generator#"$scripts/"}" "$generator" "$made"
    [ -f "$made/system.ini" ] || [ -f "$made/case.ini" ]
    ok $? "${generator##*/}: its case"
done
gapnet -q -d "solved $nasty" "made by square $nasty/system.ini"
wirebeam -q -d "bent $nasty" "made by arc $nasty/case.ini"

draws line "line $nasty.csv" "$picture"
draws modes "model $nasty" "$picture"
draws response -c "model $nasty/case.ini" "response $nasty.csv" "$picture"
draws path -c "model $nasty/case.ini" "response $nasty.csv" "$picture"
draws history "response $nasty.csv" "$picture" "title $nasty" v2_1_m,0,3
draws stability "map $nasty.csv" "$picture"
draws stability "map $nasty.csv" "$picture" "title $nasty" "1,0.02,it's"
draws regions "$picture" "title $nasty" panel "name's" 0.1 0.9 1.1 map "near $nasty.csv" 1 fill1 "it's"
draws lift "table $nasty.csv" a "$picture"
draws righting "table $nasty.csv" a "$picture"
draws heights "contour $nasty.csv" "$picture"
draws curves "groups $nasty.csv" x y g "$picture"
draws curves "groups $nasty.csv" x y - "$picture" "$nasty" "$nasty" "$nasty"
draws net "solved $nasty" "$picture"
draws gaps "$picture" "solved $nasty"
draws wire "bent $nasty" "$picture"
draws distribution "response $nasty.csv" v2_1_m "$picture" - time_s

gapnet -q --moves "$top/tests/data/spread/moves.csv" -o "moves $nasty.csv" \
    "$top/tests/data/spread/system.ini"
draws restoring "moves $nasty.csv" "$picture"
# Excerpts of tables of experiments, for the pictures that belong to one.
cp -R "$top/tests/data/plots" "plots $nasty"
for table in "plots $nasty"/*.csv; do
    mv "$table" "${table%.csv} $nasty.csv"
done
from="plots $nasty/"
for experiment in catalogue convergence crossover frequencies; do
    draws $experiment "$from$experiment $nasty.csv" "$picture"
done
mv "${from}damping" "${from}damping $nasty"
draws damping "${from}damping $nasty" "$picture"
draws rope-stiffness "${from}rope-stiffness $nasty.csv" along "$picture"
draws shape-change "${from}shapes $nasty.csv" "${from}slopes $nasty.csv" "$picture"
draws ensemble "${from}states $nasty.csv" "${from}boundary $nasty.csv" "$picture"
draws sweep "${from}up $nasty.csv" "${from}down $nasty.csv" "${from}rest $nasty.csv" "$picture"
draws protocol "${from}up $nasty.csv" "${from}down $nasty.csv" "${from}rest $nasty.csv" \
    "${from}kinds $nasty.csv" 1 a "$picture" "title $nasty"
runs 2 'a limit that is code' "$scripts/plot/distribution" "response $nasty.csv" v2_1_m "$picture" \
    '1; system("touch hit")'
script experiment compare "experiment $nasty" "done $nasty"
script published "experiment $nasty/published.csv" "done $nasty/computed.csv"
if command -v chromium >/dev/null; then
    echo '<p>text' >"page $nasty.html"
    script html2pdf "page $nasty.html" "page $nasty.pdf"
    [ -s "page $nasty.pdf" ]
    ok $? 'html2pdf: the page'
else
    skip 'no chromium'
fi

# Nothing is left out.
for file in "$scripts"/plot/*; do
    case ${file##*/} in *.sh) continue ;; esac
    grep -qx "${file##*/}" "$scratch/drawn" || echo "${file##*/}"
done >"$scratch/left-out"
[ ! -s "$scratch/left-out" ] || sed 's/^/# /' "$scratch/left-out"
[ ! -s "$scratch/left-out" ]
ok $? 'every plot is in the table'

[ -z "$(find "$scratch" -name hit)" ]
ok $? 'nothing was run that a name or a cell says'
[ -z "$(find "$scratch" -mindepth 1 -maxdepth 1 -name 'tmp.*')" ]
ok $? 'no scratch directory is left'

# A dash in front: with ./ it is a name like others; without, it is one, or refused as an option,
# and nothing is written.
cp "line $nasty.csv" ./-line.csv
script plot/line ./-line.csv ./-line.svg
[ -s ./-line.svg ]
ok $? 'plot/line: ./-name'
cp "$stay" ./-stay.ini
script single-cable ./-stay.ini ./-made --set time.end=1 --set mesh.elements=4
for generator in net/square net/mooring wire/ring wire/helix; do
    script $generator ./-generated
    [ -f ./-generated/system.ini ] || [ -f ./-generated/case.ini ]
    ok $? "$generator: ./-name"
    rm -r ./-generated
done
find . | sort >"$scratch/before"
for refused in 'plot/line -none.csv -none.svg' 'plot/modes -model -none.svg' 'envelope -response.csv 3' \
    'spectrum -r v' 'single-cable -stay.ini -none' 'nearest-resonance -deck.csv -stay.ini' \
    'check-point -rope.ini 1 1' 'experiment run -folder -none' 'npy2csv -x.npy' 'net/square -none' \
    'wire/ring -none' 'html2pdf -page.html -none.pdf' 'published -a -b' 'report -a -b' 'demo -none'; do
    # shellcheck disable=SC2086 # words without blanks
    "$scripts"/$refused >"$scratch/out" 2>"$scratch/err" </dev/null
    got=$?
    [ $got -ge 1 ] && [ $got -le 2 ] && [ -s "$scratch/err" ]
    ok $? "$refused: refused, with words"
done
find . | sort >"$scratch/after"
cmp "$scratch/before" "$scratch/after" >&2
ok $? 'and nothing is written'
finish
