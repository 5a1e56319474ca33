#!/bin/sh
# Random admissible cases against what must hold whatever the numbers are: equilibrium put back,
# symmetry, order, and units: the same thing in metres and in millimetres must give the same answer.
# Tolerances are some 20 times what was found: the static start ends an iteration (modal), a
# motion multiplies what is left of it (diffverf), as the search of a boundary does (stabil); the
# others have round-off alone.
# A million cables and lifts, 2000 cases of each other tool; MANY and SOME in the environment: fewer.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
LC_ALL=C
export LC_ALL
many=${MANY:-1000000}
some=${SOME:-2000}
study=$top/scripts/study

# draw N SEED NAME=LOW:HIGH[:log]...: a table of random numbers, the same on every machine
draw()
{
    count=$1
    seed=$2
    shift 2
    for range; do
        printf ' --vary %s' "$range"
    done >ranges
    # shellcheck disable=SC2046
    "$study" --print-table --latin "$count" --seed "$seed" $(cat ranges)
}

# in_units FACTOR: a table in metres, kilograms, seconds with lengths times FACTOR, 1000 for millimetres;
# forces are in millinewtons then.  By the names of its columns.
in_units()
{
    awk -F, -v OFS=, -v unit="$1" '
        NR == 1 {
            for (i = 1; i <= NF; i++) {
                name = $i; sub(/^.*[.]/, "", name)
                if (name ~ /^(span|drop|unstressed_length|acceleration|amplitude|amplitude_end|radius|pitch|length_m|x_m|z_m|[vsz]_m|base_long_m|base_cross_m|sling_m|axial_stiffness|fz_N)$/)
                    factor[i] = unit
                if (name == "mass_per_length") factor[i] = 1/unit
            }
            print; next
        }
        {
            for (i = 1; i <= NF; i++)
                if (i in factor) {
                    n = split($i, part, " "); $i = sprintf("%.17g", part[1]*factor[i])
                    for (k = 2; k <= n; k++) $i = $i " " sprintf("%.17g", part[k]*factor[i])
                }
            print
        }'
}

# same_in_units A B FACTOR FORCES TOLERANCE NAME: numbers of B are those of A in other units of length
# and force, relative to the largest of their kind in the row, by the suffixes of the columns; what is
# empty or a word is the same.
same_in_units()
{
    awk -F, -v OFS=, -v other="$2" -v lengths="$3" -v forces="$4" -v tolerance="$5" '
        function size(x) { return x < 0 ? -x : x }
        NR == 1 {
            (getline line <other)
            if (line != $0) { print "# other columns"; bad = 1; exit }
            for (i = 1; i <= NF; i++) {
                kind[i] = 0; angle[i] = $i ~ /_rad$/
                if (match($i, /_(N|m|Nm|kN|kNm|m_s)$/)) kind[i] = substr($i, RSTART + 1)
                if ($i ~ /_(rad|deg|Hz|rad_s|t)$|^(lambda2|strain_max|slack_factor|c|c_1|c_2|ratio|multiplier)$/) kind[i] = "1"
                if ($i ~ /^(supports|cable|gravity|motion|load|point|why|name)|_tol$/) kind[i] = 0
            }
            next
        }
        {
            if ((getline line <other) < 1) { print "# fewer rows"; bad = 1; exit }
            n = split(line, b, ",")
            split("", most)
            for (i = 1; i <= NF; i++)
                if (kind[i] != 0 && $i ~ /[0-9]/ && size($i) > most[kind[i]]) most[kind[i]] = size($i)
            for (i = 1; i <= NF; i++) {
                if (kind[i] == 0) continue
                if ($i !~ /[0-9]/) { if (b[i] != $i) { wrong++; if (wrong < 4) print "# " NR ": " $i " " b[i] } continue }
                factor = kind[i] == "1" ? 1 : kind[i] == "Nm" || kind[i] == "kNm" ? forces*lengths : \
                    kind[i] == "N" || kind[i] == "kN" ? forces : lengths
                error = size(b[i]/factor - $i)
                scale = kind[i] != "1" ? most[kind[i]] : angle[i] && size($i) < 1 ? 1 : size($i)
                if (scale > 0 && error/scale > worst) { worst = error/scale; where = NR " column " i }
                if (!(error <= tolerance*scale)) { wrong++; if (wrong < 4) print "# " NR ", column " i ": " $i " " b[i] }
            }
            rows++
        }
        END {
            printf "# %d rows, largest difference %.2g, in row %s; %d wrong\n", rows, worst, where, wrong
            exit bad || wrong || !rows
        }' "$1"
    ok $? "$6: the same in other units"
}

# all CONDITION FILE NAME: holds in every row; cells by name: c["..."].
all()
{
    awk -F, '
        function size(x) { return x < 0 ? -x : x }
        function asinh(x) { return x < 0 ? -log(-x + sqrt(x*x + 1)) : log(x + sqrt(x*x + 1)) }
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        { for (name in at) c[name] = $at[name] }
        { rows++ }
        !('"$1"') { if (++bad < 4) print "# row " NR ": " $0 }
        END { print "# " rows " rows, " bad + 0 " wrong"; exit bad || !rows }' "$2"
    ok $? "$3"
}

# Cables: a span of 1 to 1000 m, up to 70 degrees steep, from 2 per cent stretched to three chords long.
cables()
{
    draw "$1" "$2" chord=1:1000:log angle=-70:70 slack=-4:0.3 mu=0.1:100:log strain=1e-7:1e-2:log g=1:20 |
        awk -F, '
            NR == 1 { print "span,drop,unstressed_length,mass_per_length,axial_stiffness,acceleration"; next }
            {
                # slack: 10^slack more than the chord, but every fifth cable is shorter than it
                pi = atan2(0, -1); a = $2*pi/180; L0 = $1*(1 + 10^$3)
                if (NR % 5 == 0) L0 = $1*(1 - 0.02*10^$3/2)
                printf "%.15g,%.15g,%.15g,%.15g,%.15g,%.15g\n", $1*cos(a), $1*sin(a), L0, $4, $4*$6*L0/$5, $6
            }'
}
cables "$many" 1 >cables.csv
runs 0 "$many cables" catenary -q --table cables.csv -o cables.out
[ "$(wc -l <cables.out)" -eq $((many + 1)) ]
ok $? 'none is refused'
# The two equations of the ends (A.109, A.110), whose terms cancel by the sag; and all forces.
all '(T1 = c["tension_left_N"]) && (T2 = c["tension_right_N"]) && (H = c["horizontal_force_N"]) &&
    (V = c["vertical_left_N"]) "" && (L = c["unstressed_length"]) && (EA = c["axial_stiffness"]) &&
    (W = c["mass_per_length"]*c["acceleration"]*L) &&
    size(V + c["vertical_right_N"] - W) <= 1e-12*(W + T1) &&
    size(sqrt(H^2 + V^2) - T1) <= 1e-12*T1 && size(sqrt(H^2 + (V - W)^2) - T2) <= 1e-12*T2 &&
    size(H*L/EA + H*L/W*(asinh(V/H) - asinh((V - W)/H)) - c["span"]) <= 1e-9*(L + T1*L/W*1e-5) &&
    size(W*L/EA*(V/W - 0.5) + L/W*(T1 - T2) - c["drop"]) <= 1e-9*(L + T1*L/W*1e-5) &&
    c["length_m"] >= sqrt(c["span"]^2 + c["drop"]^2)*(1 - 1e-12) && c["strain_max"] > 0' \
    cables.out 'catenary: equilibrium and ends'
in_units 1000 <cables.csv | catenary -q --table - >units.out
same_in_units cables.out units.out 1000 1000 1e-9 catenary
awk -F, -v OFS=, 'NR > 1 { sub(/^/, "-", $2); sub(/^--/, "", $2) } { print }' cables.csv | catenary -q --table - |
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } { print $at["horizontal_force_N"] "," $at["vertical_left_N"] "," $at["vertical_right_N"] }' |
    sed '1s/.*/mirror_H,mirror_left,mirror_right/' >mirror.out
paste -d, cables.out mirror.out >both.out
all 'size(c["mirror_H"] - c["horizontal_force_N"]) <= 1e-10*c["tension_max_N"] &&
    size(c["mirror_left"] - c["vertical_right_N"]) <= 1e-10*c["tension_max_N"] &&
    size(c["mirror_right"] - c["vertical_left_N"]) <= 1e-10*c["tension_max_N"]' both.out \
    'catenary: the mirror image'
awk -F, -v OFS=, 'NR > 1 { $3 = sprintf("%.17g", 1.001*$3) } { print }' cables.csv | catenary -q --table - |
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } { print $at["horizontal_force_N"] }' |
    sed '1s/.*/longer_H/' >longer.out
paste -d, cables.out longer.out >both.out
all 'c["longer_H"] < c["horizontal_force_N"]' both.out 'catenary: a longer cable pulls less'
rm -f cables.csv ./*.out

# Lifts with two kinds of slings, from very stable to unstable.
draw "$many" 2 v_m=0.5:20:log s_m=0.1:20:log z_m=-2:10 phi_deg=5:65 gamma_deg=-15:15 m_spreader_t=0:0.9 m_load_t=1:500:log |
    awk -F, -v OFS=, 'NR == 1 { print "type," $0; next } {
        # a base must be left
        pi = atan2(0, -1); t = $4*pi/180; g = $5*pi/180
        if ($1*sin(t)/cos(t) + $2*sin(g)/cos(g) < 0.05*$1) $5 = -$5
        $6 = sprintf("%.12g", $6*$7) # a share of the load
        print "primary-secondary," $0 }' | sed 's/ //g' >lifts.csv
runs 0 "$many lifts" sling -q lifts.csv -o lifts.out
all 'c["verdict"] != "not-judged" && c["why"] != "" && (c["h_m"] > 0) == (c["verdict"] == "stable" || c["verdict"] == "marginal")' \
    lifts.out 'sling: a verdict as the height'
# g is fixed, so forces stay; lengths of kilometres are refused, so decimetres
in_units 10 <lifts.csv | sling -q - >units.out
same_in_units lifts.out units.out 10 1 1e-8 sling
awk -F, -v OFS=, 'FNR == NR { z[FNR] = $3; next } FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print; next }
    { $4 = $at["z_critical_m"]; print }' lifts.csv lifts.out | cut -d, -f1-8 | sling -q - >critical.out
all 'size(c["h_m"]) <= 1e-9*(c["v_m"] + c["s_m"] + size(c["z_m"]))*(1 + c["m_spreader_t"]/c["m_load_t"]) || c["z_m"] == "inf"' critical.out \
    'sling: the height at the critical z is zero'
awk -F, -v OFS=, 'NR > 1 { $7 = sprintf("%.17g", 3*$7); $8 = sprintf("%.17g", 3*$8) } { print }' lifts.csv | sling -q - |
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } { print $at["h_m"] }' | sed '1s/.*/heavier/' >heavier.out
paste -d, lifts.out heavier.out >both.out
all 'size(c["heavier"] - c["h_m"]) <= 1e-9*(c["v_m"] + c["s_m"] + size(c["z_m"]))*(1 + c["m_spreader_t"]/c["m_load_t"])' both.out \
    'sling: three times all masses'
rm -f lifts.csv ./*.out

# One case file serves modal, diffverf and stabil.
cat >case.ini <<'END'
[cable]
unstressed_length = 103
mass_per_length = 2
axial_stiffness = 1e6
[supports]
span = 100
[mesh]
elements = 8
[damping]
zeta = 0.01 0.01
omega = 3 20
[motion deck]
amplitude = 0.01 0.02 0.005
omega = 4
[time]
end = 3
output_every = 0.5
[stability]
ratio_start = 0.95
ratio_end = 1.05
ratio_step = 0.05
END
cables "$some" 3 | awk -F, -v OFS=, '
    NR == 1 { print "supports.span,supports.drop,cable.unstressed_length,cable.mass_per_length,cable.axial_stiffness,gravity.acceleration,motion deck.amplitude,motion deck.omega,damping.omega,stability.amplitude_end"; next }
    {
        # the frequency of a taut string sets the times
        chord = sqrt($1^2 + $2^2); L0 = $3 < chord ? $3 : chord*(1 + ($3/chord - 1)/10)
        w = 3.1416/chord*sqrt(9.81*chord); a = chord*1e-4
        print $1, $2, sprintf("%.15g", L0), $4, $5, $6, a " " 2*a " " a/2, sprintf("%.6g", w), sprintf("%.6g %.6g", w, 10*w), sprintf("%.6g", chord/200)
    }' >some.csv
in_units 1000 <some.csv >thin.csv

# twice NAME TOOL...: the study in both units; both must refuse the same points
twice()
{
    name=$1
    shift
    for unit in some thin; do
        "$study" -q -d "$name-$unit" --table $unit.csv "$@" 2>/dev/null
        touch "$name-$unit/failed.csv"
    done
    awk -F, 'NR == FNR { a[$1] = 1; n++; next } !($1 in a) { bad = 1 } { m++ } END { print "# refused: " (m ? m - 1 : 0); exit bad || n != m }' \
        "$name-some/failed.csv" "$name-thin/failed.csv"
    ok $? "$name: the same points are refused"
    [ "$(awk 'END { print NR }' "$name-some/failed.csv")" -le $((some / 20)) ]
    ok $? "$name: few are"
}

# finds_all NAME: the study NAME-some has a result for every point.
finds_all()
{
    [ "$(awk 'END { print NR }' "$1-some/failed.csv")" -le 1 ] &&
        [ "$(awk -F, 'NR > 1 { n += !($1 in seen); seen[$1] = 1 } END { print n }' "$1-some/results.csv")" -eq "$some" ]
    ok $? "$1: every point has its result"
}
twice modal modal --modes 6 case.ini
same_in_units modal-some/results.csv modal-thin/results.csv 1000 1000 1e-7 modal
all 'c["omega_rad_s"] > 0 && size(c["frequency_Hz"]*2*atan2(0, -1) - c["omega_rad_s"]) < 1e-14*c["omega_rad_s"]' \
    modal-some/results.csv 'modal: frequencies'
awk -F, -v OFS=, 'NR > 1 { sub(/^/, "-", $2); sub(/^--/, "", $2) } { print }' some.csv >mirror.csv
"$study" -q -d modal-mirror --table mirror.csv modal --modes 6 case.ini
cut -d, -f13 modal-mirror/results.csv | sed '1s/.*/mirrored/' | paste -d, modal-some/results.csv - >both.out
header modal-some/results.csv "$(head -n 1 modal-mirror/results.csv)" 'modal: its columns'
all 'size(c["mirrored"] - c["omega_rad_s"]) <= 1e-6*c["omega_rad_s"]' both.out 'modal: the mirror image'
twice diffverf diffverf -q --energy case.ini
same_in_units diffverf-some/results.csv diffverf-thin/results.csv 1000 1000 1e-5 diffverf
twice stabil stabil -q case.ini
same_in_units stabil-some/results.csv stabil-thin/results.csv 1000 1000 1e-5 stabil

# A buoy on three ropes of different lengths, and a bent wire: tables by a script that takes --set.
cat >buoy <<'END'
#!/bin/sh
set -eu
while [ "${1:-}" = --set ]; do
    eval "${2%%=*}='${2#*=}'"
    shift 2
done
printf '[environment]\ngravity = %s\nwater_density = 0\n[tables]\nnodes = nodes.csv\nropes = ropes.csv\ntypes = types.csv\n' \
    "$acceleration" >system.ini
awk -v r="$span" -v d="$drop" -v f="$fz_N" 'BEGIN {
    print "node,condition,x_m,y_m,z_m,fx_N,fy_N,fz_N"
    for (k = 0; k < 3; k++) printf "a%d,fixed,%.17g,%.17g,0,0,0,0\n", k, r*cos(2.0944*k), r*sin(2.0944*k)
    printf "buoy,free,0,0,%.17g,0,0,%.17g\n", d, f }' >nodes.csv
awk -v L="$unstressed_length" 'BEGIN {
    print "rope,node_a,node_b,type,length_m"
    for (k = 0; k < 3; k++) printf "%d,a%d,buoy,w,%.17g\n", k, k, L*(1 + 0.03*k) }' >ropes.csv
printf 'type,diameter_m,mass_kg_m,ea_N\nw,0,%s,%s\n' "$mass_per_length" "$axial_stiffness" >types.csv
gapnet -q -d solved system.ini
gapcheck solved >proof.csv
awk -F, 'NR == 1 || $1 == "buoy"' solved/nodes.csv | cut -d, -f2-7
END
chmod +x buoy
draw "$some" 5 span=1:1000:log drop=0.2:1 slack=0.01:0.5 mu=0.1:100:log strain=1e-5:1e-2:log g=5:15 lift=0.2:20:log |
    awk -F, 'NR == 1 { print "span,drop,unstressed_length,mass_per_length,axial_stiffness,acceleration,fz_N"; next }
        { d = $1*$2; L = sqrt($1^2 + d^2)*(1 + $3); W = 3*$4*$6*L
          printf "%.15g,%.15g,%.15g,%.15g,%.15g,%.15g,%.15g\n", $1, d, L, $4, W/$5, $6, W*$7 }' >some.csv
in_units 1000 <some.csv >thin.csv
twice gapnet ./buoy
same_in_units gapnet-some/results.csv gapnet-thin/results.csv 1000 1000 1e-12 gapnet
# buoy stops where gapcheck does not agree
finds_all gapnet

cat >bent <<'END'
#!/bin/sh
set -eu
while [ "${1:-}" = --set ]; do
    eval "${2%%=*}='${2#*=}'"
    shift 2
done
"$ARC" wire "$radius" "$angle" 6
printf 'section,E_Pa,G_Pa,area_m2,Ixx_m4,Iyy_m4,It_m4\nwire,%s,%s,%s,%s,%s,%s\n' \
    "$modulus" "$shear" "$area" "$inertia" "$inertia" "$torsion" >wire/sections.csv
printf 'node,fx_N,fy_N,fz_N\nend,%s,%s,%s\n' "$fz_N" "$fz_N" "$fz_N" >wire/loads.csv
wirebeam -q -d wire/solved wire/case.ini
awk -F, '{ if (NR == 1 || $1 == "end") print $5, $6, $7 } ' OFS=, wire/solved/nodes.csv
END
chmod +x bent
ARC=$top/scripts/wire/arc
export ARC
draw "$some" 6 radius=0.1:10:log angle=20:170 diameter=1e-3:2e-2:log modulus=1e9:2e11:log load=0.01:1:log |
    awk -F, 'NR == 1 { print "radius,angle,modulus,shear,area,inertia,torsion,fz_N"; next }
        { pi = atan2(0, -1); d = $3*$1; I = pi*d^4/64; l = $1*$2*pi/180
          printf "%.15g,%.15g,%.15g,%.15g,%.15g,%.15g,%.15g,%.15g\n", $1, $2, $4, $4/2.6, pi*d^2/4, I, 2*I, $5*$4*I/l^2 }' >some.csv
awk -F, -v OFS=, 'NR == 1 { print; next } { printf "%.17g,%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n",
    1000*$1, $2, $3/1000, $4/1000, 1e6*$5, 1e12*$6, 1e12*$7, 1000*$8 }' some.csv >thin.csv
twice wirebeam ./bent
finds_all wirebeam
same_in_units wirebeam-some/results.csv wirebeam-thin/results.csv 1000 1000 1e-11 wirebeam

# What is no case is refused with words, and prints nothing: one key of a case, or one cell of a table,
# after the other with a value that cannot be, or that can and then has numbers for results.
values='nan inf -1 1e400 x 1,5 0x10p3 1e-400 -0 1e300 1e-300 99999999999999999999'
no_number='nan|inf'
bad=
n=0

# asked WHAT COMMAND...: runs it, and adds what is wrong to $bad.
asked()
{
    what=$1
    shift
    n=$((n + 1))
    timeout 20 "$@" >out 2>err
    status=$?
    case $status in
    0) ! grep -qiE ",-?($no_number)(,|\$)" out || bad="$bad $what:nan" ;;
    1 | 2) [ -s err ] || bad="$bad $what:silent" ;;
    *) bad="$bad $what:$status" ;;
    esac
    [ $status -ne 2 ] || [ ! -s out ] || bad="$bad $what:printed"
}

# told NAME: the verdict on all that were asked since.
told()
{
    [ -z "$bad" ] || echo "# $bad"
    [ -z "$bad" ] && [ $n -gt 0 ]
    ok $? "$1: $n inputs with one value that cannot be, or that can"
    bad=
    n=0
}

# cells TABLE COMMAND...: each cell of the second line in turn.
cells()
{
    table=$1
    shift
    cp "$table" sound.csv
    columns=$(awk -F, 'NR == 1 { print NF }' "$table")
    i=0
    while [ $((i += 1)) -le "$columns" ]; do
        for value in $values '' '1 2' '"'; do
            value=$value awk -F, -v OFS=, -v i=$i 'NR == 2 { $i = ENVIRON["value"] } { print }' sound.csv >"$table"
            asked "$table:$i=$value" "$@"
        done
    done
    cp sound.csv "$table"
}

for tool in catenary modal diffverf stabil; do
    for key in cable.unstressed_length cable.mass_per_length cable.axial_stiffness supports.span \
        supports.drop mesh.elements gravity.acceleration damping.zeta time.end time.output_every \
        stability.ratio_step 'motion deck.omega' 'motion deck.amplitude'; do
        for value in $values '' '1 2 3 4 5 6 7'; do
            asked "$key=$value" $tool --set "$key=$value" --set mesh.elements=2 case.ini
        done
    done
    told $tool
done
head -n 2 "$top/scripts/experiments/lifts/cases.csv" >lift.csv
no_number='nan' # a critical height may be infinite
cells lift.csv sling lift.csv
cells lift.csv sling --exact lift.csv
told sling
no_number='nan|inf'
cp "$top/scripts/experiments/nets/mooring/"* .
for key in environment.gravity environment.water_density solve.elements solve.tolerance solve.iterations; do
    for value in $values; do
        asked "$key=$value" gapnet -q --set "$key=$value" --rope chain system.ini
    done
done
for table in nodes ropes types; do
    cells $table.csv gapnet -q --rope chain system.ini
done
told gapnet
"$ARC" . 1 90 2
for key in solve.steps solve.tolerance solve.iterations solve.largest_angle output.points; do
    for value in $values; do
        asked "$key=$value" wirebeam -q --set "$key=$value" case.ini
    done
done
for table in nodes elements sections supports loads; do
    cells $table.csv wirebeam -q case.ini
done
told wirebeam

finish
