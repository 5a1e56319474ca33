/* Small eigenproblems, Cholesky and null spaces: put back, known spectra, failures. */
#include "check.h"

#include "num/jacobi.h"
#include "num/nullspace.h"

#include <string.h>

enum { MOST = 24 };

static void random_symmetric(uint64_t *seed, int n, double *A)
{
    for (int j = 0; j < n; j++)
        for (int i = 0; i <= j; i++)
            A[i + j * n] = A[j + i * n] = uniform_in(seed, -1, 1);
}

/* B^T B + n I/10. */
static void random_definite(uint64_t *seed, int n, double *A)
{
    double B[MOST * MOST] = {0};

    for (int i = 0; i < n * n; i++)
        B[i] = uniform_in(seed, -1, 1);
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            A[i + j * n] = i == j ? n / 10.0 : 0;
            for (int k = 0; k < n; k++)
                A[i + j * n] += B[k + i * n] * B[k + j * n];
        }
}

/* Largest entry of K X - M X diag(lambda) and of X^T M X - I. */
static double off(int n, const double *K, const double *M, const double *lambda, const double *X)
{
    double most = 0;

    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++) {
            double r = 0, o = -(i == k);

            for (int j = 0; j < n; j++) {
                double Mx = 0;

                r += (K[i + j * n] - lambda[k] * M[i + j * n]) * X[j + k * n];
                for (int l = 0; l < n; l++)
                    Mx += M[j + l * n] * X[l + k * n];
                o += X[j + i * n] * Mx;
            }
            most = fmax(most, fmax(fabs(r), fabs(o)));
        }
    return most;
}

static void put_back(void **state)
{
    uint64_t seed = 1;
    (void)state;

    for (int turn = 0; turn < 200; turn++) {
        double A[MOST * MOST], B[MOST * MOST], M[MOST * MOST] = {0}, C[MOST * MOST];
        double X[MOST * MOST], lambda[MOST];
        int n = 1 + turn % MOST;

        random_symmetric(&seed, n, A);
        for (int i = 0; i < n * n; i++)
            M[i] = i % (n + 1) == 0;
        memcpy(B, A, sizeof B);
        assert_int_equal(jacobi_symmetric(n, B, lambda, X), SW_OK);
        below(off(n, A, M, lambda, X), 1e-13);
        for (int i = 1; i < n; i++)
            assert_true(lambda[i - 1] <= lambda[i]);
        random_definite(&seed, n, M);
        memcpy(B, A, sizeof B);
        memcpy(C, M, sizeof C);
        assert_int_equal(jacobi_pencil(n, B, C, lambda, X), SW_OK);
        below(off(n, A, M, lambda, X), 1e-13);
    }
}

/* Tridiagonal 2, -1: 4 sin^2(k pi/(2 (n + 1))); with M = 3 I a third of it; and one multiple
 * eigenvalue. */
static void known_spectra(void **state)
{
    double A[MOST * MOST], M[MOST * MOST], X[MOST * MOST], lambda[MOST];
    (void)state;

    for (int pencil = 0; pencil < 2; pencil++) {
        memset(A, 0, sizeof A);
        memset(M, 0, sizeof M);
        for (int i = 0; i < MOST; i++) {
            A[i + i * MOST] = 2;
            M[i + i * MOST] = 3;
            if (i > 0)
                A[i + (i - 1) * MOST] = A[i - 1 + i * MOST] = -1;
        }
        assert_int_equal(pencil ? jacobi_pencil(MOST, A, M, lambda, X)
                                : jacobi_symmetric(MOST, A, lambda, X),
                         SW_OK);
        for (int k = 1; k <= MOST; k++)
            near_abs(lambda[k - 1], 4 * pow(sin(k * PI / (2 * (MOST + 1))), 2) / (pencil ? 3 : 1),
                     1e-14);
    }
    for (int i = 0; i < 25; i++)
        A[i] = 1 + (i % 6 == 0); /* I + ones: 1, 1, 1, 1, 6 */
    assert_int_equal(jacobi_symmetric(5, A, lambda, X), SW_OK);
    for (int k = 0; k < 5; k++)
        near_abs(lambda[k], k < 4 ? 1 : 6, 1e-14);
}

static void failures(void **state)
{
    double A[] = {1, 2, 2, 1}, N[] = {1, NAN, NAN, 1}, I[] = {1, 0, 0, 1}, M[] = {1, 2, 2, 1};
    double lambda[2], X[4];
    (void)state;

    assert_int_equal(jacobi_pencil(2, A, M, lambda, X), SW_INDEFINITE);
    assert_int_equal(jacobi_symmetric(2, N, lambda, X), SW_NOCONV);
    assert_int_equal(jacobi_pencil(2, I, N, lambda, X), SW_INDEFINITE);
    assert_int_equal(jacobi_symmetric(0, A, lambda, X), SW_OK);
}

/* Columns that depend on one another: the rank, an orthogonal Q, A^T Z = 0. */
static void null_spaces(void **state)
{
    uint64_t seed = 7;
    (void)state;

    for (int turn = 0; turn < 200; turn++) {
        int n = 4 + turn % 20, m = 1 + turn % 9, rank = m < n ? m : n;
        double A[MOST * MOST], kept[MOST * MOST];
        struct nullspace f;

        for (int i = 0; i < n * m; i++)
            A[i] = uniform_in(&seed, -1, 1);
        if (m > 2) { /* the last is a sum of the first two */
            for (int i = 0; i < n; i++)
                A[i + (m - 1) * n] = A[i] - 2 * A[i + n];
            rank = m - 1 < n ? m - 1 : n;
        }
        memcpy(kept, A, sizeof kept);
        nullspace_of(n, m, A, 1e-10, &f);
        assert_int_equal(f.rank, rank);
        for (int j = 0; j < n; j++)
            for (int k = 0; k < n; k++) {
                double sum = -(j == k), cross = 0;

                for (int i = 0; i < n; i++) {
                    sum += f.Q[i + j * n] * f.Q[i + k * n];
                    cross += k < m ? f.Q[i + j * n] * kept[i + k * n] : 0;
                }
                below(fabs(sum), 1e-14);
                if (j >= rank)
                    below(fabs(cross), 1e-14);
            }
    }
}

/* Two equal columns share evenly; A x = b and A^T y = c put back. */
static void solutions(void **state)
{
    const double A[] = {1, 2, 0, 1, 2, 0, 0, 1, 1}, b[] = {2, 5, 1}, c[] = {3, 3, 4};
    double B[9], x[3], y[3];
    struct nullspace f;
    (void)state;

    memcpy(B, A, sizeof B);
    nullspace_of(3, 3, B, 1e-10, &f);
    assert_int_equal(f.rank, 2);
    nullspace_solve(&f, b, x);
    near_abs(x[0], 1, 1e-14);
    near_abs(x[1], 1, 1e-14);
    near_abs(x[2], 1, 1e-14);
    nullspace_transposed(&f, c, y);
    for (int j = 0; j < 3; j++)
        near_abs(A[3 * j] * y[0] + A[3 * j + 1] * y[1] + A[3 * j + 2] * y[2], c[j], 1e-13);
}

TEST_MAIN(cmocka_unit_test(put_back), cmocka_unit_test(known_spectra), cmocka_unit_test(failures),
          cmocka_unit_test(null_spaces), cmocka_unit_test(solutions))
