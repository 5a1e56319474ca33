/* Symmetric band matrices. */
#include "num/band.h"
#include "num/mem.h"
#include "num/simd.h"

#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

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

/* The columns from..to-1, each with `below` entries under the diagonal (constant for most). */
static inline void multiply_columns(const struct band *A, int from, int to, int below, double c,
                                    const double *x, double *y)
{
    for (int j = from; j < to; j++) {
        const double *a = band_at(A, j, j);
        double cx = c * x[j], sum = a[0] * x[j];

        for (int i = 1; i <= below; i++) {
            sum += a[i] * x[j + i];
            y[j + i] += a[i] * cx;
        }
        y[j] += c * sum;
    }
}

void band_multiply_add(const struct band *A, double c, const double *x, double *y)
{
    int n = A->n, whole = n > A->kd ? n - A->kd : 0;

    switch (A->kd) { /* the common ones, for the compiler to unroll */
    case 3: multiply_columns(A, 0, whole, 3, c, x, y); break;
    case 7: multiply_columns(A, 0, whole, 7, c, x, y); break;
    case 11: multiply_columns(A, 0, whole, 11, c, x, y); break;
    default: multiply_columns(A, 0, whole, A->kd, c, x, y);
    }
    for (int j = whole; j < n; j++)
        multiply_columns(A, j, j + 1, n - 1 - j, c, x, y);
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

/* Unit L and D from LAPACK's Cholesky factor C = L sqrt(D); 0 if a pivot is not positive. */
static int take_factor(const struct band *C, struct band_factor *ret)
{
    int n = C->n, kd = C->kd;

    for (int j = 0; j < n; j++) {
        double pivot = *band_at(C, j, j);

        if (!(pivot > 0))
            return 0;
        ret->inverse[j] = 1 / (pivot * pivot);
        for (int i = 1; i <= kd && j + i < n; i++) {
            double l = *band_at(C, j + i, j) / pivot;

            ret->column[(size_t)kd * (size_t)(j + 1) - (size_t)i] = l;
            ret->row[(size_t)kd * (size_t)(j + i + 1) - (size_t)i] = l;
        }
    }
    return 1;
}

enum status band_cholesky(const struct band *A, struct band_factor *ret)
{
    size_t n = (size_t)A->n, kd = (size_t)A->kd;
    struct band C = {A->n, A->kd, mem_copy(A->a, sizeof(double) * n * (kd + 1))};
    enum status s = SW_NOMEM;
    int info;

    *ret =
        (struct band_factor){A->n, A->kd, mem_doubles(n * kd), mem_doubles(n * kd), mem_doubles(n)};
    if (C.a && ret->row && ret->column && ret->inverse) {
        info = n > 0 ? LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', C.n, C.kd, C.a, C.kd + 1) : 0;
        s = info == 0 && take_factor(&C, ret) ? SW_OK : SW_INDEFINITE;
    }
    band_free(&C);
    if (s != SW_OK)
        band_factor_free(ret);
    return s;
}

void band_factor_free(struct band_factor *F)
{
    free(F->row);
    free(F->column);
    free(F->inverse);
    *F = (struct band_factor){0};
}

/*
 * Unknown j of the substitutions: x_j less its row (column) of L times the count unknowns before
 * (after) it.  The nearest one (fresh) comes last and from a register: each unknown waits for it by
 * one product and one difference only.
 */
static INLINE_BODY double forward(const double *l, int kd, int count, const double *x, int j,
                                  double fresh)
{
    double sum = x[j];

    for (int i = kd - count; i < kd - 1; i++)
        sum -= l[i] * x[j - kd + i];
    return count > 0 ? sum - l[kd - 1] * fresh : sum;
}

static INLINE_BODY double backward(const double *l, int kd, int count, const double *x, int j,
                                   double fresh)
{
    double sum = x[j];

    for (int i = kd - count; i < kd - 1; i++)
        sum -= l[i] * x[j + kd - i];
    return count > 0 ? sum - l[kd - 1] * fresh : sum;
}

/* x := L^{-1} x and x := L^{-T} x; the caller's constant kd lets the compiler unroll. */
static INLINE_BODY void solve_forward(const struct band_factor *F, int kd, double *x)
{
    int n = F->n, ragged = n < kd ? n : kd; /* rows that the matrix' corner cuts short */
    const double *l = F->row;
    double fresh = 0;

    for (int j = 0; j < ragged; j++, l += kd)
        x[j] = fresh = forward(l, kd, j, x, j, fresh);
    for (int j = ragged; j < n; j++, l += kd)
        x[j] = fresh = forward(l, kd, kd, x, j, fresh);
}

static INLINE_BODY void solve_backward(const struct band_factor *F, int kd, double *x)
{
    int n = F->n, ragged = n < kd ? n : kd;
    const double *l = F->column + (size_t)kd * (size_t)n;
    double fresh = 0;

    for (int j = n - 1; j >= n - ragged; j--)
        x[j] = fresh = backward(l -= kd, kd, n - 1 - j, x, j, fresh);
    for (int j = n - 1 - ragged; j >= 0; j--)
        x[j] = fresh = backward(l -= kd, kd, kd, x, j, fresh);
}

/* The half bandwidths of cables as constants. */
static INLINE_BODY void forward_any(const struct band_factor *F, double *x)
{
    switch (F->kd) {
    case 3: solve_forward(F, 3, x); break;
    case 7: solve_forward(F, 7, x); break;
    case 11: solve_forward(F, 11, x); break;
    default: solve_forward(F, F->kd, x);
    }
}

static INLINE_BODY void backward_any(const struct band_factor *F, double *x)
{
    switch (F->kd) {
    case 3: solve_backward(F, 3, x); break;
    case 7: solve_backward(F, 7, x); break;
    case 11: solve_backward(F, 11, x); break;
    default: solve_backward(F, F->kd, x);
    }
}

static void forward_plain(const struct band_factor *F, double *x)
{
    forward_any(F, x);
}

FOR_AVX2 static void forward_avx2(const struct band_factor *F, double *x)
{
    forward_any(F, x);
}

static void backward_plain(const struct band_factor *F, double *x)
{
    backward_any(F, x);
}

FOR_AVX2 static void backward_avx2(const struct band_factor *F, double *x)
{
    backward_any(F, x);
}

static void run_forward(const struct band_factor *F, double *x)
{
    if (has_avx2())
        forward_avx2(F, x);
    else
        forward_plain(F, x);
}

static void run_backward(const struct band_factor *F, double *x)
{
    if (has_avx2())
        backward_avx2(F, x);
    else
        backward_plain(F, x);
}

void band_solve(const struct band_factor *F, double *x)
{
    run_forward(F, x);
    for (int j = 0; j < F->n; j++)
        x[j] *= F->inverse[j];
    run_backward(F, x);
}

/* Four right sides side by side; as forward and backward above. */
typedef double four __attribute__((vector_size(32), aligned(8), may_alias));

static INLINE_BODY void solve_four(const struct band_factor *F, int kd, double *x)
{
    int n = F->n, ragged = n < kd ? n : kd;
    const double *l = F->row;
    four *y = (four *)x, fresh = {0};

    for (int j = 0; j < n; j++, l += kd) {
        int count = j < ragged ? j : kd;
        four sum = y[j];

        for (int i = kd - count; i < kd - 1; i++)
            sum -= l[i] * y[j - kd + i];
        if (count > 0)
            sum -= l[kd - 1] * fresh;
        y[j] = fresh = sum;
    }
    l = F->column + (size_t)kd * (size_t)n;
    for (int j = n - 1; j >= 0; j--) {
        int count = n - 1 - j < kd ? n - 1 - j : kd;
        four sum = y[j] * F->inverse[j];

        l -= kd;
        for (int i = kd - count; i < kd - 1; i++)
            sum -= l[i] * y[j + kd - i];
        if (count > 0)
            sum -= l[kd - 1] * fresh;
        y[j] = fresh = sum;
    }
}

static INLINE_BODY void solve_four_any(const struct band_factor *F, double *x)
{
    if (F->kd == 3)
        solve_four(F, 3, x);
    else
        solve_four(F, F->kd, x);
}

static void solve_four_plain(const struct band_factor *F, double *x)
{
    solve_four_any(F, x);
}

FOR_AVX2 static void solve_four_avx2(const struct band_factor *F, double *x)
{
    solve_four_any(F, x);
}

void band_solve_four(const struct band_factor *F, double *x)
{
    if (has_avx2())
        solve_four_avx2(F, x);
    else
        solve_four_plain(F, x);
}

void band_solve_lower(const struct band_factor *F, double *x)
{
    run_forward(F, x);
    for (int j = 0; j < F->n; j++)
        x[j] *= sqrt(F->inverse[j]);
}

void band_solve_upper(const struct band_factor *F, double *x)
{
    for (int j = 0; j < F->n; j++)
        x[j] *= sqrt(F->inverse[j]);
    run_backward(F, x);
}

/*
 * Elimination of A - sigma B column by column.  Only the triangle of the next kd columns that the
 * earlier ones have changed is kept: change[a][b] goes to entry (j + a, j + b), a >= b.
 */
static inline int count_below(const struct band *A, const struct band *B, double sigma, int kd)
{
    double change[BAND_COUNT_KD + 1][BAND_COUNT_KD + 1] = {{0}};
    int below = 0;

    for (int j = 0; j < A->n; j++) {
        const double *a = band_at(A, j, j), *b = band_at(B, j, j);
        double c[BAND_COUNT_KD + 1] = {0}, inverse;

        for (int i = 0; i <= kd; i++)
            c[i] = a[i] - sigma * (i <= B->kd ? b[i] : 0) + change[i][0];
        below += c[0] < 0;
        inverse = 1 / (c[0] != 0 ? c[0] : DBL_MIN);
        for (int q = 1; q <= kd; q++) {
            double l = c[q] * inverse;

            for (int p = q; p <= kd; p++)
                change[p - 1][q - 1] = (p < kd ? change[p][q] : 0) - l * c[p];
        }
    }
    return below;
}

int band_count_below(const struct band *A, const struct band *B, double sigma)
{
    switch (A->kd) {
    case 3: return count_below(A, B, sigma, 3);
    case 7: return count_below(A, B, sigma, 7);
    default: return count_below(A, B, sigma, A->kd);
    }
}

/* Column by column: what is left of the matrix takes the change at once, four numbers at a time;
 * c is filled up with zeros. */
static INLINE_BODY enum status factor_in_place(struct band *A, int kd)
{
    for (int j = 0; j < A->n; j++) {
        double *a = band_at(A, j, j), c[BAND_COUNT_KD + 5] = {0}, inverse = 1 / a[0];
        int below = A->n - 1 - j < kd ? A->n - 1 - j : kd;

        if (!(a[0] > 0))
            return SW_INDEFINITE;
        for (int i = 1; i <= kd; i++) {
            c[i] = a[i];
            a[i] *= inverse;
        }
        for (int q = 1; q <= kd; q++) {
            if (q > below)
                break;
            for (int p = q; p <= kd; p += 4)
                *(four *)(a + (kd + 1) * q + p - q) -= a[q] * *(const four *)(c + p);
        }
    }
    return SW_OK;
}

static INLINE_BODY void solve_in_place(const struct band *A, int kd, double *x)
{
    int whole = A->n > kd ? A->n - kd : 0;

    for (int j = 0; j < A->n; j++) {
        const double *a = band_at(A, j, j);

        if (j < whole)
            for (int i = 1; i <= kd; i++)
                x[j + i] -= a[i] * x[j];
        else
            for (int i = 1; j + i < A->n; i++)
                x[j + i] -= a[i] * x[j];
    }
    for (int j = A->n - 1; j >= 0; j--) {
        const double *a = band_at(A, j, j);
        double sum = x[j] / a[0];

        if (j < whole)
            for (int i = 1; i <= kd; i++)
                sum -= a[i] * x[j + i];
        else
            for (int i = 1; j + i < A->n; i++)
                sum -= a[i] * x[j + i];
        x[j] = sum;
    }
}

static INLINE_BODY enum status factor_in_place_any(struct band *A)
{
    switch (A->kd) {
    case 3: return factor_in_place(A, 3);
    case 7: return factor_in_place(A, 7);
    default: return factor_in_place(A, 11);
    }
}

static INLINE_BODY void solve_in_place_any(const struct band *A, double *x)
{
    if (A->kd == 11)
        solve_in_place(A, 11, x);
    else
        solve_in_place(A, A->kd, x);
}

static enum status factor_in_place_plain(struct band *A)
{
    return factor_in_place_any(A);
}

FOR_AVX2 static enum status factor_in_place_avx2(struct band *A)
{
    return factor_in_place_any(A);
}

static void solve_in_place_plain(const struct band *A, double *x)
{
    solve_in_place_any(A, x);
}

FOR_AVX2 static void solve_in_place_avx2(const struct band *A, double *x)
{
    solve_in_place_any(A, x);
}

enum status band_factor_in_place(struct band *A)
{
    return has_avx2() ? factor_in_place_avx2(A) : factor_in_place_plain(A);
}

void band_solve_in_place(const struct band *A, double *x)
{
    if (has_avx2())
        solve_in_place_avx2(A, x);
    else
        solve_in_place_plain(A, x);
}
