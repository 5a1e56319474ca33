/* Equilibrium of systems of ropes: state, methods, end. */
#include "num/mem.h"
#include "phys/network.h"

#include <stdlib.h>
#include <string.h>

enum status net_state_new(const struct net *net, const struct net_options *o, struct net_state *s)
{
    size_t n = 3 * (size_t)net->n, m = 3 * (size_t)net->m;

    *s = (struct net_state){.worst = -1};
    s->x = mem_doubles(n);
    s->t = mem_doubles(m);
    s->end = mem_doubles(2 * m);
    s->residual = mem_doubles(n);
    s->push = mem_doubles((size_t)net->n);
    s->drag = mem_doubles(n);
    s->step = mem_zeroed((size_t)o->steps + 1, sizeof *s->step);
    return s->x && s->t && s->end && s->residual && s->push && s->drag && s->step ? SW_OK
                                                                                  : SW_NOMEM;
}

void net_state_free(struct net_state *s)
{
    free(s->x);
    free(s->t);
    free(s->end);
    free(s->residual);
    free(s->push);
    free(s->drag);
    free(s->step);
    net_fine_free(s->fine);
    *s = (struct net_state){.x = NULL};
}

/* Bars follow from the positions. */
static void take_ends(const struct net *net, const struct net_work *w, struct net_state *s)
{
    for (int r = 0; r < net->m; r++) {
        if (net_is_bar(&net->rope[r]))
            memcpy(s->t + 3 * r, w->bar + 3 * r, 3 * sizeof *s->t);
        net_ends_now(net, s->t, w, r, s->end + 6 * r, s->end + 6 * r + 3);
        if (net->rope[r].over)
            memcpy(s->t + 3 * r, s->end + 6 * r, 3 * sizeof *s->t);
    }
}

enum status net_conclude(const struct net *net, const struct net_options *o, enum status s,
                         const struct net_work *w, struct net_state *ret)
{
    struct net_step end;

    if (s != SW_OK && s != SW_NOCONV)
        return s;
    memcpy(ret->residual, w->residual, 3 * sizeof *ret->residual * (size_t)net->n);
    take_ends(net, w, ret);
    ret->hard = w->hard;
    if (w->hard > 0)
        memcpy(ret->push, w->push, sizeof *ret->push * (size_t)net->n);
    end = net_measure(net, ret->t, w, ret);
    end.factor = ret->step[ret->steps].factor;
    ret->step[ret->steps] = end; /* what there is, by whatever method */
    return net_is_met(&end, ret, o->tolerance) ? SW_OK : SW_NOCONV;
}

void net_prepare(struct net *net, struct net_work *w, struct net_state *s)
{
    s->size = net_size(net);
    w->reference = net_reference(net);
    net_smooth(net, NET_SHARP, w->reference, 0);
    for (int r = 0; r < net->m; r++) {
        memset(net->rope[r].rope.offset, 0, sizeof net->rope[r].rope.offset);
        net->rope[r].over = 0;
    }
}

enum status net_solve_dry(struct net *net, const struct net_options *o, struct net_state *ret)
{
    struct net_work w = {.dof = NULL};
    enum status s = net_state_new(net, o, ret);

    if (s == SW_OK)
        s = net_work_new(net, &w);
    if (s == SW_OK) {
        net_prepare(net, &w, ret);
        if (o->method == NET_IMAGINARY)
            s = net_imaginary(net, o, &w, ret);
        else if (o->method == NET_DISPLACEMENT)
            s = net_displace(net, o, &w, ret);
        else
            s = net_begin(net, &w, ret);
    }
    if (s == SW_OK && o->method == NET_GAP)
        s = net_iterate_all_ways(net, o, &w, ret);
    s = net_conclude(net, o, s, &w, ret);
    net_work_free(&w);
    if (s == SW_NOMEM)
        net_state_free(ret);
    return s;
}

enum status net_solve(struct net *net, const struct net_options *o, struct net_state *ret)
{
    return net->sea ? net_solve_in_sea(net, o, ret) : net_solve_dry(net, o, ret);
}
