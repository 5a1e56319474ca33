/*
 * Output files that appear whole or not at all, signals, progress.
 *
 * A regular file is written as FILE.part, synced and renamed when complete; links are followed.  A
 * FILE that exists and is no regular file is written as it is.  A tool that fails, or is stopped by
 * a signal, leaves no FILE.part behind.
 */
#ifndef SEILWERK_SYS_OUT_H
#define SEILWERK_SYS_OUT_H

#include "sys/err.h"

#include <limits.h>
#include <stdio.h>

struct out {
    FILE *f;             /* to print on; NULL: closed */
    const char *name;    /* for messages; owned by the caller, or "<stdout>" */
    char path[PATH_MAX]; /* final path, empty for what is written as it is */
    int slot;            /* in the list of unfinished files, -1: none */
    int error;           /* errno of the first failure seen, 0: none */
};

/* First act of a tool: standard streams that are closed stay unused, a closed pipe ends the tool
 * quietly, a file size limit is an error of writing, and unfinished files vanish on signals. */
void out_prepare(void);

/* path NULL or "-": stdout.  SW_USAGE: the file was read in this run; SW_WRITE else. */
enum status out_open(struct out *o, const char *path, struct why *why);

/* Continue FILE.part, or what FILE itself holds already, behind its first bytes.  SW_READ: it is
 * missing or shorter; else as out_open. */
enum status out_resume(struct out *o, const char *path, long bytes, struct why *why);

/* Bytes written so far, all of them with the system; -1: not to be told of what is no file. */
long out_bytes(struct out *o);

/* Flush, sync, close, and leave the unfinished file for out_resume.  SW_WRITE. */
enum status out_keep(struct out *o, struct why *why);

/* x in its shortest form (sys/number.h). */
void out_number(struct out *o, double x);

/* n numbers with commas between them and a line end. */
void out_row(struct out *o, const double *x, int n);

/* One cell of CSV: quoted where it holds a comma, a quote or a line end. */
void out_cell(struct out *o, const char *text);

/* Whether writing has failed so far: for long runs. */
int out_failed(struct out *o);

/* Flush, sync, check, rename.  On failure the unfinished file is removed.  SW_WRITE. */
enum status out_close(struct out *o, struct why *why);

/* The two halves of out_close, for files that belong together: written and synced, but not yet
 * renamed; renamed. */
enum status out_finish(struct out *o, struct why *why);
enum status out_rename(struct out *o, struct why *why);

/* From now on SIGINT and SIGTERM only set a mark, however often; the tool asks for it between rows
 * and ends by the signal: complete rows are flushed, an unfinished file is removed. */
void signals_defer(void);
int signals_pending(void);
__attribute__((noreturn)) void signals_end(struct out *o); /* o may have been closed */

/* Done so far, 0..1, on a terminal at stderr or with -v, not with -q; at most ten times a second.
 */
void progress(double done, const char *what);
void progress_end(void);

#endif
