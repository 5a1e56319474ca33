#!/bin/sh
# scripts/study over several hosts: three sshd on loopback, each with a home, a path and a temporary
# directory of its own, so that a shell does not read, nor a kill tear, what the user has at home.
# One is killed in mid-study with all that runs there, then all of them.
# Nothing outside the scratch directory is changed, but /run/sshd, which sshd insists on.
. "$(dirname "$0")/../tap.sh"
. "$top/tests/processes.sh"
for program in parallel rsync ssh-keygen /usr/sbin/sshd; do
    command -v "$program" >/dev/null || {
        skip "$program is missing"
        finish
    }
done
cd "$scratch" || exit 1
PATH=$top/scripts:$PATH
[ -d /run/sshd ] || [ "$(id -u)" -ne 0 ] || { mkdir /run/sshd && made=/run/sshd; }

# down HOST: its sshd and all that runs there, at one blow.
down()
{
    [ -s "$1/pid" ] || return 0
    kill_tree "$(cat "$1/pid")"
    rm -f "$1/pid"
}

all_down()
{
    for host in h1 h2 h3; do down $host; done
}
trap 'exit 143' INT TERM HUP
trap 'all_down; rmdir ${made:+"$made"} 2>/dev/null; rm -rf "$scratch"' EXIT

# up HOST: its sshd, at the port that it always had.
up()
{
    /usr/sbin/sshd -D -f "$scratch/$1/sshd_config" -E "$scratch/$1/log" </dev/null >/dev/null 2>&1 &
    echo $! >"$1/pid"
    for _ in 1 2 3 4 5 6 7 8 9 10; do
        ssh -F config "$1" true 2>/dev/null && return 0
        sleep 0.2
    done
    sed 's/^/# /' "$1/log"
    return 1
}

ports=$(perl -MIO::Socket::INET -e 'my @s = map { IO::Socket::INET->new(Listen => 1,
    LocalAddr => "127.0.0.1") // die "no port\n" } 1 .. 3; print join " ", map { $_->sockport } @s')
ssh-keygen -q -t ed25519 -N '' -f user
mkdir tools
for tool in catenary diffverf; do ln -s "$SEILWERK_BUILD/bin/$tool" tools; done
n=0
for port in $ports; do
    n=$((n + 1))
    mkdir -p h$n/tmp
    ssh-keygen -q -t ed25519 -N '' -f h$n/key
    cat >h$n/sshd_config <<END
ListenAddress 127.0.0.1
Port $port
HostKey $scratch/h$n/key
PidFile none
AuthorizedKeysFile $scratch/user.pub
StrictModes no
UsePAM no
PasswordAuthentication no
PermitRootLogin prohibit-password
MaxStartups 100
ForceCommand $scratch/h$n/enter
SetEnv HOME=$scratch/h$n
END
    cat >h$n/enter <<END
#!/bin/sh
cd '$scratch/h$n' || exit 1
TMPDIR=$scratch/h$n/tmp PATH=/usr/bin:/bin HOST=h$n
export TMPDIR PATH HOST
exec sh -c "\${SSH_ORIGINAL_COMMAND:-true}"
END
    chmod +x h$n/enter
    cat >>config <<END
Host h$n
    Port $port
END
    echo "[127.0.0.1]:$port $(cut -d' ' -f1,2 h$n/key.pub)" >>known
done
cat >>config <<END
Host *
    HostName 127.0.0.1
    IdentityFile $scratch/user
    IdentitiesOnly yes
    UserKnownHostsFile $scratch/known
    StrictHostKeyChecking yes
    BatchMode yes
    LogLevel ERROR
END

# A tool of the user's own that goes over to the hosts, with what the case needs: it takes its time,
# and tells where it computed which point.
mkdir 'my case'
sed 's/^end = .*/end = 5/' "$top/scripts/experiments/ben-ahin/case.ini" >'my case/stay.ini'
mkdir 'my case/model'
echo 0.1 >'my case/model/pause'
cat >'my case/slow' <<'END'
#!/bin/sh
sleep "$(cat 'my case/model/pause')"
echo "$SEILWERK_POINT ${HOST:-here}" >>"$(cat 'my case/log')"
exec catenary --summary "$@"
END
echo "$scratch/log" >'my case/log'
chmod +x 'my case/slow'

# over DIR [OPTION...]: the study in DIR.
over()
{
    directory=$1
    shift
    study -d "$directory" --grid 'cable.area=6e-3:10e-3:1e-4' --grid 'cable.mass_per_length=60:64:1' \
        --chunk 4 --with 'my case/model' --with 'my case/log' "$@" \
        './my case/slow' 'my case/stay.ini'
}
hosts()
{
    over "$@" --tools "$scratch/tools" --sshlogin "2/ssh -F $scratch/config h1" \
        --sshlogin "2/ssh -F $scratch/config h2" --sshlogin "2/ssh -F $scratch/config h3"
}
# In the background; its process number is in $study.
start()
{
    hosts "$@" >out 2>err </dev/null &
    study=$!
}
# ends STATUS NAME: so it does.
ends()
{
    wait "$study"
    got=$?
    [ $got -eq "$1" ] || { echo "# status $got, wanted $1"; tail -n 20 err | sed 's/^/# /'; }
    [ $got -eq "$1" ]
    ok $? "$2"
}

# wait_for COMMAND...: at most a minute.
wait_for()
{
    for _ in $(seq 600); do
        "$@" && return 0
        sleep 0.1
    done
    return 1
}
computed() { [ -e log ] && [ "$(wc -l <log)" -ge "$1" ]; }

runs 0 'the study here, on the local cores' over here -j 2
[ "$(wc -l <here/results.csv)" -eq 206 ] && [ "$(grep -c here log)" -eq 205 ]
ok $? '205 points'

up h1 && up h2 && up h3
ok $? 'three hosts are up'
rm log
start whole
ends 0 'over three hosts'
same here/results.csv whole/results.csv 'the same bytes'
[ "$(sort -n log | cut -d' ' -f1 | uniq | wc -l)" -eq 205 ] && [ "$(wc -l <log)" -eq 205 ]
ok $? 'each point was computed once'
[ "$(cut -d' ' -f2 log | sort -u | tr '\n' ' ')" = 'h1 h2 h3 ' ]
ok $? 'each host had its part'
for host in h1 h2 h3; do find $host -path '*job-*' -o -path '*seilwerk*'; done >left
[ ! -s left ] || sed 's/^/# /' left
[ ! -s left ]
ok $? 'nothing is left at the hosts'

rm log
runs 0 'one host and this machine' over mixed --tools "$scratch/tools" -j 2 --sshlogin : \
    --sshlogin "ssh -F $scratch/config h1"
same here/results.csv mixed/results.csv 'the same bytes'
[ "$(cut -d' ' -f2 log | sort -u | tr '\n' ' ')" = 'h1 here ' ]
ok $? 'each had its part'

rm log
start killed
wait_for computed 40
ok $? 'the next study is under way'
down h2
ends 0 'one host is killed: the study ends well'
same here/results.csv killed/results.csv 'nothing is lost, nothing is there twice'
cut -d' ' -f1 log | sort -n | uniq >once
[ "$(wc -l <once)" -eq 205 ] && [ "$(wc -l <log)" -le 221 ]
ok $? 'only what ran there was computed again'
grep -q ' h2' log
ok $? 'the killed one had had its part'
up h2
ok $? 'the host comes back'

rm log
start dark
wait_for computed 40
all_down
ends 1 'all hosts are killed: status 1'
says ' not yet computed' 'is said'
done_points=$(($(wc -l <dark/results.csv) - 1))
undone=$(sed -n 's/.*, \([0-9]*\) not yet computed.*/\1/p' err)
[ $((done_points + undone)) -eq 205 ] && [ "$done_points" -gt 0 ] && [ "$undone" -gt 0 ]
ok $? 'done and undone are all points'
tail -n +2 dark/results.csv | cut -d, -f1 | sort >kept
rm log
runs 0 'the same study goes on here' study -d dark --grid 'cable.area=6e-3:10e-3:1e-4' \
    --grid 'cable.mass_per_length=60:64:1' --with 'my case/model' --with 'my case/log' -j 2 \
    './my case/slow' 'my case/stay.ini'
same here/results.csv dark/results.csv 'nothing is lost, nothing is there twice'
cut -d' ' -f1 log | sort >later
[ "$(wc -l <later)" -eq "$undone" ] && [ -z "$(comm -12 kept later)" ]
ok $? 'no finished point was computed again'
finish
