#!/bin/sh
# Every example of the manual pages runs: lines that begin with "$ ", continued by "> ".
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1

for page in "$top"/man/*.[1-9]; do
    name=$(basename "$page")
    mkdir "$name.d" && cd "$name.d" || exit 1
    sed 's/^end = .*/end = 5/' "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini
    # each "$ " begins a command of its own, "> " goes on with the last one
    awk '/^\$ / { n++ } /^\$ / || (/^> / && n) { sub(/^[$>] /, ""); gsub(/\\e/, "\\");
         print >sprintf("example%02d", n) }' "$page"
    for example in example*; do
        [ -e "$example" ] || continue
        sh -eu "./$example" >out 2>err </dev/null
        status=$?
        { [ $status -eq 0 ] && [ ! -s err ]; } || sed 's/^/# /' "$example" err
        { [ $status -eq 0 ] && [ ! -s err ]; }
        ok $? "$name: $(head -n 1 "$example")"
    done
    cd ..
done
finish
