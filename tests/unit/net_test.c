/* Systems of ropes: published numbers, closed forms, method against method, symmetry, random nets.
 */
#include "nets.h"

#include <string.h>

#define MOST 24    /* nodes of a test */
#define LONGEST 40 /* elements of a chain */

/* Largest length that elements of a chain lack although they pull, over the size: smoothed chords
 * must not hide slack pieces that carry something. */
static double lacking(const struct net *net, const struct net_state *s, int r, double most)
{
    const struct rope *p = &net->rope[r].rope;
    struct rope_point point[LONGEST + 1];
    double lacks = 0;

    if (p->elements < 2 || p->elements > LONGEST)
        return 0;
    rope_points(p, s->t + 3 * r, p->elements + 1, point);
    for (int k = 0; k < p->elements; k++) {
        const double *a = point[k].x, *b = point[k + 1].x, *t = point[k].t;
        double d = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);

        if (hypot(hypot(t[0], t[1]), t[2]) > 1e-8 * most)
            lacks = fmax(lacks, (1 + point[k].strain) * p->L0 / p->elements - d);
    }
    return lacks / s->size;
}

/* Largest force that is missing at a free node, by summing ends anew, over the largest tension; and
 * largest gap of a rope over the size. */
static void judge(const struct net *net, const struct net_state *s, double *unbalance, double *gap)
{
    double sum[3 * MOST] = {0}, most = 0, softest = INFINITY;

    *unbalance = *gap = 0;
    for (int i = 0; i < net->n; i++)
        net_node_force(&net->node[i], s->x + 3 * i, sum + 3 * i, NULL);
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        double ta[3], tb[3], end[3], chord[3];

        net_ends(net, s, r, ta, tb);
        rope_end_load(&p->rope, end);
        rope_chord(&p->rope, s->t + 3 * r, chord, NULL);
        for (int c = 0; c < 3; c++) {
            double open = s->x[3 * p->b + c] - s->x[3 * p->a + c] - chord[c];

            sum[3 * p->a + c] += ta[c] + end[c];
            sum[3 * p->b + c] += end[c] - tb[c];
            most = fmax(most, fmax(fabs(ta[c]), fabs(tb[c])));
            if (p->rope.elements != 1)
                *gap = fmax(*gap, fabs(open) / s->size);
        }
    }
    for (int r = 0; r < net->m; r++) /* nothing pulls: strains of 1e-5 are still something */
        softest = fmin(softest, net->rope[r].rope.law.EA);
    for (int r = 0; r < net->m; r++)
        *gap = fmax(*gap, lacking(net, s, r, fmax(most, 1e-5 * softest)));
    for (int i = 0; i < 3 * net->n; i++)
        if (!(net->node[i / 3].held & 1 << i % 3))
            *unbalance = fmax(*unbalance, fabs(sum[i]) / most);
}

/* The mooring of Bild 6: three legs, a closed triangle of ropes, three buoys. */
static struct net triangle(struct net_node node[6], struct net_rope part[6], int elements)
{
    for (int i = 0; i < 3; i++) {
        node[i] = at(100 * cos(2 * PI * i / 3), 100 * sin(2 * PI * i / 3), 0);
        node[3 + i] = loose(0, 0, 1.09 * 50 * 540 / 3);
        part[i] = rope(i, 3 + i, 120, 1e7, 50, elements);
        part[3 + i] = rope(3 + i, 3 + (i + 1) % 3, 60, 1e7, 50, elements);
    }
    return (struct net){.n = 6, .m = 6, .node = node, .rope = part};
}

static void triangle_mooring(void **state)
{
    struct net_node node[6];
    struct net_rope part[6];
    struct net net = triangle(node, part, 20);
    struct net_state s = solve(&net, &exact);
    (void)state;

    assert_true(s.steps <= 12);
    for (int i = 3; i < 6; i++) {
        near_abs(hypot(s.x[3 * i], s.x[3 * i + 1]), 30.198, 5e-4); /* as published, rounded */
        near_abs(s.x[3 * i + 2], 93.111, 5e-4);
    }
    /* quadratic at the end: a gap is the square of the one before, times a constant */
    for (int k = 3; k < s.steps; k++)
        if (s.step[k].mean_gap > 1e-8)
            below(s.step[k + 1].mean_gap, 30 * s.step[k].mean_gap * s.step[k].mean_gap);
    net_state_free(&s);
}

/* Classic: the joint of a cable moves by (-0.859365, -5.625616) m under 35585.77 N. */
static void point_load_cable(void **state)
{
    const double EA = 131.0004e9 * 5.48386e-4, w = 46.11656;
    double x[2][3];
    (void)state;

    for (int loaded = 0; loaded < 2; loaded++) {
        struct net_node node[3] = {at(0, 0, 0), loose(0, 0, loaded ? -35585.77 : 0),
                                   at(304.8, 0, 0)};
        struct net_rope part[2] = {rope(0, 1, 125.84695, EA, w, 0),
                                   rope(1, 2, 186.85526, EA, w, 0)};
        struct net net = {.n = 3, .m = 2, .node = node, .rope = part};
        struct net_state s = solve(&net, &exact);

        memcpy(x[loaded], s.x + 3, sizeof x[loaded]);
        net_state_free(&s);
    }
    near_abs(x[1][0] - x[0][0], -0.859365, 1e-5);
    near_abs(x[1][2] - x[0][2], -5.625616, 1e-5);
}

static double apart(const struct net_state *a, const struct net_state *b, int n)
{
    double most = 0;

    for (int i = 0; i < 3 * n; i++)
        most = fmax(most, fabs(a->x[i] - b->x[i]));
    return most;
}

/* The three methods where all apply; displacement also on a closed system. */
static void methods_agree(void **state)
{
    struct net_node node[6],
        tree[4] = {at(0, 0, 0), at(100, 0, 0), at(40, 80, 5), loose(0, 0, 9000)};
    struct net_rope part[6], leg[3];
    struct net closed = triangle(node, part, 10),
               open = {.n = 4, .m = 3, .node = tree, .rope = leg};
    struct net_options o = exact;
    struct net_state s = solve(&closed, &o), t;
    (void)state;

    o.method = NET_DISPLACEMENT;
    t = solve(&closed, &o);
    below(apart(&s, &t, 6), 1e-8 * s.size);
    net_state_free(&t);
    o.method = NET_IMAGINARY;
    assert_int_equal(net_solve(&closed, &o, &t), SW_ADMISSIBLE); /* it has a closed part */
    net_state_free(&t);
    net_state_free(&s);
    for (int i = 0; i < 3; i++)
        leg[i] = rope(i, 3, 100 + 5 * i, 1e6, 20, 12);
    s = solve(&open, &exact);
    for (int method = 0; method < 4; method++) {
        o = (struct net_options){.method = method < 3 ? NET_IMAGINARY : NET_DISPLACEMENT,
                                 .pull = (enum net_pull)(method % 3),
                                 .tolerance = 1e-10,
                                 .steps = 100000};
        t = solve(&open, &o);
        below(apart(&s, &t, 4), 1e-8 * s.size);
        net_state_free(&t);
    }
    net_state_free(&s);
}

/* Other stiffness in the first steps: another way, the same place. */
static void other_starts(void **state)
{
    struct net_node node[6];
    struct net_rope part[6];
    struct net net = triangle(node, part, 20);
    struct net_state s = solve(&net, &exact), t;
    (void)state;

    for (int start = NET_CLOSED; start <= NET_FICTITIOUS; start++) {
        struct net_options o = exact;

        o.start = (enum net_stiffness)start;
        o.start_steps = 6;
        t = solve(&net, &o);
        below(apart(&s, &t, 6), 1e-8 * s.size);
        assert_true(t.steps >= 6);
        net_state_free(&t);
    }
    net_state_free(&s);
}

/* Stiffness of two nodes: symmetric, and the derivative of the forces that hold them. */
static void stiffness_by_differences(void **state)
{
    const int chosen[2] = {0, 4};
    struct net_node node[6], keep[6];
    struct net_rope part[6];
    struct net net = triangle(node, part, 8);
    struct net_state s = solve(&net, &exact);
    double K[36], most = 0;
    (void)state;

    assert_int_equal(net_stiffness(&net, &s, chosen, 2, K), SW_OK);
    for (int i = 0; i < 36; i++) {
        most = fmax(most, fabs(K[i]));
        near_abs(K[i], K[i % 6 * 6 + i / 6], 1e-9 * 400);
    }
    memcpy(keep, node, sizeof keep);
    for (int j = 0; j < 6; j++) {
        double f[2][6], h = 1e-4;

        for (int side = 0; side < 2; side++) {
            struct net_state t;

            memcpy(node, keep, sizeof keep);
            for (int c = 0; c < 2; c++)
                node[chosen[c]] =
                    at(s.x[3 * chosen[c]], s.x[3 * chosen[c] + 1], s.x[3 * chosen[c] + 2]);
            node[chosen[j / 3]].x[j % 3] += side ? h : -h;
            t = solve(&net, &exact);
            for (int i = 0; i < 6; i++)
                f[side][i] = -t.residual[3 * chosen[i / 3] + i % 3];
            net_state_free(&t);
        }
        for (int i = 0; i < 6; i++)
            near_abs((f[1][i] - f[0][i]) / (2 * h), K[i + 6 * j], 1e-5 * most);
    }
    net_state_free(&s);
}

/* Force and moment that hold a body of nodes 3, 4, 5, moved by y from where s has them: along and
 * about the axes of a point that goes with it. */
static void hold_body(struct net *net, const struct net_state *s, const double about[3],
                      const double y[6], double ret[6])
{
    struct net_node *node = net->node;
    struct net_state t;
    double angle = sqrt(y[3] * y[3] + y[4] * y[4] + y[5] * y[5]), lever[3][3];

    for (int i = 0; i < 3; i++) {
        const double *x = s->x + 3 * (3 + i),
                     r[3] = {x[0] - about[0], x[1] - about[1], x[2] - about[2]};
        double dot = 0;

        memcpy(lever[i], r, sizeof lever[i]);
        for (int c = 0; c < 3 && angle > 0; c++)
            dot += r[c] * y[3 + c] / angle;
        for (int c = 0; c < 3 && angle > 0; c++) { /* Rodrigues */
            double n = y[3 + c] / angle;
            double cross =
                (y[3 + (c + 1) % 3] * r[(c + 2) % 3] - y[3 + (c + 2) % 3] * r[(c + 1) % 3]) / angle;

            lever[i][c] = r[c] * cos(angle) + cross * sin(angle) + n * dot * (1 - cos(angle));
        }
        node[3 + i] = at(about[0] + y[0] + lever[i][0], about[1] + y[1] + lever[i][1],
                         about[2] + y[2] + lever[i][2]);
        node[3 + i].force[2] = 1.09 * 50 * 540 / 3;
    }
    t = solve(net, &exact);
    memset(ret, 0, 6 * sizeof *ret);
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++) {
            const double *p = t.residual + 3 * (3 + i), *r = lever[i];

            ret[c] -= p[c];
            ret[3 + c] -= r[(c + 1) % 3] * p[(c + 2) % 3] - r[(c + 2) % 3] * p[(c + 1) % 3];
        }
    net_state_free(&t);
}

/* Stiffness of a rigid body about a point off its middle, under the forces that hold it away from
 * rest. */
static void body_by_differences(void **state)
{
    const int chosen[3] = {3, 4, 5};
    const double about[3] = {4, -7, 80};
    struct net_node node[6];
    struct net_rope part[6];
    struct net net = triangle(node, part, 6);
    struct net_state s;
    double K[36], most[2][2] = {{0}};
    (void)state;

    for (int i = 3; i < 6; i++) { /* held off its place: forces and moments act */
        node[i] = at(30 * cos(2 * PI * i / 3) + 5, 30 * sin(2 * PI * i / 3), 90);
        node[i].force[2] = 1.09 * 50 * 540 / 3;
    }
    s = solve(&net, &exact);
    assert_int_equal(net_body_stiffness(&net, &s, chosen, 3, about, K), SW_OK);
    for (int i = 0; i < 36; i++)
        most[i % 6 / 3][i / 18] = fmax(most[i % 6 / 3][i / 18], fabs(K[i]));
    for (int j = 0; j < 6; j++) {
        double f[2][6], h = j < 3 ? 1e-3 : 1e-5;

        for (int side = 0; side < 2; side++) {
            double y[6] = {0};

            y[j] = side ? h : -h;
            hold_body(&net, &s, about, y, f[side]);
        }
        for (int i = 0; i < 6; i++)
            near_abs((f[1][i] - f[0][i]) / (2 * h), K[i + 6 * j], 1e-5 * most[i / 3][j / 3]);
    }
    net_state_free(&s);
}

/* Mirrored, turned and renumbered input gives mirrored, turned and renumbered output. */
static void symmetries(void **state)
{
    struct net_node node[5] = {at(0, 0, 0), at(80, 10, 5), loose(100, 0, -500), loose(0, 50, 300),
                               at(20, 70, -3)},
                    turned[5], shuffled[5];
    struct net_rope part[5] = {rope(0, 2, 50, 1e6, 8, 0), rope(2, 1, 45, 1e6, 8, 6),
                               rope(2, 3, 30, 2e6, -4, 0), rope(3, 4, 60, 1e6, 8, 9),
                               rope(3, 0, 75, 1e6, 2, 0)},
                    other[5];
    static const int order[5] = {3, 0, 4, 2, 1};
    struct net net = {.n = 5, .m = 5, .node = node, .rope = part},
               second = {.n = 5, .m = 5, .node = turned, .rope = part},
               third = {.n = 5, .m = 5, .node = shuffled, .rope = other};
    struct net_state s = solve(&net, &exact), t;
    double c = cos(0.7), d = sin(0.7);
    (void)state;

    for (int mirror = 0; mirror < 2; mirror++) {
        double sign = mirror ? -1 : 1;

        for (int i = 0; i < 5; i++) {
            const double *x = node[i].x, *f = node[i].force;

            turned[i] = node[i];
            turned[i].x[0] = c * x[0] - d * x[1];
            turned[i].x[1] = sign * (d * x[0] + c * x[1]);
            turned[i].force[0] = c * f[0] - d * f[1];
            turned[i].force[1] = sign * (d * f[0] + c * f[1]);
        }
        t = solve(&second, &exact);
        for (int i = 0; i < 5; i++) {
            const double *x = s.x + 3 * i;

            near_abs(t.x[3 * i], c * x[0] - d * x[1], 1e-10 * s.size);
            near_abs(t.x[3 * i + 1], sign * (d * x[0] + c * x[1]), 1e-10 * s.size);
            near_abs(t.x[3 * i + 2], x[2], 1e-10 * s.size);
        }
        net_state_free(&t);
    }
    for (int i = 0; i < 5; i++) /* nodes and ropes in another order, ropes from b to a */
        shuffled[order[i]] = node[i];
    for (int r = 0; r < 5; r++) {
        other[order[r]] = part[r];
        other[order[r]].a = order[part[r].b];
        other[order[r]].b = order[part[r].a];
    }
    t = solve(&third, &exact);
    for (int i = 0; i < 15; i++)
        near_abs(t.x[3 * order[i / 3] + i % 3], s.x[i], 1e-10 * s.size);
    net_state_free(&s);
    net_state_free(&t);
}

/* Bars: a frame of two under a load, one pulled and one pushed, against statics. */
static void bars_push(void **state)
{
    struct net_node node[3] = {at(0, 0, 0), at(0, 0, 3), loose(0, 0, -1000)};
    struct net_rope part[2] = {rope(0, 2, 4, 1e9, 0, 1), rope(1, 2, 5, 1e9, 0, 1)};
    struct net net = {.n = 3, .m = 2, .node = node, .rope = part};
    struct net_state s;
    (void)state;

    node[2].x[0] = 4; /* a bar needs to know on which side */
    node[2].x[1] = node[2].x[2] = 0;
    node[2].held = 2; /* nothing holds it sideways */
    s = solve(&net, &exact);
    near_abs(s.x[6], 4, 1e-4);
    near_abs(s.x[8], 0, 1e-4);
    near_abs(s.t[0], -1000 * 4 / 3.0, 0.1); /* pushed: the bar presses the wall */
    near_abs(s.t[3], 1000 * 4 / 3.0, 0.1);
    near_abs(s.t[5], -1000, 0.1);
    net_state_free(&s);
}

/* A float that pierces the surface draws what its load asks for; one that is pulled under lifts
 * with all it has; one that is too light for its load floats out. */
static void floats(void **state)
{
    static const double load[3] = {-4000, -50000, 2000};
    (void)state;

    for (int k = 0; k < 3; k++) {
        struct net_node node[2] = {at(0, 0, -30), loose(0, 0, load[k])};
        struct net_rope part[1] = {rope(0, 1, k == 1 ? 20 : 40, 1e6, 10, 0)};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part};
        struct net_state s;
        double lift;

        node[1].area = 10000; /* N per metre of depth */
        node[1].height = 3;
        s = solve(&net, &exact);
        lift = 10000 * fmin(fmax(-s.x[5], 0), 3);
        if (k == 0) /* the rope hangs below: the float carries its part of the weight */
            assert_true(s.x[5] < 0 && s.x[5] > -3 && lift > 4000 && lift < 4000 + 400);
        if (k == 1)
            assert_true(s.x[5] < -30 && lift == 30000); /* hangs below its anchor */
        if (k == 2)
            assert_true(s.x[5] > 0 && lift == 0);
        net_state_free(&s);
    }
}

/* A spring of stiffness K towards a point: a rope of the same flexibility in its place. */
static void springs(void **state)
{
    struct net_node node[2] = {at(0, 0, 0), loose(300, 0, 0)};
    struct net_rope part[1] = {rope(0, 1, 10, 1e5, 0.001, 0)};
    struct net net = {.n = 2, .m = 1, .node = node, .rope = part};
    struct net_state s;
    (void)state;

    node[1].K[SYM_XX] = node[1].K[SYM_YY] = node[1].K[SYM_ZZ] = 1000;
    node[1].anchor[0] = 10;
    s = solve(&net, &exact);
    /* 300 = EA (x/10 - 1) + 1000 (x - 10), weightless to 1e-6 */
    near_abs(s.x[3], 10 + 300 / (1e4 + 1000), 1e-6);
    net_state_free(&s);
}

/* Things that are nearly nothing, or nearly too much: solved without a hint. */
static void awkward(void **state)
{
    (void)state;
    { /* parallel ropes between two floats over a closed mesh, one slack, one of no weight */
        struct net_node node[4] = {at(0, 0, 0), at(60, 0, 0), loose(0, 0, 3000), loose(0, 0, 3000)};
        struct net_rope part[6] = {rope(0, 2, 50, 1e6, 20, 0), rope(1, 3, 50, 1e6, 20, 0),
                                   rope(2, 3, 30, 1e6, 20, 0), rope(2, 3, 45, 1e6, 20, 0),
                                   rope(2, 3, 40, 1e6, 0, 5),  rope(0, 3, 200, 1e6, 1e-5, 0)};
        struct net net = {.n = 4, .m = 6, .node = node, .rope = part};
        struct net_state s = solve(&net, &exact);
        double unbalance, gap;

        judge(&net, &s, &unbalance, &gap);
        below(unbalance, 1e-8);
        below(gap, 1e-9);
        net_state_free(&s);
    }
    for (int elements = 0; elements <= 3; elements += 3) { /* folded, its middle element slack */
        struct net_node node[2] = {at(0, 0, 0), at(3, 0, 0)};
        struct net_rope part[1] = {rope(0, 1, 30, 2e4, 1000, elements)};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part};
        struct net_state s = solve(&net, &exact);
        double unbalance, gap;

        judge(&net, &s, &unbalance, &gap);
        below(gap, 1e-9);
        net_state_free(&s);
    }
    for (int elements = 0; elements <= 9; elements += 9) { /* a loop that hangs from one point */
        struct net_node node[2] = {at(0, 0, 0), at(0, 0, 1)};
        struct net_rope part[1] = {rope(0, 1, 20, 1e6, 5, elements)};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part};
        struct net_state s = solve(&net, &exact);

        near_abs(s.t[2] + part[0].rope.offset[2],
                 -5 * 20 * (elements ? 8 / 18.0 : 0.5) - 2.5 * (elements ? 0 : 1), 5);
        net_state_free(&s);
    }
    { /* taut to 1e-4 of the chord */
        struct net_node node[2] = {at(0, 0, 0), at(100, 0, 30)};
        struct net_rope part[1] = {rope(0, 1, sqrt(10900) / 1.0001, 1e8, 0.5, 0)};
        struct net net = {.n = 2, .m = 1, .node = node, .rope = part};
        struct net_state s = solve(&net, &exact);

        near_rel(hypot(s.t[0], s.t[2]), 1e8 * 1e-4, 0.01);
        net_state_free(&s);
    }
}

/*
 * Random systems: 2 to 13 nodes at random places of a box, 1 to 4 of them fixed, a random tree of
 * ropes and up to twice as many others; lengths from 0.98 to 3 times, every third 1.0001 times the
 * distance of the places; weights over three decades, one in eight each without weight, with a
 * millionth of it, buoyant; half of them chains of 2 to 21 elements; every second free node under a
 * force.
 */
static struct net random_net(uint64_t *seed, struct net_node *node, struct net_rope *part)
{
    int n = 2 + (int)(12 * uniform(seed)), m = 0;
    int fixed = 1 + (int)((n > 4 ? 4 : n - 1) * uniform(seed)), more = (int)(2 * n * uniform(seed));
    double size = log_uniform(seed, 1, 1000), weight = log_uniform(seed, 1e-3, 1e3);
    double EA = weight * size * log_uniform(seed, 10, 1e6), place[MOST][3];

    for (int i = 0; i < n; i++) {
        double force = weight * size * log_uniform(seed, 1e-3, 10);
        int kind = (int)(4 * uniform(seed));

        for (int c = 0; c < 3; c++)
            place[i][c] = size * uniform(seed);
        node[i] = i < fixed ? at(place[i][0], place[i][1], place[i][2]) : loose(0, 0, 0);
        if (i >= fixed && kind < 2)
            for (int c = kind ? 0 : 2; c < 3; c++)
                node[i].force[c] = force * uniform_in(seed, -1, 1);
    }
    for (int k = 0; k < n - fixed + more; k++) {
        int a = k < n - fixed ? fixed + k : (int)(n * uniform(seed));
        int b = (int)((k < n - fixed ? a : n) * uniform(seed)), kind = (int)(8 * uniform(seed));
        double d = 0, w = weight * log_uniform(seed, 1e-2, 10);

        if (a == b)
            continue;
        for (int c = 0; c < 3; c++)
            d += (place[a][c] - place[b][c]) * (place[a][c] - place[b][c]);
        d = sqrt(d) * (uniform(seed) < 0.3 ? 1.0001 : log_uniform(seed, 0.98, 3));
        w *= kind == 0 ? 0 : kind == 1 ? 1e-6 : kind == 2 ? -1 : 1;
        part[m++] = rope(a, b, d, EA * log_uniform(seed, 0.1, 10), w,
                         uniform(seed) < 0.5 ? 0 : 2 + (int)(20 * uniform(seed)));
    }
    return (struct net){.n = n, .m = m, .node = node, .rope = part};
}

static void random_systems(void **state)
{
    enum { SYSTEMS = 1000, ROPES = 64 };
    uint64_t seed = 20261122;
    double worst = 0, worst_gap = 0;
    int solved = 0, most_steps = 0;
    (void)state;

    for (int k = 0; k < SYSTEMS; k++) {
        struct net_node node[MOST];
        struct net_rope part[ROPES];
        struct net net = random_net(&seed, node, part);
        struct net_state s;
        double unbalance, gap;

        if (net_solve(&net, &exact, &s) == SW_OK) {
            judge(&net, &s, &unbalance, &gap);
            worst = fmax(worst, unbalance);
            worst_gap = fmax(worst_gap, gap);
            solved++;
            most_steps = s.steps > most_steps ? s.steps : most_steps;
        }
        net_state_free(&s);
    }
    print_message("# %d of %d solved, unbalance %.2g, gap %.2g, %d steps at the most\n", solved,
                  SYSTEMS, worst, worst_gap, most_steps);
    assert_true(solved >= 995);
    below(worst, 1e-8);
    below(worst_gap, 1e-9);
}

static void refusals(void **state)
{
    struct net_node node[4] = {at(0, 0, 0), loose(0, 0, 1), loose(0, 0, 1), loose(0, 0, 1)};
    struct net_rope part[2] = {rope(0, 1, 1, 1e6, 1, 0), rope(2, 3, 1, 1e6, 1, 0)};
    struct net net = {.n = 4, .m = 2, .node = node, .rope = part};
    struct net_state s;
    int is_rope, which;
    (void)state;

    assert_non_null(net_refused(&net, &is_rope, &which)); /* nothing holds nodes 2 and 3 */
    assert_true(!is_rope && which >= 2);
    net.n = 2;
    net.m = 1;
    assert_null(net_refused(&net, &is_rope, &which));
    part[0].b = 0;
    assert_non_null(net_refused(&net, &is_rope, &which));
    assert_true(is_rope && which == 0);
    part[0].b = 1;
    part[0].rope.L0 = NAN;
    assert_non_null(net_refused(&net, &is_rope, &which));
    part[0] = rope(0, 1, 1, 1e6, 0, 1); /* a bar without a force turns about its end */
    node[1] = loose(0, 0, 0);
    node[1].x[0] = 1;
    node[1].x[1] = node[1].x[2] = 0;
    assert_int_equal(net_solve(&net, &exact, &s), SW_INDEFINITE);
    assert_int_equal(s.worst, 1);
    net_state_free(&s);
}

TEST_MAIN(cmocka_unit_test(triangle_mooring), cmocka_unit_test(point_load_cable),
          cmocka_unit_test(methods_agree), cmocka_unit_test(other_starts),
          cmocka_unit_test(stiffness_by_differences), cmocka_unit_test(body_by_differences),
          cmocka_unit_test(symmetries), cmocka_unit_test(bars_push), cmocka_unit_test(floats),
          cmocka_unit_test(springs), cmocka_unit_test(awkward), cmocka_unit_test(random_systems),
          cmocka_unit_test(refusals))
