/* Loads of nets in the sea: drag, and friction of ropes that were split (Blendermann, Anhang). */
#include "phys/voyage.h"

#include <math.h>
#include <string.h>

#define LOOSE 1e-6  /* of the largest tension: lies as it likes */
#define LESS 0.5    /* of a renewal, where the last one did not bring loads nearer */
#define MORE 1.5    /* and where it did */
#define LEAST 0.02  /* of it, at the least */
#define USED 0.99   /* of the friction that there may be */
#define MARGIN 1e-3 /* of the friction that there may be */
#define SETTLED 12  /* rounds after which friction is no longer looked for */

/* Unit vector from a to b; upright where they are one. */
static void direction(const double *a, const double *b, double ret[3])
{
    double l;

    for (int i = 0; i < 3; i++)
        ret[i] = b[i] - a[i];
    l = net_length(ret);
    for (int i = 0; i < 3; i++)
        ret[i] = l > 0 ? ret[i] / l : i == 2;
}

/* Tension of element r, towards its end b. */
static double tension(const struct voyage *v, int r)
{
    double ta[3], tb[3];

    net_ends_now(v->net, v->s->t, &v->w, r, ta, tb);
    return net_length(ta);
}

/* Direction of element r in the current: one that lies slack has none of its own, and takes that of
 * its rope. */
static void face(const struct voyage *v, int r, double c[3])
{
    const struct net_rope *p = &v->net->rope[r];
    const double *a = v->s->x + 3 * p->a, *b = v->s->x + 3 * p->b;
    const double *way = v->net->node[p->b].way;

    if (way[0] == 0 && way[1] == 0)
        way = v->net->node[p->a].way;
    direction(a, b, c);
    if (v->w.hard == 0 || (way[0] == 0 && way[1] == 0) || tension(v, r) > LOOSE * v->s->scale ||
        (v->w.push[p->a] == 0 && v->w.push[p->b] == 0))
        return;
    memcpy(c, way, 2 * sizeof *way);
    c[2] = 0;
}

/* Drag of elements, half to each end, and of points. */
static void add_drag(const struct voyage *v, double *f)
{
    const struct net *net = v->net;
    const struct current *flow = &net->sea->current;
    const double *x = v->s->x;
    double U[3], c[3], drag[3];

    for (int r = 0; r < net->m && flow->n > 0; r++) {
        const struct net_rope *p = &net->rope[r];

        face(v, r, c);
        current_at(flow, (x[3 * p->a + 2] + x[3 * p->b + 2]) / 2, U, NULL);
        sea_drag(p->across, p->along, p->rope.L0, c, U, drag);
        for (int i = 0; i < 3; i++) {
            f[3 * p->a + i] += drag[i] / 2;
            f[3 * p->b + i] += drag[i] / 2;
        }
    }
    for (int i = 0; i < net->n && flow->n > 0; i++) {
        current_at(flow, x[3 * i + 2], U, NULL);
        for (int k = 0; k < 3; k++)
            f[3 * i + k] += net->node[i].drag * net_length(U) * U[k];
    }
}

/* Friction at a joint that lies, whose rope leads along c towards the pulled end, where it carries
 * T: what pushes it sideways is held if C times the bed's push can; what is left of that acts along
 * the rope, away from the pulled end, as long as there is tension.  Returns the tension beyond it.
 */
static double rub(const double c[3], double T, double most, const double load[3], double *f)
{
    double along = c[0] * load[0] + c[1] * load[1] + c[2] * load[2];
    double level = hypot(c[0], c[1]),
           h[2] = {level > 0 ? c[0] / level : 0, level > 0 ? c[1] / level : 0};
    double forward = h[0] * load[0] + h[1] * load[1];
    double side[2] = {load[0] - forward * h[0], load[1] - forward * h[1]};
    double size = hypot(side[0], side[1]), F;

    F = fmin(most, size);
    for (int i = 0; i < 2 && size > 0; i++)
        f[i] -= F * side[i] / size;
    most = sqrt(most * most - F * F);
    F = fmax(-most, fmin(most, T + along)); /* what would slide down is held, too */
    for (int i = 0; i < 3; i++)
        f[i] -= F * c[i];
    return fmax(0, T + along - F);
}

/* Friction of a rope that was split into the elements first..last, from where it meets the bed on
 * the pulled side on. */
static void add_friction(const struct voyage *v, int first, int last)
{
    const struct net *net = v->net;
    const double *x = v->s->x;
    int lies = 0;
    enum touch_pulled pulled = net->rope[first].pulled;
    double T = 0;

    for (int k = 0; k < last - first && pulled != TOUCH_ALIKE; k++) {
        const struct net_rope *p = &net->rope[pulled == TOUCH_PULLED_B ? last - k : first + k];
        int to = pulled == TOUCH_PULLED_B ? p->b : p->a, joint = to == p->b ? p->a : p->b;
        double c[3], n[3], load[3];

        if (!lies && !(v->w.push[joint] > 0))
            continue;
        if (!lies)
            T = tension(v, (int)(p - net->rope));
        lies = 1;
        direction(x + 3 * joint, x + 3 * to, c);
        net_bed_normal(net, x, joint, n);
        for (int i = 0; i < 3; i++)
            load[i] = v->base[3 * joint + i] + v->fresh[3 * joint + i] + v->w.push[joint] * n[i];
        T = rub(c, T, p->friction * v->w.push[joint], load, v->held + 3 * joint);
    }
}

/* Joints between the elements first..last: the heading of their rope. */
static void find_way(const struct voyage *v, int first, int last)
{
    const double *a = v->s->x + 3 * v->net->rope[first].a, *b = v->s->x + 3 * v->net->rope[last].b;
    double d[2] = {b[0] - a[0], b[1] - a[1]}, l = hypot(d[0], d[1]);

    for (int r = first; r < last; r++)
        for (int c = 0; c < 2; c++)
            v->net->node[v->net->rope[r].b].way[c] = l > 0 ? d[c] / l : 0;
}

/* Joints whose friction is not used up stay where they are from now on: springs along the bed,
 * whose forces are the last of the friction. */
static void stick(const struct voyage *v, const struct net_split *split, int ropes)
{
    for (int r = 0; r < ropes; r++)
        for (int e = split->first[r]; e < split->first[r + 1] - 1; e++) {
            int i = v->net->rope[e].b;
            struct net_node *node = &v->net->node[i];
            double most = v->net->rope[e].friction * v->w.push[i];

            if (!(net_length(v->held + 3 * i) < USED * most))
                continue;
            node->K[SYM_XX] = node->K[SYM_YY] = v->w.hard;
            memcpy(node->anchor, v->s->x + 3 * i, sizeof node->anchor);
        }
}

/* What friction does at a joint: its load, and the spring where it sticks. */
static void friction_at(const struct voyage *v, int i, double ret[3])
{
    const struct net_node *p = &v->net->node[i];

    for (int c = 0; c < 3; c++)
        ret[c] =
            v->held[3 * i + c] - (c < 2 ? p->K[SYM_XX] * (v->s->x[3 * i + c] - p->anchor[c]) : 0);
}

/* Joints that are held by more than C times the bed's push slip: what they are held by goes back to
 * that, and stays. */
static void slip(const struct voyage *v, const struct net_split *split, int ropes)
{
    for (int r = 0; r < ropes; r++)
        for (int e = split->first[r]; e < split->first[r + 1] - 1; e++) {
            int i = v->net->rope[e].b;
            struct net_node *node = &v->net->node[i];
            double most = v->net->rope[e].friction * v->w.push[i], f[3], size;

            friction_at(v, i, f);
            size = net_length(f);
            if (size <= most * (1 + MARGIN) + v->o->tolerance * v->s->scale)
                continue;
            node->K[SYM_XX] = node->K[SYM_YY] = 0;
            for (int c = 0; c < 3; c++)
                v->held[3 * i + c] = f[c] * most / size;
        }
}

/* What current and friction do in the present shape.  Friction is looked for in states near to
 * balance only: what a tension on the way has called forth would hold itself up.  The bed can hold
 * anything up to C times its push: after some rounds it holds what it then does, within that. */
void voyage_look(struct voyage *v, const struct net_split *split, int ropes, int near)
{
    size_t bytes = 3 * sizeof *v->fresh * (size_t)v->net->n;

    memset(v->fresh, 0, bytes);
    add_drag(v, v->fresh);
    for (int r = 0; r < ropes; r++)
        find_way(v, split->first[r], split->first[r + 1] - 1);
    v->rounds += near || v->rounds > 0;
    if (near && v->rounds < SETTLED && v->w.hard > 0) {
        memset(v->held, 0, bytes);
        for (int r = 0; r < ropes; r++)
            if (v->net->rope[split->first[r]].friction > 0)
                add_friction(v, split->first[r], split->first[r + 1] - 1);
    }
    if (v->rounds == SETTLED)
        stick(v, split, ropes);
    if (near && v->rounds >= SETTLED && v->w.hard > 0)
        slip(v, split, ropes);
    for (int i = 0; i < 3 * v->net->n; i++)
        v->fresh[i] += v->held[i];
}

/* Forces of nodes that are moved by loads: what is fixed takes any. */
void voyage_renew(struct voyage *v)
{
    double most = 0, part = v->part;

    for (int i = 0; i < 3 * v->net->n; i++) {
        double change = v->fresh[i] - v->load[i];

        most = fmax(most, v->w.dof[i] >= 0 ? fabs(change) : 0);
        v->load[i] += part * change;
        v->net->node[i / 3].force[i % 3] = v->base[i] + v->load[i];
    }
    v->part = most > v->before ? fmax(LEAST, v->part * LESS) : fmin(1, v->part * MORE);
    v->before = most;
}
