/* Load paths by arc length, past limit points. */
#include "num/mem.h"
#include "phys/walk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    s = walk_factor(k);
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
    walk_foresee(k, k->move);
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
    if (!(walk_spin(k, k->rate, NULL) * fabs(dt) < 2 * WALK_SPIN))
        return SW_NOCONV;
    go(k, dt);
    for (k->iterations = 1; k->iterations <= k->o->iterations; k->iterations++) {
        s = two_directions(k);
        if (s != SW_OK)
            return s;
        k->residual = frame_residual(k->f, k->w, k->o->tolerance);
        if (!(k->w->angle < WALK_TURN) || isnan(k->residual))
            return SW_NOCONV;
        if (k->residual <= k->o->tolerance)
            return walk_settle(k);
        dt = -inner(k, normal, k->dx) / inner(k, normal, k->rate);
        if (!(fabs(dt) < 1e3))
            return SW_NOCONV;
        go(k, dt);
    }
    return SW_NOCONV;
}

/* A step of length l; what fails leaves state and direction where they were. */
static enum status try_arc(struct walk *k, double l)
{
    size_t bytes = (size_t)k->w->unknowns * sizeof *k->along;
    enum status s, back;

    memcpy(k->last, k->along, bytes);
    frame_state_copy(k->f, k->s, &k->before);
    s = arc_step(k, l);
    if (s != SW_NOCONV && s != SW_INDEFINITE)
        return s;
    memcpy(k->along, k->last, bytes);
    back = walk_back(k);
    return back == SW_OK ? SW_NOCONV : back;
}

/* Within the step of length l that has just passed it, by halving. */
static enum status find_critical(struct walk *k, double l)
{
    size_t bytes = (size_t)k->w->unknowns * sizeof *k->along;
    double least = WALK_FINE * l;
    enum status s = walk_back(k);
    int before = k->w->negative;

    memcpy(k->along, k->last, bytes);
    while (s == SW_OK && l > least) {
        l /= 2;
        s = try_arc(k, l);
        if (s == SW_NOCONV) { /* on the singular place itself */
            s = SW_OK;
        } else if (s == SW_OK && k->w->negative > before) {
            memcpy(k->along, k->last, bytes);
            s = walk_back(k);
        }
    }
    k->path->critical = k->s->t;
    return s;
}

enum status walk_arc(struct walk *k, double end)
{
    enum status s = two_directions(k);
    double l = 0, first;

    if (s == SW_OK) {
        weigh(k, k->rate, k->along);
        l = sqrt(inner(k, k->along, k->rate)) / k->o->parts;
    }
    first = l;
    while (s == SW_OK && k->s->t < end && k->path->n <= k->o->steps && isnan(k->path->critical)) {
        int before = k->w->negative;

        s = try_arc(k, l);
        if (s == SW_NOCONV) {
            l /= 2;
            s = l > WALK_SMALLEST * first ? SW_OK : SW_NOCONV;
            continue;
        }
        if (s == SW_OK && k->o->critical && k->w->negative > before)
            s = find_critical(k, l);
        else if (s == SW_OK && k->s->t > end) /* the last piece by load */
            s = walk_by_load(k, end);
        if (s == SW_OK)
            s = walk_record(k);
        l = fmin(l * (k->iterations <= WALK_EASY ? WALK_GROW : 0.7), WALK_MOST * first);
    }
    return s;
}
