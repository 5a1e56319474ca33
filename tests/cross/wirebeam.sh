#!/bin/sh
# wirebeam beside other tools: a wire almost without bending stiffness hangs as catenary says; a taut
# one vibrates as modal says.
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../wiretap.sh"
cd "$scratch" || exit 1

cat >cable.ini <<END
[cable]
unstressed_length = 104
mass_per_length = 5
axial_stiffness = 1e6
[supports]
span = 100
[mesh]
elements = 40
END
# wire DIR ELEMENTS LENGTH FORCE: straight along x, EI = 1 N m2, 5 kg/m, hinged, its end free along x;
# the force pulls there in stage 1, the weight comes in stage 2.  (A wire that is not pulled first has
# next to no stiffness across.)
wire()
{
    mkdir "$1"
    printf '[tables]\nsupports = supports.csv\nloads = loads.csv\n[solve]\nelement_loads = lumped\n' >"$1/case.ini"
    printf 'section,E_Pa,G_Pa,area_m2,Ixx_m4,Iyy_m4,It_m4,mass_kg_m\nw,1e9,1e9,1e-3,1e-9,1e-9,1e-9,5\n' >"$1/sections.csv"
    awk -v n="$2" -v L="$3" -v H="$4" -v dir="$1" 'BEGIN {
        nodes = dir "/nodes.csv"; elements = dir "/elements.csv"; loads = dir "/loads.csv"
        print "node,x_m,y_m,z_m" >nodes
        print "element,node_a,node_b,section" >elements
        print "node,fx_N,element,qz_N_m,stage" >loads
        printf "n%d,%s,,,1\n", n, H >loads
        for (i = 0; i <= n; i++)
            printf "n%d,%.17g,0,0\n", i, L*i/n >nodes
        for (i = 1; i <= n; i++) {
            printf "%d,n%d,n%d,w\n", i, i - 1, i >elements
            printf ",,%d,-49.05,2\n", i >loads
        }
        print "node,ux,uy,uz,rx\nn0,0,0,0,0\nn" n ",,0,0," >(dir "/supports.csv") }'
}
# extrapolated NAME: of the numbers of 64 and 128 elements, order 2
extrapolated()
{
    cat "${1}64" "${1}128" | tr '\n' ' ' | awk '{ printf "%.12g\n", (4*$2 - $1)/3 }'
}
runs 0 catenary catenary --summary -o summary.csv cable.ini
for n in 64 128; do
    wire hang$n $n 104 "$(value summary.csv horizontal_force_N)"
    runs 0 "hanging wire of $n elements" wirebeam -o hang$n.csv hang$n/case.ini
    cell hang$n.csv n$n x_m >x$n
    cell hang$n.csv n$((n / 2)) z_m >z$n
    cell hang$n.csv n0 support_z_N >V$n
done
about "$(extrapolated x)" 100 2e-5 'the span that catenary was given, under its horizontal force'
about "$(extrapolated z)" "-$(value summary.csv sag_m)" 1e-4 'its sag'
about "$(extrapolated V)" "$(awk 'BEGIN { print 104*49.05/2 }')" 1e-9 'half its weight'

# Taut: the first frequency across, where it hangs.
sed 's/^unstressed_length.*/unstressed_length = 99.5/' cable.ini >taut.ini
runs 0 modal modal --modes 2 -o cable.csv taut.ini
for n in 64 128; do
    wire taut$n $n 99.5 0
    printf 'node,ux,uy,uz,rx\nn0,0,0,0,0\nn%d,0.5,0,0,\n' $n >taut$n/supports.csv
    runs 0 "taut wire of $n elements" wirebeam --modes 3 -o taut$n.csv taut$n/case.ini
    awk -F, 'NR > 1 { print $2 }' taut$n.csv >rates$n
    sed -n 1p rates$n >w$n
done
about "$(extrapolated w)" "$(cell cable.csv 1 omega_rad_s)" 1e-5 'the first frequency of modal'
finish
