/* Tolerances of lifts: enclosures, worst case, samples, derivatives against differences; design. */
#include "check.h"

#include "form/doubt.h"
#include "num/span.h"

static struct lift_given blank(int type)
{
    struct lift_given g = {.type = {type, LIFT_UNKNOWN, LIFT_UNKNOWN}};

    for (int i = 0; i < LIFT_NUMBERS; i++)
        g.x[i] = NAN;
    return g;
}

static void give(struct lift_given *g, int i, double x, double tol)
{
    g->x[i] = x * lift_unit(i);
    g->tol[i] = tol * lift_unit(i);
}

/* Height that judges, NAN if it is no arrangement. */
static double height(const struct lift_given *g)
{
    struct lift l;
    struct why why;

    return lift_make(g, &l, &why) == SW_OK ? judge_height(&l) : NAN;
}

static double worst(const struct lift_given *g)
{
    struct lift l;
    struct why why;

    assert_int_equal(lift_make(g, &l, &why), SW_OK);
    return doubt_worst(g, &l);
}

/* A spreader of an end, or of the whole. */
static void give_spreader(struct lift_given *g, int end, uint64_t *seed, double wide)
{
    double v = uniform_in(seed, 2, 8), s = uniform_in(seed, 2, 8);

    give(g, LIFT_AT(LIFT_V, end), v, wide * uniform(seed));
    give(g, LIFT_AT(LIFT_S, end), s, wide * uniform(seed));
    give(g, LIFT_AT(LIFT_Z, end), uniform_in(seed, -2, 3), wide * uniform(seed));
    give(g, LIFT_AT(LIFT_PHI, end), uniform_in(seed, 40, 60), 10 * wide * uniform(seed));
    give(g, LIFT_AT(LIFT_GAMMA, end), uniform_in(seed, -5, 8), 10 * wide * uniform(seed));
    give(g, LIFT_AT(LIFT_SPREADER, end), uniform_in(seed, 5, 10), wide * uniform(seed));
    give(g, LIFT_AT(LIFT_LOAD, end), uniform_in(seed, 30, 60), 10 * wide * uniform(seed));
}

/* Any arrangement of the kind-th sort, all its numbers with tolerances. */
static struct lift_given any(int kind, uint64_t *seed, double wide)
{
    struct lift_given g = blank(kind < 2    ? RIGGING_SECONDARY
                                : kind == 2 ? RIGGING_ELASTIC
                                : kind == 3 ? LIFT_PAIR
                                            : RIGGING_PRIMARY);

    if (kind == 0)
        give_spreader(&g, 0, seed, wide);
    if (kind == 1) { /* v from the sling, gamma from the base */
        give_spreader(&g, 0, seed, wide);
        give(&g, LIFT_AT(LIFT_SLING, 0), uniform_in(seed, 6, 9), wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_CROSS, 0), uniform_in(seed, 9, 14), wide * uniform(seed));
        g.x[LIFT_AT(LIFT_V, 0)] = g.x[LIFT_AT(LIFT_GAMMA, 0)] = NAN;
        g.tol[LIFT_AT(LIFT_V, 0)] = g.tol[LIFT_AT(LIFT_GAMMA, 0)] = 0;
    }
    if (kind == 2) {
        give(&g, LIFT_AT(LIFT_SLING, 0), uniform_in(seed, 12, 16), wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_Z, 0), uniform_in(seed, -2, 9), wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_LONG, 0), uniform_in(seed, 6, 9), wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_CROSS, 0), uniform_in(seed, 2, 9), wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_STRAIN, 0), uniform_in(seed, 0.01, 0.03), 0.005 * uniform(seed));
        give(&g, LIFT_AT(LIFT_LOAD, 0), uniform_in(seed, 60, 90), 5 * wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_WLL, 0), 400, 0);
    }
    if (kind == 3) {
        give_spreader(&g, 2, seed, wide);
        give(&g, LIFT_AT(LIFT_LOAD, 1), uniform_in(seed, 30, 60), 5 * wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_Z, 1), uniform_in(seed, -1, 3), wide * uniform(seed));
    }
    if (kind == 4) { /* about the rule of 5 degrees */
        give(&g, LIFT_AT(LIFT_V, 0), uniform_in(seed, 4, 8), wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_Z, 0), uniform_in(seed, -1, 1), wide * uniform(seed));
        give(&g, LIFT_AT(LIFT_PHI, 0), uniform_in(seed, 3, 7), 10 * wide * uniform(seed));
    }
    return g;
}

#define KINDS 5

/* What the arrangements of the box have least, by corners and samples, against the bound. */
static void worst_case(void **state)
{
    uint64_t seed = 17;
    int checked = 0;
    (void)state;

    for (int i = 0; i < 400; i++) {
        struct lift_given g = any(i % KINDS, &seed, i % 3 == 0 ? 0.02 : 0.2), sample;
        double bound, least = INFINITY;

        if (isnan(height(&g)))
            continue;
        bound = worst(&g);
        for (int k = 0; k < 3000; k++) {
            double h;

            sample = g;
            for (int n = 0; n < LIFT_NUMBERS; n++) {
                double u = uniform_in(&seed, -1, 1);

                sample.x[n] += g.tol[n] * (k % 2 ? u : u < 0 ? -1 : 1);
            }
            h = height(&sample);
            assert_true(!isnan(h) || bound == -INFINITY);
            least = fmin(least, h);
        }
        assert_true(bound <= least);
        if (isfinite(bound)) {
            near_abs(bound, least, 0.05 * (height(&g) - bound) + 1e-5);
            checked++;
        }
    }
    assert_true(checked > 200);
}

/* h has its least value between the ends of the range of gamma: no corner shows it. */
static void between_corners(void **state)
{
    struct lift_given g = blank(RIGGING_SECONDARY), sample;
    double least = INFINITY, corners;
    (void)state;

    give(&g, LIFT_AT(LIFT_V, 0), 3, 0);
    give(&g, LIFT_AT(LIFT_S, 0), 10, 0);
    give(&g, LIFT_AT(LIFT_Z, 0), 0, 0);
    give(&g, LIFT_AT(LIFT_PHI, 0), 60, 0);
    give(&g, LIFT_AT(LIFT_GAMMA, 0), -14, 12);
    give(&g, LIFT_AT(LIFT_SPREADER, 0), 0, 0);
    sample = g;
    for (int i = 0; i <= 100000; i++) {
        give(&sample, LIFT_AT(LIFT_GAMMA, 0), -26 + 24 * (i / 1e5), 0);
        least = fmin(least, height(&sample));
    }
    give(&sample, LIFT_AT(LIFT_GAMMA, 0), -26, 0);
    corners = height(&sample);
    give(&sample, LIFT_AT(LIFT_GAMMA, 0), -2, 0);
    corners = fmin(corners, height(&sample));
    assert_true(least < corners - 0.1);
    near_abs(worst(&g), least, 1e-5);
    assert_true(worst(&g) <= least);
}

static void edges(void **state)
{
    struct lift_given g = blank(RIGGING_PRIMARY);
    struct lift l;
    struct why why;
    (void)state;

    give(&g, LIFT_AT(LIFT_V, 0), 3, 0);
    give(&g, LIFT_AT(LIFT_Z, 0), 1, 0);
    give(&g, LIFT_AT(LIFT_PHI, 0), 30, 0);
    assert_true(isnan(worst(&g)));
    give(&g, LIFT_AT(LIFT_PHI, 0), 30, 26); /* may be less than 5 degrees: -z */
    near_abs(worst(&g), -1, 1e-6);
    give(&g, LIFT_AT(LIFT_PHI, 0), 30, 31); /* may be negative */
    assert_true(worst(&g) == -INFINITY);
    give(&g, LIFT_AT(LIFT_PHI, 0), 30, 0);
    give(&g, LIFT_AT(LIFT_V, 0), 3, 3);
    assert_true(worst(&g) == -INFINITY);
    assert_int_equal(lift_make(&g, &l, &why), SW_OK);
}

static void derivatives(void **state)
{
    uint64_t seed = 23;
    int checked = 0;
    (void)state;

    for (int i = 0; i < 2000; i++) {
        struct lift_given g = any(i % KINDS, &seed, 0.1);
        double slopes[LIFT_NUMBERS];
        struct lift l;
        struct why why;

        if (lift_make(&g, &l, &why) != SW_OK)
            continue;
        doubt_slopes(&g, &l, slopes);
        for (int n = 0; n < LIFT_NUMBERS; n++) {
            double step = 1e-5 * lift_unit(n), up, down, twice;

            assert_true(isnan(g.x[n]) == isnan(slopes[n]));
            if (isnan(slopes[n]))
                continue;
            g.x[n] += step;
            up = height(&g);
            g.x[n] -= 2 * step;
            down = height(&g);
            g.x[n] += step;
            twice = 2 * height(&g);
            if (!(fabs(up + down - twice) < 1e-7)) /* a kink: another view, or the rule */
                continue;
            near_abs(slopes[n], (up - down) / 2e-5, 1e-5 * (1 + fabs(slopes[n])));
            checked++;
        }
    }
    assert_true(checked > 8000);
}

static void samples(void **state)
{
    struct lift_given g = blank(RIGGING_PRIMARY);
    struct doubt d, again, other;
    (void)state;

    give(&g, LIFT_AT(LIFT_V, 0), 3, 0);
    give(&g, LIFT_AT(LIFT_Z, 0), 1, 0.6);
    give(&g, LIFT_AT(LIFT_PHI, 0), 30, 0);
    doubt_sample(&g, 200000, 1, 1.7, &d); /* h = 2 +- 0.6, uniform */
    near_abs(d.probability, 0.25, 4e-3);
    near_abs(d.mean, 2, 3e-3);
    near_abs(d.deviation, 0.6 / sqrt(3), 2e-3);
    doubt_sample(&g, 200000, 1, 1.7, &again);
    assert_true(again.probability == d.probability && again.mean == d.mean);
    doubt_sample(&g, 200000, 2, 1.7, &other);
    assert_true(other.mean != d.mean);
    give(&g, LIFT_AT(LIFT_V, 0), 3, 0.6); /* independent: a triangle */
    doubt_sample(&g, 200000, 3, 2 - 0.6, &d);
    near_abs(d.probability, 0.125, 4e-3);
    give(&g, LIFT_AT(LIFT_PHI, 0), 30, 60); /* below 0 in a quarter: no arrangement; below 5, or
                                               above 90 nowhere: 5/120 by the rule of 5 degrees */
    give(&g, LIFT_AT(LIFT_V, 0), 3, 0);
    doubt_sample(&g, 200000, 3, 0, &d);
    near_abs(d.probability, 35.0 / 120, 5e-3);
}

/* gamma beside the base that agrees with it: samples of gamma still are arrangements. */
static void samples_of_what_is_given_twice(void **state)
{
    struct lift_given g = blank(RIGGING_SECONDARY);
    struct doubt once, twice;
    double half = 3.6 * tan(26 * PI / 180) + 7.5 * tan(-4 * PI / 180);
    (void)state;

    give(&g, LIFT_AT(LIFT_V, 0), 3.6, 0.2);
    give(&g, LIFT_AT(LIFT_S, 0), 7.5, 0);
    give(&g, LIFT_AT(LIFT_Z, 0), 1.1, 0);
    give(&g, LIFT_AT(LIFT_PHI, 0), 26, 0);
    give(&g, LIFT_AT(LIFT_GAMMA, 0), -4, 3);
    give(&g, LIFT_AT(LIFT_SPREADER, 0), 0, 0);
    doubt_sample(&g, 10000, 1, 0, &once);
    assert_true(once.probability > 0.1 && once.probability < 0.5);
    give(&g, LIFT_AT(LIFT_CROSS, 0), 2 * half, 0);
    give(&g, LIFT_AT(LIFT_SLING, 0), 3.6 / cos(26 * PI / 180), 0);
    assert_true(!isnan(height(&g)));
    doubt_sample(&g, 10000, 1, 0, &twice);
    assert_true(once.probability == twice.probability && once.mean == twice.mean);
}

static void designs(void **state)
{
    uint64_t seed = 29;
    int found = 0;
    (void)state;

    for (int i = 0; i < 1000; i++) {
        struct lift_given g = any(i % KINDS, &seed, 0.1);
        static const int wanted[] = {LIFT_AT(LIFT_Z, 0),     LIFT_AT(LIFT_V, 0),
                                     LIFT_AT(LIFT_GAMMA, 0), LIFT_AT(LIFT_SPREADER, 0),
                                     LIFT_AT(LIFT_GAMMA, 2), LIFT_AT(LIFT_Z, 1)};
        int n = wanted[i % 6];
        double h = height(&g), target = h + uniform_in(&seed, -0.5, 0.5), x;

        if (isnan(h) || isnan(g.x[n]))
            continue;
        x = doubt_design(&g, n, target);
        if (isnan(x))
            continue;
        g.x[n] = x;
        near_abs(height(&g), target, 1e-6 * (1 + fabs(target)));
        found++;
    }
    assert_true(found > 250);
}

/* The operations of spans hold what the operations of numbers give. */
static void spans(void **state)
{
    uint64_t seed = 31;
    (void)state;

    for (int i = 0; i < 20000; i++) {
        double al = uniform_in(&seed, -1.5, 1.5), ah = uniform_in(&seed, al, 1.5);
        double bl = uniform_in(&seed, -2, 2), bh = uniform_in(&seed, bl, 2);
        struct span a = span_input(2, 0, al, ah), b = span_input(2, 1, bl, bh);
        double x = uniform_in(&seed, al, ah), y = uniform_in(&seed, bl, bh);
#define HOLDS(what, value, dx, dy)                                                                 \
    do {                                                                                           \
        struct span got = what;                                                                    \
        assert_true(got.lo <= (value) && (value) <= got.hi);                                       \
        assert_true(got.dlo[0] <= (dx) && (dx) <= got.dhi[0]);                                     \
        assert_true(got.dlo[1] <= (dy) && (dy) <= got.dhi[1]);                                     \
    } while (0)

        HOLDS(span_add(a, b), x + y, 1, 1);
        HOLDS(span_sub(a, b), x - y, 1, -1);
        HOLDS(span_mul(a, b), x * y, y, x);
        HOLDS(span_div(a, b), x / y, 1 / y, -x / y / y);
        HOLDS(span_square(a), x * x, 2 * x, 0);
        HOLDS(span_tan(a), tan(x), 1 + tan(x) * tan(x), 0);
        HOLDS(span_either(a, b, a), i % 2 ? x : y, i % 2, !(i % 2));
        HOLDS(span_min(a, b), fmin(x, y), x < y, x >= y);
        if (al > 0) {
            HOLDS(span_root(a), sqrt(x), 0.5 / sqrt(x), 0);
            HOLDS(span_cos(a), cos(x), -sin(x), 0);
        }
    }
}

TEST_MAIN(cmocka_unit_test(worst_case), cmocka_unit_test(between_corners), cmocka_unit_test(edges),
          cmocka_unit_test(derivatives), cmocka_unit_test(samples),
          cmocka_unit_test(samples_of_what_is_given_twice), cmocka_unit_test(designs),
          cmocka_unit_test(spans))
