#!/bin/sh
# Arrays of modal, and others in all forms of .npy, read by scripts/npy2csv and scripts/npyread.m:
# the same numbers; damaged files are refused.
. "$(dirname "$0")/../tap.sh"

runs 0 'modal writes a directory' modal --set mesh.elements=3 -d "$scratch/model" \
    -o "$scratch/modes.csv" "$top/scripts/experiments/ben-ahin/case.ini"

# npy FORMAT DESCR ORDER SHAPE NUMBERS: an array on stdout.
npy()
{
    perl -e 'my ($format, $descr, $order, $shape, @x) = @ARGV;
        my $header = "{\"descr\": \"$descr\", \"fortran_order\": $order, \"shape\": $shape, }";
        $header =~ tr/"/\x27/;
        $header .= " " x (63 - (length($header) + ($format == 1 ? 10 : 12)) % 64) . "\n";
        binmode STDOUT;
        print "\x93NUMPY", chr($format), "\0", pack($format == 1 ? "v" : "V", length $header),
            $header, pack("d<*", @x)' "$@"
}

# The matrix 1 2 3; 4 5 6 in all forms, a vector, an empty one, numbers at the edges of double.
mkdir "$scratch/forms"
for format in 1 2; do
    npy $format '<f8' True '(2, 3)' 1 4 2 5 3 6 >"$scratch/forms/f$format.npy"
    npy $format '<f8' False '(2, 3)' 1 2 3 4 5 6 >"$scratch/forms/c$format.npy"
    npy $format '<f8' False '(3,)' 7 8 9 >"$scratch/forms/vector$format.npy"
done
npy 1 '<f8' True '(0, 3)' >"$scratch/forms/empty.npy"
npy 1 '<f8' True '(1, 4)' 0.1 -1.7976931348623157e308 4.9e-324 0.30000000000000004 \
    >"$scratch/forms/edge.npy"

printf '1,2,3\n4,5,6\n' >"$scratch/matrix"
printf '7\n8\n9\n' >"$scratch/vector"
: >"$scratch/nothing"
for form in f1 f2 c1 c2; do
    runs 0 "npy2csv: $form" "$top/scripts/npy2csv" "$scratch/forms/$form.npy"
    same "$scratch/matrix" "$scratch/out" "npy2csv: $form: the matrix"
done
for form in vector1 vector2; do
    runs 0 "npy2csv: $form" "$top/scripts/npy2csv" "$scratch/forms/$form.npy"
    same "$scratch/vector" "$scratch/out" "npy2csv: $form: the vector"
done
runs 0 'npy2csv: empty array' "$top/scripts/npy2csv" "$scratch/forms/empty.npy"
same "$scratch/nothing" "$scratch/out" 'npy2csv: empty array: no line'
runs 0 'npy2csv: edges' "$top/scripts/npy2csv" "$scratch/forms/edge.npy"
echo '0.1,-1.7976931348623157e+308,4.94065645841247e-324,0.30000000000000004' >"$scratch/edge"
same "$scratch/edge" "$scratch/out" 'npy2csv: edges of double read back'
runs 2 'npy2csv: no operand' "$top/scripts/npy2csv"
says 'usage: npy2csv FILE.npy' 'npy2csv: usage'

# Damaged files, each with the words of the refusal.
mkdir "$scratch/broken"
head -c 7 "$scratch/forms/f1.npy" >"$scratch/broken/short.npy"
head -c 50 "$scratch/forms/f1.npy" >"$scratch/broken/header.npy"
head -c 170 "$scratch/forms/f1.npy" >"$scratch/broken/data.npy"
{ cat "$scratch/forms/f1.npy"; printf x; } >"$scratch/broken/more.npy"
npy 3 '<f8' True '(1,)' 1 >"$scratch/broken/format.npy"
npy 1 '>f8' True '(1,)' 1 >"$scratch/broken/endian.npy"
npy 1 '<f8' Maybe '(1,)' 1 >"$scratch/broken/order.npy"
npy 1 '<f8' True '(1, 1, 1)' 1 >"$scratch/broken/cube.npy"
echo 'theta_m,x1_m' >"$scratch/broken/text.npy"
for file in "$scratch"/broken/*.npy; do
    runs 2 "npy2csv refuses $(basename "$file")" "$top/scripts/npy2csv" "$file"
    says "$file" "npy2csv: the message names $(basename "$file")"
done

if ! octave-cli --version >/dev/null 2>&1; then
    skip 'no octave-cli here'
    finish
fi

# Each file as CSV by npyread, all digits; a damaged one gives the message instead.
cat >"$scratch/all.m" <<END
files = argv ();
for i = 1:numel (files)
  out = fopen ([files{i}, '.octave'], 'w');
  try
    [A, order] = npyread (files{i});
    fprintf (out, 'order %s\n', order);
    for row = A.'
      cells = sprintf (',%.17g', row);
      fprintf (out, '%s\n', cells(2:end));
    end
  catch failure
    fprintf (out, '%s\n', failure.message);
  end
  fclose (out);
end
END
runs 0 'octave reads all files' \
    octave-cli --norc --no-history --path "$top/scripts" "$scratch/all.m" \
    "$scratch"/model/*.npy "$scratch"/forms/*.npy "$scratch"/broken/*.npy

# equal FILE FILE: the same cells, as doubles; some there, unless both are empty.
equal()
{
    awk -F, '
        NR == FNR { rows = FNR; cells[FNR] = $0; next }
        {
            n = split(cells[FNR], cell, ",")
            if (n != NF) bad = 1
            for (i = 1; i <= NF; i++)
                if (cell[i] != $i && cell[i] + 0 != $i + 0) bad = 1
            other = FNR
        }
        END { exit bad || rows != other }' "$1" "$2"
}

for file in "$scratch"/model/*.npy "$scratch"/forms/*.npy; do
    "$top/scripts/npy2csv" "$file" >"$scratch/perl"
    sed 1d "$file.octave" >"$scratch/octave"
    equal "$scratch/perl" "$scratch/octave"
    ok $? "octave and npy2csv read the same from $(basename "$file")"
done
for form in c1 c2 vector1; do
    [ "$(head -n 1 "$scratch/forms/$form.npy.octave")" = 'order C' ]
    ok $? "npyread: order of $form"
done
for file in "$scratch/model/mass.npy" "$scratch/forms/f2.npy"; do
    [ "$(head -n 1 "$file.octave")" = 'order F' ]
    ok $? "npyread: order of $(basename "$file")"
done
for file in "$scratch"/broken/*.npy; do
    grep -q "^npyread: $file: ." "$file.octave"
    ok $? "npyread refuses $(basename "$file")"
done

finish
