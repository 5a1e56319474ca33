/* What is told of ropes: ends, points, outlines. */
#include "phys/network.h"

#include <math.h>
#include <string.h>

void net_ends(const struct net *net, const struct net_state *s, int r, double ta[3], double tb[3])
{
    (void)net;
    memcpy(ta, s->end + 6 * r, 3 * sizeof *ta);
    memcpy(tb, s->end + 6 * r + 3, 3 * sizeof *tb);
}

/* Elements of a rope that was split; 0: it was not. */
static int elements_of(const struct net *net, const struct net_state *s, int r, int *ret_first)
{
    const int *first = s->fine ? s->fine->split.first : NULL;

    if (!first || net_is_bar(&net->rope[r]) ||
        (first[r + 1] - first[r] == 1 && !s->fine->split.fine.rope[first[r]].cut))
        return 0;
    *ret_first = first[r];
    return first[r + 1] - first[r];
}

/* Joints of a rope that was split into n elements from `first` on, seen from its node a. */
static void list_joints(const struct net_fine *fine, int first, int n, struct rope_point *point)
{
    const struct net *split = &fine->split.fine;
    const struct net_state *s = &fine->state;
    const double *a = s->x + 3 * split->rope[first].a;

    *point = (struct rope_point){.s = 0};
    for (int k = 0; k < n; k++, point++) {
        const struct net_rope *p = &split->rope[first + k];
        const double *end = s->end + 6 * (first + k), *b = s->x + 3 * p->b;
        double normal[3], slope, push = k < n - 1 ? s->push[p->b] : 0;
        struct rope_point *next = point + 1;

        net_bed_normal(split, s->x, p->b, normal);
        memcpy(point->t, end, sizeof point->t);
        point->strain = rope_strain(&p->rope.law, net_length(end), &slope);
        *next =
            (struct rope_point){.s = (k + 1) * p->rope.L0, .strain = point->strain, .bed = push};
        for (int i = 0; i < 3; i++) {
            next->x[i] = b[i] - a[i];
            next->t[i] = end[3 + i];
            if (k < n - 1)
                next->load[i] =
                    split->node[p->b].force[i] + s->drag[3 * p->b + i] + push * normal[i];
        }
        if (k < n - 1)
            memcpy(next->t, end + 6, sizeof next->t);
    }
}

int net_points(const struct net *net, const struct net_state *s, int r, struct rope_point *ret)
{
    const struct net_rope *p = &net->rope[r];
    const double *a = s->x + 3 * p->a, *b = s->x + 3 * p->b;
    int first, n = elements_of(net, s, r, &first);

    if (n > 0) {
        list_joints(s->fine, first, n, ret);
        return n + 1;
    }
    if (p->over)
        return net_over_points(net, p, a, b, ret);
    n = p->rope.elements > 0 ? p->rope.elements + 1 : NET_FREE_POINTS;
    rope_points(&p->rope, s->t + 3 * r, n, ret);
    for (int i = 0; i < 3 && net_is_bar(p); i++) /* a bar reaches from node to node */
        ret[1].x[i] = b[i] - a[i];
    return n;
}

static void outline_bar(const struct net_rope *p, const double *a, const double *b, double tension,
                        struct net_outline *ret)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};

    ret->length = net_length(d);
    ret->lowest = fmin(a[2], b[2]);
    ret->most = ret->least = ret->length < p->rope.L0 ? -tension : tension; /* compression */
}

/* Of a rope that was split into n elements. */
static void outline_split(const struct net_fine *fine, int first, int n, struct net_outline *ret)
{
    const struct net_state *s = &fine->state;

    *ret = (struct net_outline){.least = INFINITY, .lowest = INFINITY, .elements = n};
    for (int r = first; r < first + n; r++) {
        const struct net_rope *p = &fine->split.fine.rope[r];
        double T = net_length(s->end + 6 * r), slope;

        ret->most = fmax(ret->most, T);
        ret->least = fmin(ret->least, T);
        ret->lowest = fmin(ret->lowest, fmin(s->x[3 * p->a + 2], s->x[3 * p->b + 2]));
        ret->length += p->rope.L0 * (1 + rope_strain(&p->rope.law, T, &slope));
        if (r < first + n - 1 && s->push[p->b] > 0)
            ret->flat += p->rope.L0;
    }
}

void net_outline(const struct net *net, const struct net_state *s, int r, struct net_outline *ret)
{
    const struct net_rope *p = &net->rope[r];
    const double *a = s->x + 3 * p->a, *b = s->x + 3 * p->b;
    int first, n = elements_of(net, s, r, &first);

    if (n > 0) {
        outline_split(s->fine, first, n, ret);
        return;
    }
    if (p->over) {
        net_over_outline(net, p, a, b, ret);
        return;
    }
    *ret = (struct net_outline){.elements = p->rope.elements};
    if (net_is_bar(p)) {
        outline_bar(p, a, b, net_length(s->end + 6 * r), ret);
        return;
    }
    rope_extremes(&p->rope, s->t + 3 * r, &ret->most, &ret->least);
    ret->length = rope_length(&p->rope, s->t + 3 * r);
    ret->lowest = a[2] + rope_lowest(&p->rope, s->t + 3 * r);
}
