/*
 * Boundaries of parametric resonance by Bolotin's method: solutions of period T = 2 pi/Omega and 2
 * T as Fourier sums (Thalheim 5.3.3.1, A.9; theory section 4, c4).
 *
 *     T(t) = b0 + sum_j [a_j sin(j Omega t/2) + b_j cos(j Omega t/2)],   j odd (2 T) or even (T)
 *
 * leads to (X + kappa Z + kappa^2 Y) y = 0: each real positive kappa is a point of a boundary.
 */
#ifndef SEILWERK_PHYS_BOLOTIN_H
#define SEILWERK_PHYS_BOLOTIN_H

#include "phys/parametric.h"

struct boundary {
    double kappa;  /* [m] */
    int mode;      /* of the system, from 0, that has the largest share in y */
    int partner;   /* a second one with more than a tenth of it, or -1 */
    int order;     /* harmonic j of the largest share of that mode */
    double share;  /* of the first mode, 0 to 1 */
    double change; /* of kappa, relative, against two harmonics less; NAN: not asked for, or none */
};

/*
 * The boundaries of one period (1: T, 2: 2 T) at Omega with kappa up to most, ascending, by
 * harmonics up to the given one.  At most room of them; *ret_n tells how many.  Time as an
 * eigenproblem of order s (harmonics + 1), twice that with quadratic terms.  SW_NOMEM, SW_NOCONV.
 */
enum status bolotin_solve(const struct parametric *p, double Omega, int period, int harmonics,
                          double most, struct boundary *ret, int room, int *ret_n);

/* bolotin_solve once more with two harmonics less, for the change of each of the n points found. */
enum status bolotin_change(const struct parametric *p, double Omega, int period, int harmonics,
                           struct boundary *points, int n);

#endif
