# From the outcomes of the chunks to one table of results and one of failed points.
use strict;
use warnings;
our (%opt);

# Calls a function with each outcome of a chunk that is done: point, wait status (undef: all is
# well), header, records or the reason, what was said though all is well.
sub outcomes
{
    my ($file, $each) = @_;
    open my $in, '<:raw', $file or fail("$file: cannot be opened: $!");
    my ($header, $said) = ('', '');
    while (defined(my $line = <$in>)) {
        return if $line eq "end\n";
        my ($kind, $point, $status, $size) = $line =~ /\A(\w+) (\d+) (\d+) (\d+)\n/ or last;
        my $text;
        my $got = read $in, $text, $size + 1;
        last unless $got && $got == $size + 1;
        chop $text;
        if ($kind eq 'header') {
            $header = $text;
        } elsif ($kind eq 'said') {
            $said = $text;
        } else {
            $each->($point, $kind eq 'ok' ? undef : $status, $header, $text, $said);
            $said = '';
        }
    }
    fail("$file: is damaged; remove it, and its points are computed again");
}

# Which points are done, failed, or still to be computed.  The chunks of a first run hold all points
# in order; those of --retry-failed follow, and count in place of the earlier ones.
sub survey
{
    my ($job, $points) = @_;
    my $pack = open_pack("$job/pack");
    my %all = (owner => [], undone => [], headers => [], failed => [], warned => 0, first => 0);
    my (%missing, $last, %header);
    for my $k (1 .. $pack->{count}) {
        my @points = map { /\A(\d+)/ } pack_chunk($pack, $k);
        $last = $points[-1], $all{first} = $k if ($last // 0) < $points[0];
        if (-e "$job/done/$k") {
            $all{owner}[$_] = $k, delete $missing{$_} for @points;
        } else {
            push @{$all{undone}}, $k;
            $missing{$_} = 1 for @points;
        }
    }
    my %late;
    each_owned($job, \%all, $all{first} + 1 .. $pack->{count}, sub { $late{$_[0]} = [@_] });
    $all{each} = sub {
        my $each = shift;
        for my $k (1 .. $all{first}) {
            next unless -e "$job/done/$k";
            outcomes("$job/done/$k", sub {
                return if $missing{$_[0]};
                $each->($all{owner}[$_[0]] == $k ? @_ : @{$late{$_[0]}});
            });
        }
    };
    $all{each}->(sub {
        my ($point, $status, $header, $text, $said) = @_;
        push @{$all{failed}}, $point if defined $status;
        $all{reason} //= "point $point: $text" if defined $status;
        $all{warned}++ if $said ne '';
        push @{$all{headers}}, $header unless defined $status || $header{$header}++;
    });
    $all{missing} = keys %missing;
    $all{count} = $pack->{count};
    return \%all;
}

sub each_owned
{
    my ($job, $all, @chunks) = @_;
    my $each = pop @chunks;
    for my $k (grep { -e "$job/done/$_" } @chunks) {
        outcomes("$job/done/$k", sub { $each->(@_) if $all->{owner}[$_[0]] == $k });
    }
}

# Columns of all headers in order of their first appearance; for each header where they come from.
sub unite
{
    my (@columns, %seen, %from);
    for my $header (@_) {
        push @columns, grep { !$seen{$_}++ } csv_cells($header);
    }
    for my $header (@_) {
        my @names = csv_cells($header);
        my %at = map { $names[$_] => $_ } 0 .. $#names;
        $from{$header} = csv_line(@names) eq csv_line(@columns) ? undef : [@at{@columns}];
    }
    return (\@columns, \%from);
}

# Writes DIR/NAME with the columns of the points and those that are named: what the function makes
# of each outcome, nothing if that is empty.
sub list_points
{
    my ($all, $names, $rows, $name, $columns, $cells) = @_;
    write_whole("$opt{d}/$name", sub {
        my $out = shift;
        print $out csv_line('point', @$names, @$columns), "\n";
        $all->{each}->(sub {
            my @cells = $cells->(@_) or return;
            print $out "$_[0],$rows->[$_[0] - 1],", csv_line(@cells), "\n";
        });
    });
}

# Writes results.csv (or FILE), failed.csv and warnings.csv.
sub collect
{
    my ($all, $names, $rows) = @_;
    my ($columns, $from) = unite(@{$all->{headers}});
    my $results = sub {
        my $out = shift;
        print $out csv_line('point', @$names, @$columns), "\n";
        $all->{each}->(sub {
            my ($point, $status, $header, $text) = @_;
            return if defined $status;
            my $head = "$point,$rows->[$point - 1]";
            my $map = $from->{$header};
            open my $in, '<:raw', \$text or fail("results: $!");
            while (defined(my $record = csv_record($in))) {
                my @cells = $map ? csv_cells($record) : ();
                $record = csv_line(map { defined $_ ? $cells[$_] : '' } @$map) if $map;
                print $out "$head,$record\n";
            }
        });
    };
    my $file = $opt{o} // "$opt{d}/results.csv";
    if ($file eq '-') {
        $results->(\*STDOUT);
        close STDOUT or fail("stdout: cannot be written: $!");
    } else {
        write_whole($file, $results);
    }
    unlink map { "$opt{d}/$_.csv" } qw(failed warnings);
    list_points($all, $names, $rows, 'failed.csv', ['status', 'reason'], sub {
        my ($point, $status, $header, $text) = @_;
        return unless defined $status;
        return ($status & 127 ? 'signal ' . ($status & 127) : $status >> 8, $text);
    }) if @{$all->{failed}};
    list_points($all, $names, $rows, 'warnings.csv', ['said'], sub { $_[4] ne '' ? $_[4] : () })
        if $all->{warned};
}

1;
