#!/bin/sh
# modal as a user meets it: solvers, added columns, shapes, dampers, wrong options.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
cp "$top/scripts/experiments/ben-ahin/case.ini" stay.ini
cat >string.ini <<END
[cable]
unstressed_length = 99.9
mass_per_length = 10
axial_stiffness = 1e9
[supports]
span = 100
[gravity]
acceleration = 0
[damper deck]
position = 0.02
direction = 0 1 0
coefficient = 50370
[mesh]
elements = 50
END

# Solvers.
for mesh in 20 60 200; do
    for solver in dense lanczos auto; do
        runs 0 "$mesh elements: $solver" modal --solver $solver --modes 20 \
            --set mesh.elements=$mesh -o $solver.csv stay.ini
        cut -d, -f1-4 $solver.csv >$solver.numbers
    done
    "$compare" -r 1e-9 dense.numbers lanczos.numbers >&2
    ok $? "$mesh elements: both solvers find the same frequencies"
    "$compare" -r 1e-9 dense.numbers auto.numbers >&2
    ok $? "$mesh elements: and so does the tool's own choice"
    cut -d, -f5,6 dense.csv >a
    cut -d, -f5,6 lanczos.csv >b
    same a b "$mesh elements: of the same planes and kinds"
done
runs 0 'lanczos, verbose' modal -v --modes 7 --set mesh.elements=3000 stay.ini
says 'Sturm count:' 'tells the Sturm count'
says 'all of them found' 'and that nothing is missing'
runs 2 'solver of no name' modal --solver qr stay.ini
says "'qr' is not one of: auto dense lanczos" 'is told'
runs 2 'lanczos for all modes' modal --solver lanczos stay.ini
says 'option --solver lanczos: 60 modes are wanted; it finds up to 16' 'is told'
runs 2 'dense for many elements' modal --solver dense --modes 3 --set mesh.elements=2001 stay.ini
says 'option --solver dense takes up to 2000 elements' 'is told'
runs 2 'all modes of many elements' modal --set mesh.elements=2001 stay.ini
says 'give --modes' 'and is told what to do'

# The model directory of a large model serves diffverf.
runs 0 'a large model' modal --modes 3 --set mesh.elements=4000 -d large stay.ini
runs 0 'is read by diffverf' diffverf -d large --set mesh.elements=4000 \
    --set 'time.start=mode 1 0.1' --set time.end=1e-4 --set time.output_every=1e-4 stay.ini
holds 'abs(f[1, 4] - 0.1) < 1e-6' out 'and its first mode starts there'

# Added columns.
runs 0 'modal --irvine' modal --irvine --modes 12 stay.ini
header out "mode,omega_rad_s,frequency_Hz,period_s,plane,kind,symmetry,damping_ratio,\
irvine_frequency_Hz,irvine_difference" 'modal --irvine: columns'
holds 'abs(f[1, 10]) < 1e-5 && abs(f[2, 10]) < 1e-5 && abs(f[2, 3] / f[2, 9] - 1 - f[2, 10]) < 1e-12' \
    out 'modal --irvine: the first modes agree with the closed theory'
holds 'f[1, 6] == "symmetric" && f[3, 6] == "antisymmetric" && f[3, 7] < -0.999 &&
    abs(f[1, 8] - (5.379e-3 / 2 / f[1, 2] + 1.676e-4 * f[1, 2] / 2)) < 1e-15' out \
    'modal: kinds and Rayleigh damping ratio'
runs 0 'axial modes' modal --irvine stay.ini
holds 'f[60, 6] == "axial" && f[60, 9] == "" && f[60, 10] == ""' out \
    'modal --irvine: axial modes have empty cells'
runs 0 'modal --participation' modal --participation stay.ini
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    { for (a = 1; a <= 3; a++)
          sum[a] += ($c["participation_left_" a] + $c["participation_right_" a])^2 }
    END { m = 110.1897*64.8; for (a = 1; a <= 3; a++) if (!(sum[a] > 0.97*m && sum[a] < m)) exit 1 }' out
ok $? 'modal --participation: the squares add up to the mass, less what the supports carry'

# Shapes.
runs 0 'modal --shapes' modal --shapes 2,1 stay.ini
header out "theta_m,v1_2_m,v2_2_m,v3_2_m,tension_2_N,v1_1_m,v2_1_m,v3_1_m,tension_1_N" \
    'modal --shapes: columns in the order of the list'
holds 'n == 201 && f[1, 3] == 0 && abs(f[101, 3] - 1) < 1e-9 && abs(f[101, 8] - 1) < 1e-9 &&
    f[201, 1] == 110.1897 && abs(f[51, 8] - sqrt(0.5)) < 1e-4' out \
    'modal --shapes: half a sine, its largest displacement 1 m'
holds 'f[101, 5] > 0 && f[101, 9] == 0' out \
    'modal --shapes: a lateral mode changes no tension to first order'
for list in 0 61 1,x '' 1,, 2,1,2 1-3; do
    runs 2 "modal --shapes '$list'" modal --shapes "$list" stay.ini
done
[ ! -e dir ] && runs 2 'modal -d --shapes 61' modal -d dir --shapes 61 stay.ini
[ ! -e dir ]
ok $? 'a wrong list leaves no model directory'
runs 2 'modal --modes 3 --shapes 4' modal --modes 3 --shapes 4 stay.ini
runs 0 'modal --shapes of a large mesh' modal --shapes 2 --set mesh.elements=5000 stay.ini
holds 'n == 5001 && abs(f[2501, 3] - 1) < 1e-9' out 'without --modes it finds as many as it needs'
# The last mode of a mesh moves between its nodes only.
runs 0 'modal --shapes 1200' modal --shapes 1200 --set mesh.elements=200 stay.ini
awk -F, 'NR > 1 { if (!($2^2 + $3^2 + $4^2 <= 1)) bad = 1; if ($5^2 > t) t = $5^2 }
    END { EA = 2.1e11*8.26e-3; h = 110.1897/200; exit bad || !(t < (20*EA/h)^2 && t > (2*EA/h)^2) }' out
ok $? 'a mode between the nodes has its largest displacement there'
runs 0 'modal --shapes of one element' modal --shapes 1,2 --set mesh.elements=1 stay.ini
holds 'abs(f[101, 4] - 1) < 1e-9 && abs(f[101, 7] - 1) < 1e-6' out 'its modes are positive, too'
runs 2 'shapes and columns' modal --shapes 1 --irvine stay.ini

# Dampers.
runs 0 'modal --damped' modal --damped --modes 4 string.ini
holds 'abs(f[1, 12] - 0.01021147) < 1e-6 && f[1, 5] == "in" || f[2, 5] == "in" &&
    abs(f[2, 12] - 0.01021147) < 1e-6' out 'modal --damped: exact ratio of the taut string'
runs 0 'modal --damper-sweep' modal --damper-sweep 1e3,1e6,25 --modes 4 string.ini
header out "mode,coefficient_N_s_m,damped_omega_rad_s,damped_frequency_Hz,decay_1_s,damped_ratio,best" \
    'modal --damper-sweep: columns'
awk -F, 'NR > 1 && !$7 { n[$1]++; k = 3.14159265358979*$2/3162.27766*0.02
        if ($6 > 1e-9 && $1 <= 2 && (e = $6/0.02 - k/(1 + k*k))^2 > 0.02^2) exit bad = 1 }
    NR > 1 && $7 { best[++m] = $2 }
    END { exit bad || n[1] != 25 || n[4] != 25 || m != 2 || (best[1] - 50370)^2 > 50^2 ||
        (2*best[2] - best[1])^2 > 300^2 }' out
ok $? 'modal --damper-sweep: the universal curve, and the best coefficient of each mode it damps'
runs 0 'a sweep that stops short' modal --damper-sweep 1e3,1e4,5 --modes 2 string.ini
says 'best coefficient lies beyond' 'says so'
holds 'n == 10' out 'and has no best row'
for text in 1 1,2 1,2,1 2,1,5 0,1,5 a,1,5 1,2,5,6 1,2,3.5 1,,2,3 1,2,3, "$(printf %0201d,2,3 1)"; do
    runs 2 "modal --damper-sweep $(echo $text | cut -c1-20)" modal --damper-sweep $text string.ini
    says 'FROM,TO,N is expected' 'is told'
done
runs 2 'a sweep without damper' modal --damper-sweep 1,2,3 stay.ini
says 'the case has 0 dampers' 'is told'
runs 2 'too many damped modes' modal --damped --set mesh.elements=100 stay.ini
says 'give --modes' 'is told'
runs 2 'sweep and shapes' modal --shapes 1 --damper-sweep 1,2,3 string.ini
for wrong in position=0 position=1 position=1.1 'direction=0 0 0' 'direction=1 0' coefficient=-1 \
    position= direction= coefficient=; do
    runs 2 "damper with $wrong" modal --set "damper deck.$wrong" string.ini
done

# Nothing is left of what cannot be written.
if [ -e /dev/full ]; then
    runs 1 'a full disk' modal --damper-sweep 1e3,1e6,200 --modes 2 -o /dev/full string.ini
fi
modal --damper-sweep 1e3,1e6,3000 --modes 2 string.ini 2>err | head -n 1 >/dev/null
[ ! -s err ]
ok $? 'a closed pipe ends the tool quietly'

finish
