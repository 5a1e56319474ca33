/*
 * The steady responses of many parameter points, eight in the lanes of the vector unit and on
 * several cores.
 *
 * Points that march by central differences under harmonic motions alone go into lanes, all others
 * by themselves; that choice, and so each result, depends on the point only.
 */
#ifndef SEILWERK_FORM_ENSEMBLE_H
#define SEILWERK_FORM_ENSEMBLE_H

#include "form/points.h"
#include "form/response.h"

/* What became of a point. */
struct outcome {
    enum status status; /* else why tells */
    struct why why;
    struct response response;
    struct drive drive;
};

struct ensemble {
    const struct points *points; /* not owned, like the next two */
    const struct model *model;
    const struct modes *modes;
    int threads;
    int first; /* the points before it are done */
    /* Called with the outcomes in the order of the points, one at a time, from any thread; not 0:
     * stop. */
    int (*deliver)(int point, const struct outcome *o);
};

/* Modes that the points need at the most; points that cannot be used are passed over. */
enum status ensemble_modes_wanted(const struct points *p, int *ret, struct why *why);

/* Run all points from e->first on, until they are done, deliver says so or a signal is pending.
 * SW_NOMEM. */
enum status ensemble_run(const struct ensemble *e, struct why *why);

#endif
