#!/bin/sh
# Bad input: status 2, the exact message (tests/cli/golden/messages.txt), nothing written.
# SEILWERK_GOLDEN=write writes the messages anew: look at the difference before you commit it.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
golden=$here/../cli/golden/messages.txt
sed 's/^end = .*/end = 0.05/; s/^elements = .*/elements = 2/' \
    "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini

# said NAME: note the message of the last run under its name.
said()
{
    printf '%s | %s\n' "$1" "$(tr '\n' '~' <err | sed 's/~$//')" >>messages
}

# refuses STATUS NAME COMMAND...
refuses()
{
    refused=$2
    runs "$@"
    said "$refused"
}

# bad NAME LINES: a case made of stay.ini and more lines is refused.
bad()
{
    cp stay.ini bad.ini
    printf "$2" >>bad.ini
    refuses 2 "$1" catenary bad.ini
}

# set NAME ASSIGNMENT [TOOL]
set_()
{
    refuses 2 "$1" "${3:-catenary}" --set "$2" stay.ini
}

# Usage.
refuses 2 'no operand' diffverf
refuses 2 'two operands' catenary stay.ini stay.ini
refuses 2 'unknown option' catenary --nonsense stay.ini
refuses 2 'unknown letter' catenary -x stay.ini
refuses 2 'missing argument' catenary stay.ini -o
refuses 2 'argument where none belongs' catenary --summary=yes stay.ini
refuses 2 'not a whole number' modal --modes 2.5 stay.ini
refuses 2 'number too small' modal --modes 0 stay.ini
refuses 2 'set without value' catenary --set cable.area stay.ini
refuses 2 'set without section' catenary --set area=1 stay.ini

# Files that are none.
refuses 2 'missing file' catenary nothing.ini
refuses 2 'directory' modal .
: >empty.ini
refuses 2 'empty case' catenary empty.ini
printf '# nothing but this\n\n' >comments.ini
refuses 2 'only comments' catenary comments.ini
head -c 4096 /dev/zero >zero.ini
refuses 2 'zero bytes' catenary zero.ini
head -c 100 stay.ini >short.ini
refuses 2 'cut short' catenary short.ini
refuses 2 'the program itself' catenary "$(command -v catenary)"
sed -i '$d' messages # its path and bytes differ from machine to machine

# Form.
bad 'unknown section' '[rope]\nlength = 3\n'
bad 'unknown empty section' '[rope]\n'
bad 'unknown key' '[cable]\ncolour = 3\n'
bad 'key of another section' '[cable]\nspan = 3\n'
bad 'double key' '[cable]\narea = 8.26e-3\n'
bad 'no equals sign' '[mesh]\nlaw hooke\n'
bad 'colon' '[mesh]\nlaw: hooke\n'
bad 'no value' '[mesh]\nlaw =\n'
bad 'open bracket' '[mesh\nlaw = hooke\n'
bad 'text behind the bracket' '[mesh] law = hooke\n'
bad 'no name' '[]\n'
bad 'label where none belongs' '[mesh fine]\nlaw = hooke\n'
bad 'long line' "[mesh]\nlaw = $(printf '%0200d' 1)\n"
printf 'span = 3\n' >bad.ini
refuses 2 'key before any section' catenary bad.ini

# Values.
set_ 'decimal comma' cable.area=1,5
set_ 'too large for a double' cable.area=1e400
set_ 'nan' cable.area=nan
set_ 'infinity' cable.area=inf
set_ 'hexadecimal' cable.area=0x10
set_ 'trailing garbage' cable.area=1m2
set_ 'two numbers' 'cable.area=1 2'
set_ 'out of range' mesh.elements=0
set_ 'absurd' mesh.elements=99999999999999999999
set_ 'half an element' mesh.elements=2.5
set_ 'negative length' cable.unstressed_length=-3
set_ 'no span' supports.span=0
set_ 'unknown word' mesh.law=rubber
set_ 'missing key' cable.unstressed_length=
set_ 'missing mass' cable.mass_per_length=
set_ 'missing span' supports.span=
set_ 'modulus without area' cable.area=
set_ 'both stiffnesses' cable.axial_stiffness=1e9
refuses 2 'slack without gravity' catenary --set gravity.acceleration=0 \
    --set cable.unstressed_length=111 stay.ini
set_ 'a section that no file could hold' 'motion a]b.omega=1'
set_ 'a comment for a label' 'motion #1.omega=1'
set_ 'a comment for a value' 'time.start=#0'
set_ 'two amplitudes' 'motion deck.amplitude=1 2'
set_ 'two phases' 'motion deck.phase=1 2'
set_ 'motion without omega' 'motion deck.omega='
set_ 'motion that --set begins by mistake' motion.omega=3
set_ 'zeta without omega' 'damping.zeta=0.1 0.2'
set_ 'zeta beside alpha' 'damping.omega=1 2'
refuses 2 'damping that feeds' catenary --set damping.alpha= --set damping.beta= \
    --set 'damping.zeta=0.001 0.1' --set 'damping.omega=1 2' stay.ini
set_ 'probe outside' 'time.probes=0.5 1.5' diffverf
set_ 'terms' nonlinear.terms=4 diffverf
set_ 'start' time.start=running diffverf
set_ 'start mode of no number' 'time.start=mode x 1' diffverf
set_ 'scheme' time.scheme=newmark diffverf
set_ 'neither mode nor node' disturbance.time=1 diffverf
refuses 2 'node at a support' diffverf --set disturbance.node=2 \
    --set 'disturbance.amplitude=0 0 1' stay.ini
refuses 2 'three amplitudes of a mode' diffverf --set disturbance.mode=2 \
    --set 'disturbance.amplitude=0 0 1' stay.ini

# Sweeps, steady states, the implicit scheme.  swept NAME ASSIGNMENT...
swept()
{
    name=$1
    shift
    for assignment; do
        shift
        set -- "$@" --set "$assignment"
    done
    refuses 2 "$name" diffverf "$@" stay.ini
}
set_ 'radius' time.radius=0.5 diffverf
set_ 'step tolerance' time.tolerance=1e-5 diffverf
swept 'radius above 1' time.scheme=alpha time.radius=1.1
swept 'tolerance beside a fixed step' time.scheme=alpha time.step=0.01 time.tolerance=1e-5
swept 'a sweep without end' sweep.from=4 sweep.rate=0.1
swept 'a sweep without beginning' sweep.to=4 sweep.rate=0.1
swept 'a sweep that stands still' sweep.from=4 sweep.to=4 sweep.rate=0.1
swept 'a sweep without rate' sweep.from=4 sweep.to=5
swept 'rate and step' sweep.from=4 sweep.to=5 sweep.rate=0.1 sweep.step=0.1
swept 'steps without dwell' sweep.from=4 sweep.to=5 sweep.step=0.1
swept 'a window beyond the dwell' sweep.from=4 sweep.to=5 sweep.step=0.1 sweep.dwell=5 sweep.window=6
swept 'too many steps' sweep.from=4 sweep.to=5 sweep.step=1e-12 sweep.dwell=5
swept 'a seed below zero' sweep.from=4 sweep.to=5 sweep.rate=0.1 sweep.seed=-1
set_ 'one period' steady.periods=1 diffverf
set_ 'no tolerance' steady.tolerance=0 diffverf

# What is given in place of the length, loads, dampers.
sed '/^unstressed_length/d' stay.ini >open.ini
# given NAME STATUS ASSIGNMENT...: of a case without a length.
given()
{
    name=$1
    status=$2
    shift 2
    for assignment; do
        shift
        set -- "$@" --set "$assignment"
    done
    refuses "$status" "$name" catenary "$@" open.ini
}
refuses 2 'no length' catenary open.ini
bad 'a length and a sag' '[cable]\nsag = 0.2\n'
given 'a force and a sag' 2 cable.tension_left=4e6 cable.sag=0.2
given 'two frequencies' 2 cable.fundamental_frequency=1 cable.frequency=1
given 'a mode of no frequency' 2 cable.sag=0.2 cable.mode=2
given 'a plane of no frequency' 2 cable.fundamental_frequency=1 cable.plane=in
given 'a mode beyond the mesh' 2 cable.frequency=1 cable.mode=3
given 'an unknown plane' 2 cable.frequency=1 cable.plane=vertical
given 'an unknown branch' 2 cable.sag=0.2 cable.branch=left
given 'no sag at all' 2 cable.sag=0
given 'a negative force' 2 cable.horizontal_force=-1
set_ 'a branch of a known length' cable.branch=slack
given 'a tension less than any' 1 cable.tension_right=1e4
given 'a tension more than any' 1 cable.tension_left=1e18
given 'a frequency less than any' 1 cable.fundamental_frequency=1e-3
given 'a slacker cable that is none' 1 cable.midspan_tension=1e6 cable.branch=slack
given 'no sag without gravity' 1 cable.sag=0.2 gravity.acceleration=0
set_ 'negative ice' load.ice_mass_per_length=-1
set_ 'a wind of one number' load.wind=3
refuses 2 'wind along the chord without gravity' catenary --set gravity.acceleration=0 \
    --set 'load.wind=1e3 0 0' stay.ini
refuses 2 'an absurd expansion' catenary --set load.temperature_change=100 \
    --set load.expansion_coefficient=0.01 stay.ini
set_ 'damper at no place' damper.coefficient=1
refuses 2 'damper at a support' catenary --set damper.position=1 \
    --set 'damper.direction=0 1 0' --set damper.coefficient=1 stay.ini
refuses 2 'damper of no direction' catenary --set damper.position=0.1 \
    --set 'damper.direction=0 0 0' --set damper.coefficient=1 stay.ini

# Tables.
printf 'name,span,unstressed_length\na,110.5,110.2\n' >table.csv
refuses 2 'table: missing' catenary --table nothing.csv
refuses 2 'table: empty' catenary --table empty.ini
refuses 2 'table: a case' catenary --table stay.ini
refuses 2 'table: two files' catenary --table table.csv table.csv
refuses 2 'table: no key of the model' catenary --table --set time.end=1 table.csv
refuses 2 'table: a wrong default' catenary --table --set cable.area=wide table.csv
refuses 2 'table: printed as a case' catenary --table --print-case table.csv
refuses 2 'table and summary' catenary --table --summary table.csv
refuses 2 'table: over its input' catenary --table -o table.csv table.csv
refuses 1 'table: a row without mass' catenary --table table.csv

# Lifts.
# lift NAME ASSIGNMENT...: of an arrangement that is good without them.
lift()
{
    name=$1
    shift
    for assignment; do
        shift
        set -- "$@" --set "$assignment"
    done
    refuses 2 "lift: $name" sling --set type=primary-secondary --set v_m=3.6 --set s_m=7.5 \
        --set z_m=1.1 --set phi_deg=26 --set gamma_deg=-4 --set m_spreader_t=2 --set m_load_t=60 "$@"
}
runs 0 'lift: the arrangement is good' sling --set type=single --set z_m=1
lift 'no height' v_m=
lift 'a negative height' s_m=-1
lift 'no centre of gravity' z_m=
lift 'nan' z_m=nan
lift 'infinity' z_m=inf
lift 'phi = 0' phi_deg=0
lift 'phi = 90' phi_deg=90
lift 'no phi' phi_deg=
lift 'gamma = 90' gamma_deg=90
lift 'slings that cross' gamma_deg=-20
lift 'a negative spreader' m_spreader_t=-2
lift 'no spreader' m_spreader_t=
lift 'a negative load' m_load_t=-60
lift 'no load' m_load_t=0
lift 'a negative base' base_cross_m=-3
lift 'another base' base_cross_m=4
lift 'another sling' sling_m=6
lift 'an unknown type' type=secondary
lift 'no type' type=
lift 'a type without spreader' type=primary
lift 'an end of no pair' v_1_m=3
lift 'a wrong word' stabilized=perhaps
lift 'a negative tolerance' z_m_tol=-0.1
lift 'an unknown column' colour=red
lift 'nearly a column' gama_deg=3
lift 'no value' v_m
lift 'three hooks' hooks=3
lift 'hooks of unknown distance' hooks=2
lift 'a distance of one hook' hook_distance_m=3
lift 'half an edge' edge_width_m=3
lift 'a negative edge' edge_width_m=-3 edge_height_m=1
lift 'edges that cross' edge_width_m=3 edge_height_m=1 low_edge_width_m=3 low_edge_height_m=2
lift 'a load without width' load_cross_m=0
lift 'strain of secondary slings of 1' strain_secondary=1.5
lift 'half a sling' slings=2.5
lift 'one sling' slings=1
lift 'millimetres' v_m=3600
lift 'kilograms' m_spreader_t=2000
lift 'newtons' wll_kN=300000
lift 'a tolerance of a number' slings_tol=1
refuses 2 'lift: two hooks of primary slings' sling --set type=primary --set z_m=1 --set v_m=3 \
    --set hooks=2 --set hook_distance_m=3
refuses 2 'lift: one hook of elastic slings' sling --set type=primary-elastic --set z_m=1 \
    --set v_m=3 --set base_long_m=6 --set base_cross_m=6 --set strain_wll=0.02 --set hooks=1
refuses 2 'lift: edges of a single sling' sling --set type=single --set z_m=1 \
    --set edge_width_m=3 --set edge_height_m=1
refuses 2 'lift: secondary slings of primary ones' sling --set type=primary --set z_m=1 \
    --set v_m=3 --set phi_deg=30 --set strain_secondary=0.01
refuses 2 'lift: a sling too short' sling --set type=primary --set z_m=1 --set sling_m=3 \
    --set base_long_m=6
refuses 2 'lift: a negative base of a primary sling' sling --set type=primary --set z_m=1 \
    --set v_m=3 --set base_long_m=-6
refuses 2 'lift: phi and base that differ' sling --set type=primary --set z_m=1 --set v_m=3 \
    --set base_long_m=6 --set phi_deg=40
refuses 2 'lift: elastic without hooks' sling --set type=primary-elastic --set z_m=1 --set v_m=3 \
    --set base_long_m=6 --set strain_wll=0.02
refuses 2 'lift: strain of 1' sling --set type=primary-elastic --set z_m=1 --set v_m=3 \
    --set base_long_m=6 --set base_cross_m=6 --set strain_wll=1
refuses 2 'lift: use less than the weight makes' sling --set type=primary-elastic --set z_m=1 \
    --set v_m=3 --set base_long_m=6 --set base_cross_m=6 --set strain_wll=0.02 --set use=0.1 \
    --set m_load_t=60 --set wll_kN=300
refuses 2 'lift: a pair without shares' sling --set type=pair --set z_m=1
refuses 2 'lift: shares that differ' sling --set type=pair --set z_m=1 --set e1_m=1 --set e2_m=2 \
    --set m_load_1_t=10 --set m_load_2_t=10
printf 'type,v_m,z_m,phi_deg\nprimary,6,2,30\nprimary,6,,30\n' >lifts.csv
refuses 2 'lift: missing' sling nothing.csv
refuses 2 'lift: empty' sling empty.ini
refuses 2 'lift: a case' sling stay.ini
refuses 2 'lift: two files' sling lifts.csv lifts.csv
refuses 2 'lift: over its input' sling -o lifts.csv lifts.csv
refuses 1 'lift: a row without z' sling lifts.csv
refuses 2 'lift: a limit that is none' sling --limit high lifts.csv
refuses 2 'lift: a negative limit' sling --limit -1 lifts.csv
refuses 2 'lift: an unknown verdict' sling --require safe lifts.csv
refuses 2 'lift: no verdict as requirement' sling --require not-judged lifts.csv
refuses 2 'lift: no samples' sling --samples 0 lifts.csv
refuses 2 'lift: samples without tolerances' sling --samples 10 lifts.csv
refuses 2 'lift: design of nothing' sling --design v_m lifts.csv
refuses 2 'lift: design of a word' sling --design type=1 lifts.csv
refuses 2 'lift: contour of two rows' sling --contour v_m,z_m lifts.csv
head -n 2 lifts.csv >lift.csv
refuses 2 'lift: contour of one' sling --contour v_m lift.csv
refuses 2 'lift: contour of the same' sling --contour v_m,v_m lift.csv
refuses 2 'lift: contour of no range' sling --contour v_m=1:2,z_m lift.csv
refuses 2 'lift: contour of a word' sling --contour v_m,type lift.csv
refuses 2 'lift: lever and exact' sling --lever --exact lift.csv
printf 'type,s_m,z_m,gamma_deg,v_m,m_spreader_t\nprimary-secondary,3,1,0,3,0\n' >flat.csv
refuses 1 'lift: exact without phi' sling --exact flat.csv
refuses 1 'lift: lever without phi' sling --lever flat.csv
refuses 2 'lift: contour and design' sling --contour v_m,z_m --design v_m=1 lifts.csv

# Wires.
"$top/scripts/wire/arc" wire 1 90 2
# wires NAME FILE SED-SCRIPT: the case with a table that has been edited.
wires()
{
    sed "$3" "wire/$2.csv" >"wire/bad-$2.csv"
    refuses 2 "wires: $1" wirebeam --set "tables.$2=bad-$2.csv" wire/case.ini
}
runs 0 'wires: the arc is good' wirebeam wire/case.ini
refuses 2 'wires: a missing table' wirebeam --set tables.loads=nothing.csv wire/case.ini
refuses 2 'wires: empty' wirebeam empty.ini
refuses 2 'wires: a cable' wirebeam stay.ini
refuses 2 'wires: nan as a tolerance' wirebeam --set solve.tolerance=nan wire/case.ini
refuses 2 'wires: an angle beyond' wirebeam --set solve.largest_angle=90 wire/case.ini
refuses 2 'wires: output is a table' wirebeam -o wire/nodes.csv wire/case.ini
refuses 1 'wires: a file for the directory' wirebeam -d stay.ini wire/case.ini
wires 'a coordinate of nan' nodes '2s/0,0,0/0,nan,0/'
wires 'a coordinate of infinity' nodes '2s/0,0,0/0,inf,0/'
wires 'a coordinate that is missing' nodes '2s/0,0,0/0,,0/'
wires 'a cell too much' nodes '2s/$/,1/'
wires 'a node twice' nodes '3s/^n1/n0/'
wires 'a node without name' nodes '3s/^n1//'
wires 'semicolons' nodes 's/,/;/g'
wires 'no elements' elements '2,$d'
wires 'a negative diameter' sections 's/,0.01/,-0.01/'
wires 'no modulus' sections 's/2.06e11//'
wires 'a negative density' sections 's/7850/-7850/'
wires 'a support of nowhere' supports 's/^n0/n9/'
wires 'a word as support' supports 's/,0,0,0,0,0,0/,fixed,0,0,0,0,0/'
wires 'a load of nowhere' loads 's/^end/end2/'
wires 'a column of springs' loads '1s/fz_N/kz_N_m/'

# Mooring decks; tests/cli/decks.sh has each error of theirs.
cp "$here/../data/decks/moordyn2.txt" deck.txt
head -c 900 deck.txt >cut.txt
refuses 2 'deck: cut short' gapnet cut.txt
sed 's/ OUTPUTS / WINCHES /' deck.txt >section.txt
refuses 2 'deck: an unknown section' gapnet section.txt
printf -- '---- LINES ----\n\0' >zero.txt
refuses 2 'deck: a zero byte' gapnet zero.txt
refuses 2 'deck: --set out of range' gapnet --set environment.water_density=-1 deck.txt
refuses 2 'deck: written over itself' gapnet --write-deck deck.txt deck.txt
refuses 1 'deck: written to nowhere' gapnet --write-deck nowhere/deck.txt deck.txt
refuses 2 'deck: and stiffness to standard output' gapnet --write-deck - --stiffness 6 deck.txt

# Bed, current and bodies; tests/cli/mooring.sh has what does not fit together.
spread=$here/../data/spread
# sea NAME KEY ROW...: a table of these rows in the place of that one.
sea()
{
    name=$1
    key=$2
    shift 2
    printf '%s\n' "$@" >sea.csv
    set -- --set "$key=$scratch/sea.csv"
    [ "$key" != environment.bed ] || set -- "$@" --set environment.depth=
    refuses 2 "sea: $name" gapnet "$@" "$spread/system.ini"
}
flow=z_m,speed_m_s,direction_deg
sea 'a current without a direction' tables.current z_m,speed_m_s 0,1
sea 'a current of no rows' tables.current "$flow"
sea 'a negative speed' tables.current "$flow" 0,1,0 -10,-1,0
sea 'a direction in words' tables.current "$flow" 0,1,north
sea 'a height twice' tables.current "$flow" 0,1,0 0,2,0
sea 'a cell too few' tables.current "$flow" 0,1
grid=x_m,y_m,z_m
sea 'a grid of one line' environment.bed "$grid" 0,0,-80 0,9,-80
sea 'a grid of no points' environment.bed "$grid"
sea 'a depth of nan' environment.bed "$grid" 0,0,-80 0,9,-80 9,0,nan 9,9,-80
sea 'a grid without heights' environment.bed x_m,y_m 0,0
body=body,condition,x_m,y_m,z_m
sea 'a body without a place' tables.bodies "$body" vessel,fixed,0,0,
sea 'a body twice' tables.bodies "$body" vessel,fixed,0,0,0 vessel,fixed,0,0,0
sea 'a body of no name' tables.bodies "$body" ,fixed,0,0,0
sea 'a body of negative mass' tables.bodies "$body,mass_kg" vessel,free,0,0,0,-1
sea 'a body that is held in some directions' tables.bodies "$body" vessel,xy,0,0,0
sea 'an unknown column of bodies' tables.bodies "$body,draft_m" vessel,free,0,0,0,1
sea 'no bodies' tables.bodies "$body"
sea 'a free body that nothing ties' tables.bodies "$body" vessel,fixed,0,0,0 buoy,free,0,0,0
for value in environment.depth=deep environment.bed_slope=0.1 environment.bed_friction=-1 \
    solve.drag=lag environment.bed=nowhere.csv tables.current=nowhere.csv tables.bodies=nowhere.csv; do
    refuses 2 "sea: $value" gapnet --set "$value" "$spread/system.ini"
done

# Outputs.
refuses 1 'below a regular file' catenary -o stay.ini/line.csv stay.ini
refuses 1 'a directory as output' catenary -o . stay.ini
refuses 1 'in no directory' catenary -o nowhere/line.csv stay.ini
refuses 2 'output is the input' catenary -o stay.ini stay.ini
ln stay.ini hard.ini
refuses 2 'output is the input by a hard link' catenary -o hard.ini stay.ini
ln -s stay.ini soft.ini
refuses 2 'output is the input by a soft link' catenary -o soft.ini stay.ini
ln -s nowhere/there dangling.csv
refuses 1 'a link to nowhere' catenary -o dangling.csv stay.ini
runs 2 'output is stdin' sh -c 'catenary -o stay.ini - <stay.ini'
said 'output is stdin'
refuses 1 'model below a regular file' modal -d stay.ini/model stay.ini
refuses 1 'a file for the model directory' modal -d stay.ini stay.ini
modal -d model -o modes.csv stay.ini
refuses 2 'model directory is the input' modal -d model model/case.ini
refuses 2 'one file written twice' modal -d model -o model/omega.npy stay.ini
cmp -s stay.ini hard.ini && [ -z "$(find . -name '*.part')" ]
ok $? 'inputs are as they were, and nothing is left'

# Closed streams.
runs 2 'closed stdin' sh -c 'catenary - <&-'
said 'closed stdin'
runs 1 'closed stdout' sh -c 'catenary stay.ini >&- 2>err'
said 'closed stdout'
sh -c 'catenary nothing.ini 2>&-'
[ $? -eq 2 ]
ok $? 'closed stderr: the status tells'
sh -c 'catenary -o line.csv stay.ini <&- >&- 2>&-'
[ $? -eq 0 ] && [ "$(wc -l <line.csv)" -eq 4 ]
ok $? 'all closed: the file is written'

# Model directories.
runs 0 'the model directory is good' diffverf -d model -o response.csv stay.ini
refuses 2 'no model directory' diffverf -d nowhere -o response.csv stay.ini
refuses 2 'model of another case' diffverf -d model --set cable.mass_per_length=65 stay.ini
refuses 2 'model of another mesh' diffverf -d model --set mesh.elements=3 stay.ini
refuses 2 'model of another law' diffverf -d model --set mesh.law=thesis stay.ini
modal -d other -o modes.csv --set mesh.elements=3 stay.ini
modal -d heavier -o modes.csv --set cable.mass_per_length=65 stay.ini
for file in mass stiffness_support omega modes static; do
    cp -r model mixed
    cp other/$file.npy mixed/$file.npy
    refuses 2 "mixed: $file of another mesh" diffverf -d mixed stay.ini
    rm -r mixed
done
for file in mass mass_reaction omega modes; do
    cp -r model mixed
    cp heavier/$file.npy mixed/$file.npy
    runs 2 "mixed: $file of another mass" diffverf -d mixed stay.ini
    rm -r mixed
done
cp -r model torn
wrong=
tried=0
header=$(seq 0 127)
[ -z "${SEILWERK_SANITIZED:-}" ] || header='0 1 5 6 7 8 9 10 11 40 77 100 126 127' # slower then
for path in model/*.npy; do
    size=$(wc -c <"$path")
    for cut in $header 128 129 135 136 $((size - 1)) $((size - 8)); do
        [ "$cut" -lt "$size" ] || continue
        head -c "$cut" "$path" >"torn/${path#model/}"
        diffverf -d torn -o torn.csv stay.ini 2>err
        status=$?
        [ $status -eq 2 ] && grep -q 'torn/.*: ' err && [ ! -e torn.csv ] ||
            wrong="$wrong $path:$cut"
        tried=$((tried + 1))
    done
    cp "$path" torn/
done
[ -z "$wrong" ] || echo "# $wrong"
[ -z "$wrong" ] && [ $tried -gt 150 ]
ok $? "model directories with a file cut short are refused ($tried places)"
head -c 128 model/mass.npy >torn/mass.npy
head -c 1152 /dev/zero | tr '\0' '\377' >>torn/mass.npy # NaN
refuses 2 'a matrix of NaN' diffverf -d torn stay.ini
cp model/mass.npy torn/

# poke FILE INDEX NUMBER: set an entry, counted from 0 in the order of the file, in model directory
# torn; the original stays in model.
poke()
{
    perl -e '
        my ($path, $i, $x) = @ARGV;
        open my $file, "+<:raw", $path or exit 1;
        seek $file, 128 + 8 * $i, 0;
        print $file pack "d<", $x' "torn/$1.npy" "$2" "$3"
}

for file in mass stiffness mass_support stiffness_support mass_reaction stiffness_reaction dofs \
    static omega modes; do
    poke $file 0 nan
    refuses 2 "one NaN in $file" diffverf -d torn stay.ini
    cp model/$file.npy torn/
done
modal -d model -o modes.csv stay.ini
omega=$(awk -F, 'NR == 2 { print $2 }' modes.csv)
for factor in 1.00001 -1 0; do
    poke omega 0 "$(awk -v x="$omega" -v f=$factor 'BEGIN { printf "%.17g", x * f }')"
    refuses 2 "first frequency times $factor" diffverf -d torn stay.ini
done
cp model/omega.npy torn/
poke modes 3 1e-3
refuses 2 'an entry of a mode' diffverf -d torn stay.ini
cp model/modes.npy torn/
poke dofs 1 4
refuses 2 'another order of unknowns' diffverf -d torn stay.ini
cp model/dofs.npy torn/
runs 0 'as it was, it is good again' diffverf -d torn -o response.csv stay.ini

sed "s|$scratch|.|g; s|$here/../data/|data/|g" messages >seen
[ "${SEILWERK_GOLDEN:-}" != write ] || cp seen "$golden"
diff "$golden" seen | sed 's/^/# /'
cmp -s "$golden" seen
ok $? 'the messages are those of tests/cli/golden/messages.txt'
finish
