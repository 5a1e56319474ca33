#!/bin/sh
# The Debian package: made twice, in directories, time zones and with umasks of different kinds, it
# is the same.  Unpacked it runs; every page can be found; lintian finds no error and no warning.
. "$(dirname "$0")/../tap.sh"
for program in dpkg-buildpackage dh lintian fakeroot; do
    command -v "$program" >/dev/null || {
        echo "1..0 # SKIP no $program (make deps-package)"
        exit 0
    }
done
git -C "$top" rev-parse -q --verify HEAD >/dev/null 2>&1 || {
    echo '1..0 # SKIP no git checkout'
    exit 0
}
export DEB_BUILD_OPTIONS=nocheck # the tests have run before
runs 0 'the package, clean of errors and warnings' "$top/scripts/deb" "$scratch/one"
(
    umask 077
    cd / && TZ=Asia/Tokyo LC_ALL=C.UTF-8 HOME=$scratch \
        "$top/scripts/deb" "$scratch/another/place" >"$scratch/out" 2>&1
)
ok $? 'again, elsewhere'
for file in "$scratch/one"/*.dsc "$scratch/one"/*.tar.* "$scratch/one"/*.deb; do
    same "$file" "$scratch/another/place/${file##*/}" "${file##*/} is the same"
done
dpkg-deb -x "$scratch/one"/seilwerk_*.deb "$scratch/root"
ok $? 'unpacked'
[ "$(PATH=$scratch/root/usr/bin:$PATH catenary --version)" = \
    "catenary (Seilwerk) $(git -C "$top" show HEAD:VERSION)" ]
ok $? 'catenary tells its version'
"$scratch/root/usr/bin/seilwerk-study" --print-table --grid a.b=1,2 >"$scratch/out"
ok $? 'seilwerk-study finds its parts'
grep -rlF -e "$scratch" -e "$top" "$scratch/root" >"$scratch/out"
[ ! -s "$scratch/out" ]
ok $? 'no path of this machine'
if command -v mandb >/dev/null; then
    mandb -q -c -u "$scratch/root/usr/share/man" 2>"$scratch/err"
    for page in seilwerk seilwerk-case seilwerk-study catenary modal gapnet sling wirebeam; do
        MANPATH=$scratch/root/usr/share/man man -k "^$page\$" | grep -q "^$page "
        ok $? "man -k finds $page"
    done
else
    skip 'no mandb'
fi
finish
