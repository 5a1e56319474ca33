/* Law hooke against an independent chain of straight Hookean bars with lumped masses. */
#include "check.h"
#include "num/band.h"
#include "num/mem.h"
#include "num/pencil.h"
#include "phys/modes.h"

#include <string.h>

#define MODES 12
#define VECTORS 30 /* of the subspace iteration */

/* n bars of unstressed length l0 between n + 1 joints; an inner joint carries mass m. */
struct chain {
    int n;
    double l0, m, EA;
    double (*t)[2]; /* tension vector of each bar */
};

/* Tension vectors (H, V - k m g) with the bars' sum equal to the chord: Newton on (H, V). */
static void hang(struct chain *c, double g, double span, double drop, double H, double V)
{
    double error;

    do {
        double sum[2] = {0, 0}, F[3] = {0, 0, 0}, det;

        for (int k = 0; k < c->n; k++) {
            double v = V - k * c->m * g, T = hypot(H, v), l = c->l0 * (1 + T / c->EA);
            double e1 = H / T, e2 = v / T;

            c->t[k][0] = H;
            c->t[k][1] = v;
            sum[0] += l * e1;
            sum[1] += l * e2;
            F[0] += l / T * (1 - c->l0 / l * e1 * e1);
            F[1] += l / T * (0 - c->l0 / l * e1 * e2);
            F[2] += l / T * (1 - c->l0 / l * e2 * e2);
        }
        sum[0] -= span;
        sum[1] -= drop;
        error = hypot(sum[0], sum[1]) / span;
        det = F[0] * F[2] - F[1] * F[1];
        H -= (F[2] * sum[0] - F[1] * sum[1]) / det;
        V -= (F[0] * sum[1] - F[1] * sum[0]) / det;
    } while (!(error < 1e-13));
}

/* Stiffness of the inner joints, d = 2 directions in the plane or 1 across it. */
static struct band stiffness(const struct chain *c, int d)
{
    struct band K;

    assert_int_equal(band_new(d * (c->n - 1), 2 * d - 1, &K), SW_OK);
    for (int k = 0; k < c->n; k++) {
        double T = hypot(c->t[k][0], c->t[k][1]), l = c->l0 * (1 + T / c->EA);

        for (int i = 0; i < 2 * d; i++)
            for (int j = 0; j <= i; j++) {
                int gi = d * (k - 1) + i, gj = d * (k - 1) + j, a = i % d, b = j % d;
                double along = d == 2 ? c->t[k][a] * c->t[k][b] / (T * T) : 0;
                double value = c->EA / c->l0 * along + T / l * ((a == b) - along);

                if (gj >= 0 && gi < d * (c->n - 1))
                    *band_at(&K, gi, gj) += i / d == j / d ? value : -value;
            }
    }
    return K;
}

/* Lowest eigenvalues of K x = lambda x by subspace iteration, Gram-Schmidt, and a Ritz problem. */
static void lowest(const struct band *K, double lambda[VECTORS])
{
    size_t n = (size_t)K->n;
    double *X = mem_doubles(n * VECTORS), *y = mem_doubles(n), ritz[VECTORS * VECTORS];
    struct band_factor F;
    struct band P, one;
    uint64_t seed = 5;

    for (size_t i = 0; i < n * VECTORS; i++)
        X[i] = uniform_in(&seed, -1, 1);
    assert_int_equal(band_cholesky(K, &F), SW_OK);
    for (int step = 0; step < 40; step++)
        for (int k = 0; k < VECTORS; k++) {
            double *x = X + n * (size_t)k, norm = 0;

            band_solve(&F, x);
            for (int twice = 0; twice < 2; twice++)
                for (int j = 0; j < k; j++) {
                    const double *z = X + n * (size_t)j;
                    double dot = 0;

                    for (size_t i = 0; i < n; i++)
                        dot += z[i] * x[i];
                    for (size_t i = 0; i < n; i++)
                        x[i] -= dot * z[i];
                }
            for (size_t i = 0; i < n; i++)
                norm += x[i] * x[i];
            for (size_t i = 0; i < n; i++)
                x[i] /= sqrt(norm);
        }
    assert_int_equal(band_new(VECTORS, VECTORS - 1, &P), SW_OK);
    assert_int_equal(band_new(VECTORS, 0, &one), SW_OK);
    for (int j = 0; j < VECTORS; j++) {
        memset(y, 0, n * sizeof *y);
        band_multiply_add(K, 1, X + n * (size_t)j, y);
        *band_at(&one, j, j) = 1;
        for (int i = j; i < VECTORS; i++)
            for (size_t r = 0; r < n; r++)
                *band_at(&P, i, j) += X[r + n * (size_t)i] * y[r];
    }
    assert_int_equal(pencil_all(&P, &one, lambda, ritz), SW_OK);
    free(X);
    free(y);
    band_free(&P);
    band_free(&one);
    band_factor_free(&F);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* The first frequencies of the chain of n bars. */
static void chain_frequencies(const struct cable *c, const struct line *line, int n,
                              double omega[MODES])
{
    struct chain chain = {n, c->L0 / n, c->mu * c->L0 / n, c->EA, NULL};
    double lambda[2 * VECTORS];

    chain.t = mem_zeroed((size_t)n, sizeof *chain.t);
    hang(&chain, c->g, c->span, c->drop, line->H, line->V);
    for (int d = 1; d <= 2; d++) {
        struct band K = stiffness(&chain, d);

        lowest(&K, lambda + (d - 1) * VECTORS);
        band_free(&K);
    }
    qsort(lambda, 2 * VECTORS, sizeof *lambda, ascending);
    for (int i = 0; i < MODES; i++)
        omega[i] = sqrt(lambda[i] / chain.m);
    free(chain.t);
}

/* The chain's error falls with 1/n^2: extrapolated from 1000 and 2000 bars it is far below 1e-6. */
static void compare(const struct cable *c, int elements)
{
    double coarse[MODES], fine[MODES], worst = 0;
    struct model m;
    struct modes p;

    assert_int_equal(model_new(c, LAW_HOOKE, elements, &m), SW_OK);
    assert_int_equal(modes_lowest(&m, MODES, SOLVER_DENSE, &p), SW_OK);
    chain_frequencies(c, &m.line, 1000, coarse);
    chain_frequencies(c, &m.line, 2000, fine);
    for (int i = 0; i < MODES; i++) {
        double extrapolated = (4 * fine[i] - coarse[i]) / 3;

        near_rel(p.omega[i], extrapolated, 1e-6);
        worst = fmax(worst, fabs(p.omega[i] / extrapolated - 1));
    }
    print_message("# worst relative difference %.2g\n", worst);
    modes_free(&p);
    model_free(&m);
}

static void taut_cable(void **state)
{
    (void)state;
    compare(&seil2, 60);
}

static void sagging_inclined_cable(void **state)
{
    const struct cable c = {112, 2, 1e6, 9.81, 100, 30};
    (void)state;

    compare(&c, 80);
}

TEST_MAIN(cmocka_unit_test(taut_cable), cmocka_unit_test(sagging_inclined_cable))
