#!/bin/sh
# Each request for memory, each act of writing, each block of the disk fails in turn: never a crash,
# a partial file or exit status 0 without the whole result.  Signals leave nothing half done.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
. "$here/../everyrun.sh"

# Until the file has content, ten seconds at most.
wait_for()
{
    tries=0
    while [ ! -s "$1" ] && [ $tries -lt 500 ]; do
        sleep 0.02
        tries=$((tries + 1))
    done
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

if [ -z "${SEILWERK_SANITIZED:-}" ]; then
    for tool in $every_run; do
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
