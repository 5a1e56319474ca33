# The pack: all that a host needs for any chunk of the study, in one file.
use strict;
use warnings;

sub escape { return $_[0] =~ s/\\/\\\\/gr =~ s/\n/\\n/gr }
sub unescape { return $_[0] =~ s/\\(.)/$1 eq 'n' ? "\n" : $1/gers }

# Pack: a line of sizes, the definition, the files, an index of 16 bytes a chunk, the chunks.
sub write_pack
{
    my ($file, $definition, $files, $chunks) = @_;
    my $bodies = join '', map { sprintf("%o %d %s\n", $_->[1], length $_->[2], escape($_->[0])) .
        $_->[2] } @$files;
    my $at = 0;
    my $index = sprintf "%15d\n", 0;
    $index .= sprintf "%15d\n", $at += length for @$chunks;
    write_whole($file, sub {
        my $out = shift;
        print $out join(' ', length $definition, length $bodies, scalar @$chunks), "\n",
            $definition, $bodies, $index, @$chunks;
    });
}

sub open_pack
{
    my $file = shift;
    open my $in, '<:raw', $file or die "$file: cannot be opened: $!\n";
    my %pack = (file => $file, in => $in);
    ($pack{definition_size}, $pack{files_size}, $pack{count}) =
        (<$in> // '') =~ /\A(\d+) (\d+) (\d+)\n/ or die "$file: is damaged\n";
    $pack{definition_at} = tell $in;
    $pack{files_at} = $pack{definition_at} + $pack{definition_size};
    $pack{index_at} = $pack{files_at} + $pack{files_size};
    $pack{chunks_at} = $pack{index_at} + 16*($pack{count} + 1);
    $pack{definition} = piece(\%pack, $pack{definition_at}, $pack{definition_size});
    return \%pack;
}

sub piece
{
    my ($pack, $at, $size) = @_;
    my $bytes;
    seek $pack->{in}, $at, 0;
    my $got = read $pack->{in}, $bytes, $size;
    defined $got && $got == $size or die "$pack->{file}: is cut short\n";
    return $bytes;
}

# Rows "POINT,CELLS" of chunk K.
sub pack_chunk
{
    my ($pack, $k) = @_;
    $k >= 1 && $k <= $pack->{count} or die "$pack->{file}: has no chunk $k\n";
    my ($from, $to) = split ' ', piece($pack, $pack->{index_at} + 16*($k - 1), 32);
    return split /\n/, piece($pack, $pack->{chunks_at} + $from, $to - $from);
}

1;
