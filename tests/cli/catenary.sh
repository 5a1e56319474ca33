#!/bin/sh
# catenary beyond the line itself: summary, stiffness, tables, lengths found from forces, sags and
# frequencies, wind, ice and temperature; each against another way to the same number.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
cat >cable.ini <<END
[cable]
unstressed_length = 110.1897
mass_per_length = 64.8
youngs_modulus = 2.1e11
area = 8.26e-3
[supports]
span = 110.5
[mesh]
elements = 10
END
cat >slack.ini <<END
[cable]
unstressed_length = 130
mass_per_length = 2
axial_stiffness = 1e6
[supports]
span = 100
drop = 35
END
grep -v unstressed cable.ini >open.ini

# holds AWK-CONDITION FILE NAME: the condition over the columns of a table by name, c["sag_m", 1]
# in its first row.
holds()
{
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; columns = NF; next }
        { for (i = 1; i <= NF; i++) c[name[i], NR - 1] = $i; n = NR - 1 }
        function abs(x) { return x < 0 ? -x : x }
        function near(x, y, r) { return abs(x - y) <= r * abs(y) }
        END { exit !('"$1"') }' "$2"
    found=$?
    [ $found -eq 0 ] || sed 's/^/# /' "$2" | head -n 3
    ok $found "$3"
}

# value FILE COLUMN: the column's cell in the first row.
value()
{
    awk -F, -v c="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i }
        NR == 2 { print $k }' "$1"
}

# Summary.
columns=horizontal_force_N,vertical_left_N,vertical_right_N,tension_left_N,tension_mid_N,\
tension_right_N,sag_m,length_m,lambda2,unstressed_length_m,angle_left_rad,angle_right_rad,\
tension_min_N,tension_max_N,sag_max_m,sag_normal_m,sag_theta_m,sag_x1_m,sway_m,lateral_left_N,\
lateral_right_N,strain_max,slack_factor,frequency_out_Hz,frequency_symmetric_Hz,\
frequency_antisymmetric_Hz
runs 0 'summary' catenary --summary cable.ini
[ "$(head -n 1 out)" = "$columns" ]
ok $? 'summary: columns'
holds 'n == 1 && columns == 26 && near(c["tension_mid_N", 1], 4899.50e3, 1e-6) &&
    near(c["sag_m", 1], 0.1975, 2e-4) && c["unstressed_length_m", 1] == 110.1897' out \
    'summary: published midspan tension and sag'
holds 'c["angle_left_rad", 1] > 0 && near(c["angle_right_rad", 1], -c["angle_left_rad", 1], 1e-9) &&
    c["sway_m", 1] == 0 && c["lateral_left_N", 1] == 0 && c["lateral_right_N", 1] == 0 &&
    near(c["sag_max_m", 1], c["sag_m", 1], 1e-9) && near(c["sag_x1_m", 1], 55.25, 1e-9) &&
    near(c["tension_min_N", 1], c["horizontal_force_N", 1], 1e-12)' out \
    'summary: a level cable is symmetric'
holds 'near(c["frequency_out_Hz", 1] ^ 2 * 4 * 64.8 * 110.1897 * 110.5,
    c["horizontal_force_N", 1], 1e-9)' out 'summary: H = 4 m l^2 f^2'
runs 0 'summary: inclined and slack' catenary --summary slack.ini
holds 'near(c["vertical_left_N", 1] + c["vertical_right_N", 1], 2 * 9.81 * 130, 1e-12) &&
    near(c["tension_max_N", 1], c["tension_left_N", 1], 0) &&
    near(c["tension_min_N", 1], c["horizontal_force_N", 1], 1e-12) &&
    near(c["tension_left_N", 1] ^ 2,
        c["horizontal_force_N", 1] ^ 2 + c["vertical_left_N", 1] ^ 2, 1e-12) &&
    near(c["strain_max", 1], c["tension_max_N", 1] / 1e6, 1e-12) &&
    near(c["slack_factor", 1], 130 / sqrt(100 ^ 2 + 35 ^ 2), 1e-12)' out \
    'summary: reactions carry the weight; tensions, strain and slack'
cp out slack.csv
runs 0 'its line' catenary --set mesh.elements=2000 slack.ini
awk -F, 'NR == FNR { for (i = 1; i <= NF; i++) v[FNR, $i] = v[FNR, i] = $i
        if (FNR == 1) for (i = 1; i <= NF; i++) at[$i] = i; next }
    FNR > 1 { d = $3 - $2 * 0.35; if (d > most) { most = d; theta = $1; x = $2; a = $6 }
        if (FNR == 2) first = $6; last = $6 }
    function abs(x) { return x < 0 ? -x : x }
    END { exit !(abs(most - v[2, at["sag_max_m"]]) < 1e-4 &&
        abs(most * cos(atan2(35, 100)) - v[2, at["sag_normal_m"]]) < 1e-4 &&
        abs(theta - v[2, at["sag_theta_m"]]) < 0.1 && abs(x - v[2, at["sag_x1_m"]]) < 0.1 &&
        abs(first - v[2, at["angle_left_rad"]]) < 1e-12 &&
        abs(last - v[2, at["angle_right_rad"]]) < 1e-12) }' slack.csv out
ok $? 'summary: deepest point and angles are those of the line'

# Stiffness: central differences of the end forces; the same as .npy.
runs 0 'stiffness' catenary --stiffness slack.ini
[ "$(head -n 1 out)" = x1_N_m,x2_N_m,x3_N_m ] && [ "$(wc -l <out)" -eq 4 ]
ok $? 'stiffness: three rows under a header'
cp out stiffness.csv
runs 0 'stiffness as .npy' catenary --stiffness -o stiffness.npy slack.ini
"$top/scripts/npy2csv" stiffness.npy >plain.csv
sed 1d stiffness.csv | paste -d, - plain.csv |
    awk -F, '$1 != $4 || $2 != $5 || $3 != $6 { bad = 1 } END { exit bad || NR != 3 || NF != 6 }'
ok $? 'stiffness: .npy holds the same numbers'

# differences CASE SPAN DROP WIND1 WIND2 WIND3: stiffness of the right end by moving it along the
# axes.  Sideways the chord, the axes and the wind are turned about the vertical by the angle of the
# chord, and the forces back.
differences()
{
    for axis in 1 2 3; do
        for side in -1 1; do
            set_by=$(awk -v a=$axis -v s=$side -v l="$2" -v h="$3" -v w1="$4" -v w2="$5" -v w3="$6" '
                BEGIN { d = 1e-3 * s; if (a == 1) l += d; if (a == 2) h += d
                    r = a == 3 ? atan2(d, l) : 0; if (a == 3) l = sqrt(l * l + d * d)
                    printf "%.17g %.17g %.17g %.17g %.17g %.17g\n", r, l, h,
                        w1 * cos(r) + w3 * sin(r), w2, w3 * cos(r) - w1 * sin(r) }')
            # shellcheck disable=SC2086
            set -- "$1" "$2" "$3" "$4" "$5" "$6" $set_by
            catenary --summary --set supports.span="$8" --set supports.drop="$9" \
                --set load.wind="${10} ${11} ${12}" "$1" |
                awk -F, -v r="$7" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
                    NR == 2 { print r, $at["vertical_right_N"], $at["lateral_right_N"],
                        $at["tension_right_N"] }' >>moved
            set -- "$1" "$2" "$3" "$4" "$5" "$6"
        done
    done
    awk '{ y = -$2; z = -$3; x = sqrt($4 ^ 2 - y ^ 2 - z ^ 2)
            f[NR, 1] = x * cos($1) - z * sin($1); f[NR, 2] = y
            f[NR, 3] = x * sin($1) + z * cos($1) }
        END { print "x1_N_m,x2_N_m,x3_N_m"
            for (i = 1; i <= 3; i++) printf "%.17g,%.17g,%.17g\n", (f[2, i] - f[1, i]) / 2e-3,
                (f[4, i] - f[3, i]) / 2e-3, (f[6, i] - f[5, i]) / 2e-3 }' moved
    rm moved
}
differences slack.ini 100 35 0 0 0 >moved.csv
"$compare" -r 1e-6 -a 1e-4 stiffness.csv moved.csv
ok $? 'stiffness: central differences of the end forces'
runs 0 'stiffness in the wind' catenary --stiffness --set load.wind='3 -5 14' slack.ini
cp out stiffness.csv
differences slack.ini 100 35 3 -5 14 >moved.csv
"$compare" -r 1e-6 -a 1e-4 stiffness.csv moved.csv
ok $? 'stiffness: central differences in space, with wind'
awk -F, 'NR > 1 { for (i = 1; i <= 3; i++) k[NR - 1, i] = $i }
    END { for (i = 1; i <= 3; i++) for (j = 1; j < i; j++) {
        d = k[i, j] - k[j, i]; if (d * d > 1e-18 * k[1, 1] ^ 2) exit 1 }
        exit !(k[1, 3] != 0) }' stiffness.csv
ok $? 'stiffness: symmetric, and with wind all nine couple'

# Loads.
runs 0 'ice' catenary --summary --set load.ice_mass_per_length=10 cable.ini
cp out a.csv
runs 0 'mass' catenary --summary --set cable.mass_per_length=74.8 cable.ini
"$compare" -r 1e-12 a.csv out
ok $? 'ice is more mass'
runs 0 'wind straight down' catenary --summary --set load.wind='0 64.8 0' cable.ini
cp out a.csv
runs 0 'more gravity' catenary --summary --set gravity.acceleration=10.81 cable.ini
"$compare" -r 1e-11 a.csv out
ok $? 'wind straight down is more gravity'
runs 0 'a warm cable' catenary --summary --set load.temperature_change=40 \
    --set load.expansion_coefficient=1.2e-5 cable.ini
cp out a.csv
warm=$(awk 'BEGIN { printf "%.17g", 110.1897 * (1 + 40 * 1.2e-5) }')
runs 0 'a longer cable of the same mass' catenary --summary --set cable.unstressed_length="$warm" \
    --set cable.mass_per_length="$(awk 'BEGIN { printf "%.17g", 64.8 / (1 + 40 * 1.2e-5) }')" \
    cable.ini
"$compare" -r 1e-9 -c "$(echo "$columns" | sed 's/unstressed_length_m,//')" a.csv out
ok $? 'a change of temperature is another length'
[ "$(value a.csv unstressed_length_m)" = 110.1897 ]
ok $? 'unstressed_length_m counts before the expansion'

# Wind across: the cable hangs in an inclined plane as under its whole load.
w=900
g=$(awk -v w=$w 'BEGIN { printf "%.17g", sqrt(9.81 ^ 2 + (w / 64.8) ^ 2) }')
runs 0 'wind across' catenary --summary --set load.wind="0 0 $w" cable.ini
cp out a.csv
runs 0 'the plane case' catenary --summary --set gravity.acceleration="$g" cable.ini
"$compare" -r 1e-12 -c horizontal_force_N,tension_left_N,tension_mid_N,tension_right_N,length_m,\
lambda2,tension_max_N,sag_normal_m,strain_max,frequency_out_Hz,frequency_symmetric_Hz a.csv out
ok $? 'wind across: forces, sag and frequencies of the rotated plane case'
holds "near(c[\"lateral_left_N\", 1] + c[\"lateral_right_N\", 1], $w * 110.1897, 1e-12) &&
    near(c[\"vertical_left_N\", 1] + c[\"vertical_right_N\", 1], 64.8 * 9.81 * 110.1897, 1e-12) &&
    near(c[\"sway_m\", 1] / c[\"sag_m\", 1], $w / 64.8 / 9.81, 1e-12) &&
    near(c[\"sway_m\", 1] ^ 2 + c[\"sag_m\", 1] ^ 2, c[\"sag_normal_m\", 1] ^ 2, 1e-12)" a.csv \
    'wind across: the supports carry wind and weight'
catenary --set load.wind="0 0 $w" cable.ini >a.csv
catenary --set gravity.acceleration="$g" cable.ini >b.csv
paste -d, a.csv b.csv | awk -F, -v w=$w 'BEGIN { r = atan2(w / 64.8, 9.81) } NR > 1 {
    if (($2 - $9) ^ 2 > 1e-24 * $9 ^ 2 || ($3 - $10 * cos(r)) ^ 2 > 1e-26 ||
        ($7 - $10 * sin(r)) ^ 2 > 1e-26 || ($4 / $11 - 1) ^ 2 > 1e-24) bad = 1 }
    END { exit bad || NR != 12 }'
ok $? 'wind across: the line is the plane one, turned'
catenary --set load.wind="0 0 -$w" cable.ini | awk -F, 'NR > 1 { sub(/^-/, "", $7) } 1' OFS=, >b.csv
same a.csv b.csv 'wind from the other side: the mirror image'

# Found lengths: put back; told by -v, by the summary and by --print-case.
for given in horizontal_force=3e6 midspan_tension=4e6 tension_left=4e6 tension_right=4.1e6 \
    sag=0.25 fundamental_frequency=1.25 frequency=1.25; do
    key=${given%=*}
    runs 0 "$key given" catenary --summary -v --set cable.$given open.ini
    length=$(value out unstressed_length_m)
    case $key in
    midspan_tension) column=tension_mid_N ;;
    horizontal_force | tension_*) column=${key}_N ;;
    sag) column=sag_m ;;
    *) column= ;;
    esac
    if [ -n "$column" ]; then # 1e-12, and a place of the length is EA eps, 4e-7 N
        holds "near(c[\"$column\", 1], ${given#*=}, 2e-12)" out "$key: the cable has it"
    else
        modal --modes 1 --set cable.unstressed_length="$length" open.ini >modes.csv
        holds 'near(c["frequency_Hz", 1], 1.25, 1e-9) && c["plane", 1] == "out"' modes.csv \
            "$key: modal finds the frequency on the found cable"
        modal --modes 1 --set cable.$given open.ini >modes.csv
        holds 'near(c["frequency_Hz", 1], 1.25, 1e-9)' modes.csv "$key: and on the case itself"
        holds 'near(c["horizontal_force_N", 1],
            4 * 64.8 * c["unstressed_length_m", 1] * 110.5 * 1.25 ^ 2, 2e-4)' out \
            "$key: the force of the taut string, H = 4 m l^2 f^2"
    fi
    says "unstressed length $(printf '%.7s' "$length")" "$key: -v tells the length"
    runs 0 "$key printed" catenary --print-case --set cable.$given open.ini
    [ "$(sed -n 2p out)" = "unstressed_length = $length" ] && ! grep -q "^$key" out
    ok $? "$key: --print-case has the length in its place"
done
runs 0 'second frequency in the plane' modal --modes 6 --set cable.frequency=2.6 \
    --set cable.mode=2 --set cable.plane=in open.ini
awk -F, '$5 == "in" && ++n == 2 { f = $3 } END { exit !((f / 2.6 - 1) ^ 2 < 1e-18) }' out
ok $? 'frequency: of its mode and plane'
grep -v unstressed slack.ini >open-slack.ini
runs 0 'the tauter of two' catenary --summary --set cable.tension_left=1950 open-slack.ini
taut=$(value out unstressed_length_m)
runs 0 'the slacker of two' catenary --summary --set cable.tension_left=1950 \
    --set cable.branch=slack open-slack.ini
holds "near(c[\"tension_left_N\", 1], 1950, 1e-11) && c[\"unstressed_length_m\", 1] > $taut + 1" \
    out 'branch = slack: another cable with the same tension'
runs 0 'given with wind and heat' catenary --summary --set cable.sag=12 --set load.wind='2 1 15' \
    --set load.temperature_change=35 --set load.expansion_coefficient=1.2e-5 open-slack.ini
holds 'near(c["sag_m", 1], 12, 1e-12)' out 'sag: under the load'
runs 1 'a tension too small' catenary --summary --set cable.tension_left=700 open-slack.ini
least=$(sed -n 's/.*no length gives 700; the least possible is //p' err)
runs 0 'the least value named' catenary --summary --set cable.tension_left="$least" open-slack.ini
runs 1 'a little less' catenary --summary --set cable.tension_left="$(awk -v x="$least" \
    'BEGIN { printf "%.12g", x * (1 - 1e-8) }')" open-slack.ini
[ ! -s out ]
ok $? 'infeasible: no result'

# Tables.
cat >table.csv <<END
name,span,supports.drop,unstressed_length,sag,mass_per_length,axial_stiffness
A1,110.5,,110.1897,,64.8,1734600000
"B, 2",100,35,130,,2,1e6
C,100,35,,12,2,1e6
END
runs 0 'table' catenary --table table.csv
[ "$(head -n 1 out)" = "$(head -n 1 table.csv),$columns" ]
ok $? 'table: its columns, then those of the summary'
[ ! -s err ]
ok $? 'table: name gives no warning'
holds 'n == 3 && c["sag", 3] == 12' out 'table: all rows'
sed 1d out | cut -d, -f8- >a.csv
catenary --summary cable.ini | sed 1d >b.csv
catenary --summary slack.ini | sed 1d >>b.csv
catenary --summary --set cable.sag=12 open-slack.ini | sed 1d >>b.csv
sed -i '2s/^[^,]*,//' a.csv # the quoted name holds a comma
same a.csv b.csv 'table: rows are the summaries of the cases'
cp out whole.csv
sed -n 3p out | grep -q '^"B, 2",100,'
ok $? 'table: a quoted cell is quoted again'
catenary --table <table.csv >out
same whole.csv out 'table: from standard input'
catenary --table - <table.csv >out
same whole.csv out 'table: from -'
runs 0 'table: -o' catenary --table -o o.csv table.csv
same whole.csv o.csv 'table: -o writes the same'
sed 's/$/\r/; 1s/^/\xef\xbb\xbf/' table.csv | catenary --table >out
same whole.csv out 'table: CR LF and a byte order mark'
printf 'span,drop,unstressed_length\n110.5,,110.1897\n100,35,130\n' >b.csv
runs 0 'table: --set' catenary --table --set cable.mass_per_length=2 \
    --set cable.axial_stiffness=1e6 --set supports.drop=7 b.csv
holds 'near(c["vertical_left_N", 2] + c["vertical_right_N", 2], 2 * 9.81 * 130, 1e-12) &&
    c["angle_left_rad", 1] + c["angle_right_rad", 1] > 0.1' out \
    'table: --set gives defaults for missing columns and empty cells'

printf 'spann,unstressed_length,mass_per_length,axial_stiffness\n100,101,2,1e6\n' >slip.csv
runs 2 'table: a slip of the hand' catenary --table slip.csv
says "slip.csv:1: column 1: 'spann' is no key of a cable; is span meant?" 'is refused'
printf 'span,drop_m,unstressed_length,mass_per_length,axial_stiffness\n100,5,101,2,1e6\n' >slip.csv
runs 0 'table: a unit in a name' catenary --table slip.csv
says "column 2: 'drop_m' is no key of a cable, which has no unit in its name: drop; it is only copied" 'is told'
printf 'span,drop,drop_m,unstressed_length,mass_per_length,axial_stiffness\n100,5,5,1010,2,1e6\n' >slip.csv
runs 0 'table: a length of another cable' catenary --table slip.csv
says "column 3: 'drop_m' is no key of a cable; it is only copied" 'beside the key itself it is its own'
says 'slip.csv:2: the cable is 10.1 times as long as its chord: are the units right?' 'rows are doubted'
cat >bad.csv <<END
name,span,unstressed_length,mass_per_length,axial_stiffness,colour
ok,100,101,2,1e6,red
nan,nan,101,2,1e6,red
short,100,101
long,100,101,2,1e6,red,7

empty,,101,2,1e6,red
comma,"100,5",101,2,1e6,red
quote,100,101,2,1e6,"re"d
ok again,100,101,2,1e6,green
END
runs 1 'table with bad rows' catenary --table bad.csv
says "bad.csv:1: column 6: 'colour' is no key of a cable; it is only copied" 'table: one warning'
[ "$(grep -c 'only copied' err)" -eq 1 ]
ok $? 'table: for a column, not for its rows'
sed 1d err >messages
cat >wanted <<END
catenary: bad.csv:3: column 2: span: 'nan': not a number
catenary: bad.csv:4: 3 cells; the header has 6
catenary: bad.csv:5: 7 cells; the header has 6 (a decimal comma, or a text with commas that is not \
quoted?)
catenary: bad.csv:7: span: is missing
catenary: bad.csv:8: column 2: span: '100,5': a decimal point is expected, not a comma
catenary: bad.csv:9: a quote is wrong: a cell is either quoted as a whole, with "" for a quote \
inside, or not at all, and ends on its line
END
same wanted messages 'table: each bad row is told with its line'
awk -F, 'NR == 2 || NR == 9 { bad += $7 == "" || $32 == ""; next }
    NR > 2 { sub(/"[^"]*"/, ""); bad += NF != 32 || $7 != "" || $32 != "" } END { exit bad || NR != 9 }' out
ok $? 'table: results of bad rows are empty, the others whole'
sed -n 2p out | sed 's/^ok,/ok again,/; s/red/green/' >a.csv
sed -n 9p out >b.csv
same a.csv b.csv 'table: a row after bad ones is as good as before'
runs 1 'table: quiet' catenary -q --table bad.csv
[ "$(wc -l <err)" -eq 6 ]
ok $? 'table -q: no warning, but all errors'
printf 'span,unstressed_length,mass_per_length,axial_stiffness,tension_left\n100,,2,1e6,10\n' >a.csv
runs 1 'table: an infeasible row' catenary --table a.csv
says 'a.csv:2: tension_left: no length gives 10; the least possible is ' 'with the least value'
printf 'span;unstressed_length\n100;101\n' >a.csv
runs 2 'table: semicolons' catenary --table a.csv
says "a.csv:1: columns are separated by ';'" 'are named'
: >a.csv
runs 2 'table: empty file' catenary --table a.csv
says 'a.csv: is empty; a header line is expected' 'is told'
sed 1d table.csv >a.csv
runs 2 'table: no header' catenary --table a.csv
says 'a.csv:1: no column is a key of a cable; a header line is expected' 'is told'
[ "$(wc -l <err)" -eq 1 ]
ok $? 'in one line'
head -n 1 table.csv >a.csv
runs 0 'table: a header only' catenary --table a.csv
[ "$(cat out)" = "$(head -n 1 whole.csv)" ]
ok $? 'gives a header'
printf 'span,drop,supports.span\n' >a.csv
runs 2 'table: a column twice' catenary --table a.csv
says 'columns 1 and 3 are both' 'says which'
runs 2 'table: --set beside the model' catenary --table --set time.end=1 table.csv
cp table.csv in.csv
runs 2 'table: over its input' catenary --table -o in.csv in.csv
same table.csv in.csv 'which stays'
runs 1 'table: -o /dev/full' catenary --table -o /dev/full table.csv
says 'cannot be written' 'is told'
catenary --table table.csv >/dev/full 2>err
[ $? -eq 1 ]
ok $? 'table: >/dev/full'

# Wrong combinations.
runs 2 'summary and table' catenary --summary --table table.csv
says 'only one of --summary, --table, --stiffness' 'says so'
runs 2 'summary and stiffness' catenary --summary --stiffness cable.ini
runs 2 'a case printed from a table' catenary --table --print-case table.csv
runs 2 'two tables' catenary --table table.csv whole.csv
runs 2 'stiffness without a case' catenary --stiffness

# A long table: in constant memory, and into a closed pipe without a word.
awk 'BEGIN { print "name,span,unstressed_length"
    for (i = 0; i < 200000; i++) printf "cable number %d,100,%.9g\n", i, 100.1 + 1e-5 * i }' >long.csv
{ catenary --table --set cable.mass_per_length=2 --set cable.axial_stiffness=1e6 long.csv 2>err
  echo $? >status; } | head -n 2 >out
[ "$(cat status)" -eq 141 ] && [ ! -s err ] && [ "$(wc -l <out)" -eq 2 ]
ok $? 'table: a closed pipe ends it quietly'

# peak PID: most memory so far [kB].
peak()
{
    awk '/^VmHWM/ { print $2 }' "/proc/$1/status"
}

if [ -n "${SEILWERK_SANITIZED:-}" ] || [ ! -r /proc/self/status ]; then
    skip 'memory cannot be told here'
    skip 'memory cannot be told here'
else
    mkfifo rows
    catenary --table --set cable.mass_per_length=2 --set cable.axial_stiffness=1e6 rows >out &
    exec 3>rows
    head -n 10000 long.csv >&3 # of which a pipe holds back 2500 rows at most
    few=$(peak $!)
    tail -n +10001 long.csv >&3
    most=$(peak $!)
    exec 3>&-
    wait $!
    [ $? -eq 0 ] && [ "$(wc -l <out)" -eq 200001 ]
    ok $? 'table: 200000 rows'
    [ $((most - few)) -lt 256 ] || echo "# $few kB, $most kB"
    [ $((most - few)) -lt 256 ] # 1.4 byte a row
    ok $? 'table: in constant memory'
fi

# Stopped while it waits for a row: no unfinished file, and the end that the signal asks for.
mkfifo slow
catenary --table -o stopped.csv slow 2>err &
exec 3>slow
head -n 2000 long.csv >&3
tries=0
while [ ! -s stopped.csv.part ] && [ $tries -lt 500 ]; do
    sleep 0.02
    tries=$((tries + 1))
done
kill -s TERM $!
wait $! 2>wait.err
status=$?
exec 3>&-
[ $tries -lt 500 ] && [ $status -eq 143 ] && [ ! -e stopped.csv ] && [ ! -e stopped.csv.part ]
ok $? 'table: stopped by SIGTERM, nothing is left'

finish
