/* Ropes over a plane bed: the closed forms of theory c5, their answers put back into the equations
 * by quadrature, derivatives by differences, mirrored, and the limits. */
#include "check.h"
#include "phys/touch.h"

static struct touch solve(const struct touch_rope *r, const struct touch_place *p)
{
    struct touch t;

    assert_int_equal(touch_solve(r, p, &t), SW_OK);
    return t;
}

/* c5: where a rope leads that lies with L_B and carries H and V at its top. */
static void closed_form(const struct touch_rope *r, double LB, double H, double V, double *x,
                        double *z)
{
    double w = r->w, EA = r->EA, C = r->friction, T = hypot(H, V);
    double s0 = C > 0 ? fmin(LB, H / (C * w)) : LB;

    *x = LB + H / w * asinh(V / H) + H * (r->L0 - LB) / EA + (H * s0 - C * w * s0 * s0 / 2) / EA;
    *z = V * V / w * (1 / (T + H) + 1 / (2 * EA));
}

/* The forces that are found are put back: they lead to the same place. */
static void level_bed(void **state)
{
    uint64_t seed = 5;
    double worst = 0;
    (void)state;

    for (int k = 0; k < 20000; k++) {
        double L = uniform_in(&seed, 100, 1000), w = log_uniform(&seed, 10, 1e4);
        struct touch_rope r = {L, w, w * log_uniform(&seed, 1e3, 1e7),
                               k % 3 ? uniform_in(&seed, 0, 2) : 0, TOUCH_PULLED_B};
        double LB = L * uniform_in(&seed, 0.001, 1), H = w * L * log_uniform(&seed, 1e-6, 100);
        double V = w * (L - LB), x, z;
        struct touch_place p = {.h = {0, 0}};
        struct touch t;

        closed_form(&r, LB, H, V, &p.x, &p.h[1]);
        t = solve(&r, &p);
        assert_true(t.lies);
        closed_form(&r, t.flat, t.H[1], t.V[1], &x, &z);
        worst = fmax(worst, fmax(fabs(x - p.x), fabs(z - p.h[1])) / L);
        near_abs(t.T[0], fmax(0, t.H[1] - r.friction * w * t.flat), 1e-10 * hypot(H, V));
        near_abs(t.V[1] - w * (L - t.flat), 0, 1e-10 * w * L);
    }
    below(worst, 1e-13); /* round-off of sums of the length */
}

/* int (1/T + 1/EA)(H, V) ds of what hangs, by Simpson's rule in the arc of its slope, which takes
 * out the peak of 1/T. */
static void integrate(const struct touch_rope *r, double H, double V0, double s, double ret[2])
{
    double from = asinh(V0 / H), to = asinh((V0 + r->w * s) / H), h = (to - from) / 4000;

    ret[0] = ret[1] = 0;
    for (int k = 0; k <= 4000; k++) { /* ds = T du/w */
        double u = from + h * k, T = H * cosh(u), V = H * sinh(u);
        double f = h / 3 *
                   (k == 0 || k == 4000 ? 1
                    : k % 2             ? 4
                                        : 2) *
                   T / r->w * (1 / T + 1 / r->EA);

        ret[0] += f * H;
        ret[1] += f * V;
    }
}

/* From a to b along what was found: where it leads, over its length. */
static double walk(const struct touch_rope *r, const struct touch_place *p, const struct touch *t)
{
    double m = p->slope, c = 1 / hypot(1, m), x = 0, height = 0, end[2];
    double lies = t->flat - t->heap, stretch = 0;

    for (int i = 0; i < 2; i++) { /* each from the bed up and outwards */
        double sign = i == 0 ? -1 : 1, rise;

        if (!(t->s[i] > 0 && t->T[i] > 1e-9 * r->w * r->L0))
            continue;
        integrate(r, t->T[i] * c, t->T[i] * c * sign * m, t->s[i], end);
        rise = end[1] - sign * m * end[0];
        height = fmax(height, fabs(rise - p->h[i]));
        x += end[0];
    }
    for (int i = 0; i < 2; i++)
        stretch += t->reach[i] * (t->T[i] - t->fall[i] * t->reach[i] / 2) / r->EA;
    x += c * (lies + stretch);
    return fmax(fabs(x - p->x), height) / r->L0;
}

static struct touch_rope any_rope(uint64_t *seed)
{
    double w = log_uniform(seed, 10, 1e4);

    return (struct touch_rope){100, w, w * log_uniform(seed, 1e4, 1e7),
                               uniform(seed) < 0.4 ? 0 : uniform_in(seed, 0, 1.5),
                               (enum touch_pulled)(3 * uniform(seed))};
}

static struct touch_place any_place(uint64_t *seed)
{
    return (struct touch_place){uniform_in(seed, 20, 100),
                                uniform(seed) < 0.3 ? 0 : uniform_in(seed, -0.6, 0.6),
                                {uniform(seed) < 0.5 ? 0 : uniform_in(seed, 0.1, 30),
                                 uniform(seed) < 0.1 ? 0 : uniform_in(seed, 0.1, 40)}};
}

/* Slopes, friction from either end or none, ends that hang or lie. */
static void slopes(void **state)
{
    uint64_t seed = 7;
    double worst = 0;
    int lying = 0, pulls = 0, heaps = 0;
    (void)state;

    for (int k = 0; k < 3000; k++) {
        struct touch_rope r = any_rope(&seed);
        struct touch_place p = any_place(&seed);
        struct touch t = solve(&r, &p);
        int up = p.slope >= 0, hi;
        double c = 1 / hypot(1, p.slope), rate, pulled;

        if (!t.lies)
            continue;
        lying++;
        heaps += t.heap > 0;
        pulled = r.pulled == TOUCH_ALIKE ? 0 : (r.pulled == TOUCH_PULLED_B) == up ? 1 : -1;
        rate = r.w * (fabs(p.slope) * c + pulled * r.friction * c); /* fall from the upper end */
        hi = rate >= 0 ? up : !up;
        near_abs(t.T[!hi], fmax(0, t.T[hi] - fabs(rate) * t.flat), 1e-9 * r.w * r.L0);
        near_abs(t.s[0] + t.s[1] + t.flat, r.L0, 1e-12 * r.L0);
        if (t.T[hi] > 1e-6 * r.w * r.L0) { /* else it may lie anywhere */
            pulls++;
            worst = fmax(worst, walk(&r, &p, &t));
        }
    }
    assert_true(lying > 2000 && pulls > 400 && heaps > 20);
    below(worst, 1e-10);
}

/* All sixteen derivatives, where the rope does not change its kind. */
static void derivatives(void **state)
{
    uint64_t seed = 11;
    int compared = 0;
    (void)state;

    for (int k = 0; k < 4000; k++) {
        struct touch_rope r = any_rope(&seed);
        struct touch_place p = any_place(&seed);
        struct touch t = solve(&r, &p);
        double most = r.w;

        for (int i = 0; i < 16; i++)
            most = fmax(most, fabs(t.J[i / 4][i % 4]));
        for (int j = 0; j < 4; j++) {
            struct touch_place low = p, high = p;
            double h = j == 1 ? 1e-6 : 1e-5;
            struct touch a, b;

            if ((j >= 2 && p.h[j - 2] == 0) || (j == 1 && p.slope == 0))
                continue; /* a kink */
            *(j == 0 ? &low.x : j == 1 ? &low.slope : &low.h[j - 2]) -= h;
            *(j == 0 ? &high.x : j == 1 ? &high.slope : &high.h[j - 2]) += h;
            a = solve(&r, &low);
            b = solve(&r, &high);
            if (a.lies != b.lies || (a.heap > 0) != (b.heap > 0) || (a.T[0] > 0) != (b.T[0] > 0) ||
                (a.T[1] > 0) != (b.T[1] > 0))
                continue;
            for (int i = 0; i < 4; i++) {
                double change = i % 2 ? b.V[i / 2] - a.V[i / 2] : b.H[i / 2] - a.H[i / 2];

                near_abs(change / (2 * h), t.J[i][j], 3e-4 * most); /* curvature where it is taut */
            }
            compared++;
        }
    }
    assert_true(compared > 8000);
}

/* Seen from the other side. */
static void mirrored(void **state)
{
    uint64_t seed = 13;
    (void)state;

    for (int k = 0; k < 3000; k++) {
        struct touch_rope r = any_rope(&seed), other = r;
        struct touch_place p = any_place(&seed), q = {p.x, -p.slope, {p.h[1], p.h[0]}};
        struct touch t = solve(&r, &p), u;
        double T = hypot(t.H[0] + t.H[1], t.V[0] + t.V[1]);

        other.pulled = r.pulled == TOUCH_PULLED_A   ? TOUCH_PULLED_B
                       : r.pulled == TOUCH_PULLED_B ? TOUCH_PULLED_A
                                                    : TOUCH_ALIKE;
        u = solve(&other, &q);
        assert_int_equal(t.lies, u.lies);
        for (int i = 0; i < 2; i++) {
            near_abs(u.H[i], t.H[!i], 1e-8 * T); /* taut ropes: EA times round-off */
            near_abs(u.V[i], t.V[!i], 1e-8 * T);
        }
    }
}

/* A slack rope under its fairlead hangs by L_v = (EA/w)(sqrt(1 + 2 w z/EA) - 1); one that lies
 * whole carries EA times its strain, less friction. */
static void limits(void **state)
{
    struct touch_rope r = {100, 1000, 1e7, 0, TOUCH_PULLED_B};
    struct touch_place plumb = {0, 0, {0, 30}}, aside = {20, 0, {0, 30}},
                       flat = {100.05, 0, {0, 0}};
    double hanging = 1e7 / 1000 * (sqrt(1 + 2 * 1000 * 30 / 1e7) - 1);
    struct touch t;
    (void)state;

    t = solve(&r, &plumb);
    near_rel(t.V[1], 1000 * hanging, 1e-12);
    near_abs(t.H[1], 0, 1e-6);
    t = solve(&r, &aside);
    near_rel(t.V[1], 1000 * hanging, 1e-12);
    near_abs(t.H[1], 0, 1e-6);
    near_rel(t.flat, 100 - hanging, 1e-12);
    t = solve(&r, &flat);
    near_rel(t.H[1], 1e7 * 0.0005, 1e-9);
    near_rel(t.H[0], 1e7 * 0.0005, 1e-9);
    near_abs(t.V[1], 0, 0);
    r.friction = 0.1; /* H L/EA - C w L^2/(2 EA) = 0.05 */
    flat.x = 100.2;
    t = solve(&r, &flat);
    near_rel(t.H[1], (0.2 + 0.1 * 1000 * 100 * 100 / (2 * 1e7)) * 1e7 / 100, 1e-9);
    near_rel(t.H[0], t.H[1] - 0.1 * 1000 * 100, 1e-9);
}

/* A chain of 410 m in 50 m of water: anchor and fairlead tension, two codes and c5. */
static void real_chain(void **state)
{
    static const struct {
        double C, TA, TB, tolerance;
    } wanted[] = {{0, 835867.155, 1001995.22, 1e-8},
                  {0.5, 436286, 1006898, 2e-6},
                  {1, 38176, 1011804, 2e-5}};
    double w = 9.81 * (390 - 1025 * PI / 4 * 0.252 * 0.252);
    (void)state;

    for (size_t i = 0; i < 3; i++) {
        struct touch_rope r = {410, w, 1.674e9, wanted[i].C, TOUCH_PULLED_B};
        struct touch_place p = {400, 0, {0, 50}};
        struct touch t = solve(&r, &p);

        near_rel(t.T[0], wanted[i].TA, wanted[i].tolerance);
        near_rel(hypot(t.H[1], t.V[1]), wanted[i].TB, wanted[i].tolerance);
    }
}

TEST_MAIN(cmocka_unit_test(level_bed), cmocka_unit_test(slopes), cmocka_unit_test(derivatives),
          cmocka_unit_test(mirrored), cmocka_unit_test(limits), cmocka_unit_test(real_chain))
