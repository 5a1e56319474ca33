#!/bin/sh
# wirebeam as an engineer meets it: tables in and out, sections, hinges, springs, methods, modes,
# stability, refusals.
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../wiretap.sh"
cd "$scratch" || exit 1
quarter quarter
case=quarter/case.ini

runs 0 'nodes on standard output' wirebeam --method linear $case
header out 'node,x_m,y_m,z_m,ux_m,uy_m,uz_m,rx_rad,ry_rad,rz_rad,load_x_N,load_y_N,load_z_N,load_mx_Nm,load_my_Nm,load_mz_Nm,support_x_N,support_y_N,support_z_N,support_mx_Nm,support_my_Nm,support_mz_Nm,held' \
    'its columns'
about "$(cell out tip uz_m)" "$(awk 'BEGIN { pi = atan2(0, -1); print 0.01*(pi/4 + (3*pi/4 - 2)/0.77) }')" \
    0.01 'a quarter ring of two elements is within 1 %'
about "$(cell out foot support_z_N)" -0.01 1e-10 'its reaction'
about "$(cell out tip load_z_N)" 0.01 0 'its load'
about "$(cell out foot support_mx_Nm)" -0.01 1e-9 'the moments of the clamp ...'
about "$(cell out foot support_my_Nm)" 0.01 1e-9 '... are force times lever'
runs 0 'in equilibrium' wirebeam $case
mv out small.csv
about "$(cell small.csv tip uz_m)" "$(awk 'BEGIN { pi = atan2(0, -1); print 0.01*(pi/4 + (3*pi/4 - 2)/0.77) }')" \
    0.01 'the same where all is small'
runs 0 'all tables' wirebeam --modes 3 -d solved $case
[ ! -s out ] && [ "$(ls solved | tr '\n' ' ')" = 'forces.csv history.csv modes.csv nodes.csv shapes.csv summary.csv ' ]
ok $? 'six of them, nothing on standard output'
same small.csv solved/nodes.csv 'the same nodes'
header solved/forces.csv 'element,s_m,N_N,Mx_Nm,My_Nm,Mt_Nm,x_m,y_m,z_m,x0_m,y0_m,z0_m' 'columns of section forces'
header solved/modes.csv 'mode,omega_rad_s,frequency_Hz,period_s,lambda_1_s2' 'columns of modes'
header solved/history.csv 'step,time,iterations,residual,negative,energy_Nm,ux_m,uy_m,uz_m,rx_rad,ry_rad,rz_rad' \
    'columns of the history'
[ "$(value solved/summary.csv status)" = solved ]
ok $? 'the summary says so'
# torsion and bending along it: T = P R (1 - cos a), M = P R sin a, a from the tip
awk -F, 'NR > 1 { a = atan2(0, -1)/4*(3 - $1) - $2; M = sqrt($4^2 + $5^2); T = $6 < 0 ? -$6 : $6; n++
        if ((M - 0.01*sin(a))^2 > 4e-8 || (T - 0.01*(1 - cos(a)))^2 > 4e-8) { print "# " $0; bad = 1 } }
    END { exit bad || n != 10 }' solved/forces.csv
ok $? 'section forces along the curve, five points a element, to 2 % of the largest: tangents of two cubics'
runs 0 'modes alone' wirebeam --modes 3 -o modes.csv $case
same modes.csv solved/modes.csv 'modes on -o'
runs 0 'stresses without measures' wirebeam --stresses $case
says 'no section tells its extent' 'a warning'
printf 'section,shape,E_Pa,G_Pa,diameter_m\nw,round,1e9,1e9,0.01\n' >quarter/round.csv
runs 0 'stresses of a round wire' wirebeam --stresses --method linear --set tables.sections=round.csv $case
header out 'element,s_m,N_N,Mx_Nm,My_Nm,Mt_Nm,x_m,y_m,z_m,x0_m,y0_m,z0_m,axial_Pa,bending_Pa,shear_Pa,most_Pa,mises_Pa' \
    'columns with stresses'
awk -F, 'NR == 2 { W = atan2(0, -1)/32*1e-6; M = sqrt($4^2 + $5^2)/W; T = sqrt($6^2)/(2*W)
    d = $14/M - 1; e = $15/T - 1; g = $17/sqrt($16^2 + 3*T^2) - 1
    exit !(d^2 < 1e-20 && e^2 < 1e-20 && g^2 < 1e-20 && $16 - $14 - sqrt($13^2) < 1e-9) }' out
ok $? 'M/W, T/2W and both together'
runs 0 'the resolved case' wirebeam --print-case --set solve.steps=7 $case
sed 's,= \([a-z]*\.csv\),= quarter/\1,' out >resolved.ini
runs 0 'is one' wirebeam resolved.ini
"$compare" -r 1e-8 -a 1e-12 out small.csv >/dev/null 2>&1
ok $? 'and gives the same'

# Division: a half circle but a little as one element becomes pieces, a whole half is refused.
mkdir half
printf '[tables]\nsupports = supports.csv\nloads = loads.csv\n' >half/case.ini
printf 'node,x_m,y_m,z_m\na,1,0,0\nb,%s,0\n' \
    "$(awk 'BEGIN { printf "%.15g,%.15g", cos(2.9), sin(2.9) }')" >half/nodes.csv
printf 'element,node_a,node_b,section,tax,tay,taz,tbx,tby,tbz\nbow,a,b,w,0,1,0,%s,0\n' \
    "$(awk 'BEGIN { printf "%.15g,%.15g", -sin(2.9), cos(2.9) }')" >half/elements.csv
cp quarter/sections.csv half
printf 'node,ux,uy,uz,rx,ry,rz\na,0,0,0,0,0,0\n' >half/supports.csv
printf 'node,fz_N\nb,1e-4\n' >half/loads.csv
runs 0 'one long bow' wirebeam --method linear -d half/solved --set solve.largest_angle=12 half/case.ini
[ "$(value half/solved/summary.csv pieces)" = 8 ] && [ "$(wc -l <half/solved/nodes.csv)" -eq 3 ]
ok $? 'is divided; the table of nodes has its own'
about "$(value half/solved/summary.csv largest_force_N)" 1e-4 1e-6 'its largest force is the load'
about "$(value half/solved/summary.csv length_m)" 2.9 1e-4 'its length is the arc'
about "$(cell half/solved/nodes.csv b uz_m)" "$(awk 'BEGIN { b = 2.9
    print 1e-4*((b/2 - sin(2*b)/4) + (1.5*b - 2*sin(b) + sin(2*b)/4)/0.77) }')" 1e-3 'and moves as one'
runs 2 'without division' wirebeam --set solve.divide=no half/case.ini
says 'elements.csv:2: its end tangent is 83.08 degrees off the chord' 'it is refused with the angle'
sed -i 's/^bow.*/bow,a,b,w,0,1,0,0,-1,0/' half/elements.csv
sed -i 's/^b,.*/b,-1,0,0/' half/nodes.csv
runs 2 'half a circle' wirebeam half/case.ini
says 'its end tangent is 90 degrees off the chord' 'is refused with the angle, too'

# Section axes: psi, its third value, or directions; a strip bends about its weak axis.
mkdir strip
cp quarter/case.ini quarter/supports.csv strip
printf 'node,x_m,y_m,z_m\nfoot,0,0,0\ntip,1,0,0\n' >strip/nodes.csv
printf 'section,shape,E_Pa,G_Pa,width_m,height_m\ns,rectangle,1e9,4e8,0.02,0.01\n' >strip/sections.csv
printf 'node,fy_N,fz_N\ntip,1e-4,1e-4\n' >strip/loads.csv
weak=$(awk 'BEGIN { print 1e-4/3/(1e9*0.02*0.01^3/12) }')
strong=$(awk 'BEGIN { print 1e-4/3/(1e9*0.01*0.02^3/12) }')
printf 'element,node_a,node_b,section\n1,foot,tip,s\n' >strip/elements.csv
runs 0 'a strip' wirebeam --method linear strip/case.ini
about "$(cell out tip uz_m)" "$strong" 1e-5 'its x axis begins in the plane of z: stiff upright ...'
about "$(cell out tip uy_m)" "$weak" 1e-5 '... and soft across'
printf 'element,node_a,node_b,section,psi_a_deg,psi_b_deg\n1,foot,tip,s,90,90\n' >strip/elements.csv
runs 0 'psi = 90' wirebeam --method linear strip/case.ini
about "$(cell out tip uz_m)" "$weak" 1e-5 'turns it'
printf 'element,node_a,node_b,section,xax,xay,xaz,xbx,xby,xbz\n1,foot,tip,s,3,1,0,0,2,0\n' >strip/elements.csv
runs 0 'a direction' wirebeam --method linear strip/case.ini
about "$(cell out tip uz_m)" "$weak" 1e-5 'does so, too'
printf 'element,node_a,node_b,section,psi_a_deg,psi_b_deg,psi_mid_deg\n1,foot,tip,s,0,0,90\n' >strip/elements.csv
wirebeam --method linear --set solve.largest_angle=85 -o whole.csv strip/case.ini
wirebeam --method linear --set solve.largest_angle=4 -o pieces.csv strip/case.ini
about "$(cell whole.csv tip uz_m)" "$(cell pieces.csv tip uz_m)" 2e-3 'a third value in the middle: whole and in pieces'

# General sections: with the diagonal of an ordinary one the same; a coupling twists what is pulled.
printf 'section,shape,k_nn_N,k_nt_Nm,k_xx_Nm2,k_yy_Nm2,k_tt_Nm2,mass_kg_m\nw,general,1e7,,1,1,0.77,10\n' >general.csv
runs 0 'a general section' wirebeam --set tables.sections=../general.csv --modes 2 $case
"$compare" -r 1e-6 -a 1e-9 out modes.csv >/dev/null 2>&1
[ $? -ne 2 ] && about "$(cell out 1 omega_rad_s)" "$(cell modes.csv 1 omega_rad_s)" 1e-6 'of the same stiffness and mass vibrates the same'
mkdir pulled
printf '[tables]\nsupports = s.csv\nloads = l.csv\nsections = g.csv\n' >pulled/case.ini
printf 'section,shape,k_nn_N,k_nt_Nm,k_xx_Nm2,k_yy_Nm2,k_tt_Nm2\ns,general,4,1,1,1,1\n' >pulled/g.csv
printf 'node,x_m,y_m,z_m\nfoot,0,0,0\ntip,0,0,1\n' >pulled/nodes.csv
printf 'element,node_a,node_b,section\n1,foot,tip,s\n' >pulled/elements.csv
printf 'node,ux,uy,uz,rx,ry,rz\nfoot,0,0,0,0,0,0\n' >pulled/s.csv
printf 'node,fz_N\ntip,3e-6\n' >pulled/l.csv
runs 0 'tension and torsion' wirebeam pulled/case.ini
about "$(cell out tip uz_m)" 1e-6 1e-5 'coupled: 1/(4 - 1) of the force'
about "$(cell out tip rz_rad)" -1e-6 1e-5 'and it turns'

# Hinges, springs, own weight, prescribed moves.
mkdir hinge
printf '[tables]\nsupports = s.csv\nloads = l.csv\nsections = ../quarter/sections.csv\n' >hinge/case.ini
printf 'node,x_m,y_m,z_m\na,0,0,0\nb,0.5,0,0\nc,1,0,0\n' >hinge/nodes.csv
printf 'element,node_a,node_b,section,hinge_a,hinge_b\n1,a,b,w,,xy\n2,b,c,w,,\n' >hinge/elements.csv
printf 'node,ux,uy,uz,rx,ry,rz\na,0,0,0,0,0,0\nc,,0,0,,,\n' >hinge/s.csv
printf 'element,qz_N_m\n2,-1\n' >hinge/l.csv
runs 0 'a hinge' wirebeam --method linear -d hinge/solved hinge/case.ini
about "$(cell hinge/solved/nodes.csv a support_my_Nm)" -0.125 1e-9 'statics: q l/2 of the bar at the cantilever'
about "$(cell hinge/solved/nodes.csv c support_z_N)" 0.25 1e-9 'and half at its support'
awk -F, 'function m(x) { return sqrt(x*x) } $1 == 1 && $2 == 0.25 { a = m($5) + m($4) } $1 == 2 && $2 == 0.25 { b = m($5) + m($4) }
    END { exit !(m(a - 0.0625) < 1e-9 && m(b - 0.03125) < 1e-9) }' hinge/solved/forces.csv
ok $? 'moments in the middle of both: linear, and q l^2/8'
sed -i 's/,xy$/,xq/' hinge/elements.csv
runs 2 'a hinge of no axis' wirebeam hinge/case.ini
says "hinge 'xq' is not made of x, y and t" 'is refused'
wirebeam --method linear -o linear.csv $case
printf 'spring,node_a,node_b,kz_N_m\n1,tip,,7\n' >quarter/springs.csv
runs 0 'a spring to the ground' wirebeam --set tables.springs=springs.csv --method linear $case
about "$(awk -v free="$(cell linear.csv tip uz_m)" -v x="$(cell out tip uz_m)" 'BEGIN { print 0.01/x - 0.01/free }')" 7 \
    1e-4 'adds to the stiffness'
printf 'spring,node_a,node_b,kx_N_m,xx,xy,xz\n1,tip,,7,0,0,-2\n' >quarter/springs.csv
wirebeam --set tables.springs=springs.csv --method linear -o turned.csv $case
"$compare" -r 1e-12 -a 1e-15 out turned.csv >/dev/null 2>&1
ok $? 'the same by its direction'
runs 0 'own weight' wirebeam --set tables.loads= --set 'gravity.acceleration=0 0 -0.0981' -d weight $case
about "$(cell weight/nodes.csv foot support_z_N)" "$(awk 'BEGIN { print 0.981*atan2(0, -1)/2 }')" 2e-3 \
    'is carried by the clamp (length of two cubics)'
printf 'node,ux,uy,uz,rx,ry,rz\nfoot,0,0,0,0,0,0\ntip,,,0.1,,,\n' >quarter/moved.csv
runs 0 'a prescribed move' wirebeam --set tables.loads= --set tables.supports=moved.csv $case
about "$(cell out tip uz_m)" 0.1 1e-12 'is made'
about "$(cell out foot support_z_N)" "$(awk -v f="$(cell out tip support_z_N)" 'BEGIN { printf "%.17g", -f }')" 1e-9 'and balanced'

# Methods, stages, paths.
runs 0 'method updated, little load' wirebeam --method updated --set solve.steps=50 -d updated $case
about "$(cell updated/nodes.csv tip uz_m)" "$(cell small.csv tip uz_m)" 0.01 'agrees where all is small'
about "$(cell updated/nodes.csv foot support_z_N)" -0.01 1e-6 'its clamp carries the load'
"$wire/straight" wire
runs 1 'method updated, large' wirebeam --method updated wire/case.ini
says 'did not come to rest; take more steps' 'says what it needs'
runs 2 'method updated with prescribed moves' wirebeam --method updated --set tables.supports=moved.csv $case
says 'method updated does not take prescribed displacements' 'is refused'
printf 'node,fx_N,fy_N,fz_N,stage\ntip,,,0.3,1\ntip,0.2,,,2\n' >quarter/two.csv
printf 'node,fx_N,fy_N,fz_N\ntip,0.2,,0.3\n' >quarter/both.csv
wirebeam --set tables.loads=two.csv -o two.csv $case
runs 0 'two stages' wirebeam --set tables.loads=both.csv $case
awk -v a="$(cell out tip uz_m)" -v b="$(cell two.csv tip uz_m)" -v c="$(cell out tip ux_m)" -v d="$(cell two.csv tip ux_m)" \
    'BEGIN { exit !(a > 0.2 && (a - b)^2 < 1e-16 && (c - d)^2 < 1e-16) }'
ok $? 'end where both loads at once do'
# a shallow arch, clamped at both ends, pressed through at its crown
"$wire/arc" arch 1 60 20 0.02
printf 'node,fx_N\nn10,6e4\n' >arch/loads.csv
printf 'node,ux,uy,uz,rx,ry,rz\nn0,0,0,0,0,0,0\nend,0,0,0,0,0,0\n' >arch/supports.csv
runs 1 'too few steps' wirebeam --set solve.most_steps=2 -d arch/solved arch/case.ini
says 'no equilibrium found beyond time' 'say how far it came'
[ "$(value arch/solved/summary.csv status)" = not-solved ]
ok $? 'and so does the summary'
printf 'node,fx_N,fy_N\nn10,%s\n' "$(awk 'BEGIN { a = atan2(0, -1)/6; print 1e5*cos(a) "," (-1e5*sin(a)) }')" >arch/loads.csv
runs 0 'an arch by arc length' wirebeam --set solve.path=arc --set solve.steps=40 --set solve.most_steps=400 \
    --set solve.watch=n10 -d arch/arc arch/case.ini
awk -F, 'NR > 2 { if ($2 < t) back++; t = $2; if ($5 > 0) unstable++ } END { exit !(back > 5 && unstable > 5 && t > 0) }' \
    arch/arc/history.csv
ok $? 'passes limit points: the load goes back, and pivots are negative there'
# clamped rod: E I = G It = 1, length 1
mkdir rod
printf '[tables]\nsupports = s.csv\nloads = l.csv\n' >rod/case.ini
awk 'BEGIN { print "node,x_m,y_m,z_m"; for (i = 0; i <= 40; i++) print "n" i "," i/40 ",0,0" }' >rod/nodes.csv
awk 'BEGIN { print "element,node_a,node_b,section"; for (i = 1; i <= 40; i++) print i ",n" i - 1 ",n" i ",w" }' >rod/elements.csv
printf 'section,E_Pa,G_Pa,area_m2,Ixx_m4,Iyy_m4,It_m4,density_kg_m3\nw,1e9,1e9,1e-2,1e-9,1e-9,1e-9,1000\n' >rod/sections.csv
printf 'node,ux,uy,uz,rx,ry,rz\nn0,0,0,0,0,0,0\nn40,,0,0,,0,0\n' >rod/s.csv
printf 'node,fx_N\nn40,-60\n' >rod/l.csv
runs 0 'a column' wirebeam --set solve.critical=yes --set solve.steps=20 -d rod/solved rod/case.ini
says 'stability is lost at time' 'loses its stability'
about "$(value rod/solved/summary.csv critical_time)" "$(awk 'BEGIN { printf "%.12g", 4*atan2(0, -1)^2/60 }')" 1e-5 \
    'at 4 pi^2 EI/L^2 (squeezed by 6e-8)'
runs 0 'beyond it' wirebeam --modes 2 --set solve.steps=1 -d rod/solved rod/case.ini
says 'the equilibrium is unstable: 2 negative pivots' 'the straight state is unstable, in both planes'
awk -F, 'NR > 1 && ($2 != "" || !($5 < 0)) { bad = 1 } END { exit bad || NR != 3 }' rod/solved/modes.csv
ok $? 'which its modes say, too'
printf 'node,fx_N\nn40,-30\n' >rod/l.csv
runs 0 'critical beyond the load' wirebeam --set solve.critical=yes rod/case.ini
says 'stability was not lost until time 1' 'is told'
runs 0 'a free wire' wirebeam --set tables.supports= --set tables.loads= --modes 8 rod/case.ini
awk -F, 'NR > 1 && NR < 8 && ($5 > 1e-4 || $5 < -1e-4) { bad = 1 } NR == 8 { w = $2*sqrt(10) }
    END { exit bad || (w - 22.3733)^2 > 1e-4 }' out
ok $? 'vibrates: six times zero, then 22.3733'

# Refusals.
refused()
{
    name=$1
    text=$2
    shift 2
    runs 2 "$name" wirebeam "$@" $case
    says "$text" "$name: is told"
}
sed '2s/middle/centre/' quarter/elements.csv >quarter/name.csv
refused 'an unknown node' "name.csv:2: there is no node 'centre'" --set tables.elements=name.csv
sed '2s/,w,/,v,/' quarter/elements.csv >quarter/of.csv
refused 'an unknown section' "of.csv:2: there is no section 'v'" --set tables.elements=of.csv
sed '3s/^2/1/' quarter/elements.csv >quarter/twice.csv
refused 'a name twice' "twice.csv:3: '1' is there already, in line 2" --set tables.elements=twice.csv
sed '2s/middle/foot/' quarter/elements.csv >quarter/loop.csv
refused 'an element of no length' "the nodes 'foot' and 'foot' are at one place" --set tables.elements=loop.csv
sed '2s/0,1,0,1,1,0/0,1,,1,1,0/' quarter/elements.csv >quarter/part.csv
refused 'a direction cut short' 'part.csv:2: a direction needs all of its three numbers' --set tables.elements=part.csv
sed '2s/0,1,0,1,1,0/0,0,0,1,1,0/' quarter/elements.csv >quarter/zero.csv
refused 'a direction of nothing' 'zero.csv:2: a direction is zero' --set tables.elements=zero.csv
sed '2s/0,1,0,1,1,0/-1,-2.4142135624,0,1,1,0/' quarter/elements.csv >quarter/back.csv
refused 'a tangent back' 'back.csv:2: the tangent of end a points straight back' --set tables.elements=back.csv
{ cat quarter/nodes.csv; echo lost,5,5,5; } >quarter/lost.csv
refused 'a node alone' "lost.csv:5: no element leads to node 'lost'" --set tables.nodes=lost.csv
printf 'node,ux,ux\nfoot,0,0\n' >quarter/double.csv
refused 'a column twice' "columns 2 and 3 are both 'ux'" --set tables.supports=double.csv
printf 'node,ux\nfoot,0\nfoot,1\n' >quarter/again.csv
refused 'held twice' "again.csv:3: ux of node 'foot' is held already" --set tables.supports=again.csv
printf 'node,element,fz_N,qz_N_m\ntip,1,1,\n' >quarter/load.csv
refused 'a load of two' 'load.csv:2: a load needs either a node or an element' --set tables.loads=load.csv
printf 'node,element,fz_N,qz_N_m\ntip,,1,1\n' >quarter/load.csv
refused 'a wrong load' 'load.csv:2: qz_N_m does not belong to a load of a node' --set tables.loads=load.csv
printf 'node,fz_N,stage\ntip,1,1.5\n' >quarter/load.csv
refused 'half a stage' 'load.csv:2: stage must be a whole number' --set tables.loads=load.csv
printf 'section,shape,E_Pa,G_Pa,diameter_m\nw,square,1,1,1\n' >quarter/shape.csv
refused 'an unknown shape' "shape 'square' is none of round" --set tables.sections=shape.csv
printf 'section,shape,E_Pa,G_Pa,diameter_m,wall_m\nw,tube,1,1,1,0.6\n' >quarter/shape.csv
refused 'a thick tube' 'the wall is thicker than half the diameter' --set tables.sections=shape.csv
printf 'section,shape,E_Pa,G_Pa,diameter_m,wall_m\nw,round,1,1,1,0.6\n' >quarter/shape.csv
refused 'a wall of a wire' 'wall_m does not belong to the shape round' --set tables.sections=shape.csv
printf 'section,shape,E_Pa,G_Pa\nw,round,1,1\n' >quarter/shape.csv
refused 'no diameter' 'the shape round needs the column diameter_m' --set tables.sections=shape.csv
printf 'section,shape,k_nn_N,k_nt_Nm,k_xx_Nm2,k_yy_Nm2,k_tt_Nm2\nw,general,1,2,1,1,1\n' >quarter/shape.csv
refused 'an indefinite stiffness' 'the stiffness is not positive definite' --set tables.sections=shape.csv
refused 'an unknown key' "unknown key 'step' in [solve]" --set solve.step=3
refused 'an unknown method' "option --method: 'exact' is not one of: equilibrium linear updated" --method exact
refused 'an unknown node to watch' "[solve] watch: there is no node 'Q'" --set solve.watch=Q
refused 'modes of linear theory' 'option --modes belongs to method equilibrium' --modes 3 --method linear
refused 'too many modes' 'there are only 12 unknowns' --modes 13
sed 's/,density_kg_m3//; s/,1000$//' quarter/sections.csv >quarter/light.csv
refused 'modes without mass' "the section of element '1' has no density_kg_m3" --modes 3 --set tables.sections=light.csv

# Numbers that cannot be meant, and turns that meet.
"$top/scripts/wire/helix" spring 0.02 0.01 6 12 0.004 -100
runs 0 'a spring' wirebeam spring/case.ini
[ ! -s err ]
ok $? 'has nothing that is doubted'
printf 'section,shape,E_Pa,G_Pa,density_kg_m3,diameter_m\nwire,round,2.06e11,7.9e10,%s\n' 7850,4 \
    >spring/wrong.csv
runs 0 'a wire of four metres' wirebeam --set tables.sections=wrong.csv spring/case.ini
says 'spring/wrong.csv:2: 4 m thick, but element ' 'is doubted'
printf 'section,shape,E_Pa,G_Pa,density_kg_m3,diameter_m\nwire,round,7.9e10,2.06e11,7.85,0.004\n' \
    >spring/wrong.csv
runs 0 'E and G swapped, g/cm3' wirebeam --set tables.sections=wrong.csv spring/case.ini
says 'wrong.csv:2: E_Pa and G_Pa make a Poisson ratio of -0.808, not within' 'Poisson ratio'
says 'wrong.csv:2: a density of 7.85 kg/m3: is the unit right?' 'density'
printf 'section,shape,E_Pa,G_Pa,diameter_m\nwire,round,2.06e8,7.9e7,0.004\n' >spring/wrong.csv
runs 0 'kilonewtons' wirebeam --method linear --set tables.sections=wrong.csv spring/case.ini
says 'spring/elements.csv:' 'a large strain has its line'
says 'where small ones are computed: is the unit right?' 'and is doubted'
for force in -400 -600; do
    printf 'node,fz_N\nend,%s\n' $force >spring/loads.csv
    runs 0 "turns that meet, $force N" wirebeam spring/case.ini
    says 'is 0.004 m thick: contact is not computed' 'are told'
done
# turned as a whole no element comes near another one
printf 'node,ux,uy,uz,rx,ry,rz\nn0,0,0,0,3.1,0,0\n' >spring/supports.csv
printf 'node,fz_N\nend,0.01\n' >spring/loads.csv
runs 0 'a spring that is turned over' wirebeam --set solve.steps=20 spring/case.ini
[ ! -s err ]
ok $? 'has turns that keep their distance'

runs 2 'no operand' wirebeam
runs 2 'both -o and -d' wirebeam -o never.csv -d never $case
runs 2 'no such case' wirebeam nothing.ini
printf 'node,ux,uy,uz\nfoot,0,0,0\n' >quarter/loose.csv
for method in equilibrium linear; do
    runs 1 "a mechanism, $method" wirebeam --method $method --set tables.supports=loose.csv $case
    says 'a mechanism: nothing holds node' 'is told'
done
[ ! -e never.csv ] && [ ! -e never ]
ok $? 'nothing was written'
finish
