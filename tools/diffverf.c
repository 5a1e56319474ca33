/* diffverf: nonlinear vibration of one cable under moving supports, by central differences. */
#include "form/modeldir.h"
#include "form/start.h"
#include "form/state.h"
#include "sys/npy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define MAX_STEPS 1e15 /* exact in a double, and longer than anyone waits */

#define CHECKPOINT 60 /* seconds of wall time between checkpoints, unless an option says else */

static struct {
    struct opt_common common;
    const char *state, *field;
    int resume, energy;
    long checkpoint;
} args = {.checkpoint = CHECKPOINT};

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR",
     "take the modes from the model directory of modal", 0, 0},
    {"energy", 0, OPT_FLAG, &args.energy, NULL, "add the energy balance", 0, 0},
    {"field", 0, OPT_TEXT, &args.field, "FILE", "write the displacements of all nodes, .npy", 0, 0},
    {"state", 0, OPT_TEXT, &args.state, "FILE", "keep the state there, also at the end", 0, 0},
    {"checkpoint", 0, OPT_INTEGER, &args.checkpoint, "SECONDS",
     "save the state so often (default 60)", 1, 1000000},
    {"resume", 0, OPT_FLAG, &args.resume, NULL, "go on from the state", 0, 0},
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
static struct energy energy;
static double *shape, *speed; /* work space over all nodes */
static struct out result, field;
static char *state; /* path of the state, or NULL */
static struct progress_mark mark;

/* The time grid: rows of output, steps between them, rows between two fields. */
struct grid {
    double dt;
    long rows, substeps, field_rows;
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
    if (c.n_motions == 0 && c.n_disturbances == 0 && c.n_forces == 0 && !(c.wind.cd > 0) &&
        c.time.start != START_MODE && c.time.start != START_STATE)
        warn("nothing moves this cable: no [motion], [disturbance], [force] or [wind], no start in "
             "a mode");
    if (rows < 2)
        warn("time.end comes before the first output_every of %g s: only t = 0 is printed",
             t->output_every);
    note("%.0f steps of %.6g s, critical %.6g s", (rows - 1) * substeps, dt, critical);
    return (struct grid){dt, (long)rows, (long)substeps,
                         isnan(t->field_every)
                             ? 1
                             : (long)fmax(1, round(t->field_every / t->output_every))};
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

static struct forcing forcing(void)
{
    return (struct forcing){c.force, c.n_forces, c.wind};
}

/* shape := equilibrium for the supports where they are at t = 0, under the forces there. */
static void find_equilibrium(void)
{
    struct forcing outer = forcing();
    double u[6], b[6];
    enum status s;

    motion_sum(c.motion, c.n_motions, 0, u, NULL, NULL);
    axes_to_plane(&model.axes, u, b);
    axes_to_plane(&model.axes, u + 3, b + 3);
    s = forcing_equilibrium(&model, &outer, c.terms, b, shape);
    if (s == SW_ADMISSIBLE)
        die(s, "the supports at t = 0 leave no static line: span %g m, drop %g m",
            hypot(c.bare.span + u[3] - u[0], u[5] - u[2]), c.bare.drop + u[4] - u[1]);
    if (s == SW_NOMEM)
        die(s, "equilibrium at t = 0: %s", status_text(s));
    if (s != SW_OK)
        die(s, "no equilibrium was found for the supports at t = 0; is the cable slack there?  "
               "time.start = rest with a ramp does without it");
}

/* The march at t = 0, by [time] start.  path: of the case. */
static void start_march(const char *path)
{
    char *from = c.time.start == START_STATE ? case_beside(path, c.time.start_text) : NULL;
    struct why why;
    enum status s;

    if (c.time.start == START_STATE && !from)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    if (from && !state_is_there(from))
        die(SW_USAGE,
            "[time] start: '%s' is neither static, rest nor mode K AMPLITUDE, and there is no such "
            "state file",
            c.time.start_text);
    if (from)
        must(state_start(from, &model, shape, speed, &why), &why);
    else if (c.time.start != START_REST)
        find_equilibrium();
    s = march_start(&march, shape, from ? speed : NULL);
    if (s == SW_OK && c.time.start == START_MODE) {
        take_mode(c.time.start_mode);
        march_kick(&march, KICK_DISPLACEMENT, c.time.start_amplitude, shape);
        memcpy(shape, march.V, sizeof *shape * model_unknowns(&model));
        /* again: its first increment is that of this deflection */
        s = march_start(&march, shape, NULL);
    }
    if (s != SW_OK)
        die(s, "start: %s", status_text(s));
    free(from);
}

/* path: of the case. */
static struct grid set_up(const char *path)
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
                                 .n_dampers = c.n_dampers,
                                 .forcing = forcing()};
    s = march_new(&model, &how, &march);
    shape = model_vector(&model);
    speed = model_vector(&model);
    if (s == SW_OK && (!shape || !speed))
        s = SW_NOMEM;
    if (s != SW_OK)
        die(s, "time integration: %s", status_text(s));
    if (!args.resume)
        start_march(path);
    return grid;
}

static void apply(const struct disturbance *d)
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

/* Disturbances act at the first step at or after their time. */
static void disturb(long step, double dt)
{
    for (int i = 0; i < c.n_disturbances; i++)
        if ((double)step == ceil(c.disturbance[i].time / dt * (1 - 1e-12))) {
            double before = args.energy ? energy_now(&march) : 0;

            apply(&c.disturbance[i]);
            if (args.energy && energy.started)
                energy.disturbances += energy_now(&march) - before;
        }
}

static void print_header(struct out *o)
{
    fputs("time_s", o->f);
    for (int p = 1; p <= c.time.n_probes; p++)
        fprintf(o->f, ",v1_%d_m,v2_%d_m,v3_%d_m,tension_%d_N", p, p, p, p);
    fputs(",force_left_1_N,force_left_2_N,force_left_3_N,force_right_1_N,force_right_2_N,"
          "force_right_3_N",
          o->f);
    if (args.energy)
        fputs(",kinetic_J,strain_J,work_supports_J,work_loads_J,work_disturbances_J,dissipated_J,"
              "energy_error_J",
              o->f);
    putc('\n', o->f);
}

static void print_row(double time, struct out *o)
{
    const struct energy *e = &energy;
    double row[1 + 4 * MAX_PROBES + 6 + 7] = {time}, *to = row + 1;

    for (int p = 0; p < c.time.n_probes; p++, to += 4)
        model_probe(&model, c.time.probe[p], march.V, to, to + 3);
    march_support_force(&march, to);
    to += 6;
    if (args.energy) {
        const double balance[] = {e->kinetic,      e->strain,     e->supports,    e->loads,
                                  e->disturbances, e->dissipated, energy_error(e)};

        memcpy(to, balance, sizeof balance);
        to += sizeof balance / sizeof *balance;
    }
    out_row(o, row, (int)(to - row));
    mark.rows++;
}

/* One column of --field: v1, v2, v3 of each node. */
static void print_field(void)
{
    for (int k = 0; k <= model.n; k++) {
        const double *node = march.V + 6 * (size_t)k;
        double v[3];

        axes_to_space(&model.axes, (double[3]){node[0], node[2], node[4]}, v);
        fwrite(v, sizeof *v, 3, field.f);
    }
    out_failed(&field);
    mark.fields++;
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

/* What, beside the case, makes the columns of the result: a state belongs to it. */
static const char *columns(void)
{
    return args.energy ? args.field ? "energy field" : "energy" : args.field ? "field" : "";
}

/* The state as it is before the next step, and the bytes of the result that belong to it. */
static void save_state(void)
{
    struct why why;

    mark.bytes = out_bytes(&result);
    if (args.field)
        out_bytes(&field);
    must(state_write(state, &c, columns(), &march, &energy, &mark, &why), &why);
}

static void save_sometimes(void)
{
    static double last = -1;
    struct timespec t;
    double now;

    clock_gettime(CLOCK_MONOTONIC, &t);
    now = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
    if (last >= 0 && now - last < (double)args.checkpoint)
        return;
    if (last >= 0)
        save_state();
    last = now;
}

static int writing_failed(void)
{
    return out_failed(&result) || (args.field && out_failed(&field));
}

static void run(const struct grid *grid)
{
    long steps = (grid->rows - 1) * grid->substeps;

    for (long k = march.step; k <= steps && !writing_failed(); k = march.step) {
        int row = k % grid->substeps == 0;

        if (row && state)
            save_sometimes();
        if (signals_pending())
            return;
        disturb(k, grid->dt);
        if (march_solve(&march) != SW_OK)
            report_divergence();
        if (args.energy)
            energy_step(&energy, &march, shape);
        if (row) {
            print_row((double)(k / grid->substeps) * c.time.output_every, &result);
            progress((double)k / (double)(steps > 0 ? steps : 1), "diffverf");
        }
        if (row && args.field && k / grid->substeps % grid->field_rows == 0)
            print_field();
        march_advance(&march);
    }
    progress_end();
    for (int i = 0; i < c.n_disturbances; i++)
        if (c.disturbance[i].time > c.time.end)
            warn("[%s] comes after time.end: it never acted", c.disturbance_label[i]);
    report_slack();
}

/* Open the result and the field, new or behind what the state says. */
static void open_results(const struct grid *grid)
{
    const char *path = args.common.out;
    size_t fields = (size_t)((grid->rows - 1) / grid->field_rows + 1);
    size_t height = 3 * ((size_t)model.n + 1);
    long field_bytes = NPY_HEADER_BYTES + mark.fields * (long)(height * sizeof(double));
    struct why why;

    if (args.resume && (mark.bytes >= 0) != (path && strcmp(path, "-") != 0))
        die(SW_USAGE, "%s: the run that was stopped wrote %s: go on in the same way", state,
            mark.bytes >= 0 ? "a file, by -o" : "on standard output");
    if (args.resume && mark.bytes >= 0)
        must(out_resume(&result, path, mark.bytes, &why), &why);
    else
        must(out_open(&result, path, &why), &why);
    if (!args.state && result.slot < 0) { /* -o is a device: nothing to go on from */
        free(state);
        state = NULL;
    }
    if (!args.resume)
        print_header(&result);
    if (!args.field)
        return;
    if (args.resume)
        must(out_resume(&field, args.field, field_bytes, &why), &why);
    else
        must(out_open(&field, args.field, &why), &why);
    if (args.resume)
        rewind(field.f); /* time.end, and so the number of columns, may have changed */
    npy_begin(&field, 2, height, fields);
    if (args.resume)
        fseek(field.f, field_bytes, SEEK_SET);
}

/* The end by a signal: a state and complete rows, if there is a state. */
__attribute__((noreturn)) static void end_by_signal(void)
{
    struct why why;

    progress_end();
    if (state) {
        save_state();
        must(out_keep(&result, &why), &why);
        if (args.field)
            must(out_keep(&field, &why), &why);
        warn("stopped at t = %.9g s; --resume goes on from %s", march_time(&march), state);
    }
    signals_end(&result);
}

static void name_state(void)
{
    struct why why;

    must(state_path(args.state, args.common.out, &state, &why), &why);
    if (args.state && !state)
        die(SW_USAGE, "option --state: a file is expected");
    if (args.resume && !state)
        die(SW_USAGE, "option --resume needs the state: give --state, or -o FILE as in the run "
                      "that was stopped");
}

int main(int argc, char **argv)
{
    struct grid grid;
    struct why why;

    start_case(&tool, &args.common, argc, argv, &c);
    if (isnan(c.time.end))
        die(SW_USAGE, "%s: [time] end: is missing", argv[argc - 1]);
    if (args.energy && c.terms == 1)
        die(SW_USAGE, "option --energy: terms = 1 has no potential; take 0, 2 or 3");
    must(case_records(&c, argv[argc - 1], &why), &why);
    name_state();
    grid = set_up(argv[argc - 1]);
    if (args.resume)
        must(state_resume(state, &c, columns(), &march, &energy, &mark, &why), &why);
    open_results(&grid);
    signals_defer();
    run(&grid);
    if (signals_pending() && march.step <= (grid.rows - 1) * grid.substeps)
        end_by_signal();
    if (args.state)
        save_state();
    must(out_close(&result, &why), &why);
    if (args.field)
        must(out_close(&field, &why), &why);
    if (state && !args.state)
        remove(state);
    free(state);
    free(shape);
    free(speed);
    march_free(&march);
    modes_free(&modes);
    model_free(&model);
    case_free(&c);
    return 0;
}
