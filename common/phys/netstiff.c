/* Stiffness of chosen nodes, condensed on the rest; ends; what no method can solve. */
#include "num/mem.h"
#include "phys/network.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Column j of chosen node c against the free unknowns: A_fc, into rhs. */
static void couple(const struct net *net, const struct net_work *w, int node, int j, double *rhs)
{
    double unit[3] = {0, 0, 0}, force[3];

    unit[j] = 1;
    memset(rhs, 0, sizeof *rhs * (size_t)w->unknowns);
    for (int r = 0; r < net->m; r++) {
        int a = net->rope[r].a, b = net->rope[r].b, other = a == node ? b : a;

        if (a != node && b != node)
            continue;
        sym_times(w->K + SYM * r, unit, force);
        for (int i = 0; i < 3; i++)
            if (w->dof[3 * other + i] >= 0)
                rhs[w->dof[3 * other + i]] -= force[i];
    }
}

/* Forces on all chosen nodes for the displacements x of free ones (by unknown) and a unit
 * displacement j of chosen node number c. */
static void reactions(const struct net *net, const struct net_work *w, const int *chosen, int k,
                      int c, int j, const double *x, double *ret)
{
    double *all = w->x1; /* work space: displacements of all nodes */

    memset(all, 0, 3 * sizeof *all * (size_t)net->n);
    for (int i = 0; i < 3 * net->n; i++)
        if (w->dof[i] >= 0)
            all[i] = x[w->dof[i]];
    all[3 * chosen[c] + j] = 1;
    memset(w->residual, 0, 3 * sizeof *w->residual * (size_t)net->n);
    for (int r = 0; r < net->m; r++) {
        int a = net->rope[r].a, b = net->rope[r].b;
        double stretch[3], force[3];

        for (int i = 0; i < 3; i++)
            stretch[i] = all[3 * b + i] - all[3 * a + i];
        sym_times(w->K + SYM * r, stretch, force);
        for (int i = 0; i < 3; i++) {
            w->residual[3 * a + i] -= force[i];
            w->residual[3 * b + i] += force[i];
        }
    }
    for (int d = 0; d < k; d++) {
        double own[3];

        sym_times(w->node_K + SYM * chosen[d], all + 3 * chosen[d], own);
        for (int i = 0; i < 3; i++)
            ret[3 * d + i] = w->residual[3 * chosen[d] + i] + own[i];
    }
}

enum status net_stiffness(const struct net *net, const struct net_state *s, const int *chosen,
                          int k, double *K)
{
    struct net held = *net;
    struct net_work w = {.dof = NULL};
    enum status status = SW_NOMEM;

    held.node = mem_copy(net->node, sizeof *net->node * (size_t)net->n);
    if (!held.node)
        return SW_NOMEM;
    for (int i = 0; i < k; i++)
        held.node[chosen[i]].held = 7;
    status = net_work_new(&held, &w);
    w.reference = net_reference(net);
    if (status == SW_OK) {
        net_evaluate(&held, s->x, s->t, &w);
        net_assemble(&held, &w);
        status = sparse_factor(&w.A);
    }
    for (int i = 0; i < 3 * k && status == SW_OK; i++) {
        couple(&held, &w, chosen[i / 3], i % 3, w.rhs);
        for (int u = 0; u < w.unknowns; u++)
            w.rhs[u] = -w.rhs[u];
        status = sparse_solve(&w.A, 1, w.rhs);
        if (status == SW_OK)
            reactions(&held, &w, chosen, k, i / 3, i % 3, w.rhs, K + 3 * k * i);
    }
    net_work_free(&w);
    free(held.node);
    return status;
}

/* Displacement of a point at r of the body for its j-th freedom: along x, y, z, about x, y, z. */
static void follow(int j, const double r[3], double ret[3])
{
    ret[0] = ret[1] = ret[2] = 0;
    if (j < 3) {
        ret[j] = 1;
        return;
    }
    ret[(j + 1) % 3] = -r[(j + 2) % 3]; /* unit rotation times r */
    ret[(j + 2) % 3] = r[(j + 1) % 3];
}

enum status net_body_stiffness(const struct net *net, const struct net_state *s, const int *chosen,
                               int k, const double about[3], double K[36])
{
    size_t n = 3 * (size_t)k;
    double *nodes = mem_doubles(n * n), *move = mem_doubles(6 * n);
    enum status status = nodes && move ? net_stiffness(net, s, chosen, k, nodes) : SW_NOMEM;

    memset(K, 0, 36 * sizeof *K);
    for (int i = 0; i < k && status == SW_OK; i++) {
        double r[3], p[3], dot = 0;

        for (int c = 0; c < 3; c++) {
            r[c] = s->x[3 * chosen[i] + c] - about[c];
            p[c] = -s->residual[3 * chosen[i] + c];
            dot += p[c] * r[c];
        }
        for (int j = 0; j < 6; j++)
            follow(j, r, move + n * (size_t)j + 3 * i);
        for (int c = 0; c < 3; c++)
            for (int d = 0; d < 3; d++)
                K[3 + c + 6 * (3 + d)] += r[c] * p[d] - (c == d ? dot : 0);
    }
    for (int a = 0; a < 6 && status == SW_OK; a++)
        for (int b = 0; b < 6; b++)
            for (size_t i = 0; i < n; i++)
                for (size_t j = 0; j < n; j++)
                    K[a + 6 * b] +=
                        move[n * (size_t)a + i] * nodes[i + n * j] * move[n * (size_t)b + j];
    free(nodes);
    free(move);
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
