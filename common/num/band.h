/*
 * Symmetric band matrices: products, Cholesky factor, solution, Sturm count.
 *
 * Storage is LAPACK's lower band form, column by column: A(i,j), i = j..j+kd, stands at
 * a[(i - j) + (kd + 1) * j]; the kd (kd + 1)/2 places below the last row are kept at zero.  A band
 * is owned by the struct; band_free takes a zeroed struct, too.  Indices count from 0.
 */
#ifndef SEILWERK_NUM_BAND_H
#define SEILWERK_NUM_BAND_H

#include "num/status.h"

#include <stddef.h>

struct band {
    int n;     /* order */
    int kd;    /* half bandwidth: number of diagonals below the main one */
    double *a; /* (kd + 1) x n, column-major */
};

/*
 * Factor A = L D L^T with unit lower L.  L is kept twice, by rows and by columns, so that both
 * substitutions run along memory; entries beyond the matrix are zero.
 */
struct band_factor {
    int n, kd;
    double *row;     /* kd x n: L(j, j - kd), ..., L(j, j - 1) */
    double *column;  /* kd x n: L(j + kd, j), ..., L(j + 1, j) */
    double *inverse; /* n: 1/D */
};

/* Place of A(i,j), i >= j >= i - kd. */
static inline double *band_at(const struct band *A, int i, int j)
{
    return A->a + (size_t)(A->kd + 1) * (size_t)j + (i - j);
}

/* A(i,j) for any i, j; 0 outside of the band. */
static inline double band_get(const struct band *A, int i, int j)
{
    if (i < j)
        return j - i <= A->kd ? *band_at(A, j, i) : 0;
    return i - j <= A->kd ? *band_at(A, i, j) : 0;
}

/* A zero matrix of order n >= 0 and half bandwidth kd >= 0.  SW_NOMEM. */
enum status band_new(int n, int kd, struct band *ret);

void band_free(struct band *A);

/* A += the dense symmetric (m, m) block E (column-major, full), rows and columns from..from+m-1;
 * m <= kd + 1. */
void band_add_block(struct band *A, int from, int m, const double *E);

/* y += c A x; x and y have n entries and do not overlap. */
void band_multiply_add(const struct band *A, double c, const double *x, double *y);

/* C = a A + b B, all of one order; B's half bandwidth not above A's.  SW_NOMEM. */
enum status band_combine(double a, const struct band *A, double b, const struct band *B,
                         struct band *ret);

/* The rows and columns keep[0] < keep[1] < ... of A; half bandwidth as A.  SW_NOMEM. */
enum status band_restrict(const struct band *A, const int *keep, int n_keep, struct band *ret);

/* Factor of A (by LAPACK's dpbtrf).  SW_NOMEM; SW_INDEFINITE if A is not positive definite, or
 * holds a NaN. */
enum status band_cholesky(const struct band *A, struct band_factor *ret);

void band_factor_free(struct band_factor *F);

/* x := A^{-1} x, n entries. */
void band_solve(const struct band_factor *F, double *x);

/* The same for four right sides at once, x(4, n): x[4 j + i] is unknown j of right side i. */
void band_solve_four(const struct band_factor *F, double *x);

/* The two halves of it, A = C C^T with C = L sqrt(D):  x := C^{-1} x,  x := C^{-T} x. */
void band_solve_lower(const struct band_factor *F, double *x);
void band_solve_upper(const struct band_factor *F, double *x);

/* A := L D L^T in place, L unit lower, D on the diagonal; without LAPACK: for small matrices that
 * are factored often.  kd is 3, 7 or 11.  SW_INDEFINITE if a pivot is not positive; A is then
 * spoilt. x := A^{-1} x by it. */
enum status band_factor_in_place(struct band *A);
void band_solve_in_place(const struct band *A, double *x);

/* How many eigenvalues of A x = lambda B x (B positive definite, half bandwidth not above A's, at
 * most BAND_COUNT_KD) lie below sigma: the negative pivots of A - sigma B = L D L^T (Sylvester).
 * Exact for a pencil that is perturbed by round-off.  No allocation. */
#define BAND_COUNT_KD 11
int band_count_below(const struct band *A, const struct band *B, double sigma);

#endif
