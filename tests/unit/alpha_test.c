/*
 * The implicit scheme against what is known of it: its order, what it leaves of high frequencies,
 * energy, damping in closed form, equilibria; against central differences with fine steps; where
 * those fail; how well the automatic step keeps its tolerance, and that failure is told.
 */
#include "check.h"
#include "num/mem.h"
#include "phys/energy.h"
#include "phys/march.h"
#include "phys/modes.h"

#include <string.h>

enum { N = 6, ALL = 6 * (N + 1), MID = 6 * (N / 2) };

static struct model new_model(int n)
{
    struct model m;

    assert_int_equal(model_new(&seil2, LAW_HOOKE, n, &m), SW_OK);
    return m;
}

static struct march_options implicit(double interval, int substeps, int terms)
{
    return (struct march_options){.scheme = SCHEME_ALPHA,
                                  .dt = substeps ? interval / substeps : interval,
                                  .interval = interval,
                                  .substeps = substeps,
                                  .radius = 0.8,
                                  .terms = terms};
}

/* To `end`, which is a mark of the march; SW_OK or what stopped it. */
static enum status run_to(struct march *a, double end)
{
    enum status s = SW_OK;

    while (s == SW_OK && march_time(a) < end - 1e-9) {
        s = march_solve(a);
        if (s == SW_OK)
            s = march_advance(a);
        /* steps end on the grid of the interval, and at its end */
        assert_true(a->alpha == NULL ||
                    (a->alpha->tick < a->alpha->ticks && a->alpha->ticks % a->alpha->stride == 0 &&
                     a->alpha->tick % a->alpha->stride == 0));
    }
    if (s == SW_OK)
        near_abs(march_time(a), end, 1e-9);
    return s;
}

/* V at `end` from V0 with velocity W0. */
static void solve(const struct model *m, const struct march_options *o, const double *V0,
                  const double *W0, double end, double *V)
{
    struct march a;

    assert_int_equal(march_new(m, o, &a), SW_OK);
    assert_int_equal(march_start(&a, V0, W0), SW_OK);
    assert_int_equal(run_to(&a, end), SW_OK);
    memcpy(V, a.V, ALL * sizeof *V);
    march_free(&a);
}

/* Largest difference of displacements. */
static double apart(const double *a, const double *b)
{
    double most = 0;

    for (int i = 0; i < ALL; i += 2)
        if (!(fabs(a[i] - b[i]) <= most))
            most = fabs(a[i] - b[i]);
    return most;
}

/* Mode k from 0, or the next lower one that moves at a node; largest displacement 1 m. */
static void shape(const struct model *m, int k, double *V, double *ret_omega)
{
    struct modes p;

    assert_int_equal(modes_lowest(m, k + 1, SOLVER_DENSE, &p), SW_OK);
    while (modes_unit_shape(m, &p, k, V) != SW_OK)
        assert_true(--k >= 0);
    *ret_omega = p.omega[k];
    modes_free(&p);
}

/* Both supports move, in the ramp and behind it; dampers, forces, a wind; all terms. */
static const struct motion shake[] = {
    {.support = SUPPORT_RIGHT,
     .amplitude = {0.02, 0.05, -0.03},
     .omega = 5,
     .phase = {0.3, 1, 2},
     .ramp = 2},
    {.support = SUPPORT_LEFT, .amplitude = {0.01, 0, 0.05}, .omega = 3.3, .ramp = 1}};
static const struct damper dampers[] = {{0.3, {0, 1, 1}, 30}, {0.6, {0, 1, -0.5}, 5}};
static const struct force forces[] = {
    {.position = 0.4, .value = {1, 5, 3}, .omega = 4, .phase = 0.2},
    {.position = NAN, .value = {0, 0.3, 0.5}, .omega = NAN}};

static struct march_options everything(struct march_options o)
{
    o.alpha = 0.1;
    o.beta = 3e-3;
    o.terms = 3;
    o.motion = shake;
    o.n_motions = 2;
    o.damper = dampers;
    o.n_dampers = 2;
    o.forcing = (struct forcing){forces, 2, {{1, 2, 10}, 1.2, 0.02, 1.225}};
    return o;
}

/* Half the step, a quarter of the error: for several radii, by steps of 1/128 to 1/512 s (mode 1
 * has a period of 1.4 s), from a smooth start; against central differences of 1e-5 s. */
static void order_two(void **state)
{
    static const double radius[] = {1, 0.8, 0.3, 0};
    struct model m = new_model(N);
    struct march_options fine = everything((struct march_options){.dt = 1 / 65536.0});
    double rest[ALL] = {0}, exact[ALL];
    (void)state;

    fine.substeps = 1;
    fine.interval = fine.dt;
    solve(&m, &fine, rest, NULL, 4, exact);
    for (int k = 0; k < 4; k++) {
        double error[3];

        for (int i = 0; i < 3; i++) {
            struct march_options o = everything(implicit(0.25, 32 << i, 3));
            double V[ALL];

            o.radius = radius[k];
            solve(&m, &o, rest, NULL, 4, V);
            error[i] = apart(V, exact);
        }
        print_message("# radius %g: errors %.2g %.2g %.2g m, orders %.2f %.2f\n", radius[k],
                      error[0], error[1], error[2], log2(error[0] / error[1]),
                      log2(error[1] / error[2]));
        below(fabs(log2(error[1] / error[2]) - 2), 0.15);
        below(error[2], 2e-3); /* of 0.6 m */
    }
    model_free(&m);
}

/* The highest mode, at omega dt = 1e7 (the lowest has 2e4): what is left after a step is the
 * radius.  The roots there are a pair, so that n steps leave up to n^2 r^n: over steps 200 to 300
 * that is 1 per cent a step.
 */
static void radius_at_infinity(void **state)
{
    static const double radius[] = {0.3, 0.5, 0.8, 0.95};
    struct model m = new_model(N);
    double V[ALL], W[ALL], omega, left;
    (void)state;

    shape(&m, 6 * N - 1, V, &omega);
    for (int i = 0; i < ALL; i++)
        W[i] = 0;
    for (int k = 0; k < 4; k++) {
        struct march_options o = implicit(1e7 / omega, 1, 0);
        double energy[2] = {0, 0};
        struct march a;

        o.radius = radius[k];
        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(march_start(&a, V, W), SW_OK);
        for (int i = 0; i < 300; i++) {
            assert_int_equal(march_solve(&a), SW_OK);
            assert_int_equal(march_advance(&a), SW_OK);
            if (i == 199 || i == 299)
                for (int j = 0; j < ALL; j += 2)
                    energy[i == 299] += a.V[j] * a.V[j];
        }
        left = pow(energy[1] / energy[0], 1 / 200.0);
        print_message("# radius %g: %.4f left\n", radius[k], left);
        near_rel(left, radius[k], 0.02);
        march_free(&a);
    }
    model_free(&m);
}

/* Radius 0 forgets the highest mode at once; the lowest one, at 200 steps a period, goes on. */
static void radius_zero(void **state)
{
    struct model m = new_model(N);
    double V[ALL], end[ALL], omega;
    struct march_options o;
    (void)state;

    shape(&m, 6 * N - 1, V, &omega);
    o = implicit(1e4 / omega, 1, 0);
    o.radius = 0;
    solve(&m, &o, V, NULL, 10 * o.interval, end);
    below(apart(end, (double[ALL]){0}), 1e-4);
    shape(&m, 0, V, &omega);
    o = implicit(2 * PI / omega, 200, 0);
    o.radius = 0;
    solve(&m, &o, V, NULL, 10 * o.interval, end);
    /* algorithmic damping of radius 0: (omega dt)^3/... : seen 3e-3 in ten periods */
    below(apart(end, V), 0.02);
    model_free(&m);
}

/* Radius 1, linear: the energy is that of the start, whatever the step. */
static void energy_stays(void **state)
{
    struct model m = new_model(N);
    double V[ALL], W[ALL], omega;
    (void)state;

    shape(&m, 1, V, &omega);
    shape(&m, 0, W, &omega);
    for (int substeps = 3; substeps <= 300; substeps *= 10) {
        struct march_options o = implicit(2 * PI / omega, substeps, 0);
        double start;
        struct march a;

        o.radius = 1;
        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(march_start(&a, V, W), SW_OK);
        start = energy_now(&a);
        assert_true(start > 1);
        assert_int_equal(run_to(&a, 5 * o.interval), SW_OK);
        near_rel(energy_now(&a), start, 1e-10);
        march_free(&a);
    }
    model_free(&m);
}

/* alpha and beta: the amplitude falls by e^{-zeta omega t}; a whole number of damped periods on. */
static void damping(void **state)
{
    static const double alpha[] = {0.2, 0}, beta[] = {0, 0.01};
    struct model m = new_model(N);
    double V[ALL], end[ALL], omega;
    (void)state;

    shape(&m, 2, V, &omega);
    for (int k = 0; k < 2; k++) {
        double zeta = alpha[k] / (2 * omega) + beta[k] * omega / 2;
        double period = 2 * PI / (omega * sqrt(1 - zeta * zeta)),
               left = exp(-zeta * omega * 5 * period);
        struct march_options o = implicit(period, 400, 0);

        o.alpha = alpha[k];
        o.beta = beta[k];
        solve(&m, &o, V, NULL, 5 * period, end);
        assert_true(left < 0.9);
        /* of the mode's displacement, the phase being late by (omega dt)^2/12 a radian */
        for (int i = 0; i < ALL; i += 2)
            near_abs(end[i], left * V[i], 2e-3 * left);
    }
    model_free(&m);
}

/* Forces of the supports are those of central differences, and the balance of energy closes: both
 * with the square of the step, though the scheme's own accelerations are late by a part of it. */
static void support_forces_and_energy(void **state)
{
    struct model m = new_model(N);
    struct march_options fine = everything((struct march_options){.dt = 1 / 65536.0});
    double rest[ALL] = {0}, work[ALL], f[6], g[6], error[3] = {0}, open[3];
    struct march a;
    (void)state;

    fine.substeps = 1;
    fine.interval = fine.dt;
    assert_int_equal(march_new(&m, &fine, &a), SW_OK);
    assert_int_equal(march_start(&a, rest, NULL), SW_OK);
    assert_int_equal(run_to(&a, 3), SW_OK);
    assert_int_equal(march_solve(&a), SW_OK);
    march_support_force(&a, f);
    assert_true(fabs(f[0] + m.line.H) > 0.01 * m.line.H);
    march_free(&a);
    for (int i = 0; i < 3; i++) {
        struct march_options o = everything(implicit(1 / 16.0, 8 << i, 3));
        struct energy e = {.started = 0};

        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(march_start(&a, rest, NULL), SW_OK);
        for (;;) {
            assert_int_equal(march_solve(&a), SW_OK);
            energy_step(&e, &a, work);
            if (march_time(&a) > 3 - 1e-9)
                break;
            assert_int_equal(march_advance(&a), SW_OK);
        }
        march_support_force(&a, g);
        for (int k = 0; k < 6; k++)
            error[i] = fmax(error[i], fabs(g[k] - f[k]) / m.line.H);
        open[i] = fabs(energy_error(&e)) / (fabs(e.supports) + fabs(e.loads) + e.dissipated);
        assert_true(e.supports != 0 && e.loads != 0 && e.dissipated > 0);
        march_free(&a);
    }
    print_message("# support forces off by %.2g %.2g %.2g of H, energy open by %.2g %.2g %.2g\n",
                  error[0], error[1], error[2], open[0], open[1], open[2]);
    below(error[2], 1e-3);
    below(open[2], 1e-3);
    below(fabs(log2(error[1] / error[2]) - 2), 0.3);
    below(open[2], 0.3 * open[1]); /* the trapezoidal rule meets corners of the ramps */
    model_free(&m);
}

/* Thirty critical steps in one, nonlinear and kicked: bounded, where central differences end. */
static void long_steps(void **state)
{
    struct model m = new_model(N);
    double dt = 30 * march_critical_step(&m), omega, V[ALL], rest[ALL] = {0};
    struct march_options o = implicit(dt, 1, 3), central = {.dt = dt, .terms = 3};
    struct march a;
    (void)state;

    shape(&m, 0, V, &omega);
    for (int i = 0; i < ALL; i++)
        V[i] *= 0.5;
    assert_int_equal(march_new(&m, &central, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    assert_int_equal(march_solve(&a), SW_DIVERGED);
    march_free(&a);
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    for (int i = 0; i < 2000; i++) {
        assert_int_equal(march_solve(&a), SW_OK);
        assert_int_equal(march_advance(&a), SW_OK);
        below(apart(a.V, rest), 1);
    }
    march_free(&a);
    model_free(&m);
}

/* In equilibrium under a constant force nothing moves; and damped motion ends there. */
static void equilibrium(void **state)
{
    static const struct force pull = {.position = 0.4, .value = {3, 60, -30}, .omega = NAN};
    const double still[6] = {0};
    struct model m = new_model(N);
    struct march_options o = implicit(0.05, 0, 3);
    double there[ALL], V[ALL], rest[ALL] = {0};
    (void)state;

    o.tolerance = 1e-4;
    o.alpha = 4;
    o.forcing = (struct forcing){.force = &pull, .n = 1};
    assert_int_equal(forcing_equilibrium(&m, &o.forcing, 3, still, there), SW_OK);
    assert_true(apart(there, rest) > 0.05);
    solve(&m, &o, there, NULL, 5, V);
    below(apart(V, there), 1e-9);
    solve(&m, &o, rest, NULL, 20, V);
    below(apart(V, there), 1e-6); /* e^{-2 20} of the way, and the tolerance of Newton's steps */
    model_free(&m);
}

/* Nothing moves, not even the scale by which errors are judged: then it moves. */
static void rest_and_kick(void **state)
{
    struct model m = new_model(N);
    struct march_options o = implicit(0.05, 0, 3);
    double rest[ALL] = {0}, V[ALL], omega;
    struct march a;
    (void)state;

    o.tolerance = 1e-4;
    shape(&m, 0, V, &omega);
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, rest, NULL), SW_OK);
    assert_int_equal(run_to(&a, 1), SW_OK);
    near_abs(apart(a.V, rest), 0, 0);
    march_kick(&a, KICK_VELOCITY, 0.1 * omega, V);
    assert_int_equal(run_to(&a, 1.35), SW_OK); /* about a quarter of 1.38 s */
    near_abs(apart(a.V, rest), 0.1, 0.01);
    march_free(&a);
    model_free(&m);
}

/* A hundredth of the tolerance, by theory (1/100)^(2/3) = 1/22 of the error, with 4.6 times the
 * steps; each step's error stays below the tolerance by the scheme's own measure. */
static void tolerance(void **state)
{
    struct model m = new_model(N);
    struct march_options fine = everything((struct march_options){.dt = 1 / 65536.0});
    double rest[ALL] = {0}, exact[ALL], error[2];
    long steps[2];
    (void)state;

    fine.substeps = 1;
    fine.interval = fine.dt;
    solve(&m, &fine, rest, NULL, 8, exact);
    for (int k = 0; k < 2; k++) {
        struct march_options o = everything(implicit(0.125, 0, 3));
        struct march a;

        o.tolerance = k ? 1e-6 : 1e-4;
        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(march_start(&a, rest, NULL), SW_OK);
        while (march_time(&a) < 8) {
            double before[ALL], A[ALL], t = march_time(&a), dt, most = 0;

            assert_int_equal(march_solve(&a), SW_OK);
            memcpy(before, a.alpha->A, sizeof before);
            assert_int_equal(march_advance(&a), SW_OK);
            memcpy(A, a.alpha->A, sizeof A);
            dt = march_time(&a) - t;
            for (int i = 0; i < ALL; i += 2)
                most = fmax(most, fabs(A[i] - before[i]));
            below(fabs(a.alpha->b - 1.0 / 6) * dt * dt * most,
                  o.tolerance * a.alpha->scale * (1 + 1e-12));
        }
        near_abs(march_time(&a), 8, 1e-12); /* no step goes beyond a mark */
        error[k] = apart(a.V, exact);
        steps[k] = a.step;
        print_message("# tolerance %g: %ld steps, %ld thrown away, %.1f Newton steps each, error "
                      "%.2g m\n",
                      o.tolerance, a.step, a.alpha->rejected,
                      (double)a.alpha->iterations / (double)(a.step + a.alpha->rejected), error[k]);
        assert_true(a.alpha->rejected < a.step / 4);
        assert_true(a.alpha->iterations < 5 * (a.step + a.alpha->rejected));
        march_free(&a);
    }
    below(error[0], 0.02);
    assert_true(error[0] > 8 * error[1] && error[0] < 60 * error[1]);
    assert_true(steps[1] > 3 * steps[0] && steps[1] < 7 * steps[0]);
    model_free(&m);
}

/* A support torn away by 200 m: no balance in a step of 0.5 s, or none at all. */
static void failure_is_told(void **state)
{
    static const struct motion tear = {.support = SUPPORT_RIGHT,
                                       .amplitude = {1e5, 0, 0},
                                       .omega = 50,
                                       .phase = {1.6, 0, 0}};
    struct model m = new_model(N);
    double rest[ALL] = {0};
    (void)state;

    for (int substeps = 0; substeps <= 1; substeps++) {
        struct march_options o = implicit(0.5, substeps, 3);
        enum status s;
        struct march a;

        o.tolerance = 1e-12; /* no step is short enough for that */
        o.motion = &tear;
        o.n_motions = 1;
        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(march_start(&a, rest, NULL), SW_OK);
        s = run_to(&a, 5);
        assert_true(s == SW_NOCONV || s == SW_INDEFINITE);
        march_free(&a);
    }
    model_free(&m);
}

static void memory_runs_out(void **state)
{
    struct model m = new_model(N);
    struct march_options o = everything(implicit(0.1, 4, 3));
    double rest[ALL] = {0};
    unsigned long n = 0;
    enum status s;
    (void)state;

    do {
        struct march a;

        mem_fail_at(++n);
        s = march_new(&m, &o, &a);
        if (s == SW_OK) {
            s = march_start(&a, rest, NULL);
            if (s == SW_OK)
                s = run_to(&a, 0.1); /* allocates nothing */
            march_free(&a);
        }
        assert_true(s == SW_OK || s == SW_NOMEM);
    } while (s != SW_OK);
    mem_fail_at(0);
    assert_true(n > 20);
    model_free(&m);
}

TEST_MAIN(cmocka_unit_test(order_two), cmocka_unit_test(radius_at_infinity),
          cmocka_unit_test(radius_zero), cmocka_unit_test(energy_stays), cmocka_unit_test(damping),
          cmocka_unit_test(support_forces_and_energy), cmocka_unit_test(long_steps),
          cmocka_unit_test(equilibrium), cmocka_unit_test(rest_and_kick),
          cmocka_unit_test(tolerance), cmocka_unit_test(failure_is_told),
          cmocka_unit_test(memory_runs_out))
