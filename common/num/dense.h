/*
 * Small dense problems, column-major, by LAPACK.  Lower triangles are given where a matrix is
 * symmetric.  SW_NOMEM, and what is said below.
 */
#ifndef SEILWERK_NUM_DENSE_H
#define SEILWERK_NUM_DENSE_H

#include "num/status.h"

/* A := A^{-1}, symmetric positive definite (n, n); both triangles are returned.
 * SW_INDEFINITE. */
enum status dense_invert(int n, double *A);

/* A = X diag(lambda) X^T, symmetric: lambda ascending, X overwrites A.  SW_NOCONV. */
enum status dense_symmetric(int n, double *A, double *lambda);

/* A x = lambda B x, symmetric, B positive definite: lambda ascending, the vectors with
 * X^T B X = I overwrite A, B is lost.  SW_INDEFINITE, SW_NOCONV. */
enum status dense_pencil(int n, double *A, double *B, double *lambda);

/* A x = (re + i im) x, general; A is lost.  x (n, n) or NULL: a complex pair k, k + 1, the one with
 * im > 0 first, has x_k + i x_(k+1).  SW_NOCONV. */
enum status dense_general(int n, double *A, double *re, double *im, double *x);

/* A x = b for m columns of b, general; both are overwritten, b by x.  SW_INDEFINITE: singular. */
enum status dense_solve(int n, double *A, int m, double *b);

/* Threads that BLAS and LAPACK may use in each call. */
void dense_threads(int n);

#endif
