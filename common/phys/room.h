/*
 * The room that an equilibrium leaves to small motions: those that keep the lengths of the taut
 * rigid slings, without the neutral ones.
 */
#ifndef SEILWERK_PHYS_ROOM_H
#define SEILWERK_PHYS_ROOM_H

#include "num/nullspace.h"
#include "phys/potential.h"

struct room {
    int n, m;      /* free motions, dimension of the room */
    int neutral;   /* neutral motions left out */
    int redundant; /* taut rigid slings more than the others allow to tell forces of */
    struct nullspace f;
    const double *Z; /* (n, m) orthonormal columns in f.Q: not to be copied apart from it */
};

/* force (slings): a rigid sling is taut where it is above least.  metric (n, n) or NULL for the
 * unit matrix: the room is orthogonal to metric times the neutral motions. */
void room_of(const struct gear *s, const struct pose *pose, const struct freedom *f,
             const struct potential *p, const double *force, double least, const double *metric,
             struct room *ret);

/* ret (m, m) = Z^T A Z, A (n, n) symmetric. */
void room_project(const struct room *r, const double *A, double *ret);

/*
 * Neutral motions T (f->n, at most 1 + bodies columns), their number: whatever the numbers, a turn
 * of everything about the one vertical line that holds all hooks costs nothing, nor does that of a
 * body about a line that holds its centre of gravity and all points where slings hold it.
 */
int room_neutral(const struct gear *s, const struct pose *pose, const struct freedom *f, double *T);

#endif
