/* Nets that have no answer within the steps that they may take, or none at all, and answers that
 * are found by detours; what is told of split ropes; the drag of nodes in the stiffness. */
#include "fails.h"
#include "nets.h"
#include "phys/attitude.h"
#include "phys/network.h"
#include "phys/sea.h"

/* Two bars longer than the way between their ends, pushed together: it hangs through in the end. */
static void toggle(void **state)
{
    struct net_node node[3] = {at(-1, 0, 0), at(1, 0, 0), loose(0, 0, -100)};
    struct net_rope bar[2] = {rope(0, 2, 1.1, 1e5, 0, 1), rope(2, 1, 1.1, 1e5, 0, 1)};
    struct net net = {.n = 3, .m = 2, .node = node, .rope = bar};
    struct net_state s;
    (void)state;

    node[2].x[0] = 0.01;
    node[2].x[1] = 0.02;
    node[2].x[2] = 0.4; /* above: both are pushed, and the node slips out sideways */
    s = solve(&net, &exact);
    near_abs(s.x[6], 0, 1e-9);
    near_abs(s.x[7], 0, 1e-9);
    below(s.x[8], -0.45);
    for (int r = 0; r < 2; r++) {
        double ta[3], tb[3];
        struct net_outline o;

        net_ends(&net, &s, r, ta, tb);
        near_abs(ta[2], r ? 50 : -50, 1e-6); /* half the load each */
        net_outline(&net, &s, r, &o);
        assert_true(o.least > 0 && o.length > 1.1);
    }
    net_state_free(&s);
}

/* Slack ropes at a loose node in few and in many steps: no convergence until there is, and then
 * the same answer. */
static void few_steps(void **state)
{
    struct net_state whole = {.x = NULL};
    int first = -1;
    (void)state;

    for (int steps = 400; steps >= 0; steps -= steps > 60 ? 340 : 1) {
        struct net_node node[4] = {at(0, 0, 0), at(10, 0, 0), at(5, 8, 0), loose(0, 0, -100)};
        struct net_rope part[3] = {rope(0, 3, 30, 1e7, 1e-3, 0), rope(3, 1, 6, 1e7, 1e-3, 4),
                                   rope(2, 3, 45, 1e7, 1e-3, 0)};
        struct net net = {.n = 4, .m = 3, .node = node, .rope = part};
        struct net_options o = exact;
        struct net_state s;
        enum status status;

        o.steps = steps;
        status = net_solve(&net, &o, &s);
        assert_true(s.steps <= steps);
        if (steps == 400) {
            assert_int_equal(status, SW_OK);
            whole = s;
            continue;
        }
        if (status == SW_OK) {
            assert_true(first < 0); /* what is enough once stays enough */
            for (int i = 0; i < 12; i++)
                near_abs(s.x[i], whole.x[i], 1e-6);
        } else {
            assert_int_equal(status, SW_NOCONV);
            first = first < 0 ? steps : first;
        }
        net_state_free(&s);
    }
    assert_true(first >= 0);
    net_state_free(&whole);
}

/* A raft on four legs, far from where it will float. */
#define LEGS 4

struct raft {
    struct net_node node[2 * LEGS];
    struct net_rope rope[LEGS];
    struct net_body body[1];
    struct net net;
};

static void raft_new(struct raft *f, double EA)
{
    *f = (struct raft){.body = {{.x = {20, 0, -4},
                                 .weight = 1e5,
                                 .lift = 1.2e5,
                                 .cg = {0, 0, -2},
                                 .area = 1e5,
                                 .level = 0}}};
    attitude_matrix((const double[3]){0.5, 0.2, 0.4}, f->body[0].R);
    for (int i = 0; i < LEGS; i++) {
        double angle = 2 * PI * (i + 0.5) / LEGS;

        f->node[2 * i] = at(100 * cos(angle), 100 * sin(angle), -30);
        f->node[2 * i + 1] =
            (struct net_node){.held = 7, .body = 1, .arm = {4 * cos(angle), 4 * sin(angle), 0}};
        f->rope[i] = rope(2 * i, 2 * i + 1, 102, EA, 50, 0);
    }
    f->net = (struct net){
        .n = 2 * LEGS, .m = LEGS, .node = f->node, .rope = f->rope, .bodies = 1, .body = f->body};
    net_place_body(&f->net, 0);
}

/* Bodies with few steps for each net: refused, or as well balanced as asked for. */
static void few_steps_of_bodies(void **state)
{
    int refused = 0, settled = 0;
    (void)state;

    for (int steps = 0; steps < 40; steps++) {
        struct raft f;
        struct net_options o = exact;
        struct net_state s;
        enum status status;

        raft_new(&f, 1e6);
        o.steps = steps;
        status = net_settle(&f.net, &o, &s);
        if (status == SW_OK) {
            assert_true(s.adrift <= o.tolerance);
            near_abs(f.body[0].x[0], 0, 1e-5);
            settled++;
        } else {
            assert_int_equal(status, SW_NOCONV);
            refused++;
        }
        net_state_free(&s);
    }
    assert_true(refused > 0 && settled > 0);
}

/* Wanted tensions with few steps, and tensions that no length brings. */
static void few_steps_of_tuning(void **state)
{
    int refused = 0, tuned = 0;
    (void)state;

    for (int steps = 0; steps < 40; steps++) {
        const struct net_target target[2] = {{0, 1, 4e4, 0}, {1, 3, steps % 2 ? 3e4 : 1e4, -1}};
        struct raft f;
        struct net_options o = exact;
        struct net_state s;
        enum status status;

        raft_new(&f, 1e6);
        f.body[0].held = 1;
        o.steps = steps;
        status = net_tune(&f.net, &o, target, 2, &s);
        if (status == SW_OK) {
            for (int i = 0; i < 2; i++) {
                double ta[3], tb[3];

                net_ends(&f.net, &s, i, ta, tb);
                near_rel(size(tb), target[i].tension, 1e-8);
            }
            tuned++;
        } else {
            assert_int_equal(status, SW_NOCONV);
            refused++;
        }
        net_state_free(&s);
    }
    assert_true(refused > 0 && tuned > 0);
}

/* A node that drags in a sheared current: the stiffness is the difference of the forces that hold
 * it. */
static void drag_of_nodes(void **state)
{
    static const double z[2] = {-20, 0}, u[2] = {0.2, 1.5}, v[2] = {0.3, -0.5};
    struct sea around = {.current = {2, z, u, v}};
    double K[9], f[2][3], h = 1e-4;
    const int chosen[1] = {2};
    (void)state;

    for (int j = -1; j < 3; j++)
        for (int side = 0; side < (j < 0 ? 1 : 2); side++) {
            struct net_node node[3] = {at(0, 0, -20), at(16, 3, -20), at(8, 1, -10)};
            struct net_rope part[2] = {rope(0, 2, 12.5, 1e5, 20, 0), rope(2, 1, 12.8, 1e5, 20, 0)};
            struct net net = {.n = 3, .m = 2, .node = node, .rope = part, .sea = &around};
            struct net_options o = exact;
            struct net_state s;

            o.split = 6;
            o.tolerance = 1e-12;
            node[2].drag = 500;
            part[0].across = part[1].across = 20;
            if (j >= 0)
                node[2].x[j] += side ? h : -h;
            s = solve(&net, &o);
            if (j < 0) {
                assert_int_equal(net_stiffness(&net, &s, chosen, 1, K), SW_OK);
                net_state_free(&s);
                continue;
            }
            for (int c = 0; c < 3; c++) /* what holds it is minus what is missing */
                f[side][c] = s.residual[6 + c];
            net_state_free(&s);
            if (side)
                for (int c = 0; c < 3; c++)
                    near_abs(K[c + 3 * j], (f[0][c] - f[1][c]) / (2 * h), 2e-4 * K[8]);
        }
}

/* Three ropes in a row over the bed, two joints on it that are free. */
static void joints_on_the_bed(void **state)
{
    struct sea around = {.bed = {.kind = BED_PLANE, .level = -10}};
    struct net_node node[4] = {at(0, 0, -10), loose(0, 0, -50), loose(0, 0, -50), at(90, 0, 0)};
    struct net_rope part[3] = {rope(0, 1, 30, 1e6, 100, 0), rope(1, 2, 30, 1e6, 100, 0),
                               rope(2, 3, 34, 1e6, 100, 0)};
    struct net net = {.n = 4, .m = 3, .node = node, .rope = part, .sea = &around};
    struct net_state s = solve(&net, &exact);
    double level[2];
    (void)state;

    near_abs(s.x[5], -10, 1e-3); /* it lies on the ground */
    near_abs(s.x[4], 0, 1e-6);
    for (int r = 0; r < 3; r++) {
        double ta[3], tb[3];

        net_ends(&net, &s, r, ta, tb);
        level[r > 0] = ta[0];
        if (r > 0)
            near_rel(level[1], level[0], 1e-6); /* no friction: H is one */
    }
    net_state_free(&s);
}

/* Over a bed, farther away than squares of numbers go: there is no answer. */
static void out_of_the_world(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct sea around = {.bed = {.kind = BED_PLANE, .level = -10}};
        struct net_node node[2] = {at(0, 0, -10), at(k == 0 ? 1e155 : 1e300, 0, 0)};
        struct net_rope part[1] = {rope(0, 1, 30, 1e6, 100, 0)};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part, .sea = &around};
        struct net_options o = exact;
        struct net_state s;
        enum status status;

        o.steps = 20;
        status = net_solve(&net, &o, &s);
        assert_true(status == SW_NOCONV || status == SW_INDEFINITE);
        net_state_free(&s);
    }
}

/* Elements of a split rope whose ends have come together have no drag to speak of: the stiffness
 * is made of numbers, or there is none. */
static void no_length(void **state)
{
    static const double z[1] = {0}, u[1] = {1}, v[1] = {0};
    struct sea around = {.current = {1, z, u, v}};
    struct net_node node[3] = {at(0, 0, -20), at(16, 3, -20), loose(0, 0, -100)};
    struct net_rope part[2] = {rope(0, 2, 12.5, 1e5, 20, 0), rope(2, 1, 12.8, 1e5, 20, 0)};
    struct net net = {.n = 3, .m = 2, .node = node, .rope = part, .sea = &around};
    struct net_options o = exact;
    const int chosen[1] = {2};
    struct net_state s;
    struct net_fine *fine;
    double K[9], *x;
    enum status status;
    (void)state;

    o.split = 3;
    part[0].across = part[1].across = 20;
    s = solve(&net, &o);
    fine = s.fine;
    assert_non_null(fine);
    x = fine->state.x;
    memcpy(x + 3 * fine->split.fine.rope[1].b, x + 3 * fine->split.fine.rope[1].a, 3 * sizeof *x);
    status = net_stiffness(&net, &s, chosen, 1, K);
    for (int i = 0; i < 9 && status == SW_OK; i++)
        assert_true(isfinite(K[i]));
    net_state_free(&s);
}

/* A chain across a slope touches where the bed is highest, seen from above: along x and along y. */
static void across_a_slope(void **state)
{
    double lowest[2];
    (void)state;

    for (int k = 0; k < 2; k++) {
        struct sea around = {
            .bed = {.kind = BED_PLANE, .level = -10, .slope = {k ? 0 : 0.25, k ? 0.25 : 0}}};
        struct net_node node[2] = {at(0, 0, 0), at(k ? 0 : 40, k ? 40 : 0, 3)};
        struct net_rope part[1] = {rope(0, 1, 43, 1e6, 100, 8)};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part, .sea = &around};
        struct net_state s = solve(&net, &exact);
        struct rope_point point[9];

        assert_non_null(s.fine); /* it was split, for it touches */
        lowest[k] = INFINITY;
        assert_int_equal(net_points(&net, &s, 0, point), 9);
        for (int i = 0; i < 9; i++)
            lowest[k] = fmin(lowest[k], point[i].x[2] + 10 - 0.25 * point[i].x[k]);
        near_abs(lowest[k], 0, 1e-3);
        net_state_free(&s);
    }
    near_abs(lowest[0], lowest[1], 1e-9);
}

/* Where memory runs out before anything else is known. */
static void refused(void **state)
{
    struct net_node node[2] = {at(0, 0, 0), at(10, 0, 0)};
    struct net_rope part[1] = {rope(0, 1, 12, 1e5, 10, 0)};
    struct net net = {.n = 2, .m = 1, .node = node, .rope = part};
    int is_rope, where;
    (void)state;

    for (unsigned long n = 1; n <= 2; n++) {
        mem_fail_at(n);
        assert_string_equal(net_refused(&net, &is_rope, &where), "memory ran out");
        assert_int_equal(mem_fail_at(0), 0);
    }
    assert_null(net_refused(&net, &is_rope, &where));
    part[0].rope.law.EA = NAN;
    assert_string_equal(net_refused(&net, &is_rope, &where), "its stiffness is not positive");
    assert_true(is_rope && where == 0);
}

/* The law of a bar without a table, and with one. */
static void laws(void **state)
{
    const double e[2] = {0.01, 0.02}, T[2] = {100, 400};
    const struct rope_law hooke = {.EA = 5e3}, table = {1e4, 2, e, T};
    double slope;
    (void)state;

    near_rel(rope_tension(&hooke, 0.02, &slope), 100, 1e-15);
    near_rel(slope, 5e3, 0);
    near_rel(rope_tension(&table, 0.015, &slope), 250, 1e-14);
    near_rel(slope, 3e4, 1e-14);
    near_rel(rope_tension(&table, 0.03, &slope), 700, 1e-14); /* by its last slope */
}

TEST_MAIN(cmocka_unit_test(toggle), cmocka_unit_test(few_steps),
          cmocka_unit_test(few_steps_of_bodies), cmocka_unit_test(few_steps_of_tuning),
          cmocka_unit_test(drag_of_nodes), cmocka_unit_test(joints_on_the_bed),
          cmocka_unit_test(out_of_the_world), cmocka_unit_test(no_length),
          cmocka_unit_test(across_a_slope), cmocka_unit_test(refused), cmocka_unit_test(laws))
