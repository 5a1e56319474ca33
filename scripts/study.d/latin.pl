# Tables of variations as Latin hypercubes, the same on every machine.
use strict;
use warnings;
our ($number);

# MRG32k3a (L'Ecuyer, Operations Research 47, 1999): exact in double precision, so that a seed
# gives the same table everywhere.  Its six numbers come from the seed by the minimal standard
# generator, whose products are exact, too.
{
    my @state;

    sub modulo
    {
        my ($x, $m) = @_;
        $x -= $m*int($x/$m);
        return $x < 0 ? $x + $m : $x;
    }

    sub seed
    {
        my $x = 1 + shift;
        @state = map { $x = modulo(16807*$x, 2147483647) } 1 .. 6;
    }

    # Uniform, inside (0, 1).
    sub draw
    {
        my $one = modulo(1403580*$state[1] - 810728*$state[0], 4294967087);
        my $two = modulo(527612*$state[5] - 1370589*$state[3], 4294944443);
        @state = (@state[1, 2], $one, @state[4, 5], $two);
        return ($one > $two ? $one - $two : $one - $two + 4294967087)/4294967088;
    }
}

# One number of (0, 1) in each of n strata, in random order.
sub strata
{
    my $n = shift;
    my @order = 0 .. $n - 1;
    for my $i (reverse 1 .. $n - 1) {
        my $j = int(draw()*($i + 1));
        @order[$i, $j] = @order[$j, $i];
    }
    return map { my $x = ($_ + draw())/$n; $x < 1 ? $x : 1 - 2**-53 } @order;
}

# The x that a standard normal number exceeds with probability q <= 1/2: a start that is good to
# 5e-4, then Halley's method on the tail, by its power series or its continued fraction.
sub tail
{
    my $q = shift;
    my $t = sqrt(-2*log $q);
    my $x = $t - (2.515517 + $t*(0.802853 + $t*0.010328)) /
        (1 + $t*(1.432788 + $t*(0.189269 + $t*0.001308)));
    for (1 .. 3) {
        my $density = exp(-$x*$x/2)/2.506628274631000502;
        my $above;
        if ($x < 2.5) {
            my ($sum, $term) = ($x, $x);
            for (my $k = 3; abs $term > 1e-17; $k += 2) {
                $sum += $term *= $x*$x/$k;
            }
            $above = 0.5 - $density*$sum;
        } else {
            $above = $x + 60/($x + 7);
            $above = $x + $_/$above for reverse 1 .. 59;
            $above = $density/$above;
        }
        my $newton = ($above - $q)/$density;
        $x += $newton/(1 - $x*$newton/2);
    }
    return $x;
}

sub table_from_latin
{
    my ($points, $seed, @vary) = @_;
    seed($seed);
    my (@names, @columns);
    for my $text (@vary) {
        my ($key, $values) = key_and_values('vary', $text);
        my ($random, @words) = (0);
        for my $word (split ' ', $values) {
            if ($word =~ /\A($number):($number)(:log)?\z/) {
                my ($from, $to, $log) = ($1, $2, $3);
                $from < $to or refuse("--vary $key: '$word': FROM must be less than TO");
                !$log || $from > 0 or refuse("--vary $key: '$word': a logarithm needs FROM > 0");
                push @words, [map { $log ? $from*($to/$from)**$_ : $from + ($to - $from)*$_ }
                    strata($points)];
            } elsif ($word =~ /\A($number)~($number)\z/) {
                my ($mean, $deviation) = ($1, $2);
                $deviation > 0 or refuse("--vary $key: '$word': the deviation must be positive");
                push @words, [map { $mean + $deviation*($_ < 0.5 ? -tail($_) : tail(1 - $_)) }
                    strata($points)];
            } else {
                $word =~ /\A$number\z/
                    or refuse("--vary $key: '$word': expected FROM:TO, FROM:TO:log or MEAN~SD");
                push @words, $word;
                next;
            }
            $random = 1;
            # twelve digits: what the last ones of exp and log are depends on the machine
            $_ = sprintf '%.12g', $_ for @{$words[-1]};
        }
        $random or refuse("--vary $key: '$values': expected FROM:TO, FROM:TO:log or MEAN~SD");
        push @names, $key;
        push @columns, \@words;
    }
    check_names('--vary', @names);
    return (\@names, [map { my $i = $_;
        join ',', map { join ' ', map { ref $_ ? $_->[$i] : $_ } @$_ } @columns
    } 0 .. $points - 1]);
}

1;
