/*
 * Implicit time integration by the generalized-alpha method (Chung and Hulbert), with full Newton
 * steps on the band tangent: the other scheme of a march (phys/march.h).
 *
 *     M A(n+1-am) + C W(n+1-af) + F_int(V(n+1-af)) = R(t(n+1-af))
 *     X(n+1-a) = (1 - a) X(n+1) + a X(n)
 *     V(n+1) = V + dt W + dt^2 [(1/2 - b) A + b A(n+1)]
 *     W(n+1) = W + dt [(1 - g) A + g A(n+1)]
 *     am = (2 r - 1)/(r + 1), af = r/(r + 1), g = 1/2 - am + af, b = (1 - am + af)^2/4
 *
 * Second order, stable for any step, and r = 0..1 is what is left of the highest frequencies after
 * a step: axial waves need no resolution.  With a tolerance the step follows the error of each
 * step, |b - 1/6| dt^2 max |A(n+1) - A|, which it keeps below tolerance times the largest
 * displacement so far; steps are the interval of the march over 1, 2, 3, 4, 6, 8, 12, ...
 */
#ifndef SEILWERK_PHYS_ALPHA_H
#define SEILWERK_PHYS_ALPHA_H

#include "num/band.h"
#include "num/status.h"

struct march;

#define ALPHA_FINEST 3145728 /* steps of an interval at the most: 3 2^20 */

struct alpha {
    double am, af, g, b;  /* of the method */
    double *W, *A;        /* velocity and acceleration over all nodes; owned */
    double *V1, *W1, *A1; /* at the end of the step; owned */
    double *Vm, *Wm, *Am; /* in between; owned */
    double *R;            /* residual, correction; owned */
    struct band M, C;     /* over all nodes; C with the dampers */
    struct band S;        /* constant part of the tangent, for steps of S_dt */
    struct band J;        /* the tangent, factored */
    double S_dt;
    long row, tick, ticks; /* t = interval (row + tick/ticks) */
    long stride;           /* ticks of the next step */
    long even;             /* steps of this length so far */
    double worst;          /* error among them, over what is allowed */
    double scale;          /* largest displacement so far [m] */
    double past;           /* time before the last step [s]; negative: there was none */
    int settled;           /* A belongs to V and W */
    long iterations;       /* Newton steps so far */
    long rejected;         /* steps thrown away so far */
};

/* Matrices and vectors of m, a march whose options and dampers are set.  SW_NOMEM. */
enum status alpha_new(struct march *m);

void alpha_free(struct alpha *p);

/* One step on, or several shorter ones that do for it.  SW_NOCONV: Newton's method fails with the
 * fixed, or the finest, step; SW_DIVERGED: numbers are no longer finite; SW_NOMEM. */
enum status alpha_advance(struct march *m);

/* A from M A = R - F - C W at the present time, if a start or a disturbance has made it stale.
 * SW_INDEFINITE: the mass matrix is no longer finite. */
enum status alpha_settle(struct march *m);

/* ret = M X + C W + F in the rows of the supports, F the internal forces less those from outside, X
 * the acceleration of the present time: A belongs to (af - am) dt earlier. */
void alpha_support(const struct march *m, double ret[6]);

#endif
