/* diffverf: nonlinear vibration of one cable under moving supports. */
#include "form/curve.h"
#include "form/ensemble.h"
#include "form/rowsfile.h"
#include "form/run.h"
#include "form/start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define CHECKPOINT 60 /* seconds of wall time between states, unless an option says else */

static struct {
    struct opt_common common;
    const char *state, *field, *points;
    int resume, energy, steady;
    long checkpoint, threads;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR",
     "take the modes from the model directory of modal", 0, 0},
    {"energy", 0, OPT_FLAG, &args.energy, NULL, "add the energy balance", 0, 0},
    {"field", 0, OPT_TEXT, &args.field, "FILE", "write the displacements of all nodes, .npy", 0, 0},
    {"steady", 0, OPT_FLAG, &args.steady, NULL, "look for the steady state: one row", 0, 0},
    {"points", 0, OPT_TEXT, &args.points, "FILE",
     "steady states of the variations in FILE, a row each", 0, 0},
    {"threads", 0, OPT_INTEGER, &args.threads, "N", "--points: on N cores (default: all)", 1, 1024},
    {"state", 0, OPT_TEXT, &args.state, "FILE", "keep the state there, also at the end", 0, 0},
    {"checkpoint", 0, OPT_INTEGER, &args.checkpoint, "SECONDS",
     "save the state so often (default 60)", 1, 1000000},
    {"resume", 0, OPT_FLAG, &args.resume, NULL, "go on from the state", 0, 0},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {"diffverf", "CASE",
                                     "Nonlinear vibration of one cable under moving supports.",
                                     options, case_name_keys};

/* What the run works on. */
static struct cable_case c;
static struct model model;
static struct modes modes;
static struct launch launch;
static struct march *const march = &launch.march;
static struct energy energy;
static struct curve curve; /* of a sweep */
static struct run files;

static long seconds(void)
{
    return args.checkpoint > 0 ? args.checkpoint : CHECKPOINT;
}

static void make_model(int modes_wanted)
{
    struct why why;
    enum status s = case_model(&c, &model);

    if (s != SW_OK)
        die(s, "model: %s", status_text(s));
    must(launch_modes(&c, args.common.dir, &model, modes_wanted, &modes, &why), &why);
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
        model_probe(&model, c.time.probe[p], march->V, to, to + 3);
    march_support_force(march, to);
    to += 6;
    if (args.energy) {
        const double balance[] = {e->kinetic,      e->strain,     e->supports,    e->loads,
                                  e->disturbances, e->dissipated, energy_error(e)};

        memcpy(to, balance, sizeof balance);
        to += sizeof balance / sizeof *balance;
    }
    out_row(o, row, (int)(to - row));
    files.mark.rows++;
}

/* Rows of a run, and how many of them lie between two fields. */
static struct {
    long rows, field_rows;
} plan;

static void lay_plan(void)
{
    const struct time_plan *t = &c.time;
    double end = case_sweeps(&c) ? fmin(t->end, c.sweep.sweep.duration) : t->end;

    plan.rows = (long)fmin(floor(end / t->output_every * (1 + 1e-12)) + 1, 1e15);
    plan.field_rows =
        isnan(t->field_every) ? 1 : (long)fmax(1, round(t->field_every / t->output_every));
}

static void warn_of_plan(void)
{
    if (c.n_motions == 0 && c.n_disturbances == 0 && c.n_forces == 0 && !(c.wind.cd > 0) &&
        c.time.start != START_MODE && c.time.start != START_STATE)
        warn("nothing moves this cable: no [motion], [disturbance], [force] or [wind], no start in "
             "a mode");
    if (case_sweeps(&c) && c.time.end < c.sweep.sweep.duration * (1 - 1e-9))
        warn("time.end = %.9g s comes before the end of the sweep at %.9g s", c.time.end,
             c.sweep.sweep.duration);
    if (plan.rows < 2)
        warn("time.end comes before the first output_every of %g s: only t = 0 is printed",
             c.time.output_every);
    if (march->options.substeps > 0)
        note("%.0f steps of %.6g s, critical %.6g s",
             (double)(plan.rows - 1) * (double)march->options.substeps, march->options.dt,
             march_critical_step(&model));
}

/* How many steps the automatic step of the implicit scheme has taken. */
static void note_steps(void)
{
    if (march->alpha && march->step > 0)
        note("%ld steps, %.6g s on average", march->step, march_time(march) / (double)march->step);
}

/* Whether the march is behind its last row. */
static int is_over(void)
{
    return march_mark(march) >= plan.rows ||
           (march_mark(march) == plan.rows - 1 && !march_at_mark(march));
}

static void report_slack(void)
{
    if (march->slack_time >= 0)
        warn("slack: the cable would carry compression, first at t = %.6g s, theta = %.6g m; it "
             "cannot, so that what follows is not to be trusted",
             march->slack_time, march->slack_theta);
}

static void expect(enum status s)
{
    struct why why;

    if (s == SW_OK)
        return;
    report_slack();
    launch_fail(&launch, s, &why);
    must(s, &why);
}

/* Disturbances act at the first step at or after their time. */
static void disturb(void)
{
    for (int i = 0; i < c.n_disturbances; i++)
        if (launch_disturbance_due(&launch, &c.disturbance[i])) {
            double before = args.energy ? energy_now(march) : 0;

            launch_disturb(&launch, &c.disturbance[i]);
            if (args.energy && energy.started)
                energy.disturbances += energy_now(march) - before;
        }
}

/* The march is at a mark: its row, field, progress. */
static void print_mark(void)
{
    long row = march_mark(march);

    if (case_sweeps(&c))
        files.mark.rows += curve_mark(&curve, march, &files.rows);
    else
        print_row((double)row * c.time.output_every, &files.rows);
    if (args.field && row % plan.field_rows == 0)
        run_field(&files);
    progress((double)row / (double)(plan.rows > 1 ? plan.rows - 1 : 1), "diffverf");
}

static void run(void)
{
    struct why why;

    while (!is_over() && !run_failed(&files)) {
        if (march_at_mark(march))
            must(run_checkpoint(&files, &why), &why);
        if (signals_pending())
            return;
        disturb();
        expect(march_solve(march));
        if (args.energy)
            energy_step(&energy, march, launch.shape);
        if (march_at_mark(march))
            print_mark();
        expect(march_advance(march));
    }
    if (case_sweeps(&c) && c.time.end >= c.sweep.sweep.duration)
        curve_end(&curve, &files.rows);
    progress_end();
    for (int i = 0; i < c.n_disturbances; i++)
        if (c.disturbance[i].time > c.time.end)
            warn("[%s] comes after time.end: it never acted", c.disturbance_label[i]);
    note_steps();
    report_slack();
}

/* The end by a signal: a state and complete rows, if there is a state. */
__attribute__((noreturn)) static void end_by_signal(void)
{
    struct why why;

    progress_end();
    must(run_stop(&files, &why), &why);
    if (files.state)
        warn("stopped at t = %.9g s; --resume goes on from %s", march_time(march), files.state);
    signals_end(&files.rows);
}

/* Files of the run; the march is put where the state says. */
static void open_files(void)
{
    struct why why;

    files = (struct run){.c = &c,
                         .march = march,
                         .energy = &energy,
                         .rows_path = args.common.out,
                         .field_path = args.field,
                         .state_given = args.state,
                         .columns = args.energy ? "energy" : "",
                         .resume = args.resume,
                         .mark = {.more = curve.more, .n_more = curve.n_more},
                         .checkpoint = seconds()};
    must(run_prepare(&files, &why), &why);
    must(run_open(&files, (size_t)((plan.rows - 1) / plan.field_rows + 1), &why), &why);
    if (args.resume)
        return;
    if (case_sweeps(&c))
        curve_header(&curve, &files.rows);
    else
        print_header(&files.rows);
}

/* The motion itself, or the response curve of a sweep. */
static void follow(const char *path)
{
    struct why why;

    lay_plan();
    make_model(launch_modes_wanted(&c));
    must(launch_new(&c, &model, &modes, c.time.output_every, c.time.end, &launch, &why), &why);
    warn_of_plan();
    if (!args.resume)
        must(launch_start(&launch, path, &why), &why);
    if (case_sweeps(&c))
        must(curve_new(&c, &model, &curve, &why), &why);
    open_files();
    signals_defer();
    run();
    if (signals_pending() && !is_over())
        end_by_signal();
    must(run_close(&files, &why), &why);
    curve_free(&curve);
}

static int show_progress(double share)
{
    progress(share, "diffverf");
    return 0;
}

/* One steady state. */
static void find_steady(const char *path)
{
    struct drive drive;
    struct response response;
    struct out o;
    struct why why;

    make_model(launch_modes_wanted(&c));
    must(drive_of(&c, &model, &drive, &why), &why);
    must(launch_new(&c, &model, &modes, drive_interval(&drive), response_end(&c, &drive), &launch,
                    &why),
         &why);
    must(launch_start(&launch, path, &why), &why);
    must(out_open(&o, args.common.out, &why), &why);
    must(response_find(&launch, &drive, show_progress, &response, &why), &why);
    progress_end();
    if (response.kind == STEADY_NONE)
        warn("no steady state until t = %.6g s", response.time);
    note_steps();
    report_slack();
    response_header(c.time.n_probes, &o);
    putc('\n', o.f);
    response_print(&response, &drive, c.time.n_probes, &o);
    putc('\n', o.f);
    must(out_close(&o, &why), &why);
}

/* Steady states of many points. */
static struct points points;
static struct rows_file table;

static int deliver(int i, const struct outcome *p)
{
    struct why why;

    points_print(&points, i, &table.out);
    putc(',', table.out.f);
    if (p->status == SW_OK) {
        response_print(&p->response, &p->drive, c.time.n_probes, &table.out);
    } else {
        report(&p->why);
        response_print_none(c.time.n_probes, &table.out);
        table.failed = 1;
    }
    putc('\n', table.out.f);
    table.next = i + 1;
    must(rows_file_checkpoint(&table, &why), &why);
    progress((double)(i + 1) / points.n, "diffverf");
    return out_failed(&table.out);
}

static void run_points(const char *path)
{
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    struct ensemble e = {.points = &points, .model = &model, .modes = &modes, .deliver = deliver};
    char input[64];
    int wanted;
    struct why why;

    must(points_read(args.points, path, &args.common.sets, &points, &why), &why);
    must(ensemble_modes_wanted(&points, &wanted, &why), &why);
    make_model(wanted);
    snprintf(input, sizeof input, "points %lx", points_checksum(&points));
    table = (struct rows_file){.kind = ROWS_ENSEMBLE,
                               .c = &c,
                               .path = args.common.out,
                               .columns = input,
                               .resume = args.resume,
                               .checkpoint = seconds()};
    must(rows_file_open(&table, &why), &why);
    if (!args.resume) {
        points_header(&points, &table.out);
        putc(',', table.out.f);
        response_header(c.time.n_probes, &table.out);
        putc('\n', table.out.f);
    }
    signals_defer();
    e.threads = (int)(args.threads > 0 ? args.threads : cores > 0 ? cores : 1);
    e.first = (int)table.next;
    must(ensemble_run(&e, &why), &why);
    progress_end();
    if (signals_pending() && table.next < points.n) {
        must(rows_file_stop(&table, &why), &why);
        if (table.state)
            warn("stopped; --resume goes on from %s", table.state);
        signals_end(&table.out);
    }
    must(rows_file_close(&table, &why), &why);
    points_free(&points);
}

static void judge_options(void)
{
    int study = args.steady || args.points;

    if (args.steady && args.points)
        die(SW_USAGE, "--points looks for steady states already; --steady is for one");
    if (study && (args.energy || args.field || args.state))
        die(SW_USAGE, "--energy, --field and --state belong to a motion that is printed");
    if (args.steady && (args.resume || args.checkpoint > 0))
        die(SW_USAGE, "--steady keeps no state: no --resume, no --checkpoint");
    if (args.threads > 0 && !args.points)
        die(SW_USAGE, "--threads belongs to --points");
    if (study && case_sweeps(&c))
        die(SW_USAGE, "a [sweep] has no steady state; remove it for --steady and --points");
    if (args.energy && case_sweeps(&c))
        die(SW_USAGE, "--energy belongs to a motion that is printed; a [sweep] prints orbits");
    if (args.energy && c.terms == 1)
        die(SW_USAGE, "option --energy: terms = 1 has no potential; take 0, 2 or 3");
}

int main(int argc, char **argv)
{
    int operand = start_options(&tool, &args.common, argc, argv);
    const char *path;
    struct why why;

    start_load(&tool, &args.common, operand, argc, argv, &c);
    path = argv[operand];
    judge_options();
    if (isnan(c.time.end) && !args.steady && !args.points)
        die(SW_USAGE, "%s: [time] end: is missing", path);
    must(case_records(&c, path, &why), &why);
    if (args.points)
        run_points(path);
    else if (args.steady)
        find_steady(path);
    else
        follow(path);
    opt_list_free(&args.common.sets);
    launch_free(&launch);
    modes_free(&modes);
    model_free(&model);
    case_free(&c);
    return table.failed;
}
