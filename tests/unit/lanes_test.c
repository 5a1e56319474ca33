/*
 * Lanes against the march and against the plain reference (reference.h), which know nothing of each
 * other; the same bits in any lane, beside anything, by registers of any width; what a lane tells
 * of itself alone.
 */
#include "reference.h"

#include "num/mem.h"
#include "phys/lanes.h"

enum { STEPS = 1000, TUNE = 37 };

/* What the lanes need of one point. */
struct point {
    struct motion motion[2];
    struct march_options o;
    double V0[MOST];
};

/* Both supports move in all three directions, each lane by its own frequencies, ramps, damping and
 * step; odd lanes have one motion only.  By little: terms 1 and 2 alone are not bounded. */
static void make_point(const struct model *m, int terms, int stiff, int lane, struct point *p)
{
    double dt = (0.9 - 0.01 * lane) * march_critical_step(m), u[6], b[6];

    *p = (struct point){.motion = {{.support = SUPPORT_RIGHT,
                                    .amplitude = {0.02, 0.01, 0.015 - 0.001 * lane},
                                    .omega = 9.124 + 0.3 * lane,
                                    .phase = {0.4, 0, 1},
                                    .ramp = lane % 3 == 2 ? dt * STEPS / 7 : 0},
                                   {.support = SUPPORT_LEFT,
                                    .amplitude = {0.005, -0.01, 0.01},
                                    .omega = 4.9 - 0.2 * lane,
                                    .phase = {1, 2, 0},
                                    .ramp = lane % 4 == 2 ? dt * STEPS * 2
                                                          : 0}}, /* one that does not end */
                        .o = {.alpha = 0.10951 - 0.01 * lane,
                              .beta = stiff ? 3.5061e-3 * (1 + 0.1 * lane) : 0,
                              .dt = dt,
                              .interval = dt * TUNE,
                              .substeps = TUNE,
                              .terms = terms,
                              .n_motions = 2 - lane % 2}};
    p->o.motion = p->motion;
    motion_sum(p->motion, p->o.n_motions, 0, u, NULL, NULL);
    axes_to_plane(&m->axes, u, b);
    axes_to_plane(&m->axes, u + 3, b + 3);
    assert_int_equal(model_equilibrium(m, 3, b, p->V0), SW_OK);
}

static void start(const struct model *m, const struct point *p, struct march *ret)
{
    assert_int_equal(march_new(m, &p->o, ret), SW_OK);
    assert_int_equal(march_start(ret, p->V0, NULL), SW_OK);
}

static void put(struct lanes *p, int i, const struct point *point)
{
    struct march m;

    start(p->model, point, &m);
    lanes_put(p, i, &m);
    march_free(&m);
}

static void step_on(struct lanes *p, int steps, int width)
{
    for (int k = 0; k < steps; k++) {
        lanes_step_by(p, width);
        for (int i = 0; i < LANES; i++)
            if (p->dt[i] > 0 && p->step[i] % TUNE == 0)
                lanes_tune(p, i);
    }
}

/* Largest difference over the largest displacement, slopes times the element length. */
static double apart(const struct model *m, const double *V, const double *wanted)
{
    double most = 0, worst = 0;

    for (size_t i = 0; i < model_unknowns(m); i++) {
        double scale = i % 2 ? m->h : 1;

        most = fmax(most, scale * fabs(wanted[i]));
        if (!(scale * fabs(V[i] - wanted[i]) <= worst))
            worst = scale * fabs(V[i] - wanted[i]);
    }
    assert_true(most > 0.005 && most < 2);
    return worst / most;
}

/* Eight points, lane by lane against the march and, every third, the reference. */
static void run_all(const struct model *m, int terms, int stiff, double worst[2])
{
    static struct point point[LANES];
    struct lanes p;

    assert_int_equal(lanes_new(m, terms, stiff, 2, &p), SW_OK);
    for (int i = 0; i < LANES; i++) {
        make_point(m, terms, stiff, i, &point[i]);
        put(&p, i, &point[i]);
    }
    step_on(&p, STEPS, lanes_width());
    for (int i = 0; i < LANES; i++) {
        double V[MOST], now;
        struct march a;

        assert_int_equal(p.step[i], STEPS);
        assert_false(lanes_negative(&p.bad, i));
        lanes_look(&p, i, V);
        start(m, &point[i], &a);
        for (int k = 0; k < STEPS; k++) {
            assert_int_equal(march_solve(&a), SW_OK);
            march_advance(&a);
        }
        now = apart(m, V, a.V);
        worst[0] = fmax(worst[0], now);
        below(now, 1e-12); /* the issue's; 5e-13 at the most, of the finest mesh */
        march_free(&a);
        if (i % 3 == 2) {
            struct reference r;

            reference_new(m, &point[i].o, &r);
            reference_start(&r, point[i].V0);
            for (int k = 0; k < STEPS; k++) {
                reference_solve(&r);
                reference_advance(&r);
            }
            now = apart(m, V, r.V);
            worst[1] = fmax(worst[1], now);
            below(now, 1e-12);
            reference_free(&r);
        }
    }
    lanes_free(&p);
}

static void every_mesh_and_term(void **state)
{
    static const int elements[] = {1, 2, 3, 10, 33};
    double worst[2] = {0, 0};
    (void)state;

    for (int k = 0; k < 5; k++) {
        struct model m;

        assert_int_equal(model_new(&seil2, k % 2 ? LAW_THESIS : LAW_HOOKE, elements[k], &m), SW_OK);
        for (int terms = 0; terms <= 3; terms++)
            for (int stiff = 0; stiff <= 1; stiff++)
                run_all(&m, terms, stiff, worst);
        model_free(&m);
    }
    print_message("# lanes: from the march %.2g, from the reference %.2g\n", worst[0], worst[1]);
}

/* A wind across turns the plane of the line: the motions turn with it. */
static void in_a_plane_of_wind(void **state)
{
    const struct load load = {.ice = 0.1, .wind = {0.3, 0.5, 4}};
    struct cable hangs;
    struct axes axes;
    double worst[2] = {0, 0};
    (void)state;

    load_apply(&seil2, &load, &hangs, &axes);
    assert_false(axes_are_plain(&axes));
    for (int stiff = 0; stiff <= 1; stiff++) {
        struct model m;

        assert_int_equal(model_new(&hangs, LAW_HOOKE, 5, &m), SW_OK);
        m.axes = axes;
        run_all(&m, 3, stiff, worst);
        model_free(&m);
    }
    print_message("# in a plane of wind: %.2g and %.2g\n", worst[0], worst[1]);
}

/* What lane i holds, to the last bit. */
static void bits_of(const struct lanes *p, int i, double *ret)
{
    size_t n = model_unknowns(p->model);

    for (size_t j = 0; j < n; j++) {
        ret[j] = p->V[j][i];
        ret[n + j] = p->D[j][i];
    }
}

enum neighbours { NONE, OTHERS, NANS, N_NEIGHBOURS };

/* The point alone in its lane, beside other points, beside lanes that are nothing but NaN. */
static void fly(struct lanes *p, int lane, const struct point *point, const struct point *others,
                enum neighbours who, int width, double *ret)
{
    for (int i = 0; i < LANES; i++) {
        lanes_clear(p, i);
        if (i != lane && who == OTHERS)
            put(p, i, &others[i]);
        for (size_t j = 0; j < model_unknowns(p->model) && i != lane && who == NANS; j++)
            p->V[j][i] = p->D[j][i] = NAN;
    }
    if (who != OTHERS) /* the others are ahead */
        step_on(p, 3, width);
    put(p, lane, point);
    step_on(p, 200, width);
    assert_false(lanes_negative(&p->bad, lane));
    assert_false(lanes_negative(&p->slack, lane));
    bits_of(p, lane, ret);
}

static void same_bits_anywhere(void **state)
{
    static const int widths[] = {2, 4, 8};
    struct model m;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_THESIS, 7, &m), SW_OK);
    for (int stiff = 0; stiff <= 1; stiff++) {
        static struct point point[LANES];
        double first[2 * MOST], now[2 * MOST];
        struct lanes p;
        int runs = 0;

        assert_int_equal(lanes_new(&m, 3, stiff, 2, &p), SW_OK);
        for (int i = 0; i < LANES; i++)
            make_point(&m, 3, stiff, i, &point[i]);
        for (int w = 0; w < 3; w++) {
            if (widths[w] > lanes_width()) {
                print_message("# no registers of %d lanes here\n", widths[w]);
                continue;
            }
            for (int lane = 0; lane < LANES; lane++)
                for (int who = NONE; who < N_NEIGHBOURS; who++) {
                    fly(&p, lane, &point[2], point, (enum neighbours)who, widths[w],
                        runs++ ? now : first);
                    if (runs > 1)
                        assert_memory_equal(now, first, 2 * model_unknowns(&m) * sizeof *now);
                }
        }
        assert_true(runs >= LANES * N_NEIGHBOURS);
        lanes_free(&p);
    }
    model_free(&m);
}

/* The step in which the march sees what the lane sees: too long a step by stretch, compression. */
static void alone_in_trouble(void **state)
{
    struct model m;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_HOOKE, 10, &m), SW_OK);
    for (int stiff = 0; stiff <= 1; stiff++) {
        static struct point point[LANES];
        struct lanes p;
        struct march a;
        int bad = -1, slack = -1;

        assert_int_equal(lanes_new(&m, 3, stiff, 2, &p), SW_OK);
        for (int i = 0; i < LANES; i++) {
            make_point(&m, 3, stiff, i, &point[i]);
            if (i == 5) { /* pushed together, then torn */
                point[i].motion[0] = (struct motion){.amplitude = {20, 0, 0}, .omega = 4};
                memset(point[i].V0, 0, sizeof point[i].V0);
                point[i].motion[0].phase[0] = PI / 2;
            }
            put(&p, i, &point[i]);
        }
        start(&m, &point[5], &a);
        for (int k = 0; k < 3000 && bad < 0; k++) {
            enum status s = march_solve(&a);

            lanes_step(&p);
            if (lanes_negative(&p.slack, 5) && slack < 0) {
                slack = k;
                near_abs(a.slack_time, k * point[5].o.dt, 1e-12);
            }
            assert_int_equal(a.slack_time >= 0, slack >= 0);
            assert_int_equal(s == SW_DIVERGED, lanes_negative(&p.bad, 5));
            bad = s == SW_OK ? -1 : k;
            march_advance(&a);
        }
        print_message("# slack in step %d, torn in step %d\n", slack, bad);
        assert_true(slack > 0 && bad > slack);
        step_on(&p, 100, lanes_width()); /* by now nothing but NaN */
        for (int i = 0; i < LANES; i++)
            if (i != 5) {
                assert_false(lanes_negative(&p.bad, i));
                assert_false(lanes_negative(&p.slack, i));
                assert_true(isfinite(p.V[6 * 5 + 2][i]));
            }
        lanes_clear(&p, 5);
        lanes_step(&p);
        assert_false(lanes_negative(&p.bad, 5));
        assert_true(p.V[6 * 5 + 2][5] == 0);
        march_free(&a);
        lanes_free(&p);
    }
    model_free(&m);
}

/* A step just above the bound is bad at once, one below it is not; linear lanes have no bound. */
static void bound_of_the_step(void **state)
{
    struct model m;
    struct lanes p;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_HOOKE, 4, &m), SW_OK);
    for (int terms = 0; terms <= 3; terms += 3) {
        static const double factor[2] = {0.9999, 1.0001};

        assert_int_equal(lanes_new(&m, terms, 1, 2, &p), SW_OK);
        for (int i = 0; i < 2; i++) {
            static struct point point;

            make_point(&m, terms, 1, 1, &point);
            point.o.dt = factor[i] * march_critical_step(&m);
            point.o.n_motions = 0;
            memset(point.V0, 0, sizeof point.V0);
            put(&p, i, &point);
        }
        lanes_step(&p);
        assert_false(lanes_negative(&p.bad, 0));
        assert_int_equal(lanes_negative(&p.bad, 1), terms > 0);
        lanes_free(&p);
    }
    model_free(&m);
}

/* lanes_add is the march's kick. */
static void kicked(void **state)
{
    static struct point point;
    double zero[MOST] = {0}, shape[MOST] = {0}, V[MOST];
    struct model m;
    struct march a;
    struct lanes p;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_HOOKE, 6, &m), SW_OK);
    make_point(&m, 3, 1, 0, &point);
    for (int i = 6; i < 6 * 6; i++)
        shape[i] = i % 2 ? 0 : 0.01 * (i % 7);
    start(&m, &point, &a);
    assert_int_equal(lanes_new(&m, 3, 1, 2, &p), SW_OK);
    lanes_put(&p, 3, &a);
    for (int k = 0; k < 300; k++) {
        if (k == 50) {
            march_kick(&a, KICK_DISPLACEMENT, 1, shape);
            lanes_add(&p, 3, shape, zero);
        }
        if (k == 90) {
            for (int i = 0; i < MOST; i++)
                shape[i] /= 64; /* exactly */
            march_kick(&a, KICK_VELOCITY, 1 / point.o.dt, shape);
            lanes_add(&p, 3, zero, shape);
        }
        assert_int_equal(march_solve(&a), SW_OK);
        march_advance(&a);
        lanes_step(&p);
    }
    lanes_look(&p, 3, V);
    below(apart(&m, V, a.V), 1e-12);
    march_free(&a);
    lanes_free(&p);
    model_free(&m);
}

static void memory_runs_out(void **state)
{
    struct model m;
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_HOOKE, 4, &m), SW_OK);
    for (int beta = 0; beta <= 1; beta++) {
        unsigned long n = 0;
        enum status s;

        do {
            struct lanes p;

            mem_fail_at(++n);
            s = lanes_new(&m, 3, beta, 2, &p);
            if (s == SW_OK)
                lanes_free(&p);
            assert_true(s == SW_OK || s == SW_NOMEM);
        } while (s != SW_OK);
        mem_fail_at(0);
        assert_true(n > 3);
    }
    model_free(&m);
}

TEST_MAIN(cmocka_unit_test(every_mesh_and_term), cmocka_unit_test(in_a_plane_of_wind),
          cmocka_unit_test(same_bits_anywhere), cmocka_unit_test(alone_in_trouble),
          cmocka_unit_test(bound_of_the_step), cmocka_unit_test(kicked),
          cmocka_unit_test(memory_runs_out))
