/* Nets over a bed and in a current: closed forms, published numbers, methods against each other,
 * stiffness by differences, random moorings. */
#include "nets.h"
#include "phys/network.h"
#include "phys/sea.h"
#include "phys/touch.h"
#include "phys/voyage.h"

#include <string.h>

#define MOST 40 /* nodes of a test */

/* A chain of 410 m from an anchor to a fairlead 50 m above and 400 m away. */
struct one_chain {
    struct net_node node[2];
    struct net_rope rope[1];
    struct sea sea;
    struct net net;
};

static void one_chain(struct one_chain *c, int elements, double friction, double slope)
{
    double g = 9.80665, w = g * (390 - 1025 * PI / 4 * 0.252 * 0.252);

    *c = (struct one_chain){.node = {at(400, 0, -50), at(0, 0, 0)},
                            .rope = {rope(0, 1, 410, 1.674e9, w, elements)}};
    c->sea.bed = (struct bed){BED_PLANE, -50 - 400 * slope, {slope, 0}, 0, 0, NULL, NULL, NULL};
    c->rope[0].friction = friction;
    c->rope[0].across = 1025 * 1.37 * 0.252 / 2;
    c->rope[0].along = 1025 * 0.64 * PI * 0.252 / 2;
    c->net = (struct net){.n = 2, .m = 1, .node = c->node, .rope = c->rope, .sea = &c->sea};
}

static void ends_of(struct one_chain *c, const struct net_options *o, double *TA, double *TB)
{
    struct net_state s = solve(&c->net, o);
    double ta[3], tb[3];

    net_ends(&c->net, &s, 0, ta, tb);
    *TA = size(ta);
    *TB = size(tb);
    net_state_free(&s);
}

/* Chains converge to the closed form: level and sloping, with and without friction. */
static void chain_to_closed_form(void **state)
{
    static const double friction[3] = {0, 0.3, 1}, slope[3] = {0, -0.02, 0.03};
    (void)state;

    for (int i = 0; i < 9; i++) {
        struct one_chain c;
        double TA, TB, error[2], A, B;

        one_chain(&c, 0, friction[i / 3], slope[i % 3]);
        ends_of(&c, &exact, &TA, &TB);
        for (int k = 0; k < 2; k++) {
            one_chain(&c, 100 << 2 * k, friction[i / 3], slope[i % 3]);
            ends_of(&c, &exact, &A, &B);
            error[k] = fmax(fabs(A - TA), fabs(B - TB)) / TB;
        }
        below(error[0], 8e-3);
        below(error[1], error[0] / 3); /* where it touches down is known to an element */
    }
}

/* Friction helps the anchor, whichever end of the rope it is, and be it a little above the ground;
 * the fairlead is none: the forces of touch.h, pulled at the fairlead. */
static void friction_helps_the_anchor(void **state)
{
    static const double above[2] = {0, 2e-4}; /* of 403 m */
    (void)state;

    for (int k = 0; k < 8; k++) {
        struct touch_place p = {400, 0, {above[k / 4], 50}};
        double TA, TB;
        struct one_chain c;
        struct touch_rope r;
        struct touch t;

        one_chain(&c, 0, k % 2 ? 1 : 0.3, 0);
        c.node[0].x[2] += above[k / 4];
        r = (struct touch_rope){410, -c.rope[0].rope.q[2], 1.674e9, c.rope[0].friction,
                                TOUCH_PULLED_B};
        assert_int_equal(touch_solve(&r, &p, &t), SW_OK);
        if (k / 2 % 2) {
            c.rope[0].a = 1;
            c.rope[0].b = 0;
            ends_of(&c, &exact, &TB, &TA);
        } else {
            ends_of(&c, &exact, &TA, &TB);
        }
        near_rel(TA, hypot(t.H[0], t.V[0]), 1e-9);
        near_rel(TB, hypot(t.H[1], t.V[1]), 1e-9);
        assert_true(TA < 0.7 * TB); /* it does */
    }
}

/* The same chain in a current of 1 m/s over a bed without friction: a leading code's tensions. */
static void chain_in_current(void **state)
{
    static const struct {
        double u, v, TA, TB;
    } wanted[2] = {{-1, 0, 919.2e3, 983.6e3}, {0, 1, 852.9e3, 1018.9e3}};
    (void)state;

    for (int i = 0; i < 2; i++)
        for (int hold = 0; hold < 2; hold++) {
            static double found[2][2];
            const double z = 0;
            struct net_options o = exact;
            struct one_chain c;

            o.hold = hold;
            one_chain(&c, 0, 0, 0);
            c.sea.current = (struct current){1, &z, &wanted[i].u, &wanted[i].v};
            ends_of(&c, &o, &found[hold][0], &found[hold][1]);
            near_rel(found[hold][0], wanted[i].TA, 0.02);
            near_rel(found[hold][1], wanted[i].TB, 0.02);
            if (hold)
                for (int end = 0; end < 2; end++)
                    near_rel(found[1][end], found[0][end], 1e-8);
        }
}

/* Along what lies, two points are as far apart as the tension between them stretches it; of what
 * hangs, a little less, round its bend. */
static void points_on_the_bed(void **state)
{
    (void)state;

    for (int k = 0; k < 4; k++) {
        struct rope_point point[200];
        struct one_chain c;
        struct net_state s;
        int n, lying = 0;

        one_chain(&c, 0, k % 2 ? 0.3 : 0, 0);
        if (k / 2) { /* from the fairlead to the anchor */
            c.rope[0].a = 1;
            c.rope[0].b = 0;
        }
        s = solve(&c.net, &exact);
        n = net_points(&c.net, &s, 0, point);
        for (int i = 1; i < n; i++) {
            const struct rope_point *p = &point[i - 1], *q = &point[i];
            double z = s.x[3 * c.rope[0].a + 2], l = q->s - p->s, T = size(p->t), U = size(q->t);
            const double d[3] = {q->x[0] - p->x[0], q->x[1] - p->x[1], q->x[2] - p->x[2]};

            below(size(d), l * (1 + fmax(T, U) / 1.674e9) * (1 + 1e-12));
            assert_true(size(d) > 0.99 * l);
            if (z + p->x[2] < -50 + 1e-9 && z + q->x[2] < -50 + 1e-9) {
                near_rel(size(d), l * (1 + (T + U) / 2 / 1.674e9), 1e-12);
                lying++;
            }
        }
        assert_true(lying >= 4);
        net_state_free(&s);
    }
}

/* A weight on a rope that would hang below a slope rests on it, as low as the rope lets it: below
 * the foot of its upper end, by the rope's length in the plane; even if it hangs but a little too
 * low. */
static void weight_on_a_slope(void **state)
{
    const double L = 40, m = 0.3, steep = hypot(1, m);
    (void)state;

    for (int k = 0; k < 4; k++) {
        int across = k % 2;
        double depth = k / 2 ? 39.8 : 30, over = depth / steep;
        struct net_node node[2] = {at(100, 0, 0), loose(0, 0, -5e4)};
        struct net_rope part[1] = {rope(0, 1, L, 1e10, 0, 0)};
        struct sea sea = {.bed = {.kind = BED_PLANE, .level = -depth - 100 * m, .slope = {m, 0}}};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part, .sea = &sea};
        double down = sqrt(L * L - over * over) / steep;
        struct net_state s;

        if (across) {
            node[0] = at(0, 100, 0);
            sea.bed.slope[0] = 0;
            sea.bed.slope[1] = m;
        }
        s = solve(&net, &exact);
        near_abs(s.x[3 + across], 100 + over * m / steep - down, 1e-3);
        near_abs(s.x[3 + !across], 0, 1e-6);
        near_abs(s.x[5], -over / steep - m * down, 1e-3);
        assert_true(s.push[1] > 0);
        net_state_free(&s);
    }
}

/* Stretched length of a chain, as that of the continuous one. */
static void length_of_chains(void **state)
{
    struct net_outline line[2];
    (void)state;

    for (int k = 0; k < 2; k++) {
        struct one_chain c;
        struct net_state s;

        one_chain(&c, k ? 200 : 0, 0.3, 0);
        s = solve(&c.net, &exact);
        net_outline(&c.net, &s, 0, &line[k]);
        net_state_free(&s);
    }
    assert_true(line[0].length > 410.1);
    near_abs(line[1].length, line[0].length, 1e-3);
    near_abs(line[1].flat, line[0].flat, 410.0 / 200);
}

/* A rope that hangs clear beside one that lies: its points are ends of its pieces, all of it is as
 * without a bed; and so is the other, when the bed has gone. */
static void hangs_beside_one_that_lies(void **state)
{
    struct net_node node[3] = {at(400, 0, -50), at(0, 0, -1), at(30, 40, -5)};
    struct net_rope part[2] = {rope(0, 1, 410, 1.674e9, 3300, 0), rope(1, 2, 52, 1e7, 500, 0)};
    struct sea sea = {.bed = {.kind = BED_PLANE, .level = -50}};
    struct net net = {.n = 3, .m = 2, .node = node, .rope = part, .sea = &sea};
    struct net fresh = net;
    struct net_state s = solve(&net, &exact), dry;
    struct net_rope whole[2] = {rope(0, 1, 410, 1.674e9, 3300, 0), rope(1, 2, 52, 1e7, 500, 0)};
    struct net_outline line[2];
    struct rope_point point[200];
    double ta[3], tb[3], a[3], b[3];
    int n = net_points(&net, &s, 1, point);
    (void)state;

    fresh.rope = whole;
    fresh.sea = NULL;
    dry = solve(&fresh, &exact);
    net_ends(&net, &s, 1, ta, tb);
    net_ends(&fresh, &dry, 1, a, b);
    assert_true(n > 10);
    for (int k = 0; k < n; k++) {
        struct rope piece = part[1].rope;
        double chord[3];

        piece.L0 = point[k].s;
        piece.epsilon = 1e-9;
        rope_chord(&piece, a, chord, NULL);
        for (int c = 0; c < 3; c++) {
            near_abs(point[k].x[c], chord[c], 1e-8);
            near_abs(point[k].t[c], a[c] - piece.q[c] * point[k].s, 1e-8 * size(a));
        }
        near_rel(point[k].strain, size(point[k].t) / 1e7, 1e-12);
    }
    near_rel(point[n - 1].s, 52, 0);
    for (int c = 0; c < 3; c++) {
        near_abs(ta[c], a[c], 1e-8 * size(a));
        near_abs(tb[c], b[c], 1e-8 * size(b));
    }
    net_outline(&net, &s, 1, &line[0]);
    net_outline(&fresh, &dry, 1, &line[1]);
    near_rel(line[0].most, line[1].most, 1e-8);
    near_rel(line[0].length, line[1].length, 1e-8);
    near_rel(line[0].least, line[1].least, 1e-2); /* of its points */
    near_abs(line[0].lowest, line[1].lowest, 0.05);
    assert_true(line[1].lowest < -6);
    net_state_free(&s);
    net.sea = NULL;
    s = solve(&net, &exact);
    for (int i = 0; i < 12; i++)
        near_abs(s.end[i], dry.end[i], 1e-8 * size(dry.end + 3));
    net_state_free(&s);
    net_state_free(&dry);
}

/* A chain with a polyester rope above it, a free node between: where two codes put it. */
static void two_parts(void **state)
{
    double g = 9.81, area = 1025 * PI / 4;
    struct net_node node[3] = {at(-800, 0, -300), loose(0, 0, 0), at(0, 0, 0)};
    struct net_rope part[2] = {rope(0, 1, 500, 2e9, g * (200 - area * 0.04), 0),
                               rope(1, 2, 380, 30e6, g * (25 - area * 0.0225), 0)};
    struct sea sea = {.bed = {.kind = BED_PLANE, .level = -300}};
    struct net net = {.n = 3, .m = 2, .node = node, .rope = part, .sea = &sea};
    struct net_state s = solve(&net, &exact);
    struct net_outline line;
    double ta[3], tb[3];
    (void)state;

    near_abs(s.x[3], -315.464455, 1e-5);
    near_abs(s.x[4], 0, 1e-9);
    near_abs(s.x[5], -226.887736, 1e-5);
    net_ends(&net, &s, 0, ta, tb);
    near_rel(size(ta), 550966.23, 1e-7);
    near_rel(size(tb), 671279.931, 1e-7);
    net_outline(&net, &s, 0, &line);
    near_rel(line.flat, 267.041078, 1e-7);
    net_state_free(&s);
}

/* A light rope in cross flow: drag R cos^2 phi across it leaves the tension constant, tan phi = R
 * s/T: half the span is (T/R) asinh(R S/T).  Chains come near with order 2. */
static void cross_flow(void **state)
{
    const double R = 40, S = 60, T = 1500, u = 1, v = 0, z = 0;
    double X = T / R * asinh(R * S / T), sag = T / R * (hypot(1, R * S / T) - 1), error[3];
    (void)state;

    for (int k = 0; k < 3; k++) {
        struct net_node node[2] = {at(0, -X, -30), at(0, X, -30)};
        struct net_rope part[1] = {rope(0, 1, 2 * S, 1e12, 0, 20 << k)};
        struct sea sea = {.current = {1, &z, &u, &v}};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part, .sea = &sea};
        struct rope_point point[100];
        struct net_state s;
        double ta[3], tb[3];

        part[0].across = R;
        s = solve(&net, &exact);
        net_ends(&net, &s, 0, ta, tb);
        net_points(&net, &s, 0, point);
        near_abs(point[10 << k].x[0], sag, 0.01 * sag);
        error[k] = fabs(size(ta) / T - 1);
        net_state_free(&s);
    }
    below(error[2], 1e-4);
    near_rel(error[0] / error[1], 4, 0.1);
    near_rel(error[1] / error[2], 4, 0.1);
}

/* Points in a current: 0.5 rho CdA |U| U on a buoy that one rope holds. */
static void buoy_in_current(void **state)
{
    const double z[2] = {-100, 0}, u[2] = {0, 2}, v[2] = {0, 0};
    struct net_node node[2] = {at(0, 0, -100), loose(0, 0, 5000)};
    struct net_rope part[1] = {rope(0, 1, 50, 1e9, 0, 0)};
    struct sea sea = {.current = {2, z, u, v}};
    struct net net = {.n = 2, .m = 1, .node = node, .rope = part, .sea = &sea};
    struct net_state s;
    double U, drag;
    (void)state;

    node[1].drag = 1025 * 3.0 / 2;
    s = solve(&net, &exact);
    U = 2 * (1 + s.x[5] / 100);
    drag = 1025 * 3.0 / 2 * U * U;
    near_rel(s.x[3] / (s.x[5] + 100), drag / 5000, 1e-8); /* the rope points to the force */
    net_state_free(&s);
}

/* A grid of depths that is a plane is that plane. */
static void grid_is_plane(void **state)
{
    const double x[4] = {-100, 50, 130, 500}, y[3] = {-300, 10, 300};
    double z[12], TA, TB, A, B;
    struct one_chain c;
    (void)state;

    one_chain(&c, 80, 0.5, -0.02);
    ends_of(&c, &exact, &TA, &TB);
    for (int k = 0; k < 12; k++)
        z[k] = bed_at(&c.sea.bed, x[k % 4], y[k / 4], NULL);
    c.sea.bed = (struct bed){BED_GRID, 0, {0, 0}, 4, 3, x, y, z};
    ends_of(&c, &exact, &A, &B);
    near_rel(A, TA, 1e-8);
    near_rel(B, TB, 1e-8);
    one_chain(&c, 0, 0.5, -0.02); /* continuous ropes are split there */
    c.sea.bed = (struct bed){BED_GRID, 0, {0, 0}, 4, 3, x, y, z};
    ends_of(&c, &exact, &A, &B);
    near_rel(B, TB, 3e-3);
}

/* A ridge of a few metres under a rope that would hang clear of the bed beside it. */
static void ridge(void **state)
{
    const double x[5] = {-1000, 206, 210, 214, 1000}, y[2] = {-10, 10};
    const double z[10] = {-50, -50, -20, -50, -50, -50, -50, -20, -50, -50};
    struct net_node node[2] = {at(400, 0, -30), at(0, 0, 0)};
    struct net_rope part[1] = {rope(0, 1, 404, 1e9, 1000, 0)};
    struct sea sea = {.bed = {BED_GRID, 0, {0, 0}, 5, 2, x, y, z}};
    struct net net = {.n = 2, .m = 1, .node = node, .rope = part, .sea = &sea};
    struct net_state s = solve(&net, &exact);
    struct rope_point point[200];
    double push = 0;
    int n = net_points(&net, &s, 0, point);
    (void)state;

    for (int k = 0; k < n; k++) {
        double px = 400 + point[k].x[0];

        assert_true(-30 + point[k].x[2] > bed_at(&sea.bed, px, 0, NULL) - 1e-6);
        push += point[k].bed;
    }
    assert_true(push > 1000);
    net_state_free(&s);
}

/* Force on the held node i for its displacement: K by central differences. */
static void differences(struct net *net, int i, double h, double K[9])
{
    double keep[3], f[2][3];

    memcpy(keep, net->node[i].x, sizeof keep);
    for (int j = 0; j < 3; j++) {
        for (int side = 0; side < 2; side++) {
            struct net_state s;

            net->node[i].x[j] = keep[j] + (side ? h : -h);
            s = solve(net, &exact);
            for (int c = 0; c < 3; c++)
                f[side][c] = s.residual[3 * i + c];
            net_state_free(&s);
            net->node[i].x[j] = keep[j];
        }
        for (int c = 0; c < 3; c++)
            K[c + 3 * j] = -(f[1][c] - f[0][c]) / (2 * h);
    }
}

static void compare_stiffness(struct net *net, int i, double tolerance, int symmetric)
{
    struct net_state s = solve(net, &exact);
    double K[9], D[9], most = 0;

    assert_int_equal(net_stiffness(net, &s, &i, 1, K), SW_OK);
    net_state_free(&s);
    differences(net, i, 1e-3, D);
    for (int k = 0; k < 9; k++)
        most = fmax(most, fabs(K[k]));
    for (int k = 0; k < 9; k++)
        near_abs(K[k], D[k], tolerance * most);
    for (int k = 0; k < 9 && symmetric; k++)
        near_abs(K[k], K[k / 3 + 3 * (k % 3)], 1e-9 * most);
}

/* Dead loads: symmetric; friction, slopes across the rope and currents: not, but as it is. */
static void stiffness(void **state)
{
    const double z[2] = {-50, 0}, u[2] = {0.2, -1}, v[2] = {0, 0.8};
    struct one_chain c;
    (void)state;

    one_chain(&c, 0, 0, 0);
    compare_stiffness(&c.net, 1, 1e-6, 1);
    one_chain(&c, 0, 0.3, 0);
    compare_stiffness(&c.net, 1, 1e-6, 0);
    one_chain(&c, 0, 0.3, -0.02);
    c.sea.bed.slope[1] = 0.05;
    compare_stiffness(&c.net, 1, 1e-6, 0);
    one_chain(&c, 60, 0, 0);
    compare_stiffness(&c.net, 1, 1e-6, 1);
    one_chain(&c, 60, 0, 0);
    c.sea.current = (struct current){2, z, u, v};
    c.sea.bed.kind = BED_NONE;
    c.node[0].x[2] = -5;
    compare_stiffness(&c.net, 1, 1e-6, 0);
    one_chain(&c, 60, 0, 0);
    c.sea.current = (struct current){2, z, u, v};
    compare_stiffness(&c.net, 1, 1e-5, 0);
}

/* A clump on the bed between two chains: they leave it where it is, and it carries nothing. */
static void clump_on_bed(void **state)
{
    struct net_node node[3] = {at(300, 0, -50), loose(0, 0, -80000), at(0, 0, 0)};
    struct net_rope part[2] = {rope(0, 1, 150, 1e9, 1000, 0), rope(1, 2, 170, 1e9, 1000, 0)};
    struct sea sea = {.bed = {.kind = BED_PLANE, .level = -50}};
    struct net net = {.n = 3, .m = 2, .node = node, .rope = part, .sea = &sea};
    struct net_state s = solve(&net, &exact);
    double ta[3], tb[3];
    (void)state;

    near_abs(s.x[5], -50, 1e-6);
    net_ends(&net, &s, 1, ta, tb);
    near_abs(s.push[1], 80000 - ta[2], 1e-3); /* what the upper chain leaves of its weight */
    assert_true(ta[2] >= 0 && s.push[1] > 0);
    net_state_free(&s);
}

/* A weight that slack ropes leave to the bed: they carry next to nothing, it carries all, and the
 * bed's push is known to the last digit of its height only. */
static void weight_among_slack_ropes(void **state)
{
    static const double mass[] = {0.1, 20, 300, 20000, 1e6}, L0[] = {602, 610, 650, 900},
                        guess[] = {-60, -40, NAN};
    (void)state;

    for (int k = 0; k < 5 * 4 * 3 * 3 * 3; k++) {
        double weight = 9.81 * mass[k % 5];
        int legs = 1 + k / 20 % 3, elements = k / 180 == 2 ? 30 : 0;
        double w = k / 180 == 1 ? 1 : 1000;
        struct net_node node[4] = {at(600, 0, -60), at(-300, 519.615, -60), at(-300, -519.615, -60),
                                   loose(0, 0, -weight)};
        struct net_rope part[3];
        struct sea sea = {.bed = {.kind = BED_PLANE, .level = -60}};
        struct net net = {.n = 4, .m = legs, .node = node, .rope = part, .sea = &sea};
        struct net_state s;

        node[3].x[2] = guess[k / 60 % 3];
        for (int r = 0; r < legs; r++)
            part[r] = rope(r, 3, L0[k / 5 % 4], 5.1e8, w, elements);
        s = solve(&net, &exact);
        near_abs(s.x[11], -60, 1e-6);
        assert_true(s.push[3] >= weight * (1 - 1e-6));
        net_state_free(&s);
    }
}

/* What cannot touch, what only lies, what lifts: without a hint. */
static void extremes(void **state)
{
    struct sea sea = {.bed = {.kind = BED_PLANE, .level = -50}};
    (void)state;

    for (int kind = 0; kind < 12; kind++) {
        int elements = kind % 2 ? 40 : 0;
        struct net_node node[2] = {at(100, 0, -50), at(0, 0, kind / 2 == 1 ? -50 : 0)};
        struct net_rope part[1] = {rope(0, 1, 150, 1e8, 1000, elements)};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part, .sea = &sea};
        struct net_state s;

        if (kind / 2 == 0)
            node[0].x[0] = 1e-3; /* slack under its fairlead */
        if (kind / 2 == 1)
            part[0].rope.L0 = 99.9; /* all of it on the bed, taut */
        if (kind / 2 == 2)
            part[0].rope.q[2] = 300; /* buoyant */
        if (kind / 2 == 3)
            part[0].rope.L0 = 111; /* taut: clear of the bed */
        if (kind / 2 == 4)
            part[0].rope.L0 = 300; /* a heap */
        if (kind / 2 == 5)
            part[0].friction = 5;
        s = solve(&net, &exact);
        below(s.steps, 1000);
        net_state_free(&s);
    }
}

/* Forces at free nodes, summed anew; nodes and points above the bed, pushed where they touch. */
static double judge(const struct net *net, const struct net_state *s)
{
    double sum[3 * MOST] = {0}, most = 0, worst = 0;

    for (int i = 0; i < net->n; i++) {
        net_node_force(&net->node[i], s->x + 3 * i, sum + 3 * i, NULL);
        for (int c = 0; c < 3; c++)
            sum[3 * i + c] += s->drag[3 * i + c];
        sum[3 * i + 2] += s->push[i];
    }
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        struct rope_point point[200];
        int n = net_points(net, s, r, point);
        double ta[3], tb[3], half = p->rope.elements > 0 ? 0.5 / p->rope.elements : 0;

        if (!p->rope.elements && n > NET_POINTS)
            half = 0.5 / (n - 1);
        net_ends(net, s, r, ta, tb);
        for (int c = 0; c < 3; c++) {
            sum[3 * p->a + c] += ta[c] + half * p->rope.q[c] * p->rope.L0;
            sum[3 * p->b + c] += -tb[c] + half * p->rope.q[c] * p->rope.L0;
        }
        most = fmax(most, fmax(size(ta), size(tb)));
        for (int k = 0; k < n; k++) {
            double h = s->x[3 * p->a + 2] + point[k].x[2] - net->sea->bed.level;

            assert_true(h > -1e-7 * s->size && point[k].bed > -1e-6 * most);
            if (n > NET_POINTS && k > 0 && k < n - 1 && point[k].bed > 0)
                below(h, 1e-7 * s->size);
        }
    }
    for (int i = 0; i < 3 * net->n; i++)
        if (!(net->node[i / 3].held & 1 << i % 3))
            worst = fmax(worst, fabs(sum[i]) / s->scale);
    return worst;
}

/* Largest friction at a joint of split ropes beyond what C times the bed's push allows, over the
 * largest tension: what acts there besides weight, bed and the drag of its elements. */
static double beyond_coulomb(const struct net *net, const struct net_state *s)
{
    double worst = 0;

    for (int r = 0; r < net->m && s->fine; r++)
        for (int e = s->fine->split.first[r]; e < s->fine->split.first[r + 1] - 1; e++) {
            const struct net *fine = &s->fine->split.fine;
            const struct net_state *t = &s->fine->state;
            int joint = fine->rope[e].b;
            double f[3], slack = 0;

            memcpy(f, t->drag + 3 * joint, sizeof f);
            for (int k = 0; k < 2; k++) { /* the drag of both elements is taken off again */
                const struct net_rope *p = &fine->rope[e + k];
                const double *a = t->x + 3 * p->a, *b = t->x + 3 * p->b;
                double c[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, l = size(c), U[3], d[3];

                for (int i = 0; i < 3; i++)
                    c[i] /= l;
                current_at(&net->sea->current, (a[2] + b[2]) / 2, U, NULL);
                sea_drag(p->across, p->along, p->rope.L0, c, U, d);
                for (int i = 0; i < 3; i++)
                    f[i] -= d[i] / 2;
                if (size(t->end + 6 * (e + k)) <= 2e-6 * s->scale) /* its direction is its own */
                    slack += size(d);
            }
            worst = fmax(worst, size(f) - slack - 1.002 * fine->rope[e].friction * t->push[joint]);
        }
    return worst / s->scale;
}

/* Moorings of one to six lines, half of them of two parts with a float or clump between, up to a
 * tenth longer than the straight way. */
static void random_mooring(uint64_t *seed, int elements, double most_friction, struct net *net)
{
    double depth = -net->sea->bed.level, w = log_uniform(seed, 10, 1e4);
    int legs = 1 + (int)(6 * uniform(seed)), parts = uniform(seed) < 0.5 ? 1 : 2;
    double EA = w * log_uniform(seed, 1e4, 1e6);

    net->n = net->m = 0;
    for (int l = 0; l < legs; l++) {
        double angle = 2 * PI * l / legs, R = depth * uniform_in(seed, 0.3, 8);
        double top = -depth * uniform_in(seed, 0, 0.1), d = hypot(R - 5, top + depth);
        double L0 = d * uniform_in(seed, 1, 1.1), share = uniform_in(seed, 0.2, 0.8);
        int anchor = net->n, middle = anchor + 2;

        net->node[net->n++] = at(R * cos(angle), R * sin(angle), -depth);
        net->node[net->n++] = at(5 * cos(angle), 5 * sin(angle), top);
        if (parts == 2)
            net->node[net->n++] = loose(0, 0, w * L0 * uniform_in(seed, -0.3, 0.3));
        for (int k = 0; k < parts; k++) {
            struct net_rope *p = &net->rope[net->m++];

            *p = parts == 1 ? rope(anchor, anchor + 1, L0, EA, w, elements)
                 : k == 0   ? rope(anchor, middle, share * L0, EA, w, elements)
                            : rope(middle, anchor + 1, (1 - share) * L0, EA,
                                   w * (uniform(seed) < 0.3 ? 0.1 : 1), elements);
            p->friction = uniform_in(seed, 0, most_friction);
            p->across = uniform_in(seed, 0, 0.05) * w;
            p->along = uniform_in(seed, 0, 0.005) * w;
        }
    }
}

static void random_moorings(void **state)
{
    static const struct {
        const char *name;
        int elements, flows;
        double friction, solved; /* part of them that is, at the least */
    } kind[] = {{"continuous", 0, 0, 0, 1},
                {"with friction", 0, 0, 1, 0.97},
                {"chains", 30, 0, 0, 0.99},
                {"in a current", 30, 1, 0, 0.99},
                {"chains with friction", 30, 0, 1, 0.97},
                {"both", 30, 1, 1, 0.95}};
    const int N = 100;
    (void)state;

    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++) {
        uint64_t seed = 17;
        int solved = 0;
        double worst = 0, coulomb = 0;

        for (int i = 0; i < N; i++) {
            struct net_node node[MOST];
            struct net_rope part[MOST];
            double depth = log_uniform(&seed, 10, 300), z[2] = {-depth, 0};
            double u[2] = {0, uniform_in(&seed, 0, 2)}, v[2] = {0, uniform_in(&seed, -1, 1)};
            struct sea sea = {.bed = {.kind = BED_PLANE, .level = -depth}};
            struct net net = {.node = node, .rope = part, .sea = &sea};
            struct net_state s;

            if (kind[k].flows)
                sea.current = (struct current){2, z, u, v};
            random_mooring(&seed, kind[k].elements, kind[k].friction, &net);
            if (net_solve(&net, &exact, &s) == SW_OK) {
                solved++;
                worst = fmax(worst, judge(&net, &s));
                coulomb = fmax(coulomb, beyond_coulomb(&net, &s));
            }
            net_state_free(&s);
        }
        printf("# %s: %d of %d solved, unbalance %.2g, beyond Coulomb's law %.2g\n", kind[k].name,
               solved, N, worst, coulomb);
        below(coulomb, 1e-8);
        assert_true(solved >= kind[k].solved * N);
        below(worst, 1e-8);
    }
}

/* Drag [N] along x on an element of 1 m from the origin along y, across 3 and along 0.5 kg/m2, in a
 * current of 0.6 and 0.8 m/s along x and y, where the largest tension is 2000 N: its nodes' ropes
 * head along x where way is 1, the bed pushes with push. */
static double drag_of_element(const double way[2], double tension, const double push[2])
{
    double z = 0, u = 0.6, v0 = 0.8, x[6] = {0, 0, 0, 0, 1, 0}, t[3] = {0, tension, 0};
    double pushes[2] = {push[0], push[1]}, bar[3] = {0, tension, 0}, fresh[6], held[6] = {0};
    struct sea sea = {.current = {1, &z, &u, &v0}};
    struct net_node node[2] = {at(0, 0, 0), at(0, 1, 0)};
    struct net_rope r = rope(0, 1, 1, 1e6, 0, 1);
    struct net net = {.n = 2, .m = 1, .node = node, .rope = &r, .sea = &sea};
    struct net_state s = {.x = x, .t = t, .scale = 2000};
    struct voyage v = {.net = &net,
                       .o = &exact,
                       .w = {.push = pushes, .bar = bar, .hard = 1},
                       .s = &s,
                       .fresh = fresh,
                       .held = held};

    node[0].way[0] = way[0];
    node[1].way[0] = way[1];
    r.across = 3;
    r.along = 0.5;
    voyage_look(&v, NULL, 0, 0);
    return fresh[0] + fresh[3];
}

/* What lies slack has the heading of its rope, known at either end, and any other its own. */
static void slack_on_the_bed(void **state)
{
    static const double none[2] = {0, 0}, first[2] = {1, 0}, last[2] = {0, 1}, both[2] = {1, 1};
    double along = 0.5 * 0.6 * 0.6, across = 3 * 0.6 * 0.6; /* of the part along x */
    (void)state;

    near_rel(drag_of_element(both, 0, both), along, 1e-12);
    near_rel(drag_of_element(first, 0, both), along, 1e-12);
    near_rel(drag_of_element(last, 0, both), along, 1e-12);
    near_rel(drag_of_element(both, 0, first), along, 1e-12);
    near_rel(drag_of_element(both, 0, last), along, 1e-12);
    near_rel(drag_of_element(both, 1e-3, both), along, 1e-12);
    near_rel(drag_of_element(none, 0, both), across, 1e-12);
    near_rel(drag_of_element(both, 0, none), across, 1e-12);
    near_rel(drag_of_element(both, 3e-3, both), across, 1e-12);
}

TEST_MAIN(cmocka_unit_test(chain_to_closed_form), cmocka_unit_test(friction_helps_the_anchor),
          cmocka_unit_test(chain_in_current), cmocka_unit_test(points_on_the_bed),
          cmocka_unit_test(weight_on_a_slope), cmocka_unit_test(length_of_chains),
          cmocka_unit_test(hangs_beside_one_that_lies), cmocka_unit_test(two_parts),
          cmocka_unit_test(cross_flow), cmocka_unit_test(buoy_in_current),
          cmocka_unit_test(grid_is_plane), cmocka_unit_test(ridge), cmocka_unit_test(stiffness),
          cmocka_unit_test(clump_on_bed), cmocka_unit_test(slack_on_the_bed),
          cmocka_unit_test(weight_among_slack_ropes), cmocka_unit_test(extremes),
          cmocka_unit_test(random_moorings))
