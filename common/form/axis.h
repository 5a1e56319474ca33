/*
 * Two inputs of an arrangement over which heights are wanted: COL,COL, each with a range or
 * without.
 */
#ifndef SEILWERK_FORM_AXIS_H
#define SEILWERK_FORM_AXIS_H

#include "form/lift.h"

struct axis {
    int number; /* of struct lift_given */
    char name[LIFT_NAME];
    double from, to; /* in the unit of the column */
    long n;          /* values, 2 at least */
};

/* COLUMN=FROM:TO:N, or COLUMN: 41 values from half to one and a half of the present one (-1 to 1
 * about 0), angles 10 degrees to both sides; a comma between two of them.  SW_USAGE. */
enum status axes_read(const char *text, const struct lift_given *g, struct axis *ret_a,
                      struct axis *ret_b, struct why *why);

/* The k-th value, from 0. */
double axis_value(const struct axis *a, long k);

#endif
