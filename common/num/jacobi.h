/*
 * Eigenpairs of small symmetric matrices by Jacobi rotations, without LAPACK.
 *
 * For orders up to a few dozen.  Column-major, both triangles given.  No allocation, no state.
 * Eigenvalues are good to round-off of the largest one; the vectors are orthogonal to round-off.
 */
#ifndef SEILWERK_NUM_JACOBI_H
#define SEILWERK_NUM_JACOBI_H

#include "num/status.h"

/* A = X diag(lambda) X^T: lambda (n) ascending, X (n, n) with X^T X = I; A (n, n) is lost.
 * SW_NOCONV: an entry is not finite. */
enum status jacobi_symmetric(int n, double *A, double *lambda, double *X);

/* K X = M X diag(lambda), X^T M X = I; K and M (n, n) symmetric, M positive definite; both are lost
 * (M holds its Cholesky factor).  SW_INDEFINITE: M is not; SW_NOCONV: K has no finite entries. */
enum status jacobi_pencil(int n, double *K, double *M, double *lambda, double *X);

/* A = L L^T of a full symmetric A (n, n): L in the lower triangle, the upper one is left as it was.
 * SW_INDEFINITE: a pivot is not above least times its diagonal entry. */
enum status cholesky_factor(int n, double *A, double least);

/* x := L^{-1} x and x := L^{-T} x, x (n). */
void cholesky_forward(int n, const double *L, double *x);
void cholesky_backward(int n, const double *L, double *x);

#endif
