/* Band matrices and their pencils against dense arithmetic and closed forms. */
#include "check.h"
#include "num/band.h"
#include "num/mem.h"
#include "num/pencil.h"

static uint64_t seed = 4711;

/* Random symmetric band, positive definite by its heavy diagonal. */
static struct band random_band(int n, int kd)
{
    struct band A;

    assert_int_equal(band_new(n, kd, &A), SW_OK);
    for (int j = 0; j < n; j++)
        for (int i = j; i < n && i - j <= kd; i++)
            *band_at(&A, i, j) = uniform_in(&seed, -1, 1) + (i == j ? 2 * kd + 1 : 0);
    return A;
}

static void dense_multiply(const struct band *A, const double *x, double *y)
{
    for (int i = 0; i < A->n; i++) {
        y[i] = 0;
        for (int j = 0; j < A->n; j++)
            y[i] += band_get(A, i, j) * x[j];
    }
}

static void products_and_solutions(void **state)
{
    const int kd[] = {0, 1, 3, 5, 7, 11}, order[] = {1, 2, 8, 40};
    (void)state;

    for (int k = 0; k < 6; k++)
        for (int o = 0; o < 4; o++) {
            int n = order[o];
            struct band A = random_band(n, kd[k]);
            struct band_factor F;
            double x[40], y[40], z[40];

            for (int i = 0; i < n; i++) {
                x[i] = uniform_in(&seed, -1, 1);
                z[i] = 1;
            }
            dense_multiply(&A, x, y);
            band_multiply_add(&A, 2, x, z);
            for (int i = 0; i < n; i++)
                near_abs(z[i], 1 + 2 * y[i], 1e-13 * (kd[k] + 1));
            assert_int_equal(band_cholesky(&A, &F), SW_OK);
            band_solve(&F, y);
            for (int i = 0; i < n; i++)
                near_abs(y[i], x[i], 1e-13);
            band_factor_free(&F);
            band_free(&A);
        }
}

/* The factor in place is that of Cholesky: same solutions, same L and D; matrices smaller than
 * their band, too.  An indefinite one, and one with a NaN, are refused. */
static void factors_in_place(void **state)
{
    const int kd[] = {3, 7, 11}, order[] = {1, 2, 5, 12, 13, 40};
    (void)state;

    for (int k = 0; k < 3; k++)
        for (int o = 0; o < 6; o++) {
            int n = order[o];
            struct band A = random_band(n, kd[k]);
            struct band_factor F;
            double x[40], y[40], z[40];

            for (int i = 0; i < n; i++)
                x[i] = uniform_in(&seed, -1, 1);
            dense_multiply(&A, x, y);
            for (int i = 0; i < n; i++)
                z[i] = y[i];
            assert_int_equal(band_cholesky(&A, &F), SW_OK);
            band_solve(&F, y);
            assert_int_equal(band_factor_in_place(&A), SW_OK);
            band_solve_in_place(&A, z);
            for (int i = 0; i < n; i++) {
                near_abs(z[i], x[i], 1e-14);
                near_abs(z[i], y[i], 1e-14);
                near_rel(*band_at(&A, i, i), 1 / F.inverse[i], 1e-14);
                for (int j = i > kd[k] ? i - kd[k] : 0; j < i; j++)
                    near_abs(*band_at(&A, i, j), F.row[kd[k] * (i + 1) - (i - j)], 1e-15);
            }
            band_factor_free(&F);
            band_free(&A);
            for (int bad = 0; bad < 3; bad++) {
                A = random_band(n, kd[k]);
                *band_at(&A, n - 1, n - 1) = bad == 0 ? -1 : bad == 1 ? 0 : NAN;
                if (bad == 1 &&
                    n > 1) /* 0 on the diagonal is indefinite only with something beside */
                    *band_at(&A, n - 1, n - 2) = 0.5;
                assert_int_equal(band_factor_in_place(&A), SW_INDEFINITE);
                band_free(&A);
            }
        }
}

static void blocks_combinations_restrictions(void **state)
{
    const double E[4] = {1, 2, 2, 5};
    const int keep[] = {0, 2, 3};
    struct band A, B = random_band(4, 1), C, R;
    (void)state;

    assert_int_equal(band_new(4, 2, &A), SW_OK);
    for (int from = 0; from < 3; from++)
        band_add_block(&A, from, 2, E);
    near_abs(band_get(&A, 0, 0), 1, 0);
    near_abs(band_get(&A, 1, 1), 6, 0);
    near_abs(band_get(&A, 1, 2), 2, 0);
    near_abs(band_get(&A, 0, 3), 0, 0);
    assert_int_equal(band_combine(3, &A, -2, &B, &C), SW_OK);
    assert_int_equal(band_restrict(&A, keep, 3, &R), SW_OK);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            near_abs(band_get(&C, i, j), 3 * band_get(&A, i, j) - 2 * band_get(&B, i, j), 1e-15);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            near_abs(band_get(&R, i, j), band_get(&A, keep[i], keep[j]), 0);
    band_free(&A);
    band_free(&B);
    band_free(&C);
    band_free(&R);
}

static void indefinite_is_refused(void **state)
{
    const double bad[] = {-1, 0, NAN};
    (void)state;

    for (int k = 0; k < 3; k++) {
        struct band A = random_band(6, 2), M = random_band(6, 2);
        struct band_factor F;
        double lambda[6], x[36];

        *band_at(&A, 3, 3) = bad[k];
        assert_int_equal(band_cholesky(&A, &F), SW_INDEFINITE);
        assert_int_equal(pencil_all(&M, &A, lambda, x), SW_INDEFINITE);
        band_free(&A);
        band_free(&M);
    }
}

/* Chain of n unit masses and springs between walls: lambda_k = 4 sin^2(k pi/(2 (n + 1))). */
static void chain_of_masses(void **state)
{
    enum { N = 60 };
    struct band K, M;
    static double lambda[N], x[N * N];
    (void)state;

    assert_int_equal(band_new(N, 1, &K), SW_OK);
    assert_int_equal(band_new(N, 0, &M), SW_OK);
    for (int i = 0; i < N; i++) {
        *band_at(&K, i, i) = 2;
        *band_at(&M, i, i) = 1;
        if (i < N - 1)
            *band_at(&K, i + 1, i) = -1;
    }
    assert_int_equal(pencil_all(&K, &M, lambda, x), SW_OK);
    for (int k = 0; k < N; k++) {
        double s = sin((k + 1) * PI / (2 * (N + 1)));

        near_rel(lambda[k], 4 * s * s, 1e-13);
    }
    band_free(&K);
    band_free(&M);
}

/* Spread of 1e12 between the ends: the small eigenvalues keep their digits, the large ones too. */
static void wide_spectrum(void **state)
{
    enum { N = 40 };
    struct band K, M;
    static double lambda[N], x[N * N];
    (void)state;

    assert_int_equal(band_new(N, 1, &K), SW_OK);
    assert_int_equal(band_new(N, 1, &M), SW_OK);
    for (int i = 0; i < N; i += 2) { /* pairs with eigenvalues d and 3 d, M = 2x2 of 2 and 1 */
        double d = pow(10, -6 + 12.0 * i / (N - 2));

        *band_at(&K, i, i) = *band_at(&K, i + 1, i + 1) = 5 * d;
        *band_at(&K, i + 1, i) = 4 * d;
        *band_at(&M, i, i) = *band_at(&M, i + 1, i + 1) = 2;
        *band_at(&M, i + 1, i) = 1;
    }
    assert_int_equal(pencil_all(&K, &M, lambda, x), SW_OK);
    for (int i = 0; i < N; i += 2) { /* (1, -1): d; (1, 1): 3 d */
        double d = pow(10, -6 + 12.0 * i / (N - 2)), off[2] = {1, 1};

        for (int k = 0; k < N; k++)
            for (int j = 0; j < 2; j++)
                off[j] = fmin(off[j], fabs(lambda[k] / (d * (1 + 2 * j)) - 1));
        below(off[0], 1e-8);
        below(off[1], 1e-8);
    }
    band_free(&K);
    band_free(&M);
}

/* Each request fails in turn: SW_NOMEM, and nothing is lost (seen by the leak checkers). */
static void memory_runs_out(void **state)
{
    struct band K = random_band(12, 3), M = random_band(12, 1);
    double lambda[12], x[144];
    enum status s;
    unsigned long n = 0;
    (void)state;

    do {
        mem_fail_at(++n);
        s = pencil_all(&K, &M, lambda, x);
        assert_true(s == SW_OK || s == SW_NOMEM);
    } while (s != SW_OK);
    mem_fail_at(0);
    assert_int_equal(n, 7); /* six requests of our own */
    band_free(&K);
    band_free(&M);
}

TEST_MAIN(cmocka_unit_test(products_and_solutions), cmocka_unit_test(factors_in_place),
          cmocka_unit_test(blocks_combinations_restrictions),
          cmocka_unit_test(indefinite_is_refused), cmocka_unit_test(chain_of_masses),
          cmocka_unit_test(wide_spectrum), cmocka_unit_test(memory_runs_out))
