/* All eigenpairs of a band pencil: dense solution, then the low end polished with the band. */
#include "num/pencil.h"
#include "num/dense.h"
#include "num/mem.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

/* Lower triangle of A, dense (n, n), the rest left alone. */
static void unpack(const struct band *A, double *dense)
{
    for (int j = 0; j < A->n; j++)
        for (int i = j; i < A->n && i - j <= A->kd; i++)
            dense[(size_t)i + (size_t)A->n * (size_t)j] = *band_at(A, i, j);
}

static int all_finite(const struct band *A)
{
    size_t size = (size_t)A->n * (size_t)(A->kd + 1);

    for (size_t i = 0; i < size; i++)
        if (!isfinite(A->a[i]))
            return 0;
    return 1;
}

/* Number of eigenvalues up to the geometric mean of the smallest and the largest one.  Round-off
 * may have made the smallest ones zero or negative: then all of them are polished. */
static int low_end(int n, const double *lambda)
{
    double limit = lambda[0] > 0 ? sqrt(lambda[0]) * sqrt(lambda[n - 1]) : INFINITY;
    int p = 0;

    while (p < n && (lambda[p] <= limit || (p > 0 && lambda[p] <= lambda[p - 1] * (1 + 1e-6))))
        p++; /* never between two that are nearly equal: the polished ones must stay in order */
    return p;
}

/*
 * One step of subspace iteration on the p lowest pairs: Y = K^{-1} M X diag(lambda), Ritz pencil
 * (Y^T M Y) z = nu (Y^T K Y) z, nu = 1/lambda, X := Y z/sqrt(z^T Y^T M Y z).
 * work: 2 n p + 2 p^2 + p doubles.
 */
static enum status polish(const struct band_factor *F, const struct band *M, int p, double *lambda,
                          double *x, double *work)
{
    int n = M->n;
    size_t np = (size_t)n * (size_t)p, pp = (size_t)p * (size_t)p;
    double *Y = work, *Z = work + np, *Ky = Z + np, *My = Ky + pp, *nu = My + pp;
    enum status s;

    for (int k = 0; k < p; k++) {
        double *y = Y + (size_t)n * (size_t)k, *z = Z + (size_t)n * (size_t)k;

        band_multiply_add(M, lambda[k] > 0 ? lambda[k] : 1, x + (size_t)n * (size_t)k, y);
        for (int i = 0; i < n; i++)
            z[i] = y[i]; /* K y, known before y itself */
        band_solve(F, y);
    }
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, p, p, n, 1, Y, n, Z, n, 0, Ky, p);
    for (size_t i = 0; i < np; i++)
        Z[i] = 0;
    for (int k = 0; k < p; k++)
        band_multiply_add(M, 1, Y + (size_t)n * (size_t)k, Z + (size_t)n * (size_t)k);
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, p, p, n, 1, Y, n, Z, n, 0, My, p);
    s = dense_pencil(p, My, Ky, nu);
    if (s != SW_OK)
        return s;
    for (int k = 0; k < p; k++) { /* nu ascends, lambda = 1/nu shall ascend: turn the order */
        int from = p - 1 - k;

        lambda[k] = 1 / nu[from];
        cblas_dgemv(CblasColMajor, CblasNoTrans, n, p, sqrt(lambda[k]), Y, n,
                    My + (size_t)p * (size_t)from, 1, 0, x + (size_t)n * (size_t)k, 1);
    }
    return SW_OK;
}

/* The p lowest pairs, polished in the place of the rough ones. */
static enum status polish_low(const struct band *K, const struct band *M, int p, double *lambda,
                              double *x)
{
    struct band_factor F;
    enum status s = band_cholesky(K, &F);
    double *work;

    if (s != SW_OK)
        return s;
    work = mem_doubles(2 * (size_t)K->n * (size_t)p + 2 * (size_t)p * (size_t)p + (size_t)p);
    s = work ? polish(&F, M, p, lambda, x, work) : SW_NOMEM;
    free(work);
    band_factor_free(&F);
    return s;
}

enum status pencil_all(const struct band *K, const struct band *M, double *lambda, double *x)
{
    int n = K->n;
    size_t nn = (size_t)n * (size_t)n;
    double *B;
    enum status s;

    if (!all_finite(K) || !all_finite(M))
        return SW_INDEFINITE;
    B = mem_doubles(nn);
    if (!B)
        return SW_NOMEM;
    for (size_t i = 0; i < nn; i++)
        x[i] = 0;
    unpack(K, x);
    unpack(M, B);
    s = dense_pencil(n, x, B, lambda);
    free(B);
    if (s == SW_OK)
        s = polish_low(K, M, low_end(n, lambda), lambda, x);
    return s;
}
