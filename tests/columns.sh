# Sourced behind tap.sh: conditions over the columns of a table, by their names.
# shellcheck shell=sh

# What the conditions may use: near(x, y, relative[, absolute]); quoted cells lose their commas.
awk_columns='
    function abs(x) { return x < 0 ? -x : x }
    function near(x, y, r, a) { return x != "" && y != "" && abs(x - y) <= r * abs(y) + a }
    function unquote(cell) {
        while (match($0, /"[^"]*"/)) {
            cell = substr($0, RSTART + 1, RLENGTH - 2); gsub(/,/, ";", cell)
            $0 = substr($0, 1, RSTART - 1) cell substr($0, RSTART + RLENGTH) }
    }
    { unquote() }
    NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; columns = NF; next }
    NF != columns { bad = 1 }'

# told STATUS FILE NAME: ok, with the beginning of the file if it failed.
told()
{
    [ "$1" -eq 0 ] || sed 's/^/# /' "$2" | head -n 4
    ok "$1" "$3"
}

# holds CONDITION FILE NAME: of the table, c["h_m", 1] in its first of n rows.
holds()
{
    awk -F, "$awk_columns"'
        { for (i = 1; i <= NF; i++) c[name[i], NR - 1] = $i; n = NR - 1 }
        END { exit bad || !('"$1"') }' "$2"
    told $? "$2" "$3"
}

# for_all CONDITION FILE NAME: of each row, c["h_m"]; there is one at least.
for_all()
{
    awk -F, "$awk_columns"'
        { for (i = 1; i <= NF; i++) c[name[i]] = $i; n = NR - 1
          if (!('"$1"')) { print "# row " n; bad = 1; exit } }
        END { exit bad || n == 0 }' "$2"
    told $? "$2" "$3"
}

# columns NAME,...: of the table on standard input.
columns()
{
    awk -F, -v wanted="$1" "$awk_columns"'
        { for (i = 1; i <= NF; i++) c[name[i]] = $i
          k = split(wanted, w, ",")
          for (i = 1; i <= k; i++) printf "%s%s", c[w[i]], i < k ? "," : "\n" }
        BEGIN { print wanted }'
}
