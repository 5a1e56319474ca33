#!/bin/sh
# The model directory read by numpy and solved by scipy (tests/cross/modeldir.py).
. "$(dirname "$0")/../tap.sh"

python=
for p in python3 /usr/bin/python3; do
    if [ -z "$python" ] && "$p" -c 'import numpy, scipy.linalg' 2>/dev/null; then
        python=$p
    fi
done
if [ -z "$python" ]; then
    skip 'no python3 here imports numpy and scipy'
    finish
fi
export PYTHONDONTWRITEBYTECODE=1

cat >"$scratch/seil1.ini" <<END
[cable]
unstressed_length = 100.282
mass_per_length = 0.704
youngs_modulus = 1.5556e11
area = 8.48e-5
[supports]
span = 100.403
[mesh]
elements = 20
END
cat >"$scratch/sagging.ini" <<END
[cable]
unstressed_length = 120
mass_per_length = 1
axial_stiffness = 1e6
[supports]
span = 100
drop = 20
[mesh]
elements = 20
END

cat >"$scratch/windy.ini" <<END
[cable]
sag = 6
mass_per_length = 3
axial_stiffness = 1e7
[supports]
span = 80
drop = -30
[load]
ice_mass_per_length = 1.5
wind = 4 -3 30
temperature_change = -40
expansion_coefficient = 1.2e-5
[mesh]
elements = 20
END

# judge NAME CASE SPAN DROP: a TAP line for each line of modeldir.py.
judge()
{
    runs 0 "$1: modal writes the directory" modal -d "$scratch/$1" -o "$scratch/$1.csv" "$2"
    runs 0 "$1: catenary" catenary -o "$scratch/$1.line.csv" "$2"
    runs 0 "$1: catenary --summary" catenary --summary -o "$scratch/$1.summary.csv" "$2"
    runs 0 "$1: numpy reads the directory" "$python" "$here/modeldir.py" "$scratch/$1" \
        "$scratch/$1.line.csv" "$scratch/$1.summary.csv" "$3" "$4"
    cp "$scratch/out" "$scratch/verdicts"
    while read -r verdict text; do
        ok "$verdict" "$1: $text"
    done <"$scratch/verdicts"
}

judge pont "$top/scripts/experiments/ben-ahin/case.ini" 110.5 0
judge seil1 "$scratch/seil1.ini" 100.403 0
judge sagging "$scratch/sagging.ini" 100 20
judge windy "$scratch/windy.ini" 80 -30

finish
