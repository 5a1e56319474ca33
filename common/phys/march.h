/*
 * Time integration: explicit, by central differences (Thalheim 4.3; theory section 3, c4), or
 * implicit (phys/alpha.h).  Explicit:
 *
 *     A (V(t+dt) - 2 V(t) + V(t-dt)) = R(t) - F_int(V(t)) - C (V(t) - V(t-dt))/dt
 *     A = M/dt^2 + C/(2 dt),  C = alpha M + beta K + dampers
 *
 * for the free unknowns, prescribed ones inserted on the left.  The state is V and the increment
 * D = V(t) - V(t-dt).  A is factored once, without the dampers: what they add to it has their
 * number for rank and is put on afterwards (Woodbury).  Vectors have 6 (n + 1) entries
 * (phys/model.h).  No allocation after march_new.
 */
#ifndef SEILWERK_PHYS_MARCH_H
#define SEILWERK_PHYS_MARCH_H

#include "phys/alpha.h"
#include "phys/damper.h"
#include "phys/force.h"
#include "phys/forcing.h"
#include "phys/inertia.h"
#include "phys/motion.h"

enum scheme { SCHEME_CENTRAL, SCHEME_ALPHA };

struct march_options {
    double alpha, beta; /* Rayleigh damping [1/s], [s] */
    enum scheme scheme;
    double dt;                   /* time step [s], > 0; central */
    double interval;             /* between the times that march_at_mark finds [s] */
    long substeps;               /* steps in it; alpha: 0 as many as the tolerance asks for */
    double radius, tolerance;    /* alpha: r, and of the step's error */
    int terms;                   /* 0..3: nonlinear parts F1, F2, F3 taken in */
    const struct motion *motion; /* of the supports; not owned */
    int n_motions;
    const struct damper *damper; /* not owned */
    int n_dampers;
    struct forcing forcing;
};

/* Dampers of a march; r of them. */
struct march_dampers {
    int r;
    double *c; /* (r) coefficients [N s/m] */
    double *b; /* (6 (n + 1), r): b^T V is the displacement at the damper along its direction */
    double *z; /* (6 (n + 1), r): A^{-1} b, zero at the supports */
    double *S; /* (r, r): inverse of diag(2 dt/c) + b^T z */
    double *w; /* (2 r) work space */
};

struct march {
    const struct model *model; /* not owned */
    struct march_options options;
    struct inertia inertia;
    struct force_table forces;
    struct march_dampers dampers;
    double omega_max;    /* of the unstretched cable [rad/s] */
    long step;           /* steps taken; t = step dt */
    double *V, *D;       /* state and increment */
    double *F;           /* internal forces less those from outside and with those of the dampers */
    double *dd;          /* V(t+dt) - 2 V(t) + V(t-dt), set by march_solve; central */
    double *W;           /* velocity, for march_velocity and the wind; central */
    struct alpha *alpha; /* of the implicit scheme, NULL: central; owned */
    double slack_time;   /* first time at which EA gamma + T < 0 somewhere, negative: never */
    double slack_theta;  /* and the place */
    double stiffened;    /* last largest 3 EA gamma/(EA a^2 + T) */
};

enum kick { KICK_DISPLACEMENT, KICK_VELOCITY };

/* Longest stable step of the model as it hangs [s], 2/omega_max. */
double march_critical_step(const struct model *m);

/* Matrices factored, state zero.  SW_NOMEM; SW_INDEFINITE if A is not positive definite. */
enum status march_new(const struct model *m, const struct march_options *o, struct march *ret);

void march_free(struct march *m);

/* Start at t = 0 from V0 with velocity W0 over all nodes (NULL: at rest).  What is prescribed at
 * the supports is taken from the motions. */
enum status march_start(struct march *m, const double *V0, const double *W0);

/* Disturb by size times shape: displacement of both time levels [m], or a velocity [m/s].  The
 * supports' entries of shape are passed over. */
void march_kick(struct march *m, enum kick kind, double size, const double *shape);

/* Forces at the present time, and dd.  SW_DIVERGED where the step is longer than the stretched
 * cable allows (central), or a number is no longer finite. */
enum status march_solve(struct march *m);

/* After march_solve: velocity (V(t+dt) - V(t-dt))/(2 dt) over all nodes; owned by m. */
const double *march_velocity(struct march *m);

/* After march_solve: force of the left, then of the right support on the cable [N], static part
 * included (three axes each). */
void march_support_force(const struct march *m, double ret[6]);

/* The same without the static part, in the axes of the line's plane. */
void march_support_change(const struct march *m, double ret[6]);

/* Step on, after march_solve.  Central: cannot fail; else as alpha_advance. */
enum status march_advance(struct march *m);

/* Motion of the supports at t, in the axes of the line's plane, left then right; v and a may be
 * NULL. */
void march_supports(const struct march *m, double t, double u[6], double v[6], double a[6]);

/* Whether the present time is a multiple of options.interval; that multiple. */
int march_at_mark(const struct march *m);
long march_mark(const struct march *m);

/* Time before the last step [s], negative at the start. */
double march_past(const struct march *m);

/* Present time [s]. */
double march_time(const struct march *m);

#endif
