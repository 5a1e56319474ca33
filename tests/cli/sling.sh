#!/bin/sh
# sling as a planner of lifts meets it: columns, one arrangement alone, verdicts, tolerances, design,
# contours, refusals.
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../columns.sh"
cd "$scratch" || exit 1
cases=$top/scripts/experiments/lifts/cases.csv
cat >lifts.csv <<END
name,type,v_m,s_m,z_m,z_m_tol,phi_deg,gamma_deg,m_spreader_t,m_load_t,wll_kN,offset_m
A,primary-secondary,3.6,7.5,1.1,0.2,26,-4,2,60,300,0.1
"B, the same",primary-secondary,3.6,7.5,1.1,0.2,26,-6,2,60,300,0.1
C,primary,6,,2,0.2,30,,,60,300,0.1
END

# One arrangement of the command line alone: nothing is read, not even a standard input that blocks.
alone='--set type=primary-secondary --set v_m=3.6 --set s_m=7.5 --set z_m=1.1 --set phi_deg=26
    --set m_spreader_t=2 --set m_load_t=60'
runs 0 'alone' sling $alone --set gamma_deg=-4
holds 'n == 1 && near(c["c", 1], 1.14256, 5e-6) && near(c["h_m", 1], 1.0155, 1e-4) &&
    c["verdict", 1] == "stable" && c["why", 1] ~ /h_cross = 1.015 m/' out 'alone: case 1.2.4'
[ "$(head -n 1 out | cut -d, -f1-13)" = "type,v_m,s_m,z_m,phi_deg,m_spreader_t,m_load_t,gamma_deg,\
c,h_m,z_critical_m,verdict,why" ]
ok $? 'alone: its columns, then the five that are fixed'
runs 0 'alone: unstable is a result' sling $alone --set gamma_deg=-6
holds 'c["h_m", 1] < 0 && c["verdict", 1] == "unstable"' out 'gamma = -6 degrees: h < 0'
runs 1 'alone: but not if stable is required' sling $alone --set gamma_deg=-6 --require stable
runs 0 'alone: unstable is required' sling $alone --set gamma_deg=-6 --require unstable
runs 2 'alone: no arrangement' sling $alone --set gamma_deg=-20
[ ! -s out ] && grep -q 'sling: --set: gamma_deg: leaves no base' err
ok $? 'says why, and prints nothing'
mkfifo blocked
timeout 5 sling $alone --set gamma_deg=0 <>blocked >out
ok $? 'alone: standard input is not read'

# Published cases.
runs 0 'published' sling "$cases"
holds 'n == 9 && near(c["h_m", 3], 0.809, 6e-4) && near(c["c", 3], 1.15727, 5e-6) &&
    c["h_m", 2] < 0 && near(c["h_2_m", 7], 3.05, 2e-3) && near(c["h_m", 7], 1.1, 0.03) &&
    near(c["h_1_m", 8], 0.233, 2e-3) && near(c["h_2_m", 8], 2.106, 3e-4) &&
    near(c["h_m", 8], 1.1, 5e-3)' out 'published: h, joint h'
holds 'c["h_cross_m", 4] == "inf" && near(c["h_document_cross_m", 5], 141.6, 5e-4) &&
    near(c["h_document_cross_m", 6], 17.7, 1e-3) && near(c["h_document_long_m", 6], 3.2, 0.015) &&
    near(c["h_cross_m", 5], 131.80, 5e-5) && near(c["h_long_m", 5], 5.267, 1e-4) &&
    near(c["h_cross_m", 6], 16.015, 5e-5) && near(c["h_long_m", 6], 2.282, 3e-4) &&
    c["h_m", 6] == c["h_long_m", 6]' out 'published: elastic slings, corrected and as printed'
holds 'near(c["centre_m", 7] - c["virtual_m", 7], c["h_m", 7], 1e-12) &&
    near(c["centre_1_m", 8], 6.05 + 18.19 - 3.54, 1e-12) &&
    c["h_coupled_m", 7] < c["h_m", 7] && c["why", 7] ~ /tilted alike/' out \
    'published: joint centres, and the verdict on the lesser height'

# A filter.
runs 0 'table' sling lifts.csv
cp out whole.csv
holds 'n == 3 && c["name", 2] == "B; the same" && c["verdict", 1] == "stable" &&
    c["verdict", 2] == "unstable" && c["h_m", 3] == 4' out 'table: all rows'
sling <lifts.csv >out && same whole.csv out 'from standard input'
sling - <lifts.csv >out && same whole.csv out 'from -'
runs 0 '-o' sling -o o.csv lifts.csv
same whole.csv o.csv '-o writes the same'
sed 's/$/\r/; 1s/^/\xef\xbb\xbf/' lifts.csv | sling >out && same whole.csv out 'CR LF, byte order mark'
{ head -n 1 lifts.csv; sed -n 4p lifts.csv; sed -n 2p lifts.csv; } | sling >out
[ "$(sed -n 3p out)" = "$(sed -n 2p whole.csv)" ] && [ "$(sed -n 2p out)" = "$(sed -n 4p whole.csv)" ]
ok $? 'rows do not depend on each other'
runs 0 'set overrides a column' sling --set v_m=4 --set name= lifts.csv
holds 'c["v_m", 2] == 4 && c["name", 2] == "" && c["h_m", 3] == 2' out \
    'and the output has what was used'
runs 0 'set adds a column' sling --set stabilized=yes lifts.csv
[ "$(head -n 1 out | cut -d, -f13)" = stabilized ] && [ "$(sed -n 2p out | cut -d, -f13)" = yes ]
ok $? 'behind those of the file'
runs 0 'verbose' sling -v lifts.csv
says 'sling: 2 stable, 0 marginal, 1 unstable, 0 not judged' 'tells what there is of each verdict'
runs 0 'limit' sling --limit 1.1 lifts.csv
holds 'c["verdict", 1] == "marginal" && c["verdict", 2] == "unstable" && c["verdict", 3] == "stable" &&
    c["why", 1] ~ /1.015 m is below the limit 1.1 m/' out 'limit: marginal below it'
runs 1 'require stable' sling --require stable lifts.csv
[ "$(wc -l <out)" -eq 4 ]
ok $? 'all rows are written'
runs 1 'require marginal' sling --require marginal lifts.csv
head -n 2 lifts.csv >first.csv
runs 0 'require stable: it is' sling --require stable first.csv
runs 1 'require stable: marginal is worse' sling --limit 2 --require stable first.csv
runs 0 'require marginal: it is' sling --limit 2 --require marginal first.csv

# Forces and tilt: the whole weight hangs on the slings.
holds 'near(4 * c["force_low_kN", 3] * 0, 0, 1) && c["force_low_kN", 3] > c["force_high_kN", 3] &&
    near(c["tilt_load_deg", 3], atan2(0.1, 4) * 180 / atan2(0, -1), 1e-12) &&
    near(c["tilt_spreader_deg", 1], atan2(0.1, c["h_m", 1]) * 180 / atan2(0, -1), 1e-12) &&
    c["tilt_load_deg", 1] > c["tilt_spreader_deg", 1] && c["tilt_spreader_deg", 3] == "" &&
    near(c["use_primary", 3], c["force_low_kN", 3] / 300, 1e-12) &&
    near(c["range_deg", 3], 30, 1e-12) && c["moment_kNm", 3] < c["moment_0_kNm", 3]' whole.csv \
    'tilt of spreader and load, forces, use, moment'
runs 0 'no offset' sling --set offset_m= lifts.csv
holds 'near(c["force_low_kN", 3], 60 * 9.81 / 4 / cos(atan2(0, -1) / 6), 1e-12) &&
    c["force_low_kN", 3] == c["force_high_kN", 3] && c["tilt_load_deg", 3] == "" &&
    near(4 * c["secondary_low_kN", 1] * cos(4 * atan2(0, -1) / 180), 60 * 9.81, 1e-12) &&
    near(4 * c["force_low_kN", 1] * cos(26 * atan2(0, -1) / 180), 62 * 9.81, 1e-12)' out \
    'upright: slings carry the weight'

# How many slings share the load is told where nobody gave it.
bar='--set type=primary --set v_m=8 --set z_m=1 --set base_long_m=9'
runs 0 'slings assumed' sling $bar --set m_load_t=120
holds 'c["why", 1] ~ /; 4 slings assumed$/' out 'forces are those of four, why says'
[ ! -s err ]
ok $? 'without a warning, as there is no limit'
runs 0 'slings given' sling $bar --set m_load_t=120 --set slings=2 --set wll_kN=2000
[ ! -s err ] && ! grep -q assumed out
ok $? 'slings given: nothing is assumed'
runs 0 'neither forces nor slings' sling $bar
! grep -q assumed out
ok $? 'without forces it does not matter'
runs 0 'limit without slings' sling --set offset_m= lifts.csv
[ "$(grep -c 'slings is empty' err)" -eq 1 ]
ok $? 'a working load limit without slings: one warning a table'
says 'sling: lifts.csv:2: a working load limit, but slings is empty: 4 assumed' 'in its first row'
runs 0 'limit without slings, a pair' sling --set type=pair --set m_load_t=30 --set e1_m=2 \
    --set e2_m=3 --set z_m=-1 --set v_2_m=2 --set phi_2_deg=30 --set slings_2=4
holds 'c["why", 1] ~ /; 1 sling assumed at end 1$/' out 'of a pair: which end'

# What would make h zero.
for what in z_critical_m:z_m v_critical_m:v_m gamma_critical_deg:gamma_deg; do
    sling lifts.csv >out
    value=$(awk -F, -v c="${what%:*}" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i }
        NR == 2 { print $k }' out)
    sling -q --set "${what#*:}=$value" first.csv >out
    holds 'abs(c["h_m", 1]) < 1e-9' out "${what%:*} put back makes h = 0"
done

# Tolerances.
holds 'c["h_worst_m", 1] < c["h_m", 1] - 0.29 && c["h_worst_m", 1] > c["h_m", 1] - 0.3 &&
    near(c["h_worst_m", 3], 3.8, 1e-9)' whole.csv 'tolerances: the worst case'
runs 0 'marginal within tolerances' sling --set z_m_tol=0.8 first.csv
holds 'c["verdict", 1] == "marginal" && c["why", 1] ~ /within the tolerances/' out 'says so'
runs 0 'samples' sling --samples 20000 --limit 3.9 lifts.csv
cp out samples.csv
holds 'abs(c["p_below", 3] - 0.25) < 0.015 && c["p_below", 1] == 1 &&
    abs(c["h_mean_m", 3] - 4) < 0.003 && abs(c["h_deviation_m", 3] - 0.2 / sqrt(3)) < 0.003' out \
    'samples: uniform within the tolerance'
sling --samples 20000 --limit 3.9 lifts.csv >out && same samples.csv out 'the same again'
sling --samples 20000 --limit 3.9 --seed 2 lifts.csv >out
! cmp -s samples.csv out
ok $? 'another seed, other samples'
runs 2 'samples without tolerances' sling --samples 10 $alone --set gamma_deg=0
runs 0 'derivatives' sling --derivatives lifts.csv
holds 'near(c["dh_dz_m", 3], -1, 1e-12) && c["dh_ds_m", 3] == "" && c["matters_most", 1] == "z_m" &&
    c["dh_dv_m", 1] > 1 && c["dh_dgamma_deg", 1] > 0.4' out 'derivatives'
runs 0 'derivatives without tolerances' sling --derivatives $alone --set gamma_deg=-4
holds 'c["matters_most", 1] == "gamma_deg"' out 'what matters most'

# Design.
for column in v_m gamma_deg m_spreader_t z_m s_m; do
    sling -q --design $column=1.2 first.csv >out
    value=$(sed -n '2s/.*,//p' out)
    sling -q --set "$column=$value" first.csv >out
    holds 'near(c["h_m", 1], 1.2, 1e-6)' out "design $column: put back"
done
runs 1 'design: there is none' sling --design phi_deg=100 first.csv
says 'first.csv:2: --design: no phi_deg near the present one gives 100 m' 'says so'
holds 'c["design_phi_deg", 1] == "" && c["verdict", 1] == "stable"' out 'the row has its verdict'
sling --design z_2_m=0.2 --set type=pair --set m_load_t=30 --set e1_m=2 --set e2_m=3 --set z_m=0.5 \
    --set v_m=2 --set phi_deg=30 --set z_2_m=0.7 >out
holds 'c["design_z_2_m", 1] > 0.7' out 'design: of one end of a pair'

# Contours.
runs 0 'contour' sling --contour z_m=0:2:5,gamma_deg=-6:0:4 --limit 0.5 first.csv
header out z_m,gamma_deg,h_m,verdict,why 'contour: columns'
holds 'n == 20 && c["z_m", 20] == 2 && c["gamma_deg", 20] == 0 && c["verdict", 1] == "stable" &&
    near(c["h_m", 4], 3.72, 1e-12) && c["verdict", 17] == "unstable"' out 'contour: all points'
runs 0 'contour without ranges' sling --contour z_m,gamma_deg $alone --set gamma_deg=-4
holds 'n == 41 * 41 && near(c["z_m", 1], 0.55, 1e-12) && c["gamma_deg", 1] == -14 &&
    c["verdict", 1] == "not-judged" && c["h_m", 1] == "" && c["why", 1] ~ /leaves no base/' out \
    'half to one and a half of the present value; what is no arrangement is not judged'
holds 'c["why", 2] !~ /tolerances/' out 'contour: without tolerances'
runs 0 'contour with tolerances' sling --set offset_m= --contour z_m=1.6:1.8:2,v_m=3.6:3.7:2 first.csv
holds 'c["verdict", 1] == "marginal" && c["why", 1] ~ /within the tolerances/' out \
    'contour: tolerances count'
cat >twice.csv <<END
type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,base_long_m
primary-secondary,8,6,1.5,32.005,-4.7636,4,9
END
runs 0 'contour: all given twice' sling --set m_load_t=120 --contour z_m,gamma_deg twice.csv
says 'sling: 1640 of 1681 points contradict base_long_m = 9: leave it out to vary gamma_deg' \
    'contour: how many points are none, and what to leave out'
runs 0 'contour: one left out' sling --set m_load_t=120 --set base_long_m= \
    --contour z_m,gamma_deg twice.csv
[ ! -s err ]
ok $? 'contour: then all are judged'
runs 0 'contour: no base' sling --contour z_m,gamma_deg $alone --set gamma_deg=-4
says '82 of 1681 points are not judged: gamma_deg: leaves no base' 'contour: other reasons'
runs 1 'design: all given twice' sling --set m_load_t=120 --design v_m=7 twice.csv
says '--design: other values of v_m contradict base_long_m = 9: leave it out' 'design: why'
runs 1 'design: of what is not given' sling --design sling_m=1 first.csv
says '--design: sling_m has no value to begin with' 'design: from where'
runs 2 'contour of two rows' sling --contour z_m,v_m lifts.csv

# The resolved case.
sling --print-case "$cases" >once.csv
sling --print-case once.csv >twice.csv
same once.csv twice.csv '--print-case: the resolved case resolves to itself'
sling once.csv >out
sling "$cases" >whole.csv
holds 'near(c["h_m", 8], 1.10122149, 1e-8) && c["slings_1", 8] == 2 && c["use", 6] == 1' out \
    '--print-case: the same heights'

# Rows that cannot be used, columns that are none.
cat >bad.csv <<END
name,type,v_m,z_m,phi_deg,crane
ok,primary,6,2,30,X
nan,primary,nan,2,30,X
huge,primary,1e400,2,30,X
short,primary,6
wrong,secondary,6,2,30,X
none,,6,2,30,X
quote,primary,6,2,30,"X"Y
comma,primary,"6,5",2,30,X
steep,primary,6,2,0,X
flat,primary,6,2,90,X
again,primary,6,2,30,Z
END
runs 1 'bad rows' sling bad.csv
says "bad.csv:1: column 6: 'crane' is no column of sling; it is only copied" 'one warning'
[ "$(grep -c 'bad.csv:' err)" -eq 10 ]
ok $? 'a line for each bad row'
holds 'n == 11 && c["verdict", 1] == "stable" && c["verdict", 11] == "stable" && c["h_m", 11] == 4 &&
    c["verdict", 2] == "not-judged" && c["why", 2] ~ /v_m: .nan.: not a number/ && c["h_m", 2] == ""' \
    out 'numbers of bad rows are empty, why is not; the others are whole'
awk -F, 'NR > 1 && !/,(stable|not-judged),/ { bad = 1 } END { exit bad }' out
ok $? 'every row has a verdict'
! grep -qi 'nan,' out || ! grep -i ',nan,' out | grep -qv '^nan,'
ok $? 'no result is NaN'
runs 1 'bad rows, -q' sling -q bad.csv
[ "$(grep -c 'only copied' err)" -eq 0 ] && [ "$(grep -c 'bad.csv:' err)" -eq 9 ]
ok $? 'warnings are silent, errors are not'
{ cat lifts.csv; printf ',,,,,,,,,,,\n , ,,,,,,,,,,\n,\n'; } >sheet.csv
runs 0 'rows of commas alone' sling sheet.csv
sling -q lifts.csv >whole.csv
same whole.csv out 'are passed over, as spreadsheets leave them'
tr , '\t' <lifts.csv >tabs.csv
runs 2 'tabs' sling tabs.csv
says "tabs.csv:1: columns are separated by tabs; expected ','" 'are named'
for word in V phi gama_deg phi_rad m_load_kg typ; do
    printf 'type,v_m,z_m,%s\nprimary,6,2,30\n' $word >near.csv
    runs 2 "a column that is nearly one: $word" sling near.csv
    [ ! -s out ] && grep -q 'is no column of sling; is .* meant?' err
    ok $? 'is refused, and nothing printed'
done

# Light: no linear algebra is loaded.
if [ -z "${SEILWERK_SANITIZED:-}" ]; then
    ! ldd "$(command -v sling)" | grep -qE 'blas|lapack|arpack'
    ok $? 'sling does not load BLAS'
fi
runs 0 '--help' sling --help
runs 0 '--version' sling --version
finish
