/* Lifts in space: the elastic formulas, pendulums, shares of four slings, what modes are called. */
#include "rig.h"

#include "phys/sway.h"

static struct sway swaying(const struct gear *s, const struct hang *h)
{
    struct sway m;

    assert_int_equal(sway_of(s, h, &m), SW_OK);
    return m;
}

/* Case 1.2.5: two hooks crosswise, two slings each. */
static const struct tandem reactor = {.hooks = 2,
                                      .hook = {{0, -2.95}, {0, 2.95}},
                                      .slings = 2,
                                      .v = 14.5,
                                      .z = 8.4,
                                      .base_half = 3.85,
                                      .m_load = 1e5,
                                      .g = 9.81};

static double lengthwise(double v, double b, double z, double eps)
{
    return v * (1 - eps) / (1 + 4 * v * v * eps / (b * b)) - z;
}

static double crosswise(double v, double b, double l, double z, double eps)
{
    double c2 = 1 / (1 + b * b / (4 * v * v));

    return l * l / (4 * v) * (c2 / eps + 1 - c2) - z;
}

/* Steel 5.267 and 131.80 m, polyester 2.282 and 16.015 m; rigid: 6.1 m and no tilt at all. */
static void case_1_2_5(void **state)
{
    const double eps[] = {0.004, 0.023, 0}, h[][2] = {{5.267, 131.80}, {2.282, 16.015}, {6.1, 0}};
    (void)state;

    for (int i = 0; i < 3; i++) {
        struct tandem t = reactor;
        struct gear s;
        struct hang up;
        struct sway m;

        t.stretch_primary = eps[i];
        s = suspended_tandem(&t);
        up = hung(&s, HANG_DOWN);
        m = swaying(&s, &up);
        below(unbalanced(&s, &up), 1e-12);
        near_abs(sway_height(&s, &m, 0, 0, 0), h[i][0], 5e-4);
        if (i < 2)
            near_rel(sway_height(&s, &m, 0, 0, 1), h[i][1], 5e-5);
        else
            assert_true(isinf(sway_height(&s, &m, 0, 0, 1)));
    }
}

/* The corrected elastic formulas in the limit: derivatives, and a tilt of 1e-5 of the length. */
static void elastic_formulas(void **state)
{
    uint64_t seed = 9;
    (void)state;

    for (int i = 0; i < 1000; i++) {
        struct tandem t = reactor;
        double eps = log_uniform(&seed, 1e-4, 0.1), v = log_uniform(&seed, 1, 30), b, l, h[2];
        struct gear s;
        struct hang up;
        struct sway m;

        t.v = v;
        t.base_half = v * tan(uniform_in(&seed, 5, 60) * DEGREES);
        t.hook[1][1] = log_uniform(&seed, 1, 30);
        t.hook[0][1] = -t.hook[1][1];
        t.z = v * uniform_in(&seed, -1, 1);
        t.stretch_primary = eps;
        b = 2 * t.base_half;
        l = 2 * t.hook[1][1];
        h[0] = lengthwise(v, b, t.z, eps);
        h[1] = crosswise(v, b, l, t.z, eps);
        s = suspended_tandem(&t);
        up = hung(&s, HANG_NEAR);
        m = swaying(&s, &up);
        near_abs(sway_height(&s, &m, 0, 0, 0), h[0], 1e-8 * (v + fabs(t.z)));
        near_rel(sway_height(&s, &m, 0, 0, 1), h[1], 1e-8 * (1 + (h[1] + fabs(t.z)) / fabs(h[1])));
        if (h[0] < 0.1 * v || h[1] < 0.1 * v || h[1] > 1e3 * l)
            continue;
        for (int cross = 0; cross < 2; cross++) {
            t.offset[cross] = 1e-5 * h[cross];
            t.offset[!cross] = 0;
            s = suspended_tandem(&t);
            up = hung(&s, HANG_NEAR);
            below(unbalanced(&s, &up), 1e-11);
            near_rel(cross ? -asin(up.pose[0].R[2][1]) : pose_tilted(up.pose), 1e-5, 1e-6);
        }
    }
}

/* One hook, rigid slings, a load with products of inertia: a pendulum about the hook;
 * det(m g d I - omega^2 (J + m d^2 I)) = 0 over the turns about x and y. */
static void pendulum(void **state)
{
    struct tandem t = {.hooks = 1,
                       .slings = 4,
                       .v = 6,
                       .z = 1,
                       .base_half = 3,
                       .base_cross = 2,
                       .m_load = 1000,
                       .g = 9.81,
                       .inertia = {{9e3, 2e3, 0}, {2e3, 12e3, 0}, {0, 0, 15e3}}};
    struct gear s = suspended_tandem(&t);
    struct hang up = hung(&s, HANG_DOWN);
    struct sway m = swaying(&s, &up);
    double stiff = 1000 * 9.81 * 5, mean = 10.5e3 + 25e3, part = hypot(1.5e3, 2e3);
    (void)state;

    assert_int_equal(up.neutral, 1);
    assert_int_equal(up.indeterminate, 1);
    assert_int_equal(m.n, 2);
    near_rel(m.omega2[0], stiff / (mean + part), 1e-12);
    near_rel(m.omega2[1], stiff / (mean - part), 1e-12);
    near_rel(sway_height(&s, &m, 0, 0, 0), 5, 1e-12);
    near_rel(sway_height(&s, &m, 0, 0, 1), 5, 1e-12);
    for (int k = 0; k < 4; k++)
        near_rel(up.force[k], 2452.5 * sqrt(49) / 6, 1e-12);
}

/* Without moments of inertia the load is a box of the lifting base, as high as z or a quarter of
 * the base, whichever is more: here 6 x 4 x 2 and 6 x 4 x 1.5 m, m (b^2 + c^2)/3 in halves. */
static void pendulum_of_a_box(void **state)
{
    (void)state;

    for (int i = 0; i < 2; i++) {
        double z = i ? 0.5 : 1, half = i ? 0.75 : 1, d = 6 - z;
        struct tandem t = {.hooks = 1,
                           .slings = 4,
                           .v = 6,
                           .z = z,
                           .base_half = 3,
                           .base_cross = 2,
                           .m_load = 1000,
                           .g = 9.81};
        struct gear s = suspended_tandem(&t);
        struct hang up = hung(&s, HANG_DOWN);
        struct sway m = swaying(&s, &up);

        assert_int_equal(m.n, 2);
        near_rel(m.omega2[0], 9.81 * d / (d * d + (9 + half * half) / 3), 1e-12);
        near_rel(m.omega2[1], 9.81 * d / (d * d + (4 + half * half) / 3), 1e-12);
    }
}

/* Under two hooks the box reaches from the outermost lifting point to that of the other side. */
static void box_under_two_hooks(void **state)
{
    struct tandem t = reactor;
    double a = 3.85, b = 2.95 + 1.5, c = 8.4;
    struct gear s;
    (void)state;

    t.slings = 4;
    t.base_cross = 1.5;
    s = suspended_tandem(&t);
    near_rel(s.body[TANDEM_LOAD].inertia[0][0], 1e5 * (b * b + c * c) / 3, 1e-14);
    near_rel(s.body[TANDEM_LOAD].inertia[1][1], 1e5 * (a * a + c * c) / 3, 1e-14);
    near_rel(s.body[TANDEM_LOAD].inertia[2][2], 1e5 * (a * a + b * b) / 3, 1e-14);
}

/* On two slings it has no breadth, and swings across as a double pendulum of the lengths l, d:
 * the frequencies squared are the roots of g^2 l d - x g [l (d^2 + i) + d l^2] + x^2 l^2 i. */
static void double_pendulum(void **state)
{
    const double g = 9.81, l = 6, d = 1, i = (0 + 1) / 3.0;
    struct tandem t = {
        .hooks = 1, .slings = 2, .v = l, .z = -d, .base_half = 3, .m_load = 1000, .g = g};
    struct gear s = suspended_tandem(&t);
    struct hang up = hung(&s, HANG_DOWN);
    struct sway m = swaying(&s, &up);
    (void)state;

    assert_int_equal(m.n, 3);
    near_rel(m.omega2[0], g * (l + d) / ((l + d) * (l + d) + (9 + 1) / 3.0), 1e-12);
    near_rel(m.omega2[1] + m.omega2[2], g * (l * (d * d + i) + d * l * l) / (l * l * i), 1e-12);
    near_rel(m.omega2[1] * m.omega2[2], g * g * d / (l * i), 1e-12);
}

/* A ring without mass in a row between two equal loads counts as 1e-6 of one of them: it swings up
 * and down between its slings, which the loads do not feel. */
static void ring_without_mass(void **state)
{
    const double none[3][3] = {{0}}, EA = 1e6, mass = 1000, W = mass * 9.81;
    struct gear s = {.g = 9.81};
    int from = gear_add_point(&s, GEAR_HOOK, 0, 0, 0);
    struct hang h;
    struct sway m;
    double most = 0;
    (void)state;

    for (int b = 0; b < 3; b++) {
        double z = -5.0 * (b + 1), T = b == 0 ? 2 * W : W;
        int to;

        gear_add_body(&s, b == 1 ? 0 : mass, (double[3]){0, 0, z}, none);
        to = gear_add_point(&s, b, 0, 0, z);
        gear_tighten(&s, gear_add_sling(&s, from, to, 0, EA), T / (EA + T));
        from = to;
    }
    h = hung(&s, HANG_NEAR);
    m = swaying(&s, &h);
    for (int k = 0; k < m.n; k++)
        if (m.body[k] == 1 && m.kind[k] == HEAVE)
            most = m.omega2[k];
    near_rel(most, 2 * (EA + W) / 5 / (1e-6 * mass), 1e-5);
}

/* A load on four vertical slings of its own hooks at (-+a, -+c), centre of gravity at (x, y) off
 * the middle, z below the points. */
static struct gear four_hooks(double a, double c, double x, double y, double EA)
{
    struct gear s = {.g = 9.81};

    gear_add_body(&s, 1000, (double[3]){x, y, -6},
                  (const double[3][3]){{1e3, 0, 0}, {0, 2e3, 0}, {0, 0, 3e3}});
    for (int k = 0; k < 4; k++) {
        double X = k % 2 ? a : -a, Y = k / 2 ? c : -c;

        gear_add_sling(&s, gear_add_point(&s, GEAR_HOOK, X, Y, 0), gear_add_point(&s, 0, X, Y, -5),
                       0, EA);
    }
    return s;
}

/* Shares W/4 (1 + X x/a^2 + Y y/c^2), elastic or rigid (then left open by equilibrium). */
static void four_share(void **state)
{
    const double a = 3, c = 2, x = 0.7, y = 0.5, W = 9810;
    (void)state;

    for (int rigid = 0; rigid < 2; rigid++) {
        struct gear s = four_hooks(a, c, x, y, rigid ? INFINITY : 1e8);
        struct hang h = hung(&s, HANG_DOWN);

        assert_int_equal(h.indeterminate, rigid);
        assert_int_equal(h.neutral, 0);
        below(unbalanced(&s, &h), 1e-10);
        for (int k = 0; k < 4; k++)
            near_abs(h.force[k], W / 4 * (1 + (k % 2 ? x : -x) / a + (k / 2 ? y : -y) / c),
                     1e-4 * W);
    }
}

/* As many slings and points as there is room for, in a row: they carry the load together. */
static void full_room(void **state)
{
    (void)state;

    for (int rigid = 0; rigid < 2; rigid++) {
        struct gear s = {.g = 9.81};
        double sum = 0;
        struct hang h;

        gear_add_body(&s, 1000, (double[3]){0, 0, -6},
                      (const double[3][3]){{1e3, 0, 0}, {0, 2e3, 0}, {0, 0, 3e3}});
        for (int k = 0; k < GEAR_SLINGS; k++) {
            double x = k - (GEAR_SLINGS - 1) / 2.0, y = k % 2 ? 1 : -1;
            int from = gear_add_point(&s, GEAR_HOOK, x, y, 0);

            gear_add_sling(&s, from, gear_add_point(&s, 0, x, y, -5), 0, rigid ? INFINITY : 1e8);
        }
        assert_int_equal(gear_add_point(&s, 0, 0, 0, 0), -1);
        assert_int_equal(gear_add_sling(&s, 0, 1, 0, INFINITY), -1);
        h = hung(&s, HANG_DOWN);
        below(unbalanced(&s, &h), 1e-10);
        for (int k = 0; k < GEAR_SLINGS; k++)
            sum += h.force[k];
        near_rel(sum, 9810, 1e-9);
    }
}

/* Far enough out the far corner's sling goes slack and the other three are told by equilibrium:
 * moments about the diagonals. */
static void three_carry(void **state)
{
    const double a = 3, c = 2, x = 1.8, y = 1.2, W = 9810;
    (void)state;

    for (int rigid = 0; rigid < 2; rigid++) {
        struct gear s = four_hooks(a, c, x, y, rigid ? INFINITY : 1e8);
        struct hang h = hung(&s, HANG_DOWN);

        below(unbalanced(&s, &h), 1e-10);
        assert_true(h.force[0] == 0);
        near_rel(h.force[1], W / 2 * (1 - y / c), 1e-3);
        near_rel(h.force[2], W / 2 * (1 - x / a), 1e-3);
        near_rel(h.force[3], W / 2 * (x / a + y / c), 1e-3);
    }
}

/* Two slings of one hook: above their points the load turns over crosswise. */
static void words(void **state)
{
    struct tandem t = {
        .hooks = 1, .slings = 2, .v = 5, .z = 0.5, .base_half = 3, .m_load = 1000, .g = 9.81};
    struct gear s = suspended_tandem(&t);
    struct hang h = hung(&s, HANG_NEAR);
    struct sway m = swaying(&s, &h);
    (void)state;

    assert_true(h.least < 0 && m.omega2[0] < 0);
    assert_int_equal(h.neutral, 1);
    assert_int_equal(m.neutral, 1);
    assert_string_equal(sway_words(m.kind[0]), "tilt crosswise");
    below(sway_height(&s, &m, 0, 0, 1), 0);
    h = hung(&s, HANG_DOWN); /* and hangs below them in the end */
    assert_true(h.least > 0);
    near_rel(h.pose[0].r[2], -5.5, 1e-9);
    s = suspended_tandem(&reactor);
    h = hung(&s, HANG_DOWN);
    m = swaying(&s, &h);
    assert_int_equal(h.neutral, 0);
    assert_string_equal(sway_words(m.kind[0]), "swing crosswise");
    t.spreaders = 1; /* the spreader, a bar, spins about itself, and all turns below the hook */
    t.s = 4;
    t.z = -0.5;
    t.spreader_half = 3;
    t.m_spreader = 50;
    s = suspended_tandem(&t);
    h = hung(&s, HANG_NEAR);
    assert_int_equal(h.neutral, 2);
    assert_true(h.least > 0);
}

/* The tandem lift of a linkage: half of it under each of two hooks. */
static struct tandem doubled(const struct linkage *l)
{
    return (struct tandem){.hooks = 2,
                           .hook = {{0, -4}, {0, 4}},
                           .slings = 2,
                           .spreaders = 1,
                           .v = l->v,
                           .s = l->s,
                           .z = l->z,
                           .spreader_half = l->v * tan(l->phi),
                           .base_half = l->v * tan(l->phi) + l->s * tan(l->gamma),
                           .m_spreader = l->m_spreader / 2,
                           .m_load = l->m_load,
                           .g = l->g,
                           .offset = {l->offset}};
}

/* With spreaders under two hooks, lengthwise h is that of the planar formula. */
static void as_in_the_plane(void **state)
{
    uint64_t seed = 4;
    (void)state;

    for (int i = 0; i < 500; i++) {
        struct linkage l = random_linkage(&seed);
        struct formula f = formula_of(&l);
        struct tandem t = doubled(&l);
        struct gear s = suspended_tandem(&t);
        struct hang h = hung(&s, HANG_NEAR);
        struct sway m = swaying(&s, &h);
        double size = fabs(f.c * l.s) + l.v + l.s + fabs(l.z) * f.r;

        near_abs(sway_height(&s, &m, TANDEM_LOAD, TANDEM_SPREADER, 0), f.h,
                 (l.m_spreader > 0 ? 1e-9 : 1e-7) * size);
        below(unbalanced(&s, &h), 1e-11);
        if (f.h < 0)
            assert_true(h.least < 0);
    }
}

/* Slings that lean on long edges across the load hang as in the plane, at half of the force; Newton
 * and the way down end at the same place. */
static void edges_in_space(void **state)
{
    struct linkage l = inclined;
    double b = l.v * tan(l.phi) + l.s * tan(l.gamma);
    struct gear flat, s;
    struct hang plane, near, down;
    struct tandem t;
    (void)state;

    l.edges = 1;
    l.half[0] = b - 0.05;
    l.height[0] = 2;
    l.offset = 0.1;
    flat = suspended_linkage(&l);
    plane = hung(&flat, HANG_DOWN);
    assert_int_equal(plane.contacts[LINKAGE_SECOND_RIGHT], 1);
    assert_int_equal(plane.contacts[LINKAGE_SECOND_LEFT], 0);
    t = doubled(&l);
    s = suspended_tandem(&t);
    for (int k = 4; k < 8; k++) {
        double side = k % 2 ? 1 : -1;
        double corner[1][3] = {{side * l.half[0], 0, -l.v - l.s + l.height[0]}};

        assert_int_equal(gear_add_edges(&s, k, TANDEM_LOAD, (double[3]){0, 1, 0},
                                        (double[3]){side, 0, 0}, 1, (const double(*)[3])corner),
                         SW_OK);
    }
    near = hung(&s, HANG_NEAR);
    down = hung(&s, HANG_DOWN);
    below(unbalanced(&s, &near), 1e-12);
    near_rel(pose_tilted(near.pose), pose_tilted(plane.pose), 1e-11);
    near_rel(pose_tilted(near.pose + 1), pose_tilted(plane.pose + 1), 1e-11);
    near_rel(pose_tilted(down.pose), pose_tilted(plane.pose), 1e-11);
    for (int k = 0; k < 8; k++) {
        near_rel(2 * near.force[k], plane.force[k % 2 + (k < 4 ? 0 : 2)], 1e-11);
        near_rel(down.force[k], near.force[k], 1e-10);
        assert_int_equal(near.contacts[k], k >= 4 && k % 2 == 1);
    }
}

static void refusals(void **state)
{
    struct tandem good = reactor, bad;
    struct gear s;
    (void)state;

    assert_null(tandem_refused(&good));
#define REFUSED(field, value)                                                                      \
    bad = good;                                                                                    \
    bad.field = (value);                                                                           \
    assert_non_null(tandem_refused(&bad));                                                         \
    assert_int_equal(tandem_gear(&bad, &s), SW_ADMISSIBLE)
    REFUSED(hooks, 3);
    REFUSED(hook[0][1], good.hook[1][1]);
    REFUSED(slings, 3);
    REFUSED(slings, 4); /* no base crosswise */
    REFUSED(v, NAN);
    REFUSED(base_half, 0);
    REFUSED(spreaders, 1); /* without measures */
    REFUSED(m_load, 0);
    REFUSED(m_spreader, NAN);
    REFUSED(z, NAN);
    REFUSED(offset[1], INFINITY);
    REFUSED(stretch_primary, -0.1);
#undef REFUSED
}

TEST_MAIN(cmocka_unit_test(case_1_2_5), cmocka_unit_test(elastic_formulas),
          cmocka_unit_test(pendulum), cmocka_unit_test(pendulum_of_a_box),
          cmocka_unit_test(box_under_two_hooks), cmocka_unit_test(double_pendulum),
          cmocka_unit_test(ring_without_mass), cmocka_unit_test(four_share),
          cmocka_unit_test(full_room), cmocka_unit_test(three_carry), cmocka_unit_test(words),
          cmocka_unit_test(as_in_the_plane), cmocka_unit_test(edges_in_space),
          cmocka_unit_test(refusals))
