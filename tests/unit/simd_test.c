/* The same bodies by registers of any width: band solvers, forces of a cable, flows of Floquet. */
#include "check.h"

#include "num/band.h"
#include "num/simd.h"
#include "phys/floquet.h"
#include "phys/force.h"
#include "rope.h"

#include <string.h>

#define N 30

/* A band of width kd, its solutions in all ways, to x (3 N + 4 N). */
static void solve_band(int kd, double *x)
{
    uint64_t seed = 1;
    struct band A;
    struct band_factor F;

    assert_int_equal(band_new(N, kd, &A), SW_OK);
    for (int j = 0; j < N; j++)
        for (int i = j; i < N && i - j <= kd; i++)
            *band_at(&A, i, j) = uniform_in(&seed, -1, 1) + (i == j ? 2 * kd + 1 : 0);
    for (int i = 0; i < 7 * N; i++)
        x[i] = uniform_in(&seed, -1, 1);
    assert_int_equal(band_cholesky(&A, &F), SW_OK);
    band_solve(&F, x);
    band_solve_lower(&F, x + N);
    band_solve_upper(&F, x + N);
    band_solve_four(&F, x + 3 * N);
    if (kd == 3 || kd == 7 || kd == 11) {
        assert_int_equal(band_factor_in_place(&A), SW_OK);
        band_solve_in_place(&A, x + 2 * N);
        *band_at(&A, N - 1, N - 1) = -1;
    }
    band_factor_free(&F);
    band_free(&A);
}

static void bands(void **state)
{
    static const int kd[] = {1, 3, 5, 7, 11, 13};
    (void)state;

    for (int k = 0; k < 6; k++) {
        double wide[7 * N], narrow[7 * N];

        solve_band(kd[k], wide);
        simd_most = 2;
        solve_band(kd[k], narrow);
        simd_most = 8;
        for (int i = 0; i < 7 * N; i++)
            near_abs(narrow[i], wide[i], 1e-14);
    }
}

/* Forces and tangent of a cable of 9 elements (the last group of four is not full), to f. */
#define ELEMENTS 9
#define UNKNOWNS (6 * (ELEMENTS + 1))

static void forces(int terms, double *f)
{
    uint64_t seed = 2;
    struct model m;
    struct force_table t;
    struct force_extremes seen = {INFINITY, -INFINITY};
    struct band J;
    double V[UNKNOWNS];

    assert_int_equal(model_new(&seil2, LAW_THESIS, ELEMENTS, &m), SW_OK);
    assert_int_equal(force_new(&m, &t), SW_OK);
    assert_int_equal(band_new(UNKNOWNS, 11, &J), SW_OK);
    for (int i = 0; i < UNKNOWNS; i++)
        V[i] = uniform_in(&seed, -0.01, 0.01);
    force_all(&t, terms, V, f, &seen);
    force_tangent(&t, terms, V, 1, &J);
    f[UNKNOWNS] = seen.least_force;
    f[UNKNOWNS + 1] = seen.most_stiffened;
    for (int i = 0; i < UNKNOWNS; i++)
        V[i] = uniform_in(&seed, -1, 1);
    memset(f + UNKNOWNS + 2, 0, sizeof V);
    band_multiply_add(&J, 1, V, f + UNKNOWNS + 2);
    band_free(&J);
    force_free(&t);
    model_free(&m);
}

static void cable(void **state)
{
    (void)state;
    for (int terms = 0; terms <= 3; terms++) {
        double wide[2 * UNKNOWNS + 2], narrow[2 * UNKNOWNS + 2], most = 0;

        forces(terms, wide);
        simd_most = 2;
        forces(terms, narrow);
        simd_most = 8;
        for (int i = 0; i < 2 * UNKNOWNS + 2; i++)
            most = fmax(most, fabs(wide[i]));
        for (int i = 0; i < 2 * UNKNOWNS + 2; i++)
            near_abs(narrow[i], wide[i], 1e-13 * most);
    }
}

static void flows(void **state)
{
    (void)state;
    for (int n = 1; n <= 5; n++) {
        struct rope r;
        struct parametric p;
        struct floquet wide = {.steps = 0}, narrow = {.steps = 0};

        rope_begin(&seil2, LAW_THESIS, 6, n, ALPHA_2, BETA_2, 0, &r);
        assert_int_equal(map_equations(&r.map, 0.95, &p), SW_OK);
        assert_int_equal(floquet_solve(&p, 1.9 * r.p.omega[0], 0.1, 1e-9, &wide), SW_OK);
        simd_most = 2;
        assert_int_equal(floquet_solve(&p, 1.9 * r.p.omega[0], 0.1, 1e-9, &narrow), SW_OK);
        simd_most = 8;
        near_rel(narrow.growth, wide.growth, 1e-8);
        assert_int_equal(narrow.steps, wide.steps);
        parametric_free(&p);
        rope_end(&r);
    }
}

TEST_MAIN(cmocka_unit_test(bands), cmocka_unit_test(cable), cmocka_unit_test(flows))
