#!/bin/sh
# Each request for memory, each act of writing, each block of the disk fails in turn: never a crash,
# a partial file or exit status 0 without the whole result.  Signals leave nothing half done.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
sed 's/^end = .*/end = 0.1/; s/^elements = .*/elements = 2/' \
    "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini
faults=$SEILWERK_BUILD/tests/faults.so
modal -d whole -o whole.csv stay.ini
cat >table.csv <<END
name,span,mass_per_length,axial_stiffness,sag,frequency,elements
a,100,2,1e6,3,,
"b, 2",100,2,1e6,,1.1,2
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

# Until the file has content, ten seconds at most.
wait_for()
{
    tries=0
    while [ ! -s "$1" ] && [ $tries -lt 500 ]; do
        sleep 0.02
        tries=$((tries + 1))
    done
}

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

# judge STATUS: status 1, a message, no result, no unfinished file.  Prints what is wrong.
judge()
{
    [ "$1" -eq 1 ] || echo "status $1"
    [ -s err ] || echo 'no message'
    [ ! -e result/out.csv ] || echo 'a result'
    [ -z "$(find result -name '*.part')" ] || echo 'an unfinished file'
}

# each_fails WHAT TOOL COMMAND...: COMMAND gets n = 1, 2, ... until the n-th call does not come.  A
# library may get over the loss by itself: then the result must be whole.
each_fails()
{
    what=$1
    tool=$2
    shift 2
    n=0
    wrong=
    rm -rf result
    mkdir result
    run "$tool"
    mv result/out.csv expected.csv
    while [ $n -lt 2000 ] && [ ${#wrong} -lt 200 ]; do
        n=$((n + 1))
        rm -rf result mark
        mkdir result
        "$@" "$n" "$tool" 2>err
        status=$?
        if [ $status -eq 0 ]; then
            found=$(cmp expected.csv result/out.csv 2>&1)
        else
            found=$(judge $status)
        fi
        [ -e mark ] || break
        [ -z "$found" ] || wrong="$wrong $n: $found;"
    done
    [ -z "$wrong$found" ] || echo "# $wrong $found"
    [ -z "$wrong$found" ] && [ $status -eq 0 ] && [ $n -gt 4 ]
    ok $? "$tool: each of $((n - 1)) $what fails in turn"
}

allocation()
{
    (export SEILWERK_FAULT_MARK=mark LD_PRELOAD="$faults" SEILWERK_FAIL_ALLOC="$1"; run "$2")
}

output()
{
    (export SEILWERK_FAULT_MARK=mark LD_PRELOAD="$faults" SEILWERK_FAIL_OUTPUT="$1"; run "$2")
}

if [ -z "${SEILWERK_SANITIZED:-}" ]; then
    for tool in catenary modal diffverf sweep steady points print table stiffness sling lift exact \
        lever contour gapnet gapnodes gapdeck writedeck seamoves seabed pretension gapcheck wire \
        wirearc wiremodes wirelinear updated; do
        each_fails 'requests for memory' $tool allocation
        each_fails 'acts of writing' $tool output
    done
fi

# A model written over that of another case: afterwards the directory is the old model, the new one
# or refused by both, and nothing unfinished lies in it.
if [ -z "${SEILWERK_SANITIZED:-}" ]; then
    modal -d older -o older.csv --set cable.mass_per_length=65 stay.ini
    n=0
    wrong=
    states=
    : >mark
    while [ -e mark ] && [ $n -lt 200 ]; do
        n=$((n + 1))
        rm -rf result mark
        mkdir result
        cp -r older result/model
        output $n modal 2>err
        diffverf -d result/model --set cable.mass_per_length=65 -o old.csv stay.ini 2>err
        old=$?
        diffverf -d result/model -o new.csv stay.ini 2>err
        states="$states $old$?"
        [ -z "$(find result -name '*.part')" ] || wrong="$wrong $n"
    done
    for state in $states; do
        case $state in 02 | 20 | 22) ;; *) wrong="$wrong $state" ;; esac
    done
    [ -z "$wrong" ] || echo "# $wrong"
    [ -z "$wrong" ] && [ $n -gt 40 ] && [ "$state" = 20 ]
    ok $? "a model directory is one model or refused, whichever of $((n - 1)) acts of writing fails"
fi

# The message itself must be written somewhere: stderr is a pipe, which has no limit of size.
for tool in catenary modal diffverf; do
    n=0
    wrong=
    status=1
    while [ $status -ne 0 ] && [ $n -lt 200 ] && [ ${#wrong} -lt 200 ]; do
        rm -rf result
        mkdir result
        message=$( (ulimit -f $n; run $tool) 2>&1)
        status=$?
        echo "$message" >err
        [ $status -eq 0 ] || found=$(judge $status)
        [ $status -eq 0 ] || [ -z "$found" ] || wrong="$wrong $n: $found;"
        n=$((n + 1))
    done
    [ -z "$wrong" ] || echo "# $wrong"
    [ -z "$wrong" ] && [ $n -gt 1 ] && [ -s result/out.csv ]
    ok $? "$tool: the disk is full after 0 ... $((n - 2)) blocks"
done

for tool in catenary modal diffverf; do
    runs 1 "$tool -o /dev/full" "$tool" -o /dev/full stay.ini
    says '/dev/full: cannot be written: No space left on device' 'says so'
    "$tool" stay.ini >/dev/full 2>err
    [ $? -eq 1 ] && grep -q 'cannot be written' err
    ok $? "$tool >/dev/full"
    { "$tool" stay.ini 2>err; echo $? >status; } | true
    [ "$(cat status)" -eq 0 ] || { [ "$(cat status)" -eq 141 ] && [ ! -s err ]; }
    ok $? "$tool into a closed pipe ends quietly"
    { env --ignore-signal=PIPE "$tool" stay.ini 2>err; echo $? >status; } | true
    [ ! -s err ]
    ok $? "$tool into a closed pipe, signal ignored by the parent, ends quietly"
done

# A long run, stopped in the middle.
for signal in INT TERM; do
    rm -rf result
    mkdir result
    env --default-signal=INT diffverf --set time.end=1e5 -o result/out.csv stay.ini 2>err &
    pid=$!
    wait_for result/out.csv.part
    kill -s $signal $pid
    wait $pid 2>wait.err # where some shells tell of the signal
    status=$?
    [ $status -eq "$(case $signal in INT) echo 130 ;; TERM) echo 143 ;; esac)" ]
    ok $? "SIG$signal ends diffverf by that signal"
    [ "$(ls result)" = 'out.csv.part
out.csv.state' ] && [ "$(tail -c 1 result/out.csv.part | od -An -c | tr -d ' ')" = '\n' ]
    ok $? 'and leaves complete rows and a state'
    env --default-signal=INT diffverf --set time.end=1e5 stay.ini >rows 2>err &
    pid=$!
    wait_for rows
    kill -s $signal $pid
    wait $pid 2>wait.err
    [ "$(tail -c 1 rows | od -An -c | tr -d ' ')" = '\n' ] &&
        [ -z "$(awk -F, 'NF != 11' rows)" ]
    ok $? "SIG$signal: standard output ends with a complete row"
done

# Special files and links.
mkfifo pipe
catenary stay.ini >expected
cat pipe >copy &
runs 0 'into a FIFO' catenary -o pipe stay.ini
wait
same expected copy 'whole, and the FIFO is there still'
[ -p pipe ]
ok $? 'the FIFO remains one'
runs 0 'into /dev/null' catenary -o /dev/null stay.ini
[ -c /dev/null ]
ok $? '/dev/null remains a device'
echo old >target
ln -s target link
runs 0 'through a link' catenary -o link stay.ini
same expected target 'the target is replaced'
[ -L link ]
ok $? 'the link remains one'
runs 0 'over an older result' catenary -o target stay.ini
same expected target 'the same again'
finish
