/* The steady responses of many parameter points. */
#include "form/ensemble.h"
#include "num/mem.h"
#include "phys/lanes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LOOK 1024 /* steps of the lanes between two looks at signals */

/* Points that can share lanes: the same nonlinear terms, and beta > 0 or not.  Class 0: those that
 * march by themselves; the last one: those that cannot be used, done first, so that no row waits
 * for them. */
enum { ALONE, USELESS = 9, CLASSES };

static int class_of(const struct cable_case *c)
{
    if (c->time.scheme != SCHEME_CENTRAL || c->n_dampers > 0 || c->n_forces > 0 || c->wind.cd > 0)
        return ALONE;
    return 1 + 2 * c->terms + (c->beta > 0);
}

/* What the threads share. */
struct work {
    const struct ensemble *e;
    signed char *class;       /* of each point */
    int next[CLASSES];        /* the first point that may still be waiting */
    int n_motions;            /* of a point at the most */
    struct outcome **outcome; /* of points that are done, until they are delivered */
    int delivered;            /* points before it are delivered */
    int stop;
    enum status status;
};

static int stopped(struct work *w)
{
    int stop;

#pragma omp atomic read
    stop = w->stop;
    return stop || signals_pending();
}

/* The first failure stays, whatever stops the others. */
static void stop(struct work *w, enum status s)
{
#pragma omp critical(ensemble_files)
    {
        if (w->status == SW_OK)
            w->status = s;
#pragma omp atomic write
        w->stop = 1;
    }
}

/* The next waiting point of a class, -1: none. */
static int take(struct work *w, int class)
{
    int n = w->e->points->n, i;

#pragma omp critical(ensemble_take)
    {
        i = w->next[class];
        while (i < n && w->class[i] != class)
            i++;
        w->next[class] = i + 1;
    }
    return i < n ? i : -1;
}

/* Hand over what became of point i, and all outcomes that have waited for it. */
static void finish(struct work *w, int i, const struct outcome *o)
{
    struct outcome *copy = mem_copy(o, sizeof *o);
    int more = 0;

    if (!copy) {
        stop(w, SW_NOMEM);
        return;
    }
#pragma omp critical(ensemble_files)
    {
        w->outcome[i] = copy;
        while (!more && w->delivered < w->e->points->n && w->outcome[w->delivered]) {
            int done = w->delivered++;

            more = w->e->deliver(done, w->outcome[done]);
            free(w->outcome[done]);
            w->outcome[done] = NULL;
        }
    }
    if (more)
        stop(w, SW_OK);
}

/* One point on its way. */
struct flight {
    int point; /* -1: none */
    struct cable_case c;
    struct launch launch;
    struct steady steady;
    struct outcome outcome;
    long marks, substeps;
};

/* Case and march of point i, at its start.  One thread at a time: files may be read. */
static enum status prepare(const struct ensemble *e, int i, struct flight *f)
{
    struct outcome *o = &f->outcome;
    enum status s;

    memset(f, 0, sizeof *f);
    f->point = i;
#pragma omp critical(ensemble_files)
    {
        s = points_case(e->points, i, &f->c, &o->why);
        if (s == SW_OK)
            s = drive_of(&f->c, e->model, &o->drive, &o->why);
        if (s == SW_OK)
            s = launch_new(&f->c, e->model, e->modes, drive_interval(&o->drive),
                           response_end(&f->c, &o->drive), &f->launch, &o->why);
        if (s == SW_OK)
            s = launch_start(&f->launch, e->points->case_path, &o->why);
    }
    if (s == SW_OK)
        f->marks = (long)floor(response_end(&f->c, &o->drive) / f->launch.interval * (1 + 1e-12));
    f->substeps = f->launch.march.options.substeps;
    return o->status = s;
}

/* The words of a flight's failure begin with its line. */
static void locate(const struct ensemble *e, struct flight *f)
{
    struct why old = f->outcome.why;
    size_t length = strlen(e->points->name);

    if (strncmp(old.text, e->points->name, length) != 0 || old.text[length] != ':')
        fail(&f->outcome.why, f->outcome.status, "%.400s:%d: %.600s", e->points->name,
             e->points->point[f->point].line, old.text);
}

static void land(struct work *w, struct flight *f)
{
    if (f->outcome.status == SW_NOMEM)
        stop(w, SW_NOMEM);
    if (f->outcome.status != SW_OK)
        locate(w->e, f);
    if (!stopped(w))
        finish(w, f->point, &f->outcome);
    steady_free(&f->steady);
    launch_free(&f->launch);
    case_free(&f->c);
    f->point = -1;
}

static int interrupted(double share)
{
    (void)share;
    return signals_pending();
}

static void fly_alone(struct work *w, int class)
{
    struct flight f;
    int i;

    while (!stopped(w) && (i = take(w, class)) >= 0) {
        if (prepare(w->e, i, &f) == SW_OK)
            f.outcome.status = response_find(&f.launch, &f.outcome.drive, interrupted,
                                             &f.outcome.response, &f.outcome.why);
        land(w, &f);
    }
}

/* Disturbances of lane i that are due now. */
static void disturb(struct lanes *p, int i, struct flight *f)
{
    struct launch *l = &f->launch;
    struct march *m = &l->march;

    if (f->c.n_disturbances == 0)
        return;
    m->step = p->step[i];
    for (int d = 0; d < f->c.n_disturbances; d++)
        if (launch_disturbance_due(l, &f->c.disturbance[d])) {
            memset(m->V, 0, sizeof *m->V * model_unknowns(l->model));
            memset(m->D, 0, sizeof *m->D * model_unknowns(l->model));
            launch_disturb(l, &f->c.disturbance[d]);
            lanes_add(p, i, m->V, m->D);
        }
}

/* The next point of the class into lane i, if there is one. */
static void board(struct work *w, int class, struct lanes *p, int i, struct flight *f)
{
    int point;

    f->point = -1;
    while (!stopped(w) && (point = take(w, class)) >= 0) {
        enum status s = prepare(w->e, point, f);
        struct steady_options o = response_options(&f->c, &f->outcome.drive);

        if (s == SW_OK) {
            s = steady_new(w->e->model, &o, &f->steady);
            if (s != SW_OK)
                f->outcome.status = fail_plain(&f->outcome.why, s);
        }
        if (s == SW_OK) {
            f->launch.march.slack_time = -1;
            lanes_put(p, i, &f->launch.march);
            disturb(p, i, f);
            return;
        }
        land(w, f);
    }
    lanes_clear(p, i);
}

/* What a step has brought lane i; whether its flight is over. */
static int arrive(struct lanes *p, int i, struct flight *f)
{
    double dt = p->dt[i], t = (double)p->step[i] * dt;
    struct march *m = &f->launch.march;
    struct outcome *o = &f->outcome;
    int done = 0;

    if (lanes_negative(&p->slack, i) && m->slack_time < 0)
        m->slack_time = t - dt;
    if (lanes_negative(&p->bad, i)) {
        o->status = fail(&o->why, SW_DIVERGED,
                         "t = %.9g s: diverged with a step of %.6g s; look at the amplitudes, or "
                         "set a smaller time.step",
                         t - dt, dt);
        return 1;
    }
    disturb(p, i, f);
    if (p->step[i] % f->substeps != 0)
        return 0;
    lanes_tune(p, i);
    lanes_look(p, i, m->V);
    o->status = steady_add(&f->steady, t, o->drive.omega * t, m->V, &done);
    if (o->status != SW_OK)
        fail_plain(&o->why, o->status);
    if (o->status == SW_OK && (done || p->step[i] / f->substeps >= f->marks)) {
        steady_end(&f->steady);
        response_take(&f->steady, &o->drive, t, m->slack_time, &o->response);
        done = 1;
    }
    return done || o->status != SW_OK;
}

static enum status fly_together(struct work *w, int class)
{
    struct flight *f = mem_zeroed(LANES, sizeof *f);
    struct lanes p;
    int flying = 0;
    enum status s =
        f ? lanes_new(w->e->model, (class - 1) / 2, (class - 1) % 2, w->n_motions, &p) : SW_NOMEM;

    for (int i = 0; i < LANES && s == SW_OK; i++) {
        board(w, class, &p, i, &f[i]);
        flying += f[i].point >= 0;
    }
    for (long k = 1; flying > 0 && s == SW_OK; k++) {
        lanes_step(&p);
        for (int i = 0; i < LANES; i++)
            if (f[i].point >= 0 && arrive(&p, i, &f[i])) {
                land(w, &f[i]);
                board(w, class, &p, i, &f[i]);
                flying -= f[i].point < 0;
            }
        if (k % LOOK == 0 && stopped(w))
            break;
    }
    for (int i = 0; i < LANES && s == SW_OK; i++)
        if (f[i].point >= 0)
            land(w, &f[i]); /* only after a stop */
    if (s == SW_OK)
        lanes_free(&p);
    free(f);
    return s;
}

/* Classes of all points, before any of them is run.  SW_NOMEM. */
static enum status classify(struct work *w)
{
    const struct points *p = w->e->points;

    for (int i = w->e->first; i < p->n; i++) {
        struct cable_case c;
        struct why why;
        enum status s = points_case(p, i, &c, &why);

        w->class[i] = USELESS;
        if (s == SW_NOMEM)
            return s;
        if (s != SW_OK)
            continue;
        w->class[i] = (signed char)class_of(&c);
        w->n_motions = c.n_motions > w->n_motions ? c.n_motions : w->n_motions;
        case_free(&c);
    }
    return SW_OK;
}

enum status ensemble_modes_wanted(const struct points *p, int *ret, struct why *why)
{
    *ret = 0;
    for (int i = 0; i < p->n; i++) {
        struct cable_case c;
        int wanted;
        enum status s = points_case(p, i, &c, why);

        if (s == SW_NOMEM)
            return s;
        if (s != SW_OK)
            continue;
        wanted = launch_modes_wanted(&c);
        *ret = wanted > *ret ? wanted : *ret;
        case_free(&c);
    }
    return SW_OK;
}

enum status ensemble_run(const struct ensemble *e, struct why *why)
{
    size_t n = (size_t)e->points->n;
    struct work w = {.e = e, .delivered = e->first, .status = SW_OK};

    w.class = mem_zeroed(n, sizeof *w.class);
    w.outcome = mem_zeroed(n, sizeof *w.outcome);
    if (!w.class || !w.outcome) {
        free(w.class);
        free(w.outcome);
        return fail_plain(why, SW_NOMEM);
    }
    for (int i = 0; i < CLASSES; i++)
        w.next[i] = e->first;
    w.status = classify(&w);
    w.stop = w.status != SW_OK;
    fly_alone(&w, USELESS);
#pragma omp parallel num_threads(e->threads) if (!w.stop)
    {
        for (int class = 1; class < USELESS; class ++) {
            enum status s = fly_together(&w, class);

            if (s != SW_OK)
                stop(&w, s);
        }
        fly_alone(&w, ALONE);
    }
    for (size_t i = 0; i < n; i++)
        free(w.outcome[i]);
    free(w.outcome);
    free(w.class);
    return w.status == SW_OK ? SW_OK : fail_plain(why, w.status);
}
