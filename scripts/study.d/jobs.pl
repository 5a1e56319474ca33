# Who computes: GNU parallel, here or on hosts; or Slurm.
use strict;
use warnings;
our (%opt, $me);

sub hosts { return @{$opt{sshlogin} // []} + @{$opt{sshloginfile} // []} }

# Computes the chunks; returns the signal that stopped it, if one did.
sub run_parallel
{
    my ($job, @chunks) = @_;
    my ($id) = $job =~ m{([^/]+)\z};
    my @command = qw(parallel --plain -u --no-run-if-empty);
    push @command, '-j', $opt{j} if defined $opt{j};
    push @command, '--bar' if -t STDERR && !$opt{q};
    if (hosts()) {
        push @command, map { ('--sshlogin', $_) } @{$opt{sshlogin} // []};
        push @command, map { ('--sshloginfile', m{\A/|\A\.\.?\z} ? $_ : "$opt{cwd}/$_") }
            @{$opt{sshloginfile} // []};
        push @command, '--retries', $opt{retries} // 3, '--halt', 'soon,fail=10', '--cleanup',
            '--basefile', "$id/run", '--basefile', "$id/pack", '--return', "$id/done/{}";
    } else {
        push @command, '--retries', $opt{retries} if defined $opt{retries};
        push @command, '--halt', 'soon,fail=1';
    }
    # words that no shell changes
    push @command, join ' ', "perl $id/run --run {}", unpack 'H*', $opt{tools} // '';
    write_whole("$job/left", sub { my $out = shift; print $out map { "$_\n" } @chunks });
    my ($pid, $stopped);
    local @SIG{qw(INT TERM)} = (sub { $stopped = shift; kill 'INT', $pid if $pid }) x 2;
    my $nohup = ($SIG{HUP} // '') eq 'IGNORE';
    local $SIG{HUP} = $nohup ? 'IGNORE' : $SIG{INT};
    $pid = fork // fail("no process: $!");
    if (!$pid) {
        $SIG{$_} = 'DEFAULT' for qw(INT TERM);
        setpgrp if $nohup; # parallel takes up SIGHUP by itself, unless it does not come to it
        chdir $opt{d} and open STDIN, '<', "$job/left" and open STDOUT, '>&', \*STDERR
            and exec { $command[0] } @command;
        print STDERR "$me: parallel cannot be run: $!\n";
        require POSIX;
        POSIX::_exit(127);
    }
    kill 'INT', $pid if $stopped;
    1 until waitpid($pid, 0) == $pid || $!{ECHILD};
    unlink "$job/left";
    return $stopped;
}

sub shell_quote { return "'" . $_[0] =~ s/'/'\\''/gr . "'" }

# "1-3,7" for sorted numbers.
sub ranges
{
    my @ranges;
    for (@_) {
        if (@ranges && $ranges[-1][1] == $_ - 1) {
            $ranges[-1][1] = $_;
        } else {
            push @ranges, [$_, $_];
        }
    }
    return join ',', map { $_->[0] == $_->[1] ? $_->[0] : "$_->[0]-$_->[1]" } @ranges;
}

# Task t of T computes the chunks t, t + T, t + 2 T, ... unless they are done.  A thousand tasks are
# what Slurm takes unless it is configured otherwise.
sub sbatch_file
{
    my ($job, $all) = @_;
    my ($id) = $job =~ m{([^/]+)\z};
    my $tasks = $all->{count} < 1000 ? $all->{count} : 1000;
    my %with_work = map { ($_ - 1) % $tasks + 1 => 1 } @{$all->{undone}};
    return join '', map { "$_\n" } '#!/bin/sh',
        '#SBATCH --job-name=seilwerk-study',
        '#SBATCH --array=' . ranges(sort { $a <=> $b } keys %with_work),
        '#SBATCH --ntasks=1', '#SBATCH --cpus-per-task=1', '#SBATCH --output=/dev/null',
        map({ "#SBATCH $_" } @{$opt{'slurm-option'} // []}),
        '# ' . @{$all->{undone}} . " of $all->{count} chunks are to be computed.",
        "# What a task has to say is appended to $id/slurm.log.",
        'export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1',
        defined $opt{tools} ? 'export PATH=' . shell_quote($opt{tools}) . ':"$PATH"' : (),
        'cd ' . shell_quote($opt{d}) . ' || exit 1',
        "exec perl $id/run --task \"\$SLURM_ARRAY_TASK_ID\" $tasks >>$id/slurm.log 2>&1";
}

sub submit
{
    my ($job, $all) = @_;
    my $earlier = -e "$job/submitted" ? slurp("$job/submitted") =~ s/\s//gr : '';
    $earlier =~ /\A\d*\z/ # a shell will read it
        or fail("$job/submitted: '$earlier': expected the number of an array");
    if ($earlier ne '') { # an array that is over is unknown to squeue, or has no lines
        my $lines = `squeue --noheader --format=%F --jobs=$earlier 2>&1`;
        fail("the array $earlier is still with Slurm; nothing is submitted")
            if $lines =~ /^\s*$earlier\s*$/m;
        $? == 0 || $lines =~ /Invalid job id/
            or fail("squeue does not tell whether the array $earlier is over; " .
                'nothing is submitted: ' . $lines =~ s/\s+/ /gr);
        unlink grep { /\.part/ } glob_done($job); # of tasks that were killed as they wrote
    }
    write_whole("$opt{d}/study.sbatch", sbatch_file($job, $all));
    open my $sbatch, '-|', 'sbatch', '--parsable', "$opt{d}/study.sbatch" or fail("sbatch: $!");
    my $number = (<$sbatch> // '') =~ /\A(\d+)/ ? $1 : '';
    close $sbatch;
    $? == 0 && $number ne '' or fail('sbatch took no job');
    write_whole("$job/submitted", "$number\n");
    print STDERR "$me: submitted as job $number; the same command collects when it is over\n"
        unless $opt{q};
}

1;
