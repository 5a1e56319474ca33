#!/bin/sh
# scripts/envelope and scripts/spectrum on waves that are known; shellcheck on all scripts.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1

# 0.7 sin 3 t + 0.2 cos 11 t about 5; beside it an amplitude that falls.
awk 'BEGIN { print "time_s,v1_1_m,v2_1_m"
    for (i = 0; i <= 6000; i++) { t = i/100
        printf "%.17g,%.17g,%.17g\n", t, 5 + 0.7*sin(3*t) + 0.2*cos(11*t), exp(-t/50)*sin(3*t) } }' >wave.csv

runs 0 'spectrum' "$top/scripts/spectrum" wave.csv v1_1_m
awk -F, 'NR > 1 { if ($2 > most && $1 < 7) { most = $2; at = $1 }
        if ($2 > high && $1 > 7) { high = $2; there = $1 } if ($1 > 20 && $2 > rest) rest = $2 }
    function off(x, y, e) { return (x - y)^2 > e*e }
    END { exit off(most, 0.7, 0.005) || off(at, 3, 0.03) || off(high, 0.2, 0.002) ||
        off(there, 11, 0.03) || !(rest < 1e-4) }' out
ok $? 'both waves at their places with their amplitudes, and nothing above them'
runs 0 'spectrum between two times' "$top/scripts/spectrum" wave.csv v1_1_m 10 20
[ "$(wc -l <out)" -eq 1026 ]
ok $? 'has the bins of these rows'
runs 0 'envelope' "$top/scripts/envelope" wave.csv 3 2
awk -F, 'NR == 1 { if ($0 != "time_s,v1_1_m_min,v1_1_m_max,v2_1_m_min,v2_1_m_max") exit bad = 1; next }
    { t = 8*atan2(1, 1)/3*2*(NR - 1); if (($1 - t)^2 > 1e-12) bad = 1
      top = exp(-(t - 8*atan2(1, 1)/3*2)/50); if (!($5 <= top && $5 > 0.97*top)) bad = 1 }
    END { exit bad || NR != 15 }' out
ok $? 'the extremes of each block of two periods'
"$top/scripts/envelope" - 3 2 <wave.csv >piped
same out piped 'from standard input, too'
runs 2 'envelope without arguments' "$top/scripts/envelope"
runs 2 'envelope of no frequency' "$top/scripts/envelope" wave.csv x
runs 2 'envelope of no table' "$top/scripts/envelope" "$0" 3
runs 2 'spectrum of a column that is not there' "$top/scripts/spectrum" wave.csv v9
runs 2 'spectrum of no rows' "$top/scripts/spectrum" wave.csv v1_1_m 100 200
runs 2 'spectrum of a file that is not there' "$top/scripts/spectrum" nothing v1_1_m

# Every script of sh: shellcheck finds nothing, and what is disabled in it stands there by its number.
# What is sourced is checked with what sources it.
if command -v shellcheck >/dev/null; then
    find "$top/scripts" "$top/.ci" -type f | sort | while IFS= read -r file; do
        case $(head -n 1 "$file") in
        '#!/bin/sh' | '#!/bin/bash') printf '%s\0' "$file" ;;
        esac
    done >files
    [ "$(tr -cd '\0' <files | wc -c)" -gt 60 ]
    ok $? 'the scripts are found'
    (cd "$top" && xargs -0 -n 12 -P 2 shellcheck -x -P SCRIPTDIR -f gcc) <files >said 2>&1
    ok $? 'shellcheck on every script'
    sed 's/^/# /' said
    ! grep -rnE 'shellcheck +disable=(all|[^ ]*-)' "$top/scripts" >&2
    ok $? 'nothing is disabled wholesale'
else
    skip 'no shellcheck'
fi
find "$top/scripts" -type f | sort | while IFS= read -r file; do
    case $(head -n 1 "$file") in
    '#!/usr/bin/env perl') perl -wc "$file" >/dev/null 2>&1 || echo "$file" ;;
    esac
done >bad
[ ! -s bad ]
ok $? 'perl accepts every script of its own'
finish
