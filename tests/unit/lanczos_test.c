/* Few modes of large models: Sturm counts and Lanczos against the dense solution, at every scale.
 */
#include "check.h"
#include "num/lanczos.h"
#include "num/mem.h"
#include "num/pencil.h"
#include "phys/modes.h"

static uint64_t seed = 1234567;

/* Random symmetric band with a heavy diagonal. */
static struct band random_band(int n, int kd, double heavy)
{
    struct band A;

    assert_int_equal(band_new(n, kd, &A), SW_OK);
    for (int j = 0; j < n; j++)
        for (int i = j; i < n && i - j <= kd; i++)
            *band_at(&A, i, j) = uniform_in(&seed, -1, 1) + (i == j ? heavy * (2 * kd + 1) : 0);
    return A;
}

/* The count between each two neighbours of the dense spectrum, and beyond its ends. */
static void sturm_counts(void **state)
{
    const int kd[] = {0, 1, 3, 5, 7, 11};
    (void)state;

    for (int k = 0; k < 6; k++)
        for (int narrow = 0; narrow < 2; narrow++) {
            int n = 40;
            struct band A = random_band(n, kd[k], 1), B = random_band(n, narrow ? 0 : kd[k], 1);
            double *lambda = mem_doubles(40), *x = mem_doubles(1600);

            assert_int_equal(pencil_all(&A, &B, lambda, x), SW_OK);
            assert_int_equal(band_count_below(&A, &B, 0), 0);
            assert_int_equal(band_count_below(&A, &B, lambda[0] * (1 - 1e-9)), 0);
            for (int i = 1; i < n; i++)
                if (lambda[i] > lambda[i - 1] * (1 + 1e-9))
                    assert_int_equal(band_count_below(&A, &B, (lambda[i - 1] + lambda[i]) / 2), i);
            assert_int_equal(band_count_below(&A, &B, lambda[n - 1] * (1 + 1e-9)), n);
            band_free(&A);
            band_free(&B);
            free(lambda);
            free(x);
        }
}

/* Largest deviation of X^T M X from I. */
static double orthogonality(const struct band *M, int k, const double *x)
{
    double worst = 0, *y = mem_doubles((size_t)M->n);

    for (int i = 0; i < k; i++) {
        for (int a = 0; a < M->n; a++)
            y[a] = 0;
        band_multiply_add(M, 1, x + (size_t)M->n * (size_t)i, y);
        for (int j = 0; j <= i; j++) {
            double sum = i == j ? -1 : 0;

            for (int a = 0; a < M->n; a++)
                sum += x[(size_t)M->n * (size_t)j + (size_t)a] * y[a];
            worst = fmax(worst, fabs(sum));
        }
    }
    free(y);
    return worst;
}

static void random_pencils(void **state)
{
    (void)state;
    for (int k = 1; k <= 30; k += 7) {
        int n = 60;
        struct band K = random_band(n, 7, 1.2), M = random_band(n, 3, 1.2);
        double *all = mem_doubles(60), *x = mem_doubles(3600), low[60], *y = mem_doubles(3600);

        assert_int_equal(pencil_all(&K, &M, all, x), SW_OK);
        assert_int_equal(lanczos_lowest(&K, &M, k, low, y), SW_OK);
        for (int i = 0; i < k; i++)
            near_rel(low[i], all[i], 1e-11); /* asked for: 1e-12 */
        below(orthogonality(&M, k, y), 1e-12);
        band_free(&K);
        band_free(&M);
        free(all);
        free(x);
        free(y);
    }
}

/* |phi^T M psi| of two vectors over all nodes. */
static double product(const struct model *m, const double *phi, const double *psi)
{
    double mass[16], sum = 0;

    element_mass(m->line.cable.mu, m->h, mass);
    for (int k = 0; k < m->n; k++)
        sum += element_product(mass, phi + 6 * (size_t)k, psi + 6 * (size_t)k);
    return fabs(sum);
}

static const struct cable inclined = {120, 10, 1e8, 9.81, 90, 60};
static const struct cable steep = {120, 10, 1e8, 9.81, 10, 110};

/* Both solvers: frequencies to 1e-9, planes, and shapes where a mode is apart from its
 * neighbours of the same plane. */
static void both_solvers(void **state)
{
    const struct cable *const cables[] = {&pont, &seil1, &seil2, &inclined, &steep};
    const int mesh[] = {10, 40, 200}, wanted[] = {1, 5, 20, 120};
    double worst = 0;
    (void)state;

    for (int c = 0; c < 5; c++)
        for (int i = 0; i < 3; i++) {
            struct model m;
            struct modes dense;
            double *V, *W;

            assert_int_equal(model_new(cables[c], LAW_HOOKE, mesh[i], &m), SW_OK);
            assert_int_equal(modes_lowest(&m, 6 * m.n, SOLVER_DENSE, &dense), SW_OK);
            assert_int_equal(dense.counted, 0);
            V = model_vector(&m);
            W = model_vector(&m);
            for (int k = 0; k < 4; k++) {
                struct modes few;

                if (wanted[k] > modes_lanczos_most(m.n))
                    continue;
                assert_int_equal(modes_lowest(&m, wanted[k], SOLVER_LANCZOS, &few), SW_OK);
                assert_true(few.counted >= wanted[k] && few.cut > few.omega[wanted[k] - 1]);
                for (int j = 0; j < wanted[k]; j++) {
                    near_rel(few.omega[j], dense.omega[j], 1e-9);
                    worst = fmax(worst, fabs(few.omega[j] / dense.omega[j] - 1));
                    modes_shape(&m, &few, j, V);
                    modes_shape(&m, &dense, j, W);
                    if (few.plane[j] != dense.plane[j] || product(&m, V, W) < 1 - 1e-6)
                        near_rel(dense.omega[j], /* then it is one of a pair */
                                 dense.omega[j > 0 && dense.omega[j] - dense.omega[j - 1] <
                                                          dense.omega[j + 1] - dense.omega[j]
                                                 ? j - 1
                                                 : j + 1],
                                 1e-6);
                }
                modes_free(&few);
            }
            modes_free(&dense);
            model_free(&m);
            free(V);
            free(W);
        }
    print_message("# lanczos against dense: %.2g\n", worst);
}

/* The largest lambda is 1e13 times the lowest here, so that the round-off of K leaves seven digits
 * of it: the quotient by elements must bring the others back.  The mesh of 400 is exact to 1e-10
 * for the first ten modes. */
static void large_meshes(void **state)
{
    struct modes fine, coarse;
    struct model m;
    (void)state;

    assert_int_equal(model_new(&inclined, LAW_HOOKE, 400, &m), SW_OK);
    assert_int_equal(modes_lowest(&m, 10, SOLVER_LANCZOS, &coarse), SW_OK);
    model_free(&m);
    assert_int_equal(model_new(&inclined, LAW_HOOKE, 30000, &m), SW_OK);
    assert_int_equal(modes_lowest(&m, 10, SOLVER_AUTO, &fine), SW_OK);
    assert_true(fine.counted >= 10);
    for (int i = 0; i < 10; i++)
        near_rel(fine.omega[i], coarse.omega[i], 1e-9);
    modes_free(&fine);
    modes_free(&coarse);
    model_free(&m);
}

/* A cable of 100 chords: all frequencies positive, all modes orthogonal. */
static void hundred_times_slack(void **state)
{
    const struct cable slack[] = {{10000, 10, 1e9, 9.81, 100, 0}, {10440, 1, 1e6, 9.81, 100, 30}};
    (void)state;

    for (int c = 0; c < 2; c++)
        for (int way = 0; way < 2; way++) {
            int k = way == 0 ? 240 : 30;
            struct model m;
            struct modes p;
            double *V, *W;

            assert_int_equal(model_new(&slack[c], LAW_HOOKE, 40, &m), SW_OK);
            assert_int_equal(modes_lowest(&m, k, way == 0 ? SOLVER_DENSE : SOLVER_LANCZOS, &p),
                             SW_OK);
            V = model_vector(&m);
            W = model_vector(&m);
            for (int i = 0; i < k; i++) {
                assert_true(p.omega[i] > 0 && (i == 0 || p.omega[i] >= p.omega[i - 1]));
                modes_shape(&m, &p, i, V);
                for (int j = 0; j <= i; j++) {
                    modes_shape(&m, &p, j, W);
                    near_abs(product(&m, V, W), i == j, 1e-10);
                }
            }
            modes_free(&p);
            model_free(&m);
            free(V);
            free(W);
        }
}

static void one_part(void **state)
{
    struct model m;
    struct modes p;
    int seen[3] = {0, 0, 0};
    double omega;
    (void)state;

    for (int n = 20; n <= 80; n += 60) {
        assert_int_equal(model_new(&inclined, LAW_THESIS, n, &m), SW_OK);
        assert_int_equal(modes_lowest(&m, 16, SOLVER_DENSE, &p), SW_OK);
        seen[PART_PLANE] = seen[PART_LATERAL] = 0;
        for (int i = 0; i < 16; i++) {
            assert_int_equal(modes_of_part(&m, p.plane[i], ++seen[p.plane[i]], &omega), SW_OK);
            near_rel(omega, p.omega[i], 1e-10); /* round-off of the dense one: seen 1.1e-11 */
        }
        assert_int_equal(modes_of_part(&m, PART_LATERAL, 2 * n + 1, &omega), SW_ADMISSIBLE);
        modes_free(&p);
        model_free(&m);
    }
}

static void too_many(void **state)
{
    const struct band huge = {.n = 60000};
    struct model m;
    struct modes p;
    (void)state;

    assert_int_equal(model_new(&pont, LAW_HOOKE, 10, &m), SW_OK);
    assert_int_equal(modes_lanczos_most(10),
                     20 - 4); /* 20 lateral ones, of which ARPACK finds 18 */
    assert_int_equal(modes_lowest(&m, modes_lanczos_most(10), SOLVER_LANCZOS, &p), SW_OK);
    modes_free(&p);
    assert_int_equal(modes_lowest(&m, modes_lanczos_most(10) + 1, SOLVER_LANCZOS, &p),
                     SW_ADMISSIBLE);
    assert_int_equal(modes_lowest(&m, 60, SOLVER_AUTO, &p), SW_OK);
    modes_free(&p);
    model_free(&m);
    assert_int_equal(model_new(&pont, LAW_HOOKE, MODES_MAX_ELEMENTS + 1, &m), SW_OK);
    assert_int_equal(modes_lowest(&m, 1, SOLVER_DENSE, &p), SW_ADMISSIBLE);
    model_free(&m);
    assert_int_equal(lanczos_lowest(&huge, &huge, 23164, NULL, NULL), SW_NOMEM);
}

static void memory_runs_out(void **state)
{
    unsigned long n = 0;
    enum status s;
    (void)state;

    do {
        struct model m = {.n = 0};
        struct modes p;
        double omega;

        mem_fail_at(++n);
        s = model_new(&seil1, LAW_HOOKE, 40, &m);
        if (s == SW_OK)
            s = modes_lowest(&m, 4, SOLVER_LANCZOS, &p);
        if (s == SW_OK) {
            modes_free(&p);
            s = modes_of_part(&m, PART_PLANE, 1, &omega);
        }
        model_free(&m);
        assert_true(s == SW_OK || s == SW_NOMEM);
    } while (s != SW_OK);
    mem_fail_at(0);
    assert_true(n > 40);
}

TEST_MAIN(cmocka_unit_test(sturm_counts), cmocka_unit_test(random_pencils),
          cmocka_unit_test(both_solvers), cmocka_unit_test(large_meshes),
          cmocka_unit_test(hundred_times_slack), cmocka_unit_test(one_part),
          cmocka_unit_test(too_many), cmocka_unit_test(memory_runs_out))
