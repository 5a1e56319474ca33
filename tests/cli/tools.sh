#!/bin/sh
# The tools as a user meets them: columns, grids, starts, disturbances, warnings, errors.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
cp "$top/scripts/experiments/ben-ahin/case.ini" stay.ini

for tool in catenary modal diffverf; do
    runs 0 "$tool --help ends well" "$tool" --help
    grep -q "usage: $tool" out
    ok $? "$tool --help prints on stdout"
    runs 0 "$tool --version" "$tool" --version
    grep -q "^$tool (Seilwerk) $(cat "$top/VERSION")$" out
    ok $? "$tool tells its version"
    runs 2 "$tool without operand" "$tool"
    says 'usage:' "$tool without operand prints the usage"
    "$tool" --print-case stay.ini >once.ini
    "$tool" --print-case once.ini >twice.ini
    same once.ini twice.ini "$tool --print-case: the resolved case resolves to itself"
done

runs 0 'catenary' catenary stay.ini
header out theta_m,x1_m,x2_m,tension_N,slope,angle_rad,x3_m 'catenary: columns'
holds 'n == 11 && f[1, 1] == 0 && f[11, 1] == 110.1897 && abs(f[11, 2] - 110.5) < 1e-10' out \
    'catenary: a row for each node, from support to support'
runs 0 'inclined' catenary --set supports.drop=30 --set cable.unstressed_length=120 stay.ini
holds 'abs(f[11, 3] - 30) < 1e-10 && f[1, 5] > f[11, 5]' out \
    'catenary: the right support lies below by drop'

runs 0 'modal' modal stay.ini
header out mode,omega_rad_s,frequency_Hz,period_s,plane,kind,symmetry,damping_ratio 'modal: columns'
holds 'n == 60 && f[1, 5] == "out" && f[2, 5] == "in" && abs(f[1, 2] - 7.82866) < 5e-6 &&
    abs(f[1, 3] * f[1, 4] - 1) < 1e-12' out 'modal: six modes an element, published frequency'
runs 0 'modal --modes' modal --modes 3 stay.ini
holds 'n == 3' out 'modal --modes 3: three rows'
runs 2 'modal --modes beyond the mesh' modal --modes 61 stay.ini
says 'has only 60 modes' 'and says how many there are'

runs 0 'diffverf' diffverf --set time.end=0.9999 --set 'time.probes=0.5 0.25' stay.ini
header out "time_s,v1_1_m,v2_1_m,v3_1_m,tension_1_N,v1_2_m,v2_2_m,v3_2_m,tension_2_N,\
force_left_1_N,force_left_2_N,force_left_3_N,force_right_1_N,force_right_2_N,force_right_3_N" \
    'diffverf: columns of two probes'
holds 'n == 50 && f[1, 1] == 0 && f[50, 1] == 0.98' out 'diffverf: rows up to the end, not beyond'
runs 0 'default interval' diffverf --set time.output_every= --set time.end=1 stay.ini
holds 'abs(f[2, 1] - 2 * 3.14159265358979 / 7.86 / 50) < 1e-14' out \
    'diffverf: a row for each 1/50 of the excitation period'

runs 2 'start rest without ramp' diffverf --set time.start=rest stay.ini
says 'needs a ramp' 'and says what is missing'
runs 0 'start rest with ramp' diffverf --set time.start=rest --set 'motion deck.ramp=2' \
    --set time.end=3 stay.ini
holds 'f[1, 2] == 0 && f[1, 3] == 0 && f[1, 6] < -4.8e6' out 'diffverf: begins on the static line'
runs 0 'start mode' diffverf --set 'time.start=mode 1 0.3' --set 'motion deck.amplitude=0 0 0' \
    --set time.end=0.1 stay.ini
holds 'abs(f[1, 4] - 0.3) < 1e-12 && abs(f[1, 3]) < 1e-9' out \
    'diffverf: mode 1 begins sideways with its amplitude'
runs 2 'start mode beyond the mesh' diffverf --set 'time.start=mode 61 0.3' stay.ini
runs 0 'disturbance by a mode' diffverf --set disturbance.time=0.5 --set disturbance.mode=1 \
    --set disturbance.amplitude=0.02 --set time.end=0.6 stay.ini
holds 'f[25, 4] == 0 && abs(f[26, 4] - 0.02) < 1e-9' out 'diffverf: displaced at its time'
runs 0 'disturbance of a node' diffverf --set disturbance.time=0 --set disturbance.node=5 \
    --set 'disturbance.amplitude=0 0 0.01' --set time.end=0 --set time.end=0.1 stay.ini
holds 'abs(f[1, 4] - 0.01) < 1e-12' out 'diffverf: node displaced'
runs 0 'disturbance of the velocity' diffverf --set disturbance.kind=velocity \
    --set disturbance.mode=1 --set disturbance.amplitude=0.5 --set time.end=0.04 \
    --set time.output_every=0.001 stay.ini
holds 'f[1, 4] == 0 && abs(f[3, 4] / 0.002 - 0.5) < 1e-3' out 'diffverf: velocity kick'

runs 0 'two motions add' diffverf --set 'motion left.support=left' --set 'motion left.omega=7.86' \
    --set 'motion left.amplitude=0.05 0 0' --set time.end=5 stay.ini
holds 'abs(f[1, 2] - 0.05) < 1e-9 && abs(f[200, 3]) < 0.02' out \
    'diffverf: both supports in step carry the cable along, without stretching it'

runs 1 'twice the critical step' diffverf --set time.step=1.32e-3 --set time.output_every=0.132 stay.ini
says 't = 0 s: would diverge: the step of 0.00132 s is longer than the critical 0.00065' \
    'and says time and step'
says 'set time.step = auto' 'and what to change'
runs 1 'stretched by a tenth' diffverf --set 'motion deck.amplitude=-20 0 0' \
    --set 'motion deck.phase=1.5708' --set time.end=2 stay.ini
says 'diverged: the cable is stretched so far that' 'and why it ends'
runs 2 'a mode with nodes at all nodes of the mesh' diffverf --set 'time.start=mode 19 0.01' stay.ini
says 'mode 19 has no displacement at the nodes' 'is refused'
runs 2 'supports that pass each other' diffverf --set 'motion deck.amplitude=-110.5 0 0' stay.ini
says 'leave no static line: span 0 m' 'are told'
runs 0 'an end before the first row' diffverf --set time.end=0.001 stay.ini
says 'only t = 0 is printed' 'is a warning'
runs 0 'a disturbance after the end' diffverf --set disturbance.mode=1 \
    --set disturbance.amplitude=0.1 --set disturbance.time=9 --set time.end=1 stay.ini
says '[disturbance] comes after time.end' 'is a warning'
runs 0 'a motion removed' diffverf --set 'motion deck.amplitude=' --set 'motion deck.omega=' \
    --set 'motion deck.support=' --set time.end=1 --set time.output_every=0.5 stay.ini
holds 'n == 3 && f[3, 3] == 0' out 'diffverf: without a motion nothing moves'
runs 1 'truncated terms at large amplitude' diffverf --set nonlinear.terms=1 \
    --set 'motion deck.amplitude=20 0 0' stay.ini
[ -s err ]
ok $? 'and says why'
runs 0 'a cable that goes slack' diffverf --set 'motion deck.amplitude=0.4 0 0' \
    --set 'motion deck.phase=1.5708' --set time.end=2 stay.ini
says 'slack: the cable would carry compression, first at t = ' 'is reported with time and place'
runs 0 'quiet' diffverf -q --set 'motion deck.amplitude=0.4 0 0' --set 'motion deck.phase=1.5708' \
    --set time.end=2 stay.ini
[ ! -s err ]
ok $? 'diffverf -q: no warning'
runs 2 'no end' diffverf --set time.end= stay.ini
says '[time] end: is missing' 'is named'
runs 2 'absurd number of steps' diffverf --set time.end=1e9 --set time.step=1e-12 stay.ini
says 'more than can be done' 'is refused'

runs 0 'millimetres for metres' catenary --set cable.area=8260 stay.ini
says 'make a density of 0.00785 kg/m3: are the units right?' 'the density is doubted'
runs 0 'gigapascals for pascals' catenary --set cable.youngs_modulus=210 stay.ini
says 'youngs_modulus = 210 Pa: is the unit right?' 'the modulus is doubted'
runs 0 'centimetres for metres' catenary --set supports.span=11050 stay.ini
says 'the cable is stretched by 9.93e+03 %: are the units right?' 'the strain is doubted'
runs 0 'a length of another cable' catenary --set cable.unstressed_length=1101.9 stay.ini
says 'the cable is 9.97 times as long as its chord: are the units right?' 'the length is doubted'
runs 0 'a change of temperature alone' catenary --set load.temperature_change=35 stay.ini
says 'temperature_change does nothing without an expansion_coefficient' 'is told'
runs 0 'per cent for a ratio' modal --set damping.alpha= --set damping.beta= --set 'damping.zeta=2 2' \
    --set 'damping.omega=8 9' stay.ini
says 'damped with a ratio of 2 or more: is zeta in per cent?' 'is doubted'
runs 0 'kN/m2 for Pa' catenary --set cable.youngs_modulus=1.76e8 stay.ini
says 'the cable is stretched by ' 'a strain of more than 5 per cent is doubted'
runs 0 'nothing that moves' diffverf --set 'motion deck.amplitude=' --set 'motion deck.omega=' \
    --set 'motion deck.support=' --set time.end=1 stay.ini
says 'nothing moves this cable' 'is a warning'
runs 2 'list with commas' diffverf --set time.probes=0.25,0.5 stay.ini
says 'blanks separate numbers' 'says how it is written'

modal -d model stay.ini >modes.csv
runs 0 'modes from the directory' diffverf -d model --set disturbance.mode=3 \
    --set disturbance.amplitude=0.1 --set time.end=0.5 -o a.csv stay.ini
runs 0 'modes computed' diffverf --set disturbance.mode=3 --set disturbance.amplitude=0.1 \
    --set time.end=0.5 -o b.csv stay.ini
"$compare" -r 1e-12 -a 1e-12 a.csv b.csv
ok $? 'diffverf: the same with the directory as without'

sh "$top/scripts/check-house" >house
cat house | sed 's/^/# /'
[ ! -s house ]
ok $? 'the rules of the house hold'
finish
