/*
 * From a case to a march that is ready to go: model, modes, time grid, start, disturbances.
 */
#ifndef SEILWERK_FORM_LAUNCH_H
#define SEILWERK_FORM_LAUNCH_H

#include "form/cable.h"
#include "phys/modes.h"

struct launch {
    const struct cable_case *c; /* not owned, like the next two */
    const struct model *model;  /* of c */
    const struct modes *modes;  /* as many as launch_modes_wanted */
    double interval;            /* between two marks of the march [s] */
    struct march march;
    double *shape, *speed; /* work space over all nodes; owned */
};

/* How many modes the start, the disturbances and the sweep of c need; 0: none.  A sweep needs the
 * first lateral one, which is among so many. */
int launch_modes_wanted(const struct cable_case *c);

/* So many modes of the model of c: of the model directory dir, or computed if that is NULL.
 * SW_USAGE: it holds less; SW_ADMISSIBLE, as modeldir_read, as modes_lowest. */
enum status launch_modes(const struct cable_case *c, const char *dir, struct model *m, int wanted,
                         struct modes *ret, struct why *why);

/* A march of c with marks every `interval` seconds; the step divides it.  SW_DIVERGED: time.step is
 * longer than the critical one; SW_USAGE: more steps than can be counted up to `end`, or a mode
 * that this mesh cannot scale; SW_NOMEM. */
enum status launch_new(const struct cable_case *c, const struct model *m, const struct modes *modes,
                       double interval, double end, struct launch *ret, struct why *why);

void launch_free(struct launch *l);

/* To t = 0 by [time] start; path: of the case.  SW_USAGE: no such state; SW_ADMISSIBLE: no static
 * line there; as forcing_equilibrium, as state_start, SW_NOMEM. */
enum status launch_start(struct launch *l, const char *path, struct why *why);

/* Whether a disturbance is due at the present time: at the first step at or after its own. */
int launch_disturbance_due(const struct launch *l, const struct disturbance *d);

/* Let it act. */
void launch_disturb(struct launch *l, const struct disturbance *d);

/* What went wrong when the march returned s: SW_DIVERGED, SW_NOCONV, ...; returns s. */
enum status launch_fail(const struct launch *l, enum status s, struct why *why);

#endif
