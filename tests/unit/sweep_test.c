/* Sweeps: their phase is the integral of their frequency, without a jump; up, down, back, in steps,
 * and what lies before and behind them. */
#include "check.h"
#include "phys/motion.h"

static void at(const struct sweep *s, double t, double *phase, double *omega, double *rate)
{
    sweep_at(s, t, phase, omega, rate);
}

static double phase_at(const struct sweep *s, double t)
{
    double phase, omega, rate;

    at(s, t, &phase, &omega, &rate);
    return phase;
}

static double omega_at(const struct sweep *s, double t)
{
    double phase, omega, rate;

    at(s, t, &phase, &omega, &rate);
    return omega;
}

/* Omega = d phase/dt and rate = d Omega/dt by differences, away from the corners (all times t with
 * |t - corner| < h), from before the start to behind the end.  The phase is quadratic between
 * corners: central differences are exact but for round-off, phase epsilon/h. */
static void derivatives(const struct sweep *s, const double *corner, int n)
{
    const double h = 1e-3;
    uint64_t seed = 4711;

    for (int k = 0; k < n; k++)
        near_abs(phase_at(s, corner[k] * (1 + 1e-12)), phase_at(s, corner[k] * (1 - 1e-12)), 1e-7);
    for (int i = 0; i < 20000; i++) {
        double t = uniform_in(&seed, -0.1, 1.1) * s->duration, phase, omega, rate;
        int near = 0;

        for (int k = 0; k < n; k++)
            near |= fabs(t - corner[k]) <= h;
        at(s, t, &phase, &omega, &rate);
        assert_true(fabs(phase_at(s, t + h) - phase_at(s, t - h)) <=
                    2.001 * h * fmax(s->from, s->to));
        if (near)
            continue;
        near_abs((phase_at(s, t + h) - phase_at(s, t - h)) / (2 * h), omega,
                 1e-15 * (1 + fabs(phase)) / h);
        near_abs((omega_at(s, t + h) - omega_at(s, t - h)) / (2 * h), rate, 1e-14 * s->to / h);
    }
}

static void continuous(void **state)
{
    static const double ends[3][2] = {{4, 6.3}, {6.3, 4}, {9, 9.5}};
    (void)state;

    for (int k = 0; k < 6; k++) {
        struct sweep s = {.from = ends[k % 3][0],
                          .to = ends[k % 3][1],
                          .rate = 0.01,
                          .back = k / 3};
        double way = fabs(s.to - s.from) / s.rate, corner[3] = {0, way, 2 * way};
        int up = s.to > s.from ? 1 : -1;

        assert_int_equal(sweep_new(&s), SW_OK);
        near_rel(s.duration, way * (s.back ? 2 : 1), 1e-15);
        derivatives(&s, corner, 3);
        near_rel(omega_at(&s, way / 2), (s.from + s.to) / 2, 1e-14);
        near_rel(phase_at(&s, way), (s.from + s.to) / 2 * way, 1e-14);
        near_rel(omega_at(&s, s.duration), s.back ? s.from : s.to, 1e-14);
        near_rel(omega_at(&s, s.duration + 77), s.back ? s.from : s.to, 1e-14);
        near_rel(omega_at(&s, -5), s.from, 0);
        near_rel(phase_at(&s, -5), -5 * s.from, 1e-15);
        assert_int_equal(sweep_direction(&s, way / 2), up);
        assert_int_equal(sweep_direction(&s, 1.5 * way), s.back ? -up : up);
        sweep_free(&s);
    }
}

/* 4, 4.3, 4.6, 4.9 (and back): each for whole periods, so that each begins where a period does. */
static void in_steps(void **state)
{
    (void)state;

    for (int back = 0; back <= 1; back++)
        for (int down = 0; down <= 1; down++) {
            static const double up_way[] = {4, 4.3, 4.6, 4.9, 4.6, 4.3, 4},
                                down_way[] = {5, 4.7, 4.4, 4.1, 4.4, 4.7, 5};
            const double *wanted = down ? down_way : up_way;
            struct sweep s = {
                .from = down ? 5 : 4, .to = down ? 4 : 5, .step = 0.3, .dwell = 7, .back = back};
            double t = 0, corner[8];
            int n = back ? 7 : 4;

            assert_int_equal(sweep_new(&s), SW_OK);
            assert_int_equal(s.n, n);
            for (int i = 0; i < n; i++) {
                double length = 7 * 2 * PI / wanted[i];

                corner[i] = t;
                near_abs(phase_at(&s, t), 2 * PI * 7 * i, 1e-11);
                near_rel(omega_at(&s, t + 0.01 * length), wanted[i], 1e-14);
                near_rel(omega_at(&s, t + 0.99 * length), wanted[i], 1e-14);
                assert_int_equal(sweep_direction(&s, t + length / 2),
                                 (i < 4 ? 1 : -1) * (down ? -1 : 1));
                t += length;
            }
            corner[n] = t;
            near_rel(s.duration, t, 1e-13);
            derivatives(&s, corner, n + 1);
            sweep_free(&s);
        }
}

/* Both ends belong to it where the step divides the way, though 0.1 is no binary fraction. */
static void both_ends(void **state)
{
    struct sweep s = {.from = 4, .to = 6.3, .step = 0.1, .dwell = 10};
    (void)state;

    assert_int_equal(sweep_new(&s), SW_OK);
    assert_int_equal(s.n, 24);
    near_rel(omega_at(&s, s.duration), 6.3, 1e-14);
    sweep_free(&s);
    s = (struct sweep){.from = 4, .to = 6.3, .step = 5, .dwell = 10};
    assert_int_equal(sweep_new(&s), SW_OK);
    assert_int_equal(s.n, 1);
    sweep_free(&s);
    s = (struct sweep){.from = 4, .to = 6.3, .step = 1e-9, .dwell = 10};
    assert_int_equal(sweep_new(&s), SW_ADMISSIBLE);
    sweep_free(&s);
}

/* A swept motion: its velocity and acceleration are the derivatives of its displacement, in the
 * ramp, too. */
static void swept_motion(void **state)
{
    struct sweep s = {.from = 4, .to = 9, .rate = 0.5};
    const struct motion m = {.amplitude = {1, -0.5, 0.25},
                             .omega = 77, /* the sweep's counts */
                             .phase = {0.3, 1, 2},
                             .ramp = 3,
                             .sweep = &s};
    const double h = 1e-4;
    (void)state;

    assert_int_equal(sweep_new(&s), SW_OK);
    for (double t = 0.11; t < 12; t += 0.37) {
        double u[3][6], v[3][6], a[6];

        motion_sum(&m, 1, t - h, u[0], v[0], NULL);
        motion_sum(&m, 1, t, u[1], v[1], a);
        motion_sum(&m, 1, t + h, u[2], v[2], NULL);
        for (int i = 3; i < 6; i++) { /* h^2 omega^3/6 = 1e-6, h^2 omega^4/6 = 1e-5 */
            near_abs((u[2][i] - u[0][i]) / (2 * h), v[1][i], 3e-6);
            near_abs((v[2][i] - v[0][i]) / (2 * h), a[i], 3e-5);
        }
    }
    sweep_free(&s);
}

TEST_MAIN(cmocka_unit_test(continuous), cmocka_unit_test(in_steps), cmocka_unit_test(both_ends),
          cmocka_unit_test(swept_motion))
