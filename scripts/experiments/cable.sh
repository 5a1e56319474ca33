# Sourced by the run scripts of the experiments with one cable: its static line, modes and motion,
# tables and pictures, by scripts/single-cable; the variables of begin.sh for what a run adds.
# shellcheck shell=sh
. "$(dirname "$0")/../begin.sh"
"$scripts/single-cable" "$case" "$dir"
