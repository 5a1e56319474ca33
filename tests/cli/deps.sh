#!/bin/sh
# scripts/deps on a bare machine, played by stand-ins for dpkg-query, id and apt-get.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
mkdir play
stand_in()
{
    printf '#!/bin/sh\n%s\n' "$2" >"play/$1"
    chmod +x "play/$1"
}
deps()
{
    PATH=$scratch/play:$PATH "$top/scripts/deps" "$@"
}
packages=$(awk '$1 == "build" { print $2 }' "$top/scripts/packages" | tr '\n' ' ' | sed 's/ $//')

stand_in dpkg-query 'exit 1'
stand_in id 'echo 1000'
stand_in apt-get 'echo "$@" >>called'
runs 1 'not root: stops' deps build
says "sudo apt-get install -y --no-install-recommends $packages" 'and prints the one line'
[ ! -e called ]
ok $? 'without installing'
stand_in id 'echo 0'
runs 0 'root: installs' deps build
[ "$(cat called)" = "install -y --no-install-recommends $packages" ]
ok $? 'what is missing, in one go'
rm called
stand_in dpkg-query 'echo install ok installed'
runs 0 'nothing is missing' deps build check demo optional
[ ! -e called ] && [ ! -s err ]
ok $? 'nothing is done or said'
stand_in dpkg-query 'exit 1'
stand_in apt-get 'echo "$1" >>called; [ "$1" = update ] || [ "$(grep -c install called)" -gt 1 ]'
runs 0 'an old package list is renewed' deps build
[ "$(tr '\n' ' ' <called)" = 'install update install ' ]
ok $? 'once'
stand_in apt-get 'exit 100'
runs 100 'a failed installation is an error' deps build
finish
