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

# The same typed into the shells themselves, each at a terminal of its own.  A key inserts all that
# completes the line, and takes it down: one line of answers for each line typed.
cat >begin.bash <<'END'
PS1='' HISTFILE=''
for f in *.bash; do [ "$f" = begin.bash ] || [ "$f" = drive.bash ] || . "./$f"; done
answer() { printf '%s\n' "$READLINE_LINE" >>answers; READLINE_LINE='' READLINE_POINT=0; }
bind '"\C-xc": insert-completions'
bind -x '"\C-xa": answer'
bind '"\C-t": "\C-xc\C-xa"'
echo ready >>answers
END
cat >begin.zsh <<'END'
PROMPT=
fpath=("$PWD" $fpath)
autoload -Uz compinit
compinit -u -D
every() { compstate[insert]=all; }
answer()
{
    comppostfuncs=(every)
    zle complete-word
    print -r -- "$BUFFER" >>answers
    BUFFER=
}
zle -N answer
bindkey '^T' answer
echo ready >>answers
END
cat >typed <<'END'
x-catenary --o|--options
x-catenary --s|--set --stiffness --summary
x-modal --solver d|dense
x-modal --solver=d|--solver=dense
x-diffverf --set damper.|damper.coefficient= damper.direction= damper.position
x-sling --require |marginal stable unstable
x-modal --modes |
x-catenary my|my\ case.ini
x-diffverf --field my|my\ case.ini
x-modal -d |play
x-modal -- --s|--s
x-modal case.ini --vers|--version
x-study -d dir --table x.csv seilwerk-pro|seilwerk-probe
x-study -d dir --sl|--slurm --slurm-option
END
touch 'my case.ini'
# answered N: at most five seconds are waited for N answers.
answered()
{
    for _ in $(seq 250); do
        [ "$(wc -l <answers)" -lt "$1" ] || return 0
        sleep 0.02
    done
    return 1
}
# type_into SHELL COMMAND: its answer to each line, without the mark that may follow it.
type_into()
{
    : >answers
    {
        echo ". ./begin.$1"
        answered 1 && n=1 && while IFS='|' read -r line _; do
            printf '%s\024' "$line"
            n=$((n + 1))
            answered $n || break
        done <typed
        echo exit
    } | TERM=vt100 INPUTRC=/dev/null timeout 60 script -qc "$2" /dev/null >screen
    sed 's/[ =/]*$//' answers >given
    n=1
    while IFS='|' read -r line wanted; do
        n=$((n + 1))
        wanted=$(printf '%s\n' "${line% *} $wanted" | sed 's/[ =/]*$//')
        got=$(sed -n ${n}p given)
        [ "$got" = "$wanted" ] || printf '# %s\n' "$got"
        [ "$got" = "$wanted" ]
        ok $? "typed into $1: $line"
    done <typed
}
if ! command -v script >/dev/null; then
    skip 'no script, which gives a shell a terminal'
else
    type_into bash 'bash --norc --noprofile -i'
    if command -v zsh >/dev/null; then type_into zsh 'zsh -f -i'; else skip 'no zsh'; fi
fi

runs 2 'no shell' "$make" fish modal <modal.options
says "'fish': expected bash or zsh" 'says which'
runs 2 'a name that is code' "$make" bash 'a;b'
says 'expected the name of a command' 'is none'
printf 'operands\tCASE\nwhat is this\n' | "$make" bash modal >out 2>err
[ $? -eq 1 ] && [ ! -s out ] && grep -q '<stdin>:2: no row of --options' err
ok $? 'another table is refused at its line'
finish
