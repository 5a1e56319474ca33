/* Ropes split into their elements: a finer net, whose first nodes are those of the coarse one. */
#include "num/mem.h"
#include "phys/network.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Half an element's load to both ends. */
static void load_ends(const struct net_rope *p, int n, struct net *fine)
{
    for (int i = 0; i < 3 && !p->rope.load; i++) {
        double half = p->rope.q[i] * p->rope.L0 / n / 2;

        fine->node[p->a].force[i] += half;
        fine->node[p->b].force[i] += half;
    }
}

/* Rope p in n elements from fine rope `at` on, its joints from fine node `node` on. */
static void split_rope(const struct net_rope *p, int n, int cut, struct net *fine, int at, int node)
{
    load_ends(p, n, fine);
    for (int k = 1; k <= n; k++, at++) {
        struct net_rope *e = &fine->rope[at];

        *e = (struct net_rope){.a = k == 1 ? p->a : node - 1,
                               .b = k == n ? p->b : node,
                               .pulls = n > 1 || p->pulls,
                               .cut = cut,
                               .across = p->across,
                               .along = p->along,
                               .friction = p->friction,
                               .pulled = p->pulled};
        e->rope = (struct rope){.law = p->rope.law, .L0 = p->rope.L0 / n, .elements = 1};
        if (k == n)
            continue;
        fine->node[node] = (struct net_node){.x = {NAN, NAN, NAN}};
        rope_joint_load(&p->rope, n, k, fine->node[node++].force);
    }
}

enum status net_split_new(const struct net *net, const int *parts, int cut, struct net_split *ret)
{
    size_t n = (size_t)net->n, m = 0;
    int node = net->n, at = 0;

    for (int r = 0; r < net->m; r++) {
        n += parts[r] > 0 ? (size_t)parts[r] - 1 : 0;
        m += parts[r] > 0 ? (size_t)parts[r] : 1;
    }
    ret->fine = (struct net){.n = (int)n,
                             .m = (int)m,
                             .node = mem_zeroed(n, sizeof *ret->fine.node),
                             .rope = mem_zeroed(m, sizeof *ret->fine.rope),
                             .sea = net->sea};
    ret->first = mem_zeroed((size_t)net->m + 1, sizeof *ret->first);
    if (!ret->fine.node || !ret->fine.rope || !ret->first)
        return SW_NOMEM;
    memcpy(ret->fine.node, net->node, sizeof *net->node * (size_t)net->n);
    for (int r = 0; r < net->m; r++) {
        ret->first[r] = at;
        if (parts[r] > 0)
            split_rope(&net->rope[r], parts[r], cut, &ret->fine, at, node);
        else
            ret->fine.rope[at] = net->rope[r];
        node += parts[r] > 0 ? parts[r] - 1 : 0;
        at += parts[r] > 0 ? parts[r] : 1;
    }
    ret->first[net->m] = at;
    return SW_OK;
}

void net_split_free(struct net_split *s)
{
    free(s->fine.node);
    free(s->fine.rope);
    free(s->first);
    *s = (struct net_split){.first = NULL};
}

void net_fine_free(struct net_fine *f)
{
    if (!f)
        return;
    net_split_free(&f->split);
    net_state_free(&f->state);
    free(f);
}
