# Sourced by the computed scripts of the experiments: numbers out of the tables of a run, printed as
# a table quantity,by,computed.
# shellcheck shell=sh
LC_ALL=C
export LC_ALL
if [ $# -ne 1 ] || [ ! -r "$1/model/case.ini" ]; then
    sed -n '2s/^# //p' "$0" >&2
    exit 2
fi
here=$(dirname "$0")
case=$here/case.ini
dir=$1

# key NAME: its value in the resolved case.
key()
{
    sed -n "s/^$1 = //p" "$dir/model/case.ini"
}

law="law $(key law)"

# Midspan tension, sag, lambda^2; the sag also without its elastic term, and lambda^2 with mu for
# the mass per metre of span, as the thesis prints them.
static_rows()
{
    awk -F, -v L0="$(key unstressed_length)" -v span="$(key span)" '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        {
            H = $column["horizontal_force_N"]; V = $column["vertical_left_N"]
            W = V + $column["vertical_right_N"]
            # sqrt(1 + (V/H)^2) - 1, without cancellation; the cable hangs between level supports
            rise = (V/H)^2/(1 + sqrt(1 + (V/H)^2))
            printf "midspan tension,,%.10g\n", $column["tension_mid_N"]/1000
            printf "sag,,%.10g\n", $column["sag_m"]
            printf "sag without elastic term,,%.10g\n", H*L0/W*rise
            printf "lambda^2,,%.10g\n", $column["lambda2"]*(span/L0)^2
        }' "$dir/summary.csv"
}

# omega_rows COUNT: the first frequencies, by law printed and by the law of the case.
omega_rows()
{
    modal --set mesh.law=printed -o "$dir/modes-printed.csv" "$case"
    awk -F, -v count="$1" -v law="$law" '
        FNR == 1 { file++; next }
        FNR <= count + 1 { printf "omega %d,%s,%.10g\n", $1, file == 1 ? "law printed" : law, $2 }
        ' "$dir/modes-printed.csv" "$dir/modes.csv"
}

# irvine_rows MODE...: frequencies of these modes once more, to stand beside a column that the sheets
# print from Irvine's closed theory for some of them.
irvine_rows()
{
    awk -F, -v wanted=" $* " -v law="$law" '
        FNR == 1 { file++; next }
        index(wanted, " " $1 " ") {
            printf "mode %d by Irvine,%s,%.10g\n", $1, file == 1 ? "law printed" : law, $2
        }' "$dir/modes-printed.csv" "$dir/modes.csv"
}

# response_by_law_printed: the motion once more, by the law behind the published tables.
response_by_law_printed()
{
    diffverf --set mesh.law=printed -o "$dir/response-printed.csv" "$case"
}

# range_row QUANTITY COLUMN FROM TO WHAT SCALE: the least or greatest value, the largest
# magnitude, or the span from least to greatest (WHAT least, greatest, largest, span) between two
# times, by both laws.
range_row()
{
    awk -F, -v quantity="$1" -v name="$2" -v from="$3" -v to="$4" -v what="$5" -v scale="$6" \
        -v law="$law" '
        FNR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; file++; n[file] = 0; next }
        $1 < from || $1 > to { next }
        {
            x = scale*$c
            if (n[file]++ == 0) low[file] = high[file] = x
            if (x < low[file]) low[file] = x
            if (x > high[file]) high[file] = x
        }
        function result(f)
        {
            if (what == "least") return low[f]
            if (what == "greatest") return high[f]
            if (what == "span") return high[f] - low[f]
            return -low[f] > high[f] ? -low[f] : high[f]
        }
        END {
            for (file = 1; file <= 2; file++)
                printf "%s,%s,%s\n", quantity, file == 1 ? "law printed" : law,
                    (n[file] ? sprintf("%.10g", result(file)) : "missing")
        }' "$dir/response-printed.csv" "$dir/response.csv"
}

# orbit_rows OMEGA TIME: the ellipse that midspan draws in its last periods, and how far v3 goes
# over how far v2 goes, by both laws; TIME in words.
orbit_rows()
{
    for response in response-printed response; do
        by=$law
        [ $response = response ] || by='law printed'
        "$here/../../orbit" "$1" <"$dir/$response.csv" | awk -F, -v time="$2" -v by="$by" '
            NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
            {
                tilt = $column["tilt_deg"]
                v2 = $column["greatest_v2_m"] - $column["least_v2_m"]
                v3 = $column["greatest_v3_m"] - $column["least_v3_m"]
                printf "longer half axis %s,%s,%s\n", time, by, $column["half_axis_m"]
                printf "shorter half axis %s,%s,%s\n", time, by, $column["minor_half_axis_m"]
                printf "angle to the vertical %s,%s,%.6g\n", time, by, tilt < 0 ? -tilt : tilt
                printf "v3/v2 %s,%s,%.8g\n", time, by, v3/v2
            }'
    done
}

# mean_rows QUANTITY COLUMN FROM TO SCALE: the mean between two times, by both laws.
mean_rows()
{
    for response in response-printed response; do
        by=$law
        [ $response = response ] || by='law printed'
        awk -F, -v quantity="$1" -v name="$2" -v from="$3" -v to="$4" -v scale="$5" -v by="$by" '
            NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
            $1 < from || $1 > to { next }
            { sum += $c; n++ }
            END { printf "%s,%s,%s\n", quantity, by, (n ? sprintf("%.10g", scale*sum/n) : "missing") }
            ' "$dir/$response.csv"
    done
}

# decay_rows FROM TO: frequency and rate of decay of v3 between two times, by both laws: from the
# times at which it is zero, and from the largest values between them by least squares.
decay_rows()
{
    for response in response-printed response; do
        by=$law
        [ $response = response ] || by='law printed'
        awk -F, -v from="$1" -v to="$2" -v by="$by" '
            NR == 1 { for (i = 1; i <= NF; i++) if ($i == "v3_1_m") c = i; next }
            $1 < from || $1 > to { next }
            {
                x = $c
                if (n++ && x*before <= 0 && x != before) {
                    zero = t + ($1 - t)*before/(before - x)
                    if (zeros++ && most > 0) {
                        m++; y = log(most); sx += peak; sy += y; sxx += peak*peak; sxy += peak*y
                    }
                    if (zeros == 1) first = zero
                    most = 0
                }
                if (x*x > most*most) { most = x < 0 ? -x : x; peak = $1 }
                t = $1; before = x
            }
            END {
                if (m < 3) { print "decay of v3," by ",missing"; exit }
                printf "frequency of v3 while it dies,%s,%.8g\n", by,
                    (zeros - 1)*atan2(0, -1)/(zero - first)
                printf "decay of v3,%s,%.6g\n", by, -(m*sxy - sx*sy)/(m*sxx - sx*sx)
            }' "$dir/$response.csv"
    done
}

# rayleigh_decay_row: what the damping of the case takes from the first mode, lateral, by itself.
rayleigh_decay_row()
{
    awk -F, -v alpha="$(key alpha)" -v beta="$(key beta)" '
        NR == 2 { printf "decay of v3,first mode alone,%.6g\n", (alpha + beta*$2*$2)/2 }
        ' "$dir/modes.csv"
}

echo quantity,by,computed
