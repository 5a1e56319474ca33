/*
 * A recorded vector of time: cubic spline with continuous second derivative, constant outside.
 *
 * At its first and last sample the spline has the slope of the parabola through the three nearest
 * samples.
 */
#ifndef SEILWERK_PHYS_SERIES_H
#define SEILWERK_PHYS_SERIES_H

#include "num/status.h"

struct series {
    int n;         /* samples, >= 2 */
    double *t;     /* (n) ascending [s]; owned */
    double *x;     /* (3, n) samples; owned */
    double *slope; /* (3, n) derivatives by time; owned */
};

/* Spline through n samples x (3, n) at t, both copied.  SW_ADMISSIBLE: less than two, or times that
 * do not ascend; SW_NOMEM. */
enum status series_new(int n, const double *t, const double *x, struct series *ret);

void series_free(struct series *s);

/* Value x, and first and second derivative v and a, at t; v and a may be NULL. */
void series_at(const struct series *s, double t, double x[3], double v[3], double a[3]);

#endif
