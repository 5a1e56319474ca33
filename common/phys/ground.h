/*
 * The ground motion of a stability analysis: steady linear response of the cable to supports that
 * move harmonically (Thalheim 5.2; theory section 4).
 */
#ifndef SEILWERK_PHYS_GROUND_H
#define SEILWERK_PHYS_GROUND_H

#include "phys/model.h"

#include <complex.h>

/* Matrices of the response, once for all frequencies. */
struct ground {
    const struct model *model;        /* not owned */
    struct partition M, K;            /* of all unknowns, in the axes of the line's plane */
    struct band part_M[2], part_K[2]; /* free unknowns of the plane, and lateral ones */
    int *keep[2];                     /* their numbers among all free ones; owned */
    double alpha, beta;               /* damping of the ground motion [1/s], [s] */
};

/* SW_NOMEM. */
enum status ground_new(const struct model *m, double alpha, double beta, struct ground *ret);

void ground_free(struct ground *g);

/*
 * V(t) = Re(V e^{i Omega t}) over all nodes for supports that move by Re(b e^{i Omega t}), left
 * then right, three axes of the plane each, and for forces Re(R e^{i Omega t}) over all nodes
 * (NULL: none): (K + i Omega C - Omega^2 M) V = R in the free rows.  May run in several threads at
 * once. SW_INDEFINITE: an undamped resonance exactly; SW_NOMEM.
 */
enum status ground_response(const struct ground *g, double Omega, const double complex b[6],
                            const double *R, double complex *V);

#endif
