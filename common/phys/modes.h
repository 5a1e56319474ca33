/*
 * Eigenmodes of the cable, K phi = omega^2 M phi with phi^T M phi = 1 (Thalheim 4.3.2.2).
 *
 * Modes count from 0 here (from 1 for users), in order of frequency.  Vectors hold the N = 6 n free
 * unknowns in ascending order.  A mode's sign: its largest displacement component is positive (the
 * first one of several that are equal to 1e-6).
 */
#ifndef SEILWERK_PHYS_MODES_H
#define SEILWERK_PHYS_MODES_H

#include "phys/model.h"

struct modes {
    int n;            /* unknowns, 6 n of the model */
    int k;            /* modes */
    double *omega;    /* (k) [rad/s], ascending; owned */
    double *phi;      /* (n, k) column-major; owned */
    enum part *plane; /* (k) PART_PLANE or PART_LATERAL; owned */
};

/* Elements up to which all modes can be solved for at once: some 3 GB and two minutes. */
#define MODES_MAX_ELEMENTS 2000

/* The k lowest modes (1 <= k <= 6 n), by solving for all.  Memory: 5 (4 n)^2 doubles at the
 * most.  SW_ADMISSIBLE: more than MODES_MAX_ELEMENTS; SW_NOMEM, SW_INDEFINITE, SW_NOCONV. */
enum status modes_all(const struct model *m, int k, struct modes *ret);

void modes_free(struct modes *p);

/* Frequency of mode i [Hz]. */
double modes_frequency(const struct modes *p, int i);

/* V (all nodes) = mode i scaled so that its largest nodal displacement is 1 m.  SW_ADMISSIBLE: the
 * mode has its own nodes at those of the mesh, and moves between them only. */
enum status modes_unit_shape(const struct model *m, const struct modes *p, int i, double *V);

#endif
