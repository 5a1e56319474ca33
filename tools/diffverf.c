/* diffverf: nonlinear vibration of one cable under moving supports, by central differences. */
#include "form/modeldir.h"
#include "form/start.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>

#define MAX_STEPS 1e15 /* exact in a double, and longer than anyone waits */

static struct {
    struct opt_common common;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR",
     "take the modes from the model directory of modal", 0, 0},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {
    "diffverf", "CASE",
    "Nonlinear vibration of one cable under moving supports, by central differences.", options};

/* The time grid: rows of output, steps between them. */
struct grid {
    double dt;
    long rows, substeps;
};

static struct grid lay_grid(const struct time_plan *t, double critical)
{
    double longest = t->step > 0 ? t->step : 0.9 * critical;
    double substeps = ceil(t->output_every / longest * (1 - 1e-12));
    double rows = floor(t->end / t->output_every * (1 + 1e-12)) + 1;

    if (!(rows * substeps <= MAX_STEPS))
        die(SW_USAGE, "[time]: %.3g steps are more than can be done", rows * substeps);
    return (struct grid){t->output_every / substeps, (long)rows, (long)substeps};
}

/* Modes for the start and the disturbances, if any of them needs one. */
static void get_modes(const struct cable_case *c, const struct model *m, struct modes *ret)
{
    int wanted = c->time.start == START_MODE ? c->time.start_mode : 0;
    struct why why;
    enum status s;

    *ret = (struct modes){0};
    for (int i = 0; i < c->n_disturbances; i++)
        if (c->disturbance[i].mode > wanted)
            wanted = c->disturbance[i].mode;
    if (args.common.dir) {
        must(modeldir_read(args.common.dir, c, m, ret, &why), &why);
        if (wanted > ret->k)
            die(SW_USAGE, "%s: holds %d modes; mode %d is wanted", args.common.dir, ret->k, wanted);
    } else if (wanted > 0) {
        s = modes_all(m, wanted, ret);
        if (s == SW_ADMISSIBLE)
            die(s, "a mode is wanted, which takes up to %d elements; the case has %d",
                MODES_MAX_ELEMENTS, c->elements);
        if (s != SW_OK)
            die(s, "modes: %s", status_text(s));
    }
}

/* Start of the march from equilibrium, rest or a mode; V is work space over all nodes. */
static void start_march(const struct cable_case *c, const struct modes *modes, struct march *m,
                        double *V)
{
    double u[6];
    enum status s = SW_OK;

    motion_sum(c->motion, c->n_motions, 0, u, NULL, NULL);
    if (c->time.start != START_REST)
        s = model_equilibrium(m->model, c->terms, u, V);
    if (s != SW_OK)
        die(s,
            "equilibrium for the supports at t = 0: %s; time.start = rest with a ramp does without",
            status_text(s));
    s = march_start(m, V);
    if (s == SW_OK && c->time.start == START_MODE) {
        modes_unit_shape(m->model, modes, c->time.start_mode - 1, V);
        march_kick(m, KICK_DISPLACEMENT, c->time.start_amplitude, V);
        for (size_t i = 0; i < 6 * ((size_t)m->model->n + 1); i++)
            V[i] = m->V[i];
        s = march_start(m, V); /* again: the first increment is that of the deflected cable */
    }
    if (s != SW_OK)
        die(s, "start: %s", status_text(s));
}

/* Disturbances whose time has come; done[i] marks those. */
static void disturb(const struct cable_case *c, const struct modes *modes, struct march *m,
                    double *V, char *done)
{
    for (int i = 0; i < c->n_disturbances; i++) {
        const struct disturbance *d = &c->disturbance[i];
        double size = d->amplitude[0];

        if (done[i] || march_time(m) < d->time * (1 - 1e-12))
            continue;
        done[i] = 1;
        if (d->mode > 0)
            modes_unit_shape(m->model, modes, d->mode - 1, V);
        else {
            for (size_t j = 0; j < 6 * ((size_t)m->model->n + 1); j++)
                V[j] = 0;
            for (int axis = 0; axis < 3; axis++)
                V[6 * d->node + 2 * axis] = d->amplitude[axis];
            size = 1;
        }
        march_kick(m, (enum kick)d->kind, size, V);
    }
}

static void print_header(const struct time_plan *t, struct out *o)
{
    fputs("time_s", o->f);
    for (int p = 1; p <= t->n_probes; p++)
        fprintf(o->f, ",v1_%d_m,v2_%d_m,v3_%d_m,tension_%d_N", p, p, p, p);
    fputs(",force_left_1_N,force_left_2_N,force_left_3_N,force_right_1_N,force_right_2_N,"
          "force_right_3_N\n",
          o->f);
}

static void print_row(const struct time_plan *t, double time, const struct march *m, struct out *o)
{
    double row[1 + 4 * MAX_PROBES + 6] = {time}, *to = row + 1;

    for (int p = 0; p < t->n_probes; p++, to += 4)
        model_probe(m->model, t->probe[p], m->V, to, to + 3);
    march_support_force(m, to);
    out_row(o, row, 1 + 4 * t->n_probes + 6);
}

__attribute__((noreturn)) static void report_divergence(const struct march *m)
{
    double stable = 2 / m->omega_max;

    if (m->options.terms > 0 && m->stiffened > 0)
        stable /= sqrt(1 + m->stiffened);
    if (isfinite(m->stiffened) && m->options.dt > stable)
        die(SW_DIVERGED,
            "t = %.9g s: diverged: the step of %.6g s is longer than the %.6g s that the cable, "
            "stretched as it is, allows; set time.step = auto or less than that",
            march_time(m), m->options.dt, stable);
    die(SW_DIVERGED,
        "t = %.9g s: diverged with a step of %.6g s: numbers are no longer finite; set "
        "a smaller time.step, or smaller amplitudes",
        march_time(m), m->options.dt);
}

static void run(const struct cable_case *c, const struct grid *grid, const struct modes *modes,
                struct march *m, double *V, struct out *o)
{
    char done[MAX_LABELLED] = {0};
    long steps = (grid->rows - 1) * grid->substeps;

    print_header(&c->time, o);
    for (long k = 0; k <= steps && !signals_pending() && !out_failed(o); k++) {
        disturb(c, modes, m, V, done);
        if (march_solve(m) != SW_OK)
            report_divergence(m);
        if (k % grid->substeps == 0) {
            print_row(&c->time, (double)(k / grid->substeps) * c->time.output_every, m, o);
            progress((double)k / (double)(steps > 0 ? steps : 1), "diffverf");
        }
        march_advance(m);
    }
    progress_end();
    if (m->slack_time >= 0)
        warn("slack: the cable would carry compression, first at t = %.6g s, theta = %.6g m; it "
             "cannot, so that what follows is not to be trusted",
             m->slack_time, m->slack_theta);
}

int main(int argc, char **argv)
{
    static struct cable_case c;
    struct march_options options_of_march;
    struct model model;
    struct modes modes;
    struct march march;
    struct grid grid;
    struct out o;
    struct why why;
    double *V;
    enum status s;

    start_case(&tool, &args.common, argc, argv, &c);
    if (isnan(c.time.end))
        die(SW_USAGE, "%s: [time] end: is missing", argv[argc - 1]);
    s = model_new(&c.cable, (enum law)c.law, c.elements, &model);
    if (s != SW_OK)
        die(s, "model: %s", status_text(s));
    get_modes(&c, &model, &modes);
    grid = lay_grid(&c.time, march_critical_step(&model));
    options_of_march =
        (struct march_options){c.alpha, c.beta, grid.dt, c.terms, c.motion, c.n_motions};
    s = march_new(&model, &options_of_march, &march);
    V = mem_doubles(6 * ((size_t)c.elements + 1));
    if (s != SW_OK || !V)
        die(V ? s : SW_NOMEM, "march: %s", status_text(V ? s : SW_NOMEM));
    note("%ld steps of %.6g s, critical %.6g s", (grid.rows - 1) * grid.substeps, grid.dt,
         march_critical_step(&model));
    must(out_open(&o, args.common.out, &why), &why);
    start_march(&c, &modes, &march, V);
    signals_defer();
    run(&c, &grid, &modes, &march, V, &o);
    if (signals_pending()) {
        if (!args.common.out)
            fflush(stdout); /* complete lines of what was done */
        signals_end();
    }
    must(out_close(&o, &why), &why);
    free(V);
    march_free(&march);
    modes_free(&modes);
    model_free(&model);
    return 0;
}
