/* Householder QR with column pivoting, and what it solves. */
#include "num/nullspace.h"

#include "num/jacobi.h"

#include <math.h>
#include <string.h>

/* x := x - 2 v (v.x)/(v.v) over entries k to n - 1. */
static void reflect(int n, int k, const double *v, double vv, double *x)
{
    double sum = 0;

    for (int i = k; i < n; i++)
        sum += v[i] * x[i];
    sum *= 2 / vv;
    for (int i = k; i < n; i++)
        x[i] -= sum * v[i];
}

static double square(int n, int k, const double *x)
{
    double sum = 0;

    for (int i = k; i < n; i++)
        sum += x[i] * x[i];
    return sum;
}

/* The column from k on that has most left below row k; its length there. */
static double pivot(const struct nullspace *f, int k, const double *A, int *ret)
{
    double most = -1;

    for (int j = k; j < f->m; j++) {
        double s = square(f->n, k, A + j * f->n);

        if (!(s <= most)) {
            most = s;
            *ret = j;
        }
    }
    return sqrt(most);
}

static void swap_columns(struct nullspace *f, double *A, int p, int q)
{
    int column = f->column[p];

    f->column[p] = f->column[q];
    f->column[q] = column;
    for (int i = 0; i < f->n; i++) {
        double a = A[i + p * f->n];

        A[i + p * f->n] = A[i + q * f->n];
        A[i + q * f->n] = a;
    }
}

/* Column k of A below row k becomes (-+length, 0, ...); the reflection goes into Q as well. */
static void eliminate(struct nullspace *f, double *A, int k, double length)
{
    double v[NULLSPACE_MOST] = {0}, vv;
    int n = f->n;

    memcpy(v + k, A + k + k * n, (size_t)(n - k) * sizeof *v);
    v[k] += copysign(length, v[k]);
    vv = square(n, k, v);
    for (int j = k; j < f->m; j++)
        reflect(n, k, v, vv, A + j * n);
    for (int i = 0; i < n; i++) { /* Q := Q H, row by row */
        double sum = 0;

        for (int j = k; j < n; j++)
            sum += f->Q[i + j * n] * v[j];
        sum *= 2 / vv;
        for (int j = k; j < n; j++)
            f->Q[i + j * n] -= sum * v[j];
    }
}

void nullspace_of(int n, int m, double *A, double tolerance, struct nullspace *ret)
{
    double longest = 0;

    ret->n = n;
    ret->m = m;
    ret->rank = 0;
    for (int i = 0; i < n * n; i++)
        ret->Q[i] = i % (n + 1) == 0;
    for (int j = 0; j < m; j++)
        ret->column[j] = j;
    while (ret->rank < m && ret->rank < n) {
        int k = ret->rank, j = k;
        double length = pivot(ret, k, A, &j);

        longest = fmax(longest, length);
        if (!(length > tolerance * longest))
            break;
        swap_columns(ret, A, k, j);
        eliminate(ret, A, k, length);
        ret->rank++;
    }
    memcpy(ret->R, A, (size_t)(n * m) * sizeof *A);
}

/* y := Q^T b, the first rank entries. */
static void project(const struct nullspace *f, const double *b, double *y)
{
    for (int j = 0; j < f->rank; j++) {
        y[j] = 0;
        for (int i = 0; i < f->n; i++)
            y[j] += f->Q[i + j * f->n] * b[i];
    }
}

/* R x = y for rank = m: back substitution. */
static void substitute(const struct nullspace *f, double *y)
{
    for (int i = f->rank - 1; i >= 0; i--) {
        for (int j = i + 1; j < f->rank; j++)
            y[i] -= f->R[i + j * f->n] * y[j];
        y[i] /= f->R[i + i * f->n];
    }
}

/* x = R^T (R R^T)^{-1} y, the shortest solution of R x = y, with one step of refinement. */
static void shortest(const struct nullspace *f, const double *y, double *x)
{
    double G[NULLSPACE_MOST * NULLSPACE_MOST], r[NULLSPACE_MOST];
    int k = f->rank, n = f->n;

    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++) {
            G[i + j * k] = 0;
            for (int l = i > j ? i : j; l < f->m; l++)
                G[i + j * k] += f->R[i + l * n] * f->R[j + l * n];
        }
    (void)cholesky_factor(k, G, 0); /* full rank: it cannot fail */
    memset(x, 0, (size_t)f->m * sizeof *x);
    for (int turn = 0; turn < 2; turn++) {
        for (int i = 0; i < k; i++) {
            r[i] = y[i];
            for (int l = i; l < f->m; l++)
                r[i] -= f->R[i + l * n] * x[l];
        }
        cholesky_forward(k, G, r);
        cholesky_backward(k, G, r);
        for (int l = 0; l < f->m; l++)
            for (int i = 0; i < k && i <= l; i++)
                x[l] += f->R[i + l * n] * r[i];
    }
}

void nullspace_solve(const struct nullspace *f, const double *b, double *x)
{
    double y[NULLSPACE_MOST], z[NULLSPACE_MOST];

    project(f, b, y);
    if (f->rank == f->m) {
        substitute(f, y);
        memcpy(z, y, (size_t)f->m * sizeof *z);
    } else {
        shortest(f, y, z);
    }
    for (int j = 0; j < f->m; j++)
        x[f->column[j]] = z[j];
}

void nullspace_transposed(const struct nullspace *f, const double *c, double *y)
{
    double z[NULLSPACE_MOST];

    for (int j = 0; j < f->rank; j++) { /* R^T z = P^T c */
        z[j] = c[f->column[j]];
        for (int i = 0; i < j; i++)
            z[j] -= f->R[i + j * f->n] * z[i];
        z[j] /= f->R[j + j * f->n];
    }
    for (int i = 0; i < f->n; i++) {
        y[i] = 0;
        for (int j = 0; j < f->rank; j++)
            y[i] += f->Q[i + j * f->n] * z[j];
    }
}
