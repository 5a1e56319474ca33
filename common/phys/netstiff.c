/* Stiffness of chosen nodes, condensed on the rest; what no method can solve. */
#include "num/mem.h"
#include "phys/network.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FIRM 1e4    /* of the bed, in place of the softness with which it was looked for */
#define PASSES 300  /* of refinement */
#define DONE 1e-12  /* of the first correction */
#define ENOUGH 1e-8 /* of it, where it gets no better */

/* The system at its equilibrium, chosen nodes held. */
struct stand {
    struct net net;
    const struct net_state *s;
    struct net_work w;
    double *u, *f; /* (n, 3) displacements and the forces that they need */
};

/* f += a block of 6 x 6, column-major, times the displacements of the ends of p. */
static void add_block(const struct net_rope *p, const double *K, const double *u, double *f)
{
    const double *at[2] = {u + 3 * p->a, u + 3 * p->b};
    double *to[2] = {f + 3 * p->a, f + 3 * p->b};

    for (int j = 0; j < 6; j++)
        for (int i = 0; i < 6; i++)
            to[i / 3][i % 3] += K[i + 6 * j] * at[j / 3][j % 3];
}

/* The drag of an element: - d(half to each end)/d(x_a, x_b). */
static void drag_block(const struct stand *g, const struct net_rope *p, double K[36])
{
    const double *a = g->s->x + 3 * p->a, *b = g->s->x + 3 * p->b;
    double U[3], slope[3], c[3], by_c[9], by_U[9], l = 0;

    for (int i = 0; i < 3; i++) {
        c[i] = b[i] - a[i];
        l += c[i] * c[i];
    }
    l = sqrt(l);
    memset(K, 0, 36 * sizeof *K);
    if (!(l > 0))
        return;
    for (int i = 0; i < 3; i++)
        c[i] /= l;
    current_at(&g->net.sea->current, (a[2] + b[2]) / 2, U, slope);
    sea_drag_change(p->across, p->along, p->rope.L0, c, U, by_c, by_U);
    for (int i = 0; i < 3; i++) {
        double turned = 0, sheared = 0;

        for (int k = 0; k < 3; k++) {
            turned += by_c[3 * i + k] * c[k];
            sheared += by_U[3 * i + k] * slope[k];
        }
        for (int j = 0; j < 3; j++) {
            double turn = (by_c[3 * i + j] - turned * c[j]) / l / 2;
            double shear = j == 2 ? sheared / 4 : 0;

            for (int end = 0; end < 2; end++) {
                K[3 * end + i + 6 * j] = turn - shear;
                K[3 * end + i + 6 * (3 + j)] = -turn - shear;
            }
        }
    }
}

/* The drag of a node: it changes with its height. */
static void add_node_drag(const struct stand *g, int i, const double *u, double *f)
{
    double U[3], slope[3], speed, along = 0;

    current_at(&g->net.sea->current, g->s->x[3 * i + 2], U, slope);
    speed = net_length(U);
    for (int c = 0; c < 3; c++)
        along += speed > 0 ? U[c] * slope[c] / speed : 0;
    for (int c = 0; c < 3; c++)
        f[3 * i + c] -= g->net.node[i].drag * (speed * slope[c] + along * U[c]) * u[3 * i + 2];
}

/* g->f: forces that the displacements g->u need, all of them, also what is not symmetric. */
static void apply(const struct stand *g)
{
    const struct net *net = &g->net;
    int flows = net->sea && net->sea->current.n > 0;

    memset(g->f, 0, 3 * sizeof *g->f * (size_t)net->n);
    for (int i = 0; i < net->n; i++) {
        double own[3];

        sym_times(g->w.node_K + SYM * i, g->u + 3 * i, own);
        for (int c = 0; c < 3; c++)
            g->f[3 * i + c] += own[c];
        if (flows && net->node[i].drag > 0)
            add_node_drag(g, i, g->u, g->f);
    }
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        double stretch[3], force[3], K[36];

        if (p->over) {
            add_block(p, g->w.over_K + 36 * (size_t)r, g->u, g->f);
            continue;
        }
        for (int i = 0; i < 3; i++)
            stretch[i] = g->u[3 * p->b + i] - g->u[3 * p->a + i];
        sym_times(g->w.K + SYM * r, stretch, force);
        for (int i = 0; i < 3; i++) {
            g->f[3 * p->a + i] -= force[i];
            g->f[3 * p->b + i] += force[i];
        }
        if (flows) {
            drag_block(g, p, K);
            add_block(p, K, g->u, g->f);
        }
    }
}

/* g->u of all that is free follows what is given for the rest: by the symmetric part, until what is
 * left of the whole is nothing.  SW_NOCONV: the rest is no small part. */
static enum status follow_on(struct stand *g)
{
    double first = 0, left = 0, before = INFINITY;

    for (int pass = 0; pass < PASSES; pass++) {
        enum status s;

        apply(g);
        left = 0;
        for (int i = 0; i < 3 * g->net.n; i++)
            if (g->w.dof[i] >= 0)
                g->w.rhs[g->w.dof[i]] = -g->f[i];
        s = sparse_solve(&g->w.A, 1, g->w.rhs);
        if (s != SW_OK)
            return s;
        for (int i = 0; i < 3 * g->net.n; i++)
            if (g->w.dof[i] >= 0) {
                g->u[i] += g->w.rhs[g->w.dof[i]];
                left = fmax(left, fabs(g->w.rhs[g->w.dof[i]]));
            }
        if (pass == 0)
            first = left;
        if (!(left > DONE * first) || (left > before / 2 && left < ENOUGH * first))
            return SW_OK; /* nothing is left, or nothing but round-off */
        before = left;
    }
    return SW_NOCONV;
}

/* Stand at the state s of net with the chosen nodes held, the matrix factored. */
static enum status stand_still(const struct net *net, const struct net_state *s, const int *chosen,
                               int k, struct stand *g)
{
    enum status status;
    int bed;

    *g = (struct stand){.net = *net, .s = s};
    g->net.node = mem_copy(net->node, sizeof *net->node * (size_t)net->n);
    g->u = mem_doubles(3 * (size_t)net->n);
    g->f = mem_doubles(3 * (size_t)net->n);
    if (!g->net.node || !g->u || !g->f)
        return SW_NOMEM;
    for (int i = 0; i < k; i++)
        g->net.node[chosen[i]].held = 7;
    status = net_work_new(&g->net, &g->w);
    if (status != SW_OK)
        return status;
    g->w.reference = net_reference(net);
    g->w.hard = s->hard;
    g->w.over = OVER_EXACT;
    bed = s->hard > 0 && g->w.lean && g->w.push; /* where there is one w has room for both */
    if (bed)
        memcpy(g->w.lean, s->push, sizeof *s->push * (size_t)net->n);
    net_evaluate(&g->net, s->x, s->t, &g->w);
    for (int i = 0; i < net->n && bed; i++)
        if (g->w.push[i] > 0)
            net_add_bed(&g->net, s->x, i, FIRM * s->hard, &g->w);
    net_assemble(&g->net, &g->w);
    return sparse_factor(&g->w.A);
}

enum status net_stiffness(const struct net *net, const struct net_state *s, const int *chosen,
                          int k, double *K)
{
    struct stand g;
    enum status status;

    if (s->fine)
        return net_stiffness(&s->fine->split.fine, &s->fine->state, chosen, k, K);
    status = stand_still(net, s, chosen, k, &g);
    for (int j = 0; j < 3 * k && status == SW_OK; j++) {
        memset(g.u, 0, 3 * sizeof *g.u * (size_t)net->n);
        g.u[3 * chosen[j / 3] + j % 3] = 1;
        status = follow_on(&g);
        for (int i = 0; i < 3 * k; i++)
            K[i + 3 * k * j] = g.f[3 * chosen[i / 3] + i % 3];
    }
    net_work_free(&g.w);
    free(g.net.node);
    free(g.u);
    free(g.f);
    return status;
}

/* The first node of i's group, with shorter ways for the next call. */
static int group_of(int *group, int i)
{
    while (group[i] != i)
        i = group[i] = group[group[i]];
    return i;
}

static int is_tied(const struct net_node *p)
{
    int tied = p->held != 0 || p->area > 0;

    for (int k = 0; k < SYM; k++)
        tied |= p->K[k] != 0;
    return tied;
}

/* A node whose group of ropes is tied to nothing; -1: none, -2: memory ran out. */
static int find_loose(const struct net *net)
{
    int *group = mem_zeroed((size_t)net->n, sizeof *group), loose = -1;
    char *tied = mem_zeroed((size_t)net->n, 1);

    if (!group || !tied) {
        free(group);
        free(tied);
        return -2;
    }
    for (int i = 0; i < net->n; i++)
        group[i] = i;
    for (int r = 0; r < net->m; r++)
        group[group_of(group, net->rope[r].a)] = group_of(group, net->rope[r].b);
    for (int i = 0; i < net->n; i++)
        if (is_tied(&net->node[i]))
            tied[group_of(group, i)] = 1;
    for (int i = 0; i < net->n && loose < 0; i++)
        if (!tied[group_of(group, i)])
            loose = i;
    free(group);
    free(tied);
    return loose;
}

const char *net_refused(const struct net *net, int *ret_is_rope, int *ret_at)
{
    *ret_is_rope = 1;
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];

        *ret_at = r;
        if (p->a == p->b)
            return "both ends are the same node";
        if (!(p->rope.L0 > 0))
            return "its length is not positive";
        if (!(p->rope.law.EA > 0))
            return "its stiffness is not positive";
    }
    *ret_is_rope = 0;
    *ret_at = find_loose(net);
    if (*ret_at == -2)
        return "memory ran out";
    return *ret_at >= 0 ? "no rope leads from here to anything that is held" : NULL;
}
