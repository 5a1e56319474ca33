#!/bin/sh
# gapnet on moorings: bed, friction, current, rigid bodies, restoring curves, stiffness, pretension.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1

# Nothing here takes as long: one that hangs fails.
gapnet()
{
    timeout 20 "$SEILWERK_BUILD/bin/gapnet" "$@"
}

# column NAME FILE: of all rows.
column()
{
    awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i; next }
        { print $at }' "$2"
}

# near A B RELATIVE NAME: two numbers.
near()
{
    awk -v a="$1" -v b="$2" -v r="$3" 'BEGIN { d = a - b; d = d < 0 ? -d : d
        m = b < 0 ? -b : b; exit !(a != "" && b != "" && d <= r*m) }'
    close=$?
    [ $close -eq 0 ] || echo "# $1 against $2"
    ok $close "$4"
}

# agree FILE FILE COLUMNS RELATIVE ABSOLUTE NAME
agree()
{
    "$compare" -r "$4" -a "$5" -c "$3" "$1" "$2" >&2
    ok $? "$6"
}

# proven DIR: by its tables.
proven()
{
    runs 0 "$1: proven" gapcheck "$1"
}

# refused NAME TEXT OPTION...: of the last operand, status 2 with this message, nothing written.
refused()
{
    what=$1
    text=$2
    shift 2
    runs 2 "$what" gapnet "$@"
    [ "$(cat err)" = "gapnet: $text" ] || sed 's/^/# /' err
    [ "$(cat err)" = "gapnet: $text" ] && [ ! -s out ]
    ok $? "$what: $text"
}

# One chain, its anchor on the bed, 50 m deep.
printf '[environment]\ngravity = 9.80665\ndepth = 50\n' >chain.ini
printf 'type,diameter_m,mass_kg_m,ea_N,cd,cd_axial\nchain,0.252,390,1.674e9,1.37,0.64\n' >types.csv
printf 'node,condition,x_m,y_m,z_m\nanchor,fixed,400,0,-50\nfairlead,fixed,0,0,0\n' >nodes.csv
printf 'rope,node_a,node_b,type,length_m\nchain,anchor,fairlead,chain,410\n' >ropes.csv

# Friction: the closed form of the part that lies and that which hangs, put to zero by bisection of H
# and V; from C w s > H on no tension is left at the anchor.
for friction in 0 0.5 1; do
    runs 0 "bed, friction $friction" gapnet --set environment.bed_friction=$friction \
        -d bed-$friction chain.ini
    proven bed-$friction
    awk -F, -v C=$friction 'NR == 2 {
            w = 9.80665*(390 - 1025*atan2(0, -1)/4*0.252^2); EA = 1.674e9; L = 410
            H = sqrt($11^2 + $12^2); V = $13; T = sqrt(H^2 + V^2); l = L - V/w; s = l
            if (C > 0 && H/(C*w) < l) s = H/(C*w)
            x = l + H/w*log((V + T)/H) + H*(L - l)/EA + (H*s - C*w*s^2/2)/EA
            z = V^2/w*(1/(T + H) + 1/(2*EA)); a = H - C*w*l; a = a < 0 ? 0 : a
            # a closed form: nothing but round-off and what the solver leaves
            exit !((x - 400)^2 < 1e-20*400^2 && (z - 50)^2 < 1e-20*400^2 &&
                ($7 - l)^2 < 1e-20*L^2 && ($2 - a)^2 < 1e-20*T^2) }' bed-$friction/ropes.csv
    ok $? "friction $friction: place of the fairlead, length on the bed, tension at the anchor"
done
near "$(column tension_a_N bed-1/ropes.csv)" 38175 1e-4 'friction 1 leaves a twentieth at the anchor'
runs 0 'more friction' gapnet --set environment.bed_friction=1.5 -d bed-2 chain.ini
proven bed-2
holds 'f[1, 2] < 1e-6 && f[1, 3] > 1e6' bed-2/ropes.csv 'nothing is left at the anchor'

# On a slope without friction T + T^2/2EA - w z is the same all along a rope, also where it lies.
sed 's/-50/-30/' nodes.csv >slope.csv
for slope in '0.05 0' '0.05 0.2'; do
    runs 0 "slope $slope" gapnet --set "environment.bed_slope=$slope" --set tables.nodes=slope.csv \
        -d slope chain.ini
    proven slope
    awk -F, 'NR > 1 { w = 9.80665*(390 - 1025*atan2(0, -1)/4*0.252^2)
            c = $6*(1 + $6/(2*1.674e9)) - w*$5; low = NR == 2 || c < low ? c : low
            high = NR == 2 || c > high ? c : high; if ($15 > 0) lies++
            if ($5 < -50 + 0.05*$3 + 0.2*$4*0 - 1e-9) below = 1 }
        END { exit !(lies > 2 && !below && high - low < 1e-11*high) }' slope/shapes.csv
    ok $? "slope $slope: energy along the rope, nothing below the bed"
done
# With friction C the tension falls along the bed by w (sin - C cos): the anchor is above the rope.
runs 0 'slope with friction' gapnet --set 'environment.bed_slope=0.05 0' \
    --set environment.bed_friction=0.3 --set tables.nodes=slope.csv -d slope chain.ini
proven slope
awk -F, 'NR == 2 { T = $6 } NR > 2 && $15 > 0 { s = $10; t = $6 }
    END { w = 9.80665*(390 - 1025*atan2(0, -1)/4*0.252^2); r = sqrt(1 + 0.05^2)
        fall = w*s*(0.3 - 0.05)/r; exit !((T + fall - t)^2 < 1e-18*t^2) }' slope/shapes.csv
ok $? 'tension along the bed by weight and friction'
near "$(column tension_a_N slope/ropes.csv)" \
    "$(awk -F, 'NR == 2 { print $6 }' slope/shapes.csv)" 1e-12 'the tables agree'

# A grid that is plane is the plane: both in 100 elements, so that they differ by the solution alone.
printf 'x_m,y_m,z_m\n500,-100,-25\n-100,-100,-55\n-100,100,-55\n500,100,-25\n' >grid.csv
printf 'rope,node_a,node_b,type,length_m,elements\nchain,anchor,fairlead,chain,410,100\n' >chain100.csv
grid='--set environment.depth= --set environment.bed=grid.csv --set tables.nodes=slope.csv'
runs 0 'a grid' gapnet $grid -d grid chain.ini
proven grid
runs 0 'the plane' gapnet --set 'environment.bed_slope=0.05 0' --set tables.nodes=slope.csv \
    --set tables.ropes=chain100.csv -d plane chain.ini
agree grid/shapes.csv plane/shapes.csv x_m,y_m,z_m,tension_N 1e-8 1e-6 'are the same'
# The continuous rope is their limit: halving the elements shortens the difference, of first order
# where the bed begins within an element.
runs 0 'continuous' gapnet --set 'environment.bed_slope=0.05 0' --set tables.nodes=slope.csv -d plane chain.ini
near "$(column tension_a_N grid/ropes.csv)" "$(column tension_a_N plane/ropes.csv)" 1e-3 \
    'and nearly the continuous rope'
# An anchor may leave its height to the bed.
sed 's/400,0,-30/400,0,/' slope.csv >left.csv
runs 0 'an anchor without a height, grid' gapnet --set environment.depth= \
    --set environment.bed=grid.csv --set tables.nodes=left.csv -d left chain.ini
agree left/nodes.csv grid/nodes.csv x_m,y_m,z_m,fx_N,fy_N,fz_N 1e-9 1e-6 'stands on the bed'
runs 0 'an anchor without a height, slope' gapnet --set 'environment.bed_slope=0.05 0' \
    --set tables.nodes=left.csv -d left chain.ini
agree left/nodes.csv plane/nodes.csv x_m,y_m,z_m,fx_N,fy_N,fz_N 1e-9 1e-6 'stands on the bed'
refused 'an anchor without a height or a bed' 'left.csv:2: a held node needs its coordinate' \
    --set environment.depth= --set tables.nodes=left.csv chain.ini
# A hump under the chain carries it: the lowest point is on the bed.
printf 'x_m,y_m,z_m\n%s\n' "$(for x in -100 100 150 200 500; do for y in -100 100; do
    echo "$x,$y,$([ $x = 150 ] && echo -40 || echo -50)"; done; done)" >hump.csv
runs 0 'a hump' gapnet --set environment.depth= --set environment.bed=hump.csv -d hump chain.ini
proven hump
awk -F, 'NR > 1 { d = $3 - 150; d = d < 0 ? -d : d; z = d < 50 ? -40 - d/5 : -50
        if ($5 < z - 1e-6) below = 1; if ($15 > 0 && d < 5) lies = 1 }
    END { exit !(lies && !below) }' hump/shapes.csv
ok $? 'carries the chain, no joint is below the bed'

# What is wrong is seen: a bed that pulls.
rm -rf pulls && cp -r plane pulls
awk -F, -v OFS=, 'NR == 4 { $15 = -$15 } { print }' plane/shapes.csv >pulls/shapes.csv
runs 1 'a bed that pulls' gapcheck pulls
says "the bed pulls at rope 'chain'" 'is told with its rope'

# Current.  Tensions of the chain by a leading code, which splits it in its own way: within 2 %; along
# +y it lies at an angle to its chord.  The load of all joints is the sum of drag and weight: its
# vertical part is the weight but for the lift of drag, its bed part the push.
current()
{
    printf 'z_m,speed_m_s,direction_deg\n0,1,%s\n' "$1" >current.csv
}
while read -r direction a b; do
    current "$direction"
    for drag in renew hold; do
        runs 0 "current $direction, $drag" gapnet --set tables.current=current.csv \
            --set solve.drag=$drag -d flow-$drag chain.ini
        proven flow-$drag
    done
    near "$(column tension_a_N flow-renew/ropes.csv)" "$a" 0.02 "current $direction: at the anchor"
    near "$(column tension_b_N flow-renew/ropes.csv)" "$b" 0.02 "current $direction: at the fairlead"
    # the same balance by other steps; residuals are 5e-10 of the tension
    agree flow-renew/ropes.csv flow-hold/ropes.csv tension_a_N,tension_b_N,ta_x_N,ta_y_N,ta_z_N 1e-8 \
        1e-2 "current $direction: held or renewed, the same"
    [ "$(column steps flow-renew/summary.csv)" -le "$(column steps flow-hold/summary.csv)" ]
    ok $? "current $direction: renewing needs no more steps"
done <<END
180 919200 983600
90 852900 1018900
END
# Mirrored: to round-off of the solution.
current -90
runs 0 'current the other way across' gapnet --set tables.current=current.csv -d flow chain.ini
near "$(column ta_y_N flow/ropes.csv)" "$(column ta_y_N flow-renew/ropes.csv | sed 's/^/-/; s/^--//')" 1e-8 \
    'is its mirror image'
# Friction holds what lies against the current; nothing of it is at the anchor of a long chain.
runs 0 'current and friction' gapnet --set tables.current=current.csv \
    --set environment.bed_friction=1 -d rough chain.ini
proven rough
awk -v a="$(column tension_a_N flow/ropes.csv)" -v b="$(column tension_a_N rough/ropes.csv)" \
    'BEGIN { exit !(b < 0.2*a) }'
ok $? 'friction takes most of the tension before the anchor'

# A buoy on a thread without weight or drag: F = 0.5 rho CdA U^2 with the speed at its height, and the
# thread points along the force.  The solution is good to 5e-10 of the tension.
cat >buoy.ini <<END
[tables]
nodes = buoy-nodes.csv
ropes = buoy-ropes.csv
types = buoy-types.csv
current = buoy-current.csv
END
printf 'type,diameter_m,mass_kg_m,ea_N\nthread,0,0,1e6\n' >buoy-types.csv
printf 'rope,node_a,node_b,type,length_m\nthread,a,b,thread,50\n' >buoy-ropes.csv
printf 'node,condition,x_m,y_m,z_m,mass_kg,volume_m3,cda_m2\na,fixed,0,0,-60,,,\nb,free,,,,100,1,2\n' \
    >buoy-nodes.csv
printf 'z_m,speed_m_s,direction_deg\n-60,0.3,30\n0,1.5,30\n' >buoy-current.csv
for drag in renew hold; do
    runs 0 "a buoy, $drag" gapnet --set solve.drag=$drag -d buoy buoy.ini
    proven buoy
    awk -F, '$1 == "b" { pi = atan2(0, -1); u = 1.5 + $4*1.2/60; F = 0.5*1025*2*u^2
            up = 9.81*(1025 - 100); T = sqrt(F^2 + up^2); l = 50*(1 + T/1e6)
            x = l*F/T*cos(pi/6); y = l*F/T*sin(pi/6); z = -60 + l*up/T
            exit !(($2 - x)^2 + ($3 - y)^2 + ($4 - z)^2 < 1e-14*l^2 && ($9 - F*cos(pi/6))^2 < 1e-14*F^2) }' \
        buoy/nodes.csv
    ok $? "a buoy, $drag: drag at its height, the thread along the force"
done
# Rows of the current may descend; beyond its ends it is constant.
printf 'z_m,speed_m_s,direction_deg\n0,1.5,30\n-60,0.3,30\n' >buoy-current.csv
cp buoy/nodes.csv down.csv
runs 0 'a current from the surface down' gapnet --set solve.drag=hold -o out.csv buoy.ini
agree out.csv down.csv x_m,y_m,z_m 0 1e-12 'is the same'
printf 'z_m,speed_m_s,direction_deg\n-5,1.5,0\n-50,0.3,0\n' >buoy-current.csv
sed 's/free,,,/fixed,0,0,-2/' buoy-nodes.csv >held.csv
runs 0 'above the highest row' gapnet --set tables.nodes=held.csv -o out.csv buoy.ini
near "$(column load_x_N out.csv | tail -n 1)" 2306.25 1e-12 'the speed is that of this row'

# A rope in cross flow alone: drag w = 0.5 rho d cd U^2 across it, normal to it, no weight.  The form
# is known (Blendermann, light rope in cross flow): T is the same all along.
printf 'z_m,speed_m_s,direction_deg\n0,2,0\n' >buoy-current.csv
printf 'type,diameter_m,mass_kg_m,ea_N,cd\nthread,0.02,0.32201324699,1e9,1.2\n' >light.csv # as water
printf 'node,condition,x_m,y_m,z_m\na,fixed,0,-10,-20\nb,fixed,0,10,-20\n' >cross.csv
printf 'rope,node_a,node_b,type,length_m\nthread,a,b,thread,22\n' >cross-ropes.csv
runs 0 'a light rope across a current' gapnet --set tables.types=light.csv --set tables.nodes=cross.csv \
    --set tables.ropes=cross-ropes.csv --set solve.elements=40 -d cross buoy.ini
proven cross
awk -F, 'NR == 2 { exit !($5 > 0 && ($5 - $4)/$4 < 1e-4) }' cross/ropes.csv
ok $? 'has nearly one tension: drag is normal to it, but for the angle between elements'

# A vessel on three chains, symmetric about a vertical axis and half of it on the bed.
cat >spread.ini <<END
[environment]
depth = 80
[tables]
nodes = spread-nodes.csv
ropes = spread-ropes.csv
types = spread-types.csv
bodies = spread-bodies.csv
END
printf 'type,diameter_m,mass_kg_m,ea_N,cd,cd_axial\nchain,0.1,126,6e8,1.4,0.6\n' >spread-types.csv
cat >spread-bodies.csv <<END
body,condition,x_m,y_m,z_m,mass_kg,volume_m3,zg_m,zb_m,waterplane_m2
floater,fixed,0,0,0,2.2e6,2500,-4,-3,120
END
awk 'BEGIN { pi = atan2(0, -1); print "node,condition,x_m,y_m,z_m,body"
    for (i = 0; i < 3; i++) { c = cos(2*pi*i/3); s = sin(2*pi*i/3)
        printf "A%d,fixed,%.17g,%.17g,-80,\nF%d,fixed,%.17g,%.17g,-8,floater\n", i + 1, 500*c, 500*s,
            i + 1, 20*c, 20*s } }' >spread-nodes.csv
printf 'rope,node_a,node_b,type,length_m\n1,A1,F1,chain,495\n2,A2,F2,chain,495\n3,A3,F3,chain,495\n' \
    >spread-ropes.csv
runs 0 'a vessel on three chains' gapnet -d spread spread.ini
proven spread
[ "$(ls spread | tr '\n' ' ')" = 'bodies.csv history.csv nodes.csv ropes.csv shapes.csv summary.csv ' ]
ok $? 'has a table of bodies'
header spread/bodies.csv 'body,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm,load_x_N,load_y_N,load_z_N,load_mx_Nm,load_my_Nm,load_mz_Nm,condition' \
    'its columns'
# forces of some 1e5 N cancel; round-off of that
holds 'abs(f[1, 8]) < 1e-4 && abs(f[1, 9]) < 1e-4 && abs(f[1, 13]) < 1e-2 && f[1, 10] < -1e5' \
    spread/bodies.csv 'symmetric: no force in surge and sway, no yaw'
holds 'f[1, 16] == 9.81*(2500*1025 - 2.2e6)' spread/bodies.csv 'what it has itself: lift less weight'

# Free: it floats up until its waterplane has what the chains pull; all sums to nothing, to 1e-8 of
# the largest tension times the arm of a fairlead.
sed 's/fixed/free/' spread-bodies.csv >free-bodies.csv
for friction in 0 0.6; do
    runs 0 "a free body, friction $friction" gapnet --set tables.bodies=free-bodies.csv \
        --set environment.bed_friction=$friction -d free spread.ini
    proven free
    holds 'abs(f[1, 8] + f[1, 14]) < 5e-3 && abs(f[1, 9] + f[1, 15]) < 5e-3 &&
        abs(f[1, 10] + f[1, 16]) < 5e-3 && abs(f[1, 11] + f[1, 17]) < 0.1 &&
        abs(f[1, 12] + f[1, 18]) < 0.1 && abs(f[1, 13] + f[1, 19]) < 0.1' free/bodies.csv \
        'its forces cancel'
    holds 'f[1, 4] > 1 && abs(f[1, 16] - 9.81*(2500*1025 - 2.2e6 - 120*1025*f[1, 4])) < 1e-3' \
        free/bodies.csv 'it has risen as its waterplane says'
done
# What is heavier than it can float ends in the bed: no result.
sed 's/2.2e6/2.2e9/' free-bodies.csv >sinks.csv
runs 2 'a body that sinks' gapnet --set tables.bodies=sinks.csv spread.ini
says 'inside the bed' 'is told'
# Pushed: a load on one of its nodes is a load on it.
printf 'node,fx_N,fy_N,fz_N\nF1,0,1e5,0\n' >push.csv
runs 0 'a free body that is pushed' gapnet --set tables.bodies=free-bodies.csv \
    --set tables.loads=push.csv -d free spread.ini
holds 'f[1, 3] > 0.5 && f[1, 7] > 0.01 && abs(f[1, 9] + f[1, 15]) < 5e-3 &&
    abs(f[1, 13] + f[1, 19]) < 0.1' free/bodies.csv 'drifts and yaws until it is in balance'

# --move is the table moved.
turn='7,3,1,0.02,-0.03,0.1'
runs 0 'moved' gapnet --move $turn -d moved spread.ini
proven moved
sed "s/fixed,0,0,0,/fixed,7,3,1,/; 1s/z_m,/z_m,rx_rad,ry_rad,rz_rad,/; 2s/7,3,1,/7,3,1,0.02,-0.03,0.1,/" \
    spread-bodies.csv >moved-bodies.csv
runs 0 'put there' gapnet --set tables.bodies=moved-bodies.csv -d put spread.ini
# the place of its buoyancy tells another level of its own, the rest is the same to round-off
agree moved/nodes.csv put/nodes.csv x_m,y_m,z_m,support_x_N,support_y_N,support_z_N 1e-9 1e-6 \
    'the same nodes'
agree moved/bodies.csv put/bodies.csv x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm \
    1e-9 1e-4 'the same body'

# --moves: each row as a run of its own; one that is not solved costs only itself.
printf 'dx_m,ry_rad,dy_m\n-5,0,0\n0,0,0\n5,0.02,\n5,0,12\n' >moves.csv
runs 0 'a restoring curve' gapnet --moves moves.csv spread.ini
header out 'dx_m,dy_m,dz_m,rx_rad,ry_rad,rz_rad,fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm,largest_tension_N,rope,status' \
    'its columns'
cp out curve.csv
{
    head -n 1 curve.csv | cut -d, -f7-13
    for move in -5,0,0,0,0,0 0,0,0,0,0,0 5,0,0,0,0.02,0 5,12,0,0,0,0; do
        gapnet --move $move -d one spread.ini
        printf '%s,%s\n' "$(tail -n 1 one/bodies.csv | cut -d, -f8-13)" \
            "$(column largest_tension_N one/summary.csv)"
    done
} >singles.csv
agree curve.csv singles.csv fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm,largest_tension_N 1e-9 1e-3 \
    'rows are runs of their own'
runs 0 'from standard input' sh -c 'gapnet --moves - spread.ini <moves.csv'
same curve.csv out 'the same'
runs 0 'to a file' gapnet --moves moves.csv -o file.csv spread.ini
same curve.csv file.csv 'the same'
# What a row alone would warn of is told once, where it occurs first.
printf 'type,diameter_m,mass_kg_m,ea_N,breaking_N\nchain,0.1,126,8e8,6e5\n' >weak-types.csv
printf 'dx_m\n0\n-8\n0\n-9\n' >pull.csv
runs 0 'a curve over a breaking load' gapnet --set tables.types=weak-types.csv --moves pull.csv spread.ini
grep -q "^gapnet: pull.csv:3: rope '1' is over its breaking load: " err && [ "$(wc -l <err)" = 1 ]
ok $? 'one warning, with the row in which it occurs first'
runs 0 'without a bed' sh -c 'grep -v ^depth spread.ini >no-bed.ini; gapnet --moves pull.csv no-bed.ini'
grep -q "^gapnet: pull.csv:2: rope '.' hangs .* m below the lowest node that is held" err && [ "$(wc -l <err)" = 1 ]
ok $? 'one warning for all rows'
runs 0 'quietly' gapnet -q --set tables.types=weak-types.csv --moves pull.csv spread.ini
[ ! -s err ]
ok $? 'no warning'
printf 'dx_m\n-5\nfive\n' >bad.csv
refused 'a move that is no number' "bad.csv:3: column 1: 'five': not a number" --moves bad.csv -o never.csv spread.ini
printf 'dx_m,ry_deg\n-5,0\n' >bad.csv
refused 'an unknown column of moves' "bad.csv:1: column 2: 'ry_deg' is not known here" \
    --moves bad.csv spread.ini
# Rows that cannot be: fairleads inside the bed, beyond the end of a tension table, not in so few steps.
printf 'dx_m,dz_m\n0,0\n0,-75\n1,0\n' >sunk.csv
printf 'strain,tension_N\n0.001,6e5\n0.002,9e5\n' >law.csv
printf 'type,diameter_m,mass_kg_m,tension_table\nchain,0.1,126,law.csv\n' >law-types.csv
printf 'dx_m\n0\n-10\n1\n' >taut.csv
printf 'dx_m\n0\n-40\n1\n' >far.csv
while read -r moves text options; do
    # shellcheck disable=SC2086
    runs 1 "a row that is not solved: $moves" gapnet $options --moves $moves spread.ini
    grep -q "^gapnet: $moves:3: not solved: $(echo "$text" | tr _ ' ')" err && [ "$(wc -l <err)" = 1 ]
    ok $? 'is told with its line'
    awk -F, 'NR == 3 && NF == 15 && $7 $8 $9 $10 $11 $12 $13 $14 == "" && $15 == "not-solved" { bad = 1 }
        NR != 1 && NR != 3 && ($15 != "solved" || $13 == "") { exit 1 } END { exit !(bad && NR == 4) }' out
    ok $? 'its cells are empty, the rest goes on'
done <<END
sunk.csv spread-nodes.csv:3:_'F1'_is_held_3_m_inside_the_bed
taut.csv rope_'1'_carries_.*_N;_its_tension_table_ends_at_900000_N --set tables.types=law-types.csv
far.csv the_iteration_did_not_converge --set solve.steps=60 --rope chain
END

# --stiffness body: differences of restoring forces over 2e-4 m and rad, whose own error is the
# square of that over the clearance of the chains, 1e-8 and less; 1e-5 is asked for.
{
    echo dx_m,dy_m,dz_m,rx_rad,ry_rad,rz_rad
    awk 'BEGIN { for (j = 0; j < 6; j++) for (s = 1; s > -2; s -= 2) for (i = 0; i < 6; i++)
        printf "%s%s", i == j ? s*1e-4 : 0, i < 5 ? "," : "\n" }'
} >six.csv
# stiff NAME AWK-CONDITION OPTION...: over e, the largest difference, and u, the largest asymmetry,
# each over the roots of the diagonal.
stiff()
{
    about=$1
    condition=$2
    shift 2
    gapnet "$@" --moves six.csv -o six.out spread.ini
    runs 0 "stiffness, $about" gapnet "$@" --stiffness body spread.ini
    awk -F, 'FNR == 1 { file++; next }
        file == 1 { for (j = 1; j <= 6; j++) F[FNR - 1, j] = $(6 + j); next }
        { for (j = 1; j <= 6; j++) K[FNR - 1, j] = $(j + 1); rows = FNR - 1 }
        function size(x) { return x < 0 ? -x : x }
        END {
            for (i = 1; i <= 6; i++)
                for (j = 1; j <= 6; j++) {
                    root = sqrt(K[i, i]*K[j, j])
                    d = size((F[2*j, i] - F[2*j - 1, i])/2e-4 - K[i, j])/root; e = d > e ? d : e
                    d = size(K[i, j] - K[j, i])/root; u = d > u ? d : u
                }
            if (!(rows == 6 && '"$condition"')) { print "# " e, u; exit 1 }
        }' six.out out
    ok $? "stiffness, $about: $condition"
}
stiff 'no friction' 'e < 1e-5 && u < 1e-9'
stiff friction 'e < 1e-5' --set environment.bed_friction=0.6
stiff 'moved' 'e < 1e-5' --move $turn
stiff 'moved, friction' 'e < 1e-5' --move $turn --set environment.bed_friction=0.6
runs 0 'of nodes by name' gapnet --stiffness F1,F2,F3 --about 0,0,0 spread.ini
cp out named.csv
runs 0 'of the body' gapnet --stiffness body -o body.csv spread.ini
agree named.csv body.csv x_m,y_m,z_m,rx_rad,ry_rad,rz_rad 1e-12 1e-3 'is that of its nodes'
runs 0 'about another point' gapnet --stiffness body --about 0,0,-8 spread.ini
# K' = T'K T: moments about a point 8 m lower; surge is untouched, pitch less
holds 'f[1, 2] > 0 && f[5, 6] < 0.9*19.4e6' out 'pitch is softer about the fairleads'
runs 0 'to a directory' gapnet --stiffness body -d stiff spread.ini
[ -s stiff/stiffness.npy ]
ok $? 'with its matrix file'
same body.csv stiff/stiffness.csv 'the same numbers'

# --pretension: reached to 1e-8, one or several at once, by length or by anchor.
# tuned NAME OPTION...
tuned()
{
    about=$1
    shift
    runs 0 "pretension $about" gapnet "$@" -d tuned spread.ini
    proven tuned
    for want; do
        case $want in [0-9]=*) ;; *) continue ;; esac
        near "$(awk -F, -v r="${want%=*}" '$1 == r { print $3 }' tuned/ropes.csv)" "${want#*=}" 1e-8 \
            "pretension $about: $want"
    done
}
tuned 'by length' --pretension 1=6e5
[ "$(column unstretched_m tuned/ropes.csv | tr '\n' ' ' | cut -d' ' -f2)" = 495 ]
ok $? 'other ropes are as long as before'
holds 'f[1, 16] < 494' tuned/ropes.csv 'the rope is shorter'
tuned 'of all' --pretension 1=6e5 --pretension 2=7e5 --pretension 3=5e5 --by length
tuned 'by anchor' --pretension 1=6e5 --by anchor
holds 'f[1, 2] > 500.5 && f[1, 4] == -80' tuned/nodes.csv 'the anchor moved away, on the bed'
holds 'f[1, 16] == 495' tuned/ropes.csv 'the rope is as long as before'
tuned 'of all, by anchor, with friction' --pretension 1=6e5 --pretension 2=6e5 --pretension 3=6e5 \
    --by anchor --set environment.bed_friction=0.6
tuned 'of all, of a free body' --pretension 1=6e5 --pretension 2=6e5 --pretension 3=6e5 \
    --set tables.bodies=free-bodies.csv
# on a slope the anchor keeps its height over the bed
awk -F, -v OFS=, -v CONVFMT=%.17g '/^A/ { $5 = -80 + 0.02*$3 - 0.01*$4 } { print }' spread-nodes.csv >high.csv
tuned 'by anchor on a slope' --pretension 2=6e5 --by anchor --set 'environment.bed_slope=0.02 -0.01' \
    --set tables.nodes=high.csv
holds 'abs(f[3, 4] - (-80 + 0.02*f[3, 2] - 0.01*f[3, 3])) < 1e-9 && f[3, 4] != -80' tuned/nodes.csv \
    'the anchor is on the bed'
printf 'dx_m\n0\n' >zero.csv
runs 0 'a restoring curve of a tuned mooring' gapnet --pretension 1=6e5 --moves zero.csv spread.ini
near "$(column largest_tension_N out)" 6e5 1e-8 'begins from the pretension'
runs 1 'a pretension that cannot be' gapnet --pretension 1=1 -d far spread.ini
says "gapnet: option --pretension: no length found that gives rope '1' 1 N: 8" 'is told'
[ "$(column status far/summary.csv)" = not-solved ]
ok $? 'is no result'

# Two methods, chains over the bed, a clump between them: its place to 1e-6 m.
printf '[environment]\ndepth = 50\n[tables]\nnodes = clump-nodes.csv\nropes = clump-ropes.csv\n' >clump.ini
printf 'node,condition,x_m,y_m,z_m,mass_kg\nanchor,fixed,400,0,-50,\nclump,free,,,,5000\nfairlead,fixed,0,0,0,\n' \
    >clump-nodes.csv
printf 'rope,node_a,node_b,type,length_m\n1,anchor,clump,chain,300\n2,clump,fairlead,chain,110\n' >clump-ropes.csv
runs 0 'verify over a bed' gapnet --verify --rope chain -d verified clump.ini
awk -v x="$(column verify_m verified/summary.csv)" 'BEGIN { exit !(x != "" && x < 1e-6) }'
ok $? 'gap and displacement agree'
proven verified
# A clump that is too heavy for its ropes lies on the bed, which carries what is left.
sed 's/5000/5e5/; s/400,0/380,0/' clump-nodes.csv >heavy.csv
runs 0 'a clump that lies' gapnet --set tables.nodes=heavy.csv -d lies clump.ini
proven lies
awk -F, '$1 == "clump" { exit !($4 > -50 - 1e-6 && $4 < -50 + 1e-6) }' lies/nodes.csv
ok $? 'is on the bed, not in it'

# Options that do not fit.
refused 'curve and directory' 'option --moves prints the curve alone' --moves moves.csv -d never spread.ini
refused 'curve and stiffness' 'option --moves prints the curve alone' --moves moves.csv --stiffness body spread.ini
refused 'curve and second method' 'option --moves prints the curve alone' --moves moves.csv --verify spread.ini
refused 'by without pretension' 'option --by belongs to --pretension' --by anchor spread.ini
refused 'by an unknown word' "option --by: 'chain' is not one of: length anchor" --by chain \
    --pretension 1=5e5 spread.ini
refused 'a body for nothing' 'option --body belongs to --move, --moves and --stiffness body' \
    --body floater --stiffness F1 spread.ini
refused 'about without stiffness' 'option --about belongs to --stiffness' --about 0,0,0 spread.ini
refused 'about two numbers' "option --about: '0,0': 3 numbers are expected, commas between them" --stiffness body --about 0,0 spread.ini
refused 'a move of three numbers' "option --move: '1,0,0': 6 numbers are expected, commas between them" --move 1,0,0 spread.ini
refused 'a move of words' "option --move: 'a': not a number" --move a,0,0,0,0,0 spread.ini
refused 'a move of a free body' "option --move: body 'floater' is free" --body floater \
    --move 1,0,0,0,0,0 --set tables.bodies=free-bodies.csv spread.ini
refused 'a move of no body' 'option --move: no body is held' --move 1,0,0,0,0,0 chain.ini
refused 'moves of an unknown body' "option --moves: there is no body 'ship'" --body ship \
    --moves moves.csv spread.ini
refused 'stiffness of an unknown body' "option --stiffness: there is no body 'ship'" --body ship \
    --stiffness body spread.ini
printf 'body,condition,x_m,y_m,z_m\nfloater,fixed,0,0,0\nbuoy,fixed,50,0,0\n' >two.csv
refused 'which of two bodies' 'option --move: 2 bodies are held: name one by --body' \
    --move 1,0,0,0,0,0 --set tables.bodies=two.csv spread.ini
runs 0 'one by name' gapnet --body floater --move 1,0,0,0,0,0 --set tables.bodies=two.csv spread.ini
refused 'pretension without a number' "option --pretension: '1': ROPE=TENSION is expected" \
    --pretension 1 spread.ini
refused 'pretension of a word' "option --pretension: 'much': not a number" --pretension 1=much spread.ini
refused 'a negative pretension' "option --pretension: '1=-5': a tension is positive" --pretension 1=-5 spread.ini
refused 'pretension of an unknown rope' "option --pretension: there is no rope '9'" --pretension 9=1e5 spread.ini
sed '2s/.*/1,A1,F1,chain,495/; 3s/.*/2,F1,F2,chain,45/; 4d' spread-ropes.csv >hung.csv
refused 'pretension by an anchor that is none' "option --pretension: rope '2' has no anchor" --by anchor \
    --pretension 2=1e5 --set tables.ropes=hung.csv spread.ini

# Systems that do not fit.
refused 'a slope of nothing' 'chain.ini: [environment] bed_slope needs a depth' \
    --set environment.depth= --set 'environment.bed_slope=0.1 0' chain.ini
refused 'depth and grid' 'chain.ini: [environment] give either depth or bed' \
    --set environment.bed=grid.csv chain.ini
sed 4d grid.csv >hole.csv
refused 'a grid with a hole' 'hole.csv: 3 points for 2 x by 2 y: no full grid' --set environment.depth= \
    --set environment.bed=hole.csv chain.ini
sed '4s/.*/-100,-100,-50/' grid.csv >twice.csv
refused 'a point twice' 'twice.csv:4: this point is there already' --set environment.depth= \
    --set environment.bed=twice.csv chain.ini
printf 'z_m,speed_m_s,direction_deg\n0,1,0\n-20,1,0\n-10,1,0\n' >mixed.csv
refused 'a current that turns back' 'mixed.csv:4: heights must ascend or descend' \
    --set tables.current=mixed.csv chain.ini
sed 's/-50$/-50.5/' nodes.csv >deep.csv
refused 'an anchor in the bed' "deep.csv:2: 'anchor' is held 0.5 m inside the bed" \
    --set tables.nodes=deep.csv chain.ini
sed 's/floater$/ship/' spread-nodes.csv >ship.csv
# rounded it is on the bed
sed 's/-50$/-50.00001/' nodes.csv >deep.csv
runs 0 'an anchor nearly on the bed' gapnet --set tables.nodes=deep.csv -d deep chain.ini
proven deep
refused 'a move into the bed' "spread-nodes.csv:3: 'F1' is held 3 m inside the bed" \
    --move 0,0,-75,0,0,0 spread.ini
refused 'an unknown body' "ship.csv:3: there is no body 'ship'" --set tables.nodes=ship.csv spread.ini
sed '3s/fixed/free/' spread-nodes.csv >loose.csv
refused 'a free node on a body' 'loose.csv:3: on a body its condition is fixed' \
    --set tables.nodes=loose.csv spread.ini
sed '1s/$/,waterplane_m2,volume_m3/; 2,$s/$/,,/; 3s/,,$/,1,1/' spread-nodes.csv >float.csv
refused 'a float on a body' 'float.csv:3: on a body a node is no float' --set tables.nodes=float.csv spread.ini
sed '1s/$/,kx_N_m/; 2,$s/$/,/; 3s/,$/,5/' spread-nodes.csv >spring.csv
refused 'a spring on a body' 'spring.csv:3: on a body a node has no spring' \
    --set tables.nodes=spring.csv spread.ini
sed 's/,fixed/,moored/' spread-bodies.csv >moored.csv
refused 'a body neither free nor fixed' "moored.csv:2: condition 'moored' is neither free nor fixed" \
    --set tables.bodies=moored.csv spread.ini
refused 'drag by an unknown word' "--set solve.drag: 'never' is not one of: renew hold" \
    --set solve.drag=never chain.ini
[ ! -e never ]
ok $? 'nothing was written'

# Slack chains: what lies without tension, on level and sloping beds, is drawn where it can lie.
for slope in 0 0.1 -0.1; do
    for friction in 0 0.05 0.5; do
        for x in 0 10 100 350; do
            printf 'node,condition,x_m,y_m,z_m\nanchor,fixed,%s,0,\nfairlead,fixed,0,0,0\n' $x >slack.csv
            runs 0 "slack: slope $slope, friction $friction, anchor at $x m" gapnet -d slack \
                --set tables.nodes=slack.csv --set environment.bed_slope="$slope 0" \
                --set environment.bed_friction=$friction chain.ini
            proven slack
        done
    done
done

# Over a tilted bed, the stiffness of a chain comes near to that of the continuous rope.
printf 'node,condition,x_m,y_m,z_m\nanchor,fixed,400,0,\nfairlead,fixed,0,0,0\n' >tilted.csv
for rope in catenary chain; do
    runs 0 "stiffness over a tilted bed: $rope" gapnet --rope $rope --set tables.nodes=tilted.csv \
        --set environment.bed_slope='0.05 0' --set solve.elements=400 -o $rope.csv \
        --stiffness fairlead chain.ini
done
agree catenary.csv chain.csv fairlead.x_m,fairlead.z_m 0.015 100 'the same, but for an element of 1 m'
finish
