/* Uniform loads: identities, symmetries, and the line in space against an integration of its own.
 */
#include "check.h"

#include "phys/load.h"

static const struct load none = {0};

struct hung {
    struct cable cable;
    struct axes axes;
    struct line line;
    double left[3], right[3]; /* tension as a vector towards the right end */
};

static void hang(const struct cable *c, const struct load *load, struct hung *ret)
{
    struct line_point end;

    load_apply(c, load, &ret->cable, &ret->axes);
    assert_int_equal(line_solve(&ret->cable, &ret->line), SW_OK);
    line_at(&ret->line, ret->cable.L0, &end);
    axes_to_space(&ret->axes, (double[3]){ret->line.H, ret->line.V, 0}, ret->left);
    axes_to_space(&ret->axes, (double[3]){ret->line.H, end.V, 0}, ret->right);
}

/* Any load, in a cable of which the wind may be as large as the weight; L0/chord 0.99 to 2. */
static void random_case(uint64_t *seed, struct cable *c, struct load *load)
{
    double chord = log_uniform(seed, 1, 1e3), angle = uniform_in(seed, -80, 80) * PI / 180;

    *c = (struct cable){.g = 9.81, .mu = log_uniform(seed, 1e-2, 1e3)};
    c->L0 = chord * (1 + log_uniform(seed, 1e-4, 1)) * (uniform(seed) < 0.2 ? 0.995 : 1);
    c->span = chord * cos(angle);
    c->drop = chord * sin(angle);
    c->EA = c->mu * c->g * c->L0 * log_uniform(seed, 1e2, 1e5);
    load->ice = c->mu * uniform_in(seed, 0, 1);
    for (int i = 0; i < 3; i++)
        load->wind[i] = c->mu * c->g * uniform_in(seed, -1, 1);
    load->temperature = uniform_in(seed, -60, 60);
    load->expansion = 1.2e-5;
}

/* Largest angle that keeps the load off the chord: along it no line exists. */
static int across_the_chord(const struct cable *c, const struct hung *h)
{
    return h->cable.span > 0.05 * line_chord(c);
}

/* To the last digit, however small the weight is. */
static void no_load_changes_nothing(void **state)
{
    uint64_t seed = 3;
    (void)state;

    for (int i = 0; i < 1000; i++) {
        struct cable given, c;
        struct load load;
        struct axes a;

        random_case(&seed, &given, &load);
        given.g = i % 2 ? 9.81 : 1e-300;
        load_apply(&given, &none, &c, &a);
        assert_memory_equal(&c, &given, sizeof c);
        assert_true(axes_are_plain(&a));
    }
    assert_true(load_is_calm(&none));
    assert_false(load_is_calm(&(struct load){.wind = {0, 0, -1}}));
}

static void ice_is_more_mass(void **state)
{
    const struct load ice = {.ice = 3.5};
    struct cable c, heavier = seil1;
    struct axes a;
    (void)state;

    heavier.mu += 3.5;
    load_apply(&seil1, &ice, &c, &a);
    assert_memory_equal(&c, &heavier, sizeof c);
    assert_true(axes_are_plain(&a));
}

static void wind_down_is_more_gravity(void **state)
{
    const struct load down = {.ice = 1, .wind = {0, 20, 0}};
    struct cable c, heavier = seil1;
    struct axes a;
    (void)state;

    heavier.mu += 1;
    heavier.g += 20 / heavier.mu;
    load_apply(&seil1, &down, &c, &a);
    near_rel(c.g, heavier.g, 1e-15);
    assert_true(c.mu == heavier.mu && c.L0 == heavier.L0 && c.span == heavier.span);
    assert_true(axes_are_plain(&a));
}

/* A warmer cable is a longer one of the same mass; cooled by as much it was shorter. */
static void temperature_is_another_length(void **state)
{
    const struct load warm = {.temperature = 40, .expansion = 1.2e-5, .ice = 2, .wind = {0, 0, 30}};
    struct load same = warm;
    struct cable longer = pont;
    struct hung a, b;
    (void)state;

    same.temperature = 0;
    longer.L0 *= 1 + 40 * 1.2e-5;
    longer.mu /= 1 + 40 * 1.2e-5;
    same.ice /= 1 + 40 * 1.2e-5;
    same.wind[2] /= 1 + 40 * 1.2e-5;
    hang(&pont, &warm, &a);
    hang(&longer, &same, &b);
    assert_true(a.cable.L0 > pont.L0);
    for (int i = 0; i < 3; i++) {
        near_abs(a.left[i], b.left[i], 1e-10 * a.left[0]); /* EA eps/H of the length's round-off */
        near_abs(a.right[i], b.right[i], 1e-10 * a.left[0]);
    }
    near_rel(load_cold_length(&warm, a.cable.L0), pont.L0, 1e-15);
    assert_true(load_cold_length(&none, 7) == 7);
}

static void axes_are_a_frame(void **state)
{
    uint64_t seed = 4;
    (void)state;

    for (int i = 0; i < 10000; i++) {
        double x[3], in[3], out[3], det, (*e)[3];
        struct cable c, ret;
        struct load load;
        struct axes a;

        random_case(&seed, &c, &load);
        load_apply(&c, &load, &ret, &a);
        if (!(ret.span > 1e-3 * line_chord(&c)))
            continue;
        e = a.e;
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                near_abs(e[j][0] * e[k][0] + e[j][1] * e[k][1] + e[j][2] * e[k][2], j == k,
                         1e-12); /* the chord's part across the load, 1e-3 of it */
        det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
              e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
              e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
        near_rel(det, 1, 1e-12);
        for (int j = 0; j < 3; j++)
            x[j] = uniform_in(&seed, -1, 1);
        axes_to_plane(&a, x, in);
        axes_to_space(&a, in, out);
        for (int j = 0; j < 3; j++)
            near_abs(out[j], x[j], 1e-12);
        axes_to_plane(&a, (double[3]){c.span, c.drop, 0}, in); /* both supports lie in the plane */
        near_abs(in[0], ret.span, 1e-12 * line_chord(&c));
        near_abs(in[1], ret.drop, 1e-12 * line_chord(&c));
        near_abs(in[2], 0, 1e-12 * line_chord(&c));
        near_rel(ret.mu * ret.L0, (c.mu + load.ice) * c.L0, 1e-15);
    }
}

/* x(theta) of the elastic catenary under the load p per metre with the tension t0 at the left end,
 * by Gauss' rule of four points on n pieces: dx = (1/|t| + 1/EA) t dtheta, t = t0 - p theta. */
static void integrate(const struct hung *h, const double p[3], int n, double ret[3])
{
    static const double node[] = {-0.86113631159405258, -0.33998104358485626, 0.33998104358485626,
                                  0.86113631159405258};
    static const double weight[] = {0.34785484513745386, 0.65214515486254614, 0.65214515486254614,
                                    0.34785484513745386};
    double length = h->cable.L0 / n;

    ret[0] = ret[1] = ret[2] = 0;
    for (int k = 0; k < 4 * n; k++) {
        double theta = length * (k / 4 + 0.5 + node[k % 4] / 2), t[3], T;

        for (int i = 0; i < 3; i++)
            t[i] = h->left[i] - p[i] * theta;
        T = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        for (int i = 0; i < 3; i++)
            ret[i] += weight[k % 4] * length / 2 * t[i] * (1 / T + 1 / h->cable.EA);
    }
}

/*
 * Force per metre from the loads by its definition, integrated: the cable ends at its right
 * support, and its end forces carry the whole load, in all three axes.
 */
static void line_in_space(void **state)
{
    uint64_t seed = 1827;
    int tried = 0;
    (void)state;

    while (tried < 2000) {
        struct cable c;
        struct load load;
        struct hung h;
        double x[3], p[3], chord, stretch;

        random_case(&seed, &c, &load);
        hang(&c, &load, &h);
        chord = line_chord(&c);
        stretch = 1 + load.expansion * load.temperature;
        if (!across_the_chord(&c, &h))
            continue; /* near the load's own direction the rule below would need more pieces */
        tried++;
        for (int i = 0; i < 3; i++)
            p[i] = (load.wind[i] + (i == 1 ? (c.mu + load.ice) * c.g : 0)) / stretch;
        integrate(&h, p, 1000, x);
        near_abs(x[0], c.span, 1e-11 * chord);
        near_abs(x[1], c.drop, 1e-11 * chord);
        near_abs(x[2], 0, 1e-11 * chord);
        for (int i = 0; i < 3; i++)
            near_abs(h.left[i] - h.right[i], p[i] * c.L0 * stretch,
                     1e-13 * (fabs(h.left[0]) + fabs(h.left[1]) + fabs(h.left[2])));
    }
}

/* Wind from the other side: the mirror image.  Supports exchanged: the reactions, too. */
static void mirrored(void **state)
{
    uint64_t seed = 99;
    (void)state;

    for (int i = 0; i < 1000; i++) {
        struct cable c, turned;
        struct load load, other;
        struct hung a, b;
        double size;

        random_case(&seed, &c, &load);
        other = load;
        other.wind[2] = -load.wind[2];
        hang(&c, &load, &a);
        hang(&c, &other, &b);
        size = 1e-10 * (hypot(a.line.H, a.line.V) + a.line.W); /* EA eps/T of 1e5 strains */
        for (int k = 0; k < 3; k++)
            near_abs(b.left[k], k == 2 ? -a.left[k] : a.left[k], size);
        turned = c;
        turned.drop = -c.drop;
        other = load;
        other.wind[0] = -load.wind[0];
        hang(&turned, &other, &b);
        near_abs(b.left[0], a.right[0], size);
        near_abs(b.left[1], -a.right[1], size);
        near_abs(b.left[2], -a.right[2], size);
    }
}

/* Level cable, wind across: it swings out by atan(wind/weight), in a plane like under more
 * gravity. */
static void swings_out(void **state)
{
    double weight = seil2.mu * seil2.g;
    const struct load side = {.wind = {0, 0, 2 * weight}};
    struct cable heavier = seil2;
    struct hung h;
    struct line s;
    (void)state;

    heavier.g *= sqrt(5);
    assert_int_equal(line_solve(&heavier, &s), SW_OK);
    hang(&seil2, &side, &h);
    near_rel(h.left[0], s.H, 1e-12);
    near_rel(h.left[1], s.V / sqrt(5), 1e-12);
    near_rel(h.left[2], 2 * s.V / sqrt(5), 1e-12);
    assert_true(!axes_are_plain(&h.axes));
}

/* Lifted by the wind, the cable is the mirror image of one that hangs; and without weight it hangs
 * in the wind alone. */
static void lifted(void **state)
{
    const struct cable c = {120, 2, 1e6, 9.81, 100, 20};
    const struct load up = {.wind = {0, -2 * 2 * 9.81, 0}};
    struct load alone = {.wind = {0, 0, -2 * 9.81}};
    struct cable mirror = c, weightless = c;
    struct hung a, b;
    (void)state;

    mirror.drop = -20;
    hang(&c, &up, &a);
    hang(&mirror, &none, &b);
    near_rel(a.left[0], b.left[0], 1e-13);
    near_rel(a.left[1], -b.left[1], 1e-13);
    near_abs(a.left[2], 0, 0);
    weightless.g = 0;
    hang(&weightless, &alone, &a);
    near_rel(a.cable.g, 9.81, 1e-15);
    near_abs(a.left[2], -9.81 * 120, 1e-10);
}

/* Balanced loads and loads along the chord leave nothing that could be solved; both are told by
 * the cable that comes out. */
static void degenerate(void **state)
{
    const struct load balanced = {.wind = {0, -seil1.mu * seil1.g, 0}};
    const struct load along = {.wind = {5, 0, 0}};
    const struct cable thirty_five = {421, 35, 2e8, 9.81, 380, 125};
    const struct load all_but = {.ice = 4, .wind = {0, -382.59, 0}};
    struct cable weightless = seil1, c;
    struct axes a;
    (void)state;

    load_apply(&seil1, &balanced, &c, &a);
    assert_true(c.g == 0 && axes_are_plain(&a));
    load_apply(&thirty_five, &all_but, &c, &a); /* 39*9.81 is no 382.59 */
    assert_true(c.g == 0 && axes_are_plain(&a));
    weightless.g = 0;
    load_apply(&weightless, &along, &c, &a);
    assert_true(!(c.span > 1e-9 * seil1.span));
}

TEST_MAIN(cmocka_unit_test(no_load_changes_nothing), cmocka_unit_test(ice_is_more_mass),
          cmocka_unit_test(wind_down_is_more_gravity),
          cmocka_unit_test(temperature_is_another_length), cmocka_unit_test(axes_are_a_frame),
          cmocka_unit_test(line_in_space), cmocka_unit_test(mirrored), cmocka_unit_test(swings_out),
          cmocka_unit_test(lifted), cmocka_unit_test(degenerate))
