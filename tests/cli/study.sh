#!/bin/sh
# scripts/study: tables of points, results, failures with their reasons, resuming, Slurm's files.
. "$(dirname "$0")/../tap.sh"
. "$top/tests/processes.sh"
cd "$scratch" || exit 1
PATH=$top/scripts:$PATH
mkdir tmp && export TMPDIR="$scratch/tmp"
command -v parallel >/dev/null || {
    skip 'GNU parallel is missing'
    finish
}
sed 's/^end = .*/end = 5/' "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini

# table NAME OPTION...: prints a table of variations into out.
table()
{
    name=$1
    shift
    runs 0 "$name" study --print-table "$@"
}
# rows LINE...: out has these lines.
rows()
{
    printf '%s\n' "$@" >wanted
    same wanted out 'its rows'
}

[ "$(study --version)" = "study (Seilwerk) $(cat "$top/VERSION")" ]
ok $? 'the version is that of the tools'

# Grids.
table 'a grid' --grid 'motion deck.omega=4:6:0.5' --grid 'cable.area=1e-4,,2e-4'
[ "$(wc -l <out)" -eq 16 ] && [ "$(sed -n 3p out)" = 4, ] && [ "$(sed -n 16p out)" = 6,2e-4 ]
ok $? 'all combinations, the last column fastest, empty cells'
table 'vectors' --grid 'load.wind=0 0 50,0 0 1:2:0.5'
rows load.wind '0 0 50' '0 0 1' '0 0 1.5' '0 0 2'
table 'downward, through zero' --grid 'a.b=0.3:-0.1:-0.1'
rows a.b 0.3 0.2 0.1 0 -0.1
table 'one empty value' --grid 'a.b='
rows a.b '""'
table 'a column that needs quotes' --grid 'a,b"c=1,x"'
rows '"a,b""c"' 1 '"x"""'

# Lists, in any dress.
cat >list.csv <<'END'
name,cable.area,load.wind
plain,8e-3,
"with, comma",9e-3,0 0 50
"with ""quotes""",1e-2,0 0 60
END
table 'a list' --table list.csv
same list.csv out 'is as it was'
{ printf '\357\273\277'; sed 's/$/\r/' list.csv; } >dos.csv
runs 0 'from stdin, CR LF and a byte order mark' sh -c 'study --print-table --table - <dos.csv'
same list.csv out 'the same'
# refused TEXT OPTION...: status 2, and the text is in the message.
refused()
{
    text=$1
    shift
    runs 2 "refused: $text" study "$@"
    says "$text" 'says so'
}
bad()
{
    printf '%b' "$1" >bad.csv
    refused "$2" --print-table --table bad.csv
}
bad 'a.b,a.c\n1,2\n3\n' 'bad.csv:3: 1 cells; the header has 2'
bad 'a.b,a.b\n' "bad.csv:1: 'a.b' is there twice"
bad 'a.b;a.c\n1;2\n' 'bad.csv:1: semicolons'
bad 'a.b\n"1"2\n' 'bad.csv:2: the quotes are wrong'
bad 'a.b,a.c\n"1\n2",3\n' 'holds a line break'
bad 'point,a.c\n' "'point' is taken"
bad '' 'is empty; a header line is expected'
refused 'nothing.csv: cannot be opened' --print-table --table nothing.csv
refused 'give the points by one of' --print-table
refused 'give the points by one of' --print-table --table list.csv --grid a.b=1
refused "'1:2': expected FROM:TO:STEP" --print-table --grid a.b=1:2
refused 'the step does not lead from 1 to 2' --print-table --grid a.b=1:2:-0.5
refused 'more than 1e7 points' --print-table --grid a=1:9999:1 --grid b=1:9999:1
refused 'expected KEY=VALUES' --print-table --grid a.b
refused 'FROM must be less than TO' --print-table --latin 3 --vary a.b=2:1
refused 'a logarithm needs FROM > 0' --print-table --latin 3 --vary a.b=0:1:log
refused 'expected FROM:TO, FROM:TO:log or MEAN~SD' --print-table --latin 3 --vary a.b=7
refused '--latin and --vary belong together' --print-table --latin 3
refused "--latin: 'x': expected a whole number" --print-table --latin x --vary a.b=1:2
refused '--seed belongs to --latin' --print-table --seed 1 --grid a.b=1
refused 'give the directory' --grid a.b=1 true
refused 'no tool is given' -d d --grid a.b=1
refused 'does not go with --slurm' -d d --slurm -j 2 --grid a.b=1 true
refused '--slurm-option belongs to' -d d --slurm-option=--time=1 --grid a.b=1 true
refused 'here PATH serves' -d d --tools x --grid a.b=1 true
refused 'unknown option: nonsense' --nonsense
refused 'is an input of this study' -d d -o stay.ini --grid a.b=1 catenary stay.ini
[ ! -e d ]
ok $? 'and nothing is written'

# Latin hypercubes: one point in each stratum of each column, by an MRG32k3a written once more.
table 'a Latin hypercube' --latin 500 --seed 7 --vary 'a=0.5:0.7' --vary 'b=1:1e6:log' \
    --vary 'c=60~2' --vary 'd=0 -1:1 5'
awk -F, 'function phi(x,   s, t, k) {
        if (x < 0) return 1 - phi(-x)
        s = t = x
        for (k = 3; k < 300; k += 2) s += t *= x*x/k
        return 0.5 + s*exp(-x*x/2)/sqrt(8*atan2(1, 1))
    }
    NR > 1 { split($4, d, " ")
        if (d[1] != 0 || d[3] != 5) bad = 1
        seen[1, int(500*($1 - 0.5)/0.2)]++; seen[2, int(500*log($2)/log(1e6))]++
        seen[3, int(500*phi(($3 - 60)/2))]++; seen[4, int(500*(d[2] + 1)/2)]++ }
    END { for (k = 1; k <= 4; k++) for (i = 0; i < 500; i++) if (seen[k, i] != 1) bad = 1
        exit bad }' out
ok $? 'each stratum of each column has one point'
cp out hypercube
table 'the same seed' --latin 500 --seed 7 --vary 'a=0.5:0.7' --vary 'b=1:1e6:log' \
    --vary 'c=60~2' --vary 'd=0 -1:1 5'
same hypercube out 'the same table'
table 'another seed' --latin 500 --seed 8 --vary 'a=0.5:0.7' --vary 'b=1:1e6:log' \
    --vary 'c=60~2' --vary 'd=0 -1:1 5'
cmp -s hypercube out
[ $? -eq 1 ]
ok $? 'another table'
awk 'function rem(x, m) { x -= m*int(x/m); return x < 0 ? x + m : x }
    function draw(   p, q) {
        p = rem(1403580*s[2] - 810728*s[1], 4294967087); s[1] = s[2]; s[2] = s[3]; s[3] = p
        q = rem(527612*s[6] - 1370589*s[4], 4294944443); s[4] = s[5]; s[5] = s[6]; s[6] = q
        return (p > q ? p - q : p - q + 4294967087)/4294967088
    }
    BEGIN {
        for (i = 1; i <= 6; i++) s[i] = 12345
        if (sprintf("%.10f", draw()) != "0.1270111220") exit 1  # as published
        x = 8
        for (i = 1; i <= 6; i++) s[i] = x = rem(16807*x, 2147483647)
        for (i = 0; i < 20; i++) order[i] = i
        for (i = 19; i; i--) { j = int(draw()*(i + 1)); t = order[i]; order[i] = order[j]; order[j] = t }
        print "x"
        for (i = 0; i < 20; i++) printf "%.12g\n", (order[i] + draw())/20
    }' >wanted
ok $? 'the generator gives its published first number'
table 'its numbers' --latin 20 --seed 7 --vary x=0:1
same wanted out 'are those of the generator'
table 'normal numbers' --latin 10000 --vary 'x=0~1'
awk 'NR > 1 { n++; s += $1; q += $1*$1; f += $1^4; if ($1 > 1.959963984540054) tail++ }
    END { exit !((s/n)^2 < 1e-8 && (q/n - 1)^2 < 1e-5 && (f/n - 3)^2 < 0.01 && tail >= 249 &&
        tail <= 251) }' out
ok $? 'mean 0, variance 1, kurtosis 3, 2.5 % above 1.96'

# A study is what a loop gives.
runs 0 'a study' study -d list --table list.csv catenary --summary stay.ini
says 'study: 3 points: 3 done' 'says how it went'
{
    head -n 1 list.csv | sed 's/^/point,/' | tr -d '\n'
    catenary --summary stay.ini | sed -n 's/^/,/; 1p'
    for n in 1 2 3; do
        area=$(echo 8e-3 9e-3 1e-2 | cut -d' ' -f$n)
        wind=$(echo ,0 0 50,0 0 60 | cut -d, -f$n)
        printf '%s,%s,' $n "$(sed -n "$((n + 1))p" list.csv)"
        catenary --summary --set "cable.area=$area" --set "load.wind=$wind" stay.ini | tail -n 1
    done
} >wanted
same wanted list/results.csv 'is what a loop gives'
same list.csv list/table.csv 'the table is kept'
[ -z "$(ls tmp)" ] && [ ! -e list/failed.csv ]
ok $? 'nothing else is left'
runs 0 'many rows for a point' study -q -d modes --grid 'cable.area=8e-3,9e-3' -o - modal --modes 3 stay.ini
[ "$(cut -d, -f1-3 out | tr '\n' ' ')" = \
    'point,cable.area,mode 1,8e-3,1 1,8e-3,2 1,8e-3,3 2,9e-3,1 2,9e-3,2 2,9e-3,3 ' ] && [ ! -s err ]
ok $? 'are all there, on stdout; -q says nothing'
runs 0 'columns that differ' study -q -d probes -o - --grid 'time.probes=0.5,0.5 0.25' --grid time.end=0.1 \
    diffverf -q stay.ini
awk -F, 'NR == 1 { n = NF; for (i = 1; i <= NF; i++) at[$i] = i; next }
    NF != n || ($at["v1_2_m"] == "") != ($1 == 1) || $at["force_left_1_N"] == "" { bad = 1 }
    END { exit bad || NR < 4 || !at["v1_2_m"] }' out
ok $? 'are united, what is missing is empty'

# Points that fail; their reasons.
cat >odd.sh <<'END'
#!/bin/sh
case $2 in
    *=crash) kill -SEGV $$ ;;
    *=silent) exit 3 ;;
    *=empty) exit 0 ;;
    *=ragged) printf 'a,b\n1,2\n3\n'; exit 0 ;;
    *=two) printf 'odd: first, "quoted"\nodd: last\n  and more\n' >&2; exit 1 ;;
    *=none) echo a,b; exit 0 ;;
esac
echo "what,$1"
echo "\"${2#*=}
next\",$(pwd | grep -c /files)"
END
chmod +x odd.sh
runs 1 'failures' study -d odd --grid 'x.y=good,crash,silent,empty,ragged,two,none' ./odd.sh
says 'study: 7 points: 2 done, 5 failed (see odd/failed.csv)' 'are counted'
cat >wanted <<'END'
point,x.y,status,reason
2,crash,signal 11,killed by signal 11
3,silent,3,failed without a message
4,empty,0,it printed no CSV with a header
5,ragged,0,line 3 of its output has 1 cells; its header has 2
6,two,1,odd: last and more
END
same wanted odd/failed.csv 'each with its reason'
printf 'point,x.y,what,--set,a,b\n1,good,"good\nnext",1,,\n' >wanted
same wanted odd/results.csv 'and left out of the results'
sed -i 's/exit 3/:/' odd.sh
runs 2 'another tool' study -d odd --grid 'x.y=good,crash,silent,empty,ragged,two,none' ./odd.sh
says 'file odd.sh (its contents)' 'is refused, and what differs is said'
sed -i 's/) :/) exit 3/' odd.sh

# All rows in one process.
# shellcheck disable=SC2086
base='--set cable.unstressed_length=110.1897 --set cable.youngs_modulus=2.1e11
    --set cable.mass_per_length=64.8 --set supports.span=110.5'
awk 'BEGIN { print "name,cable.area"; for (i = 1; i <= 50; i++) print "s" i "," (i == 23 ? "x" : i/1e3) }' >many.csv
runs 1 'one process for a chunk' study -d many --chunk 20 --table many.csv catenary --table $base {}
says '50 points: 49 done, 1 failed' 'a row that cannot be used'
[ "$(sed -n 2p many/failed.csv)" = \
    "23,s23,x,1,catenary: table.csv:24: column 2: area: 'x': not a number" ]
ok $? 'is a failed point, with its line in the whole table'
catenary --table $base <many.csv 2>/dev/null | awk -F, 'NR == 1 { print "point," $0; next }
    $3 != "" { print NR - 1 "," $0 }' >wanted
same wanted many/results.csv 'the others are what the tool prints'
runs 1 'a tool that refuses the table' study -d no --chunk 20 --table many.csv catenary --table --nonsense {}
[ "$(grep -c 'option --nonsense is not known' no/failed.csv)" -eq 50 ]
ok $? 'fails all points with this reason'
printf 'type,v_m,z_m,phi_deg\nprimary,5,1,45\nprimary,5,x,45\n' >lifts.csv
runs 0 'sling' study -d sling --table lifts.csv sling {}
sling lifts.csv 2>/dev/null | awk 'NR == 1 { print "point," $0; next } { print NR - 1 "," $0 }' >wanted
same wanted sling/results.csv 'has its own way to say it: a verdict'
runs 0 'sling by --set' study -q -d sling2 --grid v_m=2,3 sling lifts.csv --set z_m=1
[ "$(grep -c . sling2/results.csv)" -eq 5 ] && head -n 1 sling2/results.csv | grep -q '^point,v_m,type,z_m,'
ok $? 'too; columns of the table are not repeated'

# Failed points again: without the cause they are done, with others they are not touched.
cat >moody.sh <<'END'
#!/bin/sh
echo "$SEILWERK_POINT" >>"$LOGFILE"
[ ! -e "$LOGFILE.bad" ] || [ $((SEILWERK_POINT % 3)) -ne 0 ] || exit 1
echo x
echo "$SEILWERK_POINT"
END
chmod +x moody.sh
LOGFILE=$scratch/moody.log
export LOGFILE
touch moody.log.bad
runs 1 'every third fails' study -d moody --chunk 4 --grid a.b=1:20:1 ./moody.sh
rm moody.log.bad moody.log
runs 1 'the same again' study -d moody --grid a.b=1:20:1 ./moody.sh
[ ! -e moody.log ]
ok $? 'runs nothing'
runs 2 '--chunk' study -d moody --chunk 5 --grid a.b=1:20:1 ./moody.sh
says 'has 4 points a job already' 'cannot change'
runs 0 '--retry-failed' study -d moody --retry-failed --chunk 2 --grid a.b=1:20:1 ./moody.sh
[ "$(sort -n moody.log | tr '\n' ' ')" = '3 6 9 12 15 18 ' ]
ok $? 'runs the failed ones'
awk 'BEGIN { print "point,a.b,x"; for (i = 1; i <= 20; i++) print i "," i "," i }' >wanted
same wanted moody/results.csv 'all is in order'
[ ! -e moody/failed.csv ]
ok $? 'no failed points are left'

# Warnings are kept, in either way of running; why the first point failed is said.
printf '[cable]\nunstressed_length = 101\nmass_per_length = 40\narea = 5e-3\nyoungs_modulus = 1.95e11\n[supports]\nspan = 100\n' >doubt.ini
runs 1 'doubtful points' study -d doubt --grid cable.youngs_modulus=1.95e11,195,-1 catenary --summary doubt.ini
says '3 points: 2 done, 1 failed (see doubt/failed.csv); 1 with warnings (see doubt/warnings.csv)' 'are counted'
says 'study: point 3: catenary: --set cable.youngs_modulus: -1 is outside' 'and why the first one failed'
[ "$(wc -l <doubt/warnings.csv)" -eq 2 ] &&
    grep -q '^2,195,catenary: youngs_modulus = 195 Pa: is the unit right?; catenary: the cable is stretched' \
        doubt/warnings.csv
ok $? 'what was said is kept'
printf 'span,unstressed_length,mass_per_length,youngs_modulus,area\n100,101,40,1.95e11,5e-3\n100,101,40,195,5e-3\n' >rows.csv
runs 0 'doubtful rows' study -d rows --table rows.csv catenary --table {}
[ "$(sed 1d rows/warnings.csv)" = "2,$(sed -n 3p rows.csv),catenary: table.csv:3: youngs_modulus = 195 Pa: is the unit right?; catenary: table.csv:3: the cable is stretched by 2.03e+06 %: are the units right?" ]
ok $? 'are told by their lines in the table'

# A tool that is told to stop has not failed: its chunk is not done.  One that crashes has.
cat >shot.sh <<'END'
#!/bin/sh
[ "$SEILWERK_POINT" -ne 5 ] || [ ! -e "$LOGFILE.shot" ] || kill -s "$(cat "$LOGFILE.shot")" $$
echo x
echo "$SEILWERK_POINT"
END
chmod +x shot.sh
for signal in INT TERM HUP; do
    echo $signal >moody.log.shot
    runs 1 "a tool stopped by SIG$signal" study -d shot-$signal --chunk 4 --grid a.b=1:20:1 ./shot.sh
    [ ! -e shot-$signal/failed.csv ] && ! grep -q '^[5-8],' shot-$signal/results.csv
    ok $? 'its chunk is not done, and nothing has failed'
    rm moody.log.shot
    runs 0 'again' study -d shot-$signal --grid a.b=1:20:1 ./shot.sh
    same wanted shot-$signal/results.csv 'is computed then'
done
echo SEGV >moody.log.shot
runs 1 'a tool that crashes' study -d shot --chunk 4 --grid a.b=1:20:1 ./shot.sh
grep -qx '5,5,signal 11,killed by signal 11' shot/failed.csv && [ "$(wc -l <shot/results.csv)" -eq 20 ]
ok $? 'has failed, with this reason'
rm moody.log.shot

# Stopped in the middle, then continued.
cat >slow.sh <<'END'
#!/bin/sh
sleep 0.1
echo "$SEILWERK_POINT" >>"$LOGFILE"
echo x
echo "$SEILWERK_POINT"
END
chmod +x slow.sh
awk 'BEGIN { print "point,a.b,x"; for (i = 1; i <= 40; i++) print i "," i "," i }' >whole
for signal in TERM INT HUP KILL; do
    rm -f moody.log
    perl -e 'setpgrp; $SIG{INT} = "DEFAULT"; exec @ARGV' study -d $signal -j 2 --grid a.b=1:40:1 ./slow.sh 2>err &
    pid=$!
    for _ in $(seq 100); do
        [ -e moody.log ] && [ "$(wc -l <moody.log)" -ge 8 ] && break
        sleep 0.05
    done
    # all that runs is killed at one blow; other signals the study passes on
    if [ $signal = KILL ]; then
        kill_tree $pid
    else
        kill -$signal $pid
    fi
    wait $pid 2>/dev/null
    [ $? -gt 128 ]
    ok $? "SIG$signal: ends by it"
    done_now=$(find $signal/job-*/done -type f ! -name '*part*' | wc -l)
    [ $signal = KILL ] || [ "$(($(wc -l <$signal/results.csv) - 1))" -eq "$done_now" ]
    ok $? 'what is done is collected'
    sleep 0.5 # a job that GNU parallel was about to start may still come to its end
    done_now=$(find $signal/job-*/done -type f ! -name '*part*' | wc -l)
    rm moody.log
    runs 0 'continued' study -d $signal -j 2 --grid a.b=1:40:1 ./slow.sh
    same whole $signal/results.csv 'nothing lost, nothing twice'
    [ "$(wc -l <moody.log)" -eq $((40 - done_now)) ]
    ok $? 'finished points are not run again'
done
runs 1 '--collect before anything is computed' study -d none --collect --grid a.b=1:40:1 ./slow.sh
says '40 points: 0 done, 40 not yet computed' 'says so'
study -q -d busy -j 1 --grid a.b=1:40:1 ./slow.sh 2>/dev/null &
pid=$!
for _ in $(seq 100); do [ -e busy/table.csv ] && break; sleep 0.05; done
runs 1 'two at a time in one directory' study -d busy --grid a.b=1:40:1 ./slow.sh
says 'another study is at work there' 'are refused'
kill $pid
wait $pid

# Names that shells stumble over, in all places.
# shellcheck disable=SC2016
odd='-a "b'\'' $c;'
at=./$odd
mkdir "$at" && cp stay.ini "$at/$odd.ini" && mkdir "$at/with" && echo 1 >"$at/with/$odd"
cat >"$at/tool $odd" <<'END'
#!/bin/sh
for word; do last=$word; done
[ -f "$last" ] && [ -f "$(dirname "$last")/with/$(basename "$last" .ini)" ] || exit 1
printf 'words\n%s\n' "$#"
END
chmod +x "$at/tool $odd"
printf 'a.b\n"x ""y"" %s"\n' "'z'; \$(exit)" >quotes.csv
runs 0 'odd names' study -d "$odd" --table quotes.csv --with "$at/with" \
    "$at/tool $odd" "$odd 'w'" '' "$at/$odd.ini"
printf 'point,a.b,words\n1,"x ""y"" %s",5\n' "'z'; \$(exit)" >wanted
same wanted "$at/results.csv" 'come through'
(cd "$at" && study -q -d ../up --grid 'cable.area=8e-3' catenary --summary "../$odd/$odd.ini")
ok $? 'a case beside the working directory'
runs 0 'an absolute path' study -q -d abs --grid 'cable.area=8e-3' catenary --summary "$scratch/stay.ini"
same up/results.csv abs/results.csv 'the same result'

# What cannot be written.
ln -s /dev/full full.csv.part
touch file
runs 1 'a directory that cannot be made' study -d file/x --grid a.b=1 ./moody.sh
says 'file/x: cannot be made' 'says so'
runs 1 'a full disk' study -d list -o full.csv --table list.csv catenary --summary stay.ini
says 'full.csv: cannot be written: No space left' 'says so'
[ ! -e full.csv ]
ok $? 'leaves no result'
runs 1 'a full stdout' sh -c 'study -q -d list -o - --table list.csv catenary --summary stay.ini >/dev/full'
runs 1 'a tool that is not there' study -d missing --grid a.b=1,2 no-such-tool
says 'no-such-tool: cannot be run' 'is no fault of the points'
says '2 points: 0 done, 2 not yet computed' 'they are not computed'
runs 0 'with the right name, in the same directory' study -d missing --grid a.b=1,2 ./moody.sh
mkdir bare && for t in perl sh; do ln -s "$(command -v $t)" bare; done
PATH="$scratch/bare" runs 1 'without GNU parallel' perl "$top/scripts/study" -d nopar --grid a.b=1,2 ./moody.sh
says 'GNU parallel is missing' 'is said'

# Slurm: the file, and what it does when its tasks are run.
slurm()
{
    study -d "dir 'x'" --chunk 2 --grid a.b=1:21:1 "$@" ./moody.sh
}
runs 0 'the sbatch file' slurm --slurm --tools tmp --slurm-option=--time=1:00:00 --slurm-option '--partition=a b'
sed "s/job-[0-9a-f]\{12\}/job-ID/g; s|$scratch|SCRATCH|g" out >sbatch
same "$top/tests/cli/golden/study.sbatch" sbatch 'is as recorded'
mkdir fake
cat >fake/sbatch <<'END'
#!/bin/sh
# runs the tasks of the array one by one; FAKE_TASKS tells which
for file; do :; done
for task in $(sed -n 's/^#SBATCH --array=//p' "$file" | tr , '\n' | awk -F- '{ for (i = $1; i <= $NF; i++) print i }'); do
    case " ${FAKE_TASKS:-$task} " in *" $task "*) SLURM_ARRAY_TASK_ID=$task sh "$file" || exit 1 ;; esac
done
echo '17;cluster'
END
cat >fake/squeue <<'END'
#!/bin/sh
[ "$*" = '--noheader --format=%F --jobs=17' ] || exit 1
[ ! -e "$LOGFILE.refusal" ] || { cat "$LOGFILE.refusal" >&2; exit 1; }
cat "$LOGFILE.queue"
END
chmod +x fake/*
PATH=$scratch/fake:$PATH
rm -f moody.log
FAKE_TASKS='1 2 5 11'
export FAKE_TASKS
runs 0 'submitted' slurm --submit
says 'submitted as job 17' 'says the number of the job'
[ "$(sort -n moody.log | tr '\n' ' ')" = '1 2 3 4 9 10 21 ' ]
ok $? 'each task computes its chunks'
printf '17\n17\n' >moody.log.queue
runs 1 'while the array is with Slurm' slurm --submit
says 'the array 17 is still with Slurm' 'nothing is submitted'
says '7 done, 14 not yet computed' 'what is there is collected'
: >moody.log.queue
echo 'slurm_load_jobs error: Unable to contact slurm controller' >moody.log.refusal
runs 1 'while squeue cannot tell' slurm --submit
says 'squeue does not tell whether the array 17 is over' 'nothing is submitted'
says 'Unable to contact slurm controller' 'says why'
echo 'slurm_load_jobs error: Invalid job id specified' >moody.log.refusal # long over
TMPDIR=none runs 1 'a task without room' sh -c "exec perl \"dir 'x'\"/job-*/run --task 1 2"
says 'chunk 3 at ' 'names its chunk'
slurm --slurm 2>/dev/null | grep '^#SBATCH --array=' >arrays
echo '#SBATCH --array=3-4,6-10' >wanted
same wanted arrays 'the next file has the tasks that are left'
rm moody.log
unset FAKE_TASKS
runs 0 'submitted again' slurm --submit
runs 0 'collected' slurm --submit
awk 'BEGIN { print "point,a.b,x"; for (i = 1; i <= 21; i++) print i "," i "," i }' >wanted
same wanted "dir 'x'/results.csv" 'all is there'
[ "$(sort -n moody.log | tr '\n' ' ')" = '5 6 7 8 11 12 13 14 15 16 17 18 19 20 ' ]
ok $? 'nothing was computed twice'
study --print-table --grid a.b=1:2500:1 >2500.csv
for chunk in 1 2; do
    study -q -d slurm$chunk --chunk $chunk --slurm --table 2500.csv ./moody.sh
done 2>/dev/null | sed -n 's/^#SBATCH --array=//p' >arrays
printf '%s\n' 1-1000 1-1000 >wanted
same wanted arrays 'no more than a thousand tasks'

# A tool and its data behind a symbolic link.
mkdir elsewhere
printf '#!/bin/sh\necho x\ncat "$3"\n' >elsewhere/show
chmod +x elsewhere/show
echo 5 >elsewhere/data
ln -s elsewhere link
runs 0 'through a link' study -q -d linked --grid a.b=1,2 link/show link/data
printf 'point,a.b,x\n1,1,5\n2,2,5\n' >wanted
same wanted linked/results.csv 'finds the tool and its data'

finish
