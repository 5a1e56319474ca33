/* Lowest eigenpairs of sparse pencils: known ones, multiple and zero ones, indefinite K, massless
 * unknowns. */
#include "check.h"

#include "num/mem.h"
#include "num/subspace.h"

#include <string.h>

/* A grid of n x m springs to its neighbours and to a frame: eigenvalues are sums of those of two
 * chains, many of them double when n = m. */
static void new_grid(int n, int m, struct sparse *K, double **M)
{
    size_t places = 0;
    struct place *place = mem_zeroed((size_t)(2 * n * m), sizeof *place);
    int *at = mem_zeroed((size_t)(2 * n * m), sizeof *at);

    assert_non_null(place);
    assert_non_null(at);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            if (i > 0)
                place[places++] = (struct place){i * m + j, (i - 1) * m + j};
            if (j > 0)
                place[places++] = (struct place){i * m + j, i * m + j - 1};
        }
    assert_int_equal(sparse_new(n * m, place, places, at, K), SW_OK);
    *M = mem_doubles(K->entries);
    assert_non_null(*M);
    for (size_t k = 0; k < places; k++)
        K->value[at[k]] = -1;
    for (int j = 0; j < n * m; j++) {
        K->value[sparse_at(K, j, j)] = 4;
        (*M)[sparse_at(K, j, j)] = 1;
    }
    free(place);
    free(at);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static void exact_values(int n, int m, double *ret)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++)
            ret[i * m + j] = 4 - 2 * cos((i + 1) * PI / (n + 1)) - 2 * cos((j + 1) * PI / (m + 1));
    qsort(ret, (size_t)(n * m), sizeof *ret, ascending);
}

static void grids(void **state)
{
    const int size[4][3] = {{12, 12, 9}, {20, 7, 12}, {3, 2, 6}, {1, 1, 1}};

    (void)state;
    for (int t = 0; t < 4; t++) {
        int n = size[t][0], m = size[t][1], k = size[t][2];
        struct sparse K;
        double *M, *x, lambda[12], wanted[144] = {0};

        new_grid(n, m, &K, &M);
        x = mem_doubles((size_t)(n * m * k));
        exact_values(n, m, wanted);
        assert_int_equal(subspace_lowest(&K, M, k, lambda, x), SW_OK);
        for (int i = 0; i < k; i++)
            near_rel(lambda[i], wanted[i], 1e-10);
        for (int i = 0; i < k; i++) { /* K x = lambda x, X^T X = I */
            double *r = mem_doubles((size_t)(n * m)), size_of = 0;

            sparse_multiply_add(&K, 1, x + i * n * m, r);
            for (int j = 0; j < n * m; j++) {
                near_abs(r[j], lambda[i] * x[i * n * m + j], 1e-5); /* vectors: root of 1e-12 */
                size_of += x[i * n * m + j] * x[i * n * m + j];
            }
            near_rel(size_of, 1, 1e-12);
            free(r);
        }
        free(M);
        free(x);
        sparse_free(&K);
    }
}

/* Shifted down: zero and negative ones come first; K's values are kept. */
static void indefinite(void **state)
{
    double wanted[64], lambda[8], *M, *x;
    struct sparse K;

    (void)state;
    new_grid(8, 8, &K, &M);
    exact_values(8, 8, wanted);
    for (int j = 0; j < 64; j++)
        K.value[sparse_at(&K, j, j)] -= wanted[3];
    x = mem_doubles(64 * 8);
    assert_int_equal(subspace_lowest(&K, M, 8, lambda, x), SW_OK);
    for (int i = 0; i < 8; i++)
        near_abs(lambda[i], wanted[i] - wanted[3], 1e-9);
    near_rel(K.value[K.column[1]], 4 - wanted[3], 0);
    free(M);
    free(x);
    sparse_free(&K);
}

/* An unknown without mass follows; more modes than masses are refused. */
static void massless(void **state)
{
    const struct place place[2] = {{1, 0}, {2, 1}};
    int at[2];
    double M[5] = {0}, lambda[3], x[9];
    struct sparse K;

    (void)state;
    assert_int_equal(sparse_new(3, place, 2, at, &K), SW_OK);
    assert_int_equal((int)K.entries, 5);
    for (int j = 0; j < 3; j++)
        K.value[sparse_at(&K, j, j)] = 2;
    K.value[at[0]] = K.value[at[1]] = -1;
    M[sparse_at(&K, 0, 0)] = M[sparse_at(&K, 2, 2)] = 1; /* the middle one has none */
    assert_int_equal(subspace_lowest(&K, M, 2, lambda, x), SW_OK);
    near_rel(lambda[0], 1, 1e-10); /* condensed: [1.5 -0.5; -0.5 1.5] */
    near_rel(lambda[1], 2, 1e-10);
    assert_int_equal(subspace_lowest(&K, M, 3, lambda, x), SW_INDEFINITE);
    sparse_free(&K);
}

TEST_MAIN(cmocka_unit_test(grids), cmocka_unit_test(indefinite), cmocka_unit_test(massless))
