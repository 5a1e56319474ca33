/* Symmetric band matrices. */
#include "num/band.h"
#include "num/mem.h"

#include <lapacke.h>
#include <stdlib.h>

double band_get(const struct band *A, int i, int j)
{
    if (i < j) {
        int swap = i;
        i = j;
        j = swap;
    }
    return i - j <= A->kd ? *band_at(A, i, j) : 0;
}

enum status band_new(int n, int kd, struct band *ret)
{
    ret->n = n;
    ret->kd = kd;
    ret->a = mem_doubles((size_t)n * (size_t)(kd + 1));
    return ret->a ? SW_OK : SW_NOMEM;
}

void band_free(struct band *A)
{
    free(A->a);
    A->a = NULL;
}

void band_add_block(struct band *A, int from, int m, const double *E)
{
    for (int j = 0; j < m; j++)
        for (int i = j; i < m; i++)
            *band_at(A, from + i, from + j) += E[i + m * j];
}

void band_multiply_add(const struct band *A, double c, const double *x, double *y)
{
    for (int j = 0; j < A->n; j++) {
        const double *a = band_at(A, j, j);
        int below = A->n - 1 - j < A->kd ? A->n - 1 - j : A->kd;
        double xj = c * x[j], sum = a[0] * xj;

        for (int i = 1; i <= below; i++) {
            sum += c * a[i] * x[j + i];
            y[j + i] += a[i] * xj;
        }
        y[j] += sum;
    }
}

enum status band_combine(double a, const struct band *A, double b, const struct band *B,
                         struct band *ret)
{
    if (band_new(A->n, A->kd, ret) != SW_OK)
        return SW_NOMEM;
    for (int j = 0; j < A->n; j++) {
        double *c = band_at(ret, j, j);

        for (int i = 0; i <= A->kd; i++)
            c[i] = a * band_at(A, j, j)[i];
        for (int i = 0; i <= B->kd; i++)
            c[i] += b * band_at(B, j, j)[i];
    }
    return SW_OK;
}

enum status band_restrict(const struct band *A, const int *keep, int n_keep, struct band *ret)
{
    if (band_new(n_keep, A->kd, ret) != SW_OK)
        return SW_NOMEM;
    for (int j = 0; j < n_keep; j++)
        for (int i = j; i < n_keep && i - j <= A->kd; i++)
            *band_at(ret, i, j) = band_get(A, keep[i], keep[j]);
    return SW_OK;
}

enum status band_cholesky(const struct band *A, struct band_factor *ret)
{
    int n = A->n, kd = A->kd, info;

    ret->l = *A;
    ret->l.a = mem_copy(A->a, sizeof(double) * (size_t)n * (size_t)(kd + 1));
    if (!ret->l.a)
        return SW_NOMEM;
    info = n > 0 ? LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', n, kd, ret->l.a, kd + 1) : 0;
    for (int j = 0; j < n && info == 0; j++) {
        double *diagonal = band_at(&ret->l, j, j);

        if (!(*diagonal > 0))
            info = j + 1;
        *diagonal = 1 / *diagonal;
    }
    if (info != 0)
        band_factor_free(ret);
    return info == 0 ? SW_OK : SW_INDEFINITE;
}

void band_factor_free(struct band_factor *F)
{
    band_free(&F->l);
}

/* x := L^{-1} x by columns; the caller's constant kd lets the compiler unroll the inner loop. */
static inline void lower(const struct band *L, int kd, double *x)
{
    int n = L->n, whole = n > kd ? n - kd : 0;
    const double *l = L->a;

    for (int j = 0; j < n; j++, l += kd + 1) {
        int below = j < whole ? kd : n - 1 - j;
        double xj = x[j] *= l[0];

        for (int i = 1; i <= below; i++)
            x[j + i] -= l[i] * xj;
    }
}

/* x := L^{-T} x by scalar products, the freshest entry last: it alone is waited for. */
static inline void upper(const struct band *L, int kd, double *x)
{
    int n = L->n;

    for (int j = n - 1; j >= 0; j--) {
        const double *l = L->a + (size_t)(kd + 1) * (size_t)j;
        int below = n - 1 - j < kd ? n - 1 - j : kd;
        double sum = x[j];

        for (int i = below; i >= 1; i--)
            sum -= l[i] * x[j + i];
        x[j] = sum * l[0];
    }
}

static void lower_any(const struct band *L, double *x)
{
    switch (L->kd) {
    case 3: lower(L, 3, x); break;
    case 7: lower(L, 7, x); break;
    case 11: lower(L, 11, x); break;
    default: lower(L, L->kd, x);
    }
}

static void upper_any(const struct band *L, double *x)
{
    switch (L->kd) {
    case 3: upper(L, 3, x); break;
    case 7: upper(L, 7, x); break;
    case 11: upper(L, 11, x); break;
    default: upper(L, L->kd, x);
    }
}

void band_solve(const struct band_factor *F, double *x)
{
    lower_any(&F->l, x);
    upper_any(&F->l, x);
}

void band_lower_solve(const struct band_factor *F, int m, double *B)
{
    for (int k = 0; k < m; k++)
        lower_any(&F->l, B + (size_t)F->l.n * (size_t)k);
}

void band_upper_solve(const struct band_factor *F, int m, double *B)
{
    for (int k = 0; k < m; k++)
        upper_any(&F->l, B + (size_t)F->l.n * (size_t)k);
}
