/*
 * Maps of parametric resonance: boundaries and multipliers over the frequency and the amplitude of
 * the ground motion.
 */
#ifndef SEILWERK_PHYS_MAP_H
#define SEILWERK_PHYS_MAP_H

#include "phys/bolotin.h"
#include "phys/floquet.h"
#include "phys/ground.h"

/* What is the same for all frequencies. */
struct map {
    struct ground ground;
    struct projection projection;
    const struct modes *modes; /* not owned */
    const int *mode;           /* (projection.s) numbers from 0; not owned */
    double alpha, beta;        /* damping of the modes */
    double reference;          /* circular frequency: Omega = 2 ratio reference [rad/s] */
    enum theory theory;
    int quadratic;
    double complex b[6]; /* motion of the supports of unit amplitude, axes of the plane */
    double *R;           /* force of unit amplitude over all nodes, or NULL; owned */
};

struct map_row {
    double ratio, Omega, amplitude;
    int period; /* of a boundary: 1 T, 2 2 T; 0: a point of a grid */
    struct boundary boundary;
    struct floquet floquet;
};

/* Rows of one frequency; to be freed. */
struct map_rows {
    struct map_row *row;
    int n, room;
    enum status status;
};

/* What to compute at each frequency. */
struct map_task {
    int floquet;           /* grid or curves of multipliers, else Bolotin's boundaries */
    int trace;             /* floquet: amplitudes at which the largest modulus crosses 1, to 1e-6 */
    int harmonics;         /* of Bolotin */
    int change;            /* whether his points tell their change by the last harmonics */
    double from, to, step; /* amplitudes */
};

/* ground_alpha, ground_beta: damping of the ground motion.  The rest of *ret is filled by the
 * caller.  SW_NOMEM. */
enum status map_new(const struct model *m, const struct modes *p, const int *mode, int s,
                    double ground_alpha, double ground_beta, struct map *ret);

void map_free(struct map *m);

/* Equations at one ratio, to be freed with parametric_free.  SW_INDEFINITE: an undamped resonance
 * of the ground motion; SW_NOMEM. */
enum status map_equations(const struct map *m, double ratio, struct parametric *ret);

/* Rows of count frequencies, ratio[i] into rows[i], in so many threads (OpenMP) with BLAS in one
 * thread each. */
void map_rows(const struct map *m, const struct map_task *t, const double *ratio, int count,
              int threads, struct map_rows *rows);

void map_rows_free(struct map_rows *r);

#endif
