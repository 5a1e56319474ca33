#!/bin/sh
# make install, uninstall and dist in a scratch directory.
. "$(dirname "$0")/../tap.sh"
[ -z "${SEILWERK_SANITIZED:-}" ] || {
    skip 'not under the sanitizers'
    finish
}

runs 0 'make install' make -s -C "$top" install BUILD="$SEILWERK_BUILD" \
    DESTDIR="$scratch/stage" PREFIX=/opt/sw PROGRAM_PREFIX=x-
for tool in catenary modal diffverf; do
    "$scratch/stage/opt/sw/bin/x-$tool" --version >/dev/null
    ok $? "x-$tool runs"
    cmp "$top/man/$tool.1" "$scratch/stage/opt/sw/share/man/man1/x-$tool.1" >&2
    ok $? "x-$tool has its page"
done
[ -f "$scratch/stage/opt/sw/share/man/man5/seilwerk-case.5" ] &&
    [ -f "$scratch/stage/opt/sw/share/man/man7/seilwerk.7" ]
ok $? 'the other pages keep their names'
cmp "$top/man/seilwerk-study.1" "$scratch/stage/opt/sw/share/man/man1/x-seilwerk-study.1" >&2
ok $? 'x-seilwerk-study has its page'
runs 0 'x-seilwerk-study runs, with its parts' "$scratch/stage/opt/sw/bin/x-seilwerk-study" \
    --print-table --grid a.b=1,2
mkdir "$scratch/links" && ln -s "$scratch/stage/opt/sw/bin/x-seilwerk-study" "$scratch/links/any"
runs 0 'by a link, too' "$scratch/links/any" --print-table --latin 2 --vary a.b=1:2
runs 0 'make uninstall' make -s -C "$top" uninstall BUILD="$SEILWERK_BUILD" \
    DESTDIR="$scratch/stage" PREFIX=/opt/sw PROGRAM_PREFIX=x-
[ -z "$(find "$scratch/stage" -type f -o -name '*study*')" ]
ok $? 'nothing is left'
finish
