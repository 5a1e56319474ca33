/* Steps of nets in the sea, with loads that are renewed. */
#include "num/mem.h"
#include "phys/voyage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define HARD 1e4     /* of the reference force over the size: push for each metre sunk in */
#define SHALLOW 1e-9 /* of the size: sinking in that is none */
#define NEAR 1e-6    /* of the size and the largest tension: tells what the bed does */
#define PATIENCE 20  /* short steps in a row */
#define VAIN 3       /* rounds that do not get there */
#define FEW 40       /* steps with the same loads before a safer way is taken */

/* Greatest depth to which a node has sunk in, or height in which the bed still pushes it [m]; the
 * push is counted on from now. */
static double count_on_bed(struct voyage *v)
{
    double most = 0;

    for (int i = 0; i < v->net->n && v->w.hard > 0; i++) {
        most = fmax(most, fabs(v->w.push[i] - v->w.lean[i]) / v->w.hard);
        v->w.lean[i] = v->w.push[i];
    }
    return most;
}

/* At most so many steps with the loads as they are. */
static enum status steps_on(struct voyage *v, int most)
{
    int last = most < v->o->steps - v->s->steps ? v->s->steps + most : v->o->steps;

    return net_iterate(v->net, v->o, v->o->tolerance, last, PATIENCE, &v->w, v->s);
}

/* Round by round: loads of the present shape, then steps with these.  The bed's push is told anew
 * once the state is near enough to tell it. */
static enum status sail(struct voyage *v, const struct net_split *split, int ropes, int safe)
{
    const struct net_options *o = v->o;
    double sunk = INFINITY;
    int vain = 0, near = 0, one_by_one = v->net->sea->current.n > 0 && !o->hold && !safe;

    for (int round = 0; round <= o->steps && v->s->steps <= o->steps; round++) {
        struct net_step now;
        enum status status;
        int seen = near || v->w.hard == 0; /* friction was looked for */

        sunk = near || v->w.hard == 0 ? count_on_bed(v) : sunk;
        voyage_look(v, split, ropes, near);
        voyage_renew(v);
        net_evaluate(v->net, v->s->x, v->s->t, &v->w);
        now = net_measure(v->net, v->s->t, &v->w, v->s);
        near = net_is_met(&now, v->s, NEAR);
        if (v->s->steps == 0)
            v->s->step[0] = now;
        if (seen && net_is_met(&now, v->s, o->tolerance) && sunk <= SHALLOW * v->s->size &&
            v->before <= o->tolerance * v->s->scale)
            return SW_OK;
        if (v->s->steps == o->steps)
            return SW_NOCONV;
        status = steps_on(v, one_by_one ? 1 : safe ? FEW : o->steps);
        if (status == SW_NOCONV && safe && !one_by_one)
            status = net_iterate_all_ways(v->net, o, &v->w, v->s);
        if ((status != SW_OK && status != SW_NOCONV) ||
            (!one_by_one && status == SW_NOCONV && vain++ == VAIN))
            return status;
    }
    return SW_NOCONV;
}

/* Nodes out of the bed, where a solution without it has put them. */
static void lift_nodes(const struct net *net, double *x)
{
    for (int i = 0; i < net->n; i++)
        if (!(net->node[i].held & 4))
            x[3 * i + 2] = fmax(x[3 * i + 2], bed_at(&net->sea->bed, x[3 * i], x[3 * i + 1], NULL));
}

enum status voyage_new(struct net *net, const struct net_options *o, struct net_state *s,
                       struct voyage *v)
{
    size_t n = 3 * (size_t)net->n;
    enum status status;

    *v = (struct voyage){.net = net,
                         .o = o,
                         .s = s,
                         .joints = net->n,
                         .size = net_size(net),
                         .part = 1,
                         .before = INFINITY};
    status = net_state_new(net, o, s);
    if (status == SW_OK)
        status = net_work_new(net, &v->w);
    v->base = mem_doubles(n);
    v->load = mem_doubles(n);
    v->fresh = mem_doubles(n);
    v->held = mem_doubles(n);
    if (!v->base || !v->load || !v->fresh || !v->held)
        return SW_NOMEM;
    for (size_t i = 0; i < n; i++)
        v->base[i] = net->node[i / 3].force[i % 3];
    return status;
}

void voyage_end(struct voyage *v)
{
    for (int i = 0; v->base && i < 3 * v->net->n; i++)
        v->net->node[i / 3].force[i % 3] = v->base[i];
    net_work_free(&v->w);
    free(v->base);
    free(v->load);
    free(v->fresh);
    free(v->held);
}

/* As if nothing had been tried yet. */
static void forget(struct voyage *v)
{
    size_t n = 3 * (size_t)v->net->n;

    v->rounds = 0;
    v->part = 1;
    v->before = INFINITY;
    memset(v->load, 0, n * sizeof *v->load);
    memset(v->held, 0, n * sizeof *v->held);
    for (size_t i = 0; i < n; i++)
        v->net->node[i / 3].force[i % 3] = v->base[i];
    for (int i = v->joints; i < v->net->n; i++)
        memset(v->net->node[i].K, 0, sizeof v->net->node[i].K);
}

/* First state with the loads as they are. */
static enum status begin(struct voyage *v)
{
    enum status status;

    net_prepare(v->net, &v->w, v->s);
    v->s->size = v->size;
    status = net_begin(v->net, &v->w, v->s);
    return status == SW_INDEFINITE ? SW_OK : status; /* the bed may hold it */
}

/* First state, ropes over the bed, the bed itself. */
static enum status set_sail(struct voyage *v, const struct net_state *dry)
{
    struct net *net = v->net;
    enum status status = begin(v);

    if (dry) {
        memcpy(v->s->x, dry->x, 3 * sizeof *dry->x * (size_t)net->n);
        memcpy(v->s->t, dry->t, 3 * sizeof *dry->t * (size_t)net->m);
    }
    for (int r = 0; r < net->m; r++)
        net->rope[r].over = net_goes_over(net, &net->rope[r]);
    if (net->sea->bed.kind != BED_NONE) {
        v->w.hard = HARD * v->w.reference / v->s->size;
        lift_nodes(net, v->s->x);
    }
    return status;
}

/* Friction makes the tension go as a square root of the distance where it begins, which Newton's
 * method cannot pass: ropes over the bed come near without it. */
static enum status come_near(struct voyage *v)
{
    enum status s = SW_OK;
    int rubs = 0;

    for (int r = 0; r < v->net->m; r++)
        rubs |= v->net->rope[r].over && v->net->rope[r].friction > 0;
    if (rubs) {
        v->w.over = OVER_SMOOTH;
        s = steps_on(v, FEW);
        v->w.over = OVER_STEP;
    }
    return s == SW_NOCONV ? SW_OK : s;
}

/* First as it is, for not too long; then by the safest way with the first loads, and on from there.
 */
enum status voyage_travel(struct voyage *v, const struct net_split *split, int ropes,
                          const struct net_state *dry)
{
    struct net_options brief = *v->o;
    const struct net_options *o = v->o;
    enum status status = set_sail(v, dry);

    brief.steps = o->steps < VOYAGE_BRIEF ? o->steps : VOYAGE_BRIEF;
    v->o = &brief;
    if (status == SW_OK)
        status = come_near(v);
    if (status == SW_OK)
        status = sail(v, split, ropes, 0);
    v->o = o;
    if ((status == SW_NOCONV || status == SW_INDEFINITE) && brief.steps < o->steps) {
        int steps = v->s->steps;

        forget(v);
        status = begin(v);
        voyage_look(v, split, ropes, 0); /* the drag of the first shape may be all that holds it */
        voyage_renew(v);
        if (status == SW_OK)
            status = set_sail(v, dry);
        v->s->steps = steps;
        v->w.over = OVER_SMOOTH;
        if (status == SW_OK)
            status = net_iterate_all_ways(v->net, o, &v->w, v->s);
        v->w.over = OVER_STEP;
        if (status == SW_OK)
            status = sail(v, split, ropes, 1);
    }
    return net_conclude(v->net, v->o, status, &v->w, v->s);
}
