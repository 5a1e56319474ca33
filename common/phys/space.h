/*
 * Vectors in space, largest entries.
 */
#ifndef SEILWERK_PHYS_SPACE_H
#define SEILWERK_PHYS_SPACE_H

#include <math.h>

static inline double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ret = a x b, neither of them ret. */
static inline void cross(const double a[3], const double b[3], double ret[3])
{
    ret[0] = a[1] * b[2] - a[2] * b[1];
    ret[1] = a[2] * b[0] - a[0] * b[2];
    ret[2] = a[0] * b[1] - a[1] * b[0];
}

/* ret = a - b. */
static inline void subtract(const double a[3], const double b[3], double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = a[i] - b[i];
}

/* The larger one; NAN if one is. */
static inline double larger(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

/* Largest magnitude of n entries, NAN if one is. */
static inline double largest(int n, const double *x)
{
    double most = 0;

    for (int i = 0; i < n; i++)
        most = larger(fabs(x[i]), most);
    return most;
}

#endif
