#!/bin/sh
# Decks of other codes against published and independent values: the folder DECKS holds the decks and
# expected.tsv (file, quantity, value, unit, tolerance with rel or abs, source).  Quantities are
# L#.TA, TB (tensions at the ends), H, HA, HB (horizontal), V, VA, VB (vertical), LBot of a line;
# P#.x, y, z of a node; K## of the body about the origin; surge5:... with the body moved by 5 m in x.
# Decks of MAP++ hang in 350 m of water.
. "$(dirname "$0")/../tap.sh"
[ -n "${DECKS:-}" ] || {
    skip 'DECKS names no folder with decks and expected.tsv'
    finish
}
[ -r "$DECKS/expected.tsv" ]
ok $? 'expected.tsv is there'
cd "$scratch" || exit 1

# value QUANTITY DIR: of the tables in DIR.
value()
{
    case $1 in
    K*) awk -F, -v row="${1#K}" 'NR == int(row/10) + 1 { print $(row%10 + 1) }' "$2/stiffness.csv" ;;
    P*) awk -F, -v what="${1#P}" 'BEGIN { split(what, part, ".") }
            NR == 1 { for (i = 1; i <= NF; i++) if ($i == part[2] "_m") at = i }
            $1 == part[1] { print $at }' "$2/nodes.csv" ;;
    L*) awk -F, -v what="${1#L}" 'BEGIN { split(what, part, "."); q = part[2]; end = tolower(substr(q, 2)) }
            NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
            $1 != part[1] { next }
            q == "LBot" { print $at["length_on_bed_m"]; exit }
            q ~ /^T/ { print $at["tension_" end "_N"]; exit }
            { if (end == "") end = "a"
              x = $at["t" end "_x_N"]; y = $at["t" end "_y_N"]; z = $at["t" end "_z_N"] }
            q ~ /^H/ { printf "%.17g\n", sqrt(x*x + y*y) }
            q ~ /^V/ { printf "%.17g\n", z < 0 ? -z : z }' "$2/ropes.csv" ;;
    esac
}

while read -r file quantity given unit tolerance kind source; do
    case $file in '#'* | '') continue ;; esac
    plain=${quantity#surge5:}
    at=$file
    [ "$plain" = "$quantity" ] || at=$file.surge5
    set --
    case $file in *.map) set -- --set environment.depth=350 ;; esac
    [ "$plain" = "$quantity" ] || set -- "$@" --move 5,0,0,0,0,0
    [ -d "$at" ] || runs 0 "$at" gapnet -q "$@" -d "$at" "$DECKS/$file"
    case $plain in
    K*) [ -e "$at/stiffness.csv" ] ||
        runs 0 "$at: stiffness" gapnet -q "$@" --stiffness body --about 0,0,0 -d "$at" "$DECKS/$file" ;;
    esac
    found=$(value "$plain" "$at")
    awk -v x="$found" -v y="$given" -v tolerance="$tolerance" -v kind="$kind" 'BEGIN {
        d = x - y; d = d < 0 ? -d : d; size = y < 0 ? -y : y
        exit !(x != "" && d <= tolerance*(kind == "rel" ? size : 1)) }'
    ok $? "$file $quantity = $given $unit ($source): ${found:-none}"
done <"$DECKS/expected.tsv"
finish
