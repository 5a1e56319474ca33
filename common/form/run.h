/*
 * The files of a run of diffverf: rows, fields, and the state from which a stopped run goes on.
 */
#ifndef SEILWERK_FORM_RUN_H
#define SEILWERK_FORM_RUN_H

#include "form/state.h"
#include "sys/out.h"

/* What a run is made of, and where its files are; nothing of it is owned but the state's path. */
struct run {
    const struct cable_case *c;
    struct march *march;
    struct energy *energy;
    const char *rows_path;   /* NULL or "-": stdout */
    const char *field_path;  /* NULL: no fields */
    const char *state_given; /* NULL: beside the rows, and removed at the end */
    const char *columns;     /* options that make the columns of the rows: part of the state */
    int resume;
    long checkpoint; /* seconds of wall time between two states */
    struct out rows, field;
    char *state; /* path of the state, NULL: there is none */
    struct progress_mark mark;
    double saved; /* time of the last state, 0: none yet */
};

/* Find the state's path; with resume put its state into march and energy.  SW_USAGE: no state where
 * one is needed; else as state_resume. */
enum status run_prepare(struct run *r, struct why *why);

/* Open rows and fields, new or behind what the state says; fields columns of nodes are planned for
 * the whole run.  SW_USAGE: rows go elsewhere than in the run that was stopped; else as out_open
 * and out_resume. */
enum status run_open(struct run *r, size_t fields, struct why *why);

/* Write the displacements of all nodes as the next field. */
void run_field(struct run *r);

/* Whether writing has failed. */
int run_failed(struct run *r);

/* Save the state as it is before the next step, if it is time for it.  As state_write. */
enum status run_checkpoint(struct run *r, struct why *why);

/* The end of a run that a signal stopped: the state, if there is one, and the rows until then.
 * SW_WRITE. */
enum status run_stop(struct run *r, struct why *why);

/* The end of a whole run.  SW_WRITE. */
enum status run_close(struct run *r, struct why *why);

#endif
