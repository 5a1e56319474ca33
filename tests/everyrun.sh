# Sourced by the tests of faults after tap.sh, in the scratch directory: small inputs, runs of each tool
# on them, and the preloaded library that lets one call of such a run fail.
# shellcheck shell=sh disable=SC2154 # tap.sh comes before
sed 's/^end = .*/end = 0.1/; s/^elements = .*/elements = 2/' \
    "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini
faults=$SEILWERK_BUILD/tests/faults.so
modal -d whole -o whole.csv stay.ini
cat >table.csv <<END
name,span,mass_per_length,axial_stiffness,sag,frequency,elements
a,100,2,1e7,3,,
"b, 2",100,2,1e7,,1.1,2
END

cp "$top/scripts/experiments/lifts/cases.csv" lifts.csv
cp -r "$top/scripts/experiments/nets/mooring" net
cp "$here/../data/decks/moordyn2.txt" deck.txt
printf 'tension\nstrain tension\n(-) (N)\n0 0\n0.01 4e5\n0.1 4e6\n' >tension.dat
sed 's/^wire .*/&\nspare 0.1 20 tension.dat -1 1 0 1 0/; s/^80 .*/&\n1 Currents/' \
    "$here/../data/decks/moordyn1.txt" >table.txt
cp -r "$here/../data/spread" spread
printf 'dx_m\n1\n' >move.csv
head -n 2 spread/ropes.csv >spread/one.csv
gapnet -d solved --rope chain --set solve.elements=2 net/system.ini
"$top/scripts/wire/arc" wire 1 90 2
printf 'element,qz_N_m\ne1,3\n' >wire/loads.csv
printf 'spring,node_a,kx_N_m\n1,end,5\n' >wire/springs.csv
printf 'type,v_m,z_m,z_m_tol,phi_deg\nprimary,6,2,0.2,30\n' >lift.csv
cat >points.csv <<END
name,motion deck.omega,damping.beta,time.scheme
a,7.8,,
"b, 2",7.9,0,
c,7.9,,alpha
END

# Runs of each tool on the small case, results in ./result.
run()
{
    case $1 in
    catenary) catenary -o result/out.csv stay.ini ;;
    modal) modal -d result/model -o result/out.csv stay.ini ;;
    diffverf) diffverf -d whole -o result/out.csv --set disturbance.mode=1 \
        --set disturbance.amplitude=0.01 stay.ini ;;
    sweep) diffverf -o result/out.csv --set sweep.from=8 --set sweep.to=9 --set sweep.rate=1 \
        --set time.end= --set time.scheme=alpha stay.ini ;;
    steady) diffverf -d whole -q --steady -o result/out.csv --set steady.periods=2 \
        --set time.end=3 --set disturbance.mode=1 --set disturbance.amplitude=0.01 stay.ini ;;
    points) diffverf -d whole -q --threads 1 --points points.csv -o result/out.csv \
        --set steady.periods=2 --set time.end=2 --set disturbance.mode=1 \
        --set disturbance.amplitude=0.01 stay.ini ;;
    stabil) stabil -d whole -q --threads 1 -o result/out.csv --set 'stability.modes=1 2' \
        --set stability.harmonics=3 --set stability.ratio_start=0.9 --set stability.ratio_end=1 \
        --set stability.ratio_step=0.1 stay.ini ;;
    floquet) stabil -q --threads 1 -o result/out.csv --set stability.method=floquet \
        --set stability.modes=1 --set stability.ratio_start=1 --set stability.ratio_end=1 \
        --set stability.amplitude_step=0.5 stay.ini ;;
    print) catenary --print-case -o result/out.csv stay.ini ;;
    sling) sling -o result/out.csv --set name=x lifts.csv ;;
    lift) sling -o result/out.csv --samples 10 --derivatives --design v_m=3 lift.csv ;;
    exact) sling -o result/out.csv --exact lift.csv ;;
    lever) sling -o result/out.csv --lever lift.csv ;;
    contour) sling -o result/out.csv --contour z_m=0:1:3,v_m=3:5:3 lift.csv ;;
    gapnet) gapnet -o result/out.csv --rope chain --stiffness B1 net/system.ini ;;
    gapnodes) gapnet -o result/out.csv --verify --set solve.elements=2 --rope chain net/system.ini ;;
    gapdeck) gapnet -q -o result/out.csv table.txt ;;
    writedeck) gapnet -o result/nodes.csv --write-deck result/out.csv deck.txt ;;
    seamoves) gapnet -q -o result/out.csv --set solve.elements=1 --set environment.bed_friction=0 \
        --set tables.current=current.csv --set tables.bodies=two.csv --set tables.ropes=one.csv \
        --body vessel --moves move.csv spread/system.ini ;;
    seabed) gapnet -q -d result/all --set environment.depth= --set environment.bed=bed.csv \
        --set solve.elements=2 spread/system.ini && cp result/all/bodies.csv result/out.csv ;;
    pretension) gapnet -q -o result/out.csv --pretension 1=5e5 --pretension 2=4.5e5 --by anchor \
        --stiffness body spread/system.ini ;;
    gapcheck) gapcheck -o result/out.csv solved ;;
    wire) wirebeam -o result/out.csv --set tables.springs=springs.csv --set solve.steps=1 \
        --set solve.largest_angle=15 wire/case.ini ;;
    wirearc) wirebeam -q -o result/out.csv --set solve.path=arc --set solve.most_steps=2 wire/case.ini ;;
    wiremodes) # BLAS' last digits depend on where memory lies; awk and cp are not on trial
        wirebeam -o result/out.csv --modes 2 --set solve.steps=1 wire/case.ini && (
            unset LD_PRELOAD
            awk -F, 'NR > 1 { $0 = sprintf("%d,%.4g", $1, $2) } { print }' result/out.csv >rounded &&
                cp rounded result/out.csv
        ) ;;
    wirelinear) wirebeam -q -o result/out.csv --method linear --stresses wire/case.ini ;;
    updated) wirebeam -q -o result/out.csv --method updated --set solve.steps=2 --set tables.loads= \
        --set 'gravity.acceleration=0 0 1e-5' wire/case.ini ;;
    table) catenary --table -o result/out.csv table.csv ;;
    stiffness) catenary --stiffness -o result/out.csv --set cable.unstressed_length= \
        --set cable.fundamental_frequency=1.25 stay.ini ;;
    esac
}

# All names of run.
every_run='catenary modal diffverf sweep steady points stabil floquet print table stiffness
    sling lift exact lever contour gapnet gapnodes gapdeck writedeck seamoves seabed pretension
    gapcheck wire wirearc wiremodes wirelinear updated'

# allocation N NAME, output N NAME: the run, whose N-th request for memory or act of writing fails.
allocation()
{
    (export SEILWERK_FAULT_MARK=mark LD_PRELOAD="$faults" SEILWERK_FAIL_ALLOC="$1"; run "$2")
}

output()
{
    (export SEILWERK_FAULT_MARK=mark LD_PRELOAD="$faults" SEILWERK_FAIL_OUTPUT="$1"; run "$2")
}
