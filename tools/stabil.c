/* stabil: maps of parametric resonance of one cable whose supports move. */
#include "form/modeldir.h"
#include "form/rowsfile.h"
#include "form/start.h"
#include "phys/answers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CHUNK 64 /* frequencies between two looks at signals */

static struct {
    struct opt_common common;
    int growth, trace, change, answers, resume;
    long threads;
} args = {.threads = 1};

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR",
     "take the modes from the model directory of modal", 0, 0},
    {"growth", 0, OPT_FLAG, &args.growth, NULL, "floquet: add growth rate, crossing and modes", 0,
     0},
    {"trace", 0, OPT_FLAG, &args.trace, NULL, "floquet: curves of the boundaries, not the grid", 0,
     0},
    {"change", 0, OPT_FLAG, &args.change, NULL,
     "bolotin: add how much the last two harmonics change", 0, 0},
    {"answers", 0, OPT_FLAG, &args.answers, NULL,
     "bolotin: smallest amplitude of each region, and damping that is enough", 0, 0},
    {"resume", 0, OPT_FLAG, &args.resume, NULL, "go on where -o FILE was stopped", 0, 0},
    {"threads", 0, OPT_INTEGER, &args.threads, "N", "work on N frequencies at once", 1, 1024},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {
    "stabil", "CASE", "Maps of parametric resonance of one cable whose supports move.", options,
    case_name_keys};

/* What the run works on. */
static struct cable_case c;
static struct model model;
static struct modes modes;
static struct map map;
static struct rows_file file;

static int is_floquet(void)
{
    return c.stability.method == METHOD_FLOQUET;
}

static void get_modes(void)
{
    int wanted = c.stability.reference;
    struct why why;
    enum status s;

    for (int i = 0; i < c.stability.n_modes; i++)
        if (c.stability.mode[i] + 1 > wanted)
            wanted = c.stability.mode[i] + 1;
    if (args.common.dir) {
        must(modeldir_read(args.common.dir, &c, &model, &modes, &why), &why);
        if (wanted > modes.k)
            die(SW_USAGE, "%s: holds %d modes; mode %d is wanted", args.common.dir, modes.k,
                wanted);
        return;
    }
    s = modes_lowest(&model, wanted, SOLVER_AUTO, &modes);
    if (s != SW_OK)
        die(s, "modes: %s", status_text(s));
}

/* Motion of the supports of unit amplitude: the sections together, over the length of the first. */
static void take_motion(void)
{
    const double *first = c.motion[0].amplitude;
    double size = sqrt(first[0] * first[0] + first[1] * first[1] + first[2] * first[2]);

    for (int i = 0; i < c.n_motions; i++)
        if (c.motion_section[i].file[0] != '\0')
            die(SW_USAGE, "[%s] file: a map needs harmonic motions", c.motion_label[i]);
    if (!(size > 0))
        die(SW_USAGE, "[%s] amplitude: a direction is needed", c.motion_label[0]);
    for (int i = 0; i < c.n_motions; i++) {
        const struct motion *m = &c.motion[i];
        int at = m->support == SUPPORT_LEFT ? 0 : 3;
        double re[3], im[3], plane_re[3], plane_im[3];

        for (int k = 0; k < 3; k++) {
            re[k] = m->amplitude[k] * cos(m->phase[k]) / size;
            im[k] = m->amplitude[k] * sin(m->phase[k]) / size;
        }
        axes_to_plane(&model.axes, re, plane_re);
        axes_to_plane(&model.axes, im, plane_im);
        for (int k = 0; k < 3; k++)
            map.b[at + k] += plane_re[k] + I * plane_im[k];
    }
}

/* A harmonic force of unit amplitude in place of a motion. */
static void take_force(void)
{
    struct force f = c.force[0];
    struct forcing forcing = {&f, 1, {.cd = 0}};
    double size = sqrt(f.value[0] * f.value[0] + f.value[1] * f.value[1] + f.value[2] * f.value[2]);
    double *rest = model_vector(&model);

    if (c.n_forces > 1)
        die(SW_USAGE, "a map takes one [force]; the case has %d", c.n_forces);
    if (c.force_section[0].file[0] != '\0' || !(size > 0))
        die(SW_USAGE, "[%s]: a map needs value, a direction", c.force_label[0]);
    map.R = model_vector(&model);
    if (!map.R || !rest)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    for (int k = 0; k < 3; k++)
        f.value[k] /= -size; /* what is subtracted from zero */
    f.omega = NAN;
    forcing_subtract(&model, &forcing, 0, rest, NULL, map.R);
    free(rest);
}

static void set_up(void)
{
    const struct stability *p = &c.stability;
    enum status s = case_model(&c, &model);

    if (s != SW_OK)
        die(s, "model: %s", status_text(s));
    if (c.n_motions == 0 && c.n_forces == 0)
        die(SW_USAGE, "nothing excites this cable: a [motion] or a [force] is needed");
    if (c.n_dampers > 0)
        warn("[%s] is not taken in: the map is that of the cable without it", c.damper_label[0]);
    if (c.wind.cd > 0)
        warn("[wind] is not taken in: the map is that of the cable without it");
    if (c.n_motions > 0 && c.n_forces > 0)
        die(SW_USAGE, "either [motion] or [force] can be what the map's amplitude means");
    get_modes();
    s = map_new(&model, &modes, p->mode, p->n_modes, p->undamped ? 0 : c.alpha,
                p->undamped ? 0 : c.beta, &map);
    if (s != SW_OK)
        die(s, "map: %s", status_text(s));
    map.alpha = c.alpha;
    map.beta = c.beta;
    map.reference = modes.omega[p->reference - 1];
    map.theory = (enum theory)p->theory;
    map.quadratic = p->quadratic;
    if (c.n_motions > 0)
        take_motion();
    else
        take_force();
}

static struct map_task task(void)
{
    const struct stability *p = &c.stability;

    return (struct map_task){.floquet = is_floquet(),
                             .trace = args.trace,
                             .harmonics = p->harmonics,
                             .change = args.change,
                             .from = p->amplitude_start,
                             .to = p->amplitude_end,
                             .step = p->amplitude_step};
}

static const char *amplitude_name(void)
{
    return c.n_motions > 0 ? "amplitude_m" : "amplitude_N";
}

static void print_header(struct out *o)
{
    fprintf(o->f, "ratio,omega_rad_s,%s,", amplitude_name());
    if (!is_floquet())
        fputs(args.change ? "period,mode,partner,order,share,change\n"
                          : "period,mode,partner,order,share\n",
              o->f);
    else if (args.growth || args.trace)
        fputs("multiplier,growth_1_s,crossing,mode,partner\n", o->f);
    else
        fputs("multiplier\n", o->f);
}

/* A mode's number for users; nothing for none. */
static void print_mode(int mode, struct out *o)
{
    putc(',', o->f);
    if (mode >= 0)
        fprintf(o->f, "%d", c.stability.mode[mode] + 1);
}

static void print_row(const struct map_row *r, struct out *o)
{
    static const char *const crossing[] = {"T", "2T", "combination"};

    out_number(o, r->ratio);
    putc(',', o->f);
    out_number(o, r->Omega);
    putc(',', o->f);
    out_number(o, r->amplitude);
    putc(',', o->f);
    if (!is_floquet()) {
        fputs(r->period == 1 ? "T" : "2T", o->f);
        print_mode(r->boundary.mode, o);
        print_mode(r->boundary.partner, o);
        fprintf(o->f, ",%d,", r->boundary.order);
        out_number(o, r->boundary.share);
        if (args.change)
            putc(',', o->f);
        if (args.change && !isnan(r->boundary.change))
            out_number(o, r->boundary.change);
    } else {
        out_number(o, r->floquet.modulus);
    }
    if (is_floquet() && (args.growth || args.trace)) {
        putc(',', o->f);
        out_number(o, r->floquet.growth);
        fprintf(o->f, ",%s", crossing[r->floquet.crossing]);
        print_mode(r->floquet.mode, o);
        print_mode(r->floquet.partner, o);
    }
    putc('\n', o->f);
}

/* Ratio i of the map. */
static double ratio_at(long i)
{
    return c.stability.ratio_start + (double)i * c.stability.ratio_step;
}

static long ratios(void)
{
    const struct stability *p = &c.stability;
    double count = floor((p->ratio_end - p->ratio_start) / p->ratio_step * (1 + 1e-12)) + 1;

    if (!(count <= 1e7))
        die(SW_USAGE, "[stability]: %.3g frequencies are more than can be done", count);
    return (long)count;
}

static void run_map(void)
{
    const struct map_task t = task();
    long all = ratios();
    struct why why;

    while (file.next < all && !out_failed(&file.out) && !signals_pending()) {
        int count = (int)fmin(CHUNK, (double)(all - file.next));
        double ratio[CHUNK];
        struct map_rows rows[CHUNK];

        for (int i = 0; i < count; i++)
            ratio[i] = ratio_at(file.next + i);
        map_rows(&map, &t, ratio, count, (int)args.threads, rows);
        for (int i = 0; i < count; i++) {
            if (rows[i].status == SW_INDEFINITE)
                warn("ratio %.9g: an undamped resonance of the ground motion: no row", ratio[i]);
            else if (rows[i].status != SW_OK)
                die(rows[i].status, "ratio %.9g: %s", ratio[i], status_text(rows[i].status));
            for (int k = 0; k < rows[i].n; k++)
                print_row(&rows[i].row[k], &file.out);
            map_rows_free(&rows[i]);
        }
        file.next += count;
        must(rows_file_checkpoint(&file, &why), &why);
        progress((double)file.next / (double)all, "stabil");
    }
    progress_end();
}

static void run_answers(struct out *o)
{
    const struct map_task t = task();
    struct map_answer answer[MAP_MOST_REGIONS];
    int n;
    enum status s = map_answers(&map, &t, ratio_at(0), c.stability.ratio_step, ratios(),
                                (int)args.threads, answer, &n);

    if (s != SW_OK)
        die(s, "answers: %s", status_text(s));
    fprintf(o->f,
            "period,mode,order,ratio,omega_rad_s,%s,damping_ratio,safe_factor,safe_damping_ratio\n",
            amplitude_name());
    for (int i = 0; i < n; i++) {
        const struct map_answer *a = &answer[i];
        double w = modes.omega[c.stability.mode[a->row.boundary.mode]];
        double zeta = c.alpha / (2 * w) + c.beta * w / 2;

        fputs(a->row.period == 1 ? "T" : "2T", o->f);
        print_mode(a->row.boundary.mode, o);
        fprintf(o->f, ",%d,", a->row.boundary.order);
        out_number(o, a->row.ratio);
        putc(',', o->f);
        out_number(o, a->row.Omega);
        putc(',', o->f);
        out_number(o, a->row.amplitude);
        putc(',', o->f);
        out_number(o, zeta);
        putc(',', o->f);
        if (!isnan(a->factor)) {
            out_number(o, a->factor);
            putc(',', o->f);
            out_number(o, a->factor * zeta);
        } else {
            putc(',', o->f);
        }
        putc('\n', o->f);
    }
}

static void judge_options(void)
{
    if ((args.growth || args.trace) && !is_floquet())
        die(SW_USAGE, "--growth and --trace belong to stability.method = floquet");
    if ((args.answers || args.change) && is_floquet())
        die(SW_USAGE, "--answers and --change belong to stability.method = bolotin");
    if (args.answers && args.resume)
        die(SW_USAGE, "--answers has nothing to go on from");
}

int main(int argc, char **argv)
{
    struct why why;

    start_case(&tool, &args.common, argc, argv, &c);
    judge_options();
    set_up();
    file = (struct rows_file){.kind = ROWS_MAP,
                              .c = &c,
                              .path = args.common.out,
                              .columns = args.trace    ? "trace"
                                         : args.growth ? "growth"
                                                       : "",
                              .resume = args.resume,
                              .checkpoint = 60};
    must(rows_file_open(&file, &why), &why);
    if (args.answers) {
        run_answers(&file.out);
    } else {
        if (!args.resume)
            print_header(&file.out);
        signals_defer();
        run_map();
    }
    if (signals_pending()) {
        must(rows_file_stop(&file, &why), &why);
        if (file.state)
            warn("stopped; --resume goes on from %s", file.state);
        signals_end(&file.out);
    }
    must(rows_file_close(&file, &why), &why);
    map_free(&map);
    modes_free(&modes);
    model_free(&model);
    opt_list_free(&args.common.sets);
    case_free(&c);
    return 0;
}
