/*
 * Range and null space of a few columns: Householder QR with column pivoting.
 *
 * Column-major; no allocation; orders up to NULLSPACE_MOST.
 */
#ifndef SEILWERK_NUM_NULLSPACE_H
#define SEILWERK_NUM_NULLSPACE_H

enum { NULLSPACE_MOST = 32 };

/* A P = Q [R; 0], A (n, m) with n, m <= NULLSPACE_MOST. */
struct nullspace {
    int n, m, rank;
    int column[NULLSPACE_MOST];                /* column j of A P is this one of A */
    double R[NULLSPACE_MOST * NULLSPACE_MOST]; /* (rank, m), leading dimension n */
    double Q[NULLSPACE_MOST * NULLSPACE_MOST]; /* (n, n): rank columns span A, the others are
                                                  orthogonal to it */
};

/* A column that, freed of its part in the earlier ones, is shorter than tolerance times the longest
 * of A does not count towards the rank; A is lost. */
void nullspace_of(int n, int m, double *A, double tolerance, struct nullspace *ret);

/* Least-squares solution x (m) of A x = b (n); the shortest one if rank < m. */
void nullspace_solve(const struct nullspace *f, const double *b, double *x);

/* y (n): the shortest solution of A^T y = c (m); rows beyond the rank are left out. */
void nullspace_transposed(const struct nullspace *f, const double *c, double *y);

#endif
