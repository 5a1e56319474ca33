/* Small dense problems by LAPACK. */
#include "num/dense.h"
#include "num/mem.h"

#include <cblas.h>
#include <lapacke.h>
#include <stdlib.h>

/* Status of an info that is not 0 for the reason given. */
static enum status judge(int info, enum status reason)
{
    if (info == LAPACK_WORK_MEMORY_ERROR || info == LAPACK_TRANSPOSE_MEMORY_ERROR)
        return SW_NOMEM;
    return info == 0 ? SW_OK : reason;
}

enum status dense_invert(int n, double *A)
{
    int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', n, A, n);

    if (info == 0)
        info = LAPACKE_dpotri(LAPACK_COL_MAJOR, 'L', n, A, n);
    for (int j = 0; j < n; j++)
        for (int i = 0; i < j; i++)
            A[i + n * j] = A[j + n * i];
    return judge(info, SW_INDEFINITE);
}

enum status dense_symmetric(int n, double *A, double *lambda)
{
    return judge(LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', n, A, n, lambda), SW_NOCONV);
}

enum status dense_pencil(int n, double *A, double *B, double *lambda)
{
    int info = LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', n, A, n, B, n, lambda);

    return judge(info, info > n ? SW_INDEFINITE : SW_NOCONV);
}

enum status dense_general(int n, double *A, double *re, double *im, double *x)
{
    double none;

    return judge(LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', x ? 'V' : 'N', n, A, n, re, im, &none, 1,
                               x ? x : &none, x ? n : 1),
                 SW_NOCONV);
}

void dense_threads(int n)
{
    openblas_set_num_threads(n);
}

enum status dense_solve(int n, double *A, int m, double *b)
{
    lapack_int *pivot = mem_zeroed((size_t)n, sizeof *pivot), info;

    if (!pivot)
        return SW_NOMEM;
    info = LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, m, A, n, pivot, b, n);
    free(pivot);
    return info > 0 ? SW_INDEFINITE : SW_OK;
}
