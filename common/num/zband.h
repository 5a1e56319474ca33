/*
 * Complex combinations of symmetric band matrices: the dynamic stiffness of a harmonic response.
 */
#ifndef SEILWERK_NUM_ZBAND_H
#define SEILWERK_NUM_ZBAND_H

#include "num/band.h"

#include <complex.h>

/* x := (k K + m M)^{-1} x by LAPACK's zgbsv, n entries; half bandwidth of M not above K's.
 * SW_NOMEM; SW_INDEFINITE: the matrix is singular. */
enum status zband_solve(double complex k, const struct band *K, double complex m,
                        const struct band *M, double complex *x);

#endif
