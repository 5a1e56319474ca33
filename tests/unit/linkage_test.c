/* The planar linkage against the check formulas, in the limit and beyond it. */
#include "rig.h"

#include "num/root.h"
#include "phys/sway.h"

enum { MANY = 10000 };

/* Least eigenvalue of the upright linkage over z. */
static double least_of(double z, void *context)
{
    struct linkage l = *(const struct linkage *)context;
    struct gear s;
    struct hang h;

    l.z = z;
    s = suspended_linkage(&l);
    if (hang(&s, HANG_NEAR, NULL, -1, &h) != SW_OK)
        return NAN;
    return h.least;
}

/* The second derivative stops being positive definite at exactly h = 0. */
static void critical_height(void **state)
{
    uint64_t seed = 20;
    (void)state;

    for (int i = 0; i < MANY; i++) {
        struct linkage l = random_linkage(&seed);
        struct formula f = formula_of(&l);
        double size = l.v + l.s, a = f.z_critical - 0.3 * size, b = f.z_critical + 0.4 * size;
        double fa = least_of(a, &l), fb = least_of(b, &l);

        assert_true(f.r > 0);
        assert_true(fa > 0 && fb < 0);
        near_abs(root_between(least_of, &l, a, fa, b, fb), f.z_critical,
                 1e-6 * fabs(f.z_critical) + 1e-12 * size);
    }
}

/* Offset over tilt of the spreader is h, over tilt of the load h/r; stable exactly where h > 0. */
static void heights(void **state)
{
    uint64_t seed = 21;
    (void)state;

    for (int i = 0; i < MANY; i++) {
        struct linkage l = random_linkage(&seed);
        struct formula f = formula_of(&l);
        struct gear s = suspended_linkage(&l);
        struct hang h = hung(&s, HANG_NEAR);
        double size = fabs(f.c * l.s) + l.v + l.s + fabs(l.z) * f.r;
        double slack = l.m_spreader > 0 ? 1e-9 : 1e-7; /* without mass it has 1e-8 of the load's */
        struct sway m;

        assert_int_equal(sway_of(&s, &h, &m), SW_OK);
        assert_int_equal(h.least > 0, f.h > 0);
        assert_int_equal(m.omega2[0] > 0, f.h > 0);
        near_abs(sway_height(&s, &m, LINKAGE_LOAD, LINKAGE_SPREADER, 0), f.h, slack * size);
        near_abs(sway_height(&s, &m, LINKAGE_LOAD, LINKAGE_LOAD, 0) * f.r, f.h, slack * size);
        below(unbalanced(&s, &h), 1e-12);
    }
}

/* Offset over tilt of a body at a finite tilt about small. */
static double finite_height(const struct linkage *upright, int body, double tilt)
{
    struct formula f = formula_of(upright);
    struct linkage l = *upright;
    struct gear s;
    struct hang h;

    l.offset = f.h * tilt / fmax(1, f.r);
    s = suspended_linkage(&l);
    h = hung(&s, HANG_NEAR);
    below(unbalanced(&s, &h), 1e-10);
    return l.offset / pose_tilted(h.pose + body);
}

/* It differs from the formula by the square of the tilt: half of the tilt, a quarter of it. */
static void second_order(void **state)
{
    uint64_t seed = 22;
    (void)state;

    for (int i = 0; i < 200; i++) {
        struct linkage l = i == 0 ? inclined : random_linkage(&seed);
        struct formula f = formula_of(&l);

        if (!(f.h > 0.05 * l.v && l.v * tan(l.phi) + l.s * tan(l.gamma) > 0.2 * (l.v + l.s)))
            continue;
        for (int body = 0; body < 2; body++) {
            double h = body == LINKAGE_LOAD ? f.h / f.r : f.h;
            double far = finite_height(&l, body, 8e-3) / h - 1;
            double near = finite_height(&l, body, 4e-3) / h - 1;

            below(fabs(far), 0.1);
            if (fabs(far) > 1e-6) /* where the square's factor is not about zero */
                near_abs(log2(far / near), 2, 0.1);
        }
    }
}

/* Published: c = 1.14256, h = 1.0 m; gamma = -6 degrees is unstable; the sheet's h = 0.809 m. */
static void published(void **state)
{
    struct linkage l = inclined;
    struct gear s = suspended_linkage(&l);
    struct hang h = hung(&s, HANG_NEAR);
    struct sway m;
    (void)state;

    assert_int_equal(sway_of(&s, &h, &m), SW_OK);
    near_abs(sway_height(&s, &m, LINKAGE_LOAD, LINKAGE_SPREADER, 0), 1.0, 0.05);
    l.gamma = -6 * DEGREES;
    s = suspended_linkage(&l);
    h = hung(&s, HANG_NEAR);
    assert_true(h.least < 0);
    l = (struct linkage){.v = 4.56,
                         .s = 8.46,
                         .z = 2.66,
                         .phi = 42 * DEGREES,
                         .gamma = -7 * DEGREES,
                         .m_spreader = 18e3,
                         .m_load = 64e3,
                         .g = 9.81};
    s = suspended_linkage(&l);
    h = hung(&s, HANG_NEAR);
    assert_int_equal(sway_of(&s, &h, &m), SW_OK);
    near_abs(sway_height(&s, &m, LINKAGE_LOAD, LINKAGE_SPREADER, 0), 0.809, 0.0005);
}

/* Left and right the same: no tilt, equal forces; an offset to the other side mirrors everything.
 */
static void symmetry(void **state)
{
    struct linkage l = inclined;
    struct gear s = suspended_linkage(&l);
    struct hang h = hung(&s, HANG_DOWN), other;
    (void)state;

    for (int b = 0; b < 2; b++)
        near_abs(pose_tilted(h.pose + b), 0, 1e-14);
    near_rel(h.force[LINKAGE_LEFT], h.force[LINKAGE_RIGHT], 1e-13);
    near_rel(h.force[LINKAGE_LEFT], 62e3 * 9.81 / (2 * cos(l.phi)), 1e-13);
    near_rel(h.force[LINKAGE_SECOND_LEFT], 60e3 * 9.81 / (2 * cos(l.gamma)), 1e-13);
    l.offset = 0.1;
    s = suspended_linkage(&l);
    h = hung(&s, HANG_DOWN);
    l.offset = -0.1;
    s = suspended_linkage(&l);
    other = hung(&s, HANG_DOWN);
    assert_true(pose_tilted(h.pose) > 0.1);
    for (int b = 0; b < 2; b++) {
        near_abs(pose_tilted(h.pose + b), -pose_tilted(other.pose + b), 1e-13);
        near_rel(h.pose[b].r[2], other.pose[b].r[2], 1e-13);
    }
    for (int k = 0; k < 4; k++)
        near_rel(h.force[k], other.force[k ^ 1], 1e-12);
}

/* Elastic slings are as long as they need be to hold the place as drawn, and softer than rigid
 * ones: the primary ones alone have h = v (1 - eps)/(1 + 4 v^2 eps/b^2) - z in the plane as well.
 */
static void elastic(void **state)
{
    uint64_t seed = 23;
    (void)state;

    for (int i = 0; i < 200; i++) {
        struct linkage l = random_linkage(&seed);
        double eps = log_uniform(&seed, 1e-3, 0.05), b = 2 * l.v * tan(l.phi);
        struct gear s;
        struct hang h;
        struct sway m;

        l.stretch_primary = eps;
        l.stretch_secondary = log_uniform(&seed, 1e-3, 0.05);
        s = suspended_linkage(&l);
        h = hung(&s, HANG_NEAR);
        below(unbalanced(&s, &h), 1e-12);
        near_rel(h.pose[LINKAGE_LOAD].r[2], l.z - l.v - l.s, 1e-9);
        near_rel(h.force[LINKAGE_LEFT], (l.m_load + l.m_spreader) * l.g / (2 * cos(l.phi)), 1e-7);
        near_rel(h.force[LINKAGE_SECOND_LEFT], l.m_load * l.g / (2 * cos(l.gamma)), 1e-9);
        near_rel(1 - s.sling[LINKAGE_LEFT].length / h.length[LINKAGE_LEFT], eps, 1e-6);
        l.s = 0;
        s = suspended_linkage(&l);
        h = hung(&s, HANG_NEAR);
        assert_int_equal(sway_of(&s, &h, &m), SW_OK);
        near_abs(sway_height(&s, &m, LINKAGE_LOAD, LINKAGE_LOAD, 0),
                 l.v * (1 - eps) / (1 + 4 * l.v * l.v * eps / (b * b)) - l.z,
                 1e-9 * (l.v + fabs(l.z)));
    }
}

/* Slings round the edges of both sides: as long as their ways, less what they give. */
static void round_edges(void **state)
{
    struct linkage l = leaning(0.5, -0.05);
    (void)state;

    l.stretch_primary = 0.01;
    l.stretch_secondary = 0.02;
    {
        struct gear s = suspended_linkage(&l);
        struct pose pose[GEAR_BODIES];
        struct path p;

        gear_drawn(&s, pose);
        for (int k = 0; k < 4; k++) {
            int second = k == LINKAGE_SECOND_LEFT || k == LINKAGE_SECOND_RIGHT;

            path_lay(&s, pose, k, &p);
            assert_int_equal(p.n, second ? 3 : 2);
            near_rel(s.sling[k].length, p.length * (second ? 0.98 : 0.99), 1e-14);
        }
    }
}

static void refusals(void **state)
{
    struct linkage good = inclined, bad;
    struct gear s;
    (void)state;

    assert_null(linkage_refused(&good));
#define REFUSED(field, value)                                                                      \
    bad = good;                                                                                    \
    bad.field = (value);                                                                           \
    assert_non_null(linkage_refused(&bad));                                                        \
    assert_int_equal(linkage_gear(&bad, &s), SW_ADMISSIBLE)
    REFUSED(v, 0);
    REFUSED(v, NAN);
    REFUSED(s, -1);
    REFUSED(z, NAN);
    REFUSED(offset, INFINITY);
    REFUSED(phi, 0);
    REFUSED(phi, 90.0001 * DEGREES);
    REFUSED(gamma, 95 * DEGREES);
    REFUSED(gamma, -20 * DEGREES); /* lifting points would change sides */
    REFUSED(m_load, 0);
    REFUSED(m_spreader, -1);
    REFUSED(g, NAN);
    REFUSED(stretch_primary, 1);
    REFUSED(stretch_secondary, NAN);
    REFUSED(edges, 5);
#undef REFUSED
}

TEST_MAIN(cmocka_unit_test(critical_height), cmocka_unit_test(heights),
          cmocka_unit_test(second_order), cmocka_unit_test(published), cmocka_unit_test(symmetry),
          cmocka_unit_test(elastic), cmocka_unit_test(round_edges), cmocka_unit_test(refusals))
