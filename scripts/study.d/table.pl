# Tables of variations from a file or a grid: the names of the columns, and the cells of each point
# as a line of CSV.
use strict;
use warnings;
our ($number);

sub check_names
{
    my ($where, @names) = @_;
    my %seen;
    for (@names) {
        /\S/ or refuse("$where: a column has no name; SECTION.KEY is expected");
        $_ ne 'point' or refuse("$where: the name 'point' is taken: it numbers the results");
        !/[\r\n]/ or refuse("$where: a name holds a line break");
        !$seen{$_}++ or refuse("$where: '$_' is there twice");
    }
}

sub table_from_file
{
    my $file = shift;
    my $in = \*STDIN;
    $file eq '-' or open $in, '<:raw', $file or refuse("$file: cannot be opened: $!");
    my (@names, @rows);
    while (defined(my $record = csv_record($in))) {
        $record =~ s/^\xef\xbb\xbf// unless @names;
        next if $record eq '';
        my @cells = csv_cells($record) or refuse("$file:$.: the quotes are wrong");
        $record !~ /\n/ or refuse("$file:$.: a cell holds a line break");
        if (!@names) {
            $record !~ /;/ || @cells > 1 or refuse("$file:$.: semicolons; commas are expected");
            check_names("$file:$.", @names = @cells);
        } else {
            @cells == @names
                or refuse("$file:$.: ${\ scalar @cells} cells; the header has ${\ scalar @names}");
            push @rows, csv_line(@cells);
        }
    }
    @names or refuse("$file: is empty; a header line is expected");
    return (\@names, \@rows);
}

# KEY=WHAT of an option.
sub key_and_values
{
    my ($option, $text) = @_;
    $text =~ /\A([^=]*\S)\s*=(.*)\z/s or refuse("--$option $text: expected KEY=VALUES");
    my ($key, $values) = ($1, $2);
    check_names("--$option", $key);
    return ($key, $values);
}

# Values of one word of a grid: FROM:TO:STEP, or itself.
sub spread
{
    my ($word, $where) = @_;
    return $word unless $word =~ /\A$number(?::$number)+\z/;
    my ($from, $to, $step, @more) = split /:/, $word;
    defined $step && !@more or refuse("$where: '$word': expected FROM:TO:STEP");
    $step != 0 && ($to - $from)/$step >= 0
        or refuse("$where: '$word': the step does not lead from $from to $to");
    my $steps = ($to - $from)/$step*(1 + 1e-12) + 1e-9;
    $steps < 1e7 or refuse("$where: '$word': too many values");
    return map {
        my $x = $from + $_*$step;
        sprintf '%.12g', abs $x < 1e-9*abs $step ? 0 : $x # a zero is one, not what is left of it
    } 0 .. int $steps;
}

# All combinations, the last column changes fastest.  The same for the words within one value.
sub combine
{
    my ($glue, @lists) = @_;
    my @all = ('');
    for my $i (0 .. $#lists) {
        my $before = $i ? $glue : '';
        @all*@{$lists[$i]} <= 1e7 or refuse('more than 1e7 points');
        @all = map { my $head = $_; map { "$head$before$_" } @{$lists[$i]} } @all;
    }
    return @all;
}

sub table_from_grid
{
    my (@names, @lists);
    for my $text (@_) {
        my ($key, $values) = key_and_values('grid', $text);
        push @names, $key;
        my @values = map { combine(' ', map { [spread($_, "--grid $key")] } split ' ') }
            split /,/, $values, -1;
        push @lists, [@values ? map({ csv_quote($_) } @values) : ('')];
    }
    check_names('--grid', @names);
    return (\@names, [map { $_ eq '' ? '""' : $_ } combine(',', @lists)]);
}

1;
