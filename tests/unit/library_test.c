/* What LAPACK and ARPACK tell is passed on: failures that they may report but hardly ever do are
 * put in here, between them and the code under test. */
#include "check.h"

#include "num/band.h"
#include "num/dense.h"
#include "num/lanczos.h"
#include "num/pencil.h"
#include "num/root.h"
#include "num/zband.h"
#include "phys/modes.h"

#include <dlfcn.h>
#include <lapacke.h>

#define N 24

static int potrf_info, syev_info, sygvd_info, geev_info; /* told in place of the truth, if not 0 */
static int aupd_info, eupd_info, found_less;
static double spoil; /* the largest eigenvalue of ARPACK becomes this, if not 0 */

/* The library's own function of that name.  ARPACK is linked only if something of it is asked for
 * that is not defined here. */
extern void dnaupd_(void);
void (*volatile linked)(void) = dnaupd_;

static void *own(const char *name)
{
    void *p = dlsym(RTLD_NEXT, name);

    assert_non_null(p);
    return p;
}

lapack_int LAPACKE_dpotrf(int layout, char uplo, lapack_int n, double *a, lapack_int lda)
{
    lapack_int (*f)(int, char, lapack_int, double *, lapack_int);

    *(void **)&f = own("LAPACKE_dpotrf");
    return potrf_info != 0 ? potrf_info : f(layout, uplo, n, a, lda);
}

lapack_int LAPACKE_dsyev(int layout, char jobz, char uplo, lapack_int n, double *a, lapack_int lda,
                         double *w)
{
    lapack_int (*f)(int, char, char, lapack_int, double *, lapack_int, double *);

    *(void **)&f = own("LAPACKE_dsyev");
    return syev_info != 0 ? syev_info : f(layout, jobz, uplo, n, a, lda, w);
}

lapack_int LAPACKE_dsygvd(int layout, lapack_int type, char jobz, char uplo, lapack_int n,
                          double *a, lapack_int lda, double *b, lapack_int ldb, double *w)
{
    lapack_int (*f)(int, lapack_int, char, char, lapack_int, double *, lapack_int, double *,
                    lapack_int, double *);

    *(void **)&f = own("LAPACKE_dsygvd");
    return sygvd_info != 0 ? sygvd_info : f(layout, type, jobz, uplo, n, a, lda, b, ldb, w);
}

lapack_int LAPACKE_dgeev(int layout, char jobvl, char jobvr, lapack_int n, double *a,
                         lapack_int lda, double *wr, double *wi, double *vl, lapack_int ldvl,
                         double *vr, lapack_int ldvr)
{
    lapack_int (*f)(int, char, char, lapack_int, double *, lapack_int, double *, double *, double *,
                    lapack_int, double *, lapack_int);

    *(void **)&f = own("LAPACKE_dgeev");
    return geev_info != 0 ? geev_info
                          : f(layout, jobvl, jobvr, n, a, lda, wr, wi, vl, ldvl, vr, ldvr);
}

void dsaupd_c(int *ido, const char *bmat, int n, const char *which, int nev, double tol,
              double *resid, int ncv, double *v, int ldv, int *iparam, int *ipntr, double *workd,
              double *workl, int lworkl, int *info)
{
    void (*f)(int *, const char *, int, const char *, int, double, double *, int, double *, int,
              int *, int *, double *, double *, int, int *);

    *(void **)&f = own("dsaupd_c");
    f(ido, bmat, n, which, nev, tol, resid, ncv, v, ldv, iparam, ipntr, workd, workl, lworkl, info);
    if (*ido != 1 && *ido != -1) {
        *info = aupd_info != 0 ? aupd_info : *info;
        iparam[4] -= found_less;
    }
}

void dseupd_(const int *rvec, const char *howmny, int *select, double *d, double *z, const int *ldz,
             const double *sigma, const char *bmat, const int *n, const char *which, const int *nev,
             const double *tol, double *resid, const int *ncv, double *v, const int *ldv,
             int *iparam, int *ipntr, double *workd, double *workl, const int *lworkl, int *info,
             long l1, long l2, long l3)
{
    void (*f)(const int *, const char *, int *, double *, double *, const int *, const double *,
              const char *, const int *, const char *, const int *, const double *, double *,
              const int *, double *, const int *, int *, int *, double *, double *, const int *,
              int *, long, long, long);

    *(void **)&f = own("dseupd_");
    f(rvec, howmny, select, d, z, ldz, sigma, bmat, n, which, nev, tol, resid, ncv, v, ldv, iparam,
      ipntr, workd, workl, lworkl, info, l1, l2, l3);
    if (eupd_info != 0)
        *info = eupd_info;
    if (spoil != 0)
        d[0] = spoil;
}

/* 2 on the diagonal and -1 beside it: a string of N beads. */
static struct band beads(double diagonal)
{
    struct band A;

    assert_int_equal(band_new(N, 1, &A), SW_OK);
    for (int i = 0; i < N; i++) {
        *band_at(&A, i, i) = diagonal;
        if (i > 0 && diagonal > 1)
            *band_at(&A, i, i - 1) = -1;
    }
    return A;
}

static void dense(void **state)
{
    double A[4] = {2, 1, 1, 2}, B[4] = {1, 0, 0, 1}, re[2], im[2];
    (void)state;

    potrf_info = syev_info = sygvd_info = geev_info = LAPACK_WORK_MEMORY_ERROR;
    assert_int_equal(dense_invert(2, A), SW_NOMEM);
    assert_int_equal(dense_symmetric(2, A, re), SW_NOMEM);
    assert_int_equal(dense_pencil(2, A, B, re), SW_NOMEM);
    assert_int_equal(dense_general(2, A, re, im, NULL), SW_NOMEM);
    potrf_info = syev_info = sygvd_info = geev_info = 1;
    assert_int_equal(dense_invert(2, A), SW_INDEFINITE);
    assert_int_equal(dense_symmetric(2, A, re), SW_NOCONV);
    assert_int_equal(dense_pencil(2, A, B, re), SW_NOCONV);
    assert_int_equal(dense_general(2, A, re, im, NULL), SW_NOCONV);
    sygvd_info = 3; /* beyond n: the second matrix */
    assert_int_equal(dense_pencil(2, A, B, re), SW_INDEFINITE);
    potrf_info = syev_info = sygvd_info = geev_info = 0;
    assert_int_equal(dense_symmetric(2, A, re), SW_OK);
    near_abs(re[0], 1, 1e-15);
    near_abs(re[1], 3, 1e-15);
}

/* Equations without a solution. */
static void singular(void **state)
{
    double A[4] = {1, 2, 2, 4}, b[2] = {1, 1};
    struct band K = beads(0), M = beads(0);
    double complex x[N];
    (void)state;

    assert_int_equal(dense_solve(2, A, 1, b), SW_INDEFINITE);
    for (int i = 0; i < N; i++)
        x[i] = 1;
    assert_int_equal(zband_solve(1, &K, 1, &M, x), SW_INDEFINITE);
    band_free(&K);
    band_free(&M);
}

static enum status lowest(int k, double *lambda)
{
    struct band K = beads(2), M = beads(1);
    double x[N * N];
    enum status s = lanczos_lowest(&K, &M, k, lambda, x);

    band_free(&K);
    band_free(&M);
    return s;
}

static void lanczos(void **state)
{
    double lambda[N];
    (void)state;

    assert_int_equal(lowest(3, lambda), SW_OK);
    for (int i = 0; i < 3; i++)
        near_rel(lambda[i], 4 * pow(sin((i + 1) * PI / (2 * (N + 1))), 2), 1e-12);
    lambda[0] = -7;
    aupd_info = 1;
    assert_int_equal(lowest(3, lambda), SW_NOCONV);
    aupd_info = 0;
    found_less = 1;
    assert_int_equal(lowest(3, lambda), SW_NOCONV);
    found_less = 0;
    eupd_info = -14;
    assert_int_equal(lowest(3, lambda), SW_NOCONV);
    eupd_info = 0;
    near_abs(lambda[0], -7, 0); /* nothing was written */
    spoil = -1;
    assert_int_equal(lowest(3, lambda), SW_NOCONV);
    spoil = 0;
    assert_int_equal(lanczos_most(3), 0);
    assert_int_equal(lanczos_most(4), 2);
}

/* A mode that was counted but not found is no result. */
static void missed_mode(void **state)
{
    struct model m;
    struct modes p;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_THESIS, 40, &m), SW_OK);
    assert_int_equal(modes_lowest(&m, 3, SOLVER_LANCZOS, &p), SW_OK);
    modes_free(&p);
    spoil = 1e-9; /* a far higher one in the place of one of them */
    assert_int_equal(modes_lowest(&m, 3, SOLVER_LANCZOS, &p), SW_NOCONV);
    spoil = 0;
    modes_free(&p);
    model_free(&m);
}

/* Not a number is no eigenvalue problem; a pencil whose factor cannot be trusted is refused. */
static void pencils(void **state)
{
    struct band K = beads(2), M = beads(1);
    double lambda[N], x[N * N];
    (void)state;

    *band_at(&K, 3, 2) = NAN;
    assert_int_equal(pencil_all(&K, &M, lambda, x), SW_INDEFINITE);
    *band_at(&K, 3, 2) = -1;
    *band_at(&M, 3, 3) = INFINITY;
    assert_int_equal(pencil_all(&K, &M, lambda, x), SW_INDEFINITE);
    *band_at(&M, 3, 3) = 1;
    sygvd_info = 1;
    assert_int_equal(pencil_all(&K, &M, lambda, x), SW_NOCONV);
    sygvd_info = 0;
    *band_at(&K, 0, 0) = -5; /* eigenvalues, but no Cholesky factor to polish them with */
    assert_int_equal(pencil_all(&K, &M, lambda, x), SW_INDEFINITE);
    band_free(&K);
    band_free(&M);
}

TEST_MAIN(cmocka_unit_test(dense), cmocka_unit_test(singular), cmocka_unit_test(lanczos),
          cmocka_unit_test(missed_mode), cmocka_unit_test(pencils))
