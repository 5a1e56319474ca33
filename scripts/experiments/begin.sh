# Sourced by the run script of every experiment, which has one argument: the directory of the results,
# $dir.  Sets its folder $here, its $name, its $case, the directories $scripts and $plot, and $pictures,
# the suffix of the pictures.  Line 2 of a run is its usage.
# shellcheck shell=sh disable=SC2034 # the scripts that source this use them
set -eu
LC_ALL=C
OPENBLAS_NUM_THREADS=1
export LC_ALL OPENBLAS_NUM_THREADS
here=$(cd "$(dirname "$0")" && pwd)
name=$(basename "$here")
case=$here/case.ini
scripts=$(cd "$here/../.." && pwd)
plot=$scripts/plot
pictures=${PICTURES:-png}
if [ $# -ne 1 ] || case $1 in '' | -*) true ;; *) false ;; esac; then
    sed -n '2s/^# //p' "$0" >&2
    exit 2
fi
dir=$1
command -v gnuplot >/dev/null 2>&1 || {
    echo "$name: gnuplot is missing; install it (Debian: apt-get install gnuplot-nox)" >&2
    exit 1
}
mkdir -p "$dir"
