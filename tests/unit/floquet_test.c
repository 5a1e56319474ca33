/* Floquet multipliers: at Bolotin's points, at a combination resonance, against Hill's method; maps
 * and what is asked of them. */
#include "num/dense.h"
#include "num/mem.h"
#include "phys/answers.h"
#include "rope.h"

#include <complex.h>

#define ROOM 2000
#define MOST (2 * MOST_MODES)

/* Number of multipliers outside the unit circle, and the distance of the nearest one from
 * target. */
static int outside(const struct parametric *p, double Omega, double kappa, double target, int steps,
                   double *ret_nearest)
{
    double re[MOST], im[MOST];
    int n = 0;

    assert_int_equal(floquet_multipliers(p, Omega, kappa, steps, re, im, NULL), SW_OK);
    *ret_nearest = INFINITY;
    for (int i = 0; i < 2 * p->s; i++) {
        *ret_nearest = fmin(*ret_nearest, hypot(re[i] - target, im[i]));
        n += hypot(re[i], im[i]) > 1;
    }
    return n;
}

/* On Bolotin's boundaries a multiplier is 1 or -1, and passes there through the unit circle. */
static void on_boundaries(void **state)
{
    static const int modes[3] = {1, 2, 6};
    static struct boundary found[ROOM];
    double worst = 0;
    int points = 0, crowded = 0;
    (void)state;

    for (int k = 0; k < 12; k++) {
        const struct cable *c = k % 2 ? &seil2 : &seil1;
        struct rope r;

        rope_begin(c, LAW_THESIS, 10, modes[k / 4], k % 2 ? ALPHA_2 : ALPHA_1,
                   k % 2 ? BETA_2 : BETA_1, 1, &r);
        r.map.theory = k / 2 % 2 ? THEORY_CLASSICAL : THEORY_INDIFFERENCE;
        for (int i = 0; i <= 17; i++) {
            double ratio = 0.45 + 0.05 * i, Omega = 2 * ratio * r.map.reference;
            int steps = i == 2 ? 8000 : 400, harmonics = i == 2 ? 41 : 21; /* ground resonance */
            struct parametric p;
            int n[2] = {0, 0}, all;

            assert_int_equal(map_equations(&r.map, ratio, &p), SW_OK);
            for (int half = 0; half < 2; half++)
                assert_int_equal(bolotin_solve(&p, Omega, half + 1, harmonics, 0.201,
                                               found + (half ? n[0] : 0), ROOM / 2, &n[half]),
                                 SW_OK);
            all = n[0] + n[1];
            for (int j = 0; j < all; j++) {
                double kappa = found[j].kappa, target = j < n[0] ? 1 : -1, nearest, beside;
                int before, after, alone = 1;

                if (kappa > 0.2)
                    continue;
                outside(&p, Omega, kappa, target, steps, &nearest);
                below(nearest, 1e-6);
                worst = fmax(worst, nearest);
                points++;
                for (int other = 0; other < all; other++)
                    alone &= other == j || fabs(found[other].kappa / kappa - 1) > 1.1e-4;
                crowded += !alone; /* what changes here may change back within the step */
                before = outside(&p, Omega, kappa * (1 - 1e-4), target, steps, &beside);
                after = outside(&p, Omega, kappa * (1 + 1e-4), target, steps, &beside);
                if (alone)
                    assert_int_equal(abs(after - before), 1);
            }
            parametric_free(&p);
        }
        rope_end(&r);
    }
    print_message("# %d points, multiplier off by %.2g at the most; %d with others within 1e-4\n",
                  points, worst, crowded);
    assert_true(points > 300);
}

/* Smallest amplitude, by halving, at which a multiplier leaves the unit circle. */
static double onset(const struct parametric *p, double Omega, double low, double high,
                    struct floquet *f)
{
    while (high - low > 1e-9 * high) {
        double kappa = (low + high) / 2;

        f->steps = 0;
        assert_int_equal(floquet_solve(p, Omega, kappa, 1e-12, f), SW_OK);
        *(f->modulus > 1 ? &high : &low) = kappa;
    }
    f->steps = 0;
    assert_int_equal(floquet_solve(p, Omega, high, 1e-12, f), SW_OK);
    return high;
}

/* Two modes that only excite each other: the sum-type combination resonance. */
static void combination(void **state)
{
    /* In the last row displacements are as 5 to 1 in energy, and both modes have to be named. */
    static const double zeta[][2] = {{1e-3, 1e-3}, {1e-3, 2e-3}, {5e-4, 1e-4}, {1e-3, 2e-4}};
    static const double second[] = {1.7, 1.7, 1.7, 5};
    (void)state;

    for (int i = 0; i < 4; i++)
        for (int detune = 0; detune < 3; detune++) {
            struct hand h;
            struct parametric *p = hand_begin(2, &h);
            double w1 = 1, w2 = second[i], d1 = zeta[i][0] * w1, d2 = zeta[i][1] * w2;
            double s = 0.5 * detune * (d1 + d2), Omega = w1 + w2 + s, closed, found;
            struct boundary b[100];
            struct floquet f = {.steps = 0};
            int n;

            p->omega[0] = w1;
            p->omega[1] = w2;
            p->c[0] = 2 * d1;
            p->c[1] = 2 * d2;
            p->psi_c[1] = p->psi_c[2] = 3;
            closed = 4 * sqrt(w1 * w2 * d1 * d2 * (1 + pow(s / (d1 + d2), 2))) / 3;
            found = onset(p, Omega, closed / 2, 2 * closed, &f);
            near_rel(found, closed, 0.01);
            assert_int_equal(f.crossing, CROSSING_COMBINATION);
            assert_true(f.mode + f.partner == 1);
            for (int period = 1; period <= 2; period++) {
                assert_int_equal(bolotin_solve(p, Omega, period, 13, 20 * closed, b, 100, &n),
                                 SW_OK);
                assert_int_equal(n, 0);
            }
            if (detune == 0)
                print_message("# damping %g, %g: %.6g, closed form %.6g\n", zeta[i][0], zeta[i][1],
                              found, closed);
            /* The other sign makes the difference type and no resonance of the sum. */
            p->psi_c[2] = -3;
            f.steps = 0;
            assert_int_equal(floquet_solve(p, Omega, 1.5 * closed, 1e-10, &f), SW_OK);
            below(f.modulus, 1);
        }
}

/* Adds value to entry (i, j) of a complex matrix of order n that stands as a real one, (R, -I; I,
 * R). */
static void put(double *A, int n, int i, int j, double complex value)
{
    A[i + 2 * n * j] += creal(value);
    A[n + i + 2 * n * (n + j)] += creal(value);
    A[n + i + 2 * n * j] += cimag(value);
    A[i + 2 * n * (n + j)] -= cimag(value);
}

/* Largest distance between the multipliers and those of Hill's method with harmonics from -N to N
 * of the first-order equations. */
static double hill(const struct parametric *p, double Omega, double kappa, int N)
{
    int s = p->s, blocks = 2 * N + 1, n = 2 * s * blocks;
    double *A = mem_doubles(4 * (size_t)n * (size_t)n);
    double *re = mem_doubles(2 * (size_t)n), *im = mem_doubles(2 * (size_t)n);
    double mre[MOST], mim[MOST], worst = 0, nearest[MOST];

    for (int b = 0; b < blocks; b++)
        for (int i = 0; i < s; i++) {
            int q = 2 * s * b + i, v = q + s;

            put(A, n, q, q, -I * ((b - N) * Omega));
            put(A, n, v, v, -I * ((b - N) * Omega) - p->c[i]);
            put(A, n, q, v, 1);
            put(A, n, v, q, -p->omega[i] * p->omega[i]);
            for (int from = 0; from < blocks; from++)
                for (int j = 0; j < s; j++) {
                    int at = i + s * j, up = b - from; /* harmonic of the coefficient */
                    double complex one = (p->psi_c[at] - I * p->psi_s[at]) / 2 * kappa;
                    double complex two =
                        (p->double_c[at] - I * p->double_s[at]) / 2 * kappa * kappa;
                    double complex value = up == 0    ? kappa * kappa * p->mean[at]
                                           : up == 1  ? one
                                           : up == -1 ? conj(one)
                                           : up == 2  ? two
                                           : up == -2 ? conj(two)
                                                      : 0;

                    if (abs(up) <= 1 || p->quadratic)
                        put(A, n, v, 2 * s * from + j, up != 0 || p->quadratic ? -value : 0);
                }
        }
    assert_int_equal(dense_general(2 * n, A, re, im, NULL), SW_OK);
    assert_int_equal(floquet_multipliers(p, Omega, kappa, 400, mre, mim, NULL), SW_OK);
    for (int k = 0; k < 2 * s; k++)
        nearest[k] = INFINITY;
    for (int i = 0; i < 2 * n; i++)
        if (fabs(im[i]) <= 0.6 * Omega) { /* exponents that the truncation leaves in peace */
            double complex mu = cexp((re[i] + I * im[i]) * 2 * PI / Omega);
            double least = INFINITY;

            for (int k = 0; k < 2 * s; k++) {
                double off = cabs(mu - mre[k] - I * mim[k]);

                nearest[k] = fmin(nearest[k], off);
                least = fmin(least, off);
            }
            worst = fmax(worst, least);
        }
    for (int k = 0; k < 2 * s; k++)
        worst = fmax(worst, nearest[k]);
    free(A);
    free(re);
    free(im);
    return worst;
}

static void hill_agrees(void **state)
{
    static const double ratio[] = {0.5, 0.53, 0.55, 0.8, 1, 1.04, 1.2};
    static const double kappa[] = {0.002, 0.01, 0.05};
    double worst = 0;
    struct rope r;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 10, 2, ALPHA_2, BETA_2, 1, &r);
    r.map.b[5] = 0.3 + 0.2 * I; /* couples both modes, and makes psi_s large */
    for (int quadratic = 0; quadratic < 2; quadratic++)
        for (int i = 0; i < 7; i++)
            for (int k = 0; k < 3; k++) {
                struct parametric p;
                double off;

                r.map.quadratic = quadratic;
                assert_int_equal(map_equations(&r.map, ratio[i], &p), SW_OK);
                off = hill(&p, 2 * ratio[i] * r.map.reference, kappa[k], 16);
                worst = fmax(worst, off);
                below(off, 1e-6);
                parametric_free(&p);
            }
    print_message("# Hill's exponents: multipliers off by %.2g at the most\n", worst);
    rope_end(&r);
}

/* A mode that is excited by itself drags another one along a little: that is no partner. */
static void dragged_along(void **state)
{
    (void)state;

    for (int k = 0; k < 2; k++) {
        struct hand h;
        struct parametric *p = hand_begin(2, &h);
        struct floquet f = {.steps = 0};

        p->omega[k] = 1;
        p->omega[!k] = 1.7;
        p->c[0] = p->c[1] = 2e-3;
        p->psi_c[3 * k] = 3;
        p->psi_c[1] = p->psi_c[2] = 0.3;
        onset(p, 2, 1e-4, 1e-2, &f);
        assert_int_equal(f.crossing, CROSSING_2T);
        assert_int_equal(f.mode, k);
        assert_int_equal(f.partner, -1);
    }
}

/* A string without weight does not know up: what a vertical motion of its support does to a
 * vertical and a lateral mode, a lateral one does to the lateral and the vertical one. */
static void up_and_aside(void **state)
{
    const struct cable string = {99.9, 10, 1e8, 0, 100, 0};
    struct parametric p[2];
    struct rope r;
    int first;
    (void)state;

    rope_begin(&string, LAW_HOOKE, 10, 2, 0.1, 1e-3, 1, &r);
    first = r.p.plane[0] == PART_LATERAL;
    assert_true(r.p.plane[0] != r.p.plane[1]);
    r.map.quadratic = 1;
    r.map.b[3] = 0;
    for (int aside = 0; aside < 2; aside++) {
        r.map.b[4] = aside ? 0 : 1;
        r.map.b[5] = aside ? 1 : 0;
        assert_int_equal(map_equations(&r.map, 0.8, &p[aside]), SW_OK);
    }
    for (int i = 0; i < 4; i++) {
        near_rel(p[1].mean[i], p[0].mean[3 - i], i % 3 == 0 ? 1e-9 : 0);
        near_rel(p[1].double_c[i], p[0].double_c[3 - i], i % 3 == 0 ? 1e-9 : 0);
        near_rel(p[1].double_s[i], p[0].double_s[3 - i], i % 3 == 0 ? 1e-9 : 0);
    }
    assert_true(fabs(p[0].double_s[0]) > 1e-3 && p[0].mean[0] != p[0].mean[3]);
    assert_true(p[0].mean[first ? 3 : 0] > p[0].mean[first ? 0 : 3]); /* more in its own plane */
    parametric_free(&p[0]);
    parametric_free(&p[1]);
    rope_end(&r);
}

/* The same boundaries with quadratic terms: multipliers are 1 or -1 there. */
static void quadratic_boundaries(void **state)
{
    static struct boundary found[ROOM];
    double worst = 0;
    int points = 0;
    struct rope r;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 10, 2, ALPHA_2, BETA_2, 1, &r);
    r.map.quadratic = 1;
    r.map.b[5] = 0.2 * I;
    for (double ratio = 0.47; ratio < 1.3; ratio += 0.04)
        for (int period = 1; period <= 2; period++) {
            double Omega = 2 * ratio * r.map.reference, nearest;
            struct parametric p;
            int n, steps = 2000;

            assert_int_equal(map_equations(&r.map, ratio, &p), SW_OK);
            assert_int_equal(bolotin_solve(&p, Omega, period, 31, 0.1, found, ROOM, &n), SW_OK);
            for (int j = 0; j < n; j++) {
                outside(&p, Omega, found[j].kappa, period == 1 ? 1 : -1, steps, &nearest);
                below(nearest, 1e-6);
                worst = fmax(worst, nearest);
                points++;
            }
            parametric_free(&p);
        }
    print_message("# quadratic: %d points, multiplier off by %.2g at the most\n", points, worst);
    assert_true(points > 20);
    rope_end(&r);
}

/* Motion in the plane separates the planes, skew motion does not; what is found by groups is what
 * is found of the whole. */
static void groups(void **state)
{
    static struct boundary found[ROOM], whole[ROOM];
    struct rope r;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 10, 6, ALPHA_2, BETA_2, 1, &r);
    for (int skew = 0; skew < 2; skew++)
        for (double ratio = 0.45; ratio < 1.3; ratio += 0.1) {
            double Omega = 2 * ratio * r.map.reference, most = 0, nearest = INFINITY, re[MOST];
            double im[MOST];
            struct parametric p;
            int group[MOST_MODES], n, m, count;
            struct floquet f = {.steps = 0};

            r.map.b[5] = skew ? 0.5 : 0;
            assert_int_equal(map_equations(&r.map, ratio, &p), SW_OK);
            count = parametric_groups(&p, group);
            if (skew)
                assert_int_equal(count, 1);
            else
                assert_true(count >= 2);
            for (int i = 0; i < 6; i++)
                for (int j = 0; j < 6 && !skew; j++)
                    if (r.p.plane[i] != r.p.plane[j])
                        assert_true(group[i] != group[j]);
            for (int i = 0; i < 6; i++) {
                struct parametric part;
                int mode[MOST_MODES];

                assert_true(group[i] >= 0 && group[i] < count);
                assert_int_equal(parametric_group(&p, group, group[i], &part, mode), SW_OK);
                for (int k = 0; k < part.s; k++) {
                    assert_int_equal(group[mode[k]], group[i]);
                    near_abs(part.omega[k], p.omega[mode[k]], 0);
                }
                parametric_free(&part);
            }
            assert_int_equal(floquet_solve(&p, Omega, 0.06, 1e-10, &f), SW_OK);
            assert_int_equal(floquet_multipliers(&p, Omega, 0.06, 400, re, im, NULL), SW_OK);
            for (int i = 0; i < 12; i++) {
                most = fmax(most, hypot(re[i], im[i]));
                nearest = fmin(nearest, hypot(re[i] - f.re, im[i] - f.im));
            }
            near_rel(f.modulus, most, 1e-8);
            below(nearest, 1e-6);
            for (int period = 1; period <= 2; period++) {
                assert_int_equal(bolotin_solve(&p, Omega, period, 13, 0.1, found, ROOM, &n), SW_OK);
                if (period == 1) /* what round-off could be makes one group of all */
                    for (int i = 1; i < 6; i++)
                        p.psi_c[i] += 1e-11 * p.psi_c[0], p.psi_c[6 * i] += 1e-11 * p.psi_c[0];
                assert_int_equal(bolotin_solve(&p, Omega, period, 13, 0.1, whole, ROOM, &m), SW_OK);
                assert_int_equal(n, m);
                for (int i = 0; i < n; i++)
                    near_rel(found[i].kappa, whole[i].kappa, 1e-7);
            }
            parametric_free(&p);
        }
    rope_end(&r);
}

/* Points A and B of SEIL2 (Thalheim 6.2.4.2): the lateral disturbance grows in A and dies in B. */
static void published_points(void **state)
{
    static const double Omega[2] = {9.124, 7.296};
    struct rope r;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 10, 2, ALPHA_2, BETA_2, 1, &r);
    for (int i = 0; i < 2; i++) {
        struct map_task t = {.floquet = 1, .from = 0.05, .to = 0.05, .step = 1};
        double ratio = Omega[i] / 2 / r.map.reference;
        struct map_rows rows;

        map_rows(&r.map, &t, &ratio, 1, 1, &rows);
        assert_int_equal(rows.status, SW_OK);
        assert_int_equal(rows.n, 1);
        print_message("# point %c: modulus %.6f\n", 'A' + i, rows.row[0].floquet.modulus);
        assert_true((rows.row[0].floquet.modulus > 1) == (i == 0));
        if (i == 0) {
            assert_int_equal(rows.row[0].floquet.crossing, CROSSING_2T);
            assert_int_equal(rows.row[0].floquet.mode, 0);
        }
        map_rows_free(&rows);
    }
    rope_end(&r);
}

/* Curves by multipliers lie on Bolotin's boundaries where those are the first to be met, also
 * without damping, where all multipliers below are 1 to round-off. */
static void trace(double damping)
{
    struct map_task t = {.floquet = 1, .trace = 1, .to = 0.08, .step = 0.0005};
    struct rope r;
    int points = 0;

    rope_begin(&seil2, LAW_THESIS, 10, 2, damping * ALPHA_2, damping * BETA_2, 1, &r);
    for (double ratio = 0.9; ratio < 1.25; ratio += 0.05) {
        struct boundary found[100];
        struct map_rows rows;
        struct parametric p;
        int n;

        map_rows(&r.map, &t, &ratio, 1, 1, &rows);
        assert_int_equal(rows.status, SW_OK);
        assert_int_equal(map_equations(&r.map, ratio, &p), SW_OK);
        assert_int_equal(bolotin_solve(&p, 2 * ratio * r.map.reference, 2, 21, 0.08, found, 100,
                                       &n),
                         SW_OK);
        assert_true((n > 0) == (rows.n > 0));
        if (n > 0) {
            near_abs(rows.row[0].amplitude, found[0].kappa, 1e-6 * found[0].kappa + 1e-8);
            points++;
        }
        parametric_free(&p);
        map_rows_free(&rows);
    }
    assert_true(points > 4);
    rope_end(&r);
}

static void traced(void **state)
{
    (void)state;

    trace(1);
    trace(0);
}

/* Lowest amplitude of a region at a ratio. */
static double region_at(const struct map *m, const struct map_row *region, double ratio)
{
    struct boundary found[400];
    struct parametric p;
    int n;

    assert_int_equal(map_equations(m, ratio, &p), SW_OK);
    assert_int_equal(bolotin_solve(&p, 2 * ratio * m->reference, region->period, 9, INFINITY, found,
                                   400, &n),
                     SW_OK);
    parametric_free(&p);
    for (int i = 0; i < n; i++)
        if (found[i].mode == region->boundary.mode && found[i].order == region->boundary.order)
            return found[i].kappa;
    return INFINITY;
}

/* Lowest points are those of a scan 200 times as fine around them; with all damping times the
 * factor the lowest point lies at the wanted amplitude. */
static void answers(void **state)
{
    struct map_task t = {.harmonics = 9, .to = 0.03};
    struct map_answer a[MAP_MOST_REGIONS];
    double step = 0.01, last = 0;
    struct rope r;
    int n;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 10, 2, ALPHA_2, BETA_2, 1, &r);
    assert_int_equal(map_answers(&r.map, &t, 0.4, step, 91, 1, a, &n), SW_OK);
    assert_true(n >= 2);
    for (int i = 0; i < n; i++) {
        const struct map_row *row = &a[i].row;
        double least = INFINITY, at = 0, lifted = INFINITY, wide;
        struct map harder = r.map;

        for (int k = -200; k <= 200; k++) {
            double here = region_at(&r.map, row, row->ratio + k * step / 200);

            if (here < least) {
                least = here;
                at = row->ratio + k * step / 200;
            }
        }
        print_message("# period %d mode %d order %d: %.7g m at %.6g (scan %.7g at %.6g), factor "
                      "%.6g\n",
                      row->period, row->boundary.mode + 1, row->boundary.order, row->amplitude,
                      row->ratio, least, at, a[i].factor);
        assert_true(row->amplitude >= last && row->amplitude <= t.to);
        last = row->amplitude;
        near_rel(row->Omega, 2 * row->ratio * r.map.reference, 1e-14);
        near_rel(row->amplitude, region_at(&r.map, row, row->ratio), 1e-12);
        assert_true(row->amplitude <= least * (1 + 1e-9));
        near_rel(row->amplitude, least, 1e-3);
        if (isnan(a[i].factor))
            continue;
        assert_true(a[i].factor >= 1);
        harder.alpha *= a[i].factor;
        harder.beta *= a[i].factor;
        harder.ground.alpha *= a[i].factor;
        harder.ground.beta *= a[i].factor;
        wide = 3 * step;
        for (int k = -600; k <= 600; k++)
            lifted = fmin(lifted, region_at(&harder, row, row->ratio + k * wide / 600));
        print_message("#   lifted to %.7g\n", lifted);
        near_rel(lifted, t.to, 1e-3);
    }
    rope_end(&r);
}

/* Without any damping there is nothing to raise. */
static void answers_undamped(void **state)
{
    struct map_task t = {.harmonics = 5, .to = 0.03};
    struct map_answer a[MAP_MOST_REGIONS];
    struct rope r;
    int n;
    (void)state;

    rope_begin(&seil2, LAW_THESIS, 8, 1, 0, 0, 0, &r);
    assert_int_equal(map_answers(&r.map, &t, 0.9, 0.01, 21, 1, a, &n), SW_OK);
    assert_int_equal(n, 1);
    below(a[0].row.amplitude, 1e-6);
    near_abs(a[0].row.ratio, 1, 1e-6);
    assert_true(isnan(a[0].factor));
    rope_end(&r);
}

static void memory_runs_out(void **state)
{
    static const double ratio[2] = {0.9, 1};
    struct model m;
    struct modes p;
    const int mode[2] = {0, 1};
    (void)state;

    assert_int_equal(model_new(&seil2, LAW_THESIS, 4, &m), SW_OK);
    assert_int_equal(modes_lowest(&m, 2, SOLVER_DENSE, &p), SW_OK);
    for (int job = 0; job < 5; job++) {
        struct map_task t = {.floquet = job == 1 || job == 2,
                             .trace = job == 2,
                             .harmonics = 3,
                             .to = 0.03,
                             .step = 0.015};
        unsigned long n = 0;
        enum status s;

        do {
            struct map map;

            mem_fail_at(++n);
            s = map_new(&m, &p, mode, 2, ALPHA_2, BETA_2, &map);
            if (s == SW_OK) {
                map.alpha = ALPHA_2;
                map.beta = BETA_2;
                map.reference = p.omega[0];
                map.b[3] = 1;
                map.quadratic = job == 3;
                if (job < 4) {
                    struct map_rows rows[2];

                    map_rows(&map, &t, ratio, 2, 1, rows);
                    for (int i = 0; i < 2; i++) {
                        if (s == SW_OK)
                            s = rows[i].status;
                        map_rows_free(&rows[i]);
                    }
                } else {
                    struct map_answer a[MAP_MOST_REGIONS];
                    int count;

                    s = map_answers(&map, &t, 0.9, 0.1, 2, 1, a, &count);
                }
                map_free(&map);
            }
            if (s != SW_OK && s != SW_NOMEM)
                print_message("# job %d, request %lu: %s\n", job, n, status_text(s));
            assert_true(s == SW_OK || s == SW_NOMEM);
        } while (s != SW_OK && n < 400);
        mem_fail_at(0);
        assert_true(n > 20);
    }
    modes_free(&p);
    model_free(&m);
}

TEST_MAIN(cmocka_unit_test(on_boundaries), cmocka_unit_test(combination),
          cmocka_unit_test(hill_agrees), cmocka_unit_test(up_and_aside),
          cmocka_unit_test(dragged_along), cmocka_unit_test(quadratic_boundaries),
          cmocka_unit_test(groups), cmocka_unit_test(published_points), cmocka_unit_test(traced),
          cmocka_unit_test(answers), cmocka_unit_test(answers_undamped),
          cmocka_unit_test(memory_runs_out))
