#!/bin/sh
# A level cable in wind across hangs in a plane turned about its chord: the same case without wind,
# under the gravity that both together make and with its motions turned, must move alike.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1

cat >plane.ini <<END
[cable]
unstressed_length = 102
mass_per_length = 5
axial_stiffness = 1e7
[supports]
span = 100
[gravity]
acceleration = 10
[mesh]
elements = 8
[motion deck]
amplitude = 0.1 0.2 0.3
omega = 3
phase = 0 0.5 0
[damping]
alpha = 0.05
[disturbance]
time = 0.5
mode = 1
amplitude = 0.2
[time]
end = 4
output_every = 0.05
probes = 0.5 0.3
END
# 3-4-5: weight 40 downward and wind 30 across make 50, which is 5 kg/m under 10 m/s2.
sed 's/^acceleration.*/acceleration = 8/; s/^amplitude = 0.1 .*/amplitude = 0.1 -0.02 0.36/
    s/^phase.*//' plane.ini >windy.ini
sed -i 's/^amplitude = 0.1 .*/amplitude = 0.1 0.2 0.3/; s/^phase.*//' plane.ini
printf '[load]\nwind = 0 0 30\n' >>windy.ini

for tool in 'catenary --summary' modal "diffverf -d model-"; do
    for case in plane windy; do
        case $tool in
        modal) runs 0 "$case: modal" modal -d model-$case -o modal-$case.csv $case.ini ;;
        diffverf*) runs 0 "$case: diffverf" $tool$case -o diffverf-$case.csv $case.ini ;;
        *) runs 0 "$case: $tool" $tool -o catenary-$case.csv $case.ini ;;
        esac
    done
done

"$compare" -r 1e-11 -c omega_rad_s modal-plane.csv modal-windy.csv >&2
ok $? 'the same frequencies'
cut -d, -f5,6 modal-plane.csv >a
cut -d, -f5,6 modal-windy.csv >b
same a b 'planes count from that of the line'
"$compare" -r 1e-12 -c tension_left_N,tension_mid_N,lambda2,length_m catenary-plane.csv \
    catenary-windy.csv >&2
ok $? 'the same tension'
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    FNR == 2 { file++; sag[file] = $c["sag_m"]; sway[file] = $c["sway_m"]
        side[file] = $c["lateral_left_N"] + $c["lateral_right_N"] }
    function off(x, y) { return (x - y)^2 > 1e-20*y*y }
    END { exit off(sag[2], 0.8*sag[1]) || off(sway[2], 0.6*sag[1]) || off(side[2], 30*102) }' \
    catenary-plane.csv catenary-windy.csv
ok $? 'sag, sway and lateral reactions are those of the turned plane'

# Columns v2, v3 (and force 2, 3) of the plane case, turned by 3-4-5, beside those of the windy one.
awk -F, 'NR == FNR { for (i = 1; i <= NF; i++) plane[FNR, i] = $i; next }
    FNR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
    { for (i = 1; i <= NF; i++) {
          wanted = plane[FNR, i]
          if (name[i] ~ /^v2_|_2_N$/ && name[i] !~ /tension/)
              wanted = 0.8*plane[FNR, i] - 0.6*plane[FNR, i + 1]
          if (name[i] ~ /^v3_|_3_N$/ && name[i] !~ /tension/)
              wanted = 0.6*plane[FNR, i - 1] + 0.8*plane[FNR, i]
          scale = name[i] ~ /_N$/ ? 1e4 : 1
          e = ($i - wanted)/scale; if (e < 0) e = -e
          if (e > worst) worst = e
          if (!(e <= 1e-8)) bad = 1
          rows = FNR
      } }
    END { printf "# largest difference %.2g\n", worst; exit bad || rows != 82 }' \
    diffverf-plane.csv diffverf-windy.csv
ok $? 'the same motion, turned'

finish
