/*
 * Righting levers and moments over the tilt, beside what the formulas say.
 */
#ifndef SEILWERK_FORM_LEVER_H
#define SEILWERK_FORM_LEVER_H

#include "form/lift.h"

/* Names of the columns, and the line end. */
void lever_header(struct out *o);

/* One arrangement, each degree from 0 to 90 until the path ends, a line a tilt.  SW_ADMISSIBLE: it
 * has no planar view, or phi is missing; SW_NOCONV. */
enum status lever_row(const struct lift *l, long row, const char *name, struct out *o,
                      struct why *why);

#endif
