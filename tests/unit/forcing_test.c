/* Forces from outside: statics against exact lines, drag, dampers and energy of marches. */
#include "check.h"
#include "num/mem.h"
#include "phys/energy.h"
#include "phys/forcing.h"
#include "phys/modes.h"

#include <string.h>

static const double still[6];
static const struct cable bare = {101, 5, 2e7, 9.81, 100, 0};

static struct model new_model(const struct cable *c, int n)
{
    struct model m;

    assert_int_equal(model_new(c, LAW_HOOKE, n, &m), SW_OK);
    return m;
}

/* Equilibrium under a small uniform vertical force: the exact line of a heavier cable; the cubic
 * law is off by the square of the added strain, 1e-4 of the change here. */
static void uniform_force(void **state)
{
    struct model m = new_model(&bare, 20);
    struct force f = {NAN, {0, 1, 0}, NAN, NAN, NULL, NULL};
    struct forcing forcing = {&f, 1, {.cd = 0}};
    double *V = model_vector(&m);
    struct cable heavy = bare;
    struct line line;
    (void)state;

    heavy.g += 1 / bare.mu;
    assert_int_equal(line_solve(&heavy, &line), SW_OK);
    assert_int_equal(forcing_equilibrium(&m, &forcing, 3, still, V), SW_OK);
    for (int k = 0; k <= 20; k++) {
        struct line_point p, q;

        line_at(&m.line, 101 * k / 20.0, &p);
        line_at(&line, 101 * k / 20.0, &q);
        near_abs(V[6 * k], q.x1 - p.x1, 2e-7);
        near_abs(V[6 * k + 2], q.x2 - p.x2, 2e-7);
        near_abs(V[6 * k + 4], 0, 1e-12);
    }
    model_free(&m);
    free(V);
}

/* A small force at a point: the exact flexibility of the line there, but for the mesh, whose own
 * flexibility lacks a share of the order of 1/n. */
static void point_force(void **state)
{
    const struct axes plain = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const struct damper at = {0.3, {0, 1, 0}, 0};
    struct model m = new_model(&bare, 200);
    struct force f = {0.3, {0, 1e-3, 0}, NAN, NAN, NULL, NULL};
    struct forcing forcing = {&f, 1, {.cd = 0}};
    double *V = model_vector(&m), v[3], flexibility;
    (void)state;

    assert_int_equal(damper_flexibility(&m.line, &plain, &at, 1, &flexibility), SW_OK);
    assert_int_equal(forcing_equilibrium(&m, &forcing, 0, still, V), SW_OK);
    model_probe(&m, 0.3, V, v, NULL);
    near_rel(v[1], 1e-3 * flexibility, 5e-3);
    assert_true(v[1] < 1e-3 * flexibility);
    model_free(&m);
    free(V);
}

static double sum_of(const struct model *m, const double *F, int c)
{
    double sum = 0;

    for (int k = 0; k <= m->n; k++)
        sum += F[6 * k + 2 * c];
    return sum;
}

/* Drag of a straight cable across the wind, along it, at 60 degrees, and carried along by it. */
static void drag(void **state)
{
    const struct cable straight = {99.9, 5, 2e7, 0, 100, 0};
    struct model m = new_model(&straight, 7);
    struct forcing f = {NULL, 0, {{0, 0, 20}, 1.2, 0.1, 1.25}};
    double *V = model_vector(&m), *W = model_vector(&m), *F = model_vector(&m);
    double full = 1.25 / 2 * 1.2 * 0.1 * 400 * 100; /* over the stretched length */
    (void)state;

    forcing_subtract(&m, &f, 0, V, NULL, F);
    near_rel(sum_of(&m, F, 2), -full, 1e-12);
    near_abs(sum_of(&m, F, 0), 0, 1e-9);
    memset(F, 0, sizeof *F * model_unknowns(&m));
    f.wind.speed[0] = 20 * cos(PI / 3);
    f.wind.speed[2] = 20 * sin(PI / 3);
    forcing_subtract(&m, &f, 0, V, NULL, F);
    near_rel(sum_of(&m, F, 2), -full * pow(sin(PI / 3), 2), 1e-12);
    near_abs(sum_of(&m, F, 0), 0, 1e-9);
    memset(F, 0, sizeof *F * model_unknowns(&m));
    for (int k = 0; k <= 7; k++)
        W[6 * k + 4] = f.wind.speed[2];
    forcing_subtract(&m, &f, 0, V, W, F);
    near_abs(sum_of(&m, F, 2), 0, 1e-9);
    model_free(&m);
    free(V);
    free(W);
    free(F);
}

/* Harmonic and recorded forces at their times. */
static void over_time(void **state)
{
    const double t[3] = {0, 1, 2}, x[9] = {0, 0, 0, 3, 0, -3, 0, 0, 0};
    struct series record;
    struct model m = new_model(&bare, 4);
    struct force f[2] = {{0.5, {0, 7, 0}, 2, 0.3, NULL, NULL},
                         {NAN, {0, 0, 0}, NAN, NAN, &record, NULL}};
    struct forcing forcing = {f, 2, {.cd = 0}};
    double *V = model_vector(&m), *F = model_vector(&m);
    (void)state;

    assert_int_equal(series_new(3, t, x, &record), SW_OK);
    forcing_subtract(&m, &forcing, 1, V, NULL, F);
    near_rel(sum_of(&m, F, 1), -7 * cos(2.3), 1e-13);
    near_rel(sum_of(&m, F, 0), -3 * bare.L0, 1e-13);
    near_rel(sum_of(&m, F, 2), 3 * bare.L0, 1e-13);
    series_free(&record);
    model_free(&m);
    free(V);
    free(F);
}

/* March of a model in a mode, from rest; the caller frees. */
static void start_in_mode(struct model *m, int mode, double amplitude, struct march_options *o,
                          struct march *a)
{
    double *V = model_vector(m);
    struct modes p;

    assert_int_equal(modes_lowest(m, mode + 1, SOLVER_DENSE, &p), SW_OK);
    assert_int_equal(modes_unit_shape(m, &p, mode, V), SW_OK);
    for (size_t i = 0; i < model_unknowns(m); i++)
        V[i] *= amplitude;
    o->dt = 0.5 * march_critical_step(m);
    assert_int_equal(march_new(m, o, a), SW_OK);
    assert_int_equal(march_start(a, V, NULL), SW_OK);
    modes_free(&p);
    free(V);
}

/* Rate at which the peaks of displacement axis at a place decay, above mean, over n of them. */
static double decay_rate(struct march *a, int n, int axis, double at, double mean)
{
    double one = 0, two = 0, first_peak = 0, first_time = 0;

    for (int peaks = 0;; march_advance(a)) {
        double v[3], now;

        assert_int_equal(march_solve(a), SW_OK);
        model_probe(a->model, at, a->V, v, NULL);
        now = v[axis] - mean;
        if (a->step > 2 && one > two && one >= now) {
            if (peaks == n)
                return log(first_peak / one) / (march_time(a) - first_time);
            if (peaks++ == 0) {
                first_peak = one;
                first_time = march_time(a);
            }
        }
        two = one;
        one = now;
    }
}

/* A steady wind damps small motions along it: decay rate density cd diameter speed/(2 m), m the
 * mass per metre of the straight cable, about its equilibrium in the wind. */
static void wind_damps(void **state)
{
    const struct cable straight = {99.9, 5, 2e7, 0, 100, 0};
    struct model m = new_model(&straight, 6);
    struct march_options o = {.forcing = {NULL, 0, {{0, 0, 30}, 1.2, 0.1, 1.25}}};
    struct march a;
    struct modes p;
    double *V = model_vector(&m), *mode = model_vector(&m), v[3];
    (void)state;

    assert_int_equal(forcing_equilibrium(&m, &o.forcing, 0, still, V), SW_OK);
    model_probe(&m, 0.5, V, v, NULL);
    assert_true(v[2] > 0);
    assert_int_equal(modes_lowest(&m, 2, SOLVER_DENSE, &p), SW_OK);
    assert_int_equal(modes_unit_shape(&m, &p, p.plane[0] == PART_LATERAL ? 0 : 1, mode), SW_OK);
    for (size_t i = 0; i < model_unknowns(&m); i++)
        V[i] += v[2] / 5 * mode[i];
    o.dt = 0.5 * march_critical_step(&m);
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    near_rel(decay_rate(&a, 12, 2, 0.5, v[2]),
             1.25 * 1.2 * 0.1 * 30 / (2 * straight.mu * straight.L0 / straight.span), 0.01);
    march_free(&a);
    modes_free(&p);
    model_free(&m);
    free(V);
    free(mode);
}

/* A light damper in the middle: decay rate c phi^2/2 of the first lateral mode. */
static void damper_damps(void **state)
{
    struct damper d[2] = {{0.5, {0, 0, 1}, 8}, {0.21, {0, 1, 1}, 5}};
    struct model m = new_model(&seil1, 10);
    struct march_options o = {.damper = d, .n_dampers = 1};
    struct march a;
    struct modes p;
    double *V = model_vector(&m), v[3], wanted;
    (void)state;

    assert_int_equal(modes_lowest(&m, 1, SOLVER_DENSE, &p), SW_OK);
    modes_shape(&m, &p, 0, V);
    model_probe(&m, 0.5, V, v, NULL);
    wanted = 8 * v[2] * v[2] / 2;
    start_in_mode(&m, 0, 1e-3, &o, &a);
    near_rel(decay_rate(&a, 20, 2, 0.5, 0), wanted, 5e-3); /* second order in the coefficient */
    march_free(&a);
    model_probe(&m, 0.21, V, v, NULL);
    wanted += 5 * pow(v[2] / sqrt(2), 2) / 2;
    o.n_dampers = 2;
    start_in_mode(&m, 0, 1e-3, &o, &a);
    near_rel(decay_rate(&a, 20, 2, 0.5, 0), wanted, 1e-2);
    march_free(&a);
    modes_free(&p);
    model_free(&m);
    free(V);
}

/* Everything at once: the balance closes with the square of the step. */
static void energy_balance(void **state)
{
    const struct motion shake[2] = {
        {SUPPORT_RIGHT, {0.05, 0.02, -0.03}, 9, {0, 1, 2}, 1, NULL, NULL},
        {SUPPORT_LEFT, {0.01, 0, 0.02}, 5, {0.5, 0, 0}, 0.7, NULL, NULL}};
    const struct damper d[2] = {{0.03, {0, 1, 1}, 100}, {0.6, {0, 1, 0}, 3}};
    const struct force f[2] = {{0.4, {1, 5, 3}, 7, 0.2, NULL, NULL},
                               {NAN, {0, 0.3, 0.5}, NAN, NAN, NULL, NULL}};
    struct march_options o = {.alpha = 0.1,
                              .beta = 3e-3,
                              .motion = shake,
                              .n_motions = 2,
                              .damper = d,
                              .n_dampers = 2,
                              .forcing = {f, 2, {{1, 2, 10}, 1.2, 0.02, 1.225}}};
    struct model m = new_model(&seil2, 10);
    double *work = model_vector(&m), *V = model_vector(&m), *kick = model_vector(&m), error[2];
    (void)state;

    for (int k = 0; k <= 10; k++) { /* smooth: sharp corners need finer steps */
        kick[6 * k + 4] = sin(PI * k / 10);
        kick[6 * k + 5] = PI / seil2.L0 * cos(PI * k / 10);
    }
    for (o.terms = 0; o.terms <= 3; o.terms += o.terms == 0 ? 2 : 1)
        for (int i = 0; i < 2; i++) {
            struct march a;
            struct energy e = {.started = 0};
            double dt = 0.2 * march_critical_step(&m) / (1 + i), before, through;

            o.dt = 0.01 / ceil(0.01 / dt) / (1 + i);
            assert_int_equal(march_new(&m, &o, &a), SW_OK);
            assert_int_equal(forcing_equilibrium(&m, &o.forcing, o.terms, still, V), SW_OK);
            assert_int_equal(march_start(&a, V, NULL), SW_OK);
            while (march_time(&a) < 4) {
                if (fabs(march_time(&a) - 2) < o.dt / 4) {
                    before = energy_now(&a);
                    march_kick(&a, KICK_VELOCITY, 0.5, kick);
                    e.disturbances += energy_now(&a) - before;
                }
                assert_int_equal(march_solve(&a), SW_OK);
                energy_step(&e, &a, work);
                march_advance(&a);
            }
            assert_true(e.dissipated > 0 && e.disturbances != 0 && e.loads != 0);
            through = fabs(e.supports) + fabs(e.loads) + e.dissipated;
            error[i] = fabs(energy_error(&e)) / through;
            march_free(&a);
            if (i == 1) {
                print_message("# terms %d: balance open by %.2g, %.2g of what went through\n",
                              o.terms, error[0], error[1]);
                below(error[1], 4e-6);
                below(error[1], 0.3 * error[0]);
            }
        }
    model_free(&m);
    free(work);
    free(V);
    free(kick);
}

TEST_MAIN(cmocka_unit_test(uniform_force), cmocka_unit_test(point_force), cmocka_unit_test(drag),
          cmocka_unit_test(over_time), cmocka_unit_test(wind_damps), cmocka_unit_test(damper_damps),
          cmocka_unit_test(energy_balance))
