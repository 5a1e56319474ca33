/* Options from a table, on getopt_long. */
#include "sys/opt.h"
#include "num/mem.h"
#include "sys/number.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_OPTIONS 48
#define CODE_HELP 1000
#define CODE_VERSION 1001
#define CODE_OPTIONS 1002
#define CODE_FIRST 1100 /* + index, for options without a letter */

/* What every tool has; codes stand in for a place to put them. */
static const struct opt own[] = {
    {"help", 'h', OPT_FLAG, NULL, NULL, "print this and stop", 0, 0},
    {"version", 0, OPT_FLAG, NULL, NULL, "print the version and stop", 0, 0},
    {"options", 0, OPT_FLAG, NULL, NULL, "print the options as a table for programs and stop", 0,
     0},
    {NULL, 0, OPT_FLAG, NULL, NULL, NULL, 0, 0},
};

static int is_end(const struct opt *o)
{
    return !o->name && !o->letter;
}

static int code_of(const struct opt_tool *tool, const struct opt *o)
{
    return o->letter ? o->letter : CODE_FIRST + (int)(o - tool->options);
}

static void print_option(char letter, const char *name, const char *arg, const char *help)
{
    char left[80];

    snprintf(left, sizeof left, "%c%c%s%s%s%s%s", letter ? '-' : ' ', letter ? letter : ' ',
             letter && name ? ", " : "  ", name ? "--" : "", name ? name : "", arg ? " " : "",
             arg ? arg : "");
    if (strlen(left) > 26)
        printf("  %s\n  %-26s  %s\n", left, "", help);
    else
        printf("  %-26s  %s\n", left, help);
}

static void print_help(const struct opt_tool *tool)
{
    printf("usage: %s [options] %s\n%s\n\n", tool->name, tool->usage, tool->purpose);
    for (const struct opt *o = tool->options; !is_end(o); o++)
        print_option(o->letter, o->name, o->arg, o->help);
    for (const struct opt *o = own; !is_end(o); o++)
        print_option(o->letter, o->name, o->arg, o->help);
    printf("\nThe manual page %s(1) has examples; seilwerk(7) is the tour.\n", tool->name);
}

/* A row of --options: letter, name, argument, help and what the argument may begin with, tabs
 * between. */
static void print_row(const struct opt_tool *tool, const struct opt *o)
{
    const char letter[] = {'-', o->letter, '\0'};

    printf("%s\t%s%s\t%s\t%s\t", o->letter ? letter : "", o->name ? "--" : "",
           o->name ? o->name : "", o->arg ? o->arg : "", o->help);
    if (o->name && strcmp(o->name, "set") == 0 && tool->print_keys)
        tool->print_keys(stdout);
    else if (o->arg && strchr(o->arg, '|'))
        for (const char *p = o->arg; *p; p++)
            putchar(*p == '|' ? ' ' : *p);
    putchar('\n');
}

static void print_table(const struct opt_tool *tool)
{
    printf("operands\t%s\n", tool->usage);
    for (const struct opt *o = tool->options; !is_end(o); o++)
        print_row(tool, o);
    for (const struct opt *o = own; !is_end(o); o++)
        print_row(tool, o);
}

/* Results on stdout end in an exit status of their own. */
__attribute__((noreturn)) static void end_printing(void)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        die(SW_WRITE, "<stdout>: cannot be written");
    exit(0);
}

void opt_usage(const struct opt_tool *tool)
{
    die(SW_USAGE, "usage: %s [options] %s (%s --help tells more)", tool->name, tool->usage,
        tool->name);
}

static void take(const struct opt *o, const char *shown, char *value)
{
    const char *reason = NULL;
    struct opt_list *list = o->to;
    const char **grown;

    switch (o->kind) {
    case OPT_FLAG: *(int *)o->to = 1; break;
    case OPT_TEXT: *(const char **)o->to = value; break;
    case OPT_INTEGER: reason = integer_read(value, o->min, o->max, o->to); break;
    case OPT_LIST:
        grown = mem_resize(list->item, (size_t)list->n + 1, sizeof *grown);
        if (!grown)
            die(SW_NOMEM, "%s", status_text(SW_NOMEM));
        list->item = grown;
        list->item[list->n++] = value;
    }
    if (reason)
        die(SW_USAGE, "option %s: '%s': %s (expected %ld to %ld)", shown, value, reason, o->min,
            o->max);
}

/* getopt's tables from ours. */
static void tables(const struct opt_tool *tool, char *letters, struct option *names)
{
    *letters++ = ':';
    *letters++ = 'h';
    *names++ = (struct option){"help", no_argument, NULL, CODE_HELP};
    *names++ = (struct option){"version", no_argument, NULL, CODE_VERSION};
    *names++ = (struct option){"options", no_argument, NULL, CODE_OPTIONS};
    for (const struct opt *o = tool->options; !is_end(o); o++) {
        if (o->letter) {
            *letters++ = o->letter;
            if (o->arg)
                *letters++ = ':';
        }
        if (o->name)
            *names++ = (struct option){o->name, o->arg ? required_argument : no_argument, NULL,
                                       code_of(tool, o)};
    }
    *letters = '\0';
    *names = (struct option){0};
}

/* What getopt did not take: optopt is the letter, or the code of a long option with a wrong '='. */
__attribute__((noreturn)) static void refuse(const struct opt_tool *tool, const char *shown)
{
    const char letter[] = {'-', (char)optopt, '\0'};

    if (strncmp(shown, "--", 2) != 0 && optopt > 0)
        die(SW_USAGE, "option %s is not known (%s --help)", letter, tool->name);
    if (optopt > 0)
        die(SW_USAGE, "option %.*s takes no argument", (int)strcspn(shown, "="), shown);
    die(SW_USAGE, "option %s is not known or not unique (%s --help)", shown, tool->name);
}

int opt_parse(const struct opt_tool *tool, int argc, char **argv)
{
    struct option names[MAX_OPTIONS + 4];
    char letters[2 * MAX_OPTIONS + 3];
    int code;

    tables(tool, letters, names);
    opterr = 0;
    while ((code = getopt_long(argc, argv, letters, names, NULL)) != -1) {
        const char *shown = argv[optind - 1];

        if (code == 'h' || code == CODE_HELP) {
            print_help(tool);
            end_printing();
        }
        if (code == CODE_VERSION) {
            printf("%s (Seilwerk) %s\n", tool->name, SEILWERK_VERSION);
            end_printing();
        }
        if (code == CODE_OPTIONS) {
            print_table(tool);
            end_printing();
        }
        if (code == ':')
            die(SW_USAGE, "option %s: an argument is missing", shown);
        if (code == '?')
            refuse(tool, shown);
        for (const struct opt *o = tool->options; !is_end(o); o++)
            if (code == code_of(tool, o)) {
                char name[32];

                if (o->name)
                    snprintf(name, sizeof name, "--%s", o->name);
                else
                    snprintf(name, sizeof name, "-%c", o->letter);
                take(o, name, optarg);
            }
    }
    return optind;
}

void opt_list_free(struct opt_list *l)
{
    free(l->item);
    *l = (struct opt_list){0};
}
