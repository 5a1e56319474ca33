/*
 * Steady states and response curves: what drives the cable, how its motion is summed up, and the
 * rows of CSV that tell of it (diffverf(1)).
 */
#ifndef SEILWERK_FORM_RESPONSE_H
#define SEILWERK_FORM_RESPONSE_H

#include "form/launch.h"
#include "phys/steady.h"
#include "sys/out.h"

/* The harmonic excitation of a case. */
struct drive {
    double omega; /* the lowest frequency [rad/s]; without excitation, of the first lateral mode */
    int order;    /* half orders k of what the phase is counted against, 0: nothing moves */
    double phase; /* of that, as it pulls: u = |a| cos(k phi/2 + phase) [rad] */
    double begin; /* when all ramps and disturbances are over [s] */
};

/* The drive of c.  SW_ADMISSIBLE: a record, or frequencies that are no multiples of the lowest one:
 * there is no period then. */
enum status drive_of(const struct cable_case *c, const struct model *m, struct drive *ret,
                     struct why *why);

/* Time between two samples of a period [s]. */
double drive_interval(const struct drive *d);

/* What a steady state was found to be. */
struct response {
    enum steady_kind kind;
    int period;
    int whole; /* whether a block of periods was: else there is no orbit */
    double time, omega, change, slack_time; /* slack_time negative: never */
    struct orbit orbit[MAX_PROBES];
};

/* The response of l, a launched march with marks at 1/STEADY_SAMPLES of the drive's period: marches
 * until a steady state, time.end, or `stop` says so (NULL: never; its argument: share of time.end).
 * As march_solve and march_advance, with the reason; SW_NOMEM. */
enum status response_find(struct launch *l, const struct drive *d, int (*stop)(double),
                          struct response *ret, struct why *why);

/* Options of steady_new for c. */
struct steady_options response_options(const struct cable_case *c, const struct drive *d);

/* How long a steady state is looked for [s]: time.end, or 2000 periods. */
double response_end(const struct cable_case *c, const struct drive *d);

/* *ret from s, which has ended at time t. */
void response_take(const struct steady *s, const struct drive *d, double t, double slack_time,
                   struct response *ret);

/* Columns of a response, and its cells; the columns of n orbits and their cells, each with a comma
 * in front.  No line ends. */
void response_header(int n_probes, struct out *o);
void response_print(const struct response *r, const struct drive *d, int n_probes, struct out *o);
void orbit_header(int n, struct out *o);
void orbit_print(const struct orbit *orbit, int n, int order, double phase, struct out *o);

/* As many empty cells as response_print makes. */
void response_print_none(int n_probes, struct out *o);

#endif
