/* Lengths from what is known of a cable: put back, closed forms, both branches, least values. */
#include "check.h"

#include "num/mem.h"
#include "phys/find.h"
#include "phys/modes.h"

#include <float.h>

static const struct load none = {0};

/*
 * What a cable of the length L0 has, by a way of its own: reactions as vectors, the sag from the
 * place in space, frequencies from all modes of the model.
 */
static double quantity(const struct cable *cold, const struct load *load, const struct known *k,
                       double L0)
{
    struct cable c = *cold, hung;
    struct axes axes;
    struct line line;
    struct line_point p;
    double at = k->given == GIVEN_LEFT || k->given == GIVEN_HORIZONTAL ? 0
                : k->given == GIVEN_RIGHT                              ? 1
                                                                       : 0.5;
    double t[3], x[3];

    c.L0 = L0;
    load_apply(&c, load, &hung, &axes);
    assert_int_equal(line_solve(&hung, &line), SW_OK);
    line_at(&line, at * hung.L0, &p);
    axes_to_space(&axes, (double[3]){line.H, p.V, 0}, t);
    axes_to_space(&axes, (double[3]){p.x1, p.x2, 0}, x);
    if (k->given == GIVEN_HORIZONTAL)
        return t[0];
    if (k->given == GIVEN_SAG)
        return x[1] - x[0] / cold->span * cold->drop;
    if (k->given == GIVEN_FREQUENCY) {
        struct model m;
        struct modes p_all;
        double omega = NAN;
        int n = 0;

        assert_int_equal(model_new(&hung, k->law, k->elements, &m), SW_OK);
        assert_int_equal(modes_lowest(&m, 6 * k->elements, SOLVER_DENSE, &p_all), SW_OK);
        for (int i = 0; i < p_all.k; i++)
            if (p_all.plane[i] == k->part && ++n == k->mode)
                omega = p_all.omega[i];
        modes_free(&p_all);
        model_free(&m);
        return omega / (2 * PI);
    }
    return sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
}

/*
 * What is asked for is 1e-12; but one place of the length changes a tension T by EA eps (eps of the
 * strain 1, against T/EA), frequencies by half of that share, and the sag by at most
 * d sag/d L0 eps L0, which is below L0/sag eps of L0.
 */
static double tolerance(const struct cable *c, const struct known *k, double x, double L0)
{
    if (k->given == GIVEN_SAG)
        return 1e-12 * x + 8 * DBL_EPSILON * L0 * (1 + L0 / x);
    if (k->given == GIVEN_FREQUENCY) {
        double speed = 2 * L0 * x / k->mode;

        return x * (1e-11 + 16 * DBL_EPSILON * c->EA / (c->mu * speed * speed));
    }
    return 1e-12 * x + 8 * DBL_EPSILON * c->EA;
}

static struct cable random_cable(uint64_t *seed)
{
    double chord = log_uniform(seed, 1, 1e3), angle = uniform_in(seed, -75, 75) * PI / 180;
    struct cable c = {.g = 9.81, .mu = log_uniform(seed, 1e-2, 1e3)};

    c.L0 = chord * (uniform(seed) < 0.4 ? 1 / (1 + log_uniform(seed, 1e-5, 2e-2))
                                        : 1 + log_uniform(seed, 1e-6, 3));
    c.span = chord * cos(angle);
    c.drop = uniform(seed) < 0.3 ? 0 : chord * sin(angle);
    c.EA = c.mu * c.g * c.L0 * log_uniform(seed, 1e2, 1e6);
    return c;
}

static struct load random_load(uint64_t *seed, const struct cable *c)
{
    struct load load = none;

    if (uniform(seed) < 0.5)
        return load;
    load.ice = c->mu * uniform(seed);
    load.wind[0] = c->mu * c->g * uniform_in(seed, -0.2, 0.2);
    load.wind[1] = c->mu * c->g * uniform_in(seed, -0.3, 1);
    load.wind[2] = c->mu * c->g * uniform_in(seed, -1, 1);
    load.temperature = uniform_in(seed, -50, 50);
    load.expansion = 1.2e-5;
    return load;
}

static double find(const struct cable *c, const struct load *load, const struct known *k)
{
    double L0 = NAN, least = NAN;
    enum status s = find_length(c, load, k, &L0, &least);

    if (s != SW_OK)
        print_error("given %d = %.17g, slack %d: least %.17g\nspan %.17g drop %.17g EA %.17g mu "
                    "%.17g\n",
                    k->given, k->value, k->slack, least, c->span, c->drop, c->EA, c->mu);
    assert_int_equal(s, SW_OK);
    return L0;
}

/*
 * The cable itself has what is known, so it must be found: the tauter one is at most as long, and
 * where it is shorter the slacker one is this cable.  Both have the value; nothing tauter has it.
 */
static void judge(const struct cable *c, const struct load *load, struct known *k)
{
    double L0, taut, slack, most = tolerance(c, k, k->value, c->L0);

    k->slack = 0;
    taut = find(c, load, k);
    near_abs(quantity(c, load, k, taut), k->value, most);
    for (int i = 1; i <= 60; i++) { /* ever tauter: larger forces and frequencies, less sag */
        double more;

        L0 = taut * (1 - 1e-3 * i * i / 3600.0);
        more = quantity(c, load, k, L0) - k->value;
        assert_true((k->given == GIVEN_SAG ? -more : more) > -most);
    }
    if (fabs(quantity(c, load, k, c->L0 * (1 + 1e-9)) - k->value) <= 10 * most ||
        taut >= c->L0 * (1 - 1e-9))
        return;
    k->slack = 1;
    slack = find(c, load, k);
    near_abs(quantity(c, load, k, slack), k->value, most);
    near_rel(slack, c->L0, 1e-9);
}

static void forces_and_sags(void **state)
{
    uint64_t seed = 1405;
    (void)state;

    for (int i = 0; i < 4000; i++) {
        struct cable c = random_cable(&seed);
        struct load load = random_load(&seed, &c);
        struct known k = {.given = (enum given)(i % GIVEN_FREQUENCY)};

        k.value = quantity(&c, &load, &k, c.L0);
        if (k.value > 0)
            judge(&c, &load, &k);
    }
}

/* Lateral frequencies fall with the length, so that one cable only has them. */
static void lateral_frequencies(void **state)
{
    uint64_t seed = 77;
    (void)state;

    for (int i = 0; i < 150; i++) {
        struct cable c = random_cable(&seed);
        struct load load = random_load(&seed, &c);
        struct known k = {.given = GIVEN_FREQUENCY,
                          .part = PART_LATERAL,
                          .mode = 1 + i % 2,
                          .law = (enum law)(i % 3),
                          .elements = 4};
        double other, least;

        if (c.L0 > 1.5 * line_chord(&c))
            continue; /* four elements are no model of a cable so slack */
        k.value = quantity(&c, &load, &k, c.L0);
        judge(&c, &load, &k);
        k.slack = 1;
        assert_int_equal(find_length(&c, &load, &k, &other, &least), SW_INFEASIBLE);
        assert_true(isnan(least));
    }
}

/*
 * Frequencies in the plane fall, rise and fall again: the tauter cable is the tautest of up to
 * three.  No finer walk from taut to it meets the value.  (Once one step of the search went over
 * the whole dip, and the cable beyond it was called the tauter one.)
 */
static void frequencies_in_the_plane(void **state)
{
    uint64_t seed = 8;
    (void)state;

    for (int i = 0; i < 120; i++) {
        struct cable c = random_cable(&seed);
        struct known k = {.given = GIVEN_FREQUENCY,
                          .part = PART_PLANE,
                          .mode = 1 + i % 3,
                          .law = LAW_HOOKE,
                          .elements = 5};
        double taut, from, d = line_chord(&c), speed;

        if (c.L0 > 1.5 * d)
            continue;
        k.value = quantity(&c, &none, &k, c.L0);
        taut = find(&c, &none, &k);
        near_abs(quantity(&c, &none, &k, taut), k.value, tolerance(&c, &k, k.value, taut));
        assert_true(taut <= c.L0 * (1 + 1e-9));
        speed = 2 * d * k.value;
        from = d / (1 + 2 * c.mu * speed * speed / c.EA); /* twice the string's force for mode 1 */
        for (int j = 0; j < 100; j++) {
            double L0 = taut - (taut - from) * (j + 0.5) * (j + 0.5) / 1e4;

            assert_true(quantity(&c, &none, &k, L0) > k.value * (1 - 1e-9));
        }
    }
}

/* The three cables of one frequency in the plane: the second one, found as the slacker. */
static void slacker_in_the_plane(void **state)
{
    struct known k = {
        .given = GIVEN_FREQUENCY, .part = PART_PLANE, .mode = 1, .law = LAW_HOOKE, .elements = 10};
    double taut, slack;
    (void)state;

    k.value = 1.05 * quantity(&seil1, &none, &k, 100.38);
    taut = find(&seil1, &none, &k);
    k.slack = 1;
    slack = find(&seil1, &none, &k);
    assert_true(taut < slack && slack < 100.45);
    near_rel(quantity(&seil1, &none, &k, taut), k.value, 1e-11);
    near_rel(quantity(&seil1, &none, &k, slack), k.value, 1e-11);
    for (double L0 = taut + 1e-3; L0 < slack - 1e-3; L0 += 1e-3)
        assert_true(quantity(&seil1, &none, &k, L0) < k.value);
}

/* A taut string: H = 4 m l^2 f^2 with m = mu L0/l, whatever the mode: its frequency over its
 * number. */
static void taut_string(void **state)
{
    const struct cable bare = {.mu = 3, .EA = 5e7, .span = 60, .drop = -25};
    const struct {
        double g;
        int elements;
        double tolerance;
    } row[] = {{0, 40, 2e-7},     /* what 40 elements are off by: (pi k/n)^4/720 and the like */
               {9.81, 40, 1e-5}}; /* (weight/tension)^2 */
    (void)state;

    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        for (int mode = 1; mode <= 3; mode++)
            for (int plane = 0; plane <= 1; plane++) {
                struct cable c = bare;
                struct known k = {.given = GIVEN_FREQUENCY,
                                  .value = 2.5 * mode,
                                  .mode = mode,
                                  .part = plane ? PART_PLANE : PART_LATERAL,
                                  .elements = row[i].elements};
                double l = line_chord(&c);
                struct line s;

                c.g = row[i].g;
                c.L0 = find(&c, &none, &k);
                assert_int_equal(line_solve(&c, &s), SW_OK);
                near_rel(s.H * l / c.span, 4 * (c.mu * c.L0 / l) * l * l * 2.5 * 2.5,
                         plane && c.g > 0 ? 1e-2 : row[i].tolerance); /* lambda2 stiffens */
            }
}

/* Small sag: w l^2/(8 H); and the sag of a catenary, H/w (cosh(w l/(2 H)) - 1). */
static void closed_sags(void **state)
{
    struct known k = {.given = GIVEN_SAG, .value = 0.5};
    struct cable c = seil1;
    struct line s;
    (void)state;

    c.L0 = find(&c, &none, &k);
    assert_int_equal(line_solve(&c, &s), SW_OK);
    near_rel(c.mu * c.L0 * c.g * c.span / 8 / s.H, 0.5, 1e-4); /* (sag/span)^2 */
    c = (struct cable){.mu = 1, .EA = 1e14, .g = 9.81, .span = 100};
    for (double v = 0.2; v < 4; v *= 1.7) { /* v = w l/(2 H) */
        k.value = 50 / v * (cosh(v) - 1);
        near_rel(find(&c, &none, &k), 100 * sinh(v) / v, 1e-9); /* EA not infinite: w L0/EA */
    }
}

/* A cable without gravity carries EA (chord/L0 - 1). */
static void weightless(void **state)
{
    struct cable c = {.mu = 2, .EA = 1e6, .span = 80, .drop = 60}, lifted = c;
    const struct load balance = {.ice = 37, .wind = {0, -382.59, 0}};
    struct known k = {.value = 1234.5};
    double L0, least;
    (void)state;

    lifted.g = 9.81;
    for (int i = GIVEN_MIDSPAN; i <= GIVEN_RIGHT; i++) {
        k.given = (enum given)i;
        near_rel(find(&c, &none, &k), 100 / (1 + 1234.5e-6), 1e-14);
        near_rel(find(&lifted, &balance, &k), 100 / (1 + 1234.5e-6), 1e-14);
    }
    k.given = GIVEN_HORIZONTAL;
    near_rel(find(&c, &none, &k), 100 / (1 + 1234.5e-6 / 0.8), 1e-14);
    k.given = GIVEN_SAG;
    assert_int_equal(find_length(&c, &none, &k, &L0, &least), SW_INFEASIBLE);
    k.given = GIVEN_LEFT;
    k.slack = 1;
    assert_int_equal(find_length(&c, &none, &k, &L0, &least), SW_INFEASIBLE);
}

/* The expansion is taken back: the cold cable that has the force when warm. */
static void warm(void **state)
{
    struct load load = {.temperature = 50, .expansion = 1.2e-5};
    struct known k = {.given = GIVEN_MIDSPAN, .value = 5e6};
    struct cable hot = pont;
    double L0 = find(&pont, &load, &k);
    (void)state;

    near_rel(quantity(&pont, &load, &k, L0), 5e6, 1e-11);
    hot.L0 = L0 * (1 + 6e-4);
    hot.mu /= 1 + 6e-4;
    near_rel(quantity(&hot, &none, &k, hot.L0), 5e6, 1e-10);
}

/* Tension at an end has a least value: below it nothing, above it two cables, one on each side. */
static void least_tension(void **state)
{
    uint64_t seed = 5150;
    (void)state;

    for (int i = 0; i < 300; i++) {
        struct cable c = random_cable(&seed);
        struct load load = random_load(&seed, &c);
        struct known k = {.given = i % 2 ? GIVEN_LEFT : GIVEN_RIGHT, .value = 1e-6};
        double L0, least = NAN, taut, slack;

        c.EA *= 1e2; /* strains that leave the least value to the shape */
        assert_int_equal(find_length(&c, &load, &k, &L0, &least), SW_INFEASIBLE);
        assert_true(least > 0);
        k.value = 0.999999 * least; /* golden section knows the least value to 1e-12 */
        assert_int_equal(find_length(&c, &load, &k, &L0, &least), SW_INFEASIBLE);
        k.value = 1.0001 * least;
        taut = find(&c, &load, &k);
        k.slack = 1;
        slack = find(&c, &load, &k);
        assert_true(slack > taut);
        for (int j = 0; j <= 20; j++)
            assert_true(quantity(&c, &load, &k, taut + (slack - taut) * j / 20) >=
                        least * (1 - 1e-9));
    }
}

/* The lowest frequency in the plane falls, rises to where the antisymmetric mode becomes the lower
 * one, and falls: of the slacker cables that have a little less than this peak the first one is
 * found, however narrow the peak is there. */
static void narrow_peak(void **state)
{
    const int steps = 4000;
    int peaks = 0;
    (void)state;

    for (int i = 0; i < 6; i++) {
        struct known k = {.given = GIVEN_FREQUENCY,
                          .slack = 1,
                          .part = PART_PLANE,
                          .mode = 1,
                          .law = LAW_THESIS,
                          .elements = 2};
        struct cable c = pont;
        double chord = hypot(c.span, c.drop), before = 0, peak = 0, at = NAN, L0;

        for (int j = 0; j < steps; j++) {
            double x = chord * (1 - 2e-3 + 2e-2 * j / steps), f = quantity(&c, &none, &k, x);

            if (peak == 0 && before > 0 && f > before)
                peak = -1; /* it rises */
            if (peak < 0 && f < before) {
                peak = before;
                at = x;
            }
            before = f;
        }
        if (!(peak > 0))
            continue;
        k.value = peak * (1 - pow(10, -2 - i / 2.0));
        L0 = find(&c, &none, &k);
        near_rel(quantity(&c, &none, &k, L0), k.value, 1e-8);
        assert_true(L0 < at);
        peaks++;
    }
    assert_int_equal(peaks, 6);
}

/* Nothing has it: more than a thousandfold stretch gives, a sag less than any. */
static void infeasible(void **state)
{
    struct known k = {.given = GIVEN_LEFT, .value = 1e30};
    struct cable bad = pont;
    double L0 = 7, least = 0;
    (void)state;

    assert_int_equal(find_length(&pont, &none, &k, &L0, &least), SW_INFEASIBLE);
    assert_true(isinf(least));
    k = (struct known){.given = GIVEN_SAG, .value = 1e-13};
    assert_int_equal(find_length(&pont, &none, &k, &L0, &least), SW_INFEASIBLE);
    k = (struct known){
        .given = GIVEN_FREQUENCY, .value = 1e-9, .mode = 1, .part = PART_LATERAL, .elements = 4};
    assert_int_equal(find_length(&pont, &none, &k, &L0, &least), SW_INFEASIBLE);
    assert_true(least > 1e-9);
    bad.mu = NAN;
    assert_int_not_equal(find_length(&bad, &none, &k, &L0, &least), SW_OK);
    assert_true(L0 == 7);
}

/* Each request for memory fails once; nothing is lost (valgrind and the sanitizer look on). */
static void memory(void **state)
{
    const struct known k = {
        .given = GIVEN_FREQUENCY, .value = 1.25, .mode = 1, .part = PART_LATERAL, .elements = 3};
    double L0 = NAN, least;
    enum status s = SW_NOMEM;
    unsigned long n;
    (void)state;

    for (n = 1; s != SW_OK; n++) {
        mem_fail_at(n);
        s = find_length(&pont, &none, &k, &L0, &least);
        mem_fail_at(0);
        if (s != SW_OK)
            assert_int_equal(s, SW_NOMEM);
        assert_true(n < 10000);
    }
    assert_true(n > 20);
    near_rel(L0, find(&pont, &none, &k), 0);
}

TEST_MAIN(cmocka_unit_test(forces_and_sags), cmocka_unit_test(lateral_frequencies),
          cmocka_unit_test(frequencies_in_the_plane), cmocka_unit_test(slacker_in_the_plane),
          cmocka_unit_test(taut_string), cmocka_unit_test(closed_sags),
          cmocka_unit_test(weightless), cmocka_unit_test(warm), cmocka_unit_test(least_tension),
          cmocka_unit_test(narrow_peak), cmocka_unit_test(infeasible), cmocka_unit_test(memory))
