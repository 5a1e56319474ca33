/* Ropes over a plane bed, for given ends: forces and stiffness in space, shape (touch.h). */
#include "phys/network.h"
#include "phys/touch.h"

#include <math.h>
#include <string.h>

#define LOW 1e-6    /* of its length: a free node so near to the bed rests on it */
#define NARROW 1e-9 /* of its length: ends above each other */
#define HANGING 16  /* pieces of what hangs, at each end */
#define LYING 4     /* of a stretch that lies */
#define ROUND_OFF 1e-13
#define TINY 1e-14 /* of its weight: tension that is none */

/* Where the rope is in its vertical plane. */
struct stand {
    struct touch_rope rope;
    struct touch_place place;
    double c[2], g[2]; /* heading from a to b, gradient of the bed */
    double rise[2];    /* of place.h with the ends' heights */
};

int net_goes_over(const struct net *net, const struct net_rope *p)
{
    return net->sea && net->sea->bed.kind == BED_PLANE && net->sea->current.n == 0 &&
           p->rope.elements == 0 && p->rope.q[2] < 0 && p->rope.q[0] == 0 && p->rope.q[1] == 0;
}

/* Height of end i over the bed.  The force goes as its square root at first; so that round-off of a
 * node that rests on the bed does not shake it, the first millionths of the length count less. */
static void stand_end(const struct bed *bed, const struct net_node *node, const double *x,
                      double L0, int i, struct stand *s)
{
    double h = fmax(0, x[2] - bed_at(bed, x[0], x[1], s->g)), low = LOW * L0;
    int rests = !(node->held & 4) && h < low;

    s->place.h[i] = rests ? h * h / low : h;
    s->rise[i] = rests ? 2 * h / low : 1;
}

static void stand_up(const struct net *net, const struct net_rope *p, const double *a,
                     const double *b, struct stand *s)
{
    const struct bed *bed = &net->sea->bed;
    double d[2] = {b[0] - a[0], b[1] - a[1]}, x = hypot(d[0], d[1]);
    int narrow = !(x > NARROW * p->rope.L0);

    stand_end(bed, &net->node[p->a], a, p->rope.L0, 0, s);
    stand_end(bed, &net->node[p->b], b, p->rope.L0, 1, s);
    s->c[0] = narrow ? 1 : d[0] / x;
    s->c[1] = narrow ? 0 : d[1] / x;
    s->place.x = narrow ? NARROW * p->rope.L0 : x;
    s->place.slope = s->g[0] * s->c[0] + s->g[1] * s->c[1];
    s->rope = (struct touch_rope){.L0 = p->rope.L0,
                                  .w = -p->rope.q[2],
                                  .EA = p->rope.law.EA,
                                  .friction = p->friction,
                                  .pulled = p->pulled};
}

/* Stiffness of the six coordinates from the four of the plane: x, slope, h_a, h_b by the
 * coordinates, and the forces' own turning with the heading.  Not exact: the slope is taken as if
 * it did not change with the heading, for what that brings is not symmetric. */
static void stiffness(const struct stand *s, const struct touch *t, int exact, double K[36])
{
    double by[4][6] = {{0}}, x = s->place.x;

    for (int i = 0; i < 2; i++) {
        double turned = exact ? (s->g[i] - s->place.slope * s->c[i]) / x : 0;

        by[0][i] = -s->c[i];
        by[0][3 + i] = s->c[i];
        by[1][i] = -turned;
        by[1][3 + i] = turned;
        by[2][i] = -s->g[i] * s->rise[0];
        by[3][3 + i] = -s->g[i] * s->rise[1];
    }
    by[2][2] = s->rise[0];
    by[3][5] = s->rise[1];
    for (int j = 0; j < 6; j++)
        for (int end = 0; end < 2; end++) {
            double H = 0, V = 0, sign = end == 0 ? 1 : -1;

            for (int k = 0; k < 4; k++) {
                H += t->J[2 * end][k] * by[k][j];
                V += t->J[2 * end + 1][k] * by[k][j];
            }
            for (int i = 0; i < 2; i++) { /* force on a: H c, on b: - H c; K is minus its change */
                double turn = ((i == j % 3) - s->c[i] * (j % 3 < 2 ? s->c[j % 3] : 0)) / x;

                turn *= j % 3 == 2 ? 0 : j < 3 ? -1 : 1;
                K[3 * end + i + 6 * j] = -sign * (H * s->c[i] + t->H[end] * turn);
            }
            K[3 * end + 2 + 6 * j] = V;
        }
}

int net_over(const struct net *net, const struct net_rope *p, const double *a, const double *b,
             double pull[6], enum over how, double K[36])
{
    struct stand s;
    struct touch t;

    stand_up(net, p, a, b, &s);
    if (how == OVER_SMOOTH)
        s.rope.friction = 0;
    if (touch_solve(&s.rope, &s.place, &t) != SW_OK)
        return 0;
    for (int i = 0; i < 2; i++) {
        pull[i] = t.H[0] * s.c[i];
        pull[3 + i] = t.H[1] * s.c[i];
    }
    pull[2] = -t.V[0];
    pull[5] = t.V[1];
    if (K)
        stiffness(&s, &t, how == OVER_EXACT, K);
    return 1;
}

int net_over_lies(const struct net *net, const struct net_rope *p, const double *a, const double *b)
{
    struct stand s;
    struct touch t;

    stand_up(net, p, a, b, &s);
    return touch_solve(&s.rope, &s.place, &t) != SW_OK || t.lies;
}

/* Points are laid from one end towards what lies, at[0] the last one. */
struct walk {
    const struct net_rope *p;
    double dir[3]; /* along the bed, the way that is walked */
    struct rope_point *at;
};

static void step(struct walk *w, const double t[3], double l, const double chord[3])
{
    struct rope_point *at = w->at, *next = ++w->at;

    *next = (struct rope_point){.s = at->s + l};
    for (int i = 0; i < 3; i++) {
        next->t[i] = t[i];
        next->load[i] = at->t[i] - t[i];
        next->x[i] = at->x[i] + chord[i];
    }
}

/* What hangs, down to the tension `to`. */
static void hang(struct walk *w, const double to[3], double l, int n)
{
    struct rope piece = {.law = w->p->rope.law, .L0 = l / n, .q = {0, 0, w->p->rope.q[2]}};

    piece.epsilon = TINY * fabs(piece.q[2]) * l; /* slack ropes hang plumb, down to no tension */

    for (int k = 1; k <= n && l > 0; k++) {
        const double *now = w->at->t;
        double t[3] = {to[0], to[1], now[2] - piece.q[2] * piece.L0}, chord[3];

        rope_chord(&piece, now, chord, NULL);
        step(w, k == n ? to : t, piece.L0, chord);
    }
}

/* What lies with a tension that falls from one to the other. */
static void lie(struct walk *w, double from, double to, double l, int n)
{
    for (int k = 0; k < n && l > 0; k++) {
        double T = from + (to - from) * (k + 1) / n, t[3], chord[3];
        double stretch = (from + (to - from) * (k + 0.5) / n) / w->p->rope.law.EA;

        for (int i = 0; i < 3; i++) {
            t[i] = T * w->dir[i];
            chord[i] = l / n * (1 + stretch) * w->dir[i];
        }
        step(w, t, l / n, chord);
        w->at->bed = w->at->load[2] - w->p->rope.q[2] * l / n;
    }
}

/* What lies without tension leads straight to a place. */
static void lie_slack(struct walk *w, const double to[3], double l, int n)
{
    const double none[3] = {0, 0, 0}, *from = w->at->x;
    const double chord[3] = {(to[0] - from[0]) / n, (to[1] - from[1]) / n, (to[2] - from[2]) / n};

    for (int k = 0; k < n; k++) {
        step(w, none, l / n, chord);
        w->at->bed = -w->p->rope.q[2] * l / n;
    }
}

/* End i of the rope and what lies there with tension, from the node on, tensions pointing inwards.
 */
static void walk_in(const struct stand *s, const struct touch *t, int i, struct walk *w)
{
    double sign = i == 0 ? 1 : -1, cosine = 1 / hypot(1, s->place.slope), meets[3];

    w->dir[0] = sign * s->c[0] * cosine;
    w->dir[1] = sign * s->c[1] * cosine;
    w->dir[2] = sign * s->place.slope * cosine;
    for (int c = 0; c < 3; c++) {
        w->at->t[c] = c < 2 ? sign * t->H[i] * s->c[c] : -t->V[i];
        meets[c] = t->T[i] * w->dir[c];
    }
    hang(w, meets, t->s[i], HANGING);
    lie(w, t->T[i], fmax(0, t->T[i] - t->fall[i] * t->reach[i]), t->reach[i], LYING);
}

/* The walk that came in from b, backwards. */
static void walk_out(struct walk *w, const struct rope_point *from, const struct rope_point *end)
{
    for (; end > from; end--) {
        const struct rope_point *next = end - 1;
        double l = end->s - next->s;
        struct rope_point *now = w->at;

        *++w->at = *next;
        w->at->s = now->s + l;
        w->at->bed = end->bed;
        for (int c = 0; c < 3; c++) {
            w->at->t[c] = -next->t[c];
            w->at->load[c] = now->t[c] - w->at->t[c];
        }
    }
}

int net_over_points(const struct net *net, const struct net_rope *p, const double *a,
                    const double *b, struct rope_point *ret)
{
    struct rope_point back[HANGING + LYING + 1] = {{.s = 0}};
    struct walk w = {.p = p, .at = ret}, in = {.p = p, .at = back};
    struct stand s;
    struct touch t;
    double slope, L0 = p->rope.L0;

    stand_up(net, p, a, b, &s);
    *ret = (struct rope_point){.s = 0};
    if (touch_solve(&s.rope, &s.place, &t) != SW_OK)
        return 1;
    if (t.lies) {
        double slack = t.flat - t.reach[0] - t.reach[1];

        for (int c = 0; c < 3; c++)
            back->x[c] = b[c] - a[c];
        walk_in(&s, &t, 0, &w);
        walk_in(&s, &t, 1, &in);
        if (slack > ROUND_OFF * L0)
            lie_slack(&w, in.at->x, slack, LYING);
        walk_out(&w, back, in.at);
    } else {
        const double tb[3] = {t.H[1] * s.c[0], t.H[1] * s.c[1], t.V[1]};

        for (int c = 0; c < 3; c++)
            ret->t[c] = c < 2 ? t.H[0] * s.c[c] : -t.V[0];
        hang(&w, tb, L0, NET_POINTS - 1);
    }
    w.at->s = L0;
    for (struct rope_point *k = ret; k <= w.at; k++)
        k->strain = rope_strain(&p->rope.law, net_length(k->t), &slope);
    return (int)(w.at - ret) + 1;
}

void net_over_outline(const struct net *net, const struct net_rope *p, const double *a,
                      const double *b, struct net_outline *ret)
{
    struct rope_point point[NET_POINTS];
    struct stand s;
    struct touch t;
    int n = net_over_points(net, p, a, b, point);

    stand_up(net, p, a, b, &s);
    *ret = (struct net_outline){.least = INFINITY, .lowest = INFINITY};
    if (touch_solve(&s.rope, &s.place, &t) == SW_OK)
        ret->flat = t.flat;
    for (int k = 0; k < n; k++) {
        ret->most = fmax(ret->most, net_length(point[k].t));
        ret->least = fmin(ret->least, net_length(point[k].t));
        ret->lowest = fmin(ret->lowest, a[2] + point[k].x[2]);
        if (k + 1 < n) { /* stretched length, by the tension between */
            struct rope piece = {.law = p->rope.law, .L0 = point[k + 1].s - point[k].s};

            for (int i = 0; i < 3; i++)
                piece.q[i] = piece.L0 > 0 ? point[k + 1].load[i] / piece.L0 : 0;
            ret->length += net_length(point[k].t) + net_length(point[k + 1].t) > 0
                               ? rope_length(&piece, point[k].t)
                               : piece.L0;
        }
    }
}
