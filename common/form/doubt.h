/*
 * What tolerances do to the height that judges (judge_height), and which value of an input gives a
 * wanted height.
 */
#ifndef SEILWERK_FORM_DOUBT_H
#define SEILWERK_FORM_DOUBT_H

#include "form/judge.h"

/*
 * A bound that no arrangement within the tolerances of g falls below, all combinations of them
 * allowed, the corners of the box and what lies between; at most 1e-6 m and 1e-6 of it below what
 * some arrangement has, if 2000 parts of the box were enough, else lower.  -INFINITY: the box holds
 * what is no arrangement.  NAN: no tolerances.  g must have made l.
 *
 * Interval arithmetic encloses h and its derivatives over the box: an input whose derivative has
 * one sign is set to its worse end, which then is no guess; the box is halved where signs are open.
 */
double doubt_worst(const struct lift_given *g, const struct lift *l);

/* Greatest judge_use within the tolerances, looked for along one after the other, which is all
 * where each acts in one direction.  NAN: no tolerances, or no limit is known. */
double doubt_use(const struct lift_given *g, const struct lift *l);

/* g at the corner of its tolerances where the height of the formulas falls to first order. */
void doubt_corner(const struct lift_given *g, struct lift_given *ret);

/* Derivatives of the height that judges by each number that is given, per unit of its column; NAN
 * for the others. */
void doubt_slopes(const struct lift_given *g, const struct lift *l, double ret[LIFT_NUMBERS]);

/* Number that matters most: its tolerance, or without any 1 % of a value and half a degree of an
 * angle, changes h most to first order; -1: none does. */
int doubt_greatest(const struct lift_given *g, const double slopes[LIFT_NUMBERS]);

struct doubt {
    double probability;     /* that h lies below the limit, or the sample is no arrangement */
    double mean, deviation; /* m, of the arrangements; NAN: there are none */
};

/* n samples, each input uniform and independent within its tolerance.  The random numbers depend on
 * seed, sample and input only: equal rows have equal results. */
void doubt_sample(const struct lift_given *g, long n, long seed, double limit, struct doubt *ret);

/* The value of number i, next to the present one, with which the height that judges is h, in SI
 * units; NAN: there is none.  It must be given. */
double doubt_design(const struct lift_given *g, int i, double h);

#endif
