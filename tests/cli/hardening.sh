#!/bin/sh
# The tools as they are built: position independent, nothing writable that need not be, stack
# guarded, libc's checked calls in place.  By readelf alone.
. "$(dirname "$0")/../tap.sh"
[ -z "${SEILWERK_SANITIZED:-}" ] || {
    skip 'not under the sanitizers'
    finish
}
command -v readelf >/dev/null || {
    echo '1..0 # SKIP no readelf (binutils)'
    exit 0
}
cd "$scratch" || exit 1
for source in "$top"/tools/*.c; do
    tool=$(basename "$source" .c)
    readelf -W -h -l -d --dyn-syms "$SEILWERK_BUILD/bin/$tool" >elf
    grep -q 'Type: *DYN' elf && grep -q 'FLAGS_1.*PIE' elf
    ok $? "$tool is position independent"
    grep -q '^ *GNU_RELRO' elf && grep -q 'FLAGS.*NOW' elf
    ok $? "$tool: what the linker fills in is read-only afterwards"
    grep -q '^ *GNU_STACK .* RW ' elf && ! grep -qE '^ *(LOAD|GNU_STACK) .* (RWE|WE) ' elf
    ok $? "$tool: nothing is writable and executable"
    grep -q '__stack_chk_fail' elf
    ok $? "$tool: the stack is guarded"
    grep -qE '__[a-z]+_chk@' elf
    ok $? "$tool: calls of libc are checked"
    ! grep -qE 'R(UN)?PATH|TEXTREL' elf
    ok $? "$tool: no search path, no relocations of its text"
    ! grep -qE ' UND (system|popen|exec[lv][pe]*|posix_spawnp?|v?fork|tmpnam|tempnam|mktemp)@' elf
    ok $? "$tool: starts no other program, guesses no names"
done
finish
