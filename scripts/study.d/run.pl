# What runs at a host: the tool on the points of one chunk.  With common.pl and pack.pl it is the
# file "run" of a job.
use strict;
use warnings;
our ($me);

my ($child, $scratch, $stopped) = (0);

sub unpack_files
{
    my ($pack, $to) = @_;
    my $bytes = piece($pack, $pack->{files_at}, $pack->{files_size});
    open my $in, '<:raw', \$bytes or die "files: $!\n";
    while (defined(my $line = <$in>)) {
        my ($mode, $size, $name) = $line =~ /\A(\d+) (\d+) (.*)\n/ or die "files: are damaged\n";
        my $body;
        read $in, $body, $size;
        my $path = "$to/" . unescape($name);
        File::Path::make_path($path =~ s{/[^/]*\z}{}r);
        open my $out, '>:raw', $path or die "$path: $!\n";
        print $out $body and close $out or die "$path: cannot be written: $!\n";
        chmod oct $mode, $path;
    }
}

# Runs a command with nothing on stdin.  Returns its wait status, stdout and stderr.
sub run_tool
{
    my ($dir, @command) = @_;
    die "stopped by SIG$stopped\n" if $stopped;
    my ($out, $to_out, $trouble, $to_trouble);
    pipe $out, $to_out or die "no pipe: $!\n";
    pipe $trouble, $to_trouble or die "no pipe: $!\n";
    $child = fork // die "no process: $!\n";
    if (!$child) {
        $SIG{$_} = 'DEFAULT' for qw(INT TERM HUP);
        if (chdir $dir and open STDIN, '<', '/dev/null' and open STDOUT, '>&', $to_out
            and open STDERR, '>', "$scratch/stderr") {
            no warnings 'exec';
            exec { $command[0] } @command;
        }
        syswrite $to_trouble, "$command[0]: cannot be run: $!";
        require POSIX;
        POSIX::_exit(127);
    }
    close $to_out;
    close $to_trouble;
    binmode $out;
    my $printed = do { local $/; <$out> } // '';
    my $why = do { local $/; <$trouble> } // '';
    waitpid $child, 0;
    my $status = $?;
    $child = 0;
    # The host or the study is at its end, not the point; the same if there is no such tool.
    die "$why\n" if $why ne '';
    my $signal = $status & 127;
    die "the tool was stopped by signal $signal\n" if grep { $signal == $_ } 1, 2, 15;
    sleep 2 if $signal == 9; # a host that is killed: this process is the next
    return ($status, $printed, eval { slurp("$scratch/stderr") } // '');
}

# What a tool said, on one line and without our names of its files.
sub plain
{
    my ($said) = @_;
    $said =~ s/\Q$scratch\E\/(?:files\/)?//g;
    $said =~ s/\s+\z//;
    $said =~ s/\n(?=\S)/; /g;
    $said =~ s/\s+/ /g;
    return $said;
}

# Why a point has no result: the last message, with the lines that continue it.
sub reason
{
    my ($status, $said) = @_;
    my $message = '';
    $said = substr $said, -4000 if length $said > 4000;
    for (reverse grep { /\S/ } split /\n/, $said) {
        $message = $message eq '' ? $_ : "$_ $message";
        last if /\A\S/;
    }
    $message = plain($message);
    return $message if $message ne '' && !($status & 127);
    my $how = $status & 127 ? 'killed by signal ' . ($status & 127) : 'failed without a message';
    return $message eq '' ? $how : "$how: $message";
}

# Splits what a tool printed: names of its own columns, and its records without the columns that
# repeat the variations.
sub own_columns
{
    my ($printed, $names) = @_;
    my %varied = map { $_ => 1 } @$names;
    open my $in, '<:raw', \$printed or die "$!\n";
    my $header = csv_record($in);
    my @names = defined $header ? csv_cells($header) : ();
    @names or die "it printed no CSV with a header\n";
    my @keep = grep { !$varied{$names[$_]} } 0 .. $#names;
    @keep or die "it printed no columns but those of the table\n";
    my @records;
    while (defined(my $record = csv_record($in))) {
        my $quick = @keep == @names && index($record, '"') < 0;
        my @cells = $quick ? () : csv_cells($record);
        my $cells = $quick ? 1 + ($record =~ tr/,//) : @cells;
        $cells == @names
            or die "line $. of its output has $cells cells; its header has ${\ scalar @names}\n";
        push @records, $quick ? $record : csv_line(@cells[@keep]);
    }
    return (csv_line(@names[@keep]), @records);
}

# One process a point.
sub compute_points
{
    my ($put, $dir, $command, $names, @rows) = @_;
    for (@rows) {
        my ($point, $row) = /\A(\d+),(.*)\z/s;
        my @cells = csv_cells($row);
        my @set = map { $names->[$_] eq 'name' ? () : ('--set', "$names->[$_]=$cells[$_]") }
            0 .. $#$names;
        $ENV{SEILWERK_POINT} = $point;
        my ($tool, @arguments) = @$command;
        my ($status, $printed, $said) = run_tool($dir, $tool, @set, @arguments);
        my ($header, @records) = $status ? () : eval { own_columns($printed, $names) };
        if (defined $header) {
            $put->('header', 0, 0, $header);
            $put->('said', $point, 0, plain($said)) if $said =~ /\S/;
            $put->('ok', $point, 0, join "\n", @records);
        } else {
            $put->('failed', $point, $status, $status ? reason($status, $said) : $@ =~ s/\n//r);
        }
    }
}

# One process for all points, which reads the table.
sub compute_table
{
    my ($put, $dir, $command, $names, @rows) = @_;
    my $table = "$scratch/table.csv";
    my @points = map { /\A(\d+),/ } @rows;
    open my $out, '>:raw', $table or die "$table: $!\n";
    print $out map { "$_\n" } csv_line(@$names), map { s/\A\d+,//r } @rows;
    close $out or die "$table: cannot be written: $!\n";
    my ($status, $printed, $said) = run_tool($dir, map { $_ eq '{}' ? $table : $_ } @$command);
    # Messages name the line of the chunk; the user has that of the whole table.
    my %why;
    $said =~ s{^(.*?)\Q$table\E:(\d+):(.*)}{
        my $point = $2 < 2 ? 0 : $points[$2 - 2] // 0; # 0: the header
        my $message = "$1table.csv:" . ($point + 1) . ":$3";
        $why{$point} = defined $why{$point} ? "$why{$point}; $message" : $message;
        $message;
    }gem;
    my $usable = !($status & 127) && $status >> 8 <= 1; # 1: some rows could not be used
    my ($header, @records) = $usable ? eval { own_columns($printed, $names) } : ();
    my $wrong = !$usable || !defined $header && $status ? reason($status, $said)
        : !defined $header ? $@ =~ s/\n//r
        : @records != @points ? "${\ scalar @records} rows for ${\ scalar @points} points" .
            ($status ? ': ' . reason($status, $said) : '') : '';
    $put->('header', 0, 0, $header) if $wrong eq '';
    for my $i (0 .. $#points) {
        if ($wrong ne '') {
            $put->('failed', $points[$i], $status, $wrong);
        } elsif ($records[$i] =~ /[^,"]/) {
            $put->('said', $points[$i], 0, plain($why{$points[$i]})) if defined $why{$points[$i]};
            $put->('ok', $points[$i], 0, $records[$i]);
        } else {
            $put->('failed', $points[$i], $status, $why{$points[$i]} // 'its result is empty');
        }
    }
}

# Computes chunk K of the job directory, unless it is done.
sub run_chunk
{
    my ($job, $k) = @_;
    return if -e "$job/done/$k";
    require File::Path;
    require File::Temp;
    my $pack = open_pack("$job/pack");
    my @definition = map { unescape($_) } split /\n/, $pack->{definition};
    my @command = map { /\Aword (.*)/s } @definition;
    my ($dir) = map { /\Adirectory (.*)/s } @definition;
    my @names = csv_cells(map { /\Acolumns (.*)/s } @definition);
    $scratch = File::Temp::mkdtemp(($ENV{TMPDIR} || '/tmp') . "/seilwerk-study-XXXXXXXXXX");
    $dir = "$scratch/files/$dir";
    unpack_files($pack, "$scratch/files");
    File::Path::make_path($dir);
    my ($outcome, $header) = ('', '');
    my $put = sub {
        my ($kind, $point, $status, $text) = @_;
        return if $kind eq 'header' && $text eq $header;
        $header = $text if $kind eq 'header';
        $outcome .= join(' ', $kind, $point, $status, length $text) . "\n$text\n";
    };
    my $table = grep { $_ eq '{}' } @command;
    ($table ? \&compute_table : \&compute_points)
        ->($put, $dir, \@command, \@names, pack_chunk($pack, $k));
    die "stopped by SIG$stopped\n" if $stopped;
    # Another job's clean-up may remove the directory as long as it is empty.
    my ($out, $part) = (undef, "$job/done/$k.part-$$");
    for (1 .. 100) {
        mkdir "$job/done";
        last if open $out, '>:raw', $part;
        $out = undef;
    }
    $out && print $out $outcome, "end\n" and close $out and rename $part, "$job/done/$k"
        or do { my $why = $!; unlink $part; die "$job/done/$k: cannot be written: $why\n" };
}

# --run CHUNK [TOOLS-IN-HEX]: of GNU parallel.  --task TASK TASKS: of a Slurm array.
sub at_host
{
    my ($mode, $k, $more) = @_;
    my ($job) = $0 =~ m{(.*)/};
    $ENV{OPENBLAS_NUM_THREADS} = $ENV{OMP_NUM_THREADS} = 1; # one core each
    $ENV{PATH} = pack('H*', $more) . ":$ENV{PATH}"
        if $mode eq '--run' && ($more // '') ne '' && ($ENV{PARALLEL_SSHLOGIN} // ':') ne ':';
    for my $signal (qw(INT TERM HUP)) {
        $SIG{$signal} = sub {
            $stopped = $signal; # for where an eval catches what follows
            kill 'TERM', $child if $child;
            die "stopped by SIG$signal\n";
        };
    }
    my $chunk = $k;
    my $done = eval {
        if ($mode eq '--run') {
            run_chunk($job, $k);
        } else {
            my $count = open_pack("$job/pack")->{count};
            for (; $chunk <= $count; $chunk += $more) {
                run_chunk($job, $chunk);
                File::Path::remove_tree($scratch), $scratch = undef if $scratch;
            }
        }
        1;
    };
    my $why = $@;
    $SIG{$_} = 'IGNORE' for qw(INT TERM HUP);
    File::Path::remove_tree($scratch) if defined $scratch && -d $scratch;
    return if $done;
    require Sys::Hostname;
    print STDERR "$me: chunk $chunk at ${\ Sys::Hostname::hostname()}: $why";
    exit 1;
}

1;
