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

/* Points of a rope that was split, and their number; 0: it was not. */
static int joints(const struct net_state *s, int r, const struct rope_point **ret)
{
    if (!s->joints.first)
        return 0;
    *ret = s->joints.point + s->joints.first[r];
    return s->joints.first[r + 1] - s->joints.first[r];
}

int net_points(const struct net *net, const struct net_state *s, int r, struct rope_point *ret)
{
    const struct net_rope *p = &net->rope[r];
    const double *a = s->x + 3 * p->a, *b = s->x + 3 * p->b;
    const struct rope_point *point;
    int n = joints(s, r, &point);

    if (n > 0) {
        memcpy(ret, point, (size_t)n * sizeof *ret);
        return n;
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

/* Of joints, n of them: elements carry the tension behind their first joint. */
static void outline_joints(const struct rope_point *point, int n, double z, struct net_outline *ret)
{
    *ret = (struct net_outline){.least = INFINITY, .lowest = INFINITY, .elements = n - 1};
    for (int k = 0; k < n; k++) {
        double T = net_length(point[k].t), l = k + 1 < n ? point[k + 1].s - point[k].s : 0;

        ret->most = fmax(ret->most, T);
        ret->least = fmin(ret->least, T);
        ret->lowest = fmin(ret->lowest, z + point[k].x[2]);
        ret->length += l * (1 + point[k].strain);
        if (k > 0 && k + 1 < n && point[k].bed > 0)
            ret->flat += l;
    }
}

void net_outline(const struct net *net, const struct net_state *s, int r, struct net_outline *ret)
{
    const struct net_rope *p = &net->rope[r];
    const double *a = s->x + 3 * p->a, *b = s->x + 3 * p->b;
    const struct rope_point *point;
    int n = joints(s, r, &point);

    if (n > 0) {
        outline_joints(point, n, a[2], ret);
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
