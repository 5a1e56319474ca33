/* A rope cut free: closed forms, the catenary tool's line, quadrature, convexity, order of chains.
 */
#include "check.h"
#include "phys/rope.h"

#include <string.h>

/* The random ropes of these tests: taut to slack, loads in any direction, up to a million times
 * apart. */
static struct rope random_rope(uint64_t *seed, double t[3])
{
    double load = log_uniform(seed, 1e-4, 1e2), EA = log_uniform(seed, 1e4, 1e8);
    double L0 = uniform_in(seed, 10, 100), T = load * L0 * log_uniform(seed, 1e-2, 1e4);
    double angle = uniform_in(seed, 0, PI), turn = uniform_in(seed, 0, 2 * PI);
    struct rope r = {.law = {.EA = EA}, .L0 = L0, .epsilon = 1e-9 * load * L0};

    r.q[0] = load * sin(angle) * cos(turn);
    r.q[1] = load * sin(angle) * sin(turn);
    r.q[2] = -load * cos(angle);
    T = fmin(T, 0.2 * EA);
    for (int i = 0; i < 3; i++)
        t[i] = uniform_in(seed, -T, T);
    return r;
}

static double largest(int n, const double *x)
{
    double most = 0;

    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* Both branches of the closed form against thousands of short pieces, which are done by quadrature:
 * the sums have round-off of 1e-14 or so. */
static void continuous_is_its_pieces(void **state)
{
    uint64_t seed = 11;
    double worst = 0, worst_F = 0;
    (void)state;

    for (int k = 0; k < 400; k++) {
        double t[3], chord[3], F[SYM], sum[3] = {0}, sum_F[SYM] = {0};
        struct rope r = random_rope(&seed, t), piece = r;
        enum { PIECES = 4000 };

        rope_chord(&r, t, chord, F);
        piece.L0 /= PIECES;
        for (int i = 0; i < PIECES; i++) {
            double at[3], x[3], G[SYM];

            for (int c = 0; c < 3; c++)
                at[c] = t[c] - r.q[c] * r.L0 * i / PIECES;
            rope_chord(&piece, at, x, G);
            for (int c = 0; c < 3; c++)
                sum[c] += x[c];
            for (int c = 0; c < SYM; c++)
                sum_F[c] += G[c];
        }
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs(sum[c] - chord[c]) / r.L0);
        for (int c = 0; c < SYM; c++)
            worst_F = fmax(worst_F, fabs(sum_F[c] - F[c]) / largest(SYM, F));
    }
    below(worst, 1e-13);
    below(worst_F, 1e-13);
    print_message("# chord %.2g, flexibility %.2g\n", worst, worst_F);
}

/* The static line of the cable tools: the same chord from its tension at the left end (x2 down). */
static void line_of_a_cable(void **state)
{
    const struct cable c = {110, 64.8, 1.7e9, 9.81, 100, 25};
    struct line s;
    (void)state;

    for (double L0 = 103.2; L0 < 300; L0 *= 1.1) {
        struct cable cable = c;
        struct rope r = {.law = {.EA = c.EA}, .q = {0, 0, -c.mu * c.g}, .epsilon = 1e-6};
        double chord[3];

        cable.L0 = r.L0 = L0;
        assert_int_equal(line_solve(&cable, &s), SW_OK);
        rope_chord(&r, (const double[3]){s.H, 0, -s.V}, chord, NULL);
        near_abs(chord[0], 100, 1e-10);
        near_abs(chord[1], 0, 1e-10);
        near_abs(chord[2], -25, 1e-10);
    }
}

/* F is the derivative of the chord, of chains and continuous ropes, and its inverse is one. */
static void flexibility_by_differences(void **state)
{
    uint64_t seed = 5;
    (void)state;

    for (int k = 0; k < 300; k++) {
        double t[3], chord[3], F[SYM], K[SYM], v[3] = {0.3, -0.7, 0.5}, w[3], z[3];
        struct rope r = random_rope(&seed, t);
        double h = 1e-5 * largest(3, t);

        r.elements = k % 3 ? 0 : 2 + k % 17;
        rope_chord(&r, t, chord, F);
        sym_times(F, v, w);
        for (int c = 0; c < 3; c++) {
            double up[3], down[3], a[3], b[3];

            for (int i = 0; i < 3; i++) {
                up[i] = t[i] + h * v[i];
                down[i] = t[i] - h * v[i];
            }
            rope_chord(&r, up, a, NULL);
            rope_chord(&r, down, b, NULL);
            /* where the tension nearly vanishes its direction turns within h */
            if (largest(3, t) >
                3 * sqrt(r.q[0] * r.q[0] + r.q[1] * r.q[1] + r.q[2] * r.q[2]) * r.L0)
                near_abs((a[c] - b[c]) / (2 * h), w[c], 1e-6 * largest(SYM, F));
        }
        assert_true(sym_invert(F, K));
        sym_times(K, w, z);
        for (int c = 0; c < 3; c++)
            near_abs(z[c], v[c], 1e-8);
    }
}

enum { SINGLE, ARC, WEIGHT, FLOW, N_FORMS };

/* Tension of a rope at u = 0..1 from one end to the other, which turns from phi to -phi under a
 * single force at its middle, a normal load, its weight, a flow across the chord. */
static void tension_of(int form, double T, double phi, double u, double ret[3])
{
    double slope = tan(phi) * (1 - 2 * u), angle = atan(slope);

    if (form == SINGLE)
        angle = u < 0.5 ? phi : -phi;
    else if (form == ARC)
        angle = phi * (1 - 2 * u);
    ret[0] = form == WEIGHT ? T * cos(phi) : T * cos(angle);
    ret[1] = 0;
    ret[2] = form == WEIGHT ? T * cos(phi) * slope : T * sin(angle);
}

/* Stiffness over T/s, along, across and out of the plane, of a chain of n elements: each has the
 * tension that the rope has at its middle. */
static void chain_form(int form, double phi, int n, double ret[3])
{
    static const int entry[3] = {SYM_XX, SYM_ZZ, SYM_YY};
    double load[3 * 320], t[3], first[3], next[3], chord[3], F[SYM], K[SYM], T = 1000;
    struct rope r = {.law = {.EA = 1e13}, .L0 = 1, .elements = n, .load = load, .epsilon = 1e-6};

    tension_of(form, T, phi, 0.5 / n, first);
    memcpy(t, first, sizeof t);
    for (int k = 1; k < n; k++) {
        tension_of(form, T, phi, (k + 0.5) / n, next);
        for (int c = 0; c < 3; c++)
            load[3 * (k - 1) + c] = t[c] - next[c];
        memcpy(t, next, sizeof t);
    }
    rope_chord(&r, first, chord, F);
    assert_true(sym_invert(F, K));
    for (int c = 0; c < 3; c++)
        ret[c] = K[entry[c]] * chord[0] / T;
}

/* The table of theory section 5 and c5: all four loads, order 2; a single force is exact at once,
 * and out of the plane so is the weight (H/s). */
static void forms_of_chains(void **state)
{
    const double phi = 1, A = log((1 + sin(phi)) / cos(phi));
    const double wanted[N_FORMS][3] = {{cos(phi) / (sin(phi) * sin(phi)), 1 / cos(phi), cos(phi)},
                                       {2 * sin(phi) / (phi - sin(2 * phi) / 2),
                                        2 * sin(phi) / (phi + sin(2 * phi) / 2), sin(phi) / phi},
                                       {cos(phi) * A / (A - sin(phi)), A / tan(phi), cos(phi)},
                                       {A / (tan(phi) - phi), A / phi, A / tan(phi)}};
    (void)state;

    for (int form = 0; form < N_FORMS; form++) {
        double coarse[3], fine[3];

        chain_form(form, phi, 80, coarse);
        chain_form(form, phi, 320, fine);
        for (int c = 0; c < 3; c++) {
            double before = fabs(coarse[c] / wanted[form][c] - 1);
            double after = fabs(fine[c] / wanted[form][c] - 1);

            below(after, 2e-5);
            if (before > 1e-9)
                near_abs(log(before / after) / log(4), 2, 0.05);
        }
    }
}

/*
 * The corrected (44)-(46) of theory section 9, elastic: with delta = EA/T0 + 1, T0 the horizontal
 * tension and q the weight per stretched length,
 *
 *     q/K_t = ln((1 + sin)/(1 - sin)) - 2 sin + 2 phi/delta,  q/K_n = 2 sin + 2 (tan - phi)/delta
 *
 * to first order in the strain, which the document takes as constant: a strain of 1e-3 leaves 1e-6
 * times some ten, and a formula without its elastic term would be off by 1e-3.
 */
static void elastic_catenary(void **state)
{
    enum { N = 2000 };
    const double phi = 0.9, T0 = 1000, EA = 1e6, q = 50, delta = EA / T0 + 1;
    const double along = log((1 + sin(phi)) / (1 - sin(phi))) - 2 * sin(phi) + 2 * phi / delta;
    const double across = 2 * sin(phi) + 2 * (tan(phi) - phi) / delta;
    static double load[3 * N];
    double stretched = 2 * T0 * tan(phi) / q, chord[3], F[SYM], first[3] = {T0, 0, 0}, t, sum = 0;
    struct rope r = {.law = {.EA = EA}, .elements = N, .load = load, .epsilon = 1e-6};
    (void)state;

    /* elements of one unstretched length: their stretched ones add up to that of the rope */
    for (double low = 0, high = stretched; high - low > 1e-13 * stretched;) {
        double before = 0;

        r.L0 = (low + high) / 2;
        sum = 0;
        t = -T0 * tan(phi);
        for (int k = 0; k < N; k++) {
            double l = r.L0 / N * (1 + hypot(T0, t + q * r.L0 / N / 2) / EA);

            /* tension of an element: that at its middle */
            if (k == 0)
                first[2] = t + q * l / 2;
            else
                load[3 * (k - 1) + 2] = -q * (before + l) / 2;
            t += q * l;
            before = l;
            sum += l;
        }
        if (sum < stretched)
            low = r.L0;
        else
            high = r.L0;
    }
    rope_chord(&r, first, chord, F);
    near_abs(chord[2], 0, 1e-6 * stretched);
    near_rel(q * F[SYM_XX], along, 2e-5);
    near_rel(q * F[SYM_ZZ], across, 2e-5);
    assert_true(fabs(q * F[SYM_XX] / (along - 2 * phi / delta) - 1) > 5e-4); /* as misprinted */
}

/* Chains under their own weight come to the continuous rope with order 2, stiffness too. */
static void chains_become_continuous(void **state)
{
    const double t[3] = {300, 20, -150};
    struct rope r = {.law = {.EA = 1e6}, .L0 = 80, .q = {0, 0, -9}, .epsilon = 1e-5};
    double exact[3], F[SYM], error[2][2] = {{0}};
    (void)state;

    rope_chord(&r, t, exact, F);
    for (int k = 0; k < 2; k++) {
        double chord[3], G[SYM], half[3], at[3];

        r.elements = k ? 160 : 40;
        rope_end_load(&r, half); /* the node carries it: t is that of the rope itself */
        for (int c = 0; c < 3; c++)
            at[c] = t[c] - half[c];
        rope_chord(&r, at, chord, G);
        for (int c = 0; c < 3; c++)
            error[0][k] = fmax(error[0][k], fabs(chord[c] - exact[c]));
        for (int c = 0; c < SYM; c++)
            error[1][k] = fmax(error[1][k], fabs(G[c] - F[c]));
    }
    for (int i = 0; i < 2; i++)
        near_abs(log(error[i][0] / error[i][1]) / log(4), 2, 0.05);
    below(error[0][1], 1e-3);
}

/* A table through points of Hooke's law is Hooke's law; its inverse is one. */
static void tables_of_strain(void **state)
{
    const double strain[3] = {0.001, 0.004, 0.01}, hooke[3] = {1e3, 4e3, 1e4},
                 bent[3] = {500, 4e3, 2e4};
    const struct rope_law line = {1e6, 3, strain, hooke}, curve = {5e5, 3, strain, bent};
    double chord[2][3], F[2][SYM], slope, back;
    struct rope r = {
        .law = {.EA = 1e6}, .L0 = 50, .elements = 12, .q = {0, 0, -30}, .epsilon = 1e-4};
    (void)state;

    for (int k = 0; k < 2; k++) {
        r.law = k ? line : (struct rope_law){.EA = 1e6};
        rope_chord(&r, (const double[3]){2000, 100, -900}, chord[k], F[k]);
    }
    for (int c = 0; c < 3; c++)
        near_abs(chord[0][c], chord[1][c], 1e-12);
    for (int c = 0; c < SYM; c++)
        near_abs(F[0][c], F[1][c], 1e-15);
    for (double T = 100; T < 2e4; T *= 1.3) {
        double e = rope_strain(&curve, T, &slope);

        near_rel(rope_tension(&curve, e, &back), T, 1e-13);
        near_rel(back * slope, 1, 1e-13);
    }
}

/* Points begin at a, end where the chord ends, and their loads are those of the rope. */
static void points_are_the_rope(void **state)
{
    uint64_t seed = 3;
    (void)state;

    for (int k = 0; k < 100; k++) {
        double t[3], chord[3], sum[3] = {0}, load[3], most, least;
        struct rope r = random_rope(&seed, t);
        struct rope_point p[21];

        r.elements = k % 2 ? 20 : 0;
        rope_chord(&r, t, chord, NULL);
        rope_points(&r, t, 21, p);
        rope_load(&r, load);
        rope_extremes(&r, t, &most, &least);
        for (int i = 0; i < 21; i++) {
            for (int c = 0; c < 3; c++)
                sum[c] += p[i].load[c];
            below(largest(3, p[i].t), most * (1 + 1e-12) + 1e-300);
        }
        for (int c = 0; c < 3; c++) {
            near_abs(p[20].x[c], chord[c], 1e-10 * r.L0);
            near_abs(sum[c], load[c], 1e-12 * largest(3, load));
            near_abs(p[20].t[c], t[c] - load[c], 1e-11 * most);
        }
        assert_true(least <= most && rope_length(&r, t) >= r.L0);
    }
}

/* Tensions from one end to the other, t - q s: the extremes are those of many points, but for what
 * lies between two of them. */
static void extremes_of_many_points(void **state)
{
    enum { POINTS = 1000 };
    uint64_t seed = 17;
    int inside = 0;
    (void)state;

    for (int k = 0; k < 1000; k++) {
        double t[3], most, least, at_most = 0, at_least = INFINITY, first = 0, last;
        struct rope r = random_rope(&seed, t);
        double load = sqrt(r.q[0] * r.q[0] + r.q[1] * r.q[1] + r.q[2] * r.q[2]), T = 0;

        for (int i = 0; i <= POINTS; i++) {
            T = 0;
            for (int c = 0; c < 3; c++)
                T += pow(t[c] - r.q[c] * r.L0 * i / POINTS, 2);
            T = sqrt(T);
            first = i == 0 ? T : first;
            at_most = fmax(at_most, T);
            at_least = fmin(at_least, T);
        }
        last = T;
        rope_extremes(&r, t, &most, &least);
        near_rel(most, at_most, 1e-14);
        assert_true(least <= at_least * (1 + 1e-14));
        if (at_least < fmin(first, last)) {
            near_abs(least, at_least, load * r.L0 / (2 * POINTS));
            inside++;
        } else if (least < at_least) {
            near_abs(least, at_least, load * r.L0 / POINTS);
        }
    }
    assert_true(inside > 100 && inside < 900);
}

/* The tension that stands for a chain is that of its least loaded element, and its chord stays; a
 * continuous rope keeps its own. */
static void least_loaded_element(void **state)
{
    struct rope r = {
        .law = {.EA = 1e6}, .L0 = 60, .elements = 6, .q = {0, 0, -20}, .epsilon = 1e-6};
    double t[3] = {100, 30, -510}, before[3], after[3]; /* falls by 200 a joint: -510 ... 490 */
    (void)state;

    rope_chord(&r, t, before, NULL);
    rope_refer(&r, t);
    near_abs(t[0], 100, 0);
    near_abs(t[1], 30, 0);
    near_abs(t[2], 90, 1e-12);
    rope_chord(&r, t, after, NULL);
    for (int c = 0; c < 3; c++)
        near_abs(after[c], before[c], 1e-12);
    r.elements = 0;
    rope_refer(&r, t);
    near_abs(t[0], 100, 0);
    near_abs(t[1], 30, 0);
    near_abs(t[2], 90, 1e-12);
}

TEST_MAIN(cmocka_unit_test(continuous_is_its_pieces), cmocka_unit_test(line_of_a_cable),
          cmocka_unit_test(flexibility_by_differences), cmocka_unit_test(forms_of_chains),
          cmocka_unit_test(elastic_catenary), cmocka_unit_test(chains_become_continuous),
          cmocka_unit_test(tables_of_strain), cmocka_unit_test(points_are_the_rope),
          cmocka_unit_test(extremes_of_many_points), cmocka_unit_test(least_loaded_element))
