/*
 * Large vibrations of the taut string without gravity against closed forms (theory section 8): free
 * vibration in a plane and whirling, the limit amplitude of parametric vibration, and the largest
 * frequency of a mesh, which bounds the time step.
 */
#include "check.h"
#include "phys/march.h"
#include "phys/modes.h"

enum { N = 20, ALL = 6 * (N + 1), MID = 6 * (N / 2), DOWN = MID + 2, SIDE = MID + 4 };

/* String of the ropes' mass and stiffness with the strain that gives them their 15 kN. */
static struct cable string(double L0, double strain)
{
    return (struct cable){L0, 0.704, 1.5556e11 * 8.48e-5, 0, L0 * (1 + strain), 0};
}

static struct model new_model(const struct cable *c, enum law law, int n)
{
    struct model m;

    assert_int_equal(model_new(c, law, n, &m), SW_OK);
    return m;
}

/* w0 and g of q'' + w0^2 q + g q (q^2 + p^2) = 0. */
static double w0(const struct model *m)
{
    return PI / m->line.cable.L0 * sqrt(m->material[0].T / m->line.cable.mu);
}

static double hardening(const struct model *m)
{
    return pow(PI, 4) * m->material[0].EA / (4 * m->line.cable.mu * pow(m->line.cable.L0, 4));
}

/* Complete elliptic integral of the first kind by the arithmetic-geometric mean. */
static double elliptic_K(double parameter)
{
    double a = 1, b = sqrt(1 - parameter);

    for (int i = 0; i < 10; i++) {
        double mean = (a + b) / 2;

        b = sqrt(a * b);
        a = mean;
    }
    return PI / (2 * a);
}

/* V = the half sine of amplitude A in the direction of unknown c (2 or 4), with the displacement
 * along the string that makes the strain uniform at rest. */
static void half_sine(const struct model *m, int c, double A, double *V)
{
    double L0 = m->line.cable.L0, along = -A * A * PI / (8 * L0) / m->material[0].stretch;

    for (int k = 0; k <= m->n; k++) {
        double x = PI * k / m->n;

        V[6 * k] = along * sin(2 * x);
        V[6 * k + 1] = along * 2 * PI / L0 * cos(2 * x);
        V[6 * k + c] = A * sin(x);
        V[6 * k + c + 1] = A * PI / L0 * cos(x);
    }
}

static void step(struct march *a)
{
    assert_int_equal(march_solve(a), SW_OK);
    march_advance(a);
}

/* Frequency of an unknown by its first and its last of many crossings of zero, interpolated. */
static double frequency(struct march *a, int unknown, int crossings)
{
    double first = 0, last = 0;

    for (int k = 0; k <= crossings;) {
        double before = a->V[unknown];

        step(a);
        if (before * a->V[unknown] <= 0 && a->V[unknown] != 0) {
            last = march_time(a) - a->options.dt * a->V[unknown] / (a->V[unknown] - before);
            first = k++ == 0 ? last : first;
        }
    }
    return crossings * PI / (last - first);
}

/* Started from V with the velocity W, or at rest. */
static struct march new_march(const struct model *m, const double *V, const double *W, int terms,
                              double dt)
{
    struct march_options o = {.dt = dt, .terms = terms};
    struct march a;

    assert_int_equal(march_new(m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, W), SW_OK);
    return a;
}

static const double amplitudes[] = {0.01, 0.3, 0.6, 1, 1.5};

/* w = pi sqrt(w0^2 + g A^2)/(2 K(m)), started at a turning point, sideways and downward. */
static void planar_backbone(void **state)
{
    const struct cable c = string(100.429, 1.135e-3);
    double worst = 0;
    (void)state;

    for (int law = LAW_HOOKE; law <= LAW_THESIS; law++) {
        struct model m = new_model(&c, (enum law)law, N);

        for (int i = 0; i < 5; i++) {
            double A = amplitudes[i], V[ALL] = {0}, w, gA2 = hardening(&m) * A * A;
            double stiff = w0(&m) * w0(&m) + gA2;
            double wanted = PI * sqrt(stiff) / (2 * elliptic_K(gA2 / (2 * stiff)));
            struct march a;

            half_sine(&m, i % 2 ? 2 : 4, A, V);
            a = new_march(&m, V, NULL, 3, 0.9 * march_critical_step(&m));
            w = frequency(&a, i % 2 ? DOWN : SIDE, 40);
            near_rel(w, wanted, 2e-4);
            assert_true(i == 0 || w > 1.005 * w0(&m)); /* far from the linear frequency */
            worst = fmax(worst, fabs(w / wanted - 1));
            march_free(&a);
        }
        model_free(&m);
    }
    print_message("# planar: frequencies off by %.1e at the most\n", worst);
}

/* Least and largest distance of the middle from the axis in some steps. */
static void radii(struct march *a, int steps, double *least, double *most)
{
    *least = INFINITY;
    *most = 0;
    for (int k = 0; k < steps; k++) {
        double r = hypot(a->V[DOWN], a->V[SIDE]);

        *least = fmin(*least, r);
        *most = fmax(*most, r);
        step(a);
    }
}

/* w = sqrt(w0^2 + g R^2), started on the circle with its velocity, and still on it after that. */
static void whirling_backbone(void **state)
{
    const struct cable c = string(100.429, 1.135e-3);
    double worst = 0, from_circle = 0;
    (void)state;

    for (int law = LAW_HOOKE; law <= LAW_THESIS; law++) {
        struct model m = new_model(&c, (enum law)law, N);

        for (int i = 0; i < 5; i++) {
            double R = amplitudes[i], V[ALL] = {0}, velocity[ALL] = {0}, least, most, w;
            double wanted = sqrt(w0(&m) * w0(&m) + hardening(&m) * R * R);
            struct march a;

            half_sine(&m, 2, R, V);
            half_sine(&m, 4, wanted * R, velocity);
            for (int k = 0; k < ALL; k++)
                velocity[k] *= k % 6 >= 4; /* none along the string */
            a = new_march(&m, V, velocity, 3, 0.9 * march_critical_step(&m));
            w = frequency(&a, SIDE, 40);
            near_rel(w, wanted, 2e-4);
            worst = fmax(worst, fabs(w / wanted - 1));
            radii(&a, 20000, &least, &most);
            from_circle = fmax(from_circle, fmax(most / R - 1, 1 - least / R));
            march_free(&a);
        }
        model_free(&m);
    }
    print_message("# whirling: off by %.1e, %.1e from the circle\n", worst, from_circle);
    below(from_circle, 5e-4);
}

/* The steady lateral vibration of the middle: its largest value, and its part cos(Omega t/2). */
struct lateral {
    double largest, first;
};

/* One end moved along the string by u0 cos Omega t with Omega = 2 ratio w0, from a small lateral
 * deflection; mass damping zeta. */
static struct lateral parametric(const struct model *m, double u0, double ratio, double zeta)
{
    const double w = w0(m), period = PI / (ratio * w), L0 = m->line.cable.L0;
    const int substeps = (int)ceil(period / (0.9 * march_critical_step(m)));
    const int end = (int)(12 / (zeta * w) / period), last = end - 40;
    const struct motion shake = {SUPPORT_RIGHT, {u0, 0, 0}, 2 * ratio * w, {0, 0, 0}, 0,
                                 NULL,          NULL};
    struct march_options o = {.alpha = 2 * zeta * w,
                              .dt = period / substeps,
                              .terms = 3,
                              .motion = &shake,
                              .n_motions = 1};
    struct lateral ret = {0, 0};
    double V[ALL] = {0}, c = 0, s = 0;
    struct march a;

    half_sine(m, 4, 0.05, V);
    for (int k = 0; k <= m->n; k++) {
        V[6 * k] += u0 * k / m->n;
        V[6 * k + 1] += u0 / L0;
    }
    assert_int_equal(march_new(m, &o, &a), SW_OK);
    assert_int_equal(march_start(&a, V, NULL), SW_OK);
    for (long k = 0; k < (long)end * substeps; k++) {
        if (k >= (long)last * substeps) {
            double v3 = a.V[6 * (m->n / 2) + 4];

            ret.largest = fmax(ret.largest, fabs(v3));
            c += v3 * cos(PI * (double)k / substeps);
            s += v3 * sin(PI * (double)k / substeps);
        }
        step(&a);
    }
    ret.first = 2 * hypot(c, s) / (40 * substeps);
    march_free(&a);
    return ret;
}

/*
 * (3/4) g A^2 = (Omega^2/4 - w0^2) + sqrt((eps w0^2/2)^2 - (zeta w0 Omega)^2) for the part
 * cos(Omega t/2), which is all that it knows of; the largest value lies 2 % (Omega = 2 w0) to 3 %
 * (0.97 of it) lower; the third shape has a part of 1e-3.  At Omega = 2 w0 tension, mass and
 * stiffness have no part in it, though g and the frequencies vary by much.
 */
static void limit_amplitude(void **state)
{
    static const struct {
        double strain, stiffness, mass, ratio, first, largest; /* tolerances of the last two */
    } run[] = {{1.135e-3, 1, 1, 1, 2e-3, 0.025},
               {2.27e-3, 1, 1, 1, 2e-3, 0.025},
               {1.135e-3, 1. / 3, 2, 1, 2e-3, 0.025},
               {1.135e-3, 1, 1, 0.97, 6e-3, 0.03}};
    const double u0 = 0.05, zeta = 0.01;
    (void)state;

    for (size_t i = 0; i < sizeof run / sizeof *run; i++) {
        struct cable c = string(100.429, run[i].strain);
        double w, eps, A;
        struct lateral seen;
        struct model m;

        c.EA *= run[i].stiffness;
        c.mu *= run[i].mass;
        m = new_model(&c, LAW_THESIS, 10);
        w = w0(&m);
        eps = c.EA * pow(m.material[0].stretch, 2) * u0 / (m.line.H * c.L0);
        A = sqrt(4 / (3 * hardening(&m)) * w * w *
                 (run[i].ratio * run[i].ratio - 1 +
                  sqrt(pow(eps / 2, 2) - pow(2 * zeta * run[i].ratio, 2))));
        seen = parametric(&m, u0, run[i].ratio, zeta);
        print_message(
            "# eps %.3f, Omega/(2 w0) %.2f: %.4f m, part of Omega/2 %.4f m, theory %.4f\n", eps,
            run[i].ratio, seen.largest, seen.first, A);
        near_rel(seen.first, A, run[i].first);
        near_rel(seen.largest, A, run[i].largest);
        if (run[i].ratio == 1)
            near_rel(seen.largest, sqrt(8 * u0 * c.L0 / 3) / PI, 0.025);
        model_free(&m);
    }
}

/* sqrt(42) c/h is the largest frequency of a straight uniform mesh, and a little above that of a
 * cable that sags. */
static void largest_frequency(void **state)
{
    const struct cable straight = string(100.429, 1.135e-3);
    const struct cable *const cables[] = {&straight, &pont, &seil1, &seil2};
    (void)state;

    for (int i = 0; i < 4; i++)
        for (int n = 1; n <= 25; n += 8) {
            struct model m = new_model(cables[i], LAW_THESIS, n);
            struct modes all;
            double bound = model_omega_max(&m), theory, above;
            const struct material *p = &m.material[0];

            assert_int_equal(modes_lowest(&m, 6 * n, SOLVER_DENSE, &all), SW_OK);
            above = bound / all.omega[6 * n - 1] - 1;
            theory = sqrt(42 * (p->EA * p->stretch * p->stretch + p->T) / m.line.cable.mu) / m.h;
            near_rel(bound, theory, 1e-4); /* at the end the tension is largest */
            near_rel(march_critical_step(&m), 2 / bound, 1e-15);
            assert_true(above > -1e-12 && above < (i == 0 ? 1e-12 : 2e-4));
            modes_free(&all);
            model_free(&m);
        }
}

/* 0.9 of the critical step stays bounded, 1.01 diverges. */
static void critical_step(void **state)
{
    const struct cable straight = string(100.429, 1.135e-3);
    const struct cable *const cables[] = {&straight, &pont, &seil2};
    (void)state;

    for (int i = 0; i < 3; i++) {
        struct model m = new_model(cables[i], LAW_THESIS, N);

        for (int terms = 0; terms <= 3; terms += 3) {
            double V[ALL] = {0}, most = 0;
            enum status s = SW_OK;
            struct march a;

            V[MID] = V[MID + 1] = 1e-6;
            a = new_march(&m, V, NULL, terms, 0.9 * march_critical_step(&m));
            for (int k = 0; k < 20000; k++) {
                step(&a);
                most = fmax(most, fabs(a.V[MID]));
            }
            below(most, 2e-5);
            march_free(&a);
            a = new_march(&m, V, NULL, terms, 1.01 * march_critical_step(&m));
            a.omega_max = 0; /* the watch asleep */
            for (int k = 0; k < 20000 && s == SW_OK; k++) {
                s = march_solve(&a);
                march_advance(&a);
            }
            assert_int_equal(s, SW_DIVERGED);
            march_free(&a);
        }
        model_free(&m);
    }
}

TEST_MAIN(cmocka_unit_test(planar_backbone), cmocka_unit_test(whirling_backbone),
          cmocka_unit_test(limit_amplitude), cmocka_unit_test(largest_frequency),
          cmocka_unit_test(critical_step))
