/* Rigid bodies on moorings: rotations, stiffness by differences, balance, closed forms, wanted
 * tensions. */
#include "nets.h"
#include "num/vec3.h"
#include "phys/attitude.h"
#include "phys/sea.h"

#include <string.h>

#define LINES 3
#define NODES (3 * LINES)

/* Rotations are those of Rodrigues: orthogonal, undone, composed, and their vectors come back. */
static void rotations(void **state)
{
    uint64_t seed = 1;
    (void)state;

    for (int k = 0; k < 10000; k++) {
        double w[3], R[9], back[3], a[3] = {1, -2, 3}, b[3], c[3], l, s = k % 3 ? 1 : 1e-6;

        for (int i = 0; i < 3; i++)
            w[i] = s * uniform_in(&seed, -1.8, 1.8);
        l = size(w);
        attitude_matrix(w, R);
        attitude_vector(R, back);
        for (int i = 0; i < 3; i++) /* beyond pi it is the other way round */
            near_abs(back[i], l <= PI ? w[i] : w[i] * (1 - 2 * PI / l), 1e-12);
        mat3_apply(R, a, b);
        mat3_apply_t(R, b, c);
        near_abs(size(b), size(a), 1e-14);
        for (int i = 0; i < 3; i++)
            near_abs(c[i], a[i], 1e-14);
    }
    for (int axis = 0; axis < 3; axis++) { /* half a turn, where signs are lost first */
        double w[3] = {0, 0, 0}, R[9], back[3];

        w[axis] = PI;
        attitude_matrix(w, R);
        attitude_vector(R, back);
        near_abs(fabs(back[axis]), PI, 1e-12);
    }
    {
        const double x[3] = {PI / 2, 0, 0}, z[3] = {0, 0, PI / 2}, a[3] = {1, 0, 0};
        double R[9], b[3];

        attitude_matrix(z, R);
        attitude_turn(x, R); /* x -> y -> z */
        mat3_apply(R, a, b);
        near_abs(b[2], 1, 1e-15);
    }
}

/* A floater on three lines of two parts over a bed, turned about z by `turned`. */
struct floater {
    struct net_node node[NODES];
    struct net_rope rope[2 * LINES];
    struct net_body body[1];
    struct sea sea;
    struct net net;
};

static void floater(struct floater *f, double turned, double friction)
{
    const double upright[3] = {0, 0, turned};

    *f = (struct floater){.sea = {.bed = {.kind = BED_PLANE, .level = -100}}};
    f->body[0] = (struct net_body){.held = 1, .x = {0, 0, 0}};
    attitude_matrix(upright, f->body[0].R);
    for (int i = 0; i < LINES; i++) {
        double angle = turned + 2 * PI * i / LINES, own = 2 * PI * i / LINES;
        int anchor = 3 * i, middle = anchor + 1, top = anchor + 2;

        f->node[anchor] =
            (struct net_node){.held = 7, .x = {400 * cos(angle), 400 * sin(angle), -100}};
        f->node[middle] = (struct net_node){.x = {NAN, NAN, NAN}, .force = {0, 0, -2000}};
        f->node[top] =
            (struct net_node){.held = 7, .body = 1, .arm = {10 * cos(own), 10 * sin(own), -5 + i}};
        f->rope[2 * i] =
            (struct net_rope){.a = anchor,
                              .b = middle,
                              .friction = friction,
                              .rope = {.law = {.EA = 5e8}, .L0 = 250 + 5 * i, .q = {0, 0, -1500}}};
        f->rope[2 * i + 1] =
            (struct net_rope){.a = middle,
                              .b = top,
                              .friction = friction,
                              .rope = {.law = {.EA = 5e7}, .L0 = 163, .q = {0, 0, -100}}};
    }
    f->net = (struct net){.n = NODES,
                          .m = 2 * LINES,
                          .node = f->node,
                          .rope = f->rope,
                          .bodies = 1,
                          .body = f->body,
                          .sea = &f->sea};
    net_place_body(&f->net, 0);
}

/* What the lines do to the first body about a point fixed in space. */
static void forces(struct net *net, const double about[3], double lines[6])
{
    struct net_state s;
    double own[6];

    assert_int_equal(net_settle(net, &exact, &s), SW_OK);
    net_body_forces(net, &s, 0, about, lines, own);
    net_state_free(&s);
}

/* The first body moved with a point fixed to it that is at about, and turned round that. */
static void move_body(struct net *net, const double about[3], const double move[6])
{
    struct net_body *p = &net->body[0];
    double R[9], lever[3], moved[3];

    for (int c = 0; c < 3; c++)
        lever[c] = p->x[c] - about[c];
    attitude_turn(move + 3, p->R);
    attitude_matrix(move + 3, R);
    mat3_apply(R, lever, moved);
    for (int c = 0; c < 3; c++)
        p->x[c] = about[c] + moved[c] + move[c];
    net_place_body(net, 0);
}

/* K of the first body, by its k nodes chosen, against differences of the forces: within tolerance
 * of its largest. */
static void compare_stiffness(struct net *net, const int *chosen, int k, const double about[3],
                              double tolerance, double K[36], double most[2])
{
    struct net_body first = net->body[0];
    struct net_state s;

    assert_int_equal(net_settle(net, &exact, &s), SW_OK);
    assert_int_equal(net_body_stiffness(net, &s, chosen, k, about, K), SW_OK);
    net_state_free(&s);
    most[0] = most[1] = 0;
    for (int i = 0; i < 36; i++)
        most[(i % 6 >= 3) | (i / 6 >= 3)] = fmax(most[(i % 6 >= 3) | (i / 6 >= 3)], fabs(K[i]));
    for (int j = 0; j < 6; j++) {
        double h = j < 3 ? 1e-3 : 1e-5, force[2][6];

        for (int side = 0; side < 2; side++) {
            double move[6] = {0}, there[3];

            move[j] = side ? h : -h;
            for (int c = 0; c < 3; c++)
                there[c] = about[c] + move[c];
            net->body[0] = first;
            move_body(net, about, move);
            forces(net, there, force[side]);
        }
        for (int i = 0; i < 6; i++)
            near_abs(-(force[1][i] - force[0][i]) / (2 * h), K[i + 6 * j],
                     tolerance * most[i >= 3 || j >= 3]);
    }
    net->body[0] = first;
    net_place_body(net, 0);
}

/* 6 x 6 about any point, condensed on the free nodes, against differences of the forces; dead loads
 * make it symmetric but for the moment of the forces that hold the body, which is turned with it.
 */
static void stiffness(void **state)
{
    const double about[3] = {3, -2, 7};
    int chosen[LINES];
    (void)state;

    for (int rubs = 0; rubs < 2; rubs++) {
        struct floater f;
        double K[36], most[2];

        floater(&f, 0.3, rubs ? 0.6 : 0);
        for (int i = 0; i < LINES; i++)
            chosen[i] = 3 * i + 2;
        compare_stiffness(&f.net, chosen, LINES, about, 1e-5, K, most);
        for (int i = 0; i < 3 && !rubs; i++)
            for (int j = 0; j < 3; j++) {
                near_abs(K[i + 6 * j], K[j + 6 * i], 1e-9 * most[0]);
                near_abs(K[i + 6 * (3 + j)], K[3 + j + 6 * i], 1e-9 * most[1]);
            }
    }
}

/* A buoy between an anchor and a held body gives way and turns, with its own weight and buoyancy.
 */
static void stiffness_behind_a_buoy(void **state)
{
    const double about[3] = {38, 1, 3};
    const int chosen[1] = {3};
    struct net_node node[4] = {{.held = 7, .x = {0, 0, -50}},
                               {.held = 7, .body = 2, .arm = {0.3, 0.1, -1.5}},
                               {.held = 7, .body = 2, .arm = {1, -0.2, 0.2}},
                               {.held = 7, .body = 1, .arm = {-5, 0, -1}}};
    struct net_rope rope[2] = {
        {.a = 0, .b = 1, .rope = {.law = {.EA = 1e6}, .L0 = 51, .q = {0, 0, -20}}},
        {.a = 2, .b = 3, .rope = {.law = {.EA = 1e6}, .L0 = 36, .q = {0, 0, -20}}}};
    struct net_body body[2] = {{.held = 1, .x = {40, 2, 4}, .R = {1, 0, 0, 0, 1, 0, 0, 0, 1}},
                               {.x = {4, 0, 0},
                                .R = {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                .weight = 2e4,
                                .cg = {0, 0.1, -0.9},
                                .lift = 3e4,
                                .area = 2e4,
                                .cb = {0.2, 0.1, -0.7}}};
    struct net net = {.n = 4, .m = 2, .node = node, .rope = rope, .bodies = 2, .body = body};
    double K[36], most[2];
    (void)state;

    net_place_body(&net, 0);
    net_place_body(&net, 1);
    compare_stiffness(&net, chosen, 1, about, 1e-5, K, most);
}

/* Weight and buoyancy of a body that is turned: at its centres, buoyancy by how deep its own is. */
static void own_forces(void **state)
{
    const double w[3] = {0.4, -0.3, 0.2}, about[3] = {1, 2, 3}, zero[3] = {0, 0, 0};
    struct floater f;
    struct net_body *p = f.body;
    struct net_state s;
    double lines[6], own[6], g[3], b[3], up, tops;
    (void)state;

    floater(&f, 0, 0);
    f.sea.bed.level = -120;
    attitude_matrix(w, p->R);
    memcpy(p->x, (const double[]){4, -3, 2}, sizeof p->x);
    memcpy(p->cg, (const double[]){0.5, -0.2, 1}, sizeof p->cg);
    memcpy(p->cb, (const double[]){-1, 2, -3}, sizeof p->cb);
    p->weight = 5e5;
    p->lift = 3e5;
    p->area = 1e4;
    p->level = 6;
    net_place_body(&f.net, 0);
    assert_int_equal(net_settle(&f.net, &exact, &s), SW_OK);
    net_body_forces(&f.net, &s, 0, about, lines, own);
    mat3_apply(p->R, p->cg, g);
    mat3_apply(p->R, p->cb, b);
    for (int c = 0; c < 3; c++) {
        g[c] += p->x[c] - about[c];
        b[c] += p->x[c] - about[c];
    }
    up = 3e5 + 1e4 * (6 - (b[2] + about[2]));
    near_abs(own[0], 0, 0);
    near_abs(own[1], 0, 0);
    near_rel(own[2], up - 5e5, 1e-12);
    near_rel(own[3], b[1] * up - g[1] * 5e5, 1e-12); /* r x F of upward forces: (y, -x, 0) F */
    near_rel(own[4], -b[0] * up + g[0] * 5e5, 1e-12);
    near_abs(own[5], 0, 0);
    p->level = -1e3; /* out of the water nothing lifts it, and nothing draws it down */
    net_body_forces(&f.net, &s, 0, zero, lines, own);
    near_rel(own[2], -5e5, 0);
    tops = s.residual[3 * 2 + 2] + s.residual[3 * 5 + 2] + s.residual[3 * 8 + 2];
    near_rel(lines[2], tops, 1e-13);
    net_state_free(&s);
}

/* Turned as a whole about the vertical, forces turn with it. */
static void turned(void **state)
{
    const double zero[3] = {0, 0, 0};
    struct floater f, g;
    double a[6], b[6], R[9], w[3] = {0, 0, 1.1}, F[6];
    (void)state;

    floater(&f, 0, 0.4);
    floater(&g, 1.1, 0.4);
    f.body[0].x[0] = 4;
    g.body[0].x[0] = 4 * cos(1.1);
    g.body[0].x[1] = 4 * sin(1.1);
    net_place_body(&f.net, 0);
    net_place_body(&g.net, 0);
    forces(&f.net, zero, a);
    forces(&g.net, zero, b);
    attitude_matrix(w, R);
    mat3_apply(R, a, F);
    mat3_apply(R, a + 3, F + 3);
    for (int i = 0; i < 6; i++)
        near_abs(b[i], F[i], 1e-7 * (i < 3 ? size(a) : size(a + 3)));
}

/* A free floater comes to rest: what the lines do is what weight and buoyancy leave.  Its place is
 * one of equilibrium for a held one, too. */
static void floats(void **state)
{
    const double zero[3] = {0, 0, 0};
    struct floater f;
    struct net_state s;
    double lines[6], own[6], held[6];
    (void)state;

    floater(&f, 0, 0);
    f.body[0].held = 0;
    f.body[0].weight = 2e7;
    f.body[0].lift = 2.1e7;
    f.body[0].area = 1025 * 9.81 * 120.0;
    f.body[0].cg[2] = -8;
    f.body[0].cb[0] = 0.5;
    f.body[0].level = 0;
    assert_int_equal(net_settle(&f.net, &exact, &s), SW_OK);
    net_body_forces(&f.net, &s, 0, zero, lines, own);
    for (int i = 0; i < 6; i++)
        near_abs(lines[i] + own[i], 0, 2e7 * 1e-8 * (i < 3 ? 1 : s.size));
    net_state_free(&s);
    assert_true(fabs(f.body[0].x[2]) > 1e-3); /* it has moved */
    f.body[0].held = 1;
    forces(&f.net, zero, held);
    for (int i = 0; i < 6; i++)
        near_abs(held[i], lines[i], 2e7 * 1e-8 * (i < 3 ? 1 : 400));
}

/* A body on one rope hangs with its centre of gravity under its eye. */
static void plumb(void **state)
{
    struct net_node node[2] = {{.held = 7}, {.held = 7, .body = 1, .arm = {2, 1, 1}}};
    struct net_rope rope[1] = {
        {.a = 0, .b = 1, .rope = {.law = {.EA = 1e7}, .L0 = 20, .q = {0, 0, -10}}}};
    struct net_body body[1] = {{.x = {1, 2, -21}, .R = {1, 0, 0, 0, 1, 0, 0, 0, 1}, .weight = 5e4}};
    struct net net = {.n = 2, .m = 1, .node = node, .rope = rope, .bodies = 1, .body = body};
    struct net_state s;
    double arm = sqrt(6), stretch = (5e4 + 10 * 20 / 2.0) * 20 / 1e7;
    (void)state;

    net_place_body(&net, 0);
    assert_int_equal(net_settle(&net, &exact, &s), SW_OK);
    for (int c = 0; c < 2; c++) {
        near_abs(node[1].x[c], 0, 1e-6);
        near_abs(body[0].x[c], 0, 1e-6);
    }
    near_rel(body[0].x[2], -(20 + stretch + arm), 1e-9);
    net_state_free(&s);
}

/* Tensions at the fairleads by all three lengths at once, and by the anchors. */
static void tuned(void **state)
{
    (void)state;
    for (int by_anchor = 0; by_anchor < 2; by_anchor++) {
        struct floater f;
        struct net_target target[LINES];
        struct net_state s;

        floater(&f, 0, by_anchor ? 0 : 0.3);
        f.sea.bed.slope[0] = by_anchor ? 0.01 : 0;
        for (int i = 0; i < LINES; i++) {
            double *x = f.node[3 * i].x;

            x[2] = bed_at(&f.sea.bed, x[0], x[1], NULL);
            target[i] = by_anchor ? (struct net_target){2 * i, 3 * i + 1, 2.4e5 + 1e4 * i, 3 * i}
                                  : (struct net_target){2 * i + 1, 3 * i + 2, 2.6e5 + 1e4 * i, -1};
        }
        assert_int_equal(net_tune(&f.net, &exact, target, LINES, &s), SW_OK);
        for (int i = 0; i < LINES; i++) {
            const double *x = f.node[3 * i].x;
            double ta[3], tb[3];

            net_ends(&f.net, &s, target[i].rope, ta, tb);
            near_rel(size(tb), target[i].tension, 1e-8);
            near_abs(x[2], bed_at(&f.sea.bed, x[0], x[1], NULL), 1e-9);
        }
        net_state_free(&s);
    }
}

TEST_MAIN(cmocka_unit_test(rotations), cmocka_unit_test(stiffness),
          cmocka_unit_test(stiffness_behind_a_buoy), cmocka_unit_test(own_forces),
          cmocka_unit_test(turned), cmocka_unit_test(floats), cmocka_unit_test(plumb),
          cmocka_unit_test(tuned))
