/*
 * Messages and the end of a tool.
 *
 * Readers return a status and explain a user's mistake in a struct why; only a tool's main ends the
 * process, through die.  All messages go to stderr as "tool: text".  This file also takes over
 * LAPACKE_xerbla and xerbla_, which else print on stdout: a wrong call of LAPACK is our bug and
 * aborts.
 */
#ifndef SEILWERK_SYS_ERR_H
#define SEILWERK_SYS_ERR_H

#include "num/status.h"

/* What went wrong, for the user: "file:line: what is wrong and what is expected". */
struct why {
    char text[1024];
};

/* Write the text (cut to fit) and return s. */
__attribute__((format(printf, 3, 4))) enum status fail(struct why *w, enum status s,
                                                       const char *format, ...);

/* fail with the text of s itself: for failures that say all by their name.  It stands here so that
 * whoever reads a caller, an analyzer too, knows that s comes back. */
static inline enum status fail_plain(struct why *w, enum status s)
{
    fail(w, s, "%s", status_text(s));
    return s;
}

/* The tool's name in messages; quiet silences warn, verbose lets note speak. */
void err_tool(const char *name);
void err_level(int quiet, int verbose);
int err_verbose(void);
int err_quiet(void);

__attribute__((format(printf, 1, 2))) void warn(const char *format, ...);
__attribute__((format(printf, 1, 2))) void note(const char *format, ...);

/* Print w's text, also with quiet: an error that does not end the tool. */
void report(const struct why *w);

/* Print the message and exit with the status of s. */
__attribute__((format(printf, 2, 3), noreturn)) void die(enum status s, const char *format, ...);

/* die with w's text unless s is SW_OK. */
void must(enum status s, const struct why *w);

#endif
