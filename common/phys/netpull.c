/*
 * The method of imaginary reactions (Skop and O'Hara; Blendermann 77-80): in a system without
 * closed parts all fixed points but one are released; tensions follow from the reactions there, the
 * positions from the one that is left, and the reactions pull towards the points that are missed.
 */
#include "num/mem.h"
#include "phys/network.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The system as a tree, from its root outwards. */
struct tree {
    int *order;     /* (n) nodes, parents first */
    int *rope;      /* (n) rope of each node to its parent, -1: root */
    int *parent;    /* (n) */
    double *pull;   /* (n, 3) reactions of the released points */
    double *before; /* (n, 3) those of the last accepted step */
    double *sum;    /* (n, 3) work space: what a node hands on to its parent */
};

static void tree_free(struct tree *t)
{
    free(t->order);
    free(t->rope);
    free(t->parent);
    free(t->pull);
    free(t->before);
    free(t->sum);
}

static enum status tree_alloc(int n, struct tree *t)
{
    *t = (struct tree){mem_zeroed((size_t)n, sizeof(int)), mem_zeroed((size_t)n, sizeof(int)),
                       mem_zeroed((size_t)n, sizeof(int)), mem_doubles(3 * (size_t)n),
                       mem_doubles(3 * (size_t)n),         mem_doubles(3 * (size_t)n)};
    return t->order && t->rope && t->parent && t->pull && t->before && t->sum ? SW_OK : SW_NOMEM;
}

static int is_fixed(const struct net_node *p)
{
    return p->held == 7;
}

/* Whether the method knows what to do with every node and rope. */
static int applies(const struct net *net)
{
    for (int i = 0; i < net->n; i++) {
        const struct net_node *p = &net->node[i];
        double spring = 0;

        for (int k = 0; k < SYM; k++)
            spring = fmax(spring, fabs(p->K[k]));
        if ((p->held != 0 && p->held != 7) || spring > 0 || p->area > 0)
            return 0;
    }
    for (int r = 0; r < net->m; r++)
        if (net_is_bar(&net->rope[r]))
            return 0;
    return net->m == net->n - 1;
}

/* Nodes from the first fixed one outwards; 0: not all are reached, so that there is a closed part.
 */
static int grow(const struct net *net, struct tree *t)
{
    int count = 0;

    for (int i = 0; i < net->n; i++)
        t->parent[i] = -1;
    for (int i = 0; i < net->n && count == 0; i++)
        if (is_fixed(&net->node[i])) {
            t->order[count++] = i;
            t->parent[i] = i;
            t->rope[i] = -1;
        }
    for (int done = -1; done != count && count > 0;) {
        done = count;
        for (int r = 0; r < net->m; r++) {
            int a = net->rope[r].a, b = net->rope[r].b;
            int from = t->parent[a] >= 0 ? a : b, to = from == a ? b : a;

            if (t->parent[from] < 0 || t->parent[to] >= 0)
                continue;
            t->order[count++] = to;
            t->parent[to] = from;
            t->rope[to] = r;
        }
    }
    return count == net->n;
}

/* Tensions from the outside in, positions from the root outwards. */
static void lay_out(const struct net *net, struct tree *t, double *x, double *tension)
{
    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3; c++)
            t->sum[3 * i + c] = net->node[i].force[c] + t->pull[3 * i + c];
    for (int r = 0; r < net->m; r++) {
        double end[3];

        rope_end_load(&net->rope[r].rope, end);
        for (int c = 0; c < 3; c++) {
            t->sum[3 * net->rope[r].a + c] += end[c];
            t->sum[3 * net->rope[r].b + c] += end[c];
        }
    }
    for (int k = net->n - 1; k > 0; k--) {
        int i = t->order[k], r = t->rope[i], at_a = net->rope[r].a == i;
        double load[3];

        rope_load(&net->rope[r].rope, load);
        for (int c = 0; c < 3; c++) {
            tension[3 * r + c] = at_a ? -t->sum[3 * i + c] : t->sum[3 * i + c] + load[c];
            t->sum[3 * t->parent[i] + c] += t->sum[3 * i + c] + load[c];
        }
    }
    memcpy(x + 3 * t->order[0], net->node[t->order[0]].x, 3 * sizeof *x);
    for (int k = 1; k < net->n; k++) {
        int i = t->order[k], r = t->rope[i];
        double chord[3], sign = net->rope[r].b == i ? 1 : -1;

        rope_chord(&net->rope[r].rope, tension + 3 * r, chord, NULL);
        for (int c = 0; c < 3; c++)
            x[3 * i + c] = x[3 * t->parent[i] + c] + sign * chord[c];
    }
}

/* Sum of squares of the gaps at the released points. */
static double missed(const struct net *net, const double *x)
{
    double sum = 0;

    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3 && is_fixed(&net->node[i]); c++) {
            double gap = net->node[i].x[c] - x[3 * i + c];

            sum += gap * gap;
        }
    return sum;
}

/* The reactions pull on: by (78), (79) or (80), halved so many times. */
static void pull_on(const struct net *net, const struct net_options *o, const double *x,
                    double tension, double span, double halved, double gaps, struct tree *t)
{
    double factor = tension / span; /* a constant stiffness, (78), and (80) */

    if (o->pull == NET_UNIT)
        factor = tension / sqrt(gaps);
    if (o->pull == NET_CONSTANT)
        factor *= 4; /* any number will do: another one than that of the span */
    for (int i = 0; i < 3 * net->n; i++)
        if (is_fixed(&net->node[i / 3]) && i / 3 != t->order[0])
            t->pull[i] = t->before[i] + factor * halved * (net->node[i / 3].x[i % 3] - x[i]);
}

static enum status iterate(const struct net *net, const struct net_options *o, struct tree *t,
                           struct net_work *w, struct net_state *s)
{
    double halved = 1, gaps, best;

    lay_out(net, t, s->x, s->t);
    best = missed(net, s->x);
    s->step[0] = (struct net_step){.mean_gap = sqrt(best) / s->size,
                                   .largest_gap = sqrt(best) / s->size,
                                   .factor = 1};
    while (s->steps < o->steps && sqrt(best) > o->tolerance * s->size / 10) {
        pull_on(net, o, s->x, w->reference, s->size, halved, best, t);
        lay_out(net, t, w->x1, w->t1);
        gaps = missed(net, w->x1);
        s->step[++s->steps] = (struct net_step){.mean_gap = sqrt(gaps) / s->size,
                                                .largest_gap = sqrt(gaps) / s->size,
                                                .factor = halved};
        if (!(gaps < best)) {
            halved /= 2;
            if (!(halved > 1e-300))
                break;
            continue;
        }
        best = gaps;
        memcpy(s->x, w->x1, 3 * sizeof *s->x * (size_t)net->n);
        memcpy(s->t, w->t1, 3 * sizeof *s->t * (size_t)net->m);
        memcpy(t->before, t->pull, 3 * sizeof *t->pull * (size_t)net->n);
    }
    return sqrt(best) <= o->tolerance * s->size ? SW_OK : SW_NOCONV;
}

enum status net_imaginary(const struct net *net, const struct net_options *o, struct net_work *w,
                          struct net_state *s)
{
    struct tree t;
    enum status status;

    if (!applies(net))
        return SW_ADMISSIBLE;
    status = tree_alloc(net->n, &t);
    if (status == SW_OK && !grow(net, &t))
        status = SW_ADMISSIBLE;
    if (status == SW_OK)
        status = iterate(net, o, &t, w, s);
    tree_free(&t);
    if (status != SW_OK && status != SW_NOCONV)
        return status;
    for (int i = 0; i < net->n; i++) /* released points go back to their places */
        if (is_fixed(&net->node[i]))
            memcpy(s->x + 3 * i, net->node[i].x, 3 * sizeof *s->x);
    net_evaluate(net, s->x, s->t, w);
    net_measure(net, s->t, w, s);
    return status;
}
