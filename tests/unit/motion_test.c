/* Support motions: derivatives by differences, ramp, sums. */
#include "check.h"
#include "phys/motion.h"

static const struct motion two[] = {
    {SUPPORT_RIGHT, {0.05, -0.02, 0.01}, 7.8, {0, 0.3, -1}, 0, NULL, NULL},
    {SUPPORT_LEFT, {0.01, 0.03, 0}, 2.5, {1, 0, 0}, 4, NULL, NULL},
};

static void derivatives_by_differences(void **state)
{
    const double at[] = {-0.5, 0.2, 1.7, 3.9, 4.1, 100};
    (void)state;

    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        double u[3][6], v[3][6], a[6] = {0}, d = 1e-5;

        for (int i = 0; i < 3; i++)
            motion_sum(two, 2, at[k] + (i - 1) * d, u[i], v[i], i == 1 ? a : NULL);
        for (int i = 0; i < 6; i++) { /* d^2/6 of the third derivative; round-off 1e-16/d */
            near_abs((u[2][i] - u[0][i]) / (2 * d), v[1][i], 1e-8);
            near_abs((v[2][i] - v[0][i]) / (2 * d), a[i], 1e-7);
        }
    }
}

static void closed_values(void **state)
{
    double u[6], v[6], a[6];
    (void)state;

    motion_sum(two, 2, 0, u, v, a); /* ramped: nothing moves yet */
    for (int i = 0; i < 3; i++)
        assert_true(u[i] == 0 && v[i] == 0 && a[i] == 0);
    near_abs(u[3], 0.05, 0);
    near_abs(u[4], -0.02 * cos(0.3), 1e-17);
    motion_sum(two, 2, 2, u, NULL, NULL); /* half of the ramp */
    near_abs(u[0], 0.01 * cos(6) / 2, 1e-16);
    motion_sum(two, 2, 10, u, NULL, NULL);
    near_abs(u[1], 0.03 * cos(25), 1e-16);
    motion_sum(two, 0, 10, u, v, a);
    for (int i = 0; i < 6; i++)
        assert_true(u[i] == 0 && v[i] == 0 && a[i] == 0);
}

TEST_MAIN(cmocka_unit_test(derivatives_by_differences), cmocka_unit_test(closed_values))
