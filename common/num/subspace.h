/*
 * The lowest eigenpairs of a sparse symmetric pencil K x = lambda M x by inverse iteration of a
 * subspace, with Sturm's count as a check.
 */
#ifndef SEILWERK_NUM_SUBSPACE_H
#define SEILWERK_NUM_SUBSPACE_H

#include "num/sparse.h"

/*
 * lambda ascending (k) and x (n, k; column-major), X^T M X = I; 1 <= k <= n.  M has its values
 * (K->entries) at the places of K, positive semidefinite; K need not be definite: negative and zero
 * eigenvalues are found, too.  K's values are kept, its factor is lost.
 *
 * SW_NOCONV: no convergence, or an eigenvalue below the last one was missed; SW_INDEFINITE: M is
 * not semidefinite; SW_NOMEM.
 */
enum status subspace_lowest(struct sparse *K, const double *M, int k, double *lambda, double *x);

#endif
