/* Irvine's theory: its limits, its crossovers, its equation, and the finite element model where the
 * sag is small. */
#include "check.h"

#include "phys/irvine.h"
#include "phys/modes.h"

/* lambda2 to 0: odd multiples of pi, at first order plus 4 lambda2/y^3 with y = (2 k - 1) pi. */
static void string_limit(void **state)
{
    (void)state;
    for (int k = 1; k <= 5; k++) {
        double y = (2 * k - 1) * PI;

        near_rel(irvine_symmetric_root(0, k), y, 1e-15);
        near_rel(irvine_symmetric_root(1e-300, k), y, 1e-15);
        /* the next term is of the order of lambda2^2/y^5 */
        near_abs(irvine_symmetric_root(1e-4, k) - y, 4 * 1e-4 / (y * y * y), 1e-10);
    }
}

/* lambda2 to infinity: tan(x/2) = x/2, of which 4.4934... and so on are the roots. */
static void inextensible_limit(void **state)
{
    static const double tangent[] = {4.493409457909064, 7.725251836937707, 10.904121659428899};
    (void)state;

    near_rel(irvine_symmetric_root(1e12, 1) / PI, 2.8605933, 2e-8); /* theory, section 8 */
    for (int k = 1; k <= 3; k++)
        near_rel(irvine_symmetric_root(1e18, k), 2 * tangent[k - 1], 1e-14);
}

/* lambda2 = (2 n pi)^2: symmetric root n is that of the antisymmetric mode n. */
static void crossovers(void **state)
{
    (void)state;
    for (int n = 1; n <= 8; n++) {
        double x = 2 * n * PI;

        near_rel(irvine_symmetric_root(x * x, n), x, 1e-15);
        assert_true(irvine_symmetric_root(x * x * 0.999, n) < x);
        assert_true(irvine_symmetric_root(x * x * 1.001, n) > x);
    }
}

/* The root put back into the pole-free equation; each in its interval, growing with lambda2. */
static void roots_of_the_equation(void **state)
{
    (void)state;
    for (int k = 1; k <= 6; k++) {
        double before = 0;

        for (double lambda2 = 1e-8; lambda2 < 1e10; lambda2 *= 3) {
            double x = irvine_symmetric_root(lambda2, k), y = x / 2;
            double cubic = 4 / lambda2 * y * y * y;

            assert_true(x > (2 * k - 1) * PI - 1e-14 * x && x < (2 * k + 1) * PI);
            assert_true(x >= before);
            before = x;
            /* round-off of y, times the slope of the equation */
            near_abs(sin(y) - (y - cubic) * cos(y), 0, 1e-14 * y * (1 + y + cubic));
        }
    }
}

/* Level, inclined, and with more tension: each closed frequency against the model of 40 elements.
 * What the theory leaves out is of the order of (weight/tension)^2 and of the strain. */
static void against_the_model(void **state)
{
    const struct cable inclined = {120.2, 3, 3e7, 9.81, 100, 67};
    const struct {
        const struct cable *cable;
        double tolerance;
    } row[] = {{&pont, 3e-3}, {&seil1, 3e-3}, {&seil2, 3e-3}, {&inclined, 3e-3}};
    (void)state;

    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct model m;
        struct line s;
        struct modes p;
        double in[3] = {0}, closed[3];
        int n = 0;

        assert_int_equal(line_solve(row[i].cable, &s), SW_OK);
        assert_int_equal(model_new(row[i].cable, LAW_HOOKE, 40, &m), SW_OK);
        for (int k = 1; k <= 3; k++) {
            double omega = NAN;

            assert_int_equal(modes_of_part(&m, PART_LATERAL, k, &omega), SW_OK);
            near_rel(irvine_lateral(&s, k), omega, row[i].tolerance);
        }
        closed[0] = irvine_symmetric(&s, 1);
        closed[1] = irvine_antisymmetric(&s, 1);
        closed[2] = irvine_symmetric(&s, 2);
        assert_int_equal(modes_lowest(&m, 12, SOLVER_AUTO, &p), SW_OK);
        for (int k = 0; k < p.k && n < 3; k++)
            if (p.plane[k] == PART_PLANE)
                in[n++] = p.omega[k];
        assert_int_equal(n, 3);
        for (int k = 0; k < 3; k++) {
            double nearest = INFINITY;

            for (int j = 0; j < 3; j++)
                nearest = fmin(nearest, fabs(closed[k] / in[j] - 1));
            below(nearest, row[i].tolerance);
        }
        modes_free(&p);
        model_free(&m);
    }
}

/* A stretched string without gravity is what the theory is exact for: omega = k pi/d sqrt(T/m). */
static void without_gravity(void **state)
{
    const struct cable c = {100, 2, 1e6, 0, 80, 60.5};
    double d = hypot(c.span, c.drop), T = c.EA * (d / c.L0 - 1);
    double unit = PI / d * sqrt(T / (c.mu * c.L0 / d));
    struct line s;
    (void)state;

    assert_int_equal(line_solve(&c, &s), SW_OK);
    for (int k = 1; k <= 4; k++) {
        near_rel(irvine_lateral(&s, k), k * unit, 1e-12);
        near_rel(irvine_antisymmetric(&s, k), 2 * k * unit, 1e-12);
        near_rel(irvine_symmetric(&s, k), (2 * k - 1) * unit, 1e-12);
    }
}

TEST_MAIN(cmocka_unit_test(string_limit), cmocka_unit_test(inextensible_limit),
          cmocka_unit_test(crossovers), cmocka_unit_test(roots_of_the_equation),
          cmocka_unit_test(against_the_model), cmocka_unit_test(without_gravity))
