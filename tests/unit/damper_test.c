/* Dampers: the taut string solved exactly, the universal curve, flexibilities, limits. */
#include "check.h"
#include "num/mem.h"
#include "phys/damper.h"

#include <complex.h>

/* A weightless taut string, 0.1 % stretched. */
static const struct cable string = {99.9, 10, 1e9, 0, 100, 0};
static const struct cable sagging = {110, 10, 1e8, 9.81, 100, 30};

struct string_facts {
    double H, m, speed, impedance;
};

static struct string_facts facts(void)
{
    struct string_facts f = {.H = string.EA * (string.span / string.L0 - 1),
                             .m = string.mu * string.L0 / string.span};

    f.speed = sqrt(f.H / f.m);
    f.impedance = sqrt(f.H * f.m);
    return f;
}

/*
 * Exact lambda of mode k of the string with a damper of coefficient c at fraction x of its span:
 * coth(lambda x1/a) + coth(lambda x2/a) + c/sqrt(H m) = 0, by Newton steps with small increments of
 * c from the undamped mode on.
 */
static double complex exact(int k, double x, double c)
{
    struct string_facts f = facts();
    double p = x * string.span / f.speed, q = (1 - x) * string.span / f.speed;
    double complex lambda = I * (k * PI * f.speed / string.span);

    for (int step = 1; step <= 400; step++) {
        double now = c * step * step / 160000.0 / f.impedance;

        /* times sinh sinh: sinh(lambda (p + q)) + now sinh(lambda p) sinh(lambda q) = 0 */
        for (int i = 0; i < 20; i++) {
            double complex value =
                csinh(lambda * (p + q)) + now * csinh(lambda * p) * csinh(lambda * q);
            double complex slope = (p + q) * ccosh(lambda * (p + q)) +
                                   now * (p * ccosh(lambda * p) * csinh(lambda * q) +
                                          q * csinh(lambda * p) * ccosh(lambda * q));

            lambda -= value / slope;
        }
    }
    return lambda;
}

struct set_up {
    struct model m;
    struct modes p;
    struct damper_basis b;
};

static struct set_up begin(const struct cable *c, int n, int k, const struct damper *d,
                           int n_dampers)
{
    struct set_up s;

    assert_int_equal(model_new(c, LAW_HOOKE, n, &s.m), SW_OK);
    assert_int_equal(modes_lowest(&s.m, k, SOLVER_AUTO, &s.p), SW_OK);
    assert_int_equal(damper_basis_new(&s.m, &s.p, d, n_dampers, &s.b), SW_OK);
    return s;
}

static void end(struct set_up *s)
{
    damper_basis_free(&s->b);
    modes_free(&s->p);
    model_free(&s->m);
}

/* The modes of one plane, in order. */
static int mode_of(const struct modes *p, enum part plane, int number)
{
    int i = -1;

    while (number > 0)
        number -= p->plane[++i] == plane;
    return i;
}

/* First four modes of the string over five decades of the coefficient.  20 elements hold less than
 * half an element up to the damper; from 100 on the 50 modes that are taken in limit the accuracy.
 */
static void exact_string(void **state)
{
    const struct {
        int n;
        double tolerance; /* of lambda over its damped part |lambda - i omega| */
    } mesh[] = {{20, 1e-2}, {100, 4e-5}, {400, 4e-5}};
    (void)state;

    for (int i = 0; i < 3; i++) {
        struct damper d = {0.02, {0, 1, 0}, 0};
        struct set_up s = begin(&string, mesh[i].n, 50, &d, 1);
        double worst = 0;

        for (d.coefficient = 100; d.coefficient < 1.1e7; d.coefficient *= 10) {
            assert_int_equal(damper_solve(&s.b, 0, 0, &d), SW_OK);
            for (int k = 1; k <= 4; k++) {
                int in = mode_of(&s.p, PART_PLANE, k), out = mode_of(&s.p, PART_LATERAL, k);
                double complex lambda = exact(k, 0.02, d.coefficient);
                double complex ours = -s.b.decay[in] + I * s.b.swing[in];
                double error = cabs(ours - lambda) / cabs(lambda - I * s.p.omega[out]);

                worst = fmax(worst, error);
                near_abs(s.b.decay[out], 0, 1e-9); /* not touched */
                near_rel(s.b.swing[out], s.p.omega[out], 1e-12);
            }
        }
        print_message("# %d elements: %.2g of the change by the damper\n", mesh[i].n, worst);
        below(worst, mesh[i].tolerance);
        end(&s);
    }
}

/* A damper on a string brings one eigenvalue that creeps, as its coefficient grows; no mode of the
 * string gets it, for all of them go on swinging. */
static void all_swing(void **state)
{
    (void)state;

    for (double x = 0.09; x < 0.5; x += 0.06) {
        struct damper d = {x, {0, 1, 0}, 0};
        struct set_up s = begin(&string, 20, 30, &d, 1);

        for (double c = 0.5; c < 100; c *= 1.5) {
            d.coefficient = c * facts().impedance;
            assert_int_equal(damper_solve(&s.b, 0, 0, &d), SW_OK);
            for (int k = 0; k < 30; k++)
                assert_true(s.b.swing[k] > 0);
        }
        end(&s);
    }
}

/* zeta/(x/l) = k/(1 + k^2), k = pi n c x/(l sqrt(H m)), with an error of second order in x/l: it
 * falls by four when x is halved.  The best coefficient has k = 1 to first order. */
static void universal_curve(void **state)
{
    double error[3] = {0}, impedance = facts().impedance;
    (void)state;

    for (int i = 0; i < 3; i++) {
        double x = 0.04 / (1 << i), best = impedance / (PI * x);
        struct damper d = {x, {0, 0, 1}, 0};
        struct set_up s = begin(&string, 200, 40, &d, 1);
        int mode = mode_of(&s.p, PART_LATERAL, 1);

        for (double k = 0.05; k < 20; k *= 1.3) {
            d.coefficient = k * best;
            assert_int_equal(damper_solve(&s.b, 0, 0, &d), SW_OK);
            error[i] = fmax(error[i], fabs(damper_ratio(&s.b, mode) - x * k / (1 + k * k)));
        }
        below(error[i], x * x);
        assert_int_equal(damper_best(&s.b, 0, 0, mode, best / 5, best * 5, &d), SW_OK);
        near_rel(d.coefficient, best, 3 * x * x + 1e-3 * x);
        near_abs(damper_ratio(&s.b, mode), 0.5 * x, x * x);
        end(&s);
    }
    print_message("# deviation from the universal curve %.3g %.3g %.3g\n", error[0], error[1],
                  error[2]);
    near_abs(error[0] / error[1], 4, 0.5);
    near_abs(error[1] / error[2], 4, 0.5);
}

/* Without or with a huge coefficient: free, and held at the damper. */
static void limits(void **state)
{
    struct damper d = {0.1, {0, 0, 2}, 0};
    struct set_up s = begin(&string, 100, 40, &d, 1);
    int mode = mode_of(&s.p, PART_LATERAL, 1);
    (void)state;

    assert_int_equal(damper_solve(&s.b, 0, 0, &d), SW_OK);
    near_rel(s.b.swing[mode], s.p.omega[mode], 1e-12);
    near_abs(s.b.decay[mode], 0, 1e-10);
    d.coefficient = 1e12;
    assert_int_equal(damper_solve(&s.b, 0, 0, &d), SW_OK);
    near_rel(s.b.swing[mode], s.p.omega[mode] / 0.9, 2e-5); /* l - x for l; mesh */
    end(&s);
}

/* Of the string: min(x, y) (l - max(x, y))/(H l); symmetric; the sagging cable's against a mesh
 * that is made finer, whose kinks cost it an error of order 1/n. */
static void flexibility(void **state)
{
    const struct axes plain = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const struct damper d[4] = {{0.7, {0, 3, 0}, 0},
                                {0.2, {0, 1, 0}, 0},
                                {0.2, {0, 0, 1}, 0},
                                {0.35, {1, 1, 1}, 0}};
    struct line s;
    double F[16], H = facts().H, at[2] = {0.7, 0.2}, error[2];
    (void)state;

    assert_int_equal(line_solve(&string, &s), SW_OK);
    assert_int_equal(damper_flexibility(&s, &plain, d, 3, F), SW_OK);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            near_rel(F[i + 3 * j], fmin(at[i], at[j]) * (1 - fmax(at[i], at[j])) * string.span / H,
                     1e-12);
    near_rel(F[8], 0.2 * 0.8 * string.span / H, 1e-12);
    near_abs(F[2], 0, 1e-20);
    assert_int_equal(line_solve(&sagging, &s), SW_OK);
    assert_int_equal(damper_flexibility(&s, &plain, d, 4, F), SW_OK);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            near_abs(F[i + 4 * j], F[j + 4 * i], 1e-12 * F[15]);
    for (int i = 0; i < 2; i++) {
        struct model m;
        struct band K;
        struct partition k;
        struct band_factor f;
        double size = sqrt(3), unit[3] = {1 / size, 1 / size, 1 / size}, sum = 0, *b;

        assert_int_equal(model_new(&sagging, LAW_HOOKE, 400 << (2 * i), &m), SW_OK);
        assert_int_equal(model_stiffness(&m, PART_ALL, &K), SW_OK);
        assert_int_equal(model_partition(&m, &K, &k), SW_OK);
        assert_int_equal(band_cholesky(&k.free, &f), SW_OK);
        b = model_vector(&m);
        model_point_load(&m, 0.35, unit, b);
        {
            int n = 6 * m.n, *keep = mem_zeroed((size_t)n, sizeof *keep);
            double *x = mem_doubles((size_t)n);

            model_free_unknowns(&m, PART_ALL, keep);
            for (int j = 0; j < n; j++)
                x[j] = b[keep[j]];
            band_solve(&f, x);
            for (int j = 0; j < n; j++)
                sum += x[j] * b[keep[j]];
            free(x);
            free(keep);
        }
        error[i] = F[15] - sum;
        assert_true(error[i] > 0); /* the mesh is too stiff */
        free(b);
        band_factor_free(&f);
        partition_free(&k);
        band_free(&K);
        model_free(&m);
    }
    print_message("# mesh against exact flexibility: %.3g %.3g\n", error[0] / F[15],
                  error[1] / F[15]);
    below(error[1] / F[15], 1e-3);
    near_abs(error[0] / error[1], 4, 0.4);
}

/* Rayleigh damping alone: zeta = alpha/(2 omega) + beta omega/2, also where a mode creeps. */
static void rayleigh(void **state)
{
    struct set_up s = begin(&seil1, 10, 20, NULL, 0);
    (void)state;

    assert_int_equal(damper_solve(&s.b, 0.2, 3e-3, NULL), SW_OK);
    for (int k = 0; k < 20; k++) {
        double w = s.p.omega[k], zeta = 0.1 / w + 1.5e-3 * w;

        near_rel(damper_ratio(&s.b, k), zeta, 1e-9);
        near_rel(s.b.swing[k], w * sqrt(1 - zeta * zeta), 1e-11);
    }
    assert_int_equal(damper_solve(&s.b, 30, 0, NULL), SW_OK);
    for (int k = 0; k < 20; k++) {
        double w = s.p.omega[k], zeta = 15 / w;

        if (zeta < 1)
            near_rel(s.b.decay[k], 15, 1e-9);
        else
            near_rel(s.b.decay[k], 15 - sqrt(225 - w * w), 1e-9);
        assert_true((s.b.swing[k] > 0) == (zeta < 1));
    }
    end(&s);
}

/* Light dampers: decay = sum of c (phi . d)^2/2; two at one place act like one of both
 * coefficients; dampers along two axes act each on its plane. */
static void several(void **state)
{
    struct damper two[2] = {{0.3, {0, 1, 0}, 5}, {0.3, {0, 1, 0}, 7}}, one = {0.3, {0, 1, 0}, 12};
    struct damper cross[3] = {{0.1, {1, 1, 0}, 9}, {0.1, {0, 0, 1}, 4}, {0.83, {0, 1, 1}, 2}};
    struct set_up s = begin(&sagging, 20, 60, two, 2), t = begin(&sagging, 20, 60, &one, 1), u;
    double *V = model_vector(&s.m);
    (void)state;

    assert_int_equal(damper_solve(&s.b, 0.01, 1e-4, two), SW_OK);
    assert_int_equal(damper_solve(&t.b, 0.01, 1e-4, &one), SW_OK);
    for (int k = 0; k < 20; k++) {
        near_rel(s.b.decay[k], t.b.decay[k], 1e-8);
        near_rel(s.b.swing[k], t.b.swing[k], 1e-10);
    }
    u = begin(&sagging, 20, 60, cross, 3);
    assert_int_equal(damper_solve(&u.b, 0, 0, cross), SW_OK);
    for (int k = 0; k < 10; k++) {
        double sum = 0;

        modes_shape(&u.m, &u.p, k, V);
        for (int i = 0; i < 3; i++) {
            const double *x = cross[i].direction;
            double v[3], size = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);

            model_probe(&u.m, cross[i].position, V, v, NULL);
            sum +=
                cross[i].coefficient / 2 * pow((v[0] * x[0] + v[1] * x[1] + v[2] * x[2]) / size, 2);
        }
        near_rel(u.b.decay[k], sum, 2e-3); /* second order in the coefficients */
    }
    end(&s);
    end(&t);
    end(&u);
    free(V);
}

/* A direction of any size. */
static void direction(void **state)
{
    static const double size[] = {1e-320, 1e-200, 1e-3, 1, 1e9, 1e200};
    const struct axes plain = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    (void)state;

    for (int i = 0; i < 6; i++) {
        const struct damper d = {0.5, {0, -size[i], size[i]}, 1};
        double unit[3];

        damper_direction(&d, &plain, unit);
        near_abs(unit[0], 0, 0);
        near_rel(unit[1], -sqrt(0.5), i == 0 ? 1e-3 : 1e-15);
        near_rel(unit[2], sqrt(0.5), i == 0 ? 1e-3 : 1e-15);
    }
}

static void memory_runs_out(void **state)
{
    const struct damper d[2] = {{0.1, {0, 1, 0}, 9}, {0.2, {0, 0, 1}, 4}};
    struct model m;
    struct modes p;
    unsigned long n = 0;
    enum status s;
    (void)state;

    assert_int_equal(model_new(&seil1, LAW_HOOKE, 4, &m), SW_OK);
    assert_int_equal(modes_lowest(&m, 10, SOLVER_DENSE, &p), SW_OK);
    do {
        struct damper_basis b;

        mem_fail_at(++n);
        s = damper_basis_new(&m, &p, d, 2, &b);
        if (s == SW_OK)
            s = damper_solve(&b, 0, 0, d);
        damper_basis_free(&b);
        assert_true(s == SW_OK || s == SW_NOMEM);
    } while (s != SW_OK);
    mem_fail_at(0);
    assert_true(n > 20);
    modes_free(&p);
    model_free(&m);
}

TEST_MAIN(cmocka_unit_test(exact_string), cmocka_unit_test(all_swing),
          cmocka_unit_test(universal_curve), cmocka_unit_test(limits),
          cmocka_unit_test(flexibility), cmocka_unit_test(rayleigh), cmocka_unit_test(several),
          cmocka_unit_test(direction), cmocka_unit_test(memory_runs_out))
