#!/bin/sh
# Every example runs: of the manual pages, lines that begin with "$ ", continued by "> "; of the
# README, indented blocks that begin with a tool, a table, a deck or a generator.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
mkdir bin && ln -s "$top/scripts/study" bin/seilwerk-study && PATH=$scratch/bin:$PATH

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
        sed -i '/^seilwerk-study: [0-9]* points: [0-9]* done$/d' err # tells that all is well
        { [ $status -eq 0 ] && [ ! -s err ]; } || sed 's/^/# /' "$example" err
        { [ $status -eq 0 ] && [ ! -s err ]; }
        ok $? "$name: $(head -n 1 "$example")"
    done
    cd ..
done

mkdir readme && cd readme || exit 1
sed 's/^end = .*/end = 5/' "$top/scripts/experiments/ben-ahin/case.ini" >stay.ini
ln -s "$top/scripts" scripts
awk '/^    / { if (!inside) { inside = 1; n++ } sub(/^    /, ""); print >sprintf("block%02d", n); next }
     { inside = 0 }' "$top/README.md"
run=0
for block in block*; do
    head -n 1 "$block" | grep -qE '^(catenary|modal|diffverf|for|\{|scripts/(net|wire)/[a-z]+|deck=[^ ]+) ' || continue
    command -v gnuplot >/dev/null || sed -i '/single-cable\|scripts.plot/d' "$block"
    sh -eu "./$block" >out 2>err </dev/null
    status=$?
    { [ $status -eq 0 ] && [ ! -s err ]; } || sed 's/^/# /' "$block" err
    { [ $status -eq 0 ] && [ ! -s err ]; }
    ok $? "README: $(head -n 1 "$block")"
    run=$((run + 1))
done
[ $run -ge 7 ]
ok $? 'README: its pipelines were found'
finish
