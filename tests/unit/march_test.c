/* Time integration: exact frequency shift, energy, order, (4.17) itself, published responses. */
#include "check.h"
#include "num/mem.h"
#include "phys/march.h"
#include "phys/modes.h"

#include <string.h>

enum { N = 10, ALL = 6 * (N + 1), MID = 6 * (N / 2) };

static struct model new_model(const struct cable *c, enum law law, int n)
{
    struct model m;

    assert_int_equal(model_new(c, law, n, &m), SW_OK);
    return m;
}

static void step(struct march *a)
{
    assert_int_equal(march_solve(a), SW_OK);
    march_advance(a);
}

/* Started in mode i (from 0) without damping, linear.  V gets the unit shape. */
static struct march in_mode(const struct model *m, int i, double fraction, double *omega, double *V)
{
    struct march_options o = {.dt = fraction * march_critical_step(m)};
    struct modes p;
    struct march a;

    assert_int_equal(modes_lowest(m, i + 1, SOLVER_DENSE, &p), SW_OK);
    *omega = p.omega[i];
    modes_unit_shape(m, &p, i, V);
    modes_free(&p);
    assert_int_equal(march_new(m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    return a;
}

/* omega (1 + (omega dt)^2/24) to the next term 3 (omega dt)^4/640, from zero crossings. */
static void frequency_shift(void **state)
{
    (void)state;
    for (int i = 0; i < 5; i++) {
        struct model m = new_model(&pont, LAW_HOOKE, N);
        double V[ALL], omega, wanted, time = 0;
        struct march a = in_mode(&m, i, 0.9, &omega, V);
        int at = 0, crossings = 0;

        for (int j = 0; j < ALL; j += 2)
            at = fabs(V[j]) > fabs(V[at]) ? j : at;
        while (crossings < 400) {
            double before = a.V[at];

            step(&a);
            if (before * a.V[at] < 0 || a.V[at] == 0) {
                crossings++;
                time = march_time(&a) - a.options.dt * a.V[at] / (a.V[at] - before);
            }
        }
        wanted = omega * (1 + pow(omega * a.options.dt, 2) / 24);
        near_rel((crossings - 0.5) * PI / time, wanted, 1e-6);
        march_free(&a);
        model_free(&m);
    }
}

/* The scheme's own energy, V' M V'/2 + V(t) K V(t-dt)/2, over 1000 periods of mode 2. */
static void energy_is_constant(void **state)
{
    struct model m = new_model(&pont, LAW_HOOKE, N);
    double V[ALL], omega, first = 0, worst = 0;
    struct march a = in_mode(&m, 1, 0.9, &omega, V);
    struct band M, K;
    (void)state;

    assert_int_equal(model_mass(&m, PART_ALL, &M), SW_OK);
    assert_int_equal(model_stiffness(&m, PART_ALL, &K), SW_OK);
    for (long k = 0; march_time(&a) < 1000 * 2 * PI / omega; k++) {
        if (k % 997 == 0) {
            double MD[ALL] = {0}, KV[ALL] = {0}, E = 0;

            band_multiply_add(&M, 1 / (a.options.dt * a.options.dt), a.D, MD);
            band_multiply_add(&K, 1, a.V, KV);
            for (int i = 0; i < ALL; i++)
                E += (a.D[i] * MD[i] + (a.V[i] - a.D[i]) * KV[i]) / 2;
            first = k == 0 ? E : first;
            worst = fmax(worst, fabs(E / first - 1));
        }
        step(&a);
    }
    print_message("# energy drifts by %.2g in %ld steps\n", worst, a.step);
    below(worst, 1e-9);
    band_free(&M);
    band_free(&K);
    march_free(&a);
    model_free(&m);
}

static const struct motion shake = {SUPPORT_RIGHT, {0.05, 0.01, 0.02}, 9.124, {0.4, 0, 0}, 0, NULL,
                                    NULL};

/* Error at 1.5 s against a run with 1/16 of the step: falls by 4 when the step is halved. */
static void order_two(void **state)
{
    struct model m = new_model(&seil2, LAW_HOOKE, N);
    double v[4];
    const int divisor[] = {1, 2, 4, 32};
    (void)state;

    for (int k = 0; k < 4; k++) {
        struct march_options o = {.alpha = 0.1,
                                  .beta = 1e-4,
                                  .dt = 1.5 / (3000 * divisor[k]),
                                  .terms = 3,
                                  .motion = &shake,
                                  .n_motions = 1};
        struct march a;
        double V[ALL] = {0};

        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(march_start(&a, V, NULL), SW_OK);
        while (a.step < 3000 * divisor[k])
            step(&a);
        v[k] = a.V[MID + 4];
        march_free(&a);
    }
    near_abs((v[0] - v[3]) / (v[1] - v[3]), 4, 0.15);
    near_abs((v[1] - v[3]) / (v[2] - v[3]), 4, 0.15);
    model_free(&m);
}

/* ret := A x for the free rows; x has free and prescribed values. */
static void apply(const struct partition *A, double c, const double *x, const double b[6],
                  double *ret)
{
    band_multiply_add(&A->free, c, x, ret);
    for (int j = 0; j < 6; j++)
        for (int i = 0; i < A->free.n; i++)
            ret[i] += c * A->support[i + A->free.n * j] * b[j];
}

static void cut(const struct model *m, const struct band *A, struct partition *ret)
{
    assert_int_equal(model_partition(m, A, ret), SW_OK);
}

/* Equation (4.17) in its own form (mended as in theory section 9) against the increment form. */
static void equation_417(void **state)
{
    struct model m = new_model(&seil2, LAW_HOOKE, N);
    struct march_options o = {
        .alpha = 0.2, .beta = 3e-4, .dt = 5e-4, .terms = 3, .motion = &shake, .n_motions = 1};
    struct band M, K, C, A;
    struct partition Mp, Cp, Ap;
    struct band_factor F;
    struct march a;
    int keep[ALL], held[6], n = 6 * N;
    double now[ALL] = {0}, past[ALL], next[ALL], rhs[ALL], force[ALL], u[3][6], worst = 0;
    (void)state;

    model_free_unknowns(&m, PART_ALL, keep);
    model_prescribed(&m, held);
    assert_int_equal(model_mass(&m, PART_ALL, &M), SW_OK);
    assert_int_equal(model_stiffness(&m, PART_ALL, &K), SW_OK);
    assert_int_equal(band_combine(o.alpha, &M, o.beta, &K, &C), SW_OK);
    assert_int_equal(band_combine(1 / (o.dt * o.dt), &M, 1 / (2 * o.dt), &C, &A), SW_OK);
    cut(&m, &M, &Mp);
    cut(&m, &C, &Cp);
    cut(&m, &A, &Ap);
    assert_int_equal(band_cholesky(&Ap.free, &F), SW_OK);
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, now, NULL), SW_OK);
    for (int i = 0; i < n; i++)
        past[i] = a.V[keep[i]] - a.D[keep[i]];
    for (int i = 0; i < n; i++)
        now[i] = a.V[keep[i]];
    for (int k = 0; k < 1000; k++) {
        double V[ALL];

        for (int j = 0; j < 3; j++)
            motion_sum(&shake, 1, (k + j - 1) * o.dt, u[j], NULL, NULL);
        for (int i = 0; i < n; i++)
            V[keep[i]] = now[i];
        for (int i = 0; i < 6; i++)
            V[held[i]] = u[1][i];
        model_force(&m, 3, V, force, NULL);
        for (int i = 0; i < n; i++)
            rhs[i] = -force[keep[i]];
        apply(&Mp, 2 / (o.dt * o.dt), now, u[1], rhs);
        apply(&Mp, -1 / (o.dt * o.dt), past, u[0], rhs);
        apply(&Cp, 1 / (2 * o.dt), past, u[0], rhs);
        for (int i = 0; i < n; i++)
            next[i] = 0;
        apply(&Ap, -1, next, u[2], rhs);
        memcpy(next, rhs, sizeof next);
        band_solve(&F, next);
        step(&a);
        for (int i = 0; i < n; i++)
            worst = fmax(worst, fabs(next[i] - a.V[keep[i]]));
        memcpy(past, now, sizeof past);
        memcpy(now, next, sizeof now);
    }
    below(worst, 1e-9); /* (4.17) itself loses eps/(omega dt)^2 a step to cancellation */
    near_abs(a.V[held[3]], u[2][3], 1e-13);
    partition_free(&Mp);
    partition_free(&Cp);
    partition_free(&Ap);
    band_free(&M);
    band_free(&K);
    band_free(&C);
    band_free(&A);
    band_factor_free(&F);
    march_free(&a);
    model_free(&m);
}

/* Logarithmic decrement of mode 1: zeta omega = (alpha + beta omega^2)/2. */
static void rayleigh_decay(void **state)
{
    struct model m = new_model(&seil1, LAW_HOOKE, N);
    struct march_options o = {.alpha = 0.08,
                              .beta = 6e-4,
                              .dt = 0.5 * march_critical_step(&m),
                              .terms = 0,
                              .motion = NULL,
                              .n_motions = 0};
    struct modes p;
    struct march a;
    double V[ALL], rate, omega, first, period;
    (void)state;

    assert_int_equal(modes_lowest(&m, 1, SOLVER_DENSE, &p), SW_OK);
    modes_unit_shape(&m, &p, 0, V);
    omega = p.omega[0];
    rate = (o.alpha + o.beta * omega * omega) / 2;
    period = 2 * PI / sqrt(omega * omega - rate * rate);
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    first = a.V[MID + 4];
    while (march_time(&a) < 20 * period - a.options.dt / 2)
        step(&a); /* stops within half a step of an extreme: cos > 1 - (omega dt)^2/8 */
    near_rel(log(first / a.V[MID + 4]), rate * 20 * period, 1e-4);
    modes_free(&p);
    march_free(&a);
    model_free(&m);
}

/* Forces of the supports: static ones of the exact line; their sum is the change of momentum. */
static void support_forces(void **state)
{
    const struct cable c = {112, 2, 1e6, 9.81, 100, 30};
    struct motion still = {SUPPORT_RIGHT, {0.5, -0.3, 0.8}, 1e-9, {0, 0, 0}, 0, NULL, NULL};
    struct model m = new_model(&c, LAW_HOOKE, 40);
    struct march_options o = {.alpha = 0.1,
                              .beta = 1e-4,
                              .dt = 0.5 * march_critical_step(&m),
                              .terms = 3,
                              .motion = &still,
                              .n_motions = 1};
    double b[6], V[6 * 41], f[6], one[6 * 41], sum[6 * 41] = {0};
    struct cable moved = c;
    struct line exact;
    struct march a;
    struct band M;
    (void)state;

    motion_sum(&still, 1, 0, b, NULL, NULL);
    assert_int_equal(model_equilibrium(&m, 3, b, V), SW_OK);
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    assert_int_equal(march_solve(&a), SW_OK);
    march_support_force(&a, f);
    moved.span = hypot(c.span + b[3], b[5]);
    moved.drop += b[4];
    assert_int_equal(line_solve(&moved, &exact), SW_OK);
    near_rel(f[0], -exact.H * (c.span + b[3]) / moved.span, 1e-4);
    near_rel(f[1], -exact.V, 1e-4);
    near_rel(f[5], exact.H * b[5] / moved.span, 1e-4);
    near_rel(f[1] + f[4], -exact.W, 1e-9);

    /* kicked: total force - weight = momentum's change + external damping alpha M v */
    for (int i = 0; i < 6 * 41; i++)
        V[i] = i % 6 == 2 && i > 6 && i < 6 * 40 ? 0.3 : 0;
    march_kick(&a, KICK_VELOCITY, 2, V);
    march_advance(&a);
    assert_int_equal(march_solve(&a), SW_OK);
    march_support_force(&a, f);
    assert_int_equal(model_mass(&m, PART_ALL, &M), SW_OK);
    for (int i = 0; i < 6 * 41; i++) /* acceleration plus alpha times central velocity */
        one[i] = a.dd[i] / (o.dt * o.dt) + o.alpha * (2 * a.D[i] + a.dd[i]) / (2 * o.dt);
    band_multiply_add(&M, 1, one, sum);
    for (int axis = 0; axis < 3; axis++) {
        double change = 0;

        for (int k = 0; k <= 40; k++)
            change += sum[6 * k + 2 * axis];
        near_abs(f[axis] + f[axis + 3] + (axis == 1 ? exact.W : 0), change, 1e-6 * exact.W);
    }
    band_free(&M);
    march_free(&a);
    model_free(&m);
}

static void kicks(void **state)
{
    struct model m = new_model(&seil1, LAW_HOOKE, N);
    struct march_options o = {.dt = 1e-4, .terms = 3};
    double V[ALL] = {0}, shape[ALL], D;
    struct march a;
    (void)state;

    for (int i = 0; i < ALL; i++)
        shape[i] = 1;
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    D = a.D[MID + 4];
    march_kick(&a, KICK_DISPLACEMENT, 0.01, shape);
    near_abs(a.V[MID + 4], 0.01, 1e-17);
    near_abs(a.D[MID + 4], D, 0);
    march_kick(&a, KICK_VELOCITY, 3, shape);
    near_abs(a.V[MID + 4], 0.01, 1e-17);
    near_abs(a.D[MID + 4], D + 3e-4, 1e-17);
    assert_true(a.V[4] == 0 && a.D[6 * N + 2] == 0); /* supports stay */
    march_free(&a);
    model_free(&m);
}

/* The critical step is the true bound: just below it the linear march stays bounded, just above it
 * grows beyond all numbers; beyond it the watch ends the run at once. */
static void critical_step(void **state)
{
    struct model m = new_model(&seil1, LAW_HOOKE, N);
    const double factor[] = {0.995, 1.01, 2};
    (void)state;

    for (int k = 0; k < 3; k++) {
        struct march_options o = {.dt = factor[k] * march_critical_step(&m)};
        enum status s = SW_OK;
        double V[ALL] = {0};
        struct march a;

        V[MID] = 1e-6;
        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        if (k < 2)
            a.omega_max = 0; /* the watch asleep */
        assert_int_equal(march_start(&a, V, NULL), SW_OK);
        for (int i = 0; i < 20000 && s == SW_OK; i++) {
            s = march_solve(&a);
            march_advance(&a);
        }
        assert_int_equal(s, k == 0 ? SW_OK : SW_DIVERGED);
        assert_true(k < 2 || a.step == 1);
        if (k == 0)
            below(fabs(a.V[MID]), 1e-5);
        march_free(&a);
    }
    model_free(&m);
}

/* A cable stretched by a tenth: 3 EA gamma/(EA a^2 + T) > 0.235 passes the margin of 0.9. */
static void stretched_beyond_the_bound(void **state)
{
    struct model m = new_model(&seil1, LAW_HOOKE, N);
    struct motion pull = {SUPPORT_RIGHT, {10, 0, 0}, 1, {PI / 2, 0, 0}, 0, NULL, NULL};
    struct march_options o = {.alpha = 0,
                              .beta = 0,
                              .dt = 0.9 * march_critical_step(&m),
                              .terms = 3,
                              .motion = &pull,
                              .n_motions = 1};
    enum status s = SW_OK;
    double V[ALL] = {0};
    struct march a;
    (void)state;

    pull.amplitude[0] = -12; /* -12 cos(t + pi/2) = 12 sin t */
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    while (s == SW_OK && march_time(&a) < 2) {
        s = march_solve(&a);
        march_advance(&a);
    }
    assert_int_equal(s, SW_DIVERGED);
    assert_true(isfinite(a.stiffened));
    below(0.2345, a.stiffened);
    march_free(&a);
    model_free(&m);
}

static void slack_is_noticed(void **state)
{
    struct model m = new_model(&seil1, LAW_HOOKE, N);
    struct motion push = {SUPPORT_RIGHT, {0.5, 0, 0}, 3, {PI / 2, 0, 0}, 0, NULL, NULL};
    struct march_options o = {.alpha = 0,
                              .beta = 0,
                              .dt = 0.9 * march_critical_step(&m),
                              .terms = 3,
                              .motion = &push,
                              .n_motions = 1};
    double V[ALL] = {0};
    struct march a;
    (void)state;

    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    while (march_time(&a) < 0.6)
        step(&a);
    assert_true(a.slack_time > 0 && a.slack_time < 0.3);
    assert_true(a.slack_theta > 0 && a.slack_theta < seil1.L0);
    march_free(&a);
    model_free(&m);
}

/* Largest |unknown| of the mid node between two times of a run from equilibrium. */
static double largest(struct march *a, int unknown, double from, double to)
{
    double most = 0;

    while (march_time(a) < to) {
        if (march_time(a) >= from)
            most = fmax(most, fabs(a->V[MID + unknown]));
        step(a);
    }
    return most;
}

static void pont_de_ben_ahin(void **state)
{
    static const struct motion deck = {SUPPORT_RIGHT, {0.05, 0, 0}, 7.86, {0, 0, 0}, 0, NULL, NULL};
    const double b[6] = {0, 0, 0, 0.05, 0, 0};
    (void)state;

    for (int law = LAW_HOOKE; law <= LAW_THESIS; law++) {
        struct model m = new_model(&pont, (enum law)law, N);
        struct march_options o = {.alpha = 5.379e-3,
                                  .beta = 1.676e-4,
                                  .dt = 0.9 * march_critical_step(&m),
                                  .terms = 3,
                                  .motion = &deck,
                                  .n_motions = 1};
        double V[ALL], early, late;
        struct march a;

        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(model_equilibrium(&m, 3, b, V), SW_OK);
        assert_int_equal(march_start(&a, V, NULL), SW_OK);
        early = largest(&a, 2, 0, 20);
        late = largest(&a, 2, 60, 120);
        print_message("# law %d: |v2| %.3f m in 20 s, %.3f m after 60 s\n", law, early, late);
        assert_true(early > 1.30 && early < 1.45); /* Bild 6.3: 1.2 to 1.5 */
        assert_true(late < 1.30 && late > 0.9);
        near_abs(largest(&a, 4, 120, 121), 0, 0); /* nothing leaves the plane by itself */
        march_free(&a);
        model_free(&m);
    }
}

/* Point A: v3 limit cycle of 1.20 m from a small disturbance of the first lateral mode. */
static void seil2_point_a(void **state)
{
    static const struct motion deck = {SUPPORT_RIGHT, {0.05, 0, 0}, 9.124, {0, 0, 0}, 0,
                                       NULL,          NULL};
    struct model m = new_model(&seil2, LAW_THESIS, N);
    struct march_options o = {.alpha = 1.0951e-1,
                              .beta = 3.5061e-3,
                              .dt = 0.9 * march_critical_step(&m),
                              .terms = 3,
                              .motion = &deck,
                              .n_motions = 1};
    const double b[6] = {0, 0, 0, 0.05, 0, 0};
    double V[ALL], shape[ALL];
    struct modes p;
    struct march a;
    (void)state;

    assert_int_equal(modes_lowest(&m, 1, SOLVER_DENSE, &p), SW_OK);
    modes_unit_shape(&m, &p, 0, shape);
    assert_int_equal(march_new(&m, &o, &a), SW_OK);
    assert_int_equal(model_equilibrium(&m, 3, b, V), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    near_abs(largest(&a, 4, 0, 5), 0, 0);
    march_kick(&a, KICK_DISPLACEMENT, 0.02, shape);
    largest(&a, 4, 5, 200);
    near_rel(largest(&a, 4, 200, 220), 1.20, 0.02);
    modes_free(&p);
    march_free(&a);
    model_free(&m);
}

static void memory_runs_out(void **state)
{
    struct model m = new_model(&seil1, LAW_HOOKE, N);
    struct march_options o = {.dt = 1e-4, .beta = 1e-4};
    double V[ALL] = {0};
    unsigned long n = 0;
    enum status s;
    (void)state;

    do {
        struct march a;

        mem_fail_at(++n);
        s = model_equilibrium(&m, 3, (double[6]){0, 0, 0, 0.01, 0, 0}, V);
        if (s == SW_OK)
            s = march_new(&m, &o, &a);
        if (s == SW_OK) {
            s = march_start(&a, V, NULL);
            march_free(&a);
        }
        assert_true(s == SW_OK || s == SW_NOMEM);
    } while (s != SW_OK);
    mem_fail_at(0);
    assert_true(n > 15);
    model_free(&m);
}

TEST_MAIN(cmocka_unit_test(frequency_shift), cmocka_unit_test(energy_is_constant),
          cmocka_unit_test(order_two), cmocka_unit_test(equation_417),
          cmocka_unit_test(rayleigh_decay), cmocka_unit_test(support_forces),
          cmocka_unit_test(kicks), cmocka_unit_test(critical_step),
          cmocka_unit_test(stretched_beyond_the_bound), cmocka_unit_test(slack_is_noticed),
          cmocka_unit_test(pont_de_ben_ahin), cmocka_unit_test(seil2_point_a),
          cmocka_unit_test(memory_runs_out))
