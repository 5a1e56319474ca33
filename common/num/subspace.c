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
#define APART 1e-7      /* below the last eigenvalue: what multiple ones differ by at most */

struct run {
    struct sparse *K;
    const double *M;
    double *own;   /* K's values */
    int n, k, p;   /* p vectors are iterated */
    double shift;  /* K + shift M is positive definite */
    double *x, *y; /* (n, p) */
    double *A, *B; /* (p, p) */
    double *ritz, *before;
};

static void run_free(struct run *r)
{
    if (r->own)
        memcpy(r->K->value, r->own, r->K->entries * sizeof *r->own);
    free(r->own);
    free(r->x);
    free(r->y);
    free(r->A);
    free(r->B);
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
    r->A = mem_doubles(columns * columns);
    r->B = mem_doubles(columns * columns);
    r->ritz = mem_doubles(columns);
    r->before = mem_doubles(columns);
    return r->own && r->x && r->y && r->A && r->B && r->ritz && r->before ? SW_OK : SW_NOMEM;
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

/* y = M x. */
static void multiply(const struct run *r, const double *x, double *y)
{
    struct sparse M = *r->K;
    size_t n = (size_t)r->n;

    M.value = (double *)(uintptr_t)r->M;
    memset(y, 0, n * (size_t)r->p * sizeof *y);
    for (int j = 0; j < r->p; j++)
        sparse_multiply_add(&M, 1, x + n * (size_t)j, y + n * (size_t)j);
}

static void project(const struct run *r, const double *x, const double *y, double *A)
{
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, r->p, r->p, r->n, 1, x, r->n, y, r->n, 0,
                A, r->p);
}

/* x := (K + shift M)^-1 M x, turned to its Ritz vectors; y is lost. */
static enum status iterate(struct run *r)
{
    size_t size = (size_t)r->n * (size_t)r->p;
    enum status s;

    multiply(r, r->x, r->y);
    memcpy(r->x, r->y, size * sizeof *r->x);
    s = sparse_solve(r->K, r->p, r->x);
    if (s != SW_OK)
        return s;
    project(r, r->x, r->y, r->A); /* y = (K + shift M) x */
    multiply(r, r->x, r->y);
    project(r, r->x, r->y, r->B);
    s = dense_pencil(r->p, r->A, r->B, r->ritz);
    if (s != SW_OK)
        return s == SW_NOMEM ? s : SW_INDEFINITE;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, r->n, r->p, r->p, 1, r->x, r->n, r->A,
                r->p, 0, r->y, r->n);
    memcpy(r->x, r->y, size * sizeof *r->x);
    return SW_OK;
}

static int settled(const struct run *r)
{
    for (int i = 0; i < r->k; i++)
        if (!(fabs(r->ritz[i] - r->before[i]) <= TOLERANCE * r->ritz[i]))
            return 0;
    return 1;
}

/* Fewer than k lie below the last one. */
static enum status check(struct run *r)
{
    int below;
    enum status s = factor(r, r->shift - r->ritz[r->k - 1] * (1 - APART), &below);

    if (s == SW_INDEFINITE)
        return SW_OK; /* on an eigenvalue: nothing to be learnt */
    return s == SW_OK && below >= r->k ? SW_NOCONV : s;
}

enum status subspace_lowest(struct sparse *K, const double *M, int k, double *lambda, double *x)
{
    struct run r;
    enum status s = run_new(K, M, k, &r);
    int round = 0;

    if (s == SW_OK)
        s = find_shift(&r);
    if (s == SW_OK)
        start(&r);
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
        lambda[i] = r.ritz[i] - r.shift;
    if (s == SW_OK)
        memcpy(x, r.x, (size_t)r.n * (size_t)k * sizeof *x);
    run_free(&r);
    return s;
}
