/* Nets when memory runs out: each request in turn, of each method and each kind of answer. */
#include "fails.h"
#include "nets.h"
#include "phys/attitude.h"
#include "phys/sea.h"

/* Two ropes and a bar at a loose node, in still air. */
struct fork {
    struct net_node node[4];
    struct net_rope rope[3];
    struct net net;
    struct net_options o;
};

static void fork_new(struct fork *f, enum net_method method)
{
    *f = (struct fork){.node = {at(0, 0, 0), at(10, 0, 0), at(5, 8, 0), loose(0, 0, -100)},
                       .rope = {rope(0, 3, 7, 1e5, 10, 0), rope(3, 1, 7, 1e5, 10, 3),
                                rope(2, 3, 7, 1e5, 10, 1)},
                       .o = exact};
    f->net = (struct net){.n = 4, .m = 3, .node = f->node, .rope = f->rope};
    f->o.method = method;
}

/* Solved, then its stiffness at the loose node: nothing is written but a whole one. */
static enum status solve_fork(void *context)
{
    struct fork *f = context;
    struct net_state s;
    const int chosen[1] = {3};
    double K[9];
    enum status status = net_solve(&f->net, &f->o, &s);

    for (int i = 0; i < 9; i++)
        K[i] = NAN;
    if (status == SW_OK)
        status = net_stiffness(&f->net, &s, chosen, 1, K);
    if (status == SW_OK) {
        assert_true(K[0] > 0 && K[4] > 0 && K[8] > 0);
        near_rel(K[1], K[3], 1e-6);
    }
    net_state_free(&s);
    return status;
}

static void dry(void **state)
{
    (void)state;
    for (int method = NET_GAP; method <= NET_IMAGINARY; method++) {
        struct fork f;

        fork_new(&f, method);
        if (method == NET_DISPLACEMENT) /* which takes no continuous ropes */
            f.rope[0].rope.elements = 3;
        if (method == NET_IMAGINARY) { /* which takes no bars, and wants ropes taut */
            f.rope[2].rope.elements = 0;
            f.node[3] = loose(0, 0, 5000);
            f.o = (struct net_options){.method = method, .tolerance = 1e-6, .steps = 100000};
        }
        assert_true(fails_each(solve_fork, &f) > 10);
    }
}

/* The same over a bed, which chains are split for, and in a current. */
static enum status solve_sea(void *context)
{
    struct fork *f = context;
    struct net_state s;
    struct net_outline outline;
    enum status status = net_solve(&f->net, &f->o, &s);

    if (status == SW_OK) {
        net_outline(&f->net, &s, 0, &outline);
        assert_true(outline.most >= outline.least && outline.length > 0);
    } else {
        assert_null(s.x);
        assert_null(s.fine);
    }
    net_state_free(&s);
    return status;
}

static void sea(void **state)
{
    static const double z[2] = {-10, 0}, u[2] = {0.1, 0.2}, v[2] = {0, 0};
    (void)state;

    for (int kind = 0; kind < 4; kind++) {
        struct fork f;
        struct sea around = {.bed = {.kind = BED_PLANE, .level = kind % 2 ? -100 : -1.5}};

        fork_new(&f, NET_GAP);
        f.rope[2].rope.elements = 0;
        for (int r = 0; r < 3; r++)
            f.rope[r].across = f.rope[r].along = 1;
        if (kind >= 2)
            around.current = (struct current){2, z, u, v};
        f.o.split = 3;
        f.net.sea = &around;
        assert_true(fails_each(solve_sea, &f) > 10);
    }
}

/* A raft on three legs; a second one beside it, tied to the first. */
#define LEGS 4

struct raft {
    struct net_node node[2 * LEGS + 2];
    struct net_rope rope[LEGS + 1];
    struct net_body body[2];
    struct net net;
    struct net_options o;
    struct raft *fresh; /* as it was */
};

static void raft_new(struct raft *f)
{
    *f = (struct raft){.o = exact};
    for (int b = 0; b < 2; b++) {
        f->body[b] = (struct net_body){.x = {b ? 30 : 0, 0, 0.1},
                                       .weight = 1e5,
                                       .lift = 1.2e5,
                                       .cg = {0, 0, -2},
                                       .area = 1e5,
                                       .level = 0};
        attitude_matrix((const double[3]){0, 0, 0}, f->body[b].R);
    }
    for (int i = 0; i < LEGS; i++) {
        double angle = 2 * PI * (i + 0.5) / LEGS;
        int b = cos(angle) > 0;

        f->node[2 * i] = at(15 + 100 * cos(angle), 100 * sin(angle), -30);
        f->node[2 * i + 1] =
            (struct net_node){.held = 7, .body = b + 1, .arm = {4 * cos(angle), 4 * sin(angle), 0}};
        f->rope[i] = rope(2 * i, 2 * i + 1, 96, 1e6, 50, 0);
    }
    f->node[2 * LEGS] = (struct net_node){.held = 7, .body = 1, .arm = {4, 0, 0}};
    f->node[2 * LEGS + 1] = (struct net_node){.held = 7, .body = 2, .arm = {-4, 0, 0}};
    f->rope[LEGS] = rope(2 * LEGS, 2 * LEGS + 1, 22, 1e6, 50, 0);
    f->net = (struct net){.n = 2 * LEGS + 2,
                          .m = LEGS + 1,
                          .node = f->node,
                          .rope = f->rope,
                          .bodies = 2,
                          .body = f->body};
    for (int b = 0; b < 2; b++)
        net_place_body(&f->net, b);
}

/* Each begins where the first began. */
static void raft_again(struct raft *f)
{
    memcpy(f->node, f->fresh->node, sizeof f->node);
    memcpy(f->rope, f->fresh->rope, sizeof f->rope);
    memcpy(f->body, f->fresh->body, sizeof f->body);
}

static enum status settle_raft(void *context)
{
    struct raft *f = context;
    struct net_state s;
    int chosen[LEGS], k = 0;
    double K[36];
    enum status status;

    raft_again(f);
    status = net_settle(&f->net, &f->o, &s);
    for (int i = 0; i < f->net.n; i++)
        if (f->node[i].body == 1)
            chosen[k++] = i;
    if (status == SW_OK)
        status = net_body_stiffness(&f->net, &s, chosen, k, f->body[0].x, K);
    if (status == SW_OK) {
        assert_true(s.adrift <= f->o.tolerance);
        for (int i = 0; i < 3; i++) /* levers turn: only displacements are symmetric */
            for (int j = 0; j < i; j++)
                near_abs(K[i + 6 * j], K[j + 6 * i], 1e-6 * fmax(K[7 * i], K[7 * j]));
    }
    net_state_free(&s);
    return status;
}

static enum status tune_raft(void *context)
{
    struct raft *f = context;
    const struct net_target target[2] = {{0, 1, 1.5e4, 0}, {1, 3, 1.6e4, -1}};
    struct net_state s;
    enum status status;

    raft_again(f);
    status = net_tune(&f->net, &f->o, target, 2, &s);
    if (status == SW_OK)
        for (int i = 0; i < 2; i++) {
            double ta[3], tb[3];

            net_ends(&f->net, &s, target[i].rope, ta, tb);
            near_rel(size(tb), target[i].tension, 1e-8);
        }
    net_state_free(&s);
    return status;
}

static void bodies(void **state)
{
    struct raft f, fresh;
    (void)state;

    raft_new(&f);
    fresh = f;
    f.fresh = &fresh;
    assert_true(fails_each(settle_raft, &f) > 20);
    f.body[0].held = f.body[1].held = fresh.body[0].held = fresh.body[1].held = 1;
    assert_true(fails_each(tune_raft, &f) > 20);
}

TEST_MAIN(cmocka_unit_test(dry), cmocka_unit_test(sea), cmocka_unit_test(bodies))
