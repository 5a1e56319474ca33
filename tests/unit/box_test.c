/* Heights in interval arithmetic enclose those of every suspension of the box; boxes that may leave
 * the ranges are refused; quotients by intervals that touch 0. */
#include "check.h"

#include "phys/box.h"

static uint64_t seed = 77;

/* One number of the box: x within a half width of `wide` times itself, or not given. */
static double choose(struct span *ret, int input, double low, double high, double wide, int given)
{
    double x = uniform_in(&seed, low, high), half = wide * fabs(x) * uniform(&seed);

    *ret = given ? span_input(12, input, x - half, x + half) : span_none();
    return given ? x + half * uniform_in(&seed, -1, 1) : NAN;
}

/* Some of a number's rows are left out, by chance. */
static int often(void)
{
    return uniform(&seed) < 0.6;
}

static double least(const struct rigging_heights *h)
{
    enum rigging_view view;

    return rigging_least(h->h, &view);
}

/* A suspension of the box, and the box around it, with what its type knows. */
static void draw(int type, double wide, struct rigging *r, struct rigging_box *b)
{
    int spreader = type == RIGGING_SECONDARY, elastic = type == RIGGING_ELASTIC;
    int by_sling = often(), bases = (int)(4 * uniform(&seed));
    double low = type == RIGGING_PRIMARY && often() ? 0.3 : 1; /* upright: the rule of 5 degrees */

    *r = (struct rigging){.type = (enum rigging_type)type, .loose = 1};
    *b = (struct rigging_box){.type = (enum rigging_type)type, .n = 12, .slings = 4};
    r->v = choose(&b->v, 0, 4, 9, wide, !by_sling);
    r->s = choose(&b->s, 1, 4, 9, wide, spreader);
    r->z = choose(&b->z, 2, -2, 6, wide, 1);
    r->phi = choose(&b->phi, 3, low / 20, low, wide, spreader || often());
    r->gamma = choose(&b->gamma, 4, -0.2, 0.2, wide, spreader && often());
    r->m_spreader = choose(&b->m_spreader, 5, 0, 3e3, wide, spreader);
    r->m_load = choose(&b->m_load, 6, 2e4, 5e4, wide, 1);
    r->sling = choose(&b->sling, 7, 2, 12, wide, by_sling);
    r->base[0] = choose(&b->base[0], 8, low, 5 * low, wide, (bases & 1) || elastic);
    r->base[1] = choose(&b->base[1], 9, low, 5 * low, wide, (bases & 2) || elastic);
    if (elastic && often()) { /* phi makes the base */
        r->phi = choose(&b->phi, 3, 0.1, 0.6, wide, 1);
        r->base[0] = NAN;
        b->base[0] = span_none();
    } else if (elastic && often()) { /* of one end, whose slings lie across */
        r->base[0] = r->base[1];
        r->base[1] = 1e3;
        b->one_hook = 1;
        b->base[0] = span_none();
    }
    if (spreader && isnan(r->gamma)) { /* one base makes it */
        r->base[1] = choose(&b->base[1], 9, 2, 8, wide, 1);
        b->base[0] = span_none();
        r->base[0] = NAN;
    }
    if (spreader && !by_sling && often()) { /* vertical slings, at an angle that is not known */
        r->phi = r->base[0] = r->base[1] = NAN;
        r->gamma = choose(&b->gamma, 4, 0, 0, wide, 1);
        b->phi = b->base[0] = b->base[1] = span_none();
    }
    r->strain_wll = choose(&b->strain_wll, 10, 0.01, 0.1, wide, elastic);
    r->wll = choose(&b->wll, 11, 3e5, 4e5, wide, elastic && often());
    r->use = NAN;
    b->use = span_none();
    r->wll_secondary = r->slings = r->stabilized = NAN;
    if (often())
        r->stabilized = b->stabilized = 1;
}

static void encloses(void **state)
{
    int made[RIGGING_SECONDARY + 1] = {0}, refused = 0;
    (void)state;

    for (int k = 0; k < 8000; k++) {
        int type = k % (RIGGING_SECONDARY + 1);
        struct rigging r;
        struct rigging_box b;
        struct suspension a;
        struct rigging_fault fault;
        struct rigging_heights h;
        struct span height, over_load;
        double x;

        draw(type, k % 3 ? 0.02 : 1e-9, &r, &b);
        if (!rigging_box_height(&b, &height, &over_load)) {
            refused++;
            assert_false(type == RIGGING_SECONDARY && isnan(r.phi)); /* vertical slings: (6) */
            continue;
        }
        if (rigging_complete(&r, &a, &fault) != SW_OK)
            continue;
        rigging_heights(&a, &h);
        x = least(&h);
        if (isinf(x)) {
            assert_true(isinf(height.hi));
            continue;
        }
        if (!(height.lo <= x && x <= height.hi))
            print_error("type %d: %.17g not in [%.17g, %.17g]\n", type, x, height.lo, height.hi);
        assert_true(height.lo <= x && x <= height.hi);
        x /= rigging_tilt_ratio(&a);
        if (type == RIGGING_SECONDARY && rigging_tilt_ratio(&a) > 0)
            assert_true(over_load.lo <= x && x <= over_load.hi);
        made[type]++;
    }
    for (int type = 0; type <= RIGGING_SECONDARY; type++)
        assert_true(made[type] > 200);
    assert_true(refused > 10);
}

/* Each number just beyond its range. */
static void ranges(void **state)
{
    static const struct {
        size_t at;
        double low, high;
    } bad[] = {
        {offsetof(struct rigging_box, v), -1, 5},
        {offsetof(struct rigging_box, v), 5, 1e4},
        {offsetof(struct rigging_box, s), 0, 1},
        {offsetof(struct rigging_box, phi), 0.1, 1.6},
        {offsetof(struct rigging_box, m_load), 0, 1},
        {offsetof(struct rigging_box, sling), -1, 1},
        {offsetof(struct rigging_box, base[0]), 0, 1},
        {offsetof(struct rigging_box, base[1]), 1, 2e4},
        {offsetof(struct rigging_box, wll), 1, 2e12},
        {offsetof(struct rigging_box, m_spreader), -1, 1},
        {offsetof(struct rigging_box, strain_wll), -0.1, 0.1},
        {offsetof(struct rigging_box, strain_wll), 0.1, 1},
        {offsetof(struct rigging_box, use), -1, 1},
        {offsetof(struct rigging_box, gamma), -1.6, 0},
        {offsetof(struct rigging_box, gamma), 0, 1.6},
    };
    (void)state;

    for (size_t k = 0; k <= sizeof bad / sizeof *bad; k++) {
        struct rigging r;
        struct rigging_box b;
        struct span h, over_load;

        do {
            draw(RIGGING_PRIMARY, 1e-9, &r, &b);
        } while (isnan(r.v) || isnan(r.base[0]));
        if (k < sizeof bad / sizeof *bad)
            *(struct span *)((char *)&b + bad[k].at) = span_input(12, 3, bad[k].low, bad[k].high);
        assert_int_equal(rigging_box_height(&b, &h, &over_load), k == sizeof bad / sizeof *bad);
    }
}

/* 1 over [0, 2] is at least a half, over [-1, 1] anything; its slope is never positive. */
static void quotients(void **state)
{
    struct span one = span_of(1, 1), q = span_div(one, span_input(1, 0, 0, 2));
    (void)state;

    near_abs(q.lo, 0.5, 1e-15);
    assert_true(q.lo <= 0.5 && isinf(q.hi) && q.hi > 0);
    assert_true(isinf(q.dlo[0]) && q.dlo[0] < 0);
    assert_true(q.dhi[0] >= 0);
    near_abs(q.dhi[0], 0, 1e-300);
    q = span_div(one, span_input(1, 0, -1, 1));
    assert_true(isinf(q.lo) && isinf(q.hi) && q.lo < 0 && q.hi > 0);
    q = span_div(one, span_input(1, 0, -4, -2));
    near_abs(q.lo, -0.5, 1e-15);
    near_abs(q.hi, -0.25, 1e-15);
}

TEST_MAIN(cmocka_unit_test(encloses), cmocka_unit_test(ranges), cmocka_unit_test(quotients))
