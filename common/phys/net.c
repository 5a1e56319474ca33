/* Equilibrium of systems of ropes: the gap method. */
#include "phys/net.h"
#include "num/mem.h"
#include "phys/network.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ENOUGH 0.3      /* of the first slope: a shortened step ends there */
#define FEWER_TRIALS 25 /* over a bed */
#define NEARER 0.25     /* of what is missing, squared: a step that does so is good */
#define TRIALS 80       /* of a step's length */
#define ROUND_OFF 1e-13 /* of the products of tensions and lengths */
#define BRIEF 0.1       /* a short step */
#define SHORT_STEPS 2   /* of them: another way */
#define STAGE 0.01      /* gap over a rope's length that ends a stage */
#define SOFT_STEPS 9    /* in a stage of ropes that give */
#define GIVE_END 0.1    /* of a rope's own: no longer matters */
#define GIVE_UP 0.9     /* a stage that takes off less is none */
#define STAGES 28       /* of smoothing, two for a power of ten */
#define ROUGH 1e-7      /* smoothing, of a rope's load, with which a solution is looked for */
#define SHARPEN 50      /* steps for a power of ten between them */
#define CLOSED 1e-13    /* a gap that no step makes smaller */
#define POLISH 3        /* steps behind the tolerance that may still bring something */

/* Trial state: x1, t1 = x, t + factor times the step. */
static void try_step(const struct net *net, const struct net_state *s, double factor,
                     struct net_work *w)
{
    for (int i = 0; i < 3 * net->n; i++)
        w->x1[i] = s->x[i] + factor * w->dx[i];
    for (int i = 0; i < 3 * net->m; i++)
        w->t1[i] = s->t[i] + factor * w->dt[i];
    net_evaluate(net, w->x1, w->t1, w);
}

/* Minus gaps times dt and residuals times dx: negative before the step, zero at its best end. */
static double slope(const struct net *net, const struct net_work *w)
{
    double sum = 0;

    for (int i = 0; i < 3 * net->m; i++)
        if (!net_is_placed(&net->rope[i / 3]))
            sum -= w->gap[i] * w->dt[i];
    for (int i = 0; i < 3 * net->n; i++)
        if (w->dof[i] >= 0)
            sum -= w->residual[i] * w->dx[i];
    return sum;
}

/* Of slopes: where statics alone gives the tensions, nothing else is left of them. */
static double round_off(const struct net *net, const struct net_state *s, const struct net_work *w)
{
    double sum = 0;

    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        const double *K = w->K + SYM * r;
        double moved = 0, gap = net_length(w->gap + 3 * r);

        for (int i = 0; i < 3; i++)
            moved += fabs(w->dx[3 * p->b + i] - w->dx[3 * p->a + i]);
        if (p->over) /* forces that follow from positions */
            sum += net_length(w->pull + 6 * r) * p->rope.L0 + p->rope.law.EA * moved;
        sum += net_length(s->t + 3 * r) * p->rope.L0 +
               (K[SYM_XX] + K[SYM_YY] + K[SYM_ZZ]) * gap * (gap + moved);
    }
    return ROUND_OFF * sum;
}

/* Gaps over the size and residuals over the largest tension, squared. */
static double missing(const struct net *net, const struct net_state *s, const struct net_work *w)
{
    double sum = 0;

    for (int i = 0; i < 3 * net->m; i++)
        sum += w->gap[i] * w->gap[i] / (s->size * s->size);
    for (int i = 0; i < 3 * net->n; i++)
        if (w->dof[i] >= 0)
            sum += w->residual[i] * w->residual[i] / (s->scale * s->scale);
    return sum;
}

/* A factor at which the slope has nearly vanished, or the whole step: by regula falsi (Illinois).
 * The trial state stands there. */
static double search(const struct net *net, const struct net_state *s, struct net_work *w)
{
    double first = slope(net, w), low = 0, high = 1, at_low = first, at_high, factor = 1;
    double enough = ENOUGH * fabs(first) + round_off(net, s, w), before = missing(net, s, w);

    try_step(net, s, 1, w);
    at_high = slope(net, w);
    if (at_high <= enough)
        return 1;
    if (w->hard > 0 && missing(net, s, w) < NEARER * before)
        return 1; /* friction and slopes of the bed are no convex ground */
    for (int k = 0; k < (w->hard > 0 ? FEWER_TRIALS : TRIALS); k++) {
        double now;

        factor = isfinite(at_high) ? (low * at_high - high * at_low) / (at_high - at_low)
                                   : (low + high) / 2;
        if (!(factor > low && factor < high) || k % 4 == 3)
            factor = low + (high - low) * (low == 0 ? 0.1 : 0.5);
        try_step(net, s, factor, w);
        now = slope(net, w);
        if (fabs(now) <= enough)
            break;
        if (now < 0) {
            low = factor;
            at_low = now;
            at_high /= 2;
        } else {
            high = factor;
            at_high = now;
            at_low /= 2;
        }
    }
    return factor;
}

/* Tensions of chains stand for those of their least loaded elements. */
static void refer(const struct net *net, double *t)
{
    for (int r = 0; r < net->m; r++)
        if (net->rope[r].rope.elements > 1)
            rope_refer(&net->rope[r].rope, t + 3 * r);
}

static void take(struct net_state *s, const struct net *net, const struct net_work *w)
{
    memcpy(s->x, w->x1, 3 * sizeof *s->x * (size_t)net->n);
    memcpy(s->t, w->t1, 3 * sizeof *s->t * (size_t)net->m);
    refer(net, s->t);
}

/* Tensions stand for ends again; to keep them while the ropes change. */
static void refer_to_ends(const struct net *net, double *t)
{
    for (int r = 0; r < net->m; r++)
        for (int i = 0; i < 3; i++) {
            t[3 * r + i] += net->rope[r].rope.offset[i];
            net->rope[r].rope.offset[i] = 0;
        }
}

/* tolerance 0: near enough for a stage on the way. */
int net_is_met(const struct net_step *p, const struct net_state *s, double tolerance)
{
    if (!isfinite(s->size)) /* before what it divides */
        return 0;
    if (tolerance == 0)
        return p->gap_of_rope <= STAGE && p->residual <= STAGE * s->scale;
    return p->largest_gap <= tolerance && p->residual <= tolerance * s->scale;
}

/* Stiffness of the first steps in place of the exact one. */
static void approximate(const struct net *net, const struct net_options *o, const double *t,
                        struct net_work *w)
{
    for (int r = 0; r < net->m; r++) {
        const struct rope *p = &net->rope[r].rope;

        if (!net_is_placed(&net->rope[r]))
            net_rough_stiffness(p, o->start, t + 3 * r, w->reference, w->K + SYM * r);
    }
}

/* On the way: bars that are pushed resist being turned as if they were pulled.  Whether there are
 * any. */
static int stiffen_bars(const struct net *net, const double *x, struct net_work *w)
{
    int any = 0;

    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        const double *a = x + 3 * p->a, *b = x + 3 * p->b;
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        double *K = w->K + SYM * r, l = net_length(d), turn = 2 * net_length(w->bar + 3 * r) / l;

        if (!net_is_bar(p) || !(l < p->rope.L0) || !(l > 0))
            continue;
        for (int i = 0, at = 0; i < 3; i++) /* K has -N/l across d: twice that is added */
            for (int j = i; j < 3; j++, at++)
                K[at] += turn * ((i == j) - d[i] * d[j] / (l * l));
        any = 1;
    }
    return any;
}

enum status net_iterate(const struct net *net, const struct net_options *o, double tolerance,
                        int last, int patience, struct net_work *w, struct net_state *s)
{
    int polish = 0, brief = 0;

    refer(net, s->t);
    net_evaluate(net, s->x, s->t, w);
    if (s->steps == 0)
        s->step[0] = net_measure(net, s->t, w, s);
    while (s->steps < last && brief < patience) {
        struct net_step before = net_measure(net, s->t, w, s), now;
        int met = net_is_met(&before, s, tolerance);
        enum status status;
        double factor;

        if (met && (polish++ == POLISH || tolerance == 0 ||
                    (before.largest_gap <= CLOSED && s->steps > 0)))
            break;
        if (s->steps < o->start_steps && o->start != NET_EXACT)
            approximate(net, o, s->t, w);
        status = net_find_step(net, w, &s->worst);
        if (status == SW_INDEFINITE && !met && stiffen_bars(net, s->x, w))
            status = net_find_step(net, w, &s->worst);
        if (status != SW_OK)
            return status; /* balance or not: it would not stay */
        factor = search(net, s, w);
        now = net_measure(net, w->t1, w, s);
        now.factor = factor;
        if (met && !(now.mean_gap < before.mean_gap / 2)) {
            net_evaluate(net, s->x, s->t, w);
            break;
        }
        take(s, net, w);
        s->step[++s->steps] = now;
        brief = factor < BRIEF ? brief + 1 : 0;
        if (!isfinite(now.mean_gap) || !isfinite(now.residual))
            break;
    }
    {
        struct net_step end = net_measure(net, s->t, w, s);

        return net_is_met(&end, s, tolerance) ? SW_OK : SW_NOCONV;
    }
}

/* Of all ropes, a give that no longer matters to the stiffest one. */
static double least_give(const struct net *net)
{
    double stiffest = 0;

    for (int r = 0; r < net->m; r++)
        stiffest = fmax(stiffest, net->rope[r].rope.law.EA);
    return GIVE_END / stiffest;
}

/* Chords are smoothed along with it, as the tensions that are of no account any more. */
static void set_give(struct net *net, double give, double reference)
{
    for (int r = 0; r < net->m; r++)
        net->rope[r].rope.give = give;
    net_smooth(net, ROUGH, reference, reference * sqrt(give * reference / 0.1));
}

/*
 * The same with ropes that give, less and less: from a strain of a tenth at the reference force to
 * nothing.  What a stage takes off is fitted to the number of steps that it needs; one that does
 * not get along is begun again, with less.
 */
static enum status iterate_softly(struct net *net, const struct net_options *o, struct net_work *w,
                                  struct net_state *s)
{
    size_t nx = 3 * sizeof *s->x * (size_t)net->n, nt = 3 * sizeof *s->t * (size_t)net->m;
    double *x = mem_copy(s->x, nx), *t = mem_copy(s->t, nt);
    double give = 0.1 / w->reference, last = give, off = 0.1, least = least_give(net);
    enum status status = x && t ? SW_OK : SW_NOMEM;

    while (status == SW_OK && off < GIVE_UP && s->steps < o->steps) {
        int before = s->steps, first = last == give, room = first ? 4 * SOFT_STEPS : SOFT_STEPS;

        set_give(net, give, w->reference);
        status = net_iterate(net, o, 0, before + room < o->steps ? before + room : o->steps,
                             first ? INT_MAX : 1, w, s);
        refer_to_ends(net, s->t);
        if (status == SW_OK) {
            memcpy(x, s->x, nx);
            memcpy(t, s->t, nt);
            off = s->steps - before <= SOFT_STEPS / 3 ? fmax(off * off, 1e-3) : off;
            last = give;
            if (give < least)
                break;
        } else if (status == SW_NOCONV && !first) {
            memcpy(s->x, x, nx);
            memcpy(s->t, t, nt);
            off = sqrt(off);
            status = SW_OK;
        }
        give = last * off;
    }
    set_give(net, 0, w->reference);
    if (status == SW_OK)
        status = net_iterate(net, o, o->tolerance, o->steps, 4 * SHORT_STEPS, w, s);
    free(x);
    free(t);
    return status;
}

/*
 * Where ropes go slack their chords become steps of the tension, on which Newton's method creeps.
 * Then: the same with smooth chords first, epsilon falling from the reference force to what it
 * shall be.
 */
static enum status iterate_smoothly(struct net *net, const struct net_options *o,
                                    struct net_work *w, struct net_state *s)
{
    enum status status = net_begin(net, w, s);

    for (int k = 0; k <= STAGES && status == SW_OK; k++) {
        int last = k == STAGES;

        net_smooth(net, ROUGH, w->reference, last ? 0 : w->reference * pow(0.1, k / 2.0));
        status = net_iterate(net, o, last ? o->tolerance : 0, o->steps, INT_MAX, w, s);
        status = status == SW_NOCONV && !last ? SW_OK : status;
    }
    return status;
}

/* On to a tenth of the smoothing: what is small goes with it, so that the change since ten times it
 * tells the next one.  x and t, tensions at ends, are from there; now they become those of s. */
static void foresee(const struct net *net, int known, double *x, double *t, struct net_state *s)
{
    for (int i = 0; i < 3 * net->n; i++) {
        double now = s->x[i];

        s->x[i] += known ? (now - x[i]) / 10 : 0;
        x[i] = now;
    }
    for (int i = 0; i < 3 * net->m; i++) {
        double now = s->t[i] + net->rope[i / 3].rope.offset[i % 3];

        s->t[i] += known && !net_is_placed(&net->rope[i / 3]) ? (now - t[i]) / 10 : 0;
        t[i] = now;
    }
}

/* From a solution with rough smoothing to one that leaves next to nothing in slack elements. */
static enum status sharpen(struct net *net, const struct net_options *o, struct net_work *w,
                           struct net_state *s)
{
    double *x = mem_doubles(3 * (size_t)net->n), *t = mem_doubles(3 * (size_t)net->m);
    enum status status = x && t ? SW_OK : SW_NOMEM;

    /* NOLINTNEXTLINE(cert-flp30-c): it ends between two decades, whatever their round-off */
    for (double part = ROUGH / 10; part > NET_SHARP / 2 && status == SW_OK; part /= 10) {
        int last = s->steps + SHARPEN;

        foresee(net, part < ROUGH / 20, x, t, s);
        net_smooth(net, part, w->reference, 0);
        status =
            net_iterate(net, o, o->tolerance, last < o->steps ? last : o->steps, INT_MAX, w, s);
        if (status == SW_NOCONV && part > 2 * NET_SHARP)
            status = SW_OK;
    }
    free(x);
    free(t);
    return status;
}

/* One way after the other, from the quickest to the safest. */
enum status net_iterate_all_ways(struct net *net, const struct net_options *o, struct net_work *w,
                                 struct net_state *s)
{
    enum status status = net_iterate(net, o, o->tolerance, o->steps, SHORT_STEPS, w, s);

    if (status == SW_OK || s->steps == o->steps)
        return status;
    if (status == SW_NOCONV)
        status = iterate_softly(net, o, w, s);
    if (status == SW_NOCONV && s->steps < o->steps)
        status = iterate_smoothly(net, o, w, s);
    return status == SW_OK ? sharpen(net, o, w, s) : status;
}
