/*
 * The matrix displacement method (Argyris and Scharpf; Blendermann 71-76): no cuts; nodes and
 * joints alike move by K^{-1} times the forces that are out of balance.  It is the same machine on
 * a finer net, each element a rope of its own that only pulls.
 */
#include "num/mem.h"
#include "phys/network.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Joints of a rope; 0 for a bar. */
static int joints(const struct net_rope *r)
{
    return r->rope.elements - 1;
}

/* The load at joint k of rope r, from 1. */
static void joint_force(const struct rope *r, int k, double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = r->load ? r->load[3 * (k - 1) + i] : r->q[i] * r->L0 / r->elements;
}

/* Nodes: those of net, then the joints of each rope; first[r]: rope r's first element. */
static void refine(const struct net *net, struct net *fine, int *first)
{
    int node = net->n, rope = 0;

    memcpy(fine->node, net->node, sizeof *net->node * (size_t)net->n);
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        double end[3];

        rope_end_load(&p->rope, end);
        for (int i = 0; i < 3; i++) {
            fine->node[p->a].force[i] += end[i];
            fine->node[p->b].force[i] += end[i];
        }
        first[r] = rope;
        for (int k = 1; k <= p->rope.elements; k++, rope++) {
            struct net_rope *e = &fine->rope[rope];

            *e = (struct net_rope){.a = k == 1 ? p->a : node - 1,
                                   .b = k == p->rope.elements ? p->b : node,
                                   .pulls = joints(p) > 0 || p->pulls};
            e->rope = (struct rope){.law = p->rope.law,
                                    .L0 = p->rope.L0 / p->rope.elements,
                                    .elements = 1};
            if (k == p->rope.elements)
                continue;
            fine->node[node] = (struct net_node){.x = {NAN, NAN, NAN}};
            joint_force(&p->rope, k, fine->node[node++].force);
        }
    }
}

static enum status solve_fine(const struct net *fine, const struct net_options *o,
                              struct net_state *s)
{
    struct net_work w;
    enum status status = net_work_new(fine, &w);

    w.reference = net_reference(fine);
    if (status == SW_OK)
        status = net_begin(fine, &w, s);
    if (status == SW_OK)
        status = net_iterate(fine, o, &w, s);
    if (status == SW_OK || status == SW_NOCONV)
        memcpy(s->t, w.bar, 3 * sizeof *s->t * (size_t)fine->m);
    net_work_free(&w);
    return status;
}

/* Room for the finer net and its state. */
static enum status new_fine(const struct net *net, const struct net_options *o, struct net *fine,
                            int **first, struct net_state *s)
{
    size_t n = (size_t)net->n, m = 0;

    for (int r = 0; r < net->m; r++) {
        if (net->rope[r].rope.elements == 0)
            return SW_ADMISSIBLE;
        n += (size_t)joints(&net->rope[r]);
        m += (size_t)net->rope[r].rope.elements;
    }
    *fine = (struct net){.n = (int)n,
                         .m = (int)m,
                         .node = mem_zeroed(n, sizeof *fine->node),
                         .rope = mem_zeroed(m, sizeof *fine->rope)};
    *first = mem_zeroed((size_t)net->m, sizeof **first);
    *s = (struct net_state){.x = mem_doubles(3 * n),
                            .t = mem_doubles(3 * m),
                            .residual = mem_doubles(3 * n),
                            .step = mem_zeroed((size_t)o->steps + 1, sizeof *s->step)};
    return fine->node && fine->rope && *first && s->x && s->t && s->residual && s->step ? SW_OK
                                                                                        : SW_NOMEM;
}

/* The tension that stands for rope r: that of its element that carries least.  One that is slack
 * gets what its smoothed chord needs. */
static void take_tension(const struct net *net, int r, const struct net *fine, int first,
                         const struct net_state *moved, double t[3])
{
    struct rope *p = &net->rope[r].rope;
    double carried[3] = {0, 0, 0}, load[3], least = INFINITY, d[3], slack;
    int at = first;

    for (int k = 0; k < p->elements; k++) {
        const double *now = moved->t + 3 * (first + k);
        double size = hypot(hypot(now[0], now[1]), now[2]);

        for (int i = 0; i < 3 && k > 0; i++) {
            joint_force(p, k, load);
            carried[i] += load[i];
        }
        if (!(size < least))
            continue;
        least = size;
        at = first + k;
        memcpy(p->offset, carried, sizeof carried);
    }
    memcpy(t, moved->t + 3 * at, 3 * sizeof *t);
    for (int i = 0; i < 3; i++)
        d[i] = moved->x[3 * fine->rope[at].b + i] - moved->x[3 * fine->rope[at].a + i];
    slack =
        fine->rope[at].rope.L0 * fine->rope[at].rope.L0 - d[0] * d[0] - d[1] * d[1] - d[2] * d[2];
    for (int i = 0; i < 3 && p->elements > 1 && slack > 0; i++)
        t[i] = p->epsilon / sqrt(slack) * d[i];
}

enum status net_displace(const struct net *net, const struct net_options *o, struct net_work *w,
                         struct net_state *s)
{
    struct net fine = {0};
    struct net_state moved = {.x = NULL};
    int *first = NULL;
    enum status status = new_fine(net, o, &fine, &first, &moved);

    if (status == SW_OK) {
        refine(net, &fine, first);
        moved.size = s->size;
        status = solve_fine(&fine, o, &moved);
    }
    if (status == SW_OK || status == SW_NOCONV || status == SW_INDEFINITE) {
        memcpy(s->x, moved.x, 3 * sizeof *s->x * (size_t)net->n);
        for (int r = 0; r < net->m; r++)
            take_tension(net, r, &fine, first[r], &moved, s->t + 3 * r);
        memcpy(s->step, moved.step, sizeof *s->step * ((size_t)moved.steps + 1));
        s->steps = moved.steps;
        s->worst = moved.worst < net->n ? moved.worst : -1;
        net_evaluate(net, s->x, s->t, w);
    }
    net_state_free(&moved);
    free(fine.node);
    free(fine.rope);
    free(first);
    return status;
}
