/* Load paths. */
#include "phys/follow.h"
#include "num/mem.h"
#include "num/pi.h"
#include "num/vec3.h"
#include "phys/twist.h"

#include <stdlib.h>
#include <string.h>

#define SPIN 0.6        /* of a node in one iteration [rad]: more is cut back */
#define TURN (0.8 * PI) /* within an element: beyond, the next step may pass half a turn */
#define SMALLEST 1e-9   /* step of a stage */
#define GROW 1.6        /* of a step that took few iterations */
#define MOST 4          /* times the first step */
#define EASY 6          /* iterations */
#define WEAK 1e-10      /* pivot over its diagonal entry at a start that leads nowhere */
#define FINE 1e-10      /* width of the bracket of a critical time */

/* What one path works on. */
struct walk {
    const struct frame *f; /* = &own */
    struct frame own;
    const struct follow_options *o;
    struct frame_state *s, before;
    struct twist twist;
    struct frame_work *w;
    struct follow_path *path;
    double *move;  /* (n, 6) */
    double *all;   /* (n, 6) moves of all nodes */
    double *dx;    /* (unknowns) */
    double *rate;  /* (unknowns) displacement per time */
    double *along; /* (unknowns) last step of the path, weighted */
    int iterations, factored;
    double residual;
};

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
}

static enum status walk_new(struct walk *k)
{
    size_t n = (size_t)k->f->n, m = (size_t)k->w->unknowns;

    k->move = mem_doubles(6 * n);
    k->all = mem_doubles(6 * n);
    k->dx = mem_doubles(m);
    k->rate = mem_doubles(m);
    k->along = mem_doubles(m);
    if (!k->move || !k->all || !k->dx || !k->rate || !k->along)
        return SW_NOMEM;
    return frame_state_new(k->f, &k->before);
}

/* Largest spin of a node in dx or among what is held. */
static double largest_spin(const struct walk *k, const double *dx, const double *move)
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

static enum status factor(struct walk *k)
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
static void foresee(struct walk *k, const double *move)
{
    const struct frame_work *w = k->w;

    for (int i = 0; i < 6 * k->f->n; i++)
        k->all[i] = w->dof[i] >= 0 ? k->dx[w->dof[i]] : move ? move[i] : 0;
    frame_foresee(k->f, k->s, (struct frame_moves){k->all, k->dx}, k->w);
}

/* In balance: the stiffness without guesses. */
static enum status settle(struct walk *k)
{
    if (k->w->guessed) {
        k->w->guessed = 0;
        frame_evaluate(k->f, k->s, FRAME_STILL, k->w);
    }
    return factor(k);
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
    spin = largest_spin(k, k->dx, move);
    if (!(spin < 1e3) || (move && spin > 2 * SPIN))
        return SW_NOCONV;
    for (int i = 0; i < w->unknowns && spin > SPIN; i++)
        k->dx[i] *= SPIN / spin;
    foresee(k, move);
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
        if (!(w->angle < TURN) || isnan(k->residual))
            return SW_NOCONV;
        if (k->residual <= k->o->tolerance && (k->iterations > 0 || !move))
            return k->iterations > 0 || !k->factored ? settle(k) : SW_OK;
        if (k->iterations > 0 || !k->factored)
            s = factor(k);
        if (s == SW_OK)
            s = newton_step(k, k->iterations == 0 ? move : NULL);
    }
    return s == SW_OK ? SW_NOCONV : s;
}

static enum status record(struct walk *k)
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
static enum status step_back(struct walk *k)
{
    frame_state_copy(k->f, &k->before, k->s);
    frame_set_loads(k->f, k->s->t, k->w);
    k->w->guessed = 0;
    frame_evaluate(k->f, k->s, FRAME_STILL, k->w);
    return factor(k);
}

/* One step of the load from the present state to the time t; SW_NOCONV leaves it where it was. */
static enum status load_step(struct walk *k, double t)
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
    back = step_back(k);
    return back == SW_OK ? SW_NOCONV : back;
}

/* Between a stable state (present, k->before) and `hi`, by halving. */
static enum status find_critical(struct walk *k, double hi)
{
    enum status s = step_back(k);

    while (s == SW_OK && hi - k->s->t > FINE * fmax(1, hi)) {
        double t = (hi + k->s->t) / 2;
        int before = k->w->negative;

        s = load_step(k, t);
        if (s == SW_NOCONV) { /* on the singular place itself */
            hi = t;
            s = SW_OK;
        } else if (s == SW_OK && k->w->negative > before) {
            hi = t;
            s = step_back(k);
        }
    }
    k->path->critical = (hi + k->s->t) / 2;
    return s;
}

static enum status by_load(struct walk *k, double end)
{
    double step = 1.0 / k->o->parts;
    enum status s = SW_OK;

    while (s == SW_OK && k->s->t < end - 1e-12 && isnan(k->path->critical)) {
        double t = fmin(k->s->t + step, end);
        int before = k->w->negative;

        if (t > end - 0.1 * step)
            t = end;
        if (k->path->n > k->o->steps)
            return SW_NOCONV;
        s = load_step(k, t);
        if (s == SW_NOCONV) {
            step /= 2;
            s = step < SMALLEST ? SW_NOCONV : SW_OK;
        } else if (s == SW_OK) {
            int easy = k->iterations <= EASY;

            if (k->o->critical && k->w->negative > before)
                s = find_critical(k, t);
            if (s == SW_OK)
                s = record(k);
            step *= easy ? GROW : k->iterations > 2 * EASY ? 0.7 : 1;
            step = fmin(step, (double)MOST / k->o->parts);
        }
    }
    return s;
}

/* Weight of an unknown in the length of a step: translations over the structure's size. */
static void weigh(const struct walk *k, const double *dx, double *to)
{
    double part = 1 / (k->w->size * k->w->size);

    memcpy(to, dx, (size_t)k->w->unknowns * sizeof *to);
    for (int i = 0; i < 6 * k->f->n; i++)
        if (i % 6 < 3 && k->w->dof[i] >= 0)
            to[k->w->dof[i]] *= part;
}

static double inner(const struct walk *k, const double *a, const double *b)
{
    double sum = 0;

    for (int i = 0; i < k->w->unknowns; i++)
        sum += a[i] * b[i];
    return sum;
}

/* rate = K^-1 (dP/dt - K dp/dt), dx = K^-1 right; K is factored first. */
static enum status two_directions(struct walk *k)
{
    struct frame_work *w = k->w;
    size_t n = (size_t)w->unknowns;
    double t = k->s->t;
    const double small = 1e-3; /* spins of what is held: of so much time */
    enum status s;

    frame_given(k->f, t, t + small, k->move);
    for (int i = 0; i < 6 * k->f->n; i++)
        k->move[i] /= small;
    frame_set_loads(k->f, t + 1, w);
    frame_evaluate(k->f, k->s, (struct frame_moves){k->move, NULL}, w);
    memcpy(k->rate, w->right, n * sizeof *k->rate);
    frame_set_loads(k->f, t, w);
    frame_evaluate(k->f, k->s, FRAME_STILL, w);
    memcpy(k->dx, w->right, n * sizeof *k->dx);
    for (size_t i = 0; i < n; i++)
        k->rate[i] -= k->dx[i];
    s = factor(k);
    if (s == SW_OK)
        s = twist_solve(&k->twist, w, k->dx);
    return s == SW_OK ? twist_solve(&k->twist, w, k->rate) : s;
}

/* dx + dt rate, and what is held from t to t + dt. */
static void go(struct walk *k, double dt)
{
    double t = k->s->t;

    for (int i = 0; i < k->w->unknowns; i++)
        k->dx[i] += dt * k->rate[i];
    frame_given(k->f, t, t + dt, k->move);
    foresee(k, k->move);
    frame_move(k->f, k->w, k->dx, k->move, k->s);
    k->s->t = t + dt;
}

/* A step of length l along the path (Riks): corrections normal to the predictor. */
static enum status arc_step(struct walk *k, double l)
{
    double *normal = k->along, size, dt, dot;
    enum status s;

    k->w->guessed = 0;
    s = two_directions(k);
    if (s != SW_OK)
        return s;
    dot = inner(k, k->along, k->rate); /* of the step before, weighted: go on, not back */
    weigh(k, k->rate, normal);
    size = sqrt(inner(k, normal, k->rate));
    dt = (dot < 0 ? -1 : 1) * l / size;
    for (int i = 0; i < k->w->unknowns; i++)
        normal[i] *= dt < 0 ? -1 : 1;
    memset(k->dx, 0, (size_t)k->w->unknowns * sizeof *k->dx);
    if (!(largest_spin(k, k->rate, NULL) * fabs(dt) < 2 * SPIN))
        return SW_NOCONV;
    go(k, dt);
    for (k->iterations = 1; k->iterations <= k->o->iterations; k->iterations++) {
        s = two_directions(k);
        if (s != SW_OK)
            return s;
        k->residual = frame_residual(k->f, k->w, k->o->tolerance);
        if (!(k->w->angle < TURN) || isnan(k->residual))
            return SW_NOCONV;
        if (k->residual <= k->o->tolerance)
            return settle(k);
        dt = -inner(k, normal, k->dx) / inner(k, normal, k->rate);
        if (!(fabs(dt) < 1e3))
            return SW_NOCONV;
        go(k, dt);
    }
    return SW_NOCONV;
}

static enum status by_arc(struct walk *k, double end)
{
    double l = 0, first;
    double *direction = mem_doubles((size_t)k->w->unknowns);
    enum status s = direction ? two_directions(k) : SW_NOMEM;

    if (s == SW_OK) {
        weigh(k, k->rate, k->along);
        l = sqrt(inner(k, k->along, k->rate)) / k->o->parts;
    }
    first = l;
    while (s == SW_OK && k->s->t < end && k->path->n <= k->o->steps) {
        memcpy(direction, k->along, (size_t)k->w->unknowns * sizeof *direction);
        frame_state_copy(k->f, k->s, &k->before);
        s = arc_step(k, l);
        if (s == SW_NOCONV || s == SW_INDEFINITE) {
            memcpy(k->along, direction, (size_t)k->w->unknowns * sizeof *direction);
            l /= 2;
            s = step_back(k) == SW_OK && l > SMALLEST * first ? SW_OK : SW_NOCONV;
            continue;
        }
        if (s == SW_OK && k->s->t > end) /* the last piece by load */
            s = load_step(k, end);
        if (s == SW_OK)
            s = record(k);
        l = fmin(l * (k->iterations <= EASY ? GROW : 0.7), MOST * first);
    }
    free(direction);
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
        status = record(&k);
    if (status == SW_OK)
        status = by_load(&k, o->arc ? f->stages - 1 : f->stages);
    k.own.arc = o->arc;
    if (status == SW_OK && o->arc && isnan(ret->critical))
        status = by_arc(&k, f->stages);
    if (status == SW_NOCONV && ret->n == 1 && w->K.least < WEAK) {
        ret->failed_node = frame_node_of(f, w, w->K.weakest);
        status = SW_INDEFINITE;
    }
    walk_free(&k);
    return status;
}
