#!/bin/sh
# The frame of the experiments: scripts/experiment, the rules of make, the report; and what is said
# of each experiment.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
scripts=$top/scripts

# A project of two experiments without a tool.
mkdir -p project/scripts/experiments/one project/scripts/experiments/'two b'
cp "$top/VERSION" project
cp -r "$scripts/published" "$scripts/experiment" project/scripts
cd project/scripts/experiments || exit 1
cat >one/run <<'END'
#!/bin/sh
set -eu
printf '<svg xmlns="http://www.w3.org/2000/svg"/>\n' >"$1/p.svg"
printf 'a,b\n1,2.00000000000001\n' >"$1/t.csv"
echo "QUICK=${QUICK:-}" >"$1/words.txt"
[ ! -e "$(dirname "$0")/fails" ] || exit 3
END
cat >one/computed <<'END'
#!/bin/sh
[ -e "$1/p.svg" ] || exit 1
printf 'quantity,by,computed\na,x,1.5\na,y,1.25\nb,,2.0004\nc,,%s\n' "${C:-7.4}"
END
cat >one/published.csv <<'END'
quantity,unit,published,source,why
a,m,1.50,"Bild 1, 2","<y> & ""less"""
b,,1.9..2.1,,
c,s,8,Tab. 3,it is another clock
END
cat >one/about <<'END'
One & <only>

First words
of a paragraph.
figure: p A picture "so".
table: t.csv A table.
text: words.txt
END
printf '#!/bin/sh\necho no numbers >"$1/p.svg"\n' >'two b/run'
chmod +x one/run one/computed 'two b/run'
touch one/rules.mk
cd "$scratch" || exit 1
experiment=project/scripts/experiment
folder=project/scripts/experiments/one

for words in '' 'run' "all $folder" "both $folder made" "run -x made"; do
    # shellcheck disable=SC2086
    runs 2 "experiment $words: usage" $experiment $words
    says 'usage: experiment ' 'says how'
done
runs 2 'no experiment' $experiment run project made
says 'has no run' 'says so'
runs 0 'run and compare' env QUICK=yes $experiment all $folder made/one
[ "$(cat made/one/words.txt)" = QUICK=yes ] && [ -e made/one/done ] && [ ! -e made/.part ]
ok $? 'its files; nothing else is left'
cat >wanted.csv <<'END'
quantity,unit,published,by,computed,difference,agrees,source,why
a,m,1.50,x,1.5,+0.0e+00,equal,"Bild 1, 2","<y> & ""less"""
a,m,1.50,y,1.25,-1.7e-01,no,"Bild 1, 2","<y> & ""less"""
b,,1.9..2.1,,2.0004,within,within,,
c,s,8,,7.4,-7.5e-02,no,Tab. 3,it is another clock
END
same wanted.csv made/one/comparison.csv 'the comparison for scripts'
grep -q '^a .* =  .* Bild 1, 2 \[1\]$' made/one/comparison.txt &&
    grep -q '^\[2\] it is another clock$' made/one/comparison.txt
ok $? 'the comparison for people, with reasons'
cp -r made/one before
touch $folder/fails
runs 3 'a run that fails' $experiment run $folder made/one
diff -r before made/one && [ ! -e made/.part ]
ok $? 'leaves the results of the last one'
rm $folder/fails
cp made/one/comparison.csv kept.csv
sed -i 's/,it is another clock/,/' $folder/published.csv
runs 1 'a difference without a reason' $experiment compare $folder made/one
says 'c: differs from what is published; say why' 'says which'
same kept.csv made/one/comparison.csv 'leaves the last comparison'
runs 0 'equal numbers need none' env C=8 $experiment compare $folder made/one
sed -i 's/^c,s,8,Tab. 3,/c,s,8,Tab. 3,it is another clock/' $folder/published.csv
runs 0 'compare' $experiment compare $folder made/one
runs 0 'a name with a blank, no published numbers' $experiment all 'project/scripts/experiments/two b' 'made/t w/x'
[ -e 'made/t w/x/done' ] && [ ! -e 'made/t w/x/comparison.csv' ]
ok $? 'its results'

# The report.
printf '# Group <1>\n\none\n' >project/scripts/experiments/contents
report=$scripts/report
runs 2 'report: usage' "$report" made
says 'usage: report ' 'says how'
runs 0 'report' "$report" project/scripts/experiments made
cp out page.html
for part in '<h2>Group &lt;1&gt;</h2>' '<h3>One &amp; &lt;only&gt;</h3>' '<p>First words of a paragraph.</p>' \
    'alt="A picture &quot;so&quot;."' '<caption>A table.</caption>' '<td class="number">2</td>' '<pre>QUICK=yes' \
    '1 published numbers are equal in all digits, 1 lie within' '>1 differ for' '<sup>2</sup> it is another clock' \
    '<li>It is another clock (<a href="#one">one</a>: 1, -7.5 %)</li>' \
    '<li>&lt;y&gt; &amp; &quot;less&quot; (<a href="#one">one</a>: 1, -17 %)</li>' 'Full variant' \
    "Seilwerk $(cat "$top/VERSION")"; do
    tr '\n' ' ' <page.html | sed 's/> *1 differ for/>1 differ for/; s/, 1 differ for/, >1 differ for/' |
        grep -qF -e "$part"
    ok $? "report: $part"
done
! grep -qE '(src|href)="?[^"#d]' page.html && ! grep -q '@import\|url(' page.html
ok $? 'report: refers to nothing outside'
"$report" project/scripts/experiments made | cmp -s - page.html
ok $? 'report: the same bytes again'
"$report" --quick project/scripts/experiments made | grep -q 'Quick variant'
ok $? 'report: says when it is the quick one'
if command -v xmllint >/dev/null 2>&1; then
    # libxml2 knows HTML 4 and not figure, section, details
    xmllint --html --noout page.html 2>&1 | grep -i error | grep -vE 'Tag (figure|figcaption|section|details|summary) invalid'
    [ $? -eq 1 ]
    ok $? 'report: well-formed'
fi
printf '# Group\n' >project/scripts/experiments/contents
runs 1 'report: an experiment that is not named' "$report" project/scripts/experiments made
says 'one is missing' 'says which'
printf 'one\n' >project/scripts/experiments/contents
runs 1 'report: contents without a heading' "$report" project/scripts/experiments made
printf '# Group\nthree\n' >project/scripts/experiments/contents
runs 1 'report: no such experiment' "$report" project/scripts/experiments made
says 'three/about: cannot be read' 'says which'

# Every experiment of the project: its files, its place in the report, its rule.
contents=$scripts/experiments/contents
for rules in "$scripts"/experiments/*/rules.mk; do
    folder=${rules%/*}
    name=${folder##*/}
    bad=
    [ -x "$folder/run" ] || bad="$bad run"
    [ "$(grep -c "call experiment,$name," "$rules")" -eq 1 ] || bad="$bad rules.mk"
    [ "$(grep -cx "$name" "$contents")" -eq 1 ] || bad="$bad contents"
    [ "$(wc -w <"$folder/about")" -gt 40 ] || bad="$bad about"
    if [ -e "$folder/published.csv" ]; then
        [ -x "$folder/computed" ] || bad="$bad computed"
    fi
    [ -z "$bad" ] || echo "# $name: $bad"
    [ -z "$bad" ]
    ok $? "$name is whole"
done

# When make runs one again.  Tools are taken as they are.
results=$scratch/results
ask()
{
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -C "$top" BUILD="$scratch/none" RESULTS="$results" "$@"
}
old=BIN=$scratch/tools # where no rule makes them
mkdir -p "$results/lifts"
runs 0 'make: no results' ask -n "$results/lifts/comparison.csv"
grep -q 'scripts/experiment run scripts/experiments/lifts' out && grep -q 'bin/sling' out
ok $? 'runs it, with its tools'
mkdir tools
touch tools/sling
touch "$results/lifts/done"
touch "$results/lifts/comparison.csv"
runs 0 'make: up to date' ask -q "$old" "$results/lifts/comparison.csv"
for newer in experiments/lifts/cases.csv experiments/lifts/run plot/lift plot/setup.sh experiment; do
    runs 1 "make: $newer is newer" ask -q "$old" -W "scripts/$newer" "$results/lifts/done"
done
for newer in published.csv computed; do
    runs 0 "make: only $newer is newer" ask -q "$old" -W "scripts/experiments/lifts/$newer" "$results/lifts/done"
    runs 1 'compares again' ask -q "$old" -W "scripts/experiments/lifts/$newer" "$results/lifts/comparison.csv"
done

finish
