/* Bed, current and drag: closed forms and differences. */
#include "check.h"
#include "phys/sea.h"

static void beds(void **state)
{
    const double x[3] = {0, 10, 30}, y[2] = {-5, 5};
    const double z[6] = {-10, -9, -7, -12, -11, -9}; /* -11 - 0.2 y + 0.1 x, at y = -5 and 5 */
    const struct bed plane = {.kind = BED_PLANE, .level = -11, .slope = {0.1, -0.2}},
                     grid = {.kind = BED_GRID, .nx = 3, .ny = 2, .x = x, .y = y, .z = z},
                     none = {.kind = BED_NONE};
    double g[2], h[2];
    (void)state;

    for (double px = 0.5; px < 30; px += 3)
        for (double py = -4.5; py < 5; py += 1.5) {
            near_abs(bed_at(&grid, px, py, g), bed_at(&plane, px, py, h), 1e-13);
            near_abs(g[0], 0.1, 1e-13);
            near_abs(g[1], -0.2, 1e-13);
            near_abs(h[0], 0.1, 0);
            near_abs(h[1], -0.2, 0);
        }
    near_abs(bed_at(&grid, 100, 100, g), -9, 0); /* beyond: as at the corner, level */
    near_abs(g[0], 0, 0);
    near_abs(g[1], 0, 0);
    near_abs(bed_at(&grid, 5, 100, g), -11.5, 1e-13);
    near_abs(g[0], 0.1, 1e-13);
    assert_true(bed_at(&none, 0, 0, g) == -INFINITY);
}

static void currents(void **state)
{
    const double z[3] = {-50, -20, 0}, u[3] = {0, 1, 2}, v[3] = {0, 0, 1};
    const double at[1] = {-50}, one[1] = {1}; /* nothing behind them may be read */
    const struct current c = {3, z, u, v}, uniform_one = {1, at, one, one}, two = {2, z, u, v},
                         none = {0, z, u, v};
    double U[3], slope[3];
    (void)state;

    current_at(&c, -35, U, slope);
    near_abs(U[0], 0.5, 1e-15);
    near_abs(slope[0], 1.0 / 30, 1e-15);
    current_at(&c, -10, U, slope);
    near_abs(U[0], 1.5, 1e-15);
    near_abs(U[1], 0.5, 1e-15);
    near_abs(slope[1], 0.05, 1e-15);
    current_at(&c, 7, U, slope); /* beyond: as at the end */
    near_abs(U[0], 2, 0);
    near_abs(slope[0], 0, 0);
    current_at(&uniform_one, -500, U, slope);
    near_abs(U[0], 1, 0);
    near_abs(slope[0], 0, 0);
    current_at(&two, -35, U, slope);
    near_abs(U[0], 0.5, 1e-15);
    near_abs(slope[0], 1.0 / 30, 1e-15);
    current_at(&none, -5, U, slope);
    near_abs(U[0] + U[1] + U[2], 0, 0);
}

/* Across and along by the angle; the derivatives by differences. */
static void drags(void **state)
{
    uint64_t seed = 3;
    double f[3], by_c[9], by_U[9], worst = 0;
    const double level[3] = {1, 0, 0}, slanted[3] = {0.6, 0, 0.8};
    (void)state;

    sea_drag(3, 5, 2, level, (const double[]){0, 2, 0}, f);
    near_abs(f[1], 3 * 4 * 2, 1e-12);
    near_abs(f[0], 0, 0);
    sea_drag(3, 5, 2, level, (const double[]){-2, 0, 0}, f);
    near_abs(f[0], -5 * 4 * 2, 1e-12);
    sea_drag(3, 5, 1, slanted, (const double[]){1, 0, 0}, f); /* Ut = 0.6, Un = 0.8 */
    near_abs(f[0], 3 * 0.8 * 0.64 + 5 * 0.36 * 0.6, 1e-12);
    near_abs(f[2], -3 * 0.8 * 0.48 + 5 * 0.36 * 0.8, 1e-12);
    for (int k = 0; k < 2000; k++) {
        double c[3], U[3], l = 0;

        for (int i = 0; i < 3; i++) {
            c[i] = uniform_in(&seed, -1, 1);
            U[i] = uniform_in(&seed, -2, 2);
            l += c[i] * c[i];
        }
        for (int i = 0; i < 3; i++)
            c[i] /= sqrt(l);
        sea_drag_change(2, 1, 3, c, U, by_c, by_U);
        for (int j = 0; j < 3; j++) {
            const double h = 1e-6;
            double a[3], b[3], keep = U[j], turn[3], wanted;

            U[j] = keep + h;
            sea_drag(2, 1, 3, c, U, a);
            U[j] = keep - h;
            sea_drag(2, 1, 3, c, U, b);
            U[j] = keep;
            for (int i = 0; i < 3; i++)
                worst = fmax(worst, fabs((a[i] - b[i]) / (2 * h) - by_U[3 * i + j]));
            for (int i = 0; i < 3; i++) /* across c */
                turn[i] = (i == j) - c[i] * c[j];
            for (int side = -1; side <= 1; side += 2) {
                double d[3], size = 0;

                for (int i = 0; i < 3; i++) {
                    d[i] = c[i] + side * h * turn[i];
                    size += d[i] * d[i];
                }
                for (int i = 0; i < 3; i++)
                    d[i] /= sqrt(size);
                sea_drag(2, 1, 3, d, U, side < 0 ? b : a);
            }
            for (int i = 0; i < 3; i++) {
                wanted = 0;
                for (int q = 0; q < 3; q++)
                    wanted += by_c[3 * i + q] * turn[q];
                worst = fmax(worst, fabs((a[i] - b[i]) / (2 * h) - wanted));
            }
        }
    }
    below(worst, 1e-4); /* |Un| Un has a kink: curvature 1/|Un| near it */
}

TEST_MAIN(cmocka_unit_test(beds), cmocka_unit_test(currents), cmocka_unit_test(drags))
