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
completed=$scratch/stage/opt/sw/share
for tool in catenary modal seilwerk-study; do
    grep -q "^complete .* x-$tool\$" "$completed/bash-completion/completions/x-$tool" &&
        grep -q "^#compdef x-$tool\$" "$completed/zsh/site-functions/_x-$tool"
    ok $? "x-$tool has its completion"
done
runs 0 'make uninstall' make -s -C "$top" uninstall BUILD="$SEILWERK_BUILD" \
    DESTDIR="$scratch/stage" PREFIX=/opt/sw PROGRAM_PREFIX=x-
[ ! -e "$scratch/stage" ]
ok $? 'nothing is left'

# Beside others, where there are blanks in names, by a user whose files nobody else may read.
mkdir -p "$scratch/my tree/bin" "$scratch/my tree/share/empty"
(
    umask 077
    make -s -C "$top" install BUILD="$SEILWERK_BUILD" PREFIX="$scratch/my tree"
) >"$scratch/out" 2>&1
ok $? 'make install into a directory with blanks'
"$scratch/my tree/bin/seilwerk-study" --print-table --grid a.b=1,2 >"$scratch/out"
ok $? 'seilwerk-study runs there'
[ -z "$(find "$scratch/my tree" -newer "$scratch/links" ! -perm -004)" ]
ok $? 'all may read it'
: >"$scratch/my tree/share/man/man1/other.1"
runs 0 'make uninstall' make -s -C "$top" uninstall BUILD="$SEILWERK_BUILD" PREFIX="$scratch/my tree"
[ "$(cd "$scratch/my tree" && find . | LC_ALL=C sort | tr '\n' ' ')" = \
    '. ./bin ./share ./share/empty ./share/man ./share/man/man1 ./share/man/man1/other.1 ' ]
ok $? 'what was there, and what others put there, is left, empty directories, too'

# make dist: the commit alone, from anywhere, by anybody.
if git -C "$top" rev-parse -q --verify HEAD >/dev/null 2>&1; then
    "$top/scripts/dist" >"$scratch/one.tar.gz"
    ok $? 'the source archive'
    git clone -q --no-local --depth 1 "file://$top" "$scratch/a clone" &&
        printf '* -text export-subst\nREADME.md export-ignore\n' >"$scratch/attributes" &&
        printf '[tar]\n\tumask = 077\n[core]\n\tattributesFile = %s\n' "$scratch/attributes" \
            >"$scratch/.gitconfig" && : >"$scratch/a clone/untracked" && (
        umask 077
        cd / && HOME=$scratch TZ=Asia/Tokyo LC_ALL=C.UTF-8 GZIP='' "$scratch/a clone/scripts/dist"
    ) >"$scratch/two.tar.gz"
    same "$scratch/one.tar.gz" "$scratch/two.tar.gz" \
        'the same from a clone, elsewhere, with another umask, time zone and configuration'
    tar -xzf "$scratch/one.tar.gz" -C "$scratch" &&
        version=$(git -C "$top" show HEAD:VERSION) &&
        make -s -n -C "$scratch/seilwerk-$version" all >"$scratch/plan" &&
        grep -q -- "-DSEILWERK_VERSION='\"$version\"'" "$scratch/plan"
    ok $? 'what it holds can be built, with the version of VERSION'
    mkdir "$scratch/bare" && cp -r "$top/scripts" "$scratch/bare"
    runs 1 'no archive without git' env GIT_CEILING_DIRECTORIES="$scratch" "$scratch/bare/scripts/dist"
    says 'from a git checkout' 'and says so'
else
    skip 'no git checkout'
fi
finish
