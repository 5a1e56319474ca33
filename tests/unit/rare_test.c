/* Motions of cables that hardly ever are: modes damped beyond their critical damping, ground motion
 * at an undamped resonance; what boundaries tell of their own change; none without memory. */
#include "fails.h"
#include "rope.h"

#include "phys/march.h"
#include "phys/orbit.h"
#include "phys/steady.h"

/* One overdamped mode without parametric terms: multipliers exp(r T), r by the square's roots. */
static void overdamped(void **state)
{
    static const double damping[3] = {5, 4, 100}; /* the second one is critical */
    (void)state;

    for (int k = 0; k < 3; k++) {
        struct hand h;
        struct parametric *p = hand_begin(1, &h);
        double c = damping[k], Omega = 7, T = 2 * PI / Omega, re[2], im[2];
        double root = sqrt(c * c / 4 - 4), slow = exp((-c / 2 + root) * T);
        double fast = exp((-c / 2 - root) * T);

        p->omega[0] = 2;
        p->c[0] = c;
        assert_int_equal(floquet_multipliers(p, Omega, 0, 8, re, im, NULL), SW_OK);
        near_rel(fmax(re[0], re[1]), slow, k == 1 ? 1e-6 : 1e-12); /* a double one is hard */
        near_abs(fmin(re[0], re[1]), fast, k == 1 ? 1e-6 * fast : 1e-13);
        near_abs(im[0], 0, 1e-6);
    }
}

/* The ground motion at an undamped resonance is none; a little damping makes one. */
static void resonance(void **state)
{
    (void)state;
    for (int mode = 0; mode < 4; mode++)
        for (int damped = 0; damped < 2; damped++) {
            const double complex b[6] = {0.1, 0.2, 0.3, 1, 0.5, 0.7};
            struct rope r;
            struct ground g;
            double complex *V;
            enum status s;

            rope_begin(&seil2, LAW_THESIS, 8, 4, 0, 0, 0, &r);
            V = mem_zeroed(model_unknowns(&r.m), sizeof *V);
            assert_non_null(V);
            assert_int_equal(ground_new(&r.m, damped ? 0.01 : 0, 0, &g), SW_OK);
            s = ground_response(&g, r.p.omega[mode], b, NULL, V);
            assert_int_equal(s, damped ? SW_OK : SW_INDEFINITE);
            assert_int_equal(ground_response(&g, 1.01 * r.p.omega[mode], b, NULL, V), SW_OK);
            ground_free(&g);
            free(V);
            rope_end(&r);
        }
}

/* A weightless string under an even lateral force p cos(Omega t):
 * v = p/(mu Omega^2) [cos(k (s - L/2))/cos(k L/2) - 1], k = Omega sqrt(mu/T), along its unstressed
 * length.  Cubic elements: a force that lacks its moment at an end would turn that by 6 %. */
static void forced_string(void **state)
{
    const struct cable string = {99.9, 10, 1e9, 0, 100, 0};
    enum { N = 20 };
    double complex V[6 * (N + 1)], none[6] = {0};
    double R[6 * (N + 1)] = {0}, h = string.L0 / N, force = 3;
    double stretch = string.span / string.L0, T = string.EA * (stretch - 1) / stretch;
    struct model m;
    struct ground g;
    (void)state;

    assert_int_equal(model_new(&string, LAW_HOOKE, N, &m), SW_OK);
    assert_int_equal(ground_new(&m, 0, 0, &g), SW_OK);
    for (int e = 0; e < N; e++) {
        R[6 * e + 4] += force * h / 2;
        R[6 * e + 5] += force * h * h / 12;
        R[6 * (e + 1) + 4] += force * h / 2;
        R[6 * (e + 1) + 5] -= force * h * h / 12;
    }
    for (double part = 0.3; part < 3; part += 0.5) { /* of the lowest frequency */
        double Omega = part * PI / string.L0 * sqrt(T / string.mu), k = part * PI / string.L0;
        double size = force / (string.mu * Omega * Omega) / fabs(cos(k * string.L0 / 2));

        assert_int_equal(ground_response(&g, Omega, none, R, V), SW_OK);
        for (int i = 0; i <= N; i++) {
            double from = (i - N / 2.0) * h, factor = force / (string.mu * Omega * Omega);
            double end = cos(k * string.L0 / 2);

            near_abs(creal(V[6 * i + 4]), factor * (cos(k * from) / end - 1), 1e-4 * size);
            near_abs(creal(V[6 * i + 5]), -factor * k * sin(k * from) / end, 2e-3 * size * k);
            near_abs(cabs(V[6 * i + 2]) + fabs(cimag(V[6 * i + 4])), 0, 1e-12 * size);
        }
    }
    ground_free(&g);
    model_free(&m);
}

/* The change of a boundary is against the same one by two harmonics less; of those that are given
 * with one there is none. */
static void change(void **state)
{
    struct rope r;
    struct parametric p;
    struct boundary b[100], coarse[100];
    int n, m, told = 0;
    double Omega;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 8, 2, ALPHA_2, BETA_2, 0, &r);
    Omega = 2 * 0.95 * r.map.reference;
    assert_int_equal(map_equations(&r.map, 0.95, &p), SW_OK);
    for (int harmonics = 2; harmonics <= 7; harmonics++)
        for (int period = 1; period <= 2; period++) {
            assert_int_equal(bolotin_solve(&p, Omega, period, harmonics, 10, b, 100, &n), SW_OK);
            assert_int_equal(bolotin_change(&p, Omega, period, harmonics, b, n), SW_OK);
            m = 0;
            if (harmonics > 2)
                assert_int_equal(bolotin_solve(&p, Omega, period, harmonics - 2, INFINITY, coarse,
                                               100, &m),
                                 SW_OK);
            for (int i = 0; i < n; i++) {
                double least = NAN;

                for (int k = 0; k < m; k++)
                    if (coarse[k].mode == b[i].mode && coarse[k].order == b[i].order)
                        least = fmin(least, fabs(coarse[k].kappa / b[i].kappa - 1));
                assert_int_equal(isnan(b[i].change), isnan(least));
                if (!isnan(least)) {
                    near_abs(b[i].change, least, 1e-12);
                    told++;
                }
            }
        }
    assert_true(told > 5);
    parametric_free(&p);
    rope_end(&r);
}

/* One row of a map, with all that it may tell. */
struct row {
    struct rope r;
    struct map_task t;
};

static enum status draw(void *context)
{
    struct row *k = context;
    struct map_rows rows;
    double ratio = 0.97;
    enum status s;

    map_rows(&k->r.map, &k->t, &ratio, 1, 1, &rows);
    s = rows.status;
    if (s == SW_OK) {
        assert_true(rows.n > 0);
        for (int i = 0; i < rows.n && !k->t.floquet; i++)
            assert_true(!(rows.row[i].boundary.change < 0));
    }
    map_rows_free(&rows);
    return s;
}

static void requests(void **state)
{
    struct row k;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 6, 2, ALPHA_2, BETA_2, 1, &k.r);
    k.t = (struct map_task){.harmonics = 3, .change = 1, .to = 1};
    assert_true(fails_each(draw, &k) > 5);
    k.t = (struct map_task){.floquet = 1, .from = 0.05, .to = 0.1, .step = 0.05};
    assert_true(fails_each(draw, &k) > 5);
    rope_end(&k.r);
}

/* A damper without a coefficient is none; a small one is one.  What a march tells of its time. */
static void dampers(void **state)
{
    const struct damper both[2] = {{0.3, {0, 1, 0}, 0}, {0.5, {0, 1, 0}, 0.5}};
    double V[2][6 * 7];
    struct model m;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_THESIS, 6, &m), SW_OK);
    for (int k = 0; k < 2; k++) {
        struct march_options o = {.substeps = 4};
        struct march a;
        double start[6 * 7] = {0};

        o.dt = 0.5 * march_critical_step(&m);
        o.damper = k ? both : both + 1;
        o.n_dampers = k ? 2 : 1;
        start[6 * 3 + 2] = 0.01;
        assert_int_equal(march_new(&m, &o, &a), SW_OK);
        assert_int_equal(a.dampers.r, 1);
        near_abs(a.dampers.c[0], 0.5, 0);
        assert_int_equal(march_start(&a, start, NULL), SW_OK);
        assert_true(march_past(&a) < 0);
        for (int i = 0; i < 8; i++) {
            assert_int_equal(march_at_mark(&a), i % 4 == 0);
            assert_int_equal(march_mark(&a), i / 4);
            assert_int_equal(march_solve(&a), SW_OK);
            march_advance(&a);
            near_rel(march_past(&a), march_time(&a) - o.dt, 1e-12);
        }
        memcpy(V[k], a.V, sizeof V[k]);
        march_free(&a);
    }
    for (int i = 0; i < 6 * 7; i++)
        near_abs(V[1][i], V[0][i], 0);
    model_free(&m);
}

/* A harmonic force whose frequency is swept is the force at the sweep's phase. */
static void swept_force(void **state)
{
    struct sweep up = {.from = 3, .to = 9, .rate = 0.5};
    struct model m;
    (void)state;

    assert_int_equal(sweep_new(&up), SW_OK);
    assert_int_equal(model_new(&seil2, LAW_THESIS, 6, &m), SW_OK);
    for (double t = 0; t < 10; t += 0.7) {
        struct force f = {.position = 0.4, .value = {1, 2, 3}, .omega = 4, .phase = 0.3};
        struct forcing all = {.force = &f, .n = 1};
        double phase, omega, rate, F[2][6 * 7] = {{0}}, V[6 * 7] = {0};

        sweep_at(&up, t, &phase, &omega, &rate);
        f.sweep = &up;
        forcing_subtract(&m, &all, t, V, NULL, F[0]);
        f.sweep = NULL;
        f.omega = NAN;
        for (int c = 0; c < 3; c++)
            f.value[c] *= cos(phase + 0.3);
        forcing_subtract(&m, &all, t, V, NULL, F[1]);
        for (int i = 0; i < 6 * 7; i++)
            near_abs(F[0][i], F[1][i], 1e-14);
    }
    model_free(&m);
    sweep_free(&up);
}

/* What does not move at all rests; what moves along the cable alone is in its plane. */
static void planes(void **state)
{
    (void)state;
    for (int moves = 0; moves < 4; moves++) {
        struct orbit_window w = {0};
        struct orbit o;

        for (int i = 0; i < 50; i++) {
            const double v[3] = {moves % 2 ? cos(2 * PI * i / 50) : 0.1, 0, 0};

            orbit_add(&w, 2 * PI * i / 50, v, 1);
        }
        memset(w.c, 0, sizeof w.c); /* less what rounding leaves of sums, but for a trace across */
        memset(w.s, 0, sizeof w.s);
        w.c[0][1] = w.s[0][1] = moves < 2 ? 25 * 1.5e-162 : 0; /* whose square is none */
        orbit_of(&w, &o);
        assert_int_equal(o.plane, moves % 2 ? ORBIT_IN : ORBIT_REST);
        assert_int_equal(o.order, moves < 2);
        near_abs(o.major, 0, 0);
    }
}

static enum status begin_steady(void *context)
{
    static const double half = 0.5;
    const struct steady_options o = {.tolerance = 1e-4,
                                     .periods = 20,
                                     .n_probes = 1,
                                     .probe = &half};
    struct steady s;
    enum status status = steady_new(context, &o, &s);

    if (status != SW_OK)
        assert_true(!s.least && !s.greatest && !s.strobe && !s.window && !s.orbit);
    steady_free(&s);
    return status;
}

static void steady_states(void **state)
{
    struct model m;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_THESIS, 4, &m), SW_OK);
    assert_true(fails_each(begin_steady, &m) >= 5);
    model_free(&m);
    assert_string_equal(steady_kind_name(STEADY_NONE), "none");
    assert_string_equal(steady_kind_name(STEADY_PERIODIC), "periodic");
    assert_string_equal(steady_kind_name(STEADY_QUASI), "quasi-periodic");
    assert_string_equal(steady_kind_name(STEADY_DECAYED), "decayed");
}

TEST_MAIN(cmocka_unit_test(overdamped), cmocka_unit_test(resonance),
          cmocka_unit_test(forced_string), cmocka_unit_test(change), cmocka_unit_test(requests),
          cmocka_unit_test(dampers), cmocka_unit_test(swept_force), cmocka_unit_test(planes),
          cmocka_unit_test(steady_states))
