/* Complex combinations of symmetric band matrices. */
#define lapack_complex_float float _Complex
#define lapack_complex_double double _Complex
#include "num/zband.h"
#include "num/mem.h"

#include <lapacke.h>
#include <stdlib.h>

enum status zband_solve(double complex k, const struct band *K, double complex m,
                        const struct band *M, double complex *x)
{
    int n = K->n, kd = K->kd, rows = 3 * kd + 1, info = LAPACK_WORK_MEMORY_ERROR;
    double complex *A = mem_zeroed((size_t)n * (size_t)rows, sizeof *A);
    int *pivot = mem_zeroed((size_t)n, sizeof *pivot);

    if (A && pivot) {
        for (int j = 0; j < n; j++) /* A(i, j) stands in row 2 kd + i - j of column j */
            for (int i = j; i <= j + kd && i < n; i++) {
                double complex a =
                    k * *band_at(K, i, j) + (i - j <= M->kd ? m * *band_at(M, i, j) : 0);

                A[(size_t)(2 * kd + i - j) + (size_t)rows * (size_t)j] = a;
                A[(size_t)(2 * kd + j - i) + (size_t)rows * (size_t)i] = a;
            }
        info = LAPACKE_zgbsv_work(LAPACK_COL_MAJOR, n, kd, kd, 1, A, rows, pivot, x, n);
    }
    free(A);
    free(pivot);
    if (info == LAPACK_WORK_MEMORY_ERROR)
        return SW_NOMEM;
    return info == 0 ? SW_OK : SW_INDEFINITE;
}
