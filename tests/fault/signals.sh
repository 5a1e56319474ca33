#!/bin/sh
# Stopped at any time by any signal, on a full disk, into a closed pipe, where nothing may be written:
# a result is the old one or the new one, whole; nothing unfinished lies about but after kill -9; and
# diffverf goes on bit for bit.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
unset LD_PRELOAD
sed 's/^end = .*/end = 2/; s/^elements = .*/elements = 4/' "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini
cp "$top/scripts/experiments/lifts/cases.csv" lifts.csv
cp -r "$top/scripts/experiments/nets/mooring" net
"$top/scripts/wire/arc" wire 1 90 8
"$top/scripts/net/square" square 12
gapnet -d solved square/system.ini
awk 'BEGIN { print "span,mass_per_length,axial_stiffness,sag"
    for (i = 0; i < 3000; i++) print 100 + i % 7 ",2,1e6," 3 + i % 11/10 }' >cables.csv
awk 'NR == 1 { print; next } { row[NR] = $0 } END { for (i = 0; i < 2000; i++) print row[2 + i % (NR - 1)] }' \
    lifts.csv >many.csv
printf 'motion deck.omega\n7.8\n7.9\n8\n8.1\n' >points.csv

# Commands whose result is the file $1, each of some hundredths of a second.
run()
{
    case $2 in
    catenary) exec env --default-signal=INT catenary --table -o "$1" cables.csv ;;
    modal) exec env --default-signal=INT modal -o "$1" --set mesh.elements=60 stay.ini ;;
    diffverf) exec env --default-signal=INT diffverf -o "$1" --set time.end=20 stay.ini ;;
    points) exec env --default-signal=INT diffverf -q --threads 2 --points points.csv --set time.end=40 -o "$1" stay.ini ;;
    stabil) exec env --default-signal=INT stabil -o "$1" --set stability.ratio_step=0.02 stay.ini ;;
    sling) exec env --default-signal=INT sling -o "$1" many.csv ;;
    gapnet) exec env --default-signal=INT gapnet -o "$1" square/system.ini ;;
    gapcheck) exec env --default-signal=INT gapcheck -o "$1" solved ;;
    wirebeam) exec env --default-signal=INT wirebeam -q -o "$1" --set solve.steps=30 wire/case.ini ;;
    esac
}
tools='catenary modal diffverf points stabil sling gapnet gapcheck wirebeam'

# Time of the whole command in milliseconds, then signals spread over it.
for tool in $tools; do
    begin=$(date +%s%N)
    (run new.csv $tool)
    took=$((($(date +%s%N) - begin)/1000000))
    rm -f new.csv.state
    mv new.csv "$tool.expected"
    bad=
    for signal in INT TERM KILL; do
        for part in 0 1 2 3 4 5 6 7; do
            echo old >out.csv
            sleep=$(awk -v t=$took -v p=$part 'BEGIN { printf "%.4f", 0.001 + t*(p + 0.3)/7/1000 }')
            (run out.csv $tool) 2>err &
            pid=$!
            sleep "$sleep"
            kill -s $signal $pid 2>/dev/null
            wait $pid 2>/dev/null
            status=$?
            said="$signal after $sleep s, status $status"
            if cmp -s out.csv "$tool.expected"; then
                : # the new one; the signal may have come behind it
            elif [ "$(cat out.csv)" != old ]; then
                bad="$bad; $said: neither old nor new"
            elif [ $status -eq 0 ]; then
                bad="$bad; $said: not written"
            fi
            case $signal:$tool in
            KILL:*) ;;
            *:diffverf) [ -z "$(find . -name '*.npy.part' -o -name '*.state.part')" ] || bad="$bad; $said: left" ;;
            *:points | *:stabil) [ ! -e out.csv.part ] || [ -z "$(tail -c 1 out.csv.part | tr -d '\n')" ] ||
                bad="$bad; $said: a part that ends in a row" ;; # what is finished is kept
            *) [ ! -e out.csv.part ] || bad="$bad; $said: a part is left" ;;
            esac
            rm -f out.csv out.csv.part out.csv.state out.csv.state.part
        done
    done
    [ -z "$bad" ] || echo "# $bad"
    [ -z "$bad" ]
    ok $? "$tool: 24 signals within $took ms: the old result or the new one"
done

# diffverf stopped again and again, by every signal, resumes until it is through: the same bytes.
for scheme in central alpha; do
    set -- --set time.scheme=$scheme --set time.end=60 --set disturbance.mode=1 \
        --set disturbance.amplitude=0.01
    diffverf -o whole.csv --state whole.state "$@" stay.ini
    rm -f cut.csv cut.csv.part cut.csv.state
    stops=0
    while [ ! -e cut.csv ] && [ $stops -lt 60 ]; do
        case $((stops%4)) in 0) signal=INT ;; 1) signal=TERM ;; 2) signal=KILL ;; 3) signal=XFSZ ;; esac
        resume=
        [ ! -e cut.csv.state ] || resume=--resume
        rm -f begun
        # shellcheck disable=SC2086
        env --default-signal=INT diffverf $resume -o cut.csv "$@" stay.ini 2>err &
        pid=$!
        sleep 0.0$((1 + stops*3%8))
        kill -s $signal $pid 2>/dev/null
        wait $pid 2>/dev/null
        [ -e cut.csv.state ] || [ -e cut.csv ] || rm -f cut.csv.part # killed before the first state
        stops=$((stops + 1))
    done
    cmp -s cut.csv whole.csv
    ok $? "diffverf, $scheme: resumed bit for bit after $((stops - 1)) stops"
done

# Nowhere to write.
for tool in $tools; do
    bad=
    (run /proc/nowhere.csv $tool) 2>err
    [ $? -eq 1 ] && grep -q 'nowhere.csv.*: cannot be' err || bad="$bad; a place that is read-only: $(cat err)"
    (run /dev/full $tool) 2>err
    [ $? -eq 1 ] && grep -q '/dev/full: cannot be written: No space left on device' err ||
        bad="$bad; a full device: $(cat err)"
    { (run /dev/stdout $tool) 2>err; echo $? >status; } | true
    [ "$(cat status)" -eq 0 ] || { [ "$(cat status)" -eq 141 ] && [ ! -s err ]; } ||
        bad="$bad; a closed pipe: $(cat status) $(cat err)"
    for blocks in 0 1 2 4 8 16; do
        (ulimit -f $blocks; run small.csv $tool) 2>err
        status=$?
        if [ $status -eq 0 ]; then
            cmp -s small.csv "$tool.expected" || bad="$bad; $blocks blocks: not whole"
        elif [ -e small.csv ] || [ -e small.csv.part ]; then
            bad="$bad; $blocks blocks: something is left"
        fi
        [ $status -lt 2 ] || bad="$bad; $blocks blocks: status $status"
        rm -f small.csv small.csv.state
    done
    [ -z "$bad" ] || echo "# $bad"
    [ -z "$bad" ]
    ok $? "$tool: read-only, full device, closed pipe, full disk"
done

finish
