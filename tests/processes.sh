# Sourced by tests that kill what they started, with all that it has started.
# shellcheck shell=sh

# below PID: it and all its descendants.
below()
{
    perl -e 'my %below;
        for (glob "/proc/[0-9]*/stat") {
            open my $in, "<", $_ or next;
            push @{$below{$2}}, $1 if (<$in> // "") =~ /^(\d+) \(.*\) \S (\d+)/s;
        }
        for (my $i = 0; $i < @ARGV; $i++) { push @ARGV, @{$below{$ARGV[$i]} // []} }
        print "@ARGV\n"' "$1"
}

# kill_tree PID: at one blow, so that nothing outlives it or starts anew.
kill_tree()
{
    for process in $(below "$1"); do kill -STOP "$process" 2>/dev/null; done
    for process in $(below "$1"); do kill -KILL "$process" 2>/dev/null; done
}
