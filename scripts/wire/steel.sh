# Sourced by the generators of wires: the case file, and a round wire of steel.
# shellcheck shell=sh

# steel_case DIR NODE [LINE...]: the case with its tables; the path of NODE is watched.
steel_case()
{
    mkdir -p "$1"
    {
        printf '[tables]\nsupports = supports.csv\nloads = loads.csv\n'
        printf '[solve]\nwatch = %s\n' "$2"
    } >"$1/case.ini"
}

# steel_round DIR DIAMETER
steel_round()
{
    printf 'section,shape,E_Pa,G_Pa,density_kg_m3,diameter_m\nwire,round,2.06e11,7.9e10,7850,%s\n' \
        "$2" >"$1/sections.csv"
}
