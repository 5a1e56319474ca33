/*
 * The linear systems of a time step, A = a M + b C with C = alpha M + beta K, supports held at
 * given values.
 *
 * With beta > 0 the cable's plane (half bandwidth 7) and the lateral direction (3) are solved
 * apart. Without it A couples no two components: one factor of half bandwidth 3 serves all three at
 * once, and no product with C is needed.  Vectors are over all nodes (phys/model.h).
 */
#ifndef SEILWERK_PHYS_INERTIA_H
#define SEILWERK_PHYS_INERTIA_H

#include "phys/model.h"

/* Matrices and work space of one part. */
struct inertia_part {
    enum part part;
    int width;                 /* unknowns a node */
    struct band A, C;          /* over all nodes */
    struct band_factor factor; /* of A with unit rows and columns for the held unknowns */
    int held[4], n_held;
    double *x, *d;
};

struct inertia {
    int n;        /* elements */
    double c;     /* the right side holds c C D */
    int parts;    /* 2, or 1: all three components by one factor */
    double gamma; /* one factor: c C = gamma A */
    struct inertia_part part[2];
};

/* SW_NOMEM; SW_INDEFINITE if A is not positive definite. */
enum status inertia_new(const struct model *m, double a, double b, double c, double alpha,
                        double beta, struct inertia *ret);

void inertia_free(struct inertia *p);

/* x with A x = -F - c C D in the free rows and held values at the supports (left, then right,
 * three axes each). */
void inertia_solve(struct inertia *p, const double *F, const double *D, const double held[6],
                   double *x);

/* ret = A x + c C D + F in the rows of the supports. */
void inertia_support(const struct inertia *p, const double *F, const double *D, const double *x,
                     double ret[6]);

#endif
