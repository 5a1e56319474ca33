#!/bin/sh
# The generators of wires: each solved by wirebeam, against closed forms; a strand against the
# classic formulas of wire rope.
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../wiretap.sh"
cd "$scratch" || exit 1

for g in straight arc ring helix spiral strand; do
    runs 0 "$g" "$wire/$g" "$g"
    runs 0 "$g: solved" wirebeam --stresses -d "$g/solved" "$g/case.ini"
    [ ! -s err ] && awk -v r="$(value "$g/solved/summary.csv" residual)" 'BEGIN { exit !(r != "" && r <= 1e-10) }'
    ok $? "$g: residual below 1e-10, stable"
    runs 2 "$g: usage" "$wire/$g"
done
EI=$(awk 'BEGIN { print 2.06e11*atan2(0, -1)*1e-8/64 }')
runs 0 'straight, linear' wirebeam --method linear straight/case.ini
about "$(cell out end uz_m)" "$(awk 'BEGIN { printf "%.17g", -100/(3*2.06e11*atan2(0, -1)*1e-8/64) }')" 1e-10 \
    'a straight cantilever: P L^3/3EI'
runs 0 'ring, linear' wirebeam --method linear ring/case.ini
about "$(cell out n0 ux_m)" "$(awk -v EI="$EI" 'BEGIN { print -10*0.148778/EI/2 }')" 5e-4 \
    'a pinched ring of 16 elements, in line'
about "$(cell out n4 uy_m)" "$(awk -v EI="$EI" 'BEGIN { print 10*0.136620/EI/2 }')" 5e-4 '... and across'
about "$(cell helix/solved/nodes.csv end uz_m)" "$(awk 'BEGIN { print 64*20*0.05^3*5/(7.9e10*0.005^4) }')" 0.01 \
    'a spring of five turns: 64 P R^3 n/(G d^4), its ends held, within 1 %'
runs 0 'a lay angle' "$wire/helix" lay 0.00495 15deg 2 24 0.0049
about "$(cell lay/nodes.csv end z_m)" \
    "$(awk 'BEGIN { a = 15*atan2(0, -1)/180; printf "%.17g", 4*atan2(0, -1)*0.00495*cos(a)/sin(a) }')" 1e-12 \
    'gives its pitch'
runs 0 'a clock spring' "$wire/spiral" clock 0.01 0.04 8 24
runs 0 'of eight turns' wirebeam -d clock/solved clock/case.ini
about "$(awk -F, '$1 == "inner" { print $22 + $2*$18 - $3*$17 }' clock/solved/nodes.csv)" \
    "$(awk -v L="$(value clock/solved/summary.csv length_m)" 'BEGIN { print 2.06e11*0.01*0.0008^3/12/L }')" \
    5e-3 'EI angle/L, within 0.5 % (its ends are clamped)'

# A strand under tension, without turning and friction, against the thin-rod formulas (Love's rod, as
# in Costello's theory of wire rope); bent, against springs side by side.
cat >plate.awk <<END
NR == 1 { for (i = 1; i <= NF; i++) at[\$i] = i }
\$1 ~ /_end\$/ { F += \$at["support_z_N"]
    T += \$at["support_mz_Nm"] + \$at["x_m"]*\$at["support_y_N"] - \$at["y_m"]*\$at["support_x_N"]
    if (\$1 == "c_end") y = \$at["y_m"]
    B += \$at["support_mx_Nm"] + (\$at["y_m"] - y)*\$at["support_z_N"] }
END { print F, T, B }
END
# share = 1: curvature and twist of the wire per length it had, not per length it has
classic()
{
    awk -v share="$1" 'BEGIN { pi = atan2(0, -1); E = 2.06e11; G = 7.9e10; a = 75*pi/180; r = 0.00245
        R = 0.00495; e = 1e-3; s = sin(a); c = cos(a); I = pi*r^4/4
        xi = e*s*s; da = e*s*c
        kappa = -2*s*c*da/R + share*xi*c*c/R; tau = cos(2*a)*da/R + share*xi*s*c/R
        T = E*pi*r^2*xi; H = 2*G*I*tau; B = E*I*kappa; N = H*c*c/R - B*s*c/R
        print E*pi*0.0025^2*e + 6*(T*s + N*c), 6*(H*s + B*c + T*R*c - N*R*s) }'
}
runs 0 'a strand' "$wire/strand" tight 15 2 24 0.005 0.0049 0.001 0 1e11
runs 0 'under tension' wirebeam --method linear -d tight/solved tight/case.ini
awk -F, -f plate.awk tight/solved/nodes.csv >tight/plate
about "$(cut -d' ' -f1 tight/plate)" "$(classic 0 | cut -d' ' -f1)" 3e-4 'its force is that of the classic formula'
about "$(cut -d' ' -f2 tight/plate)" "$(classic 1 | cut -d' ' -f2)" 3e-3 \
    'its torque is that of the formula with twist and curvature per natural length'
awk -v t="$(cut -d' ' -f2 tight/plate)" -v f="$(classic 0 | cut -d' ' -f2)" 'BEGIN { exit !(t/f > 1.03 && t/f < 1.07) }'
ok $? 'which is 5 % above the classic one: that forgets that the wire is stretched, too'
runs 0 'a strand without contact' "$wire/strand" bent 15 2 24 0.005 0.0049 0 0.0001 0
runs 0 'bent' wirebeam --method linear -d bent/solved bent/case.ini
awk -F, -f plate.awk bent/solved/nodes.csv >bent/plate
about "$(awk -v L="$(cell bent/nodes.csv c_end z_m)" '{ print $3*L/1e-4 }' bent/plate)" \
    "$(awk 'BEGIN { pi = atan2(0, -1); E = 2.06e11; a = 75*pi/180; nu = E/(2*7.9e10) - 1
        print E*pi*0.0025^4/4 + 6*2*E*pi*0.00245^4/4*sin(a)/(2 + nu*cos(a)^2) }')" 3e-4 \
    'is as stiff as its core and six springs, 2 EI sin a/(2 + nu cos^2 a)'
finish
