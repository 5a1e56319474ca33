#!/bin/sh
# gapnet: what is admissible but seldom meant is told, by --lint and as warnings of a solution.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1

# A chain between a vessel and its anchor in 60 m of water.
cat >s.ini <<END
[environment]
depth = 60
[tables]
bodies = bodies.csv
END
printf 'body,condition,x_m,y_m,z_m\nvessel,fixed,0,0,0\n' >bodies.csv
printf 'node,condition,x_m,y_m,z_m,mass_kg,volume_m3,waterplane_m2,body\nA,fixed,500,0,-60,,,,\nF,fixed,0,0,-5,,,,vessel\n' >nodes.csv
printf 'type,diameter_m,mass_kg_m,ea_N\nchain,0.1,126,6e8\n' >types.csv
printf 'rope,node_a,node_b,type,length_m\n1,A,F,chain,520\n' >ropes.csv

# change FILE SED: a fresh copy of the system with one line of FILE changed.
change()
{
    rm -rf new
    mkdir new
    cp ./*.ini ./*.csv new
    sed "$2" "$1" >"new/$1"
}
# only TEXT NAME: the message of the last run, and no other.
only()
{
    [ "$(cat err)" = "gapnet: $1" ] || sed 's/^/# /' err
    [ "$(cat err)" = "gapnet: $1" ]
    ok $? "$2"
}
# doubtful NAME FILE SED TEXT: found by --lint, told as a warning by a solution, not with -q.
doubtful()
{
    change "$2" "$3"
    runs 1 "lint: $1" gapnet --lint new/s.ini
    only "$4" "is told: $4"
    runs 0 "solved: $1" gapnet new/s.ini
    only "$4" 'is a warning'
    runs 0 "quietly: $1" gapnet -q new/s.ini
    [ ! -s err ]
    ok $? 'is kept back'
}

runs 0 'lint: nothing' gapnet --lint s.ini
runs 0 'a sound system' gapnet s.ini
[ ! -s err ]
ok $? 'no warning'

doubtful 'a sign that slipped' nodes.csv 's/0,-60/0,60/' \
    'new/nodes.csv:2: it is held 60 m above the water, the bed lies at z = -60 m; is -60 meant?'
doubtful 'tonnes for kilograms' types.csv 's/,126,/,0.126,/' \
    'new/types.csv:2: mass and diameter make a density of 16 kg/m3: are the units right?'
doubtful 'decimetres for metres' types.csv 's/,0.1,/,0.01,/' \
    'new/types.csv:2: mass and diameter make a density of 1.6e+06 kg/m3: are the units right?'
doubtful 'a rope too short' ropes.csv 's/520/452/' \
    'new/ropes.csv:2: its nodes are 503.016 m apart, 11.3 % more than its length'
doubtful 'a rope too long' ropes.csv 's/520/5200/' \
    'new/ropes.csv:2: its nodes are 503.016 m apart, its length is 10.3 times that'
doubtful 'tonnes in a cubic metre' s.ini 's/^\[env.*/&\nwater_density = 1.025/' \
    'water_density = 1.02 kg/m3: is the unit right?'

# What is no doubt: the air, a dry system, a weightless thread, a crane that stands a little higher.
change s.ini 's/^\[env.*/&\nwater_density = 0/'
sed -i 's/,126,/,0.126,/' new/types.csv
runs 0 'dry' gapnet --lint new/s.ini
change types.csv 's/,0.1,126,/,0,126,/'
runs 0 'no diameter' gapnet --lint new/s.ini
change nodes.csv 's/0,0,-5,,,,vessel/0,0,20,,,,/'
runs 0 'held above the water' gapnet --lint new/s.ini

# No depth: --lint tells what a solution would; of a taut rope there is nothing to tell.
change s.ini '/^depth/d'
runs 1 'lint: no depth' gapnet --lint new/s.ini
only 'new/ropes.csv:2: it hangs below its anchor: no depth is given, there is no bed' 'is told'
runs 0 'solved: no depth' gapnet new/s.ini
says "rope '1' hangs" 'is told by the solution'
[ "$(wc -l <err)" = 1 ]
ok $? 'once'
sed -i 's/520/500/' new/ropes.csv
runs 0 'lint: no depth, taut' gapnet --lint new/s.ini

# Solutions: strain, floats in the air.
change types.csv 's/6e8/6e5/'
runs 0 'kilonewtons for newtons' gapnet --set environment.gravity=40 new/s.ini
grep -q "^gapnet: rope '1' is strained by [0-9.]* %: is the unit of its stiffness right?" err &&
    [ "$(wc -l <err)" = 1 ]
ok $? 'the stiffness is doubted'
# a buoy of 20 t lift on a chain of 65 m over its anchor
printf 'rope,node_a,node_b,type,length_m\n1,A,B,chain,65\n' >buoy-ropes.csv
printf 'node,condition,x_m,y_m,z_m,mass_kg,volume_m3,waterplane_m2\nA,fixed,0,0,-60,,,\nB,free,,,,1000,30,\n' >buoy-nodes.csv
set -- --set tables.ropes=buoy-ropes.csv --set tables.nodes=buoy-nodes.csv
runs 0 'a buoy without a waterplane' gapnet "$@" s.ini
grep -q "^gapnet: node 'B' comes to rest 5[0-9.]* m above the water and keeps its whole buoyancy; has it a waterplane?$" err &&
    [ "$(wc -l <err)" = 1 ]
ok $? 'floats in the air'
sed -i 's/30,$/30,10/' buoy-nodes.csv
runs 0 'with a waterplane' gapnet "$@" s.ini
[ ! -s err ]
ok $? 'floats in the water'
sed -i 's/,65$/,50/; 1s/,waterplane_m2$//' buoy-ropes.csv
sed -i 's/30,10$/30,/' buoy-nodes.csv
runs 0 'under water' gapnet "$@" s.ini
[ ! -s err ]
ok $? 'needs no waterplane'
# the same of a body, on three chains
cp "$top"/tests/data/spread/* .
sed 's/,fixed,/,free,/; s/,120$/,/' "$top/tests/data/spread/bodies.csv" >float.csv
runs 0 'a body without a waterplane' gapnet --set tables.bodies=float.csv system.ini
grep -q "^gapnet: body 'vessel' comes to rest [3-6][0-9.]* m above the water" err && [ "$(wc -l <err)" = 1 ]
ok $? 'floats in the air'
finish
