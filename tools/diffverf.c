/* diffverf: nonlinear vibration of one cable under moving supports, by central differences. */
#include "form/modeldir.h"
#include "form/start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* What the run works on. */
static struct cable_case c;
static struct model model;
static struct modes modes;
static struct march march;
static double *shape; /* work space over all nodes */

/* The time grid: rows of output, steps between them. */
struct grid {
    double dt;
    long rows, substeps;
};

static struct grid lay_grid(void)
{
    const struct time_plan *t = &c.time;
    double critical = march_critical_step(&model);
    double longest = t->step > 0 ? t->step : 0.9 * critical;
    double substeps = ceil(t->output_every / longest * (1 - 1e-12));
    double rows = floor(t->end / t->output_every * (1 + 1e-12)) + 1;
    double dt = t->output_every / substeps;

    if (dt > critical)
        die(SW_DIVERGED,
            "t = 0 s: would diverge: the step of %.6g s%s is longer than the critical %.6g s; set "
            "time.step = auto or to less than that",
            dt, dt < t->step ? " (time.step, shortened to divide output_every)" : "", critical);
    if (!(rows * substeps <= MAX_STEPS))
        die(SW_USAGE, "[time]: %.3g steps are more than can be done", rows * substeps);
    if (c.n_motions == 0 && c.n_disturbances == 0 && c.time.start != START_MODE)
        warn("nothing moves this cable: no [motion], no [disturbance], no start in a mode");
    if (rows < 2)
        warn("time.end comes before the first output_every of %g s: only t = 0 is printed",
             t->output_every);
    note("%.0f steps of %.6g s, critical %.6g s", (rows - 1) * substeps, dt, critical);
    return (struct grid){dt, (long)rows, (long)substeps};
}

/* Modes for the start and the disturbances, if any of them needs one. */
static void get_modes(void)
{
    int wanted = c.time.start == START_MODE ? c.time.start_mode : 0;
    struct why why;
    enum status s;

    for (int i = 0; i < c.n_disturbances; i++)
        if (c.disturbance[i].mode > wanted)
            wanted = c.disturbance[i].mode;
    if (args.common.dir) {
        must(modeldir_read(args.common.dir, &c, &model, &modes, &why), &why);
        if (wanted > modes.k)
            die(SW_USAGE, "%s: holds %d modes; mode %d is wanted", args.common.dir, modes.k,
                wanted);
    } else if (wanted > 0) {
        s = modes_lowest(&model, wanted, SOLVER_AUTO, &modes);
        if (s == SW_ADMISSIBLE)
            die(s, "mode %d is wanted; more than %d elements allow modes up to %d", wanted,
                MODES_MAX_ELEMENTS, modes_lanczos_most(c.elements));
        if (s != SW_OK)
            die(s, "modes: %s", status_text(s));
    }
}

/* shape := mode k (from 1), largest nodal displacement 1 m. */
static void take_mode(int k)
{
    if (modes_unit_shape(&model, &modes, k - 1, shape) != SW_OK)
        die(SW_USAGE, "mode %d has no displacement at the nodes of this mesh; take more elements",
            k);
}

/* shape := equilibrium for the supports where they are at t = 0. */
static void find_equilibrium(void)
{
    double u[6], b[6];
    enum status s;

    motion_sum(c.motion, c.n_motions, 0, u, NULL, NULL);
    axes_to_plane(&model.axes, u, b);
    axes_to_plane(&model.axes, u + 3, b + 3);
    s = model_equilibrium(&model, c.terms, b, shape);
    if (s == SW_ADMISSIBLE)
        die(s, "the supports at t = 0 leave no static line: span %g m, drop %g m",
            hypot(c.bare.span + u[3] - u[0], u[5] - u[2]), c.bare.drop + u[4] - u[1]);
    if (s == SW_NOMEM)
        die(s, "equilibrium at t = 0: %s", status_text(s));
    if (s != SW_OK)
        die(s, "no equilibrium was found for the supports at t = 0; is the cable slack there?  "
               "time.start = rest with a ramp does without it");
}

static void start_march(void)
{
    enum status s;

    if (c.time.start != START_REST)
        find_equilibrium();
    s = march_start(&march, shape);
    if (s == SW_OK && c.time.start == START_MODE) {
        take_mode(c.time.start_mode);
        march_kick(&march, KICK_DISPLACEMENT, c.time.start_amplitude, shape);
        memcpy(shape, march.V, sizeof *shape * model_unknowns(&model));
        s = march_start(&march, shape); /* again: its first increment is that of this deflection */
    }
    if (s != SW_OK)
        die(s, "start: %s", status_text(s));
}

static struct grid set_up(void)
{
    struct march_options how;
    struct grid grid;
    enum status s = case_model(&c, &model);

    if (s != SW_OK)
        die(s, "model: %s", status_text(s));
    grid = lay_grid();
    get_modes();
    how = (struct march_options){.alpha = c.alpha,
                                 .beta = c.beta,
                                 .dt = grid.dt,
                                 .terms = c.terms,
                                 .motion = c.motion,
                                 .n_motions = c.n_motions,
                                 .damper = c.damper,
                                 .n_dampers = c.n_dampers};
    s = march_new(&model, &how, &march);
    shape = model_vector(&model);
    if (s == SW_OK && !shape)
        s = SW_NOMEM;
    if (s != SW_OK)
        die(s, "time integration: %s", status_text(s));
    start_march();
    return grid;
}

static void disturb(const struct disturbance *d)
{
    double v[3];

    if (d->mode > 0) {
        take_mode(d->mode);
        march_kick(&march, (enum kick)d->kind, d->amplitude[0], shape);
        return;
    }
    memset(shape, 0, sizeof *shape * model_unknowns(&model));
    axes_to_plane(&model.axes, d->amplitude, v);
    for (int axis = 0; axis < 3; axis++)
        shape[6 * d->node + 2 * axis] = v[axis];
    march_kick(&march, (enum kick)d->kind, 1, shape);
}

static void print_header(struct out *o)
{
    fputs("time_s", o->f);
    for (int p = 1; p <= c.time.n_probes; p++)
        fprintf(o->f, ",v1_%d_m,v2_%d_m,v3_%d_m,tension_%d_N", p, p, p, p);
    fputs(",force_left_1_N,force_left_2_N,force_left_3_N,force_right_1_N,force_right_2_N,"
          "force_right_3_N\n",
          o->f);
}

static void print_row(double time, struct out *o)
{
    double row[1 + 4 * MAX_PROBES + 6] = {time}, *to = row + 1;

    for (int p = 0; p < c.time.n_probes; p++, to += 4)
        model_probe(&model, c.time.probe[p], march.V, to, to + 3);
    march_support_force(&march, to);
    out_row(o, row, 1 + 4 * c.time.n_probes + 6);
}

static void report_slack(void)
{
    if (march.slack_time >= 0)
        warn("slack: the cable would carry compression, first at t = %.6g s, theta = %.6g m; it "
             "cannot, so that what follows is not to be trusted",
             march.slack_time, march.slack_theta);
}

__attribute__((noreturn)) static void report_divergence(void)
{
    double stable = march_critical_step(&model);

    report_slack();
    if (!isfinite(march.stiffened))
        die(SW_DIVERGED,
            "t = %.9g s: diverged with a step of %.6g s: numbers are no longer finite; look at the "
            "amplitudes, or set a smaller time.step",
            march_time(&march), march.options.dt);
    die(SW_DIVERGED,
        "t = %.9g s: diverged: the cable is stretched so far that it allows a step of %.6g s only, "
        "not %.6g s; look at the amplitudes%s, or set a smaller time.step",
        march_time(&march), stable / sqrt(1 + march.stiffened), march.options.dt,
        c.terms < 3 ? " (terms = 1 and 2 lack the part that bounds them)" : "");
}

/* Disturbances act at the first step at or after their time. */
static void run(const struct grid *grid, struct out *o)
{
    long steps = (grid->rows - 1) * grid->substeps;

    print_header(o);
    for (long k = 0; k <= steps && !signals_pending() && !out_failed(o); k++) {
        for (int i = 0; i < c.n_disturbances; i++)
            if ((double)k == ceil(c.disturbance[i].time / grid->dt * (1 - 1e-12)))
                disturb(&c.disturbance[i]);
        if (march_solve(&march) != SW_OK)
            report_divergence();
        if (k % grid->substeps == 0) {
            print_row((double)(k / grid->substeps) * c.time.output_every, o);
            progress((double)k / (double)(steps > 0 ? steps : 1), "diffverf");
        }
        march_advance(&march);
    }
    progress_end();
    for (int i = 0; i < c.n_disturbances; i++)
        if (c.disturbance[i].time > c.time.end)
            warn("[%s] comes after time.end: it never acted", c.disturbance_label[i]);
    report_slack();
}

int main(int argc, char **argv)
{
    struct grid grid;
    struct out o;
    struct why why;

    start_case(&tool, &args.common, argc, argv, &c);
    if (isnan(c.time.end))
        die(SW_USAGE, "%s: [time] end: is missing", argv[argc - 1]);
    grid = set_up();
    must(out_open(&o, args.common.out, &why), &why);
    signals_defer();
    run(&grid, &o);
    if (signals_pending())
        signals_end(&o);
    must(out_close(&o, &why), &why);
    free(shape);
    march_free(&march);
    modes_free(&modes);
    model_free(&model);
    case_free(&c);
    return 0;
}
