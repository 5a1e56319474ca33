# What a study is: its command, its table and the contents of the files that it reads.
use strict;
use warnings;
our (%opt);

# Files below what was given, as real paths; symbolic links are followed.
sub files_below
{
    my ($path, $depth) = @_;
    return $path unless -d $path;
    $depth < 50 or refuse("$path: directories too deep, or in a circle");
    opendir my $dir, $path or refuse("$path: cannot be read: $!");
    return map { files_below("$path/$_", $depth + 1) } grep { !/\A\.\.?\z/ } sort readdir $dir;
}

# What the tool is run with: the command and the files that it names, all below one root so that
# relative paths between them hold at a host, too.  Returns the definition and the files.
sub define
{
    my ($names, $rows, @command) = @_;
    require Digest::SHA;
    require File::Basename;
    require File::Spec;
    my $real = sub {
        my $dir = Cwd::realpath(File::Basename::dirname($_[0]));
        defined $dir or refuse("$_[0]: cannot be found");
        return File::Spec->catfile($dir, File::Basename::basename($_[0]));
    };
    my $cwd = Cwd::getcwd();
    my @inputs = map { -e or refuse("--with $_: cannot be found"); files_below($real->($_), 0) }
        @{$opt{with} // []};
    for my $i (0 .. $#command) {
        my $word = $command[$i];
        next unless -f $word && ($i || $word =~ m{/});
        my $path = $real->($word);
        push @inputs, $path;
        next if $path eq File::Spec->canonpath("$cwd/$word"); # not so: absolute, .., through a link
        $command[$i] = File::Spec->abs2rel($path, $cwd);
        $command[$i] = "./$command[$i]" if $command[$i] =~ /\A-/ || !$i;
    }
    my @root = split m{/}, $cwd;
    for my $path (@inputs) {
        my @parts = split m{/}, $path;
        my $same = 0;
        $same++ while $same < @root && $same < $#parts && $root[$same] eq $parts[$same];
        $#root = $same - 1;
    }
    my $root = join('/', @root) || '/';
    my %seen;
    my @files = map { [File::Spec->abs2rel($_, $root), (stat)[2] & 0777, eval { slurp($_) }
        // refuse($@ =~ s/\n//r)] } grep { !$seen{$_}++ } sort @inputs;
    my $table = join "\n", csv_line(@$names), @$rows, '';
    my $definition = join '', map { escape($_) . "\n" }
        'seilwerk-study 1', map({ "word $_" } @command),
        'directory ' . File::Spec->abs2rel($cwd, $root), 'columns ' . csv_line(@$names),
        'points ' . @$rows, 'table ' . Digest::SHA::sha256_hex($table),
        map { sprintf 'file %s: %o %s', @$_[0, 1], Digest::SHA::sha256_hex($_->[2]) } @files;
    return ($definition, \@files, $table);
}

# Refuses another study in the same directory, and says in what it differs.
sub compare_definitions
{
    my ($there, $here) = @_;
    return if $there eq $here;
    my %was = map { $_ => 1 } split /\n/, $there;
    my %is = map { $_ => 1 } split /\n/, $here;
    my @gone = map { unescape($_) } grep { !$is{$_} } split /\n/, $there;
    my @new = map { unescape($_) } grep { !$was{$_} } split /\n/, $here;
    # of files and tables the names tell enough
    s/\A(file .*): \d+ \w+\z/$1 (its contents)/, s/\Atable \w+\z/the cells of the table/
        for @gone, @new;
    my %both = map { $_ => 1 } @gone;
    my @text = map { $both{$_} ? "differs: $_" : "now: $_" } @new;
    %both = map { $_ => 1 } @new;
    push @text, map { "was: $_" } grep { !$both{$_} } @gone;
    push @text, 'the order of the words' unless @text;
    refuse("$opt{shown}: holds another study:\n" . join("\n", map { "  $_" } @text) .
        "\nTake another directory, or the command of that study.");
}

1;
