/*
 * Floquet multipliers of the projected equations over one period T = 2 pi/Omega.
 *
 * The monodromy matrix is composed of exact flows of the damped modes and kicks by the parametric
 * terms, fourth order (Suzuki); steps are halved until the matrix stands still, and
 * extrapolated to none.
 */
#ifndef SEILWERK_PHYS_FLOQUET_H
#define SEILWERK_PHYS_FLOQUET_H

#include "phys/parametric.h"

enum crossing { CROSSING_T, CROSSING_2T, CROSSING_COMBINATION };

struct floquet {
    double modulus;         /* of the largest multiplier */
    double growth;          /* log(modulus)/T [1/s] */
    double re, im;          /* that multiplier, im >= 0 */
    enum crossing crossing; /* by its place: near the positive or negative real axis, or off it */
    int mode, partner;      /* that move most in its vector; partner -1: alone */
    int steps;              /* a period */
};

/* kappa [m]; tolerance: of the monodromy matrix, relative; ret->steps before the call: those to
 * begin with, e.g. of a neighbour, or 0.  SW_NOCONV: not reached with 2^16 steps; SW_NOMEM. */
enum status floquet_solve(const struct parametric *p, double Omega, double kappa, double tolerance,
                          struct floquet *ret);

/* All multipliers by the given number of steps: re, im (2 s) and vectors x (2 s, 2 s) or NULL, as
 * of dense_general: displacements, then velocities. */
enum status floquet_multipliers(const struct parametric *p, double Omega, double kappa, int steps,
                                double *re, double *im, double *x);

#endif
