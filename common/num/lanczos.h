/*
 * The lowest eigenpairs of a symmetric positive definite band pencil K x = lambda M x by Lanczos.
 *
 * ARPACK keeps state between its calls: one Lanczos at a time in a process.
 */
#ifndef SEILWERK_NUM_LANCZOS_H
#define SEILWERK_NUM_LANCZOS_H

#include "num/band.h"

/* Most pairs that can be asked for, of a pencil of order n. */
int lanczos_most(int n);

/*
 * The k lowest pairs: lambda[0] <= ... (k) and x (n, k; column-major), X^T M X = I.
 * 1 <= k <= lanczos_most(n).  Largest eigenvalues of C^{-1} M C^{-T}, K = C C^T, to 1e-12.
 * Memory: about 2 k + 10 vectors besides x; time n k^2.
 *
 * SW_NOMEM, also where k is above 23163; SW_INDEFINITE if K is not positive definite; SW_NOCONV.
 */
enum status lanczos_lowest(const struct band *K, const struct band *M, int k, double *lambda,
                           double *x);

#endif
