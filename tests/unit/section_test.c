/* Cross sections: measures by name, torsion constants, coupled stiffness, stresses. */
#include "check.h"

#include "phys/section.h"

/* Torsion of rectangles: the textbook's factors (Timoshenko and Goodier, table for a/b). */
static void rectangles(void **state)
{
    const double ratio[6] = {1, 1.5, 2, 3, 5, 10};
    const double It[6] = {0.1406, 0.196, 0.229, 0.263, 0.291, 0.312};
    const double Wt[6] = {0.208, 0.231, 0.246, 0.267, 0.291, 0.312};
    double W;

    (void)state;
    for (int k = 0; k < 6; k++) {
        near_abs(section_rectangle_torsion(2 * ratio[k], 2, &W) / (16 * ratio[k]), It[k], 6e-4);
        near_abs(W / (8 * ratio[k]), Wt[k], 6e-4);
        near_rel(section_rectangle_torsion(2, 2 * ratio[k], NULL),
                 section_rectangle_torsion(2 * ratio[k], 2, NULL), 1e-15);
    }
    near_abs(section_rectangle_torsion(1, 1, NULL), 0.140577014955, 1e-11); /* square, ten digits */
    near_rel(section_rectangle_torsion(1e4, 1, NULL), 1e4 / 3.0 - 0.21, 1e-6); /* thin: a b^3/3 */
}

static void shapes(void **state)
{
    struct section round = {.shape = SECTION_ROUND, .E = 2, .G = 3, .diameter = 0.2};
    struct section tube = {.shape = SECTION_TUBE, .E = 2, .G = 3, .diameter = 0.2, .wall = 0.1};
    struct section strip = {
        .shape = SECTION_RECTANGLE, .E = 2, .G = 3, .width = 0.3, .height = 0.1};

    (void)state;
    assert_int_equal(section_complete(&round, 5), SW_OK);
    near_rel(round.stiffness[0], 2 * PI * 0.01, 1e-15);
    near_rel(round.Ixx, PI * 1e-4 / 4, 1e-15);
    near_rel(round.It, 2 * round.Ixx, 1e-15);
    near_rel(round.mass, 5 * PI * 0.01, 1e-15);
    near_rel(round.inertia[2], 5 * round.It, 1e-15);
    near_rel(round.flexibility[10], 1 / (2 * round.Iyy), 1e-14);
    assert_int_equal(section_complete(&tube, 5), SW_OK); /* a full one */
    near_rel(tube.area, round.area, 1e-15);
    near_rel(tube.Ixx, round.Ixx, 1e-15);
    tube.wall = 0.01;
    assert_int_equal(section_complete(&tube, 5), SW_OK);
    near_rel(tube.area, PI * 0.19 * 0.01, 1e-14);
    near_rel(tube.It, PI / 32 * (pow(0.2, 4) - pow(0.18, 4)), 1e-13);
    assert_int_equal(section_complete(&strip, 5), SW_OK);
    near_rel(strip.Ixx, 0.3 * 1e-3 / 12, 1e-15); /* bending about x: the low way */
    near_rel(strip.Iyy, 0.1 * 0.027 / 12, 1e-15);
}

/* H is the inverse of the whole coupled stiffness; one that is not definite is refused. */
static void coupled(void **state)
{
    struct section s = {.shape = SECTION_GENERAL,
                        .stiffness = {1e7, 30, -2, 900, 30, 3, 0.5, 0.1, -2, 0.5, 2, -0.3, 900, 0.1,
                                      -0.3, 1}};

    (void)state;
    assert_int_equal(section_complete(&s, 0), SW_OK);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            double sum = 0;

            for (int k = 0; k < 4; k++)
                sum += s.stiffness[i + 4 * k] * s.flexibility[k + 4 * j];
            near_abs(sum, i == j, 1e-11 * (i == 0 && j > 0 ? 1e4 : 1)); /* N by curvature: units */
        }
    s.stiffness[12] = s.stiffness[3] = 4000; /* 4000^2 > 1e7 */
    assert_int_equal(section_complete(&s, 0), SW_INDEFINITE);
    s.stiffness[0] = NAN;
    assert_int_equal(section_complete(&s, 0), SW_INDEFINITE);
}

static void stresses(void **state)
{
    struct section round = {.shape = SECTION_ROUND, .E = 2, .G = 3, .diameter = 0.2};
    struct section strip = {
        .shape = SECTION_RECTANGLE, .E = 2, .G = 3, .width = 0.3, .height = 0.1};
    const double force[4] = {-7, 3, 4, 5};
    struct section_stress t;

    (void)state;
    assert_int_equal(section_complete(&round, 0), SW_OK);
    t = section_stresses(&round, force);
    near_rel(t.axial, -7 / (PI * 0.01), 1e-14);
    near_rel(t.bending, 5 / (PI / 32 * 8e-3), 1e-14);
    near_rel(t.shear, 5 / (PI / 16 * 8e-3), 1e-14);
    near_rel(t.most, t.bending - t.axial, 1e-14);
    near_rel(t.mises, sqrt(t.most * t.most + 3 * t.shear * t.shear), 1e-14);
    assert_int_equal(section_complete(&strip, 0), SW_OK);
    t = section_stresses(&strip, force);
    near_rel(t.bending, 3 * 0.05 / strip.Ixx + 4 * 0.15 / strip.Iyy, 1e-14); /* in a corner */
    near_rel(t.shear, 5 / (0.267 * 0.3 * 0.01), 2e-3);                       /* a/b = 3 */
}

TEST_MAIN(cmocka_unit_test(rectangles), cmocka_unit_test(shapes), cmocka_unit_test(coupled),
          cmocka_unit_test(stresses))
