/*
 * Numbers as text: read whole, printed shortest so that they read back as the same double.
 */
#ifndef SEILWERK_SYS_NUMBER_H
#define SEILWERK_SYS_NUMBER_H

#include "sys/err.h"

#include <stddef.h>

#define NUMBER_SIZE 32 /* characters that hold any printed number, NUL included */

/*
 * Print x with the fewest digits that read back as x, the closest of them to x; -0 as 0; nan, inf,
 * -inf by these names.  Positional from 1e-5 up to 1e17, else with an exponent.  Returns the
 * length; NUL-terminated.
 */
size_t number_print(double x, char ret[NUMBER_SIZE]);

/* Read all of text as a finite decimal number.  Returns NULL and sets *ret, or returns why not
 * (static storage) and leaves *ret alone. */
const char *number_read(const char *text, double *ret);

/* The same for a whole number in [min, max]. */
const char *integer_read(const char *text, long min, long max, long *ret);

/* n numbers with commas between them to ret.  SW_USAGE, with what is wrong. */
enum status numbers_read(const char *text, int n, double *ret, struct why *why);

#endif
