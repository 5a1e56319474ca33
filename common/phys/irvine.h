/*
 * Irvine's closed theory of the small vibrations of a cable with small sag (theory section 8).
 *
 * Inclined cables by the usual projection: chord for span, tension along it for H, gravity across
 * it.  Mass per metre of chord.
 */
#ifndef SEILWERK_PHYS_IRVINE_H
#define SEILWERK_PHYS_IRVINE_H

#include "phys/line.h"

/* Root k = 1, 2, ... of sin(x/2) - (x/2 - (4/lambda2)(x/2)^3) cos(x/2) = 0, which lies between
 * (2 k - 1) pi and (2 k + 1) pi; x = omega l sqrt(m/H).  lambda2 >= 0. */
double irvine_symmetric_root(double lambda2, int k);

/* Circular frequencies [rad/s], k = 1, 2, ...: symmetric and antisymmetric in the plane of the
 * line, and out of it with k half waves. */
double irvine_symmetric(const struct line *s, int k);
double irvine_antisymmetric(const struct line *s, int k);
double irvine_lateral(const struct line *s, int k);

#endif
