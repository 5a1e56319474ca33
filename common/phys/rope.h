/*
 * A rope between two nodes, cut free at both ends: its shape and flexibility from the tension
 * vector at one end (Blendermann 26-35, theory section 5, c5).
 *
 * t is the tension at end a, pointing from a to b.  Loads act on the rope: a chain of straight
 * elements carries them at its joints, t(next) = t - load; the continuous rope carries a uniform
 * one, t(s) = t_a - q s, s the unstretched length from a.  Elements pull only; where the tension
 * falls to nothing its size counts as sqrt(t^2 + epsilon^2), which leaves the chord the gradient of
 * a convex function of t, and the flexibility, its Hessian, positive definite.  z is up.
 */
#ifndef SEILWERK_PHYS_ROPE_H
#define SEILWERK_PHYS_ROPE_H

#include "num/status.h"

/* Tension by strain: Hooke, or a table through (0, 0), both columns ascending. */
struct rope_law {
    double EA;                      /* [N]; of a table: its first slope */
    int n;                          /* points of the table, 0: Hooke */
    const double *strain, *tension; /* (n) each; not owned */
};

/* Strain at tension T >= 0 [N] and its derivative [1/N]; beyond the table by its last slope. */
double rope_strain(const struct rope_law *law, double T, double *ret_slope);

/* Tension at strain e > 0 [N] and its derivative [N]: the other way round. */
double rope_tension(const struct rope_law *law, double e, double *ret_slope);

struct rope {
    struct rope_law law;
    double L0;          /* unstretched length [m] */
    int elements;       /* of the chain; 0: continuous (Hooke only) */
    double q[3];        /* uniform load [N] per unstretched metre */
    const double *load; /* (elements - 1, 3) at the joints [N], in place of q, or NULL; not owned */
    double epsilon;     /* [N], > 0 */
    double offset[3];   /* of a chain: tension at a less the t that stands for it [N] */
    double give;        /* further strain for each N, while a solution is looked for [1/N] */
};

/* Symmetric 3 x 3: xx, xy, xz, yy, yz, zz. */
enum { SYM_XX, SYM_XY, SYM_XZ, SYM_YY, SYM_YZ, SYM_ZZ, SYM };

/* chord = x_b - x_a [m] and flexibility d chord/d t [m/N], or NULL. */
void rope_chord(const struct rope *r, const double t[3], double chord[3], double F[SYM]);

/* Let t stand for the tension of the chain's element that carries least: where one is nearly slack
 * its few digits would be lost beside the loads.  Its chord is as before. */
void rope_refer(struct rope *r, double t[3]);

/* Load at joint k, from 1, of a rope in n elements [N]. */
void rope_joint_load(const struct rope *r, int n, int k, double ret[3]);

/* Sum of the loads that act between the ends: t at b is t - sum [N]. */
void rope_load(const struct rope *r, double ret[3]);

/* What each end node carries of the uniform load of a chain: half an element's [N]. */
void rope_end_load(const struct rope *r, double ret[3]);

/* One point along the rope. */
struct rope_point {
    double s;       /* unstretched length from a [m] */
    double x[3];    /* from a [m] */
    double t[3];    /* tension towards b, behind the load of this point [N] */
    double load[3]; /* at this point; of a continuous rope, of the stretch before it [N] */
    double strain;  /* of what comes behind it; at b of the last piece */
    double bed;     /* push of the bed here, or on the stretch before it, in load [N] */
};

/* Points of the rope: of a chain its ends and joints, elements + 1; of a continuous one, as many.
 */
void rope_points(const struct rope *r, const double t[3], int n, struct rope_point *ret);

/* Largest and least tension [N]. */
void rope_extremes(const struct rope *r, const double t[3], double *ret_most, double *ret_least);

/* How far its lowest point lies above a, 0 or less [m]. */
double rope_lowest(const struct rope *r, const double t[3]);

/* Stretched length [m]. */
double rope_length(const struct rope *r, const double t[3]);

/* K = F^{-1}.  0 where F is not positive definite. */
int sym_invert(const double F[SYM], double K[SYM]);

/* y = A x. */
void sym_times(const double A[SYM], const double x[3], double y[3]);

#endif
