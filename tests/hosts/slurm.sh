#!/bin/sh
# scripts/study through Slurm: a controller and one node on this machine, with an authentication of
# their own, run as whoever runs the test.  All that they keep lies in the scratch directory.
. "$(dirname "$0")/../tap.sh"
. "$top/tests/processes.sh"
PATH=$top/scripts:$PATH:/usr/sbin:/sbin
for program in parallel munged slurmctld slurmd sbatch squeue scancel sinfo; do
    command -v "$program" >/dev/null || {
        skip "$program is missing"
        finish
    }
done
cd "$scratch" || exit 1
mkdir munge state spool tmp
export SLURM_CONF="$scratch/slurm.conf" TMPDIR="$scratch/tmp"

ports=$(perl -MIO::Socket::INET -e 'my @s = map { IO::Socket::INET->new(Listen => 1,
    LocalAddr => "127.0.0.1") // die "no port\n" } 1 .. 2; print join " ", map { $_->sockport } @s')
cat >slurm.conf <<END
ClusterName=test
SlurmctldHost=localhost
SlurmctldPort=${ports% *}
SlurmdPort=${ports#* }
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=0,sched_interval=1
ReturnToService=2
MinJobAge=2
SlurmdTimeout=6
MessageTimeout=2
NodeName=node NodeHostname=$(uname -n | cut -d. -f1) NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=node Default=YES MaxTime=INFINITE State=UP
END

# start NAME COMMAND...: a daemon in the foreground, in the background of this shell.
start()
{
    name=$1
    shift
    "$@" </dev/null >"$name.log" 2>&1 &
    echo $! >"$name.process"
}
down()
{
    [ -s "$1.process" ] || return 0
    kill_tree "$(cat "$1.process")"
    rm -f "$1.process"
}
# The controller writes down what it knows as it goes.
controller_down()
{
    kill "$(cat slurmctld.process)"
    wait "$(cat slurmctld.process)"
    rm slurmctld.process
}
# The node with all that runs there, at one blow: Slurm lets the guardians of its tasks, which know
# the file of the configuration, outlive slurmd.
node_down()
{
    down slurmd
    for guardian in $(perl -e 'for (glob "/proc/[0-9]*/comm") {
        my ($directory) = m{(.*)/};
        open my $in, "<", $_ or next;
        <$in> =~ /^slurmstepd/ or next;
        open $in, "<", "$directory/environ" or next;
        print "$1\n" if grep({ $_ eq "SLURM_CONF=$ENV{SLURM_CONF}" } split /\0/, <$in> // "") &&
            $directory =~ /(\d+)/;
    }'); do kill_tree "$guardian"; done
}
all_down()
{
    node_down
    down slurmctld
    down munged
}
trap 'exit 143' INT TERM HUP
trap 'all_down; rm -rf "$scratch"' EXIT

# wait_for COMMAND...: at most a minute.
wait_for()
{
    for _ in $(seq 600); do
        "$@" && return 0
        sleep 0.1
    done
    return 1
}
# stands STATE: so does the node.
stands() { [ "$(sinfo --noheader --format=%t 2>/dev/null)" = "$1" ]; }
over() { queue=$(squeue --noheader) && [ -z "$queue" ]; }

dd if=/dev/urandom of=munge/key bs=1024 count=1 2>/dev/null
chmod 400 munge/key
chmod 711 . munge
start munged munged --foreground --force --socket="$scratch/munge/socket" --num-threads=1 \
    --key-file="$scratch/munge/key" --pid-file="$scratch/munge/pid" \
    --seed-file="$scratch/munge/seed" --log-file="$scratch/munge/log"
wait_for test -S munge/socket
node_up() { start slurmd slurmd -D -N node; }
controller_up() { start slurmctld slurmctld -D; }
controller_up
node_up
wait_for stands idle
ready=$?
[ $ready -eq 0 ] || tail -n 5 ./*.log | sed 's/^/# /'
ok $ready 'a controller and a node are up'
[ $ready -eq 0 ] || finish

# A tool of the user's own, which takes its time and tells which point it computed.
sed 's/^end = .*/end = 5/' "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini
cat >slow <<END
#!/bin/sh
sleep 0.2
echo "\$SEILWERK_POINT" >>'$scratch/log'
exec catenary --summary "\$@"
END
chmod +x slow
# points DIR [OPTION...]: the study in DIR.
points()
{
    directory=$1
    shift
    study -d "$directory" --grid 'cable.area=6e-3:10e-3:1e-3' --grid 'cable.mass_per_length=60:64:1' \
        --chunk 2 "$@" ./slow stay.ini
}
# slurm DIR [OPTION...]: the same for the node, which has the tools at a place of its own.
slurm() { points "$@" --tools "$SEILWERK_BUILD/bin"; }
computed() { [ -e log ] && [ "$(wc -l <log)" -ge "$1" ]; }

runs 0 'the study here, on the local cores' points here -j 2

runs 0 'the sbatch file' slurm printed --slurm
mv out printed.sbatch
runs 0 'sbatch takes it as it is' sbatch printed.sbatch
wait_for over
runs 0 'all points are done' points printed --collect
same here/results.csv printed/results.csv 'the same bytes as without Slurm'

rm log
runs 0 'submitted' slurm 'in parts' --submit --slurm-option=--comment=ours
wait_for computed 6
ok $? 'it is under way'
runs 1 'the same command' slurm 'in parts' --submit
says 'is still with Slurm; nothing is submitted' 'does not submit it twice'
scancel "$(cat 'in parts'/job-*/submitted)"
wait_for over
ok $? 'scancel ends it in mid-study'
grep -q 'stopped by' 'in parts'/job-*/slurm.log
ok $? 'its tasks say so'
find tmp 'in parts' -name 'seilwerk-study*' -o -name '*.part*' >left
[ ! -s left ] || sed 's/^/# /' left
[ ! -s left ]
ok $? 'nothing half-written is left'

controller_down
runs 1 'while the controller is down' slurm 'in parts' --submit
says 'squeue does not tell' 'nothing is submitted'
controller_up
wait_for stands idle
points 'in parts' --collect 2>/dev/null
tail -n +2 'in parts/results.csv' | cut -d, -f1 | sort >kept
[ -s kept ] && [ "$(wc -l <kept)" -lt 25 ]
ok $? 'a part of the points is done'
rm log
runs 0 'submitted again' slurm 'in parts' --submit
wait_for over
runs 0 'the same command collects' slurm 'in parts' --submit
same here/results.csv 'in parts/results.csv' 'nothing is lost, nothing is there twice'
sort log >later
[ -z "$(comm -12 kept later)" ] && [ $(($(wc -l <kept) + $(wc -l <later))) -eq 25 ]
ok $? 'no finished point was computed again'

rm log
runs 0 'submitted, to a node that will die' slurm dark --submit
wait_for computed 6
node_down
wait_for stands 'down*' # the star: it does not answer
ok $? 'it dies in mid-study'
node_up
wait_for over
ok $? 'it comes back: Slurm starts its tasks again'
runs 0 'all points are done' points dark --collect
same here/results.csv dark/results.csv 'the same bytes'
[ "$(sort -n log | uniq | wc -l)" -eq 25 ] && [ "$(wc -l <log)" -le 29 ]
ok $? 'only what ran there was computed again'

seq 1001 | awk 'BEGIN { print "cable.area" } { print 6e-3 + $1*1e-6 }' >many.csv
runs 0 'an array as large as Slurm takes' study -d many --table many.csv --chunk 1 --submit \
    --slurm-option=--hold ./slow stay.ini
[ "$(squeue --noheader --array | wc -l)" -eq 1000 ]
ok $? 'has a thousand tasks'
scancel "$(cat many/job-*/submitted)"
finish
