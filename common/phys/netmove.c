/*
 * The matrix displacement method (Argyris and Scharpf; Blendermann 71-76): no cuts; nodes and
 * joints alike move by K^{-1} times the forces that are out of balance.  It is the same machine on
 * a finer net, each element a rope of its own that only pulls.
 */
#include "num/mem.h"
#include "phys/network.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static enum status solve_fine(const struct net *fine, const struct net_options *o,
                              struct net_state *s)
{
    struct net_work w;
    enum status status = net_work_new(fine, &w);

    w.reference = net_reference(fine);
    if (status == SW_OK)
        status = net_begin(fine, &w, s);
    if (status == SW_OK)
        status = net_iterate(fine, o, o->tolerance, o->steps, INT_MAX, &w, s);
    if (status == SW_OK || status == SW_NOCONV)
        memcpy(s->t, w.bar, 3 * sizeof *s->t * (size_t)fine->m);
    net_work_free(&w);
    return status;
}

/* All ropes to elements; SW_ADMISSIBLE: one is continuous. */
static enum status split_all(const struct net *net, struct net_split *ret)
{
    int *parts = mem_zeroed((size_t)net->m, sizeof *parts), continuous = 0;
    enum status status = parts ? SW_OK : SW_NOMEM;

    for (int r = 0; r < net->m && parts; r++) {
        parts[r] = net->rope[r].rope.elements;
        continuous |= parts[r] == 0;
    }
    if (status == SW_OK)
        status = continuous ? SW_ADMISSIBLE : net_split_new(net, parts, 0, ret);
    free(parts);
    return status;
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
            rope_joint_load(p, p->elements, k, load);
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

/* State s of the net by that of its split one, solved or not. */
static void take_state(const struct net *net, const struct net_split *split,
                       const struct net_state *moved, struct net_work *w, struct net_state *s)
{
    memcpy(s->x, moved->x, 3 * sizeof *s->x * (size_t)net->n);
    for (int r = 0; r < net->m; r++)
        take_tension(net, r, &split->fine, split->first[r], moved, s->t + 3 * r);
    memcpy(s->step, moved->step, sizeof *s->step * ((size_t)moved->steps + 1));
    s->steps = moved->steps;
    s->worst = moved->worst < net->n ? moved->worst : -1;
    net_evaluate(net, s->x, s->t, w);
}

enum status net_displace(const struct net *net, const struct net_options *o, struct net_work *w,
                         struct net_state *s)
{
    struct net_split split = {.first = NULL};
    struct net_state moved = {.x = NULL};
    enum status status = split_all(net, &split);

    if (status == SW_OK)
        status = net_state_new(&split.fine, o, &moved);
    if (status == SW_OK) {
        moved.size = s->size;
        status = solve_fine(&split.fine, o, &moved);
        if (status == SW_OK || status == SW_NOCONV || status == SW_INDEFINITE)
            take_state(net, &split, &moved, w, s);
    }
    net_state_free(&moved);
    net_split_free(&split);
    return status;
}
