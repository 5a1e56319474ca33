#!/bin/sh
# Mooring decks of other codes: the same system by tables, closed forms, round trips, each error with
# its line.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
cp "$here"/../data/decks/*.txt .

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

# agree FILE FILE COLUMNS ABS NAME
agree()
{
    "$compare" -r 1e-9 -a "$4" -c "$3" "$1" "$2" >&2
    ok $? "$5"
}

# trip DECK OPTION...: what is written reads back to the same results.
trip()
{
    deck=$1
    shift
    runs 0 "$deck: solved" gapnet "$@" -d "first-$deck" --write-deck "again-$deck" "$deck"
    runs 0 "$deck: what was written is solved" gapnet -d "second-$deck" "again-$deck"
    "$compare" -r 0 -a 1e-7 -c x_m,y_m,z_m "first-$deck/nodes.csv" "second-$deck/nodes.csv" >&2
    ok $? "$deck: positions of nodes"
    "$compare" -r 1e-8 -a 1e-3 -c tension_a_N,tension_b_N,length_on_bed_m "first-$deck/ropes.csv" \
        "second-$deck/ropes.csv" >&2
    ok $? "$deck: tensions of ropes"
    awk '/^-+ POINTS/ { on = 1 } /^-+ LINES/ { on = 0 } on && $2 == "Free" { print $3 "," $4 "," $5 }' \
        "again-$deck" >written
    awk -F, 'NR > 1 && $NF == "" { print $2 "," $3 "," $4 }' "first-$deck/nodes.csv" >found
    same written found "$deck: free points are written where they were found"
}

# MoorDyn v2 by tables.
cat >v2.ini <<END
[environment]
gravity = 9.80665
depth = 120
[tables]
nodes = v2-nodes.csv
ropes = v2-ropes.csv
types = v2-types.csv
bodies = v2-bodies.csv
END
cat >v2-types.csv <<END
type,diameter_m,mass_kg_m,ea_N,cd,cd_axial
chain,0.12,55,9e8,1.3,0.6
rope,0.16,22,4e7,1.6,0.1
END
cat >v2-bodies.csv <<END
body,condition,x_m,y_m,z_m,rz_rad
vessel,fixed,0,0,0,0
body1,fixed,1,2,-5,0.5235987755982988
END
cat >v2-nodes.csv <<END
node,condition,x_m,y_m,z_m,mass_kg,volume_m3,cda_m2,body
1,fixed,300,0,-120,,,,
2,fixed,-150,259.8,-120,,,,
3,fixed,-150,-259.8,-120,,,,
4,fixed,5,0,-3,,,,body1
5,fixed,-3,4,-3,,,,body1
6,free,,,,2000,1,0.5,
7,fixed,-20,-10,-8,,,,vessel
R1A,fixed,0,-5,-3,,,,body1
R1B,fixed,0,-5,-9,,,,body1
R2A,fixed,0,310,-120,,,,
R2B,fixed,0,310,-120,,,,
END
cat >v2-ropes.csv <<END
rope,node_a,node_b,type,length_m
1,1,6,chain,220
2,6,4,rope,95
3,2,5,chain,318
4,3,R1B,chain,305
5,R2A,7,rope,330
END
runs 0 'MoorDyn v2' gapnet -v -d v2 moordyn2.txt
[ "$(grep -c passed err)" -eq 0 ]
ok $? 'nothing is passed over'
runs 0 'and its tables' gapnet -d v2-tables v2.ini
agree v2/nodes.csv v2-tables/nodes.csv node,x_m,y_m,z_m,support_x_N,support_y_N,support_z_N 1e-4 \
    'the same nodes, and what holds them'
agree v2/ropes.csv v2-tables/ropes.csv rope,tension_a_N,tension_b_N,node_a,node_b 1e-4 \
    'the same ropes'
holds 'abs(f[4, 2] - (1 + 5*cos(atan2(0, -1)/6))) < 1e-12 && abs(f[4, 3] - 4.5) < 1e-12 &&
    f[4, 4] == -8' v2/nodes.csv 'the yaw of the body turns its points'
trip moordyn2.txt
grep -q '^2 rope 6 4 95 10 -' again-moordyn2.txt
ok $? 'NumSegs is kept'

# v1: forces at points, the length before the ends.
cat >v1.ini <<END
[environment]
water_density = 1000
depth = 80
[tables]
nodes = v1-nodes.csv
ropes = v1-ropes.csv
types = v1-types.csv
END
printf 'type,diameter_m,mass_kg_m,ea_N\nwire,0.06,18,2.4e8\n' >v1-types.csv
cat >v1-nodes.csv <<END
node,condition,x_m,y_m,z_m,mass_kg,volume_m3,fx_N,fy_N,fz_N
1,fixed,-100,0,-80,,,,,
2,fixed,100,0,-80,,,,,
3,free,0,0,-20,500,4,3000,0,-1000
END
printf 'rope,node_a,node_b,type,length_m\n1,1,3,wire,115\n2,2,3,wire,118\n' >v1-ropes.csv
runs 0 'MoorDyn v1' gapnet -d v1 moordyn1.txt
[ ! -s err ]
ok $? 'without a warning'
runs 0 'and its tables' gapnet -d v1-tables v1.ini
agree v1/nodes.csv v1-tables/nodes.csv node,x_m,y_m,z_m,load_x_N,load_z_N 1e-4 'the same nodes'
agree v1/ropes.csv v1-tables/ropes.csv rope,tension_a_N,tension_b_N 1e-4 'the same ropes'
runs 2 'a horizontal force' gapnet --write-deck never.txt moordyn1.txt
says "no deck can say this: a horizontal force on node '3'" 'is in no deck of v2'
[ ! -e never.txt ] && [ ! -s out ]
ok $? 'nothing is written'
sed 's/3000  0    -1e3/0  0  -1e3/' moordyn1.txt >weight.txt
trip weight.txt
sed 's/3000  0    -1e3/0  0  1e3/' moordyn1.txt >lift.txt
trip lift.txt
grep -q '^3 Free .* 500 4.10193' again-lift.txt
ok $? 'a vertical force becomes volume'

# MoorPy: a chain of which a part lies on the bed.  H = 600 kN gives V = w s and the place of the
# fairlead, of the elastic catenary and the part that lies.
runs 0 'MoorPy' gapnet -d py moorpy.txt
cat >wanted <<END
tension_a_N,tension_b_N,length_on_bed_m
600000,938671.319812877,295.431507144327
END
agree py/ropes.csv wanted tension_a_N,tension_b_N,length_on_bed_m 1e-6 'the closed form'
trip moorpy.txt

# MAP++: friction of the bed by type, guesses, copies turned clockwise.
runs 2 'MAP++ without a depth' gapnet map.txt
says 'map.txt:9: the depth stands in no such deck: set environment.depth' 'asks for it'
runs 0 'MAP++' gapnet -v --set environment.depth=250 -d map map.txt
says 'map.txt:28: repeat behind a blank is a comment' 'such a line is passed over'
holds 'n == 9 && f[4, 1] == 4 && f[9, 14] == 14 && f[9, 15] == 15' map/ropes.csv \
    'three of each, numbered on'
cat >wanted <<END
tension_a_N,tension_b_N,length_on_bed_m
550260.995762169,1594332.2270906125,199.52671384440941
END
for rope in 1 4 7; do
    awk -F, -v rope=$rope 'NR == 1 || $1 == rope' map/ropes.csv >one
    agree one wanted tension_a_N,tension_b_N,length_on_bed_m 1e-5 "the closed form, line $rope"
done
# copies 4 + 5 of node 4: turned by -120 degrees
holds 'abs(f[9, 2] - (-0.5*f[4, 2] + sqrt(0.75)*f[4, 3])) < 1e-6 &&
    abs(f[9, 3] - (-sqrt(0.75)*f[4, 2] - 0.5*f[4, 3])) < 1e-6 && abs(f[9, 4] - f[4, 4]) < 1e-6' \
    map/nodes.csv 'copies are turned clockwise'
sed 's/  0   2000   -500/  0   0   -500/' map.txt >pull.txt
trip pull.txt --set environment.depth=250

runs 0 'moved' gapnet --set environment.depth=250 --move 5,0,1,0,0,0.1 -d moved --write-deck moved.txt pull.txt
runs 0 'read back' gapnet -d moved-again moved.txt
agree moved/ropes.csv moved-again/ropes.csv tension_a_N,tension_b_N 1e-2 \
    'a vessel that was moved is written where it stands'

# A free body: weight at its centre of gravity, buoyancy at its origin; roll, pitch and yaw turn
# about axes that have turned already.
printf '[environment]\ndepth = 100\n[tables]\nnodes = spar-nodes.csv\nropes = spar-ropes.csv\n' >spar.ini
printf 'types = spar-types.csv\nbodies = spar-bodies.csv\n' >>spar.ini
printf 'type,diameter_m,mass_kg_m,ea_N,cd,cd_axial\nwire,0.06,20,3e8,1.2,0.1\n' >spar-types.csv
cat >spar-bodies.csv <<END
body,condition,x_m,y_m,z_m,mass_kg,volume_m3,xg_m,yg_m,zg_m
body1,free,2,0,-30,6e4,150,1,0.5,-4
END
cat >spar-nodes.csv <<END
node,condition,x_m,y_m,z_m,mass_kg,body
1,fixed,120,0,-100,,
2,fixed,-60,103.9,-100,,
3,fixed,-60,-103.9,-100,,
4,fixed,4,0,-6,,body1
5,fixed,-2,3.5,-6,,body1
6,fixed,-2,-3.5,-6,300,body1
END
printf 'rope,node_a,node_b,type,length_m\n1,1,4,wire,131\n2,2,5,wire,131\n3,3,6,wire,131\n' >spar-ropes.csv
runs 0 'a free body' gapnet -d spar spar.txt
runs 0 'and its tables' gapnet -d spar-tables spar.ini
agree spar/nodes.csv spar-tables/nodes.csv node,x_m,y_m,z_m 1e-6 'the same nodes'
agree spar/ropes.csv spar-tables/ropes.csv rope,tension_a_N,tension_b_N 1e-1 'the same ropes'
trip spar.txt
agree first-spar.txt/bodies.csv second-spar.txt/bodies.csv x_m,y_m,z_m,rx_rad,ry_rad,rz_rad 1e-7 \
    'the body is written where it was found'
sed '9s/Free /Fixed/; 9s/4    -3   10/90   90   0 /' spar.txt >turned.txt
runs 0 'a body that is turned twice' gapnet -q -o turned.csv turned.txt
# Rx(90) Ry(90) takes x to y, y to z, z to x
holds 'abs(f[4, 2] - (2 - 6)) < 1e-9 && abs(f[4, 3] - 4) < 1e-9 && abs(f[4, 4] + 30) < 1e-9' turned.csv \
    'roll, then pitch about the axis that it turned'
trip turned.txt

# One file, many habits: CR LF, tabs, bytes that are no ASCII, comments, no closing line, sections in
# another order.
awk '{ gsub(/  +/, "\t"); printf "%s\r\n", $0 }' moordyn2.txt | LC_ALL=C sed 's/m^3/m\xcb\x863/' >habits.txt
runs 0 'CR LF, tabs, bytes' gapnet -o habits.csv habits.txt
same habits.csv v2/nodes.csv 'read as before'
awk '/^---+ [A-Z]/ { n++ } { part[n] = part[n] $0 "\n" }
    END { printf "\xef\xbb\xbftitle\n"; for (k = n; k >= 2; k--) printf "%s", part[k] }' moordyn2.txt |
    sed '/need this line/d' >order.txt
runs 0 'sections in another order' gapnet -o order.csv order.txt
same order.csv v2/nodes.csv 'read as before'
sed 's/Coupled     1/vessel 1/; s/Free  /POINT /; s/^7    Coupled/7    Fairlead/; s/Fixed /ANCHOR/' \
    moordyn2.txt >names.txt
runs 0 'other names of attachments' gapnet -o names.csv names.txt
same names.csv v2/nodes.csv 'read as before'

# Stiffness by a table, chains by NumSegs, --set over what the deck says.
printf 'tension\nstrain tension\n(-) (N)\n0 0\n0.01 4e5\n0.02 8e5\n0.1 4e6\n' >tension.dat
sed 's/4.0e7|9e7/tension.dat/' moordyn2.txt >table.txt
runs 0 'a file of tensions' gapnet -d table table.txt
grep -q table table/ropes.csv
ok $? 'is the law of its lines'
gapnet --rope chain --set solve.elements=10 -d line-chain moordyn2.txt
[ "$(column elements line-chain/ropes.csv | tr '\n' ' ')" = '20 10 20 20 20 ' ]
ok $? 'chains have NumSegs elements'
runs 2 'a table is in no deck' gapnet --write-deck never.txt table.txt
says "no deck can say this: the tension table of type 'rope'" 'is told'
runs 0 '--set over the deck' gapnet --print-case --set environment.depth=350 \
    --set environment.bed_friction=0.5 moordyn2.txt
grep -q '^depth = 350' out && grep -q '^bed_friction = 0.5' out && grep -q '^gravity = 9.80665' out
ok $? 'and what the deck says else'
runs 0 'the deck on standard output' sh -c 'gapnet --write-deck - moordyn2.txt >deck.txt'
same deck.txt again-moordyn2.txt 'and nothing else'
runs 2 'over the input' gapnet --write-deck moordyn2.txt moordyn2.txt
runs 1 'to a full disk' gapnet --write-deck /dev/full moordyn2.txt

# What changes results and is passed over is a warning.
sed 's/^0        WaveKin/0.5 FrictionCoefficient/' moordyn2.txt >friction.txt
runs 0 'friction' gapnet friction.txt
says 'gapnet: friction.txt:46: FrictionCoefficient 0.5 is passed over; set environment.bed_friction' \
    'is passed over with a warning'
runs 0 'friction that is set' gapnet --set environment.bed_friction=0.5 friction.txt
[ ! -s err ]
ok $? 'needs no warning'
sed 's/^0        WaveKin/1 Currents/' moordyn2.txt >current.txt
runs 0 'a current' gapnet current.txt
says 'current.txt:46: Currents 1 is passed over; set tables.current' 'is passed over with a warning'
# meant WORD OPTION: a wrong name in place of WaveKin is told with the option that is meant.
meant()
{
    sed "s/^0        WaveKin/60 $1/" moordyn2.txt >meant.txt
    runs 0 "option $1" gapnet meant.txt
    [ "$(cat err)" = "gapnet: meant.txt:46: option $1 is not known; is $2 meant?" ]
    ok $? "is $2 meant?"
}
meant WaterDepth WtrDpth
meant WtrDpht WtrDpth
meant WTRDENSTY WtrDnsty
meant gravty gravity
meant SeaFloorFil SeafloorFile
sed 's/^200      depth/Depht 200/' moorpy.txt >meant.txt
runs 1 'lint: no depth' gapnet --lint meant.txt
says 'meant.txt:16: option Depht is not known; is WtrDpth meant?' 'in the order of MAP++, too'
says 'it hangs below its anchor: no depth is given, there is no bed' 'and what comes of it'
# what only dynamics knows is near to none
for option in dtM kbot cbot dtIC TmaxIC CdScaleIC threshIC tScheme writeLog dtOut WaveKin mc cv \
    integration_dt kb_default cb_default outer_tol inner_ftol FricDamp StatDynFricScale; do
    echo "0.1 $option"
done >dynamics.txt
{
    sed '/WaveKin/,$d' moordyn2.txt
    cat dynamics.txt
    sed '1,/WaveKin/d' moordyn2.txt
} >many.txt
runs 0 'options of dynamics' gapnet many.txt
[ ! -s err ]
ok $? 'are passed over without a word'
sed 's/(N-m^2)/(-)/; s/-1.0      0        1.3/-1.0      1e4        1.3/' moordyn2.txt >bends.txt
runs 0 'bending' gapnet bends.txt
says "bends.txt:6: EI of type 'chain' is passed over: ropes do not bend" 'is passed over with a warning'
sed 's/^6    Free /6 Turbine3 /' moordyn2.txt >farm.txt
runs 0 'a turbine' gapnet farm.txt
says 'farm.txt:29: turbine3 is taken to stand at the origin: a deck does not tell its place' 'is told'

# Lint.
runs 0 'lint: nothing' gapnet --lint moordyn2.txt
sed 's/-259.8  -120/-259.8  -119/' moordyn2.txt >off.txt
runs 1 'lint: an anchor off the bed' gapnet --lint off.txt
says 'gapnet: off.txt:26: it is held 1 m above the bed, which lies at z = -120 m' 'is told'
sed 's/-259.8  -120/-259.8  -121/' moordyn2.txt >off.txt
runs 2 'an anchor inside the bed' gapnet --lint off.txt
says "off.txt:26: '3' is held 1 m inside the bed" 'is told'
sed 's/^3    chain     2        5        318/3 chain 2 5 200/' moordyn2.txt >short.txt
runs 1 'lint: a line too short' gapnet --lint short.txt
says 'short.txt:36: its nodes are' 'is told'
sed 's/100   0       -60/100 0 3/' moordyn2.txt >high.txt
runs 1 'lint: a float above the water' gapnet --lint high.txt
says 'high.txt:29: a float above the water' 'is told'

# bad NAME SED TEXT [DECK]: status 2, exactly this message, nothing on standard output.
bad()
{
    sed "$2" "${4:-moordyn2.txt}" >bad.txt
    runs 2 "$1" gapnet ${4:+--set environment.depth=250} bad.txt
    printf 'gapnet: bad.txt%s\n' "$3" >wanted
    cmp -s wanted err || { sed 's/^/# wanted: /' wanted; sed 's/^/# /' err; }
    cmp -s wanted err && [ ! -s out ]
    ok $? "$1: says '$3'"
}
bad 'a missing column' '34s/20 .*//' \
    ':34: column 6 (NumSegs) is missing: 5 are there, 6 are expected'
bad 'a missing column of a point' '26s/0    0   .*/0/' \
    ':26: column 9 (Ca) is missing: 8 are there, 9 are expected'
bad 'a wrong number' '34s/220/2z0/' ":34: column 5 (UnstrLen): '2z0': not a number"
bad 'NaN' '24s/-120/nan/' ":24: column 5 (Z): 'nan': not a number"
bad 'a diameter out of range' '6s/0.12/1e9/' ':6: column 2 (Diam): 1e9 is outside of 0 to 1000'
bad 'a length of nothing' '34s/220/0/' ':34: column 5 (UnstrLen): 0 is outside of 1e-09 to 1e+09'
bad 'an unknown type' '34s/chain/cable/' ":34: there is no type of lines 'cable'"
bad 'an unknown point' '34s/P6/P60/' ":34: there is no point 'P60'"
bad 'an unknown rod' '37s/R1B/R4B/' ":37: there is no point 'R4B'"
bad 'an unknown body' '27s/Body1/Body2/' ":27: there is no body '2'"
bad 'an unknown attachment' '29s/Free/Loose/' \
    ":29: attachment 'Loose' is not known: fixed, coupled, free or Body#"
bad 'a number twice' '25s/^2/1/' ":25: '1' is there already, in line 24"
bad 'a line twice' '35s/^2/1/' ":35: '1' is there already, in line 34"
bad 'a type twice' '7s/^rope /chain/' ":7: 'chain' is there already, in line 6"
bad 'a section twice' '31s/LINES/POINTS/' ':31: this section is there already, in line 21'
bad 'no lines' '34,38d' ':31: section LINES is empty'
bad 'no section of lines' '31,38d' ':42: the file ends without a section LINES'
bad 'an option that is cut' '42s/120.*/120/' ':42: option: the key behind 120 is missing'
bad 'no section of points' '21,30d' ':40: the file ends without a section POINTS'
bad 'a section that fails' '47s/OUTPUTS/FAILURE/' ':47: section FAILURE: statics cannot honour it'
bad 'a section of controls' '47s/OUTPUTS/CONTROL/' ':47: section CONTROL: statics cannot honour it'
bad 'an unknown section' '47s/OUTPUTS/WINCHES/' ":47: section 'WINCHES' is not known"
bad 'a rod that moves' '19s/Body1/Free /' ':19: rod 1 moves: rods only hold lines here'
bad 'a rod that turns' '19s/Body1/Body1Pinned/' ':19: rod 1 moves: rods only hold lines here'
bad 'a rod on a free body' '15s/Coupled/Free/' ':19: rod 1 moves: rods only hold lines here'
bad 'a body that turns' '15s/Coupled/CoupledPinned/' \
    ':15: body 1 is pinned: only bodies that are held or free in all directions are known here'
bad 'an unknown type of rods' '19s/can/pan/' ":19: there is no type of rods 'pan'"
bad 'no line of units' '33d' ':33: a line of units is expected below the names; this is a record'
bad 'a wrong option' '42s/120/1,2/' ":42: option WtrDpth: '1,2': a decimal point is expected, not a comma"
bad 'an option twice' '43s/.*/12 depth/' ':43: option depth was given in line 42 already'
bad 'a wrong stiffness' '7s/4.0e7|9e7/4e7|x/' ":7: column 4 (EA): 'x': not a number"
bad 'a file of tensions that is not there' '7s/4.0e7|9e7/none.dat/' \
    ":7: column 4 (EA): 'none.dat' is neither a number nor a file"
bad 'two copies in one place' '26s/120/360/' \
    ':26: repeat: lines at 360 degrees are there already' map.txt
bad 'a copy that is none' '26s/120/x/' ":26: column 2: 'x': not a number" map.txt
bad 'a line that touches nothing' '17s/tension_fair/omit_contact/' \
    ':17: line 1: OMIT_CONTACT is not known to statics here' map.txt
bad 'a force to be found' '12s/2000/#/' ':12: column 9: a free node needs its force' map.txt
bad 'a guess of a held node' '11s/100/#/' ':11: column 3: a held node needs its coordinate' map.txt

# Cut anywhere: a message, or a mooring; never a crash.
wrong=
cut=0
size=$(wc -c <moordyn2.txt)
while [ $cut -lt "$size" ]; do
    head -c $cut moordyn2.txt >cut.txt
    gapnet -q -o cut.csv cut.txt 2>err
    status=$?
    case $status in 0) ;; [12]) grep -q '^gapnet: ' err || wrong="$wrong $cut" ;;
    *) wrong="$wrong $cut:$status" ;; esac
    cut=$((cut + 41))
done
[ -z "$wrong" ] || echo "# $wrong"
[ -z "$wrong" ]
ok $? 'cut anywhere it is refused, or a mooring'
finish
