/*
 * Sparse symmetric systems, positive definite or not, by CHOLMOD: pattern analysed once, factored
 * often.
 *
 * The lower half is stored by columns.  A sparse matrix is owned by the struct; sparse_free takes a
 * zeroed struct, too.
 */
#ifndef SEILWERK_NUM_SPARSE_H
#define SEILWERK_NUM_SPARSE_H

#include "num/status.h"

#include <stddef.h>

struct sparse_solver; /* CHOLMOD's, private */

struct sparse {
    int n; /* order */
    size_t entries;
    int *column;   /* (n + 1) first entry of each column */
    int *row;      /* (entries) ascending within a column */
    double *value; /* (entries) */
    struct sparse_solver *solver;
    int failed;   /* column at which the last factorization stopped, or */
    double least; /* smallest pivot of sparse_factor_signed over its diagonal entry, */
    int weakest;  /* in this column */
};

/* A place (row, column) of a matrix. */
struct place {
    int row, column;
};

/* A zero matrix with entries at these places (row >= column, any order, again and again) and on the
 * diagonal; ret_at[k] is where place k stands in value.  SW_NOMEM. */
enum status sparse_new(int n, const struct place *place, size_t n_places, int *ret_at,
                       struct sparse *ret);

void sparse_free(struct sparse *A);

/* Where (row, column), row >= column, stands in value; -1: nowhere. */
int sparse_at(const struct sparse *A, int row, int column);

/* Factor A as its values are.  SW_INDEFINITE with A->failed; SW_NOMEM. */
enum status sparse_factor(struct sparse *A);

/*
 * Factor A = L D L^T as its values are, in the order of the pattern (no pivoting); *ret_negative
 * pivots are: so many eigenvalues of A (Sylvester).  SW_INDEFINITE with A->failed: a pivot is
 * nothing but rounding (below 1e-15 of its diagonal entry), or a value is not finite; SW_NOMEM.
 * Of one matrix either this or sparse_factor is called.
 */
enum status sparse_factor_signed(struct sparse *A, int *ret_negative);

/* y += c A x. */
void sparse_multiply_add(const struct sparse *A, double c, const double *x, double *y);

/* x := A^{-1} x for columns of n numbers, by the last factor.  SW_NOMEM. */
enum status sparse_solve(struct sparse *A, int columns, double *x);

#endif
