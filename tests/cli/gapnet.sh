#!/bin/sh
# gapnet and gapcheck as a mooring engineer meets them: tables in and out, methods, proofs, refusals.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
nets=$top/scripts/experiments/nets
cp -r "$nets/mooring" mooring
system=mooring/system.ini

# column NAME FILE: of all rows.
column()
{
    awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i; next }
        { print $at }' "$2"
}

runs 0 'nodes on standard output' gapnet --rope chain $system
header out 'node,x_m,y_m,z_m,fx_N,fy_N,fz_N,residual_N,load_x_N,load_y_N,load_z_N,support_x_N,support_y_N,support_z_N,held' \
    'its columns'
cp out nodes.csv
holds 'n == 6 && abs(f[4, 2] - 30.198) < 5e-4 && abs(f[4, 4] - 93.111) < 5e-4' nodes.csv \
    'the mooring of Bild 6 with 20 elements a rope'
runs 0 'all tables' gapnet --rope chain -d solved $system
[ ! -s out ] && [ "$(ls solved | tr '\n' ' ')" = 'history.csv nodes.csv ropes.csv shapes.csv summary.csv ' ]
ok $? 'five of them, nothing on standard output'
same nodes.csv solved/nodes.csv 'the same nodes'
header solved/ropes.csv 'rope,tension_a_N,tension_b_N,tension_max_N,tension_min_N,length_m,length_on_bed_m,ta_x_N,ta_y_N,ta_z_N,tb_x_N,tb_y_N,tb_z_N,node_a,node_b,unstretched_m,elements,ea_N,use,lowest_z_m,remark,law' \
    'columns of ropes'
header solved/shapes.csv 'rope,joint,x_m,y_m,z_m,tension_N,load_x_N,load_y_N,load_z_N,s_m,tx_N,ty_N,tz_N,strain,bed_N' \
    'columns of shapes'
header solved/history.csv 'step,mean_gap,largest_gap,residual_N,factor' 'columns of the history'
[ "$(column steps solved/summary.csv)" -le 12 ]
ok $? 'in at most 12 steps'

# The proof, and that it sees what is wrong.
for rope in chain catenary auto; do
    runs 0 "$rope" gapnet --rope $rope -d "by-$rope" $system
    runs 0 "$rope: proven" gapcheck "by-$rope"
    holds 'f[1, 6] < 1e-13 && f[1, 8] < 1e-13 && f[1, 10] < 1e-13' out "$rope: to round-off"
done
# change FILE COLUMN ROW FACTOR: one number of a copy of the tables
change()
{
    rm -rf wrong
    cp -r by-chain wrong
    awk -F, -v OFS=, -v name="$2" -v row="$3" -v factor="$4" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i }
        NR == row + 1 { $at = sprintf("%.17g", $at*factor) } { print }' "by-chain/$1" >"wrong/$1"
}
change nodes.csv z_m 4 1.00000001
runs 1 'a node beside its ropes' gapcheck wrong
says "misses by" 'is told'
change nodes.csv load_z_N 4 1.0001
runs 1 'a load that nothing carries' gapcheck wrong
says "node 'B1' is out of balance" 'is told with its name'
change ropes.csv tb_z_N 2 1.0001
runs 1 'an end tension' gapcheck wrong
change shapes.csv tx_N 9 1.00001
runs 1 'a tension within a rope' gapcheck wrong
says "rope 'leg1' is out of balance" 'is told with its rope'
change shapes.csv strain 9 1.1
runs 1 'a strain' gapcheck wrong
change shapes.csv y_m 30 1.0001
runs 1 'a joint' gapcheck wrong
change nodes.csv support_x_N 5 1
sed -i '6s/0,0,0,$/5,0,0,/' wrong/nodes.csv
runs 2 'a support where nothing is held' gapcheck wrong
head -n 40 by-chain/shapes.csv >wrong/shapes.csv
cp by-chain/nodes.csv wrong/nodes.csv
runs 2 'shapes that are cut short' gapcheck wrong
change ropes.csv ea_N 2 1.001
runs 1 'strains that are not of the rope' gapcheck wrong
change ropes.csv unstretched_m 2 1.001
runs 2 'lengths that are not of the rope' gapcheck wrong
says "s_m does not belong" 'are told'
change shapes.csv tx_N 9 1e300
sed -i '9s/,[-0-9.e+]*\(,[^,]*,[^,]*\)$/,nan\1/' wrong/shapes.csv
runs 2 'a tension that is no number' gapcheck wrong
runs 2 'no such directory' gapcheck nowhere
runs 2 'gapcheck without an operand' gapcheck

# Methods.
runs 0 'displacement' gapnet --method displacement --rope chain -o moved.csv $system
"$compare" -r 1e-8 -a 1e-6 nodes.csv moved.csv >/dev/null 2>&1
ok $? 'is where the gap method is'
runs 2 'imaginary reactions on a closed system' gapnet --method imaginary $system
says 'closed parts' 'are refused by their reason'
runs 2 'displacement of continuous ropes' gapnet --method displacement --rope catenary $system
says 'take --rope chain' 'is refused with the way out'
runs 0 'two methods' gapnet --verify --rope chain -d verified $system
awk -v x="$(column verify_m verified/summary.csv)" 'BEGIN { exit !(x != "" && x < 1e-7) }'
ok $? 'agree, and the summary says so'
cat >tree.ini <<END
[environment]
water_density = 0
[tables]
nodes = tree-nodes.csv
ropes = tree-ropes.csv
types = mooring/types.csv
END
printf 'node,condition,x_m,y_m,z_m,fz_N\na,fixed,0,0,0,\nb,fixed,100,0,0,\nc,fixed,50,80,0,\nd,free,,,,12000\n' \
    >tree-nodes.csv
printf 'rope,node_a,node_b,type,length_m\n1,a,d,rope,90\n2,b,d,rope,95\n3,c,d,rope,100\n' >tree-ropes.csv
runs 0 'a tree' gapnet -o tree.csv tree.ini
for step in constant unit span; do
    runs 0 "imaginary, $step" gapnet --method imaginary --step $step --set solve.steps=100000 \
        -o "tree-$step.csv" tree.ini
    "$compare" -r 1e-6 -a 1e-5 tree.csv "tree-$step.csv" >/dev/null 2>&1
    ok $? "imaginary, $step: where the gap method is"
done

# Displacement with a folded chain: its middle element is slack, which the gap method has to be told.
printf 'type,diameter_m,mass_kg_m,ea_N\nheavy,0.05,50,2e6\n' >fold-types.csv
printf 'node,condition,x_m,y_m,z_m\na,fixed,0,0,0\nb,fixed,3,0,0\n' >fold-nodes.csv
printf 'rope,node_a,node_b,type,length_m,elements\n1,a,b,heavy,30,3\n' >fold-ropes.csv
sed 's/tree-/fold-/; s,mooring/types,fold-types,' tree.ini >fold.ini
runs 0 'displacement, folded' gapnet --method displacement -d folded fold.ini
runs 0 'is proven' gapcheck folded

# Stiffness: symmetric, as CSV and as the file that another system takes for a spring.
runs 0 'stiffness' gapnet --stiffness A1,B2 --rope chain $system
header out 'force_N,A1.x_m,A1.y_m,A1.z_m,B2.x_m,B2.y_m,B2.z_m' 'its columns'
holds 'n == 6 && abs(f[1, 5] - f[4, 2]) < 1e-9 && abs(f[3, 6] - f[5, 4]) < 1e-9 && f[1, 2] > 0' out \
    'it is symmetric'
runs 0 'stiffness of one node to a directory' gapnet --stiffness d -d part tree.ini
[ -s part/stiffness.npy ] && [ -s part/stiffness.csv ] && [ -s part/nodes.csv ]
ok $? 'and the tables'
# a substructure: d held by its stiffness moves under a small load as the whole does
x=$(column x_m part/nodes.csv | tail -n 1)
y=$(column y_m part/nodes.csv | tail -n 1)
z=$(column z_m part/nodes.csv | tail -n 1)
for push in 0 1; do
    printf 'node,condition,x_m,y_m,z_m,fx_N,stiffness\nd,free,%s,%s,%s,%s,part/stiffness.npy\ne,fixed,0,0,0,0,\n' \
        "$x" "$y" "$z" $push >sub-nodes.csv
    printf 'type,diameter_m,mass_kg_m,ea_N\nthread,0,0,0.01\n' >sub-types.csv
    printf 'rope,node_a,node_b,type,length_m\n1,d,e,thread,50\n' >sub-ropes.csv
    sed 's/tree-/sub-/; s,mooring/types,sub-types,' tree.ini >sub.ini
    runs 0 "a substructure, pushed by $push N" gapnet -o "sub$push.csv" sub.ini
done
printf 'node,fx_N,fy_N,fz_N\nd,1,0,0\n' >push.csv
runs 0 'the whole' gapnet --set tables.loads=push.csv -o pushed.csv tree.ini
awk -v a="$(column x_m sub0.csv | head -n 1)" -v b="$(column x_m sub1.csv | head -n 1)" -v x="$x" \
    -v y="$(column x_m pushed.csv | tail -n 1)" \
    'BEGIN { exit !(y > x && ((b - a) - (y - x))^2 < (1e-3*(y - x))^2) }'
ok $? 'moves as its substructure does'

# Tables of tension and strain, bars, floats, conditions.
printf 'strain,tension_N\n0,0\n0.01,20000\n0.02,60000\n' >rope.csv
printf 'type,diameter_m,mass_kg_m,tension_table,breaking_N\nsoft,0.05,5,rope.csv,70000\n' >soft.csv
runs 0 'a tension table' gapnet --set tables.types=soft.csv -d soft $(sed 's/,rope,/,soft,/' tree-ropes.csv >soft-ropes.csv; echo --set tables.ropes=soft-ropes.csv) tree.ini
runs 0 'is proven' gapcheck soft
printf 'strain,tension_N\n0.01,2000\n' >rope.csv
runs 2 'a table that ends too soon' gapnet --set tables.types=soft.csv --set tables.ropes=soft-ropes.csv tree.ini
says 'its tension table ends at 2000 N' 'is not extrapolated'
printf 'strain,tension_N\n0.01,2000\n0.01,3000\n' >rope.csv
runs 2 'a table that does not ascend' gapnet --set tables.types=soft.csv --set tables.ropes=soft-ropes.csv tree.ini
printf 'type,diameter_m,mass_kg_m,ea_N,breaking_N\nrope,0.05,5,1e7,3000\n' >weak.csv
runs 0 'a weak rope' gapnet --set tables.types=weak.csv -d weak tree.ini
says 'is over its breaking load' 'is told'
[ "$(column over_breaking weak/summary.csv)" -gt 0 ] && grep -q 'over its breaking load' weak/ropes.csv
ok $? 'and stands in the tables'
printf 'node,condition,x_m,y_m,z_m,fz_N\na,fixed,0,0,0,\nb,fixed,0,0,3,\nc,y,4,0,0,-1000\n' >tree-nodes.csv
printf 'rope,node_a,node_b,type,length_m,elements\n1,a,c,bar,4,1\n2,b,c,bar,5,1\n' >tree-ropes.csv
printf 'type,diameter_m,mass_kg_m,ea_N\nbar,0,0,1e9\n' >bar.csv
runs 0 'a bracket of bars' gapnet --set tables.types=bar.csv -d bars tree.ini
runs 0 'is proven' gapcheck bars
[ "$(column remark bars/ropes.csv | tr '\n' ' ')" = 'compression  ' ] &&
    [ "$(column compression bars/summary.csv)" = 1 ]
ok $? 'the bar that is pushed is named'
printf 'rope,node_a,node_b,type,length_m,elements\n1,a,c,bar,4,1\n' >tree-ropes.csv
runs 1 'a mechanism' gapnet --set tables.types=bar.csv tree.ini
says "nothing holds node 'c'" 'is named'

# Slack: folded ropes, parallel ones, nothing that pulls; loads on what is held pull at no rope.
cat >slack.ini <<END
[environment]
water_density = 0
[tables]
nodes = slack-nodes.csv
ropes = slack-ropes.csv
types = slack-types.csv
END
printf 'type,diameter_m,mass_kg_m,ea_N\nheavy,0.05,50,2e4\nnone,0.01,0,1e7\n' >slack-types.csv
printf 'node,condition,x_m,y_m,z_m,fz_N\na,fixed,0,0,0,9000\nb,fixed,3,0,0,\nc,free,,,,0\n' >slack-nodes.csv
for elements in '' 2 3 4 30; do
    printf 'rope,node_a,node_b,type,length_m,elements\n1,a,b,heavy,30,%s\n2,a,c,heavy,5,%s\n3,a,b,none,9,\n' \
        "$elements" "$elements" >slack-ropes.csv
    runs 0 "folded, elements '$elements'" gapnet -d slack slack.ini
    runs 0 'is proven' gapcheck slack
done
printf 'rope,node_a,node_b,type,length_m,elements\n1,a,b,none,30,\n2,a,b,none,30,7\n3,c,b,none,9,\n' >slack-ropes.csv
runs 0 'nothing that pulls' gapnet -d slack slack.ini
runs 0 'is proven' gapcheck slack
[ "$(column slack slack/summary.csv)" = 3 ]
ok $? 'all are slack'
printf 'strain,tension_N\n0.01,20000\n0.02,60000\n' >rope.csv
printf 'type,diameter_m,mass_kg_m,tension_table\nbar,0,0,rope.csv\n' >slack-types.csv
printf 'rope,node_a,node_b,type,length_m,elements\n1,a,b,bar,2.96,1\n' >slack-ropes.csv
printf 'node,condition,x_m,y_m,z_m\na,fixed,0,0,0\nb,fixed,3,0,0\n' >slack-nodes.csv
runs 0 'a bar with a tension table' gapnet -d slack slack.ini
runs 0 'is proven' gapcheck slack

printf 'rope,node_a,node_b,type,length_m,elements\n1,a,b,bar,3.01,1\n' >slack-ropes.csv
runs 2 'a bar with a tension table that is pushed' gapnet slack.ini
says 'its tension table starts at nothing' 'is told'

# Lint.
runs 0 'lint: nothing' gapnet --lint $system
sed 's/^leg1,A1,B1,rope,120/leg1,A1,A2,rope,100/' mooring/ropes.csv >mooring/short.csv
runs 1 'lint: a rope too short' gapnet --lint --set tables.ropes=short.csv $system
says 'short.csv:2: its nodes are 173.205 m apart, 73.2 % more than its length' 'is told with its line'
printf 'node,condition,x_m,y_m,z_m,volume_m3\nA1,fixed,100,0,0,\nA2,fixed,-50,80,0,\nA3,fixed,-50,-80,0,\nB1,free,0,0,5,2\nB2,free,,,,2\nB3,free,,,,2\n' >mooring/high.csv
runs 1 'lint: a float above the water' gapnet --lint --set tables.nodes=high.csv \
    --set environment.water_density=1025 $system
says 'high.csv:5' 'is told with its line'

# Refusals: what, where.
# refused NAME TEXT OPTION...
refused()
{
    name=$1
    text=$2
    shift 2
    runs 2 "$name" gapnet "$@" -o never.csv $system
    says "$text" "$name: $text"
}
sed 's/,B1,rope/,B9,rope/' mooring/ropes.csv >mooring/unknown.csv
refused 'an unknown node' "unknown.csv:2: there is no node 'B9'" --set tables.ropes=unknown.csv
sed '3s/rope,120/chain,120/' mooring/ropes.csv >mooring/type.csv
refused 'an unknown type' "type.csv:3: there is no type 'chain'" --set tables.ropes=type.csv
sed '3s/leg2/leg1/' mooring/ropes.csv >mooring/double.csv
refused 'a name twice' "double.csv:3: 'leg1' is there already, in line 2" --set tables.ropes=double.csv
sed '3s/120/-120/' mooring/ropes.csv >mooring/negative.csv
refused 'a negative length' 'negative.csv:3: column 5: -120 is outside' --set tables.ropes=negative.csv
sed '3s/120/nan/' mooring/ropes.csv >mooring/nan.csv
refused 'a length of nan' 'nan.csv:3: column 5' --set tables.ropes=nan.csv
sed '2s/fixed/held/' mooring/nodes.csv >mooring/held.csv
refused 'an unknown condition' "held.csv:2: condition 'held'" --set tables.nodes=held.csv
sed '2s/100,0,0/,0,0/' mooring/nodes.csv >mooring/place.csv
refused 'a fixed node without a place' 'place.csv:2: a held node needs its coordinate' \
    --set tables.nodes=place.csv
sed '1s/fz_N/weight/' mooring/nodes.csv >mooring/column.csv
refused 'an unknown column' "column 6: 'weight' is not known here" --set tables.nodes=column.csv
sed '1s/node_b/b/' mooring/ropes.csv >mooring/lacks.csv
refused 'a missing column' 'lacks.csv' --set tables.ropes=lacks.csv
sed 's/,/;/g' mooring/ropes.csv >mooring/semicolon.csv
refused 'semicolons' 'semicolon.csv:1' --set tables.ropes=semicolon.csv
: >mooring/empty.csv
refused 'an empty table' 'empty.csv' --set tables.ropes=empty.csv
head -n 1 mooring/ropes.csv >mooring/none.csv
refused 'no ropes' 'has no ropes' --set tables.ropes=none.csv
printf 'rope,node_a,node_b,type,length_m\n1,B1,B2,rope,5\n' >mooring/loose.csv
refused 'a part that drifts' 'no rope leads from here to anything that is held' \
    --set tables.ropes=loose.csv
refused 'an unknown key' "unknown key 'salinity' in [environment]" --set environment.salinity=35
refused 'an unknown method' "option --method: 'force' is not one of: gap displacement imaginary" \
    --method force
refused 'an unknown node of stiffness' "there is no node 'Q'" --stiffness A1,Q
runs 2 'no operand' gapnet
runs 2 'both -o and -d' gapnet -o never.csv -d never $system
runs 2 'stiffness of nothing' gapnet --stiffness '' $system
runs 2 'no such system' gapnet nothing.ini
runs 1 'too few steps' gapnet --set solve.steps=2 -d far $system
says 'not solved in 2 steps' 'say how far it came'
[ "$(column status far/summary.csv)" = not-solved ]
ok $? 'and so does the summary'
[ ! -e never.csv ]
ok $? 'nothing was written'

# One rope against catenary: chains come to its line and end stiffness with order 2, the continuous
# rope at once.
cat >one.ini <<END
[cable]
unstressed_length = 104
mass_per_length = 5
axial_stiffness = 1e6
[supports]
span = 100
drop = 10
END
catenary --summary one.ini | tail -n 1 | tr , '\n' >one
catenary --stiffness one.ini | tail -n 3 | tr , '\n' >>one
mkdir line
printf '[environment]\nwater_density = 0\n' >line/system.ini
printf 'type,diameter_m,mass_kg_m,ea_N\nt,0,5,1e6\n' >line/types.csv
printf 'node,condition,x_m,y_m,z_m\na,fixed,0,0,0\nb,fixed,100,0,-10\n' >line/nodes.csv
for n in 40 80 whole; do
    printf 'rope,node_a,node_b,type,length_m,elements\n1,a,b,t,104,%s\n' "${n#whole}" >line/ropes.csv
    gapnet line/system.ini | awk -F, '$1 == "b" { print $12 }' >"line/$n"
    gapnet --stiffness b line/system.ini | awk -F, 'NR == 2 { print $2 } NR == 4 { print $4 }' \
        >>"line/$n"
done
awk 'FNR == 1 { file++ } { x[file, FNR] = $1 }
    function abs(x) { return x < 0 ? -x : x }
    function order(i, wanted,   e, f) {
        e = abs(x[2, i] - wanted); f = abs(x[3, i] - wanted)
        return abs(e/f - 4) < 0.05 && abs(x[4, i]/wanted - 1) < 1e-9
    }
    END { n = 26; exit !(order(1, x[1, 1]) && order(2, x[1, n + 1]) && order(3, x[1, n + 5])) }' \
    one line/40 line/80 line/whole
ok $? 'one rope: horizontal force and end stiffness of catenary, with order 2'

# Generators: solved and proven, each of them.
for net in square hexagonal radial saddle mooring; do
    runs 0 "$net" "$top/scripts/net/$net" "net-$net"
    runs 0 "$net: solved" gapnet -d "net-$net/solved" "net-$net/system.ini"
    runs 0 "$net: proven" gapcheck "net-$net/solved"
done
runs 0 'mooring: again' gapnet net-mooring/system.ini
[ ! -s err ]
ok $? 'mooring: without a warning'
awk -F, '$1 == "float" { below = $4 < 0 } END { exit !below }' net-mooring/solved/nodes.csv
ok $? 'mooring: its float is submerged'
runs 0 'mooring: longer chains' "$top/scripts/net/mooring" net-long 6 100 60 130
runs 0 'mooring: longer chains: solved' gapnet -d net-long/solved net-long/system.ini
says "m below the lowest node that is held: there is no bed" 'sag below the anchors is told'
finish
