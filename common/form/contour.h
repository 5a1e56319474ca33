/*
 * Heights of one arrangement over two of its inputs, and a word on the points that are none.
 */
#ifndef SEILWERK_FORM_CONTOUR_H
#define SEILWERK_FORM_CONTOUR_H

#include "form/axis.h"

/* The table over a and b, a line a point.  How many points are not judged, and the most frequent
 * reason, is warned of in the end. */
void contour_print(struct lift_table *t, const struct lift_given *g, const struct axis *a,
                   const struct axis *b, double limit, struct out *o);

#endif
