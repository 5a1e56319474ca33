# Sourced by the run scripts of the experiments that are studies of their own: checks, the directory
# of the results, and the force that gives a cable its Irvine parameter.
# shellcheck shell=sh
LC_ALL=C
OPENBLAS_NUM_THREADS=1
export LC_ALL OPENBLAS_NUM_THREADS
here=$(cd "$(dirname "$0")" && pwd)
name=$(basename "$here")
case=$here/case.ini
# shellcheck disable=SC2034
plot=$here/../../plot/$name
# shellcheck disable=SC2034
pictures=${PICTURES:-png}

study_usage()
{
    sed -n '2s/^# //p' "$0" >&2
    exit 2
}

# begin_study TABLE... -- ARGUMENT...: judge the arguments of the script and the tools on PATH; $dir
# is the directory of the results, without those of an earlier run.
begin_study()
{
    results=
    while [ "$1" != -- ]; do
        results="$results $1"
        shift
    done
    shift
    [ $# -eq 1 ] || study_usage
    case $1 in '' | -*) study_usage ;; esac
    dir=$1
    for tool in catenary modal gnuplot; do
        command -v $tool >/dev/null 2>&1 || {
            echo "$name: $tool is missing: it is not on PATH" >&2
            [ $tool != gnuplot ] || echo 'Debian has it as: apt-get install gnuplot-nox' >&2
            exit 1
        }
    done
    mkdir -p "$dir"
    for old in $results "$name.$pictures" table.txt; do
        rm -f "$dir/$old"
    done
}

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
