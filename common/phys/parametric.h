/*
 * The equations of small motions about a harmonic ground motion, on some modes of the cable at
 * rest:
 *
 *     T'' + C T' + [omega^2 + kappa (Psi_c cos Omega t + Psi_s sin Omega t)
 *           + kappa^2 (mean + double_c cos 2 Omega t + double_s sin 2 Omega t)] T = 0
 *
 * (Thalheim 5.3, A.8; theory section 4).  kappa [m] multiplies the ground motion of unit amplitude.
 * The terms with kappa^2 are those quadratic in the ground motion as A.701 has them; they are no
 * complete second order, for the second-order ground motion is not in them.
 */
#ifndef SEILWERK_PHYS_PARAMETRIC_H
#define SEILWERK_PHYS_PARAMETRIC_H

#include "phys/modes.h"

#include <complex.h>

enum theory { THEORY_INDIFFERENCE, THEORY_CLASSICAL };

/* Slopes of the chosen modes at all Gauss points. */
struct projection {
    const struct model *model; /* not owned */
    int s;                     /* modes */
    double *slope;             /* (3, s, GAUSS n); owned */
};

struct parametric {
    int s;
    double *omega, *c;     /* (s): circular frequency [rad/s], C = alpha + beta omega^2 [1/s] */
    double *psi_c, *psi_s; /* (s, s) [1/(s2 m)] */
    int quadratic;         /* whether the next three count */
    double *mean, *double_c, *double_s; /* (s, s) [1/(s2 m2)] */
    double *memory;                     /* of all these; owned */
};

/* mode[i]: numbers of modes of p, from 0.  SW_NOMEM. */
enum status projection_new(const struct model *m, const struct modes *p, const int *mode, int s,
                           struct projection *ret);

void projection_free(struct projection *p);

/* Room for s modes with frequencies of p's chosen ones.  SW_NOMEM. */
enum status parametric_new(const struct modes *p, const int *mode, int s, double alpha, double beta,
                           struct parametric *ret);

void parametric_free(struct parametric *p);

/* The matrices of *ret for the ground motion V of unit amplitude over all nodes (A.802): dK is
 * EA int [(B V) D^T D + D^T (D V) B + B^T (D V)^T D], its first term alone in the classical theory,
 * and with quadratic EA int D^T [w w^T + (w.w/2) I] D, w = D V. */
void parametric_fill(const struct projection *p, enum theory theory, int quadratic,
                     const double complex *V, struct parametric *ret);

/* Number of groups of modes that no matrix of *p couples, and the group of each mode, from 0: for a
 * ground motion in the plane of the line at least the two planes. */
int parametric_groups(const struct parametric *p, int *ret_group);

/* The equations of one group, and which modes of *p they are (s places).  SW_NOMEM. */
enum status parametric_group(const struct parametric *p, const int *group, int which,
                             struct parametric *ret, int *ret_mode);

#endif
