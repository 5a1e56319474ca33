/* Bolotin's boundaries: Mathieu's characteristic values, damped thresholds, the taut string, the
 * worked numbers of SEIL2. */
#include "num/dense.h"
#include "num/mem.h"
#include "num/root.h"
#include "rope.h"

#define ROOM 400
#define TERMS 40

/* The classes of Mathieu's characteristic values: a and b, even and odd orders. */
enum { A_EVEN, B_EVEN, A_ODD, B_ODD };

/* Characteristic value number k, from 0, of a class, of y'' + (a - 2 q cos 2 t) y = 0. */
static double mathieu(int class, int k, double q)
{
    double *A = mem_doubles(TERMS * TERMS), value[TERMS], shift = class == B_EVEN ? 2 : 0;

    for (int i = 0; i < TERMS; i++) {
        double order = 2 * i + (class >= A_ODD ? 1 : shift);

        A[i + TERMS * i] = order * order;
        if (i > 0)
            A[i + TERMS * (i - 1)] = q * (class == A_EVEN && i == 1 ? sqrt(2) : 1);
    }
    if (class == A_ODD)
        A[0] += q;
    if (class == B_ODD)
        A[0] -= q;
    assert_int_equal(dense_symmetric(TERMS, A, value), SW_OK);
    free(A);
    return value[k];
}

/* The values themselves against Abramowitz and Stegun, table 20.1, and their series. */
static void characteristic_values(void **state)
{
    (void)state;

    near_abs(mathieu(A_EVEN, 0, 1), -0.4551386041, 6e-11);
    near_abs(mathieu(A_ODD, 0, 1), 1.8591080725, 6e-11);
    near_abs(mathieu(B_ODD, 0, 1), -0.1102488170, 6e-11);
    near_abs(mathieu(A_EVEN, 1, 1), 4.3713009827, 6e-11);
    near_abs(mathieu(B_EVEN, 0, 1), 3.9170247730, 6e-11);
    near_abs(mathieu(A_EVEN, 1, 1e-3), 4 + 5e-6 / 12, 1e-12);
}

struct curve {
    int class, k;
    double a;
};

static double over(double q, void *context)
{
    struct curve *c = context;

    return mathieu(c->class, c->k, q) - c->a;
}

/* One mode of frequency 3 with a psi of 7. */
static struct parametric *one_mode(double zeta, struct hand *h)
{
    struct parametric *p = hand_begin(1, h);

    p->omega[0] = 3;
    p->c[0] = 2 * zeta * 3;
    p->psi_c[0] = 7;
    return p;
}

/* Without damping, all boundaries up to q = 5 are those where a characteristic value is a, and no
 * more. */
static void curves_of_mathieu(void **state)
{
    struct hand h;
    struct parametric *p = one_mode(0, &h);
    struct boundary found[ROOM];
    double worst = 0;
    int total = 0;
    (void)state;

    for (double ratio = 0.213; ratio < 1.6; ratio += 0.0131) {
        double Omega = 6 * ratio, a = 1 / (ratio * ratio), scale = Omega * Omega / 14;

        for (int period = 1; period <= 2; period++) {
            int n, wanted = 0;

            assert_int_equal(bolotin_solve(p, Omega, period, 33, 5 * scale, found, ROOM, &n),
                             SW_OK);
            for (int i = 0; i < 12; i++) {
                struct curve c = {(period == 2 ? A_ODD : A_EVEN) + i % 2, i / 2, a};
                double before = over(0, &c);

                for (double q = 0.1; q < 5.05; q += 0.1) {
                    double at = fmin(q, 5), now = over(at, &c), least = INFINITY, root;

                    if ((now > 0) != (before > 0)) {
                        root = root_between(over, &c, at - 0.1, over(at - 0.1, &c), at, now);
                        for (int k = 0; k < n; k++)
                            least = fmin(least, fabs(found[k].kappa / scale - root) / root);
                        below(least, 1e-9);
                        worst = fmax(worst, least);
                        wanted++;
                    }
                    before = now;
                }
            }
            assert_int_equal(n, wanted);
            total += n;
        }
    }
    print_message("# %d points on Mathieu's curves, q off by %.2g at the most\n", total, worst);
    assert_true(total > 100);
}

/* The nearest characteristic value of the orders of a tongue. */
static double distance(int j, double a, double q)
{
    int k = (j - 1) / 2;
    double first = mathieu(j % 2 ? A_ODD : A_EVEN, j % 2 ? k : j / 2, q) - a;
    double second = mathieu(j % 2 ? B_ODD : B_EVEN, k, q) - a;

    return fmin(fabs(first), fabs(second));
}

/* The tongues touch zero amplitude at Omega/(2 omega) = 1/j: beside the tip their lowest points
 * follow a_j or b_j to there, and at the tip itself they are no higher than round-off leads. */
static void tips(void **state)
{
    static const double side[] = {0, 1e-9, -1e-9, 1e-6, -1e-6, 1e-3, -1e-3};
    struct hand h;
    struct parametric *p = one_mode(0, &h);
    struct boundary found[ROOM];
    double worst = 0;
    (void)state;

    for (int j = 1; j <= 6; j++)
        for (int i = 0; i < 7; i++) {
            double ratio = (1 + side[i]) / j, Omega = 6 * ratio, a = 1 / (ratio * ratio), q;
            int n;

            assert_int_equal(bolotin_solve(p, Omega, 2 - (j + 1) % 2, 21, 1e9, found, ROOM, &n),
                             SW_OK);
            assert_true(n > 0);
            q = 14 * found[0].kappa / (Omega * Omega);
            if (side[i] >= 0 && j > 2) /* both boundaries of a tongue lie at larger a */
                continue;
            worst = fmax(worst, distance(j, a, q) / a);
            below(distance(j, a, q) / a, 1e-10);
            below(q, 20 * j * sqrt(fabs(side[i]) + 1e-15));
            assert_int_equal(found[0].order, j);
            assert_int_equal(found[0].mode, 0);
            assert_int_equal(found[0].partner, -1);
        }
    print_message("# tips: frequency squared off by %.2g at the most\n", worst);
}

/* Lowest kappa of one period over the frequency. */
struct tongue {
    const struct parametric *p;
    int period, order;
};

static double lowest(double Omega, void *context)
{
    struct tongue *t = context;
    struct boundary found[ROOM];
    int n;

    assert_int_equal(bolotin_solve(t->p, Omega, t->period, 21, 1e9, found, ROOM, &n), SW_OK);
    for (int i = 0; i < n; i++)
        if (found[i].order == t->order)
            return found[i].kappa;
    return INFINITY;
}

/* Threshold of region n of one damped mode, and where it lies. */
static double threshold(const struct parametric *p, int n, double eps, double *ret_Omega)
{
    double w = p->omega[0], q = eps * n * n / 2, least;
    double a = n == 1   ? 1
               : n == 2 ? 4 + q * q / 6
                        : n * n + q * q / (2 * (n * n - 1)); /* the middle of both boundaries */
    double Omega = 2 * w / sqrt(a), wide = 0.5 * fabs(Omega - 2 * w / n) + 0.01 * eps * Omega;
    struct tongue t = {p, 2 - (n + 1) % 2, n};

    *ret_Omega = least_between(lowest, &t, Omega - wide, Omega + wide, &least);
    return least;
}

static const double region_factor[5] = {0, 4, 8, 9216.0 / 729, 18};

/* eps_n = (c_n zeta)^(1/n) as zeta -> 0: what is left falls with eps. */
static void thresholds(void **state)
{
    (void)state;

    for (int n = 1; n <= 4; n++) {
        double before = INFINITY;

        for (int i = 0; i < 3; i++) {
            double zeta = pow(10, -3 - i), eps = pow(region_factor[n] * zeta, 1.0 / n), Omega, off;
            struct hand h;
            struct parametric *p = one_mode(zeta, &h);

            off = threshold(p, n, eps, &Omega) * 7 / 9 / eps - 1;
            print_message("# region %d, zeta %g: eps %.6g, off by %.3g\n", n, zeta, eps, off);
            below(fabs(off), eps * eps + 1e-8);
            assert_true(fabs(off) < before || fabs(off) < 1e-8);
            before = fabs(off);
        }
    }
}

/* Trace of the monodromy matrix of one mode by Runge-Kutta steps. */
static double trace(const struct parametric *p, double Omega, double kappa, int steps)
{
    double T = 2 * PI / Omega, h = T / steps, w = p->omega[0], sum = 0;

    for (int column = 0; column < 2; column++) {
        double y[2] = {column == 0, column == 1};

        for (int i = 0; i < steps; i++) {
            static const double part[4] = {0, 0.5, 0.5, 1}, share[4] = {1, 2, 2, 1};
            double k[2] = {0, 0}, all[2] = {0, 0};

            for (int stage = 0; stage < 4; stage++) {
                double t = (i + part[stage]) * h, x = y[0] + part[stage] * h * k[0];
                double v = y[1] + part[stage] * h * k[1];

                k[0] = v;
                k[1] = -p->c[0] * v - (w * w + kappa * p->psi_c[0] * cos(Omega * t)) * x;
                all[0] += share[stage] * k[0] / 6;
                all[1] += share[stage] * k[1] / 6;
            }
            y[0] += h * all[0];
            y[1] += h * all[1];
        }
        sum += y[column];
    }
    return sum;
}

struct runge {
    const struct parametric *p;
    double Omega;
    int sign;
};

/* Zero where a multiplier is sign. */
static double determinant(double kappa, void *context)
{
    struct runge *r = context;

    return 1 - r->sign * trace(r->p, r->Omega, kappa, 2000) + exp(-r->p->c[0] * 2 * PI / r->Omega);
}

/* The same thresholds at zeta = 0.01 by Runge-Kutta: a multiplier goes through 1 or -1 there, and
 * at frequencies beside it only at higher amplitudes. */
static void thresholds_by_integration(void **state)
{
    struct hand h;
    struct parametric *p = one_mode(0.01, &h);
    (void)state;

    for (int n = 1; n <= 4; n++) {
        double eps = pow(region_factor[n] * 0.01, 1.0 / n), Omega, here;
        double kappa = threshold(p, n, eps, &Omega);

        for (int side = -1; side <= 1; side++) {
            struct runge r = {p, Omega * (1 + side * 1e-3 * eps), n % 2 ? -1 : 1};
            double low = 0.99 * kappa, high = 1.03 * kappa, f = determinant(low, &r);

            assert_true(f > 0);
            if (determinant(high, &r) > 0) { /* outside */
                assert_true(side != 0);
                continue;
            }
            here = root_between(determinant, &r, low, f, high, determinant(high, &r));
            if (side == 0) {
                print_message("# region %d: eps %.9g, Runge-Kutta %.9g, first order %.4g\n", n,
                              kappa * 7 / 9, here * 7 / 9, eps);
                near_rel(kappa, here, 1e-8);
            } else {
                assert_true(here > kappa * (1 - 1e-8));
            }
        }
    }
}

/* A weightless taut string, 0.1 % stretched, whose end moves along the chord: the whole Psi. */
static void taut_string(void **state)
{
    static const struct cable string = {99.9, 10, 1e9, 0, 100, 0};
    double a = 100 / 99.9, H = 1e9 * (a - 1), L0 = 99.9, worst = 0;
    double T = H / a, eps1 = 1e9 * a * a / (H * L0);
    double sign[6], *V;
    struct rope r;
    (void)state;

    rope_begin(&string, LAW_THESIS, 40, 6, 0, 0, 0, &r);
    V = model_vector(&r.m);
    for (int i = 0; i < 6; i++) { /* of the mode at the left */
        modes_shape(&r.m, &r.p, i, V);
        sign[i] = V[6 + (r.p.plane[i] == PART_PLANE ? 2 : 4)] > 0 ? 1 : -1;
    }
    free(V);
    r.map.reference = PI / L0 * sqrt(T / 10);
    for (double ratio = 0.1; ratio < 8; ratio *= 1.7) {
        double Omega = 2 * ratio * r.map.reference;
        double k = Omega * L0 * sqrt(10 / (1e9 * a * a + T));
        struct parametric p;

        assert_int_equal(map_equations(&r.map, ratio, &p), SW_OK);
        for (int i = 0; i < 6; i++)
            for (int j = 0; j < 6; j++) {
                int n = i / 2 + 1, m = j / 2 + 1, both[2] = {abs(n - m), n + m};
                double size = eps1 * n * m * pow(r.map.reference, 2), wanted = 0;

                for (int l = 0; l < 2 && r.p.plane[i] == r.p.plane[j]; l++)
                    wanted += both[l] == 0 ? 1
                                           : sign[i] * sign[j] * (both[l] % 2 ? -1 : 1) * k * k /
                                                 (k * k - pow(both[l] * PI, 2));
                near_abs(p.psi_c[i + 6 * j] / size, wanted, 1e-6);
                near_abs(p.psi_s[i + 6 * j], 0, 0);
                worst = fmax(worst, fabs(p.psi_c[i + 6 * j] / size - wanted));
            }
        parametric_free(&p);
    }
    print_message("# taut string: Psi off by %.2g at the most\n", worst);
    rope_end(&r);
}

/* Smallest amplitude at a ratio: of one period, and of one mode unless that is -1. */
static double smallest(const struct rope *r, double ratio, int period, int harmonics, int mode)
{
    struct boundary found[ROOM];
    struct parametric p;
    int n;

    assert_int_equal(map_equations(&r->map, ratio, &p), SW_OK);
    assert_int_equal(bolotin_solve(&p, 2 * ratio * r->map.reference, period, harmonics, 1e9, found,
                                   ROOM, &n),
                     SW_OK);
    parametric_free(&p);
    for (int i = 0; i < n; i++)
        if (mode < 0 || found[i].mode == mode)
            return found[i].kappa;
    return INFINITY;
}

/* The six numbers, for any mesh and any harmonics. */
static void worked_numbers(void **state)
{
    static const double ratio[3] = {0.95, 1, 1.05};
    static const double wanted[2][3] = {{0.02281, 0.00867, 0.01392}, {0.02281, 0.00867, 0.01520}};
    (void)state;

    for (int n = 10; n <= 40; n *= 2) {
        struct rope r;

        rope_begin(&seil2, LAW_THESIS, n, 2, ALPHA_2, BETA_2, 0, &r);
        for (int theory = 0; theory < 2; theory++)
            for (int i = 0; i < 3; i++)
                for (int harmonics = 3; harmonics <= 13; harmonics += 5) {
                    r.map.theory = theory ? THEORY_CLASSICAL : THEORY_INDIFFERENCE;
                    near_abs(smallest(&r, ratio[i], 2, harmonics, -1), wanted[theory][i], 5.01e-6);
                }
        rope_end(&r);
    }
}

/* Indifference widens the principal region in the plane and leaves the lateral one as it is. */
static void two_theories(void **state)
{
    struct rope r;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 10, 2, ALPHA_2, BETA_2, 1, &r);
    assert_true(r.p.plane[0] == PART_LATERAL && r.p.plane[1] == PART_PLANE);
    for (double ratio = 0.9; ratio < 1.25; ratio += 0.01) {
        double lateral, plane;

        r.map.theory = THEORY_INDIFFERENCE;
        lateral = smallest(&r, ratio, 2, 13, 0);
        plane = smallest(&r, ratio, 2, 13, 1);
        r.map.theory = THEORY_CLASSICAL;
        near_rel(smallest(&r, ratio, 2, 13, 0), lateral, 1e-9);
        assert_true(plane < smallest(&r, ratio, 2, 13, 1));
    }
    rope_end(&r);
}

/* Smallest amplitude of period T for ratios 0.50 to 0.58, where the ground motion itself is in
 * resonance and the true tongue is not. */
static double false_region(double factor, int ground_damped)
{
    double least = INFINITY;
    struct rope r;

    rope_begin(&seil2, LAW_THESIS, 10, 2, factor * ALPHA_2, factor * BETA_2, ground_damped, &r);
    for (int i = 0; i <= 160; i++)
        least = fmin(least, smallest(&r, 0.5 + i * 0.0005, 1, 13, -1));
    rope_end(&r);
    return least;
}

static void damped_ground(void **state)
{
    double undamped = false_region(1, 0), before = false_region(1, 1);
    (void)state;

    print_message("# ratios 0.50 to 0.58: %.3g m undamped, %.5g damped", undamped, before);
    below(undamped, 1e-4);
    assert_true(before > 0.004 && before < 0.008);
    for (int i = 2; i <= 8; i *= 2) {
        double now = false_region(i, 1);

        printf(", %.5g (x %.3f)", now, now / before);
        assert_true(now / before > 2.5 && now / before < 3.2);
        before = now;
    }
    putchar('\n');
}

TEST_MAIN(cmocka_unit_test(characteristic_values), cmocka_unit_test(curves_of_mathieu),
          cmocka_unit_test(tips), cmocka_unit_test(thresholds),
          cmocka_unit_test(thresholds_by_integration), cmocka_unit_test(taut_string),
          cmocka_unit_test(worked_numbers), cmocka_unit_test(two_theories),
          cmocka_unit_test(damped_ground))
