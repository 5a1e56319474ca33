/*
 * All eigenpairs of a symmetric positive definite band pencil K x = lambda M x.
 */
#ifndef SEILWERK_NUM_PENCIL_H
#define SEILWERK_NUM_PENCIL_H

#include "num/band.h"

/*
 * lambda[0] <= lambda[1] <= ... (n) and the vectors x (n, n; column-major), X^T M X = I.
 *
 * A dense solution with M (LAPACK dsygvd) is exact to round-off of the largest eigenvalue only;
 * the lower end of the spectrum, up to the geometric mean of its bounds, is therefore polished by
 * one step of subspace iteration with the band factor of K and a Ritz projection, which leaves a
 * relative error of about epsilon sqrt(lambda_max/lambda_min).  Memory: 5 n^2 doubles, x included;
 * time grows with n^3.
 *
 * SW_NOMEM; SW_INDEFINITE if M or K is not positive definite; SW_NOCONV.
 */
enum status pencil_all(const struct band *K, const struct band *M, double *lambda, double *x);

#endif
