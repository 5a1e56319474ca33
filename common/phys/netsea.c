/* Systems of ropes over a bed and in a current. */
#include "num/mem.h"
#include "phys/network.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define HARD 1e4     /* of the reference force over the size: push for each metre sunk in */
#define LOOSE 1e-6   /* of the largest tension: lies as it likes */
#define SHALLOW 1e-9 /* of the size: sinking in that is none */
#define LESS 0.5     /* of a renewal, where the last one did not bring loads nearer */
#define MORE 1.5     /* and where it did */
#define LEAST 0.02   /* of it, at the least */
#define NEAR                                                                                       \
    1e-6            /* of the size and the largest tension: the bed's push is told by such a state \
                     */
#define USED 0.99   /* of the friction that there may be */
#define SETTLED 12  /* rounds after which friction is no longer looked for */
#define PATIENCE 20 /* short steps in a row */
#define GROUND 1e-6 /* of the size: what is held so near to the bed is an anchor */
#define VAIN 3      /* rounds that do not get there */
#define FEW 40      /* steps with the same loads before a safer way is taken */
#define BRIEF 120   /* steps without further care */
#define DRY 100     /* steps of a first try without the bed */

/* A net in the sea on its way to balance. */
struct voyage {
    struct net *net; /* the fine one */
    const struct net_options *o;
    struct net_work w;
    struct net_state *s;
    double *base;  /* (n, 3) forces without sea; owned */
    double *load;  /* (n, 3) of current and friction, as they act; owned */
    double *fresh; /* (n, 3) as the present shape would have them; owned */
    double *held;  /* (n, 3) friction; owned */
    int rounds;    /* of renewal */
    double part;   /* of the difference that a renewal takes */
    double before; /* difference at the last renewal */
};

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

/* What current and friction do in the present shape.  Friction is looked for in states near to
 * balance only: what a tension on the way has called forth would hold itself up.  The bed can hold
 * anything up to C times its push: after some rounds it holds what it then does, within that. */
static void look(struct voyage *v, const struct net_split *split, int ropes, int near)
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
    for (int i = 0; i < 3 * v->net->n; i++)
        v->fresh[i] += v->held[i];
}

/* Forces of nodes that are moved by loads: what is fixed takes any. */
static void renew(struct voyage *v, double part)
{
    double most = 0;

    for (int i = 0; i < 3 * v->net->n; i++) {
        double change = v->fresh[i] - v->load[i];

        most = fmax(most, v->w.dof[i] >= 0 ? fabs(change) : 0);
        v->load[i] += part * change;
        v->net->node[i / 3].force[i % 3] = v->base[i] + v->load[i];
    }
    v->part = most > v->before ? fmax(LEAST, v->part * LESS) : fmin(1, v->part * MORE);
    v->before = most;
}

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

        sunk = near || v->w.hard == 0 ? count_on_bed(v) : sunk;
        look(v, split, ropes, near);
        renew(v, v->part);
        net_evaluate(v->net, v->s->x, v->s->t, &v->w);
        now = net_measure(v->net, v->s->t, &v->w, v->s);
        near = net_is_met(&now, v->s, NEAR);
        if (v->s->steps == 0)
            v->s->step[0] = now;
        if (net_is_met(&now, v->s, o->tolerance) && sunk <= SHALLOW * v->s->size &&
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

/* Elements of each rope where it must be split, 0 where not; whether any is. */
static int choose_parts(const struct net *net, const struct net_options *o, int all, int *parts)
{
    int any = 0;

    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        int light = net->sea->current.n == 0 && p->rope.elements == 0 && !(p->rope.q[2] < 0);

        parts[r] = p->rope.elements > 0 ? p->rope.elements : o->split;
        if ((net_is_bar(p) && o->method == NET_GAP) || (!all && net_goes_over(net, p)) || light)
            parts[r] = 0;
        any |= parts[r] > 0;
    }
    return any;
}

static int nodes_are_clear(const struct net *net, const struct net_state *s)
{
    const struct bed *bed = &net->sea->bed;

    for (int i = 0; i < net->n; i++)
        if (!(net->node[i].held & 4) &&
            s->x[3 * i + 2] < bed_at(bed, s->x[3 * i], s->x[3 * i + 1], NULL))
            return 0;
    return 1;
}

/* Of rope r; point: room for its points. */
static int rope_is_clear(const struct net *net, const struct net_state *s, int r,
                         struct rope_point *point)
{
    const struct net_rope *p = &net->rope[r];
    const double *a = s->x + 3 * p->a;
    int n;

    if (net_goes_over(net, p))
        return !net_over_lies(net, p, a, s->x + 3 * p->b);
    n = net_points(net, s, r, point);
    for (int k = 1; k + 1 < n; k++)
        if (a[2] + point[k].x[2] <
            bed_at(&net->sea->bed, a[0] + point[k].x[0], a[1] + point[k].x[1], NULL))
            return 0;
    return 1;
}

/* Whether a solution without a bed stays above it.  SW_NOMEM. */
static enum status is_clear(const struct net *net, const struct net_state *s, int *ret)
{
    struct rope_point *point;
    int most = NET_POINTS;

    *ret = nodes_are_clear(net, s);
    for (int r = 0; r < net->m; r++)
        most = net->rope[r].rope.elements + 1 > most ? net->rope[r].rope.elements + 1 : most;
    point = mem_zeroed((size_t)most, sizeof *point);
    for (int r = 0; r < net->m && point && *ret; r++)
        *ret = rope_is_clear(net, s, r, point);
    free(point);
    return point ? SW_OK : SW_NOMEM;
}

/* Nodes out of the bed, where a solution without it has put them. */
static void lift_nodes(const struct net *net, double *x)
{
    for (int i = 0; i < net->n; i++)
        if (!(net->node[i].held & 4))
            x[3 * i + 2] = fmax(x[3 * i + 2], bed_at(&net->sea->bed, x[3 * i], x[3 * i + 1], NULL));
}

static enum status new_voyage(struct net *net, const struct net_options *o, struct net_state *s,
                              struct voyage *v)
{
    size_t n = 3 * (size_t)net->n;
    enum status status;

    *v = (struct voyage){.net = net, .o = o, .s = s, .part = 1, .before = INFINITY};
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

static void end_voyage(struct voyage *v)
{
    for (int i = 0; v->base && i < 3 * v->net->n; i++)
        v->net->node[i / 3].force[i % 3] = v->base[i];
    net_work_free(&v->w);
    free(v->base);
    free(v->load);
    free(v->fresh);
    free(v->held);
}

/* First state, ropes over the bed, the bed itself. */
static enum status set_sail(struct voyage *v, const struct net_state *dry)
{
    struct net *net = v->net;
    enum status status;

    net_prepare(net, &v->w, v->s);
    status = net_begin(net, &v->w, v->s);
    if (status == SW_INDEFINITE)
        status = SW_OK; /* the bed may hold it */
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
static enum status travel(struct voyage *v, const struct net_split *split, int ropes,
                          const struct net_state *dry)
{
    struct net_options brief = *v->o;
    const struct net_options *o = v->o;
    enum status status = set_sail(v, dry);

    brief.steps = o->steps < BRIEF ? o->steps : BRIEF;
    v->o = &brief;
    if (status == SW_OK)
        status = come_near(v);
    if (status == SW_OK)
        status = sail(v, split, ropes, 0);
    v->o = o;
    if ((status == SW_NOCONV || status == SW_INDEFINITE) && brief.steps < o->steps) {
        int steps = v->s->steps;

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

/* What current and friction do to the first n nodes, the springs of joints that stick with them. */
static void report(const struct voyage *v, int joints, int n, struct net_state *ret)
{
    for (int i = 0; i < 3 * n; i++) {
        const struct net_node *p = &v->net->node[i / 3];

        ret->drag[i] = v->load[i];
        if (i / 3 >= joints && i % 3 < 2)
            ret->drag[i] -= p->K[SYM_XX] * (v->s->x[i] - p->anchor[i % 3]);
    }
}

/* From the fine net's state to that of the coarse one. */
static void gather(const struct net *net, const struct net_split *split, const struct net_state *s,
                   struct net_state *ret)
{
    size_t n = (size_t)net->n;

    memcpy(ret->x, s->x, 3 * n * sizeof *ret->x);
    memcpy(ret->residual, s->residual, 3 * n * sizeof *ret->residual);
    memcpy(ret->push, s->push, n * sizeof *ret->push);
    memcpy(ret->drag, s->drag, 3 * n * sizeof *ret->drag);
    memcpy(ret->step, s->step, sizeof *ret->step * ((size_t)s->steps + 1));
    ret->steps = s->steps;
    ret->size = s->size;
    ret->most = s->most;
    ret->scale = s->scale;
    ret->hard = s->hard;
    ret->worst = s->worst < net->n ? s->worst : -1;
    for (int r = 0; r < net->m; r++) {
        int first = split->first[r], last = split->first[r + 1] - 1;

        memcpy(ret->t + 3 * r, s->t + 3 * first, 3 * sizeof *ret->t);
        memcpy(ret->end + 6 * r, s->end + 6 * first, 3 * sizeof *ret->end);
        memcpy(ret->end + 6 * r + 3, s->end + 6 * last + 3, 3 * sizeof *ret->end);
        net->rope[r].over = split->fine.rope[first].over;
    }
}

/* With ropes as they are; with friction not for too long, for there is another way. */
static enum status solve_whole(struct net *net, const struct net_options *o,
                               const struct net_state *dry, struct net_state *ret)
{
    struct net_options brief = *o;
    struct voyage v;
    enum status s;

    for (int r = 0; r < net->m; r++)
        if (net->rope[r].friction > 0 && brief.steps > BRIEF)
            brief.steps = BRIEF;
    s = new_voyage(net, &brief, ret, &v);

    if (s == SW_OK)
        s = travel(&v, NULL, 0, dry);
    if (s == SW_OK || s == SW_NOCONV)
        report(&v, net->n, net->n, ret);
    end_voyage(&v);
    return s;
}

/* With ropes split; loads stay at the fine net's nodes. */
static enum status solve_split(const struct net *net, const struct net_options *o, const int *parts,
                               struct net_state *ret)
{
    struct net_fine *fine = mem_zeroed(1, sizeof *fine);
    struct voyage v = {.net = NULL};
    enum status s = net_state_new(net, o, ret);

    ret->fine = fine;
    if (!fine || s != SW_OK)
        return SW_NOMEM;
    s = net_split_new(net, parts, o->method == NET_GAP, &fine->split);
    if (s == SW_OK)
        s = new_voyage(&fine->split.fine, o, &fine->state, &v);
    if (s == SW_OK)
        s = travel(&v, &fine->split, net->m, NULL);
    if (s == SW_OK || s == SW_NOCONV || s == SW_INDEFINITE) {
        report(&v, net->n, v.net->n, &fine->state);
        gather(net, &fine->split, &fine->state, ret);
    }
    if (v.net)
        end_voyage(&v);
    return s;
}

/* Ropes between node i and others are that much farther from the anchors than it is. */
static int reach_out(const struct net *net, int *far)
{
    int any = 0;

    for (int r = 0; r < net->m; r++)
        for (int end = 0; end < 2; end++) {
            int from = end ? net->rope[r].b : net->rope[r].a;
            int to = end ? net->rope[r].a : net->rope[r].b;

            if (far[from] + 1 < far[to]) {
                far[to] = far[from] + 1;
                any = 1;
            }
        }
    return any;
}

/* Friction acts towards the anchors: nodes that are held on the ground.  SW_NOMEM. */
static enum status find_pulled(struct net *net)
{
    int *far = mem_zeroed((size_t)net->n, sizeof *far);
    double size = net_size(net);

    if (!far)
        return SW_NOMEM;
    for (int i = 0; i < net->n; i++) {
        const struct net_node *p = &net->node[i];
        double h = p->held == 7 ? p->x[2] - bed_at(&net->sea->bed, p->x[0], p->x[1], NULL) : 0;

        far[i] = p->held == 7 && p->body == 0 && h <= GROUND * size ? 0 : net->n;
    }
    while (reach_out(net, far))
        ;
    for (int r = 0; r < net->m; r++) {
        struct net_rope *p = &net->rope[r];

        p->pulled = far[p->a] == far[p->b]  ? TOUCH_ALIKE
                    : far[p->a] < far[p->b] ? TOUCH_PULLED_B
                                            : TOUCH_PULLED_A;
    }
    free(far);
    return SW_OK;
}

enum status net_solve_in_sea(struct net *net, const struct net_options *o, struct net_state *ret)
{
    int *parts = mem_zeroed((size_t)net->m, sizeof *parts), clear = 0;
    struct net_options brief = *o;
    struct net_state dry = {.x = NULL};
    enum status s = parts ? SW_OK : SW_NOMEM;

    if (s == SW_OK)
        s = find_pulled(net);
    brief.steps = o->steps < DRY ? o->steps : DRY;
    *ret = (struct net_state){.worst = -1};
    if (s == SW_OK && o->method == NET_IMAGINARY)
        s = SW_ADMISSIBLE;
    if (s == SW_OK && net->sea->current.n == 0) {
        s = net_solve_dry(net, &brief, &dry);
        if (s == SW_OK)
            s = is_clear(net, &dry, &clear);
        if (s == SW_OK && clear) {
            free(parts);
            *ret = dry;
            return SW_OK;
        }
        s = s == SW_NOMEM ? s : SW_OK;
    }
    if (s == SW_OK) {
        int any = choose_parts(net, o, 0, parts);

        s = any ? solve_split(net, o, parts, ret) : solve_whole(net, o, dry.x ? &dry : NULL, ret);
        if (s == SW_NOCONV && choose_parts(net, o, 1, parts)) {
            net_state_free(ret);
            s = solve_split(net, o, parts, ret);
        }
    }
    free(parts);
    net_state_free(&dry);
    if (s == SW_NOMEM)
        net_state_free(ret);
    return s;
}
