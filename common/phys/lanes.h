/*
 * Eight marches side by side, one in each lane of a vector: what an ensemble spends its time on.
 *
 * All lanes march on the same model with the same nonlinear terms, each with a damping, time step,
 * support motion and state of its own.  A lane knows nothing of the others: its numbers are the
 * same, bit for bit, whatever stands beside it, and on any processor.  They agree with those of
 * phys/march.h to round-off (another order of sums).
 *
 * With beta > 0 the scheme is solved for V(t+dt) - V(t-dt) = Y,
 *
 *     A Y = R - F_int + (2/dt^2) M D,     D(t+dt) = Y - D,
 *
 * which needs no product with C (for C/dt = 2 A - 2 M/dt^2); M is that of a uniform mesh.  Without
 * beta, A is a multiple of M, and the factor of M for one component serves all three and all lanes.
 * No dampers, forces or wind.
 */
#ifndef SEILWERK_PHYS_LANES_H
#define SEILWERK_PHYS_LANES_H

#include "phys/march.h"

#define LANES 8

/* One number of each lane. */
typedef double lanes_vector __attribute__((vector_size(8 * LANES), may_alias));

/*
 * A harmonic motion of the supports in each lane: u = r (p c + q s) with c + i s = e^{i omega t},
 * turned on from step to step by the factor dc + i ds and set anew by lanes_tune.
 */
struct lanes_motion {
    lanes_vector c, s, dc, ds;
    lanes_vector p[6], q[6]; /* in the axes of the line's plane, left then right [m] */
    lanes_vector r;          /* ramp, at the end of the step */
};

struct lanes {
    const struct model *model;   /* not owned */
    int terms, beta;             /* nonlinear terms; whether beta > 0: the same in all lanes */
    double slope[GAUSS][3];      /* Hermite slopes: of the difference of the ends, of both slopes */
    double *material;            /* (n, GAUSS, 5): x1, x2, weighted EA and T, stiffening; owned */
    double mass[7];              /* of one component: of a node within, and what its ends lack */
    double *memory;              /* of the next six; owned */
    lanes_vector *V, *D, *Y;     /* (6 (n + 1)) in the order of phys/model.h */
    lanes_vector *factor;        /* beta: (n + 1, 33), of the plane, then of the lateral part */
    lanes_vector *support;       /* (2, 15): beta: columns of A at the supports */
    double *mass_factor;         /* no beta: (n + 1, 7) of M for one component; owned */
    double mass_support[2][3];   /* no beta: columns of M at the supports */
    lanes_vector scale;          /* beta: 2/dt^2; else: of M^{-1} in A^{-1} */
    lanes_vector gamma;          /* no beta: c C = gamma A */
    lanes_vector limit;          /* largest admissible 3 EA gamma/(EA a^2 + T) */
    struct lanes_motion *motion; /* (n_motions); in memory */
    int n_motions;
    int ramps[LANES];                   /* whether a motion of the lane may still be in its ramp */
    double dt[LANES];                   /* [s], 0: the lane is empty */
    long step[LANES];                   /* steps taken */
    const struct motion *source[LANES]; /* motions of the lane; not owned */
    int n_source[LANES];
    lanes_vector bad, slack; /* below zero: the step was too long; some place was slack */
};

/* Room for so many motions in each lane.  SW_NOMEM. */
enum status lanes_new(const struct model *m, int terms, int beta, int n_motions, struct lanes *ret);

void lanes_free(struct lanes *p);

/* Lane i takes over the state of m, a march on the same model with the same terms, all of its
 * motions harmonic, without dampers, forces and wind, as it is before march_solve.  The motions
 * must live as long as the lane is in use. */
void lanes_put(struct lanes *p, int i, const struct march *m);

/* Lane i comes to rest and stays there. */
void lanes_clear(struct lanes *p, int i);

/* One step of all lanes.  Sets bad and slack by the state before it. */
void lanes_step(struct lanes *p);

/* The same by registers of 2, 4 (AVX2) or 8 (AVX-512) lanes, which the processor must have; and the
 * widest that it has.  All give the same bits. */
void lanes_step_by(struct lanes *p, int width);
int lanes_width(void);

/* The motions of lane i from its present time itself: to be called every few dozen steps, at times
 * that do not depend on the other lanes. */
void lanes_tune(struct lanes *p, int i);

/* V of lane i over all nodes. */
void lanes_look(const struct lanes *p, int i, double *V);

/* V of lane i += V and D += D, over all nodes and zero at the supports. */
void lanes_add(struct lanes *p, int i, const double *V, const double *D);

/* Whether the sign of lane i is negative: of bad and slack. */
static inline int lanes_negative(const lanes_vector *x, int i)
{
    return __builtin_signbit((*x)[i]) != 0;
}

#endif
