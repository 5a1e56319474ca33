/* Systems of ropes over a bed and in a current. */
#include "num/mem.h"
#include "phys/voyage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GROUND 1e-6 /* of the size: what is held so near to the bed is an anchor */
#define DRY 100     /* steps of a first try without the bed */

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

/* Of rope r, looked at as finely as it would be split; point: room for its points. */
static int rope_is_clear(const struct net *net, const struct net_state *s, int r, int split,
                         struct rope_point *point)
{
    const struct net_rope *p = &net->rope[r];
    const double *a = s->x + 3 * p->a;
    int n;

    if (net_goes_over(net, p))
        return !net_over_lies(net, p, a, s->x + 3 * p->b);
    n = p->rope.elements > 0 ? p->rope.elements + 1 : split + 1;
    rope_points(&p->rope, s->t + 3 * r, n, point);
    for (int k = 1; k + 1 < n; k++)
        if (a[2] + point[k].x[2] <
            bed_at(&net->sea->bed, a[0] + point[k].x[0], a[1] + point[k].x[1], NULL))
            return 0;
    return 1;
}

/* Whether a solution without a bed stays above it.  SW_NOMEM. */
static enum status is_clear(const struct net *net, const struct net_state *s, int split, int *ret)
{
    struct rope_point *point;
    int most = split + 1;

    *ret = nodes_are_clear(net, s);
    for (int r = 0; r < net->m; r++)
        most = net->rope[r].rope.elements + 1 > most ? net->rope[r].rope.elements + 1 : most;
    point = mem_zeroed((size_t)most, sizeof *point);
    for (int r = 0; r < net->m && point && *ret; r++)
        *ret = rope_is_clear(net, s, r, split, point);
    free(point);
    return point ? SW_OK : SW_NOMEM;
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
        if (net->rope[r].friction > 0 && brief.steps > VOYAGE_BRIEF)
            brief.steps = VOYAGE_BRIEF;
    s = voyage_new(net, &brief, ret, &v);
    if (s == SW_OK)
        s = voyage_travel(&v, NULL, 0, dry);
    if (s == SW_OK || s == SW_NOCONV)
        report(&v, net->n, net->n, ret);
    voyage_end(&v);
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
        s = voyage_new(&fine->split.fine, o, &fine->state, &v);
    if (s == SW_OK) {
        v.size = net_size(net);
        v.joints = net->n;
        s = voyage_travel(&v, &fine->split, net->m, NULL);
        if (s == SW_OK || s == SW_NOCONV || s == SW_INDEFINITE) {
            report(&v, net->n, v.net->n, &fine->state);
            gather(net, &fine->split, &fine->state, ret);
        }
    }
    if (v.net)
        voyage_end(&v);
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
            s = is_clear(net, &dry, o->split, &clear);
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
