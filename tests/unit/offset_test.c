/* Equilibria that the upright one turns into while the centre of gravity moves. */
#include "rig.h"

#include "phys/offset.h"

/* By primary slings alone, z > 0: tan(tilt) = e/h, until one sling hangs plumb and the load turns
 * over: e = h tan(phi). */
static void closed_form(void **state)
{
    const struct linkage l = {.v = 5, .z = 2, .phi = 20 * DEGREES, .m_load = 1000, .g = 9.81};
    const double h = l.v - l.z, most = h * tan(l.phi);
    (void)state;

    for (int side = -1; side <= 1; side += 2)
        for (double e = 0.1; e < 2; e += 0.1) {
            struct gear s = suspended_linkage(&l);
            struct hang is = hung(&s, HANG_NEAR);
            double share;
            enum status status =
                offset_shift(&s, LINKAGE_LOAD, (double[3]){side * e, 0, 0}, &is, &share);

            assert_int_equal(status, e < most ? SW_OK : SW_INFEASIBLE);
            near_rel(share, fmin(1, most / e), 1e-8);
            near_abs(s.body[LINKAGE_LOAD].cg[0], side * e * share, 1e-12);
            near_rel(pose_tilted(is.pose), side * atan(fmin(e, most) / h), 1e-8);
            below(unbalanced(&s, &is), 1e-10);
        }
}

/* The same place as drawn with the offset, where that is found at once; never a jump elsewhere. */
static void continues(void **state)
{
    uint64_t seed = 40;
    (void)state;

    for (int i = 0; i < 300; i++) {
        struct linkage l = random_linkage(&seed);
        struct formula f = formula_of(&l);
        double tilt = uniform_in(&seed, 0.001, 0.05), share;
        struct gear s, drawn;
        struct hang h, other;

        if (!(f.h > 0.05 * l.v))
            continue;
        s = suspended_linkage(&l);
        h = hung(&s, HANG_NEAR);
        l.offset = f.h * tilt / fmax(f.r, 1);
        if (offset_shift(&s, LINKAGE_LOAD, (double[3]){l.offset, 0, 0}, &h, &share) != SW_OK)
            continue;
        near_rel(pose_tilted(h.pose + LINKAGE_SPREADER), l.offset / f.h, 0.3);
        drawn = suspended_linkage(&l);
        other = hung(&drawn, HANG_NEAR);
        near_abs(pose_tilted(h.pose), pose_tilted(other.pose), 1e-9);
        for (int k = 0; k < 4; k++)
            near_abs(h.force[k], other.force[k], 1e-8 * l.m_load * 9.81);
    }
}

static void in_space(void **state)
{
    struct tandem t = {.hooks = 1,
                       .slings = 4,
                       .v = 6,
                       .z = -1,
                       .base_half = 3,
                       .base_cross = 2,
                       .m_load = 1000,
                       .g = 9.81,
                       .stretch_primary = 0.01};
    struct gear s = suspended_tandem(&t), drawn;
    struct hang h = hung(&s, HANG_NEAR), other;
    double share;
    (void)state;

    assert_int_equal(offset_shift(&s, 0, (double[3]){0.5, 0.3, 0}, &h, &share), SW_OK);
    t.offset[0] = 0.5;
    t.offset[1] = 0.3;
    drawn = suspended_tandem(&t);
    other = hung(&drawn, HANG_DOWN);
    for (int k = 0; k < 4; k++)
        near_rel(h.force[k], other.force[k], 1e-3); /* stiffness is that of the other middle */
    below(unbalanced(&s, &h), 1e-10);
    assert_int_equal(offset_shift(&s, 1, (double[3]){0}, &h, &share), SW_ADMISSIBLE);
    assert_int_equal(offset_shift(&s, 0, (double[3]){NAN, 0, 0}, &h, &share), SW_ADMISSIBLE);
}

TEST_MAIN(cmocka_unit_test(closed_form), cmocka_unit_test(continues), cmocka_unit_test(in_space))
