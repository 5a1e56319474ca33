/* Any words as a command line: refused with status 2, answered with status 0, or options within
 * their ranges and operands that were on the line.  The Makefile lets exit come back here. */
#include "fuzz.h"
#include "sys/opt.h"

#include <getopt.h>
#include <setjmp.h>
#include <string.h>
#include <unistd.h>

enum { WORDS = 64 };

static jmp_buf back;
static int status;

_Noreturn void __wrap_exit(int s);
_Noreturn void __real_exit(int s);
static int inside;

/* From opt_parse exit comes back; from elsewhere it ends the process. */
_Noreturn void __wrap_exit(int s)
{
    if (!inside)
        __real_exit(s);
    status = s;
    longjmp(back, 1);
}

static int is_word(char *const *argv, int argc, const char *text)
{
    for (int i = 1; i < argc; i++)
        if (text >= argv[i] && text <= argv[i] + strlen(argv[i]))
            return 1;
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct opt_common common;
    static long count;
    static const char *word;
    static int flag;
    static const struct opt options[] = {
        OPT_OUT(&common),
        {"count", 'n', OPT_INTEGER, &count, "N", "a number", 1, 1000},
        {"word", 0, OPT_TEXT, &word, "TEXT", "a word", 0, 0},
        {"flag", 'f', OPT_FLAG, &flag, NULL, "a flag", 0, 0},
        OPT_COMMON(&common),
    };
    static const struct opt_tool tool = {"fuzz", "FILE", "Fuzz.", options, NULL};
    char line[4096], *argv[WORDS + 2] = {line};
    volatile int argc = 1;
    int first;

    if (size > sizeof line - 6)
        size = sizeof line - 6;
    memcpy(line, "fuzz\0", 5);
    memcpy(line + 5, data, size); /* words between zero bytes */
    line[5 + size] = '\0';
    for (char *at = line + 5; at < line + 5 + size && argc <= WORDS; at += strlen(at) + 1)
        argv[argc++] = at;
    argv[argc] = NULL;
    common = (struct opt_common){.out = NULL};
    count = 1;
    word = NULL;
    flag = 0;
    optind = 0; /* glibc begins anew */
    inside = 1;
    if (setjmp(back) != 0) {
        inside = 0;
        check(status == 0 || status == 2);
        free(common.sets.item);
        return 0;
    }
    first = opt_parse(&tool, argc, argv);
    inside = 0;
    check(first >= 1 && first <= argc);
    check(count >= 1 && count <= 1000 && (flag == 0 || flag == 1));
    check(!common.out || is_word(argv, argc, common.out));
    check(!word || is_word(argv, argc, word));
    for (int i = 0; i < common.sets.n; i++)
        check(is_word(argv, argc, common.sets.item[i]));
    free(common.sets.item);
    return 0;
}
