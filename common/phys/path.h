/*
 * The path of a sling in a pose: its places, its length and the length's derivatives.
 *
 * The shortest line from end to end that passes parallel edges of a body on the outside lies, seen
 * along the edges, on the convex hull of the ends and the corners; along the edges it climbs evenly
 * over the length seen, because the faces between the edges can be unfolded.
 */
#ifndef SEILWERK_PHYS_PATH_H
#define SEILWERK_PHYS_PATH_H

#include "phys/gear.h"

enum { PATH_POINTS = GEAR_CORNERS + 2 };

struct path {
    int n;                       /* points: ends and corners that are touched */
    int body[PATH_POINTS];       /* of each, or GEAR_HOOK */
    int corner[PATH_POINTS];     /* which corner, -1 for an end */
    double x[PATH_POINTS][3];    /* their places in space */
    double arm[PATH_POINTS][3];  /* from the centre of gravity of their body */
    double pull[PATH_POINTS][3]; /* d length/d x */
    double edge[3];              /* direction of the edges in space */
    double length;
};

/* Sling k of s in the pose (bodies). */
void path_lay(const struct gear *s, const struct pose *pose, int k, struct path *ret);

/* g (f->n) = gradient of the length over the free motions. */
void path_gradient(const struct path *p, const struct freedom *f, double *g);

/* H (f->n, f->n) += factor times the second derivatives of the length.  Where the path just touches
 * an edge they jump; those without the touched edge are given. */
void path_add_hessian(const struct path *p, const struct freedom *f, double factor, double *H);

#endif
