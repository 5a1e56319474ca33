/*
 * Dividing curved elements whose end angles are too large: points, tangents and section axes
 * between two ends, as of an arc.
 */
#ifndef SEILWERK_PHYS_DIVIDE_H
#define SEILWERK_PHYS_DIVIDE_H

#include "phys/bow.h"

#define DIVIDE_MOST 1024 /* pieces of one element */

struct station {
    double x[3], A[9]; /* point and section frame, global */
    double twist;      /* of the piece from here to the next, about [rad] */
    double bulge;      /* psi in the middle of that piece beyond the mean [rad] */
};

/* Stations from `a` to `b` (a.twist, a.bulge: of the whole) such that the end angles of all pieces
 * are at most `angle` and their twists 3 angle.  Circles and helices are met exactly, or to the
 * order of the element.  ret: room for DIVIDE_MOST + 1.  Returns the number of pieces, 0: more
 * would be needed, or the ends point back. */
int divide(const struct station *a, const struct station *b, double angle, struct station *ret);

#endif
