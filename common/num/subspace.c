/* Lowest eigenpairs of a sparse pencil. */
#include "num/subspace.h"
#include "num/dense.h"
#include "num/mem.h"

#include <cblas.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define ROUNDS 200
#define TOLERANCE 1e-12 /* relative change of the shifted eigenvalues */
#define GAP 1e-6        /* of an eigenvalue: what is narrower may be rounding between equal ones */
#define NOTHING 1e-12   /* of a vector is left: it lies in the others, or moves no mass */

struct run {
    struct sparse *K;
    const double *M;
    double *own;           /* K's values */
    int n, k, p;           /* p vectors are iterated */
    double shift;          /* K + shift M is positive definite */
    double *x, *y;         /* (n, p) X^T M X = I, M X */
    double *z;             /* (n, p) */
    double *C;             /* (p, p) */
    double *ritz, *before; /* (p) eigenvalues of (K + shift M)^-1 M, descending */
};

static void run_free(struct run *r)
{
    if (r->own)
        memcpy(r->K->value, r->own, r->K->entries * sizeof *r->own);
    free(r->own);
    free(r->x);
    free(r->y);
    free(r->z);
    free(r->C);
    free(r->ritz);
    free(r->before);
}

static enum status run_new(struct sparse *K, const double *M, int k, struct run *r)
{
    int p = 2 * k + 8 < K->n ? 2 * k + 8 : K->n;
    size_t n = (size_t)K->n, columns = (size_t)p;

    *r = (struct run){.K = K, .M = M, .n = K->n, .k = k, .p = p};
    r->own = mem_copy(K->value, K->entries * sizeof *K->value);
    r->x = mem_doubles(n * columns);
    r->y = mem_doubles(n * columns);
    r->z = mem_doubles(n * columns);
    r->C = mem_doubles(columns * columns);
    r->ritz = mem_doubles(columns);
    r->before = mem_doubles(columns);
    return r->own && r->x && r->y && r->z && r->C && r->ritz && r->before ? SW_OK : SW_NOMEM;
}

/* Factor K + shift M; how many eigenvalues lie below -shift.  A pivot that is rounding is met on an
 * eigenvalue alone: SW_INDEFINITE. */
static enum status factor(struct run *r, double shift, int *ret_below)
{
    for (size_t i = 0; i < r->K->entries; i++)
        r->K->value[i] = r->own[i] + shift * r->M[i];
    return sparse_factor_signed(r->K, ret_below);
}

/* The scale of the k-th eigenvalue by counting down from the stiffest unknown, then a shift far
 * below it that makes all positive. */
static enum status find_shift(struct run *r)
{
    double top = 0;
    int below = r->n;
    enum status s = SW_OK;

    for (int j = 0; j < r->n; j++) {
        int at = r->K->column[j];

        if (r->M[at] < 0)
            return SW_INDEFINITE;
        if (r->M[at] > 0)
            top = fmax(top, fabs(r->own[at]) / r->M[at]);
    }
    if (!(top > 0 && top < INFINITY))
        return SW_INDEFINITE;
    for (int i = 0; i < 40 && below >= r->k && (s == SW_OK || s == SW_INDEFINITE); i++) {
        s = factor(r, -top, &below);
        if (s == SW_INDEFINITE) /* on an eigenvalue */
            below = r->k;
        top /= below >= r->k ? 10 : 1;
    }
    r->shift = 0.1 * top; /* the k-th one lies within 1 and 10 top */
    do {
        s = factor(r, r->shift, &below);
        r->shift *= s == SW_OK && below == 0 ? 1 : 10;
    } while ((s == SW_INDEFINITE || (s == SW_OK && below > 0)) && r->shift < INFINITY);
    return s;
}

static void start(struct run *r)
{
    uint64_t state = 88172645463325252;

    for (size_t i = 0; i < (size_t)r->n * (size_t)r->p; i++) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        r->x[i] = (double)(state >> 11) * 0x1p-53 - 0.5;
    }
}

static double *column(const struct run *r, double *of, int j)
{
    return of + (size_t)r->n * (size_t)j;
}

/* y_j = M x_j. */
static void multiply(struct run *r, int j)
{
    struct sparse M = *r->K;

    M.value = (double *)(uintptr_t)r->M; /* is only read */
    memset(column(r, r->y, j), 0, (size_t)r->n * sizeof *r->y);
    sparse_multiply_add(&M, 1, column(r, r->x, j), column(r, r->y, j));
}

/* X^T M X = I, y = M X: Gram and Schmidt, twice.  What is nothing but rounding ends the basis. */
static enum status orthonormalize(struct run *r)
{
    for (int j = 0; j < r->p; j++) {
        double *x = column(r, r->x, j), before, after;

        multiply(r, j);
        before = cblas_ddot(r->n, x, 1, column(r, r->y, j), 1);
        for (int twice = 0; twice < 2 && j > 0; twice++) {
            cblas_dgemv(CblasColMajor, CblasTrans, r->n, j, 1, r->y, r->n, x, 1, 0, r->C, 1);
            cblas_dgemv(CblasColMajor, CblasNoTrans, r->n, j, -1, r->x, r->n, r->C, 1, 1, x, 1);
        }
        multiply(r, j);
        after = cblas_ddot(r->n, x, 1, column(r, r->y, j), 1);
        if (!(after > NOTHING * NOTHING * before) || !(before < INFINITY)) {
            r->p = j;
            return j < r->k ? SW_INDEFINITE : SW_OK;
        }
        cblas_dscal(r->n, 1 / sqrt(after), x, 1);
        cblas_dscal(r->n, 1 / sqrt(after), column(r, r->y, j), 1);
    }
    return SW_OK;
}

/* x := (K + shift M)^-1 M x, turned to its Ritz vectors, the largest first. */
static enum status iterate(struct run *r)
{
    size_t size = (size_t)r->n * (size_t)r->p;
    int p = r->p;
    enum status s;

    memcpy(r->z, r->y, size * sizeof *r->z);
    s = sparse_solve(r->K, p, r->z);
    if (s != SW_OK)
        return s;
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, p, p, r->n, 1, r->y, r->n, r->z, r->n, 0,
                r->C, p);
    s = dense_symmetric(p, r->C, r->ritz);
    if (s != SW_OK)
        return s;
    for (int i = 0; i < p / 2; i++) { /* ascending to descending */
        double swap = r->ritz[i];

        r->ritz[i] = r->ritz[p - 1 - i];
        r->ritz[p - 1 - i] = swap;
        cblas_dswap(p, r->C + (size_t)(p * i), 1, r->C + (size_t)(p * (p - 1 - i)), 1);
    }
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, r->n, p, p, 1, r->z, r->n, r->C, p, 0,
                r->x, r->n);
    return orthonormalize(r);
}

static int settled(const struct run *r)
{
    for (int i = 0; i < r->k; i++)
        if (!(fabs(r->ritz[i] - r->before[i]) <= TOLERANCE * r->ritz[i]))
            return 0;
    return 1;
}

/* As many eigenvalues lie below the widest gap among the upper ones as were found there: with stiff
 * and long structures a count next to an eigenvalue would see the rounding of the stiffest one. */
static enum status check(struct run *r)
{
    double widest = GAP, middle = 0;
    int below, found = 0;
    enum status s;

    for (int j = (r->k - 1) / 2; j < r->k && j + 1 < r->p; j++) {
        double here = 1 / r->ritz[j], next = 1 / r->ritz[j + 1];

        if (next - here > widest * next) {
            widest = (next - here) / next;
            middle = (here + next) / 2;
            found = j + 1;
        }
    }
    if (found == 0)
        return SW_OK;
    s = factor(r, r->shift - middle, &below);
    if (s == SW_INDEFINITE)
        return SW_OK; /* on an eigenvalue: nothing to be learnt */
    return s == SW_OK && below > found ? SW_NOCONV : s;
}

enum status subspace_lowest(struct sparse *K, const double *M, int k, double *lambda, double *x)
{
    struct run r;
    enum status s = run_new(K, M, k, &r);
    int round = 0;

    if (s == SW_OK)
        s = find_shift(&r);
    if (s == SW_OK) {
        start(&r);
        s = orthonormalize(&r);
    }
    while (s == SW_OK) {
        s = iterate(&r);
        if (s == SW_OK && settled(&r))
            break;
        memcpy(r.before, r.ritz, (size_t)r.p * sizeof *r.ritz);
        if (s == SW_OK && ++round == ROUNDS)
            s = SW_NOCONV;
    }
    if (s == SW_OK)
        s = check(&r);
    for (int i = 0; i < k && s == SW_OK; i++)
        lambda[i] = 1 / r.ritz[i] - r.shift;
    if (s == SW_OK)
        memcpy(x, r.x, (size_t)r.n * (size_t)k * sizeof *x);
    run_free(&r);
    return s;
}
