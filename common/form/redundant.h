/*
 * Quantities that are given twice, such as phi beside v and base: whoever varies one of them meets
 * the other.
 */
#ifndef SEILWERK_FORM_REDUNDANT_H
#define SEILWERK_FORM_REDUNDANT_H

#include "form/lift.h"

/* The number whose leaving out makes an arrangement of g, which is none because numbers contradict
 * each other; a base rather than an angle.  The varied ones (n) stay.  -1: it is none for another
 * reason, or one number is not enough. */
int redundant_number(const struct lift_given *g, const int *varied, int n);

/* The same for number i of g, which is an arrangement, on the way to values near by; -1: none of
 * them contradicts. */
int redundant_near(const struct lift_given *g, int i);

/* "base_long_m = 9". */
#define REDUNDANT_TEXT (LIFT_NAME + 30)
void redundant_say(const struct lift_given *g, int i, char ret[REDUNDANT_TEXT]);

#endif
