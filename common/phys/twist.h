/*
 * What moments about fixed axes add to the stiffness of a frame: K - C, C of rank two at each node
 * that carries one (theory: the derivative of spatial moments by spins is not symmetric).
 */
#ifndef SEILWERK_PHYS_TWIST_H
#define SEILWERK_PHYS_TWIST_H

#include "phys/frame.h"

#define TWIST_NODES 16 /* with the largest moments; more are left to the iteration */

struct twist {
    int n;
    int node[TWIST_NODES];
    double *Z; /* (unknowns, 3 n) K^-1 at their spins; owned */
    double C[TWIST_NODES][9];
    double A[9 * TWIST_NODES * TWIST_NODES]; /* I - C Z, (3 n, 3 n), by rows */
};

/* From the factor of w->K and what was last evaluated.  SW_NOMEM. */
enum status twist_new(const struct frame *f, struct frame_work *w, struct twist *ret);
void twist_free(struct twist *t);

/* x := (K - C)^-1 x for one column.  SW_INDEFINITE: singular; SW_NOMEM. */
enum status twist_solve(const struct twist *t, struct frame_work *w, double *x);

#endif
