/* Sparse symmetric systems. */
#include "num/sparse.h"
#include "num/dense.h"
#include "num/mem.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif
#include <suitesparse/cholmod.h>

#define NESTED 20000   /* unknowns */
#define ROUNDING 1e-15 /* of a diagonal entry: a pivot that is none */

struct sparse_solver {
    cholmod_common common;
    cholmod_factor *factor;
};

/* Columns of the places and of the diagonal, sorted, each once.  count: (n + 1) work space. */
static void lay_columns(int n, const struct place *place, size_t n_places, struct sparse *A)
{
    size_t total = 0, kept = 0;
    int *next = A->column;

    for (size_t k = 0; k < n_places; k++)
        next[place[k].column + 1]++;
    for (int j = 0; j < n; j++)
        next[j + 1] += next[j] + 1;
    for (int j = n; j > 0; j--) /* first entry of each column: where its end will come to stand */
        next[j] = next[j - 1];
    next[0] = 0;
    for (int j = 0; j < n; j++)
        A->row[next[j + 1]++] = j;
    for (size_t k = 0; k < n_places; k++)
        A->row[next[place[k].column + 1]++] = place[k].row;
    for (int j = 0; j < n; j++) {
        size_t first = total, end = (size_t)next[j + 1];

        total = end;
        next[j] = (int)kept;
        for (size_t i = first + 1; i < end; i++) { /* by insertion: columns are short */
            int r = A->row[i];
            size_t at = i;

            for (; at > first && A->row[at - 1] > r; at--)
                A->row[at] = A->row[at - 1];
            A->row[at] = r;
        }
        for (size_t i = first; i < end; i++)
            if (i == first || A->row[i] != A->row[i - 1])
                A->row[kept++] = A->row[i];
    }
    next[n] = (int)kept;
    A->entries = kept;
}

enum status sparse_new(int n, const struct place *place, size_t n_places, int *ret_at,
                       struct sparse *ret)
{
    size_t room = n_places + (size_t)n;

    *ret = (struct sparse){.n = n};
    ret->column = mem_zeroed((size_t)n + 2, sizeof *ret->column);
    ret->row = mem_zeroed(room, sizeof *ret->row);
    if (!ret->column || !ret->row || room >= INT_MAX) {
        sparse_free(ret);
        return SW_NOMEM;
    }
    lay_columns(n, place, n_places, ret);
    ret->value = mem_doubles(ret->entries);
    ret->solver = mem_zeroed(1, sizeof *ret->solver);
    if (!ret->value || !ret->solver) {
        sparse_free(ret);
        return SW_NOMEM;
    }
    dense_threads(1); /* supernodes are too small to share: threads would wait for each other */
    cholmod_start(&ret->solver->common);
    ret->solver->common.print = 0;
    ret->solver->common.supernodal = CHOLMOD_AUTO;
    ret->solver->common.final_ll = 1; /* L L^T also of small ones: L D L^T takes negative pivots */
    ret->solver->common.nmethods = 1; /* nested dissection costs more once, and saves a third of
                                         each factor */
    ret->solver->common.method[0].ordering = n > NESTED ? CHOLMOD_METIS : CHOLMOD_AMD;
    ret->solver->common.postorder = 1;
    for (size_t k = 0; k < n_places; k++)
        ret_at[k] = sparse_at(ret, place[k].row, place[k].column);
    return SW_OK;
}

void sparse_free(struct sparse *A)
{
    if (A->solver) {
        cholmod_free_factor(&A->solver->factor, &A->solver->common);
        cholmod_finish(&A->solver->common);
    }
    free(A->solver);
    free(A->column);
    free(A->row);
    free(A->value);
    *A = (struct sparse){0};
}

int sparse_at(const struct sparse *A, int row, int column)
{
    int low = A->column[column], high = A->column[column + 1] - 1;

    while (low <= high) {
        int middle = low + (high - low) / 2;

        if (A->row[middle] == row)
            return middle;
        if (A->row[middle] < row)
            low = middle + 1;
        else
            high = middle - 1;
    }
    return -1;
}

static cholmod_sparse view(struct sparse *A)
{
    return (cholmod_sparse){.nrow = (size_t)A->n,
                            .ncol = (size_t)A->n,
                            .nzmax = A->entries,
                            .p = A->column,
                            .i = A->row,
                            .x = A->value,
                            .stype = -1,
                            .itype = CHOLMOD_INT,
                            .xtype = CHOLMOD_REAL,
                            .dtype = CHOLMOD_DOUBLE,
                            .sorted = 1,
                            .packed = 1};
}

static enum status status_of(const cholmod_common *c)
{
    return c->status == CHOLMOD_OUT_OF_MEMORY || c->status == CHOLMOD_TOO_LARGE ? SW_NOMEM : SW_OK;
}

/* CHOLMOD copies supernodes in teams of four threads, however few cores there are and however small
 * the supernodes: it is quicker alone.  Returns what to restore. */
static int levels(int now)
{
#ifdef _OPENMP
    int before = omp_get_max_active_levels();

    omp_set_max_active_levels(now);
    return before;
#else
    return now;
#endif
}

/* Analyse once, factor; SW_NOMEM, SW_INDEFINITE with A->failed as CHOLMOD sees it. */
static enum status factor(struct sparse *A)
{
    struct sparse_solver *s = A->solver;
    cholmod_sparse a = view(A);
    int before;

    A->failed = -1;
    for (size_t i = 0; i < A->entries; i++)
        if (!(A->value[i] - A->value[i] == 0)) /* NaN or infinite */
            return SW_INDEFINITE;
    if (!s->factor)
        s->factor = cholmod_analyze(&a, &s->common);
    if (!s->factor)
        return SW_NOMEM;
    before = levels(0);
    cholmod_factorize(&a, s->factor, &s->common);
    levels(before);
    if (status_of(&s->common) != SW_OK)
        return SW_NOMEM;
    if (s->common.status == CHOLMOD_NOT_POSDEF || s->factor->minor < (size_t)A->n) {
        A->failed =
            s->factor->minor < (size_t)A->n ? ((const int *)s->factor->Perm)[s->factor->minor] : -1;
        return SW_INDEFINITE;
    }
    return SW_OK;
}

enum status sparse_factor(struct sparse *A)
{
    A->failed = -1;
    return A->n > 0 ? factor(A) : SW_OK;
}

enum status sparse_factor_signed(struct sparse *A, int *ret_negative)
{
    cholmod_common *c = &A->solver->common;
    enum status s;

    *ret_negative = 0;
    if (A->n == 0)
        return SW_OK;
    if (!A->solver->factor) { /* supernodes know no D; chains want no nested dissection */
        c->supernodal = CHOLMOD_SIMPLICIAL;
        c->final_ll = 0;
        c->method[0].ordering = CHOLMOD_AMD;
    }
    s = factor(A);
    A->least = INFINITY;
    for (int j = 0; j < A->n && s == SW_OK; j++) {
        const cholmod_factor *f = A->solver->factor;
        double D = ((const double *)f->x)[((const int *)f->p)[j]];
        int own = ((const int *)f->Perm)[j];
        double part = fabs(D) / fabs(A->value[A->column[own]]);

        *ret_negative += D < 0;
        if (!(part >= A->least)) {
            A->least = part;
            A->weakest = own;
        }
    }
    if (s == SW_OK && !(A->least > ROUNDING)) {
        A->failed = A->weakest;
        s = SW_INDEFINITE;
    }
    return s;
}

void sparse_multiply_add(const struct sparse *A, double c, const double *x, double *y)
{
    for (int j = 0; j < A->n; j++) {
        int at = A->column[j]; /* the diagonal comes first */

        y[j] += c * A->value[at] * x[j];
        for (at++; at < A->column[j + 1]; at++) {
            y[A->row[at]] += c * A->value[at] * x[j];
            y[j] += c * A->value[at] * x[A->row[at]];
        }
    }
}

enum status sparse_solve(struct sparse *A, int columns, double *x)
{
    struct sparse_solver *s = A->solver;
    size_t n = (size_t)A->n, size = n * (size_t)columns;
    cholmod_dense b = {.nrow = n,
                       .ncol = (size_t)columns,
                       .nzmax = size,
                       .d = n,
                       .x = x,
                       .xtype = CHOLMOD_REAL,
                       .dtype = CHOLMOD_DOUBLE};
    cholmod_dense *y;

    if (A->n == 0)
        return SW_OK;
    y = cholmod_solve(CHOLMOD_A, s->factor, &b, &s->common);
    if (!y)
        return SW_NOMEM;
    memcpy(x, y->x, size * sizeof *x);
    cholmod_free_dense(&y, &s->common);
    return SW_OK;
}
