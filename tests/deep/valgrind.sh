#!/bin/sh
# No wrong access and no leak under valgrind: the tools on a small case, the quick unit tests.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
command -v valgrind >/dev/null || {
    skip 'valgrind is not installed'
    finish
}
sed 's/^end = .*/end = 0.5/; s/^elements = .*/elements = 3/' \
    "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini

# OpenBLAS keeps its buffers to the end: reachable memory is no leak.
checked()
{
    valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,possible "$@"
}

runs 0 catenary checked catenary stay.ini
runs 0 'catenary --summary' checked catenary --summary -o summary.csv stay.ini
runs 0 'modal -d' checked modal -d model -o modes.csv stay.ini
runs 0 'diffverf -d' checked diffverf -d model --set disturbance.mode=1 \
    --set disturbance.amplitude=0.01 -o response.csv stay.ini
printf 'span,mass_per_length,axial_stiffness,sag\n100,2,1e6,3\n100,2,1e6,x\n' >table.csv
runs 1 'catenary --table' checked catenary --table table.csv
runs 0 sling checked sling -o lifts.csv "$top/scripts/experiments/lifts/cases.csv"
printf 'type,v_m,z_m,z_m_tol,phi_deg\nprimary,6,2,0.2,30\nprimary,x,2,0.2,30\n' >lifts.csv
runs 1 'sling, everything' checked sling --samples 10 --derivatives --design v_m=3 lifts.csv
runs 0 'catenary, wind and a tension' checked catenary --set cable.unstressed_length= \
    --set cable.tension_left=5e6 --set 'load.wind=0 0 50' stay.ini
runs 0 'modal, lanczos' checked modal --solver lanczos --modes 3 --irvine --participation \
    --set mesh.elements=10 stay.ini
damper='--set damper.position=0.1 --set damper.coefficient=1e5'
runs 0 'modal --damped' checked modal --damped --modes 3 $damper \
    --set 'damper.direction=0 1 1' stay.ini
runs 0 'modal --shapes' checked modal --shapes 1,2 stay.ini
runs 0 'diffverf, everything' checked diffverf --energy --field field.npy --state run.state $damper \
    --set 'damper.direction=0 1 1' --set 'wind.speed=0 0 9' --set wind.drag_coefficient=1 \
    --set wind.diameter=0.1 --set force.position=all --set 'force.value=0 1 0' -o all.csv stay.ini
runs 0 'diffverf --resume' checked diffverf --energy --field field.npy --state run.state --resume \
    $damper --set 'damper.direction=0 1 1' --set 'wind.speed=0 0 9' --set wind.drag_coefficient=1 \
    --set wind.diameter=0.1 --set force.position=all --set 'force.value=0 1 0' --set time.end=0.6 \
    -o all.csv stay.ini
runs 0 'diffverf, a sweep' checked diffverf --set sweep.from=8 --set sweep.to=9 --set sweep.rate=2 \
    --set time.end= -o sweep.csv stay.ini
runs 0 'diffverf --steady, implicit' checked diffverf -q --steady --set time.scheme=alpha \
    --set steady.periods=2 --set time.end=3 stay.ini
printf 'motion deck.omega,damping.beta,time.scheme\n7.8,,\n7.9,0,\nx,,\n7.9,,alpha\n' >points.csv
# one thread: what libgomp keeps for others is possibly lost
runs 1 'diffverf --points' checked diffverf -q --threads 1 --points points.csv \
    --set steady.periods=2 --set time.end=2 stay.ini
runs 0 'stabil' checked stabil --change --set stability.ratio_step=0.2 stay.ini
runs 0 'stabil, floquet' checked stabil --growth --set stability.method=floquet \
    --set stability.ratio_step=0.4 --set stability.amplitude_step=0.05 stay.ini
spread=$here/../data/spread
runs 0 'gapnet, a bed' checked gapnet -d bed --stiffness body --move 3,1,0,0,0,0.02 \
    "$spread/system.ini"
runs 0 'gapcheck' checked gapcheck bed
runs 0 'gapnet, current and a free body' checked gapnet -d flow --set solve.elements=2 \
    --set tables.current=current.csv --set tables.bodies=afloat.csv "$spread/system.ini"
runs 0 'gapnet, a grid, drag held' checked gapnet -d grid --set solve.elements=2 --set solve.drag=hold \
    --set tables.current=current.csv --set environment.depth= --set environment.bed=bed.csv \
    "$spread/system.ini"
runs 0 'gapnet --moves' checked gapnet --body vessel --moves "$spread/moves.csv" --set tables.bodies=two.csv \
    "$spread/system.ini"
runs 0 'gapnet --pretension' checked gapnet --pretension 1=6e5 --pretension 2=6e5 --by anchor \
    "$spread/system.ini"
printf 'dz_m\n0\n-75\nx\n' >sunk.csv
runs 2 'gapnet, moves that cannot be' checked gapnet --moves sunk.csv "$spread/system.ini"
runs 0 'print-case' checked diffverf --print-case stay.ini
runs 0 'wire' "$top/scripts/wire/arc" wire 1 90 2
printf 'spring,node_a,kx_N_m\n1,end,5\n' >wire/springs.csv
runs 0 wirebeam checked wirebeam --set tables.springs=springs.csv --modes 2 --stresses -d solved wire/case.ini
runs 0 'wirebeam, arc length' checked wirebeam -q --set solve.path=arc --set solve.most_steps=2 wire/case.ini
runs 0 'wirebeam, linear, divided' checked wirebeam --method linear --set solve.largest_angle=10 wire/case.ini
runs 1 'wirebeam, updated' checked wirebeam --method updated wire/case.ini
runs 2 'wirebeam, a bad table' checked wirebeam --set tables.supports=nodes.csv wire/case.ini
runs 2 'a bad case' checked diffverf --set cable.area=x stay.ini

cd "$top" || exit 1
for test in "$SEILWERK_BUILD"/tests/*_test; do
    case ${test##*/} in # long ones: they run under the sanitizers
    line_test | march_test | chain_test | number_test | find_test | lanczos_test | load_test | \
        backbone_test | doubt_test | damper_test | bolotin_test | floquet_test | forcing_test | \
        frame_test | follow_test | netsea_test) continue ;;
    esac
    runs 0 "$(basename "$test")" checked "$test"
done
finish
