# Sourced by the experiments that ask $case for its keys, or hang its cable with another parameter.
# shellcheck shell=sh disable=SC2154 # begin.sh comes before

# key NAME: its value in the resolved case.
key()
{
    catenary --print-case "$case" | sed -n "s/^$1 = //p"
}

# hang LAMBDA2 [OPTION...]: prints the horizontal force [N] that gives the cable this parameter
# lambda^2, to 1e-6, then lambda^2 itself, the sag [m] and the unstressed length [m].  lambda^2
# goes nearly with the third power of 1/force, so that a few steps do.
hang()
{
    wanted=$1
    force=1000
    shift
    for step in 1 2 3 4 5 6 7 8 9; do
        found=$(catenary --summary --set cable.horizontal_force="$force" "$@" "$case" |
            awk -F, -v l2="$wanted" '
            NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
            {
                H = $column["horizontal_force_N"]; ratio = $column["lambda2"]/l2
                if ((ratio - 1)^2 < 1e-12)
                    print H, $column["lambda2"], $column["sag_m"], $column["unstressed_length_m"]
                else
                    printf "%.15g\n", H*ratio^(1/3)
            }')
        case $found in
        *' '*)
            echo "$found"
            return
            ;;
        '') break ;;
        esac
        force=$found
    done
    echo "$name: no horizontal force for lambda^2 = $wanted after $step steps" >&2
    return 1
}
