# Messages, files that are there whole or not at all, CSV.
use strict;
use warnings;
our ($me);

sub refuse { print STDERR "$me: @_\n"; exit 2 }
sub fail { print STDERR "$me: @_\n"; exit 1 }

# A file that is there whole or not at all.  It may be filled by a function or be given as text.
sub write_whole
{
    my ($file, $content) = @_;
    my $ok = open my $out, '>:raw', "$file.part";
    $ok &&= ref $content ? ($content->($out), 1) : print $out $content;
    return if $ok && !$out->error && close($out) && rename "$file.part", $file;
    my $why = $!;
    unlink "$file.part";
    fail("$file: cannot be written: $why");
}

sub slurp
{
    my $file = shift;
    open my $in, '<:raw', $file or die "$file: cannot be opened: $!\n";
    local $/;
    my $all = <$in>;
    defined $all or die "$file: cannot be read: $!\n";
    return $all;
}

# ---- CSV ----

# The next record, quoted line breaks included; its lines are counted in $..
sub csv_record
{
    my $in = shift;
    my $record = <$in>;
    return unless defined $record;
    while ($record =~ tr/"// % 2) {
        my $more = <$in>;
        last unless defined $more;
        $record .= $more;
    }
    $record =~ s/\r?\n\z//;
    return $record;
}

# Cells of a record; none if its quotes are wrong.
sub csv_cells
{
    my $record = shift;
    return ('') if $record eq '';
    return split /,/, $record, -1 if index($record, '"') < 0;
    my @cells;
    do {
        if ($record =~ /\G"([^"]*(?:""[^"]*)*)"(?=,|\z)/gc) {
            push @cells, $1 =~ s/""/"/gr;
        } elsif ($record =~ /\G([^",]*)(?=,|\z)/gc) {
            push @cells, $1;
        } else {
            return;
        }
    } while $record =~ /\G,/gc;
    return @cells;
}

sub csv_quote { return $_[0] =~ /[",\r\n]/ ? '"' . $_[0] =~ s/"/""/gr . '"' : $_[0] }

sub csv_line
{
    return '""' if @_ == 1 && $_[0] eq ''; # an empty line would be no record
    return join ',', map { csv_quote($_) } @_;
}

1;
