/* Lowest eigenpairs of a band pencil: ARPACK on the inverse of its stiffness. */
#include "num/lanczos.h"
#include "num/mem.h"

#include <arpack/arpack.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* The Fortran routine itself, with the lengths of its three texts: arpack.h's dseupd_c requests
 * memory and does not look whether it got any. */
void dseupd_(const int *rvec, const char *howmny, int *select, double *d, double *z, const int *ldz,
             const double *sigma, const char *bmat, const int *n, const char *which, const int *nev,
             const double *tol, double *resid, const int *ncv, double *v, const int *ldv,
             int *iparam, int *ipntr, double *workd, double *workl, const int *lworkl, int *info,
             size_t, size_t, size_t);

#define MAX_RESTARTS 300
#define TOLERANCE 1e-12 /* of each 1/lambda, and so of the residual of its vector */

#define MOST_VECTORS 46336 /* ARPACK counts its work array, v (v + 8), in an int */

/* What the reverse communication works on. */
struct run {
    const struct band *M;
    struct band_factor F;
    int n, k, vectors; /* Lanczos vectors kept */
    double *resid, *basis, *workd, *workl, *work;
    int *chosen;
    int iparam[11], ipntr[14];
};

int lanczos_most(int n)
{
    return n > 3 ? n - 2 : 0;
}

/* Few restarts, little work on the basis: seen best of k + 12 to 2 k + 20. */
static int vectors_for(int k, int n)
{
    int wanted = 2 * k + 10;

    return wanted < n ? wanted : n;
}

static void run_free(struct run *r)
{
    band_factor_free(&r->F);
    free(r->resid);
    free(r->basis);
    free(r->workd);
    free(r->workl);
    free(r->work);
    free(r->chosen);
}

static enum status run_new(const struct band *K, const struct band *M, int k, struct run *r)
{
    size_t n = (size_t)K->n, vectors;

    *r = (struct run){.M = M, .n = K->n, .k = k, .vectors = vectors_for(k, K->n)};
    vectors = (size_t)r->vectors;
    if (vectors > MOST_VECTORS)
        return SW_NOMEM;
    r->resid = mem_doubles(n);
    r->basis = mem_doubles(n * vectors);
    r->workd = mem_doubles(3 * n);
    r->workl = mem_doubles(vectors * (vectors + 8));
    r->work = mem_doubles(n);
    r->chosen = mem_zeroed(vectors, sizeof *r->chosen);
    r->iparam[0] = 1; /* shifts by ARPACK */
    r->iparam[2] = MAX_RESTARTS;
    r->iparam[6] = 1; /* standard problem */
    if (!r->resid || !r->basis || !r->workd || !r->workl || !r->work || !r->chosen)
        return SW_NOMEM;
    return band_cholesky(K, &r->F);
}

/* y = C^{-1} M C^{-T} x. */
static void apply(const struct run *r, const double *x, double *y)
{
    size_t bytes = sizeof *y * (size_t)r->n;

    memcpy(r->work, x, bytes);
    band_solve_upper(&r->F, r->work);
    memset(y, 0, bytes);
    band_multiply_add(r->M, 1, r->work, y);
    band_solve_lower(&r->F, y);
}

/* The same start in each run: smooth modes and those of a single place alike are in it. */
static void start(struct run *r)
{
    uint64_t state = 88172645463325252;

    for (int i = 0; i < r->n; i++) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        r->resid[i] = (double)(state >> 11) * 0x1p-53 - 0.5;
    }
}

static enum status iterate(struct run *r)
{
    int ido = 0, info = 1, lworkl = r->vectors * (r->vectors + 8);

    start(r);
    for (;;) {
        dsaupd_c(&ido, "I", r->n, "LM", r->k, TOLERANCE, r->resid, r->vectors, r->basis, r->n,
                 r->iparam, r->ipntr, r->workd, r->workl, lworkl, &info);
        if (ido != 1 && ido != -1)
            break;
        apply(r, r->workd + r->ipntr[0] - 1, r->workd + r->ipntr[1] - 1);
    }
    return info == 0 && r->iparam[4] >= r->k ? SW_OK : SW_NOCONV;
}

/* Eigenvalues nu = 1/lambda and vectors y, y^T y = 1, to lambda ascending and x = C^{-T} y with
 * x^T M x = x^T K x/lambda = 1.  */
static enum status extract(struct run *r, double *lambda, double *x)
{
    const int with_vectors = 1, lworkl = r->vectors * (r->vectors + 8), k = r->k;
    const double sigma = 0, tolerance = TOLERANCE;
    double *nu = r->work, *y = r->basis;
    int info = 0;

    dseupd_(&with_vectors, "A", r->chosen, nu, y, &r->n, &sigma, "I", &r->n, "LM", &k, &tolerance,
            r->resid, &r->vectors, r->basis, &r->n, r->iparam, r->ipntr, r->workd, r->workl,
            &lworkl, &info, 1, 1, 2);
    if (info != 0)
        return SW_NOCONV;
    for (int i = 0; i < k; i++) { /* ARPACK's order is ascending in nu, but does not promise it */
        int rank = 0;
        double *to;

        for (int j = 0; j < k; j++)
            rank += nu[j] > nu[i] || (j < i && nu[j] == nu[i]);
        to = x + (size_t)r->n * (size_t)rank;
        if (!(nu[i] > 0))
            return SW_NOCONV;
        lambda[rank] = 1 / nu[i];
        memcpy(to, y + (size_t)r->n * (size_t)i, sizeof *to * (size_t)r->n);
        band_solve_upper(&r->F, to);
        for (int j = 0; j < r->n; j++)
            to[j] *= sqrt(lambda[rank]);
    }
    return SW_OK;
}

enum status lanczos_lowest(const struct band *K, const struct band *M, int k, double *lambda,
                           double *x)
{
    struct run r;
    enum status s = run_new(K, M, k, &r);

    if (s == SW_OK)
        s = iterate(&r);
    if (s == SW_OK)
        s = extract(&r, lambda, x);
    run_free(&r);
    return s;
}
