/*
 * A result of many independent rows, and the state from which a stopped run goes on: maps of
 * stabil, ensembles of diffverf.
 */
#ifndef SEILWERK_FORM_ROWSFILE_H
#define SEILWERK_FORM_ROWSFILE_H

#include "form/cable.h"
#include "sys/out.h"

enum rows_kind { ROWS_MAP = 2, ROWS_ENSEMBLE = 3 }; /* the version of the state; marches have 1 */

struct rows_file {
    enum rows_kind kind;
    const struct cable_case *c; /* not owned */
    const char *path;           /* NULL or "-": stdout, which has no state */
    const char *columns;        /* options that make the columns, other input */
    int resume;
    long checkpoint; /* seconds between two states */
    struct out out;
    char *state;  /* path of the state, NULL: there is none */
    long next;    /* frequencies or points done */
    int failed;   /* whether one of them had no result; kept in the state */
    double saved; /* time of the last state */
};

/* Open the result, new or behind what the state says.  SW_USAGE: nothing to go on from; SW_FORMAT:
 * the state is of another case; else as out_open and out_resume. */
enum status rows_file_open(struct rows_file *f, struct why *why);

/* Save the state if it is time for it.  SW_WRITE. */
enum status rows_file_checkpoint(struct rows_file *f, struct why *why);

/* Leave rows and state for a later run.  SW_WRITE. */
enum status rows_file_stop(struct rows_file *f, struct why *why);

/* The end of a whole run.  SW_WRITE. */
enum status rows_file_close(struct rows_file *f, struct why *why);

#endif
