/* Load paths. */
#include "num/mem.h"
#include "num/vec3.h"
#include "phys/walk.h"

#include <stdlib.h>
#include <string.h>

#define SHORT (1.0 / 65536) /* of the first step: what lies behind is taken as it is */
#define WEAK 1e-10          /* pivot over its diagonal entry at a start that leads nowhere */

void follow_path_free(struct follow_path *p)
{
    free(p->step);
    p->step = NULL;
}

static void walk_free(struct walk *k)
{
    frame_state_free(&k->before);
    twist_free(&k->twist);
    free(k->move);
    free(k->all);
    free(k->dx);
    free(k->rate);
    free(k->along);
    free(k->last);
}

static enum status walk_new(struct walk *k)
{
    size_t n = (size_t)k->f->n, m = (size_t)k->w->unknowns;

    k->move = mem_doubles(6 * n);
    k->all = mem_doubles(6 * n);
    k->dx = mem_doubles(m);
    k->rate = mem_doubles(m);
    k->along = mem_doubles(m);
    k->last = mem_doubles(m);
    if (!k->move || !k->all || !k->dx || !k->rate || !k->along || !k->last)
        return SW_NOMEM;
    return frame_state_new(k->f, &k->before);
}

/* Largest spin of a node in dx or among what is held. */
double walk_spin(const struct walk *k, const double *dx, const double *move)
{
    double most = 0;

    for (int i = 0; i < k->f->n; i++) {
        double spin[3];

        for (int c = 3; c < 6; c++) {
            int unknown = k->w->dof[6 * i + c];

            spin[c - 3] = unknown >= 0 ? dx[unknown] : move ? move[6 * i + c] : 0;
        }
        most = fmax(most, vec3_length(spin));
    }
    return most;
}

enum status walk_factor(struct walk *k)
{
    enum status s = frame_factorize(k->w);

    twist_free(&k->twist);
    if (s == SW_OK)
        s = twist_new(k->f, k->w, &k->twist);
    k->factored = s == SW_OK;
    if (s == SW_INDEFINITE)
        k->path->failed_node = frame_node_of(k->f, k->w, k->w->K.failed);
    return s;
}

/* dx and the held moves become one of all nodes, k->all; the linear forces that they lead to. */
void walk_foresee(struct walk *k, const double *move)
{
    const struct frame_work *w = k->w;

    for (int i = 0; i < 6 * k->f->n; i++)
        k->all[i] = w->dof[i] >= 0 ? k->dx[w->dof[i]] : move ? move[i] : 0;
    frame_foresee(k->f, k->s, (struct frame_moves){k->all, k->dx}, k->w);
}

/* In balance: the stiffness without guesses. */
enum status walk_settle(struct walk *k)
{
    if (k->w->guessed) {
        k->w->guessed = 0;
        frame_evaluate(k->f, k->s, FRAME_STILL, k->w);
    }
    return walk_factor(k);
}

/* One step of Newton's method from what was evaluated.  SW_NOCONV: it leads too far. */
static enum status newton_step(struct walk *k, const double *move)
{
    struct frame_work *w = k->w;
    enum status s;
    double spin;

    memcpy(k->dx, w->right, (size_t)w->unknowns * sizeof *k->dx);
    s = twist_solve(&k->twist, w, k->dx);
    if (s != SW_OK)
        return s;
    spin = walk_spin(k, k->dx, move);
    if (!(spin < 1e3) || (move && spin > 2 * WALK_SPIN))
        return SW_NOCONV;
    for (int i = 0; i < w->unknowns && spin > WALK_SPIN; i++)
        k->dx[i] *= WALK_SPIN / spin;
    walk_foresee(k, move);
    frame_move(k->f, w, k->dx, move, k->s);
    return SW_OK;
}

/* Newton's iteration at the loads that are set, what is held moving by `move` in the first one.
 * SW_NOCONV: none; K belongs to the state and is factored when it is in balance. */
static enum status balance(struct walk *k, const double *move)
{
    struct frame_work *w = k->w;
    enum status s = SW_OK;

    w->guessed = 0;
    for (k->iterations = 0; k->iterations <= k->o->iterations && s == SW_OK; k->iterations++) {
        frame_evaluate(k->f, k->s, (struct frame_moves){k->iterations == 0 ? move : NULL, NULL}, w);
        k->residual = frame_residual(k->f, w, k->o->tolerance);
        if (!(w->angle < WALK_TURN) || isnan(k->residual))
            return SW_NOCONV;
        if (k->residual <= k->o->tolerance && (k->iterations > 0 || !move))
            return k->iterations > 0 || !k->factored ? walk_settle(k) : SW_OK;
        if (k->iterations > 0 || !k->factored)
            s = walk_factor(k);
        if (s == SW_OK)
            s = newton_step(k, k->iterations == 0 ? move : NULL);
    }
    return s == SW_OK ? SW_NOCONV : s;
}

enum status walk_record(struct walk *k)
{
    struct follow_path *p = k->path;
    struct follow_step *to;

    if (p->n == p->room) {
        int room = p->room > 0 ? 2 * p->room : 32;

        to = mem_resize(p->step, (size_t)room, sizeof *to);
        if (!to)
            return SW_NOMEM;
        p->step = to;
        p->room = room;
    }
    to = &p->step[p->n++];
    *to = (struct follow_step){.t = k->s->t,
                               .iterations = k->iterations,
                               .negative = k->w->negative,
                               .residual = k->residual,
                               .energy = k->w->energy};
    p->angle = k->w->angle;
    for (int c = 0; c < 3 && k->o->watch >= 0; c++) {
        int at = 3 * k->o->watch + c;

        to->watch[c] = k->s->x[at] - k->f->node[k->o->watch].x[c] + k->s->low[at];
        to->watch[3 + c] = k->s->turn[at];
    }
    return SW_OK;
}

/* Back to the last state in balance. */
enum status walk_back(struct walk *k)
{
    frame_state_copy(k->f, &k->before, k->s);
    frame_set_loads(k->f, k->s->t, k->w);
    k->w->guessed = 0;
    frame_evaluate(k->f, k->s, FRAME_STILL, k->w);
    return walk_factor(k);
}

/* One step of the load from the present state to the time t; SW_NOCONV leaves it where it was. */
enum status walk_by_load(struct walk *k, double t)
{
    double from = k->s->t;
    enum status s, back;

    frame_state_copy(k->f, k->s, &k->before);
    frame_given(k->f, from, t, k->move);
    frame_set_loads(k->f, t, k->w);
    s = balance(k, k->move);
    k->s->t = t;
    if (s != SW_NOCONV && s != SW_INDEFINITE)
        return s;
    back = walk_back(k);
    return back == SW_OK ? SW_NOCONV : back;
}

/* Between a stable state (present, k->before) and `hi`, by halving. */
static enum status find_critical(struct walk *k, double hi)
{
    enum status s = walk_back(k);

    while (s == SW_OK && hi - k->s->t > WALK_FINE * fmax(1, hi)) {
        double t = (hi + k->s->t) / 2;
        int before = k->w->negative;

        s = walk_by_load(k, t);
        if (s == SW_NOCONV) { /* on the singular place itself */
            hi = t;
            s = SW_OK;
        } else if (s == SW_OK && k->w->negative > before) {
            hi = t;
            s = walk_back(k);
        }
    }
    k->path->critical = (hi + k->s->t) / 2;
    return s;
}

/*
 * Where more pivots are negative than before, a short step may still find a stable branch that a
 * long one has jumped over: of imperfect columns and arches.
 */
static int jumped(const struct walk *k, int before, double step)
{
    return !k->o->critical && k->w->negative > before && step > SHORT / k->o->parts;
}

static enum status by_load(struct walk *k, double end)
{
    double step = 1.0 / k->o->parts;
    enum status s = SW_OK;

    while (s == SW_OK && k->s->t < end - 1e-12 && isnan(k->path->critical)) {
        double t = k->s->t + step > end - 0.1 * step ? end : k->s->t + step;
        int before = k->w->negative;

        if (k->path->n > k->o->steps)
            return SW_NOCONV;
        s = walk_by_load(k, t);
        if (s == SW_OK && jumped(k, before, step)) {
            s = walk_back(k);
            step /= 4;
        } else if (s == SW_NOCONV) {
            step /= 2;
            s = step < WALK_SMALLEST ? SW_NOCONV : SW_OK;
        } else if (s == SW_OK) {
            if (k->o->critical && k->w->negative > before)
                s = find_critical(k, t);
            if (s == SW_OK)
                s = walk_record(k);
            step *= k->iterations <= WALK_EASY      ? WALK_GROW
                    : k->iterations > 2 * WALK_EASY ? 0.7
                                                    : 1;
            step = fmin(step, (double)WALK_MOST / k->o->parts);
        }
    }
    return s;
}

enum status follow(const struct frame *f, const struct follow_options *o, struct frame_state *s,
                   struct frame_work *w, struct follow_path *ret)
{
    struct walk k = {.f = &k.own, .own = *f, .o = o, .s = s, .w = w, .path = ret};
    enum status status;

    *ret = (struct follow_path){.critical = NAN, .failed_node = -1};
    status = walk_new(&k);
    if (status == SW_OK) {
        frame_set_loads(f, s->t, w);
        status = balance(&k, NULL);
    }
    if (status == SW_OK)
        status = walk_record(&k);
    if (status == SW_OK)
        status = by_load(&k, o->arc ? f->stages - 1 : f->stages);
    k.own.arc = o->arc;
    if (status == SW_OK && o->arc && isnan(ret->critical))
        status = walk_arc(&k, f->stages);
    if (status == SW_NOCONV && ret->n == 1 && w->K.least < WEAK) {
        ret->failed_node = frame_node_of(f, w, w->K.weakest);
        status = SW_INDEFINITE;
    }
    walk_free(&k);
    return status;
}
