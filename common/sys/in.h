/*
 * Input files: opened once, remembered, so that no tool writes a file that it has read.
 */
#ifndef SEILWERK_SYS_IN_H
#define SEILWERK_SYS_IN_H

#include "sys/err.h"

#include <stdio.h>
#include <sys/stat.h>

struct in {
    FILE *f;
    const char *name; /* for messages: the path, or "<stdin>" */
    int noted;        /* whether it is among the files remembered since this opening */
};

/* Open path for reading; "-" is stdin.  SW_READ: missing, a directory, no permission;
 * SW_NOMEM. */
enum status in_open(const char *path, struct in *ret, struct why *why);

void in_close(struct in *in);

/* Close what was opened last: a file that this run may replace, as a state by a later one. */
void in_close_replaceable(struct in *in);

/* Whether the file of *st was opened by in_open in this run. */
int in_was_read(const struct stat *st);

#endif
