/* Lengths of ropes, or places of their anchors, that give wanted tensions. */
#include "num/dense.h"
#include "num/mem.h"
#include "phys/network.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STEPS 60
#define TRIALS 30  /* halvings of a step */
#define PROBE 1e-6 /* of the length: for the change of tensions */
#define FAR 0.05   /* of the length: the longest step */

struct tuning {
    struct net *net;
    const struct net_options *o;
    const struct net_target *target;
    int k;
    double *u, *best;   /* (k) what is changed, from where it was [m] */
    double *off, *next; /* (k) tensions over the wanted ones, less 1 */
    double *A, *step;   /* (k, k), (k) */
    double *L0;         /* (k) lengths at the beginning */
    double (*x)[3];     /* (k) places of the anchors */
    double (*way)[3];   /* (k) headings along which anchors move away from the other end */
};

/* The end of a rope that is no anchor. */
static int far_end(const struct net *net, const struct net_target *t)
{
    const struct net_rope *p = &net->rope[t->rope];

    return p->a == t->anchor ? p->b : p->a;
}

/* Lengths and anchors as u has them; an anchor stays on the bed if there is one. */
static void set(const struct tuning *q, const double *u)
{
    for (int i = 0; i < q->k; i++) {
        const struct net_target *t = &q->target[i];

        if (t->anchor < 0) {
            q->net->rope[t->rope].rope.L0 = q->L0[i] + u[i];
            continue;
        }
        for (int c = 0; c < 3; c++)
            q->net->node[t->anchor].x[c] = q->x[i][c] + u[i] * q->way[i][c];
        if (q->net->sea && q->net->sea->bed.kind != BED_NONE) {
            const double *x = q->net->node[t->anchor].x;
            const struct bed *bed = &q->net->sea->bed;

            q->net->node[t->anchor].x[2] +=
                bed_at(bed, x[0], x[1], NULL) - bed_at(bed, q->x[i][0], q->x[i][1], NULL);
        }
    }
}

/* Solve with u: off, over the wanted tension, less 1; the largest of it. */
static enum status look(const struct tuning *q, const double *u, double *off, double *ret_most,
                        struct net_state *s)
{
    enum status status;

    set(q, u);
    status = net_settle(q->net, q->o, s);
    *ret_most = 0;
    for (int i = 0; i < q->k && status == SW_OK; i++) {
        double ta[3], tb[3];
        int at_a = q->net->rope[q->target[i].rope].a == q->target[i].at;

        net_ends(q->net, s, q->target[i].rope, ta, tb);
        off[i] = net_length(at_a ? ta : tb) / q->target[i].tension - 1;
        *ret_most = fmax(*ret_most, fabs(off[i]));
    }
    return status;
}

/* Change of the tensions by each u, by differences. */
static enum status probe(const struct tuning *q)
{
    enum status s = SW_OK;

    for (int j = 0; j < q->k && s == SW_OK; j++) {
        struct net_state now;
        double most, h = PROBE * q->L0[j];

        q->u[j] += h;
        s = look(q, q->u, q->next, &most, &now);
        q->u[j] -= h;
        net_state_free(&now);
        for (int i = 0; i < q->k; i++)
            q->A[i + (long)q->k * j] = (q->next[i] - q->off[i]) / h;
    }
    return s;
}

/* Newton's step, shortened until the tensions come nearer; *s is the state there. */
static enum status step_on(const struct tuning *q, double *most, struct net_state *s)
{
    double factor = 1;
    enum status status = probe(q);

    memcpy(q->step, q->off, sizeof *q->off * (size_t)q->k);
    if (status == SW_OK)
        status = dense_solve(q->k, q->A, 1, q->step);
    if (status == SW_INDEFINITE) /* nothing changes a tension: slack ropes */
        return SW_NOCONV;
    for (int i = 0; i < q->k; i++)
        factor = fmin(factor, FAR * q->L0[i] / fabs(q->step[i]));
    /* NOLINTNEXTLINE(cert-flp30-c): trial counts the rounds */
    for (int trial = 0; trial < TRIALS && status == SW_OK; trial++, factor /= 2) {
        struct net_state now;
        double left = INFINITY;

        for (int i = 0; i < q->k; i++)
            q->best[i] = q->u[i] - factor * q->step[i];
        status = look(q, q->best, q->next, &left, &now);
        if (status == SW_OK && left < *most) {
            net_state_free(s);
            *s = now;
            *most = left;
            memcpy(q->u, q->best, sizeof *q->u * (size_t)q->k);
            memcpy(q->off, q->next, sizeof *q->off * (size_t)q->k);
            return SW_OK;
        }
        net_state_free(&now);
        status = status == SW_NOCONV || status == SW_INDEFINITE ? SW_OK : status;
    }
    return status == SW_OK ? SW_NOCONV : status;
}

static enum status begin(struct net *net, const struct net_options *o,
                         const struct net_target *target, int k, struct tuning *q)
{
    size_t n = (size_t)k;

    *q = (struct tuning){net,
                         o,
                         target,
                         k,
                         mem_doubles(n),
                         mem_doubles(n),
                         mem_doubles(n),
                         mem_doubles(n),
                         mem_doubles(n * n),
                         mem_doubles(n),
                         mem_doubles(n),
                         mem_zeroed(n, sizeof *q->x),
                         mem_zeroed(n, sizeof *q->way)};
    if (!q->u || !q->best || !q->off || !q->next || !q->A || !q->step || !q->L0 || !q->x || !q->way)
        return SW_NOMEM;
    for (int i = 0; i < k; i++)
        q->L0[i] = net->rope[target[i].rope].rope.L0;
    return SW_OK;
}

static void end(struct tuning *q)
{
    void *const all[] = {q->u, q->best, q->off, q->next, q->A, q->step, q->L0, q->x, q->way};

    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
}

/* Anchors move away from the other ends of their ropes, as these stand. */
static void find_ways(const struct tuning *q, const struct net_state *s)
{
    for (int i = 0; i < q->k; i++) {
        int anchor = q->target[i].anchor;
        const double *other;
        double l;

        if (anchor < 0)
            continue;
        other = s->x + 3 * far_end(q->net, &q->target[i]);
        memcpy(q->x[i], q->net->node[anchor].x, sizeof q->x[i]);
        l = hypot(q->x[i][0] - other[0], q->x[i][1] - other[1]);
        for (int c = 0; c < 2; c++)
            q->way[i][c] = l > 0 ? (q->x[i][c] - other[c]) / l : c == 0;
    }
}

enum status net_tune(struct net *net, const struct net_options *o, const struct net_target *target,
                     int k, struct net_state *ret)
{
    struct tuning q;
    double most = 0;
    enum status s = begin(net, o, target, k, &q);

    *ret = (struct net_state){.worst = -1};
    if (s == SW_OK)
        s = net_settle(net, o, ret);
    if (s == SW_OK) {
        find_ways(&q, ret);
        net_state_free(ret);
        s = look(&q, q.u, q.off, &most, ret);
    }
    for (int i = 0; i < STEPS && s == SW_OK && most > NET_TUNED; i++)
        s = step_on(&q, &most, ret);
    if (s == SW_OK || s == SW_NOCONV)
        set(&q, q.u);
    end(&q);
    return s == SW_OK && most > NET_TUNED ? SW_NOCONV : s;
}
