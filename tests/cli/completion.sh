#!/bin/sh
# Completion of the shells, made from the tables that the tools print with --options.
. "$(dirname "$0")/../tap.sh"
cd "$scratch" || exit 1
make="$top/scripts/completion"

# Every option of --help stands in the table, and nothing else.
for tool in catenary diffverf gapcheck gapnet modal sling stabil wirebeam "$top/scripts/study"; do
    name=${tool##*/}
    "$tool" --options >"$name.options"
    "$tool" --help | grep -oE '^  .{27}' | grep -oE -e '(^| )-(-[a-z-]+|[a-z])' | tr -d ' ' | sort >help
    awk -F '\t' 'NR > 1 { for (i = 1; i <= 2; i++) if ($i != "") print $i }' "$name.options" |
        sort | cmp -s - help
    ok $? "$name --options: the options of --help"
    "$make" bash "x-$name" <"$name.options" >"$name.bash" && "$make" zsh "x-$name" \
        <"$name.options" >"_x-$name"
    ok $? "$name: made for both shells"
done
for f in *.bash; do
    bash -n "$f" && shellcheck -s bash "$f" >&2 || echo "$f"
done >bad
[ ! -s bad ]
ok $? 'bash and shellcheck accept all files'
if command -v zsh >/dev/null; then
    for f in _x-*; do zsh -n "$f" || echo "$f"; done >bad
    [ ! -s bad ]
    ok $? 'zsh accepts all files'
else
    skip 'no zsh'
fi

# complete TOOL WORD...: the answers, and what readline is told; words as bash splits them.
cat >drive.bash <<'END'
compopt() { echo "compopt $*"; }
tool=$1
shift
. "./$tool.bash"
COMP_WORDS=("x-$tool" "$@")
COMP_CWORD=$#
f=$(complete -p "x-$tool")
f=${f#*-F }
"${f%% *}" "x-$tool" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]}"
END
# gives NAME ANSWER TOOL WORD...: lines joined by blanks.
gives()
{
    name=$1
    wanted=$2
    shift 2
    got=$(bash drive.bash "$@" | tr '\n' ' ' | sed 's/ *$//')
    [ "$got" = "$wanted" ] || echo "# $got"
    [ "$got" = "$wanted" ]
    ok $? "$name"
}
gives 'the beginning of an option' 'compopt +o default --summary --stiffness --set' catenary --s
gives 'words of an option' 'compopt +o default dense' modal --solver d
gives 'words behind =' 'compopt +o default displacement' gapnet --method = d
gives 'all of them' 'compopt +o default stable marginal unstable' sling --require = ''
gives 'keys, the value to follow' \
    'compopt +o default compopt -o nospace damper.position= damper.direction= damper.coefficient=' \
    diffverf --set damper.
gives 'columns' 'compopt +o default compopt -o nospace z_m=' sling --set z
gives 'a number is not completed' 'compopt +o default' modal --modes ''
gives 'files are left to readline' '' catenary ''
gives 'files of an option, too' '' diffverf --field ''
gives 'directories' 'compopt -o dirnames +o default' modal -d ''
gives 'no options behind --' '' modal -- --s
gives 'an option behind an operand' 'compopt +o default --version' modal case.ini --vers
mkdir play && cp /bin/true play/seilwerk-probe && PATH=$PATH:$scratch/play
gives 'the tool of a study' 'seilwerk-probe' study -d dir --table x.csv seilwerk-pro
gives 'its options are its own' '' study -d dir catenary --s
gives 'before it, those of study' 'compopt +o default --slurm --slurm-option' study -d dir --sl

runs 2 'no shell' "$make" fish modal <modal.options
says "'fish': expected bash or zsh" 'says which'
runs 2 'a name that is code' "$make" bash 'a;b'
says 'expected the name of a command' 'is none'
printf 'operands\tCASE\nwhat is this\n' | "$make" bash modal >out 2>err
[ $? -eq 1 ] && [ ! -s out ] && grep -q '<stdin>:2: no row of --options' err
ok $? 'another table is refused at its line'
finish
