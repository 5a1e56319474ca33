# Sourced by the plot scripts: checks, scratch directory, common look of the pictures.
# shellcheck shell=sh
name=${0##*/}
LC_ALL=C
export LC_ALL

usage()
{
    sed -n '2s/^# //p' "$0" >&2
    exit 2
}

fail()
{
    echo "$name: $1" >&2
    exit "${2:-1}"
}

# begin PICTURE INPUT...: judge all before any work; $work is a scratch directory.
begin()
{
    picture=$1
    shift
    for input in "$@"; do
        [ -r "$input" ] || fail "$input: cannot be read" 2
    done
    command -v gnuplot >/dev/null 2>&1 ||
        fail 'gnuplot is missing; install it (Debian: apt-get install gnuplot-nox)'
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
}

# A text as it may stand between quotes of gnuplot: it ends there, and what is between backquotes is
# run; a newline ends the command.
plain()
{
    printf '%s' "$1" | tr "'\"\`\\\\\\n" '     '
}

# What the picture is about: the name of the directory that holds FILE.
about()
{
    plain "$(basename "$(cd -- "$(dirname -- "$1")" && pwd)")"
}

# place CASE PROBE: "0.5 L0", where the resolved case says that the probe is, or "probe 1".
place()
{
    [ -z "$1" ] || at=$(awk -v probe="$2" '
        /^\[/ { here = $1 == "[time]" }
        here && $1 == "probes" && probe + 2 <= NF { printf "%.3g L0", $(probe + 2) }' "$1")
    echo "${at:-probe $2}"
    at=
}

# ticks EXTENT: a step of 1, 2 or 5 times a power of ten that goes into it two to five times, so that
# labels of a small panel do not run into each other; as gnuplot likes where there is no extent.
ticks()
{
    awk -v extent="$1" 'BEGIN {
        if (!(extent > 0)) { print "autofreq"; exit }
        extent *= 1 - 1e-9
        unit = 1e-300
        while (unit < extent/50) unit *= 10
        while (5*unit < extent) unit *= 10
        step = unit
        if (5*(unit/2) >= extent) step = unit/2
        if (5*(unit/5) >= extent) step = unit/5
        printf "%.6g\n", step
    }'
}

# draw: the commands on stdin make the picture; it is written when it is complete.  The suffix of its
# name says the format: png, svg or pdf.  $size and $text are for a picture that needs other ones.
size=1200,800
text=noenhanced
draw()
{
    case $picture in
    *.svg) terminal="svg $text size $size dynamic font 'sans-serif,16' linewidth 1.2" ;;
    *.pdf) terminal="pdfcairo $text size $(echo "$size" | sed 's/00/in/g') font 'Sans,13'" ;;
    *) terminal="pngcairo $text size $size font 'Sans,13' linewidth 1.2" ;;
    esac
    {
        cat <<END
set terminal $terminal
set encoding utf8
set output '$work/picture'
set grid linecolor rgb '#d8d8d8' linetype 1 linewidth 0.6
set tics nomirror out
set border 3 linecolor rgb '#404040'
set format '%g'
blue = '#0060ad'; orange = '#d95f02'; green = '#1b8a5a'; purple = '#7555b3'
array colour[4] = [blue, orange, green, purple]
END
        cat
    } >"$work/picture.gp"
    LC_ALL=C.UTF-8 gnuplot "$work/picture.gp" || fail "gnuplot could not draw $picture"
    # PDF holds the time at which it was made: the same picture is to be the same file.  The date that
    # stands in its place is as long, so the table of offsets at the end stays right.
    case $picture in
    *.pdf)
        LC_ALL=C sed 's/Date (D:[0-9]\{14\}/Date (D:19700101000000/' "$work/picture" >"$work/dated"
        mv "$work/dated" "$work/picture"
        ;;
    esac
    cat "$work/picture" >"$picture" || fail "$picture: cannot be written"
}
