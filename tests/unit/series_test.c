/* Splines of records: interpolation, smoothness, accuracy, ends. */
#include "check.h"
#include "num/mem.h"
#include "phys/motion.h"
#include "phys/series.h"

#define N 40

/* Samples of f at uneven times. */
static struct series sample(int n, double (*f)(double, int), double *t)
{
    double *x = mem_doubles(3 * (size_t)n);
    struct series s;

    for (int i = 0; i < n; i++) {
        t[i] = 0.1 * i + 0.03 * (i % 2);
        for (int c = 0; c < 3; c++)
            x[3 * i + c] = f(t[i], c);
    }
    assert_int_equal(series_new(n, t, x, &s), SW_OK);
    free(x);
    return s;
}

static double wave(double t, int c)
{
    return sin((c + 1) * t + c);
}

static double parabola(double t, int c)
{
    return 1 + c - 2 * t + (c + 1) * t * t;
}

static void interpolates(void **state)
{
    double t[N], x[3], v[3], a[3];
    struct series s = sample(N, wave, t);
    (void)state;

    for (int i = 0; i < N; i++) {
        series_at(&s, t[i], x, v, a);
        for (int c = 0; c < 3; c++)
            near_abs(x[c], wave(t[i], c), 1e-15);
    }
    series_free(&s);
}

/* Value, velocity and acceleration from both sides of each sample. */
static void smooth(void **state)
{
    double t[N], x[2][3], v[2][3], a[2][3], e = 1e-9;
    struct series s = sample(N, wave, t);
    (void)state;

    for (int i = 1; i < N - 1; i++) {
        series_at(&s, t[i] - e, x[0], v[0], a[0]);
        series_at(&s, t[i] + e, x[1], v[1], a[1]);
        for (int c = 0; c < 3; c++) {
            near_abs(x[0][c], x[1][c], 1e-8); /* 2 e times the slope */
            near_abs(v[0][c], v[1][c], 1e-7);
            near_abs(a[0][c], a[1][c], 1e-6);
        }
    }
    series_free(&s);
}

/* A parabola exactly; a wave with an error of fourth order inside. */
static void accurate(void **state)
{
    double t[N], x[3], v[3], a[3], worst = 0;
    struct series p = sample(N, parabola, t), w = sample(N, wave, t);
    (void)state;

    for (double at = 0; at < t[N - 1]; at += 0.0137) {
        series_at(&p, at, x, v, a);
        for (int c = 0; c < 3; c++) {
            near_abs(x[c], parabola(at, c), 1e-13);
            near_abs(v[c], -2 + 2 * (c + 1) * at, 1e-11);
            near_abs(a[c], 2 * (c + 1), 1e-9);
        }
        series_at(&w, at, x, v, NULL);
        for (int c = 0; c < 3 && at > 0.5 && at < t[N - 1] - 0.5; c++) {
            worst = fmax(worst, fabs(x[c] - wave(at, c)));
            near_abs(v[c], (c + 1) * cos((c + 1) * at + c), 3e-3);
        }
    }
    print_message("# error of the wave: %.2g\n", worst);
    below(worst, 81 * pow(0.13, 4) * 5 / 384); /* 5/384 h^4 of the fourth derivative */
    series_free(&p);
    series_free(&w);
}

static void outside(void **state)
{
    double t[N], x[3], v[3], a[3];
    struct series s = sample(N, wave, t);
    (void)state;

    series_at(&s, -1, x, v, a);
    for (int c = 0; c < 3; c++)
        assert_true(x[c] == wave(t[0], c) && v[c] == 0 && a[c] == 0);
    series_at(&s, t[N - 1] + 1e-9, x, v, a);
    for (int c = 0; c < 3; c++) {
        near_abs(x[c], wave(t[N - 1], c), 1e-15);
        assert_true(v[c] == 0 && a[c] == 0);
    }
    series_free(&s);
}

static void few(void **state)
{
    const double t[3] = {0, 1, 1}, x[9] = {0, 0, 0, 2, 4, 6, 0, 0, 0};
    double y[3], v[3], a[3];
    struct series s;
    (void)state;

    assert_int_equal(series_new(2, t, x, &s), SW_OK);
    series_at(&s, 0.25, y, v, a);
    for (int c = 0; c < 3; c++) {
        near_rel(y[c], 0.5 * (c + 1), 1e-15);
        near_rel(v[c], 2 * (c + 1), 1e-15);
    }
    series_free(&s);
    assert_int_equal(series_new(3, t, x, &s), SW_ADMISSIBLE);
    assert_int_equal(series_new(1, t, x, &s), SW_ADMISSIBLE);
}

/* A recorded motion beside the harmonic one that it was sampled from, with a ramp. */
static void as_motion(void **state)
{
    double t[400], x[1200] = {0}, u[2][6], v[2][6], a[2][6];
    struct motion m[2] = {{SUPPORT_LEFT, {0.1, 0, 0}, 3, {0, 0, 0}, 2, NULL, NULL},
                          {SUPPORT_LEFT, {0, 0, 0}, 0, {0, 0, 0}, 2, NULL, NULL}};
    struct series s;
    (void)state;

    for (int i = 0; i < 400; i++) {
        t[i] = 0.025 * i;
        x[3 * i] = 0.1 * cos(3 * t[i]);
    }
    assert_int_equal(series_new(400, t, x, &s), SW_OK);
    m[1].record = &s;
    for (double at = 0.1; at < 9.8; at += 0.0371) {
        for (int i = 0; i < 2; i++)
            motion_sum(&m[i], 1, at, u[i], v[i], a[i]);
        for (int c = 0; c < 6; c++) {
            near_abs(u[1][c], u[0][c], 1e-7); /* 5/384 (3 * 0.025)^4 */
            near_abs(v[1][c], v[0][c], 2e-5);
            near_abs(a[1][c], a[0][c], 2e-3);
        }
    }
    series_free(&s);
}

static void memory_runs_out(void **state)
{
    const double t[3] = {0, 1, 2}, x[9] = {0};
    unsigned long n = 0;
    enum status s;
    (void)state;

    do {
        struct series p;

        mem_fail_at(++n);
        s = series_new(3, t, x, &p);
        if (s == SW_OK)
            series_free(&p);
        assert_true(s == SW_OK || s == SW_NOMEM);
    } while (s != SW_OK);
    mem_fail_at(0);
    assert_int_equal(n, 5);
}

TEST_MAIN(cmocka_unit_test(interpolates), cmocka_unit_test(smooth), cmocka_unit_test(accurate),
          cmocka_unit_test(outside), cmocka_unit_test(few), cmocka_unit_test(as_motion),
          cmocka_unit_test(memory_runs_out))
