/* Orbits: ellipses whose axes, lean and sense are known, harmonics, bounds, planes. */
#include "check.h"
#include "phys/orbit.h"

#include <string.h>

enum { SAMPLES = 50 };

/* An ellipse of half axes a, b in (x2, x3), longer axis leaning by `lean` from x2 towards x3, run
 * through `sense` = 1 from x2 towards x3, -1 the other way round; at k half orders. */
static void ellipse(double a, double b, double lean, int sense, int k, double start, double phi,
                    double v[3])
{
    double along = a * cos(k * phi / 2 + start), across = sense * b * sin(k * phi / 2 + start);

    v[1] += along * cos(lean) - across * sin(lean);
    v[2] += along * sin(lean) + across * cos(lean);
}

static void known_ellipses(void **state)
{
    uint64_t seed = 99;
    (void)state;

    for (int run = 0; run < 400; run++) {
        double a = uniform_in(&seed, 0.5, 2), b = a * uniform_in(&seed, 0.06, 0.95);
        double lean = uniform_in(&seed, -1.5, 1.5), begin = uniform_in(&seed, -3, 3);
        int sense = run % 2 ? 1 : -1, k = 1 + run % ORBIT_ORDERS;
        struct orbit_window w = {0};
        struct orbit o;

        for (int i = 0; i < 4 * SAMPLES; i++) { /* four periods, from anywhere */
            double phi = 17.3 + 2 * PI * i / SAMPLES, v[3] = {0.01, 0.2, -0.1};

            ellipse(a, b, lean, sense, k, begin, phi, v);
            orbit_add(&w, phi, v, 1000 + i);
        }
        orbit_of(&w, &o);
        near_rel(o.major, a, 1e-12);
        near_rel(o.minor, b, 1e-11);
        near_abs(o.tilt, lean, 1e-9 / (1 - b / a));
        assert_int_equal(o.order, k);
        assert_int_equal(o.plane, sense > 0 ? ORBIT_WHIRL_RIGHT : ORBIT_WHIRL_LEFT);
        near_abs(o.mean[0], 0.01, 1e-15);
        near_abs(o.mean[1], 0.2, 1e-13);
        near_abs(o.mean[2], -0.1, 1e-13);
        near_abs(o.tension, 1000 + 4 * SAMPLES - 1, 0);
        near_abs(o.harmonic[k - 1][0], 0, 1e-14);
    }
}

/* Each half order by itself, all of them together: sums over whole pairs of periods are exact. */
static void harmonics(void **state)
{
    struct orbit_window w = {0};
    struct orbit o;
    (void)state;

    for (int i = 0; i < 20 * SAMPLES; i++) {
        double phi = 2 * PI * (i + 1) / SAMPLES, v[3] = {0, 0, 0};

        for (int k = 1; k <= ORBIT_ORDERS; k++)
            for (int c = 0; c < 3; c++)
                v[c] += (c + 1) * cos(k * phi / 2 + 0.1 * c * k - 0.2 * k) / k;
        orbit_add(&w, phi, v, 1);
    }
    orbit_of(&w, &o);
    for (int k = 1; k <= ORBIT_ORDERS; k++)
        for (int c = 0; c < 3; c++) {
            near_rel(o.harmonic[k - 1][c], (c + 1.0) / k, 1e-12);
            near_abs(o.phase[k - 1][c], 0.1 * c * k - 0.2 * k, 1e-12);
        }
    assert_int_equal(o.order, 1);
}

static void bounds(void **state)
{
    struct orbit_window w = {0};
    struct orbit o;
    (void)state;

    orbit_add(&w, 0, (double[3]){1, -2, 5}, 7);
    orbit_add(&w, 1, (double[3]){-3, -1, 5}, 9);
    orbit_add(&w, 2, (double[3]){0, -7, 5}, 8);
    orbit_of(&w, &o);
    near_abs(o.least[0], -3, 0);
    near_abs(o.greatest[0], 1, 0);
    near_abs(o.amplitude[0], 2, 0);
    near_abs(o.least[1], -7, 0);
    near_abs(o.greatest[1], -1, 0);
    near_abs(o.amplitude[2], 0, 0);
    near_abs(o.tension, 9, 0);
}

/* The words: 5 per cent of the longer axis make it round; 0.1 of slope is still along an axis. */
static void planes(void **state)
{
    static const struct {
        double a, b, lean;
        int sense;
        enum orbit_plane wanted;
        const char *name;
    } try[] = {
        {1, 0, 0, 1, ORBIT_IN, "in"},
        {1, 0.049, 0, 1, ORBIT_IN, "in"},
        {1, 0.051, 0, 1, ORBIT_WHIRL_RIGHT, "whirling+"},
        {1, 0.051, 0, -1, ORBIT_WHIRL_LEFT, "whirling-"},
        {1, 0.01, 0.099, 1, ORBIT_IN, "in"},
        {1, 0.01, -0.099, 1, ORBIT_IN, "in"},
        {1, 0.01, 0.101, 1, ORBIT_INCLINED, "inclined"},
        {1, 0.01, -0.7, 1, ORBIT_INCLINED, "inclined"},
        {1, 0.01, PI / 2 - 0.101, 1, ORBIT_INCLINED, "inclined"},
        {1, 0.01, PI / 2 - 0.099, 1, ORBIT_LATERAL, "lateral"},
        {1, 0, -PI / 2 + 0.01, 1, ORBIT_LATERAL, "lateral"},
        {0, 0, 0, 1, ORBIT_REST, "rest"},
    };
    (void)state;

    for (size_t n = 0; n < sizeof try / sizeof *try; n++)
        for (int moves = 0; moves <= 1; moves++) { /* along the cable, too: at rest, that counts */
            struct orbit_window w = {0};
            struct orbit o;

            for (int i = 0; i < 2 * SAMPLES; i++) {
                double phi = 2 * PI * i / SAMPLES, v[3] = {moves * 5 * cos(phi), 0, 0};

                ellipse(try[n].a, try[n].b, try[n].lean, try[n].sense, 2, 0.4, phi, v);
                orbit_add(&w, phi, v, 1);
            }
            orbit_of(&w, &o);
            if (try[n].wanted == ORBIT_REST && moves) {
                assert_string_equal(orbit_plane_name(o.plane), "in");
                continue;
            }
            assert_int_equal(o.plane, try[n].wanted);
            assert_string_equal(orbit_plane_name(o.plane), try[n].name);
        }
}

TEST_MAIN(cmocka_unit_test(known_ellipses), cmocka_unit_test(harmonics), cmocka_unit_test(bounds),
          cmocka_unit_test(planes))
