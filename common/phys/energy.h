/*
 * The energy balance of a march: kinetic + strain = start + works of supports, loads and
 * disturbances - dissipated.
 *
 * Counted from the static line: the static parts of the support forces and the weight, whose works
 * cancel, are left out.  Works are integrated by the trapezoidal rule over each step, so that the
 * balance closes with the square of the step.  Terms 0, 2, 3 only: F1 alone has no potential.
 */
#ifndef SEILWERK_PHYS_ENERGY_H
#define SEILWERK_PHYS_ENERGY_H

#include "phys/march.h"

struct energy {
    double kinetic, strain;                           /* at the last step [J] */
    double supports, loads, disturbances, dissipated; /* since the start [J] */
    double start;                                     /* kinetic + strain of the first step [J] */
    double time;                                      /* of the last step [s] */
    double power[3];                                  /* of supports, loads, dissipation [W] */
    int started;
};

/* Take the present step of m in, after march_solve; once a step, from the first on.  work: a vector
 * over all nodes. */
void energy_step(struct energy *e, struct march *m, double *work);

/* Kinetic and strain energy of the present state, also before march_solve, by the velocity of the
 * last step; the difference after and before a kick is the work of a disturbance. */
double energy_now(struct march *m);

/* kinetic + strain - start - supports - loads - disturbances + dissipated [J]. */
double energy_error(const struct energy *e);

#endif
