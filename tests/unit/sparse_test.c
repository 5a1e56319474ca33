/* Sparse systems against dense elimination; patterns in any order; what is not positive definite.
 */
#include "check.h"
#include "num/sparse.h"

#include <string.h>

enum { N = 40, PLACES = 400 };

/* Gauss elimination with the full matrix. */
static void eliminate(int n, double A[N][N], double x[N])
{
    for (int j = 0; j < n; j++)
        for (int i = j + 1; i < n; i++) {
            double l = A[i][j] / A[j][j];

            for (int k = j; k < n; k++)
                A[i][k] -= l * A[j][k];
            x[i] -= l * x[j];
        }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            x[i] -= A[i][k] * x[k];
        x[i] /= A[i][i];
    }
}

static void random_systems(void **state)
{
    uint64_t seed = 7;
    (void)state;

    for (int n = 1; n <= N; n++) {
        struct place place[PLACES];
        double full[N][N] = {{0}}, x[2 * N], y[N];
        int at[PLACES], places = n * 8;
        struct sparse A;

        for (int k = 0; k < places; k++) {
            int i = (int)(n * uniform(&seed)), j = (int)(n * uniform(&seed));

            place[k] = (struct place){i > j ? i : j, i > j ? j : i};
        }
        assert_int_equal(sparse_new(n, place, (size_t)places, at, &A), SW_OK);
        for (int round = 0; round < 2; round++) { /* the pattern is used again */
            memset(A.value, 0, A.entries * sizeof *A.value);
            memset(full, 0, sizeof full);
            for (int k = 0; k < places; k++) {
                double v = uniform_in(&seed, -1, 1);
                int i = place[k].row, j = place[k].column;

                A.value[at[k]] += v;
                full[i][j] += v;
                full[j][i] += i == j ? 0 : v;
            }
            for (int i = 0; i < n; i++) {
                A.value[sparse_at(&A, i, i)] += 20;
                full[i][i] += 20;
                x[i] = y[i] = uniform_in(&seed, -1, 1);
                x[n + i] = 2 * x[i];
            }
            assert_int_equal(sparse_factor(&A), SW_OK);
            assert_int_equal(sparse_solve(&A, 2, x), SW_OK);
            eliminate(n, full, y);
            for (int i = 0; i < n; i++) {
                near_abs(x[i], y[i], 1e-14);
                near_abs(x[n + i], 2 * y[i], 1e-14);
            }
        }
        sparse_free(&A);
    }
}

static void indefinite(void **state)
{
    const struct place place[3] = {{1, 0}, {2, 1}, {2, 2}};
    double x[3] = {1, 1, 1};
    int at[3];
    struct sparse A;
    (void)state;

    assert_int_equal(sparse_new(3, place, 3, at, &A), SW_OK);
    assert_int_equal(sparse_at(&A, 2, 0), -1);
    for (int i = 0; i < 3; i++)
        A.value[sparse_at(&A, i, i)] = i == 1 ? -1 : 1;
    assert_int_equal(sparse_factor(&A), SW_INDEFINITE);
    assert_int_equal(A.failed, 1);
    A.value[sparse_at(&A, 1, 1)] = NAN;
    assert_int_equal(sparse_factor(&A), SW_INDEFINITE);
    A.value[sparse_at(&A, 1, 1)] = 1;
    assert_int_equal(sparse_factor(&A), SW_OK);
    assert_int_equal(sparse_solve(&A, 1, x), SW_OK);
    near_abs(x[2], 1, 0);
    sparse_free(&A);
    assert_int_equal(sparse_new(0, NULL, 0, NULL, &A), SW_OK);
    assert_int_equal(sparse_factor(&A), SW_OK);
    sparse_free(&A);
}

/* L D L^T counts eigenvalues below zero: a chain of springs, shifted past some of its known ones,
 * 2 - 2 cos(k pi/(n + 1)); it solves there, too, and y += c A x puts the answer back. */
static void signed_factor(void **state)
{
    enum { CHAIN = 30 };
    struct place place[CHAIN - 1];
    int at[CHAIN - 1];
    struct sparse A;

    (void)state;
    for (int k = 0; k < CHAIN - 1; k++)
        place[k] = (struct place){k + 1, k};
    assert_int_equal(sparse_new(CHAIN, place, CHAIN - 1, at, &A), SW_OK);
    for (int below = 0; below <= CHAIN; below++) {
        double shift = 2 - 2 * cos((below + 0.37) * PI / (CHAIN + 1)), x[CHAIN], b[CHAIN];
        int negative;

        for (int j = 0; j < CHAIN; j++)
            A.value[sparse_at(&A, j, j)] = 2 - shift;
        for (int k = 0; k < CHAIN - 1; k++)
            A.value[at[k]] = -1;
        assert_int_equal(sparse_factor_signed(&A, &negative), SW_OK);
        assert_int_equal(negative, below);
        for (int j = 0; j < CHAIN; j++)
            x[j] = b[j] = j % 7 - 3;
        assert_int_equal(sparse_solve(&A, 1, x), SW_OK);
        sparse_multiply_add(&A, -1, x, b);
        for (int j = 0; j < CHAIN; j++)
            near_abs(b[j], 0, 1e-10); /* no pivots are chosen: growth takes some digits */
    }
    sparse_free(&A);
}

/* What nothing holds has a pivot that is rounding. */
static void singular(void **state)
{
    const struct place place[3] = {{1, 0}, {2, 1}, {3, 2}};
    int at[3], negative;
    struct sparse A;

    (void)state;
    assert_int_equal(sparse_new(4, place, 3, at, &A), SW_OK);
    for (int k = 0; k < 3; k++) { /* a free chain with uneven springs */
        double c = 0.1 + k / 3.0;

        A.value[at[k]] = -c;
        A.value[sparse_at(&A, k, k)] += c;
        A.value[sparse_at(&A, k + 1, k + 1)] += c;
    }
    assert_int_equal(sparse_factor_signed(&A, &negative), SW_INDEFINITE);
    assert_in_range(A.failed, 0, 3);
    sparse_free(&A);
}

TEST_MAIN(cmocka_unit_test(random_systems), cmocka_unit_test(indefinite),
          cmocka_unit_test(signed_factor), cmocka_unit_test(singular))
