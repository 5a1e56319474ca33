/*
 * The result of stabil and the state from which a stopped map goes on.
 */
#ifndef SEILWERK_FORM_MAPFILE_H
#define SEILWERK_FORM_MAPFILE_H

#include "form/cable.h"
#include "sys/out.h"

struct map_file {
    const struct cable_case *c; /* not owned */
    const char *path;           /* NULL or "-": stdout, which has no state */
    const char *columns;        /* options that make the columns */
    int resume;
    struct out out;
    char *state;  /* path of the state, NULL: there is none */
    long next;    /* frequencies done */
    double saved; /* time of the last state */
};

/* Open the result, new or behind what the state says.  SW_USAGE: nothing to go on from; SW_FORMAT:
 * the state is of another case; else as out_open and out_resume. */
enum status map_file_open(struct map_file *f, struct why *why);

/* Save the state once a minute.  SW_WRITE. */
enum status map_file_checkpoint(struct map_file *f, struct why *why);

/* Leave rows and state for a later run.  SW_WRITE. */
enum status map_file_stop(struct map_file *f, struct why *why);

/* The end of a whole map.  SW_WRITE. */
enum status map_file_close(struct map_file *f, struct why *why);

#endif
