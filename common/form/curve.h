/*
 * Response curves: the orbits of the probes over windows of a slow sweep, and the seed that keeps
 * the first lateral mode alive.
 *
 * A continuous sweep is cut into windows of [sweep] window periods, each of them a row; of a sweep
 * in steps the last window of each step is one.
 */
#ifndef SEILWERK_FORM_CURVE_H
#define SEILWERK_FORM_CURVE_H

#include "form/response.h"

struct curve {
    const struct cable_case *c; /* not owned */
    const struct model *model;  /* not owned */
    double *shape;              /* first lateral mode, largest nodal displacement 1 m; owned */
    double *weight;             /* of V in its amplitude; owned */
    double *more;               /* (n_more) all that changes, for the state; owned */
    size_t n_more;
    struct drive drive; /* what phases are counted against */
};

/* SW_ADMISSIBLE: as modes_lowest, no lateral mode to seed, or nothing is harmonic; SW_NOMEM. */
enum status curve_new(const struct cable_case *c, const struct model *m, struct curve *ret,
                      struct why *why);

void curve_free(struct curve *p);

/* The march is at a mark: rows that it completes go to o; it is seeded if it is time for it.
 * Returns the number of rows. */
int curve_mark(struct curve *p, struct march *m, struct out *o);

/* The last row, if its window is nearly whole; the number of rows. */
int curve_end(struct curve *p, struct out *o);

void curve_header(const struct curve *p, struct out *o);

#endif
