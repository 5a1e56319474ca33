/*
 * Options from a table: parsing (getopt_long), --help, --version, and --options, the table itself
 * for other programs.
 */
#ifndef SEILWERK_SYS_OPT_H
#define SEILWERK_SYS_OPT_H

#include "sys/err.h"

#include <stdio.h>

enum opt_kind {
    OPT_FLAG,    /* to: int, set to 1 */
    OPT_TEXT,    /* to: const char *, points into argv */
    OPT_INTEGER, /* to: long in [min, max] */
    OPT_LIST     /* to: struct opt_list, each use appends */
};

struct opt_list {
    const char **item;
    int n;
};

struct opt {
    const char *name; /* long name, or NULL */
    char letter;      /* or 0 */
    enum opt_kind kind;
    void *to;
    const char *arg;  /* name of the argument, or NULL; FILE, DIR and choices a|b|c tell a shell */
    const char *help; /* one line */
    long min, max;    /* OPT_INTEGER */
};

/* The options that all tools share. */
struct opt_common {
    const char *out; /* -o FILE, or NULL */
    const char *dir; /* -d DIR, or NULL */
    struct opt_list sets;
    int print_case, quiet, verbose;
};

#define OPT_OUT(c)                                                                                 \
    {                                                                                              \
        NULL, 'o', OPT_TEXT, &(c)->out, "FILE", "write the result there, not on stdout", 0, 0      \
    }
#define OPT_COMMON(c)                                                                              \
    {"set",                                                                                        \
     0,                                                                                            \
     OPT_LIST,                                                                                     \
     &(c)->sets,                                                                                   \
     "SECTION.KEY=VALUE",                                                                          \
     "set or add a key of the case; an empty value removes it",                                    \
     0,                                                                                            \
     0},                                                                                           \
        {"print-case",                                                                             \
         0,                                                                                        \
         OPT_FLAG,                                                                                 \
         &(c)->print_case,                                                                         \
         NULL,                                                                                     \
         "print the resolved case, every default written out, and stop",                           \
         0,                                                                                        \
         0},                                                                                       \
        {"quiet", 'q', OPT_FLAG, &(c)->quiet, NULL, "no warnings", 0, 0},                          \
        {"verbose", 'v', OPT_FLAG, &(c)->verbose, NULL, "say what is done", 0, 0},                 \
    {                                                                                              \
        NULL, 0, OPT_FLAG, NULL, NULL, NULL, 0, 0                                                  \
    }

struct opt_tool {
    const char *name;
    const char *usage;           /* operands, e.g. "CASE" */
    const char *purpose;         /* one sentence */
    const struct opt *options;   /* ends with an entry without name and letter */
    void (*print_keys)(FILE *f); /* what --set can set, blanks between, or NULL */
};

/*
 * Parse; options may follow operands.  --help, --version and --options print on stdout and exit 0;
 * wrong usage prints what is wrong and exits 2.  The operands stand at argv[returned index] and
 * after; argv is permuted.
 */
int opt_parse(const struct opt_tool *tool, int argc, char **argv);

/* Print the one-line usage on stderr and exit 2. */
__attribute__((noreturn)) void opt_usage(const struct opt_tool *tool);

void opt_list_free(struct opt_list *l);

#endif
