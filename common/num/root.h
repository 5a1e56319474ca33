/*
 * Root and least value of a function of one number.
 *
 * A function that cannot be evaluated returns NAN, which ends the search with NAN.
 */
#ifndef SEILWERK_NUM_ROOT_H
#define SEILWERK_NUM_ROOT_H

typedef double scalar_function(double x, void *context);

/* x in [a, b] with f(x) = 0 to round-off of x, where fa = f(a) and fb = f(b) differ in sign
 * (Chandrupatla: inverse quadratic steps where they are safe, else bisection). */
double root_between(scalar_function *f, void *context, double a, double fa, double b, double fb);

/* x of the least f in [a, b], which holds one minimum (golden section; x to the square root of
 * round-off), and f there. */
double least_between(scalar_function *f, void *context, double a, double b, double *ret_f);

#endif
