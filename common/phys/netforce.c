/* Forces of systems of ropes: of nodes, bars and ropes, what is missing to their balance, and the
 * step that would close it. */
#include "num/dense.h"
#include "phys/network.h"

#include <math.h>
#include <string.h>

#define PART 1e-5   /* of the reference force: less than that is no tension to compare with */
#define BEARS 0.1   /* of it over a bed: its push is known to the heights' last digit only */
#define REST 1e-10  /* of the bed's hardness: stiffness of what nothing holds */
#define STIFFER 10  /* powers of ten above that */
#define THREADS 512 /* ropes from which threads share them */

void net_node_force(const struct net_node *node, const double x[3], double f[3], double K[SYM])
{
    double away[3], pull[3], draft = -x[2];

    for (int i = 0; i < 3; i++)
        away[i] = x[i] - node->anchor[i];
    sym_times(node->K, away, pull);
    for (int i = 0; i < 3; i++)
        f[i] = node->force[i] - pull[i];
    if (K)
        memcpy(K, node->K, sizeof node->K);
    if (!(node->area > 0))
        return;
    f[2] += node->area * fmin(fmax(draft, 0), node->height);
    if (K && draft > 0 && draft < node->height)
        K[SYM_ZZ] += node->area;
}

/* A bar between x_a and x_b: tension towards b and stiffness (26).  One that only pulls has none
 * where it is slack; soft, a thousandth of what a rope has that carries the reference, stands for
 * its stiffness in the matrix. */
static void bar(const struct net_rope *p, const double d[3], double soft, double t[3],
                double K[SYM])
{
    const struct rope *r = &p->rope;
    double l = net_length(d), N, along, change, slope;

    if (l > r->L0 && r->law.n > 0) {
        N = rope_tension(&r->law, l / r->L0 - 1, &slope);
        slope /= r->L0;
    } else {
        N = r->law.EA * (l / r->L0 - 1);
        slope = r->law.EA / r->L0;
    }
    along = N / l;
    change = (slope - along) / (l * l);
    if (!(l > 0)) { /* no direction: a spring in all of them */
        along = slope;
        change = 0;
    }
    if (p->pulls && !(N > 0)) {
        N = 0;
        along = soft / r->L0;
        change = 0;
    }
    for (int i = 0; i < 3; i++)
        t[i] = l > 0 ? N / l * d[i] : i == 2 ? N : 0; /* no length: as if it stood upright */
    K[SYM_XX] = along + change * d[0] * d[0];
    K[SYM_XY] = change * d[0] * d[1];
    K[SYM_XZ] = change * d[0] * d[2];
    K[SYM_YY] = along + change * d[1] * d[1];
    K[SYM_YZ] = change * d[1] * d[2];
    K[SYM_ZZ] = along + change * d[2] * d[2];
}

/* Chord, stiffness and gap of rope r at t and x. */
static void evaluate_rope(const struct net *net, const double *x, const double *t, int r,
                          struct net_work *w)
{
    const struct net_rope *p = &net->rope[r];
    const double *a = x + 3 * p->a, *b = x + 3 * p->b;
    double *gap = w->gap + 3 * r, *K = w->K + SYM * r, F[SYM], chord[3];

    if (p->over) {
        gap[0] = gap[1] = gap[2] = 0;
        if (!net_over(net, p, a, b, w->pull + 6 * (size_t)r, w->over, w->over_K + 36 * (size_t)r))
            w->pull[6 * (size_t)r] = NAN;
        return;
    }
    if (net_is_bar(p)) {
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};

        bar(p, d, w->reference / 1000, w->bar + 3 * r, w->K + SYM * r);
        gap[0] = gap[1] = gap[2] = 0;
        return;
    }
    rope_chord(&p->rope, t + 3 * r, chord, F);
    for (int i = 0; i < 3; i++)
        gap[i] = b[i] - a[i] - chord[i];
    if (!sym_invert(F, K))
        memset(K, 0, SYM * sizeof *K);
}

static void evaluate_ropes(const struct net *net, const double *x, const double *t,
                           struct net_work *w)
{
#pragma omp parallel for if (net->m >= THREADS)
    for (int r = 0; r < net->m; r++)
        evaluate_rope(net, x, t, r, w);
}

void net_ends_now(const struct net *net, const double *t, const struct net_work *w, int r,
                  double ta[3], double tb[3])
{
    const struct net_rope *p = &net->rope[r];
    double load[3] = {0, 0, 0};

    if (p->over) {
        memcpy(ta, w->pull + 6 * (size_t)r, 3 * sizeof *ta);
        memcpy(tb, w->pull + 6 * (size_t)r + 3, 3 * sizeof *tb);
        return;
    }
    memcpy(ta, net_is_bar(p) ? w->bar + 3 * r : t + 3 * r, 3 * sizeof *ta);
    if (!net_is_bar(p))
        rope_load(&p->rope, load);
    for (int i = 0; i < 3; i++) {
        ta[i] += p->rope.offset[i];
        tb[i] = ta[i] - load[i];
    }
}

/* Where the bed pushes node i to, per unit upwards; joints of ropes in the rope's heading only. */
void net_bed_normal(const struct net *net, const double *x, int i, double n[3])
{
    const double *way = net->node[i].way;
    double g[2], along;

    bed_at(&net->sea->bed, x[3 * i], x[3 * i + 1], g);
    along = g[0] * way[0] + g[1] * way[1];
    for (int c = 0; c < 2; c++)
        n[c] = way[0] == 0 && way[1] == 0 ? -g[c] : -along * way[c];
    n[2] = 1;
}

void net_add_bed(const struct net *net, const double *x, int i, double hard, struct net_work *w)
{
    double n[3];

    net_bed_normal(net, x, i, n);
    for (int c = 0, at = 0; c < 3; c++)
        for (int d = c; d < 3; d++, at++)
            w->node_K[SYM * i + at] += hard * n[c] * n[d];
}

/* The bed under node i at x: it pushes as it is counted on, less where the node is above it, more
 * where it sinks in; nodes that are held in height are left alone. */
static void push_up(const struct net *net, const double *x, int i, struct net_work *w)
{
    double n[3], deep = bed_at(&net->sea->bed, x[3 * i], x[3 * i + 1], NULL) - x[3 * i + 2];

    w->push[i] = net->node[i].held & 4 ? 0 : fmax(0, w->lean[i] + w->hard * deep);
    if (!(w->push[i] > 0))
        return;
    net_bed_normal(net, x, i, n);
    for (int c = 0; c < 3; c++)
        w->residual[3 * i + c] += w->push[i] * n[c];
    net_add_bed(net, x, i, w->hard, w);
}

/* Residual of all nodes at x and t: forces of ropes and from outside. */
static void evaluate_nodes(const struct net *net, const double *x, const double *t,
                           struct net_work *w)
{
    for (int i = 0; i < net->n; i++)
        net_node_force(&net->node[i], x + 3 * i, w->residual + 3 * i, w->node_K + SYM * i);
    for (int i = 0; i < net->n && w->hard > 0; i++)
        push_up(net, x, i, w);
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        double ta[3], tb[3], end[3];

        net_ends_now(net, t, w, r, ta, tb);
        rope_end_load(&p->rope, end);
        for (int i = 0; i < 3; i++) {
            w->residual[3 * p->a + i] += ta[i] + end[i];
            w->residual[3 * p->b + i] += end[i] - tb[i];
        }
    }
}

void net_evaluate(const struct net *net, const double *x, const double *t, struct net_work *w)
{
    evaluate_ropes(net, x, t, w);
    evaluate_nodes(net, x, t, w);
}

struct net_step net_measure(const struct net *net, const double *t, const struct net_work *w,
                            struct net_state *s)
{
    struct net_step ret = {.factor = 1};
    int counted = 0;

    s->most = 0;
    s->scale = (w->hard > 0 ? BEARS : PART) * w->reference;
    for (int r = 0; r < net->m; r++) {
        double gap = net_length(w->gap + 3 * r) / s->size, ta[3], tb[3];

        net_ends_now(net, t, w, r, ta, tb);
        s->most = fmax(s->most, fmax(net_length(ta), net_length(tb)));
        s->scale = fmax(s->scale, s->most);
        ret.mean_gap += gap;
        counted += !net_is_placed(&net->rope[r]);
        if (!(gap <= ret.largest_gap))
            ret.largest_gap = gap;
        gap *= s->size / net->rope[r].rope.L0;
        if (!(gap <= ret.gap_of_rope))
            ret.gap_of_rope = gap;
    }
    ret.mean_gap /= counted > 0 ? counted : 1;
    for (int i = 0; i < 3 * net->n; i++) {
        double missing = w->dof[i] >= 0 ? fabs(w->residual[i]) : 0;

        if (!(missing <= ret.residual)) {
            ret.residual = missing;
            s->worst = i / 3;
        }
    }
    return ret;
}

/* The symmetric part of a block, 6 x 6, without what is negative in it. */
static enum status make_convex(double *K)
{
    double X[36], lambda[6];
    enum status s;

    for (int i = 0; i < 36; i++)
        X[i] = (K[i] + K[i / 6 + 6 * (i % 6)]) / 2;
    s = dense_symmetric(6, X, lambda);
    for (int i = 0; i < 36 && s == SW_OK; i++) {
        K[i] = 0;
        for (int k = 0; k < 6; k++)
            K[i] += fmax(0, lambda[k]) * X[i % 6 + 6 * k] * X[i / 6 + 6 * k];
    }
    return s;
}

/*
 * On a bed nodes may rest where nothing holds them sideways, among slack ropes; and on a slope or
 * with friction ropes are not quite symmetric.  The positive part, and a small resistance to any
 * displacement change the way, not where it ends.
 */
static enum status stiffen(const struct net *net, struct net_work *w)
{
    enum status s = SW_OK;

    for (int r = 0; r < net->m && s == SW_OK; r++)
        if (net->rope[r].over)
            s = make_convex(w->over_K + 36 * (size_t)r);
    if (s != SW_OK)
        return s;
    net_assemble(net, w);
    s = SW_INDEFINITE;
    for (int k = 0; k < STIFFER && s == SW_INDEFINITE; k++) {
        for (int i = 0; i < w->unknowns; i++)
            w->A.value[sparse_at(&w->A, i, i)] += pow(10, k) * REST * w->hard;
        s = sparse_factor(&w->A);
    }
    return s;
}

enum status net_find_step(const struct net *net, struct net_work *w, int *ret_worst)
{
    enum status s;

    net_assemble(net, w);
    for (int i = 0; i < 3 * net->n; i++)
        if (w->dof[i] >= 0)
            w->rhs[w->dof[i]] = w->residual[i];
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        double pull[3];

        sym_times(w->K + SYM * r, w->gap + 3 * r, pull);
        for (int i = 0; i < 3; i++) {
            if (w->dof[3 * p->a + i] >= 0)
                w->rhs[w->dof[3 * p->a + i]] += pull[i];
            if (w->dof[3 * p->b + i] >= 0)
                w->rhs[w->dof[3 * p->b + i]] -= pull[i];
        }
    }
    s = sparse_factor(&w->A);
    if (s == SW_INDEFINITE && w->hard > 0)
        s = stiffen(net, w);
    if (s == SW_INDEFINITE)
        *ret_worst = net_node_of(net, w, w->A.failed);
    if (s == SW_OK)
        s = sparse_solve(&w->A, 1, w->rhs);
    if (s != SW_OK)
        return s;
    for (int i = 0; i < 3 * net->n; i++)
        w->dx[i] = w->dof[i] >= 0 ? w->rhs[w->dof[i]] : 0;
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        double open[3];

        for (int i = 0; i < 3; i++)
            open[i] = w->gap[3 * r + i] + w->dx[3 * p->b + i] - w->dx[3 * p->a + i];
        sym_times(w->K + SYM * r, open, w->dt + 3 * r);
    }
    return SW_OK;
}
