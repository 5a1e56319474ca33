/* From a case to a march that is ready to go. */
#include "form/launch.h"
#include "form/modeldir.h"
#include "form/state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MAX_STEPS 1e15 /* exact in a double, and longer than anyone waits */

int launch_modes_wanted(const struct cable_case *c)
{
    int wanted = c->time.start == START_MODE ? c->time.start_mode : 0;

    for (int i = 0; i < c->n_disturbances; i++)
        if (c->disturbance[i].mode > wanted)
            wanted = c->disturbance[i].mode;
    return wanted;
}

enum status launch_modes(const struct cable_case *c, const char *dir, struct model *m, int wanted,
                         struct modes *ret, struct why *why)
{
    enum status s;

    *ret = (struct modes){.k = 0};
    if (dir) {
        s = modeldir_read(dir, c, m, ret, why);
        if (s == SW_OK && wanted > ret->k)
            s = fail(why, SW_USAGE, "%s: holds %d modes; mode %d is wanted", dir, ret->k, wanted);
        return s;
    }
    if (wanted == 0)
        return SW_OK;
    s = modes_lowest(m, wanted, SOLVER_AUTO, ret);
    if (s == SW_ADMISSIBLE)
        return fail(why, s, "mode %d is wanted; more than %d elements allow modes up to %d", wanted,
                    MODES_MAX_ELEMENTS, modes_lanczos_most(c->elements));
    return s == SW_OK ? s : fail(why, s, "modes: %s", status_text(s));
}

static struct forcing forcing(const struct cable_case *c)
{
    return (struct forcing){c->force, c->n_forces, c->wind};
}

/* Steps in an interval, 0: as many as it takes. */
static enum status lay_steps(const struct launch *l, double end, long *ret, struct why *why)
{
    const struct time_plan *t = &l->c->time;
    int central = t->scheme == SCHEME_CENTRAL;
    double critical = march_critical_step(l->model);
    double longest = t->step > 0 ? t->step : central ? 0.9 * critical : INFINITY;
    double substeps = ceil(l->interval / longest * (1 - 1e-12)), marks = end / l->interval;
    double dt = l->interval / substeps;

    if (central && dt > critical)
        return fail(why, SW_DIVERGED,
                    "t = 0 s: would diverge: the step of %.6g s%s is longer than the critical %.6g "
                    "s; set time.step = auto or to less than that",
                    dt, dt < t->step ? " (time.step, shortened to divide output_every)" : "",
                    critical);
    if (!(marks * fmax(substeps, 1) <= MAX_STEPS))
        return fail(why, SW_USAGE, "[time]: %.3g steps are more than can be done",
                    marks * fmax(substeps, 1));
    *ret = (long)substeps;
    return SW_OK;
}

/* shape := mode k (from 1), largest nodal displacement 1 m. */
static enum status take_mode(const struct launch *l, int k, struct why *why)
{
    if (modes_unit_shape(l->model, l->modes, k - 1, l->shape) != SW_OK)
        return fail(why, SW_USAGE,
                    "mode %d has no displacement at the nodes of this mesh; take more elements", k);
    return SW_OK;
}

/* All modes that will be needed can be scaled. */
static enum status judge_modes(const struct launch *l, double end, struct why *why)
{
    const struct cable_case *c = l->c;
    enum status s = SW_OK;

    if (c->time.start == START_MODE)
        s = take_mode(l, c->time.start_mode, why);
    for (int i = 0; i < c->n_disturbances && s == SW_OK; i++)
        if (c->disturbance[i].mode > 0 && c->disturbance[i].time <= end)
            s = take_mode(l, c->disturbance[i].mode, why);
    return s;
}

enum status launch_new(const struct cable_case *c, const struct model *m, const struct modes *modes,
                       double interval, double end, struct launch *ret, struct why *why)
{
    struct march_options how = {.alpha = c->alpha,
                                .beta = c->beta,
                                .scheme = (enum scheme)c->time.scheme,
                                .interval = interval,
                                .radius = c->time.radius,
                                .tolerance = c->time.tolerance,
                                .terms = c->terms,
                                .motion = c->motion,
                                .n_motions = c->n_motions,
                                .damper = c->damper,
                                .n_dampers = c->n_dampers,
                                .forcing = forcing(c)};
    enum status s;

    *ret = (struct launch){.c = c, .model = m, .modes = modes, .interval = interval};
    ret->shape = model_vector(m);
    ret->speed = model_vector(m);
    if (!ret->shape || !ret->speed) {
        launch_free(ret);
        return fail_plain(why, SW_NOMEM);
    }
    s = lay_steps(ret, end, &how.substeps, why);
    how.dt = interval / fmax((double)how.substeps, 1);
    if (s == SW_OK)
        s = judge_modes(ret, end, why);
    if (s == SW_OK) {
        s = march_new(m, &how, &ret->march);
        if (s != SW_OK)
            fail(why, s, "time integration: %s", status_text(s));
    }
    if (s != SW_OK)
        launch_free(ret);
    return s;
}

void launch_free(struct launch *l)
{
    free(l->shape);
    free(l->speed);
    march_free(&l->march);
    *l = (struct launch){.c = NULL};
}

/* shape := equilibrium for the supports where they are at t = 0, under the forces there. */
static enum status find_equilibrium(struct launch *l, struct why *why)
{
    const struct cable_case *c = l->c;
    struct forcing outer = forcing(c);
    double u[6], b[6];
    enum status s;

    motion_sum(c->motion, c->n_motions, 0, u, NULL, NULL);
    axes_to_plane(&l->model->axes, u, b);
    axes_to_plane(&l->model->axes, u + 3, b + 3);
    s = forcing_equilibrium(l->model, &outer, c->terms, b, l->shape);
    if (s == SW_ADMISSIBLE)
        return fail(why, s, "the supports at t = 0 leave no static line: span %g m, drop %g m",
                    hypot(c->bare.span + u[3] - u[0], u[5] - u[2]), c->bare.drop + u[4] - u[1]);
    if (s == SW_NOMEM)
        return fail(why, s, "equilibrium at t = 0: %s", status_text(s));
    if (s != SW_OK)
        return fail(why, s,
                    "no equilibrium was found for the supports at t = 0; is the cable slack there? "
                    " time.start = rest with a ramp does without it");
    return s;
}

/* V and, where one is given, the velocity of the start. */
static enum status find_start(struct launch *l, const char *path, int *has_speed, struct why *why)
{
    const struct time_plan *t = &l->c->time;
    char *from;
    enum status s;

    *has_speed = t->start == START_STATE;
    if (t->start == START_REST) {
        memset(l->shape, 0, sizeof *l->shape * model_unknowns(l->model));
        return SW_OK;
    }
    if (t->start != START_STATE)
        return find_equilibrium(l, why);
    from = case_beside(path, t->start_text);
    if (!from)
        return fail_plain(why, SW_NOMEM);
    if (state_is_there(from))
        s = state_start(from, l->model, l->shape, l->speed, why);
    else
        s = fail(why, SW_USAGE,
                 "[time] start: '%s' is neither static, rest nor mode K AMPLITUDE, and there is no "
                 "such state file",
                 t->start_text);
    free(from);
    return s;
}

enum status launch_start(struct launch *l, const char *path, struct why *why)
{
    const struct time_plan *t = &l->c->time;
    int has_speed;
    enum status s = find_start(l, path, &has_speed, why);

    if (s != SW_OK)
        return s;
    s = march_start(&l->march, l->shape, has_speed ? l->speed : NULL);
    if (s == SW_OK && t->start == START_MODE) {
        take_mode(l, t->start_mode, why);
        march_kick(&l->march, KICK_DISPLACEMENT, t->start_amplitude, l->shape);
        memcpy(l->shape, l->march.V, sizeof *l->shape * model_unknowns(l->model));
        /* again: its first increment is that of this deflection */
        s = march_start(&l->march, l->shape, NULL);
    }
    return s == SW_OK ? s : fail(why, s, "start: %s", status_text(s));
}

int launch_disturbance_due(const struct launch *l, const struct disturbance *d)
{
    const struct march *m = &l->march;

    if (!m->alpha)
        return (double)m->step == ceil(d->time / m->options.dt * (1 - 1e-12));
    return d->time * (1 - 1e-12) <= march_time(m) && d->time * (1 - 1e-12) > march_past(m);
}

void launch_disturb(struct launch *l, const struct disturbance *d)
{
    struct why why;
    double v[3];

    if (d->mode > 0) {
        take_mode(l, d->mode, &why); /* judged before */
        march_kick(&l->march, (enum kick)d->kind, d->amplitude[0], l->shape);
        return;
    }
    memset(l->shape, 0, sizeof *l->shape * model_unknowns(l->model));
    axes_to_plane(&l->model->axes, d->amplitude, v);
    for (int axis = 0; axis < 3; axis++)
        l->shape[6 * d->node + 2 * axis] = v[axis];
    march_kick(&l->march, (enum kick)d->kind, 1, l->shape);
}

enum status launch_fail(const struct launch *l, enum status s, struct why *why)
{
    const struct march *m = &l->march;
    double stable = march_critical_step(l->model), t = march_time(m);

    if (m->alpha && s != SW_DIVERGED)
        return fail(why, s,
                    "t = %.9g s: the implicit step finds no balance%s; set a smaller time.step", t,
                    l->c->time.step > 0 ? " with time.step" : " however short it is");
    if (m->alpha || !isfinite(m->stiffened))
        return fail(why, s,
                    "t = %.9g s: diverged with a step of %.6g s: numbers are no longer finite; "
                    "look at the amplitudes, or set a smaller time.step",
                    t, m->options.dt);
    return fail(why, s,
                "t = %.9g s: diverged: the cable is stretched so far that it allows a step of %.6g "
                "s only, not %.6g s; look at the amplitudes%s, or set a smaller time.step",
                t, stable / sqrt(1 + m->stiffened), m->options.dt,
                l->c->terms < 3 ? " (terms = 1 and 2 lack the part that bounds them)" : "");
}
