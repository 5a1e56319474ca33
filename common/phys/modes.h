/*
 * Eigenmodes of the cable, K phi = omega^2 M phi with phi^T M phi = 1 (Thalheim 4.3.2.2).
 *
 * Modes count from 0 here (from 1 for users), in order of frequency.  Vectors hold the N = 6 n free
 * unknowns in ascending order.  A mode's sign: its largest displacement component is positive (the
 * first one of several that are equal to 1e-6); of a single element, its largest slope at the left.
 */
#ifndef SEILWERK_PHYS_MODES_H
#define SEILWERK_PHYS_MODES_H

#include "phys/model.h"

struct modes {
    int n;            /* unknowns, 6 n of the model */
    int k;            /* modes */
    double *omega;    /* (k) [rad/s], ascending; owned */
    double *phi;      /* (n, k) column-major; owned */
    enum part *plane; /* (k) PART_PLANE or PART_LATERAL; owned; NULL as read from a file */
    int counted;      /* modes below the cut of the Sturm count, all found; 0: dense solution */
    double cut;       /* that circular frequency [rad/s] */
};

enum solver {
    SOLVER_AUTO,   /* dense for small models and many modes, else Lanczos */
    SOLVER_DENSE,  /* all modes at once (LAPACK) */
    SOLVER_LANCZOS /* the lowest modes (ARPACK), proven complete by a Sturm count */
};

/* Elements up to which the dense solution goes: some 3 GB and two minutes. */
#define MODES_MAX_ELEMENTS 2000

/* Most modes that Lanczos can be asked for of a mesh of n elements. */
int modes_lanczos_most(int n);

/*
 * The k lowest modes, 1 <= k <= 6 n.  Memory: dense 5 (4 n)^2 doubles at the most, Lanczos about
 * 4 n (k + 20) + 6 n k.
 *
 * SW_ADMISSIBLE: dense and more than MODES_MAX_ELEMENTS, or Lanczos and more than
 * modes_lanczos_most; SW_NOMEM, SW_INDEFINITE; SW_NOCONV, also where Lanczos missed a mode that the
 * Sturm count tells of.
 */
enum status modes_lowest(const struct model *m, int k, enum solver solver, struct modes *ret);

/* Circular frequency of mode number mode (from 1) of one part alone (PART_PLANE, PART_LATERAL).
 * SW_ADMISSIBLE: the mesh has no such mode; SW_NOMEM, SW_INDEFINITE, SW_NOCONV. */
enum status modes_of_part(const struct model *m, enum part part, int mode, double *ret_omega);

void modes_free(struct modes *p);

/* Frequency [Hz] of a circular frequency [rad/s]. */
double hertz(double omega);

/* V (all nodes) = mode i as it is, zero at the supports. */
void modes_shape(const struct model *m, const struct modes *p, int i, double *V);

/* V (all nodes) = mode i scaled so that its largest nodal displacement is 1 m.  SW_ADMISSIBLE: the
 * mode has its own nodes at those of the mesh, and moves between them only. */
enum status modes_unit_shape(const struct model *m, const struct modes *p, int i, double *V);

#endif
