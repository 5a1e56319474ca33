# Sourced by the run scripts of the experiments with one cable: its static line, modes and motion,
# tables and pictures, by scripts/single-cable; $dir and $pictures for what a run adds.
# shellcheck shell=sh
set -eu
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
if [ $# -ne 1 ]; then
    sed -n '2s/^# //p' "$0" >&2
    exit 2
fi
case $1 in '' | -*) sed -n '2s/^# //p' "$0" >&2; exit 2 ;; esac
dir=$1
# shellcheck disable=SC2034 # the scripts that source this use them
pictures=${PICTURES:-png}
# shellcheck disable=SC2034
plot=$here/../../plot
"$here/../../single-cable" "$here/case.ini" "$dir"
