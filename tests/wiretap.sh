# Sourced by the tests of wirebeam: cells of tables, numbers, the quarter ring of two elements.
# shellcheck shell=sh
wire=$top/scripts/wire

# cell FILE ROW-NAME COLUMN
cell()
{
    awk -F, -v row="$2" -v name="$3" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i }
        $1 == row { print $at }' "$1"
}

# value FILE COLUMN: of the first row
value()
{
    awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i }
        NR == 2 { print $at }' "$1"
}

# about X WANTED RELATIVE NAME
about()
{
    awk -v x="$1" -v w="$2" -v r="$3" 'BEGIN { d = x - w; if (d < 0) d = -d; if (w < 0) w = -w
        if (!(x != "" && d <= r*w)) { printf "# %s, wanted %s\n", x, w; exit 1 } }'
    ok $? "$4"
}

# quarter DIR: radius 1, EI = 1, GJ = 0.77, 10 kg/m, clamped at foot, 0.01 N out of its plane at tip.
quarter()
{
    mkdir "$1"
    cat >"$1/case.ini" <<END
[tables]
supports = supports.csv
loads = loads.csv
[solve]
watch = tip
END
    printf 'node,x_m,y_m,z_m\nfoot,0,0,0\nmiddle,0.2928932188,0.7071067812,0\ntip,1,1,0\n' >"$1/nodes.csv"
    cat >"$1/elements.csv" <<END
element,node_a,node_b,section,tax,tay,taz,tbx,tby,tbz
1,foot,middle,w,0,1,0,1,1,0
2,middle,tip,w,1,1,0,1,0,0
END
    printf 'section,E_Pa,G_Pa,area_m2,Ixx_m4,Iyy_m4,It_m4,density_kg_m3\nw,1e9,1e9,1e-2,1e-9,1e-9,0.77e-9,1000\n' \
        >"$1/sections.csv"
    printf 'node,ux,uy,uz,rx,ry,rz\nfoot,0,0,0,0,0,0\n' >"$1/supports.csv"
    printf 'node,fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm\ntip,,,0.01,,,\n' >"$1/loads.csv"
}
