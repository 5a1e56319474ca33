/* Messages and the end of a tool. */
#include "sys/err.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *tool = "seilwerk";
static int is_quiet, is_verbose;

enum status fail(struct why *w, enum status s, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    // cppcheck-suppress ctuuninitvar  // it is filled here
    vsnprintf(w->text, sizeof w->text, format, args);
    va_end(args);
    return s;
}

void err_tool(const char *name)
{
    const char *slash = strrchr(name, '/');

    tool = slash ? slash + 1 : name;
}

void err_level(int quiet, int verbose)
{
    is_quiet = quiet;
    is_verbose = verbose;
}

int err_verbose(void)
{
    return is_verbose;
}

int err_quiet(void)
{
    return is_quiet;
}

static void say(const char *format, va_list args)
{
    fprintf(stderr, "%s: ", tool);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
}

void warn(const char *format, ...)
{
    va_list args;

    va_start(args, format);
    if (!is_quiet)
        say(format, args);
    va_end(args);
}

void note(const char *format, ...)
{
    va_list args;

    va_start(args, format);
    if (is_verbose)
        say(format, args);
    va_end(args);
}

/* say for a text without arguments. */
static void say_text(const char *format, ...)
{
    va_list args;

    va_start(args, format);
    say(format, args);
    va_end(args);
}

void report(const struct why *w)
{
    say_text("%s", w->text);
}

void die(enum status s, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    say(format, args);
    va_end(args);
    exit(status_exit(s));
}

void must(enum status s, const struct why *w)
{
    if (s != SW_OK)
        die(s, "%s", w->text);
}

/* LAPACK's error exits: with our arguments they cannot happen but by a bug. */
void LAPACKE_xerbla(const char *name, int32_t info);
void LAPACKE_xerbla(const char *name, int32_t info)
{
    if (info > -1000) { /* -1010, -1011: memory; reported by the caller */
        fprintf(stderr, "%s: bug: argument %d of %s is wrong\n", tool, (int)-info, name);
        abort();
    }
}

void xerbla_(const char *name, const int32_t *info, int length);
void xerbla_(const char *name, const int32_t *info, int length)
{
    fprintf(stderr, "%s: bug: argument %d of %.*s is wrong\n", tool, (int)*info, length, name);
    abort();
}
