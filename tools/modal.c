/* modal: eigenfrequencies, modes and damping of one cable; writes the model directory. */
#include "form/modeldir.h"
#include "form/start.h"
#include "phys/damper.h"
#include "phys/irvine.h"
#include "phys/shape.h"
#include "sys/number.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MODES_MORE 40 /* that the damped problem takes in beyond those printed */
#define MODES_DAMPED 400
#define MODES_SWEPT 5    /* unless --modes says else */
#define SHAPE_POINTS 200 /* at least so many intervals of a printed shape */
#define MAX_SHAPES 50

static struct {
    struct opt_common common;
    long modes;
    const char *solver, *shapes, *sweep;
    int irvine, participation, damped;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {NULL, 'd', OPT_TEXT, &args.common.dir, "DIR", "write the model directory", 0, 0},
    {"modes", 0, OPT_INTEGER, &args.modes, "K", "only the K lowest modes", 1, INT_MAX},
    {"solver", 0, OPT_TEXT, &args.solver, "auto|dense|lanczos", "dense: all modes at once", 0, 0},
    {"irvine", 0, OPT_FLAG, &args.irvine, NULL, "add the frequencies of Irvine's closed theory", 0,
     0},
    {"participation", 0, OPT_FLAG, &args.participation, NULL,
     "add participation factors for moving supports", 0, 0},
    {"damped", 0, OPT_FLAG, &args.damped, NULL, "add frequency and decay with all damping", 0, 0},
    {"shapes", 0, OPT_TEXT, &args.shapes, "LIST", "the shapes of these modes instead, e.g. 1,2,5",
     0, 0},
    {"damper-sweep", 0, OPT_TEXT, &args.sweep, "FROM,TO,N",
     "damping over N coefficients of the damper instead (5 modes, or --modes)", 0, 0},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {
    "modal", "CASE", "Eigenfrequencies, modes and damping of one cable about its static line.",
    options, case_name_keys};

/* What the run works on. */
static struct cable_case c;
static struct model model;
static struct modes modes;
static struct damper_basis damping;
static int printed; /* modes of the result; the damped problem takes in more */

/* Modes of --shapes, from 1. */
static struct {
    int mode[MAX_SHAPES];
    int n;
} shapes;

/* A sweep over the coefficient of the one damper. */
static struct {
    double from, to; /* [N s/m] */
    int n;
} sweep;

/* Fill shapes from the option: whole numbers with commas between them. */
static void read_shapes(void)
{
    long all = 6L * c.elements, max = args.modes > 0 && args.modes < all ? args.modes : all;
    char copy[400], *rest = copy, *word;

    if (snprintf(copy, sizeof copy, "%s", args.shapes) >= (int)sizeof copy)
        die(SW_USAGE, "option --shapes: the list is too long");
    while ((word = strsep(&rest, ","))) {
        long value;
        const char *reason = integer_read(word, 1, max, &value);

        if (reason)
            die(SW_USAGE, "option --shapes: '%s': %s (expected modes from 1 to %ld)", word, reason,
                max);
        if (shapes.n == MAX_SHAPES)
            die(SW_USAGE, "option --shapes: more than %d modes", MAX_SHAPES);
        for (int i = 0; i < shapes.n; i++)
            if (shapes.mode[i] == value)
                die(SW_USAGE, "option --shapes: mode %ld stands in the list twice", value);
        shapes.mode[shapes.n++] = (int)value;
    }
}

/* Fill sweep from the option. */
static void read_sweep(void)
{
    char copy[200], *word[3], *rest = copy;
    long n = 0;
    int bad = snprintf(copy, sizeof copy, "%s", args.sweep) >= (int)sizeof copy;

    for (int i = 0; i < 3; i++)
        word[i] = strsep(&rest, ",");
    if (bad || !word[2] || rest || number_read(word[0], &sweep.from) ||
        number_read(word[1], &sweep.to) || integer_read(word[2], 2, 100000, &n) ||
        !(sweep.from > 0 && sweep.from < sweep.to && sweep.to <= 1e18))
        die(SW_USAGE,
            "option --damper-sweep: '%s': FROM,TO,N is expected: 0 < FROM < TO in N s/m, and from "
            "2 to 100000 coefficients",
            args.sweep);
    if (c.n_dampers != 1)
        die(SW_USAGE, "option --damper-sweep: the case has %d dampers; one [damper] is expected",
            c.n_dampers);
    sweep.n = (int)n;
}

static enum solver solver(void)
{
    if (!args.solver || strcmp(args.solver, "auto") == 0)
        return SOLVER_AUTO;
    if (strcmp(args.solver, "dense") == 0)
        return SOLVER_DENSE;
    if (strcmp(args.solver, "lanczos") != 0)
        die(SW_USAGE, "option --solver: '%s' is not one of: auto dense lanczos", args.solver);
    return SOLVER_LANCZOS;
}

/* The k lowest modes. */
static void find_modes(int k)
{
    enum solver by = solver();
    enum status s = modes_lowest(&model, k, by, &modes);
    int most = modes_lanczos_most(c.elements) > 0 ? modes_lanczos_most(c.elements) : 0;

    if (s == SW_ADMISSIBLE && by == SOLVER_LANCZOS)
        die(SW_USAGE,
            "option --solver lanczos: %d modes are wanted; it finds up to %d of this mesh", k,
            most);
    if (s == SW_ADMISSIBLE && by == SOLVER_DENSE)
        die(SW_USAGE, "option --solver dense takes up to %d elements; the case has %d",
            MODES_MAX_ELEMENTS, c.elements);
    if (s == SW_ADMISSIBLE)
        die(SW_USAGE,
            "all modes are found at once for up to %d elements: give --modes, for %d elements up "
            "to %d",
            MODES_MAX_ELEMENTS, c.elements, most);
    if (s != SW_OK)
        die(s, "modes of %d elements: %s", c.elements, status_text(s));
    if (modes.counted > 0)
        note("Sturm count: %d modes below %.9g rad/s, all of them found", modes.counted, modes.cut);
}

static void cell(double x, struct out *o)
{
    putc(',', o->f);
    if (!isnan(x))
        out_number(o, x);
}

/* Irvine's frequency for a mode of this plane and kind; seen counts those before it.  NAN: axial
 * modes are not in his theory. */
static double by_irvine(enum part plane, enum mode_kind kind, int seen[3])
{
    if (kind == KIND_AXIAL)
        return NAN;
    if (plane == PART_LATERAL)
        return hertz(irvine_lateral(&model.line, ++seen[0]));
    if (kind == KIND_SYMMETRIC)
        return hertz(irvine_symmetric(&model.line, ++seen[1]));
    return hertz(irvine_antisymmetric(&model.line, ++seen[2]));
}

static void print_header(struct out *o)
{
    fputs("mode,omega_rad_s,frequency_Hz,period_s,plane,kind,symmetry,damping_ratio", o->f);
    if (args.irvine)
        fputs(",irvine_frequency_Hz,irvine_difference", o->f);
    if (args.participation)
        fputs(",participation_left_1,participation_left_2,participation_left_3,"
              "participation_right_1,participation_right_2,participation_right_3",
              o->f);
    if (args.damped)
        fputs(",damped_omega_rad_s,damped_frequency_Hz,decay_1_s,damped_ratio", o->f);
    putc('\n', o->f);
}

static void print_modes(double *V, struct out *o)
{
    static const char *const kind[] = {"symmetric", "antisymmetric", "axial"};
    int seen[3] = {0, 0, 0};

    print_header(o);
    for (int i = 0; i < printed; i++) {
        double w = modes.omega[i], f = hertz(w), theirs, part[6];
        struct character it;

        modes_shape(&model, &modes, i, V);
        shape_character(&model, V, &it);
        shape_participation(&model, V, w, part);
        theirs = by_irvine(modes.plane[i], it.kind, seen);
        fprintf(o->f, "%d", i + 1);
        cell(w, o);
        cell(f, o);
        cell(1 / f, o);
        fprintf(o->f, ",%s,%s", modes.plane[i] == PART_PLANE ? "in" : "out", kind[it.kind]);
        cell(it.symmetry, o);
        cell(c.alpha / (2 * w) + c.beta * w / 2, o);
        if (args.irvine) {
            cell(theirs, o);
            cell((f - theirs) / theirs, o);
        }
        for (int j = 0; args.participation && j < 6; j++)
            cell(part[j], o);
        if (args.damped) {
            cell(damping.swing[i], o);
            cell(hertz(damping.swing[i]), o);
            cell(damping.decay[i], o);
            cell(damper_ratio(&damping, i), o);
        }
        putc('\n', o->f);
    }
}

static void solve_damped(const struct damper *d)
{
    enum status s = damper_solve(&damping, c.alpha, c.beta, d);

    if (s != SW_OK)
        die(s, "complex modes: %s", status_text(s));
}

/* Largest displacement of V at the printed points or, as a mode may move between them only, at the
 * quarters of the elements. */
static double largest(const double *V, int points)
{
    int each = points / c.elements;
    int n = each < 4 ? 4 * points : points;
    double most = 0;

    for (int p = 0; p <= n; p++) {
        double v[3];

        model_probe(&model, (double)p / n, V, v, NULL);
        most = fmax(most, sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    }
    return most;
}

/* Modes as lines of points, the largest displacement of each 1 m. */
static void print_shapes(struct out *o)
{
    int n = shapes.n, points = (SHAPE_POINTS + c.elements - 1) / c.elements * c.elements;
    double *V[MAX_SHAPES], most[MAX_SHAPES], row[1 + 4 * MAX_SHAPES];

    fputs("theta_m", o->f);
    for (int i = 0; i < n; i++) {
        int mode = shapes.mode[i];

        fprintf(o->f, ",v1_%d_m,v2_%d_m,v3_%d_m,tension_%d_N", mode, mode, mode, mode);
        V[i] = model_vector(&model);
        if (!V[i])
            die(SW_NOMEM, "%s", status_text(SW_NOMEM));
        modes_shape(&model, &modes, mode - 1, V[i]);
        most[i] = largest(V[i], points);
    }
    putc('\n', o->f);
    for (int p = 0; p <= points; p++) {
        double *to = row;

        *to++ = model.line.cable.L0 * ((double)p / points);
        for (int i = 0; i < n; i++, to += 4) {
            model_probe_small(&model, (double)p / points, V[i], to, to + 3);
            for (int j = 0; j < 4; j++)
                to[j] /= most[i];
        }
        out_row(o, row, 1 + 4 * n);
    }
    for (int i = 0; i < n; i++)
        free(V[i]);
}

/* Coefficient i of the sweep: equal ratios between them. */
static double coefficient_at(int i)
{
    double ratio = sweep.to / sweep.from;

    return i == sweep.n - 1 ? sweep.to : sweep.from * pow(ratio, (double)i / (sweep.n - 1));
}

static void print_swept(int mode, double coefficient, int best, struct out *o)
{
    fprintf(o->f, "%d", mode + 1);
    cell(coefficient, o);
    cell(damping.swing[mode], o);
    cell(hertz(damping.swing[mode]), o);
    cell(damping.decay[mode], o);
    cell(damper_ratio(&damping, mode), o);
    fprintf(o->f, ",%d\n", best);
}

/* The best coefficient for a mode, number at of the sweep being the best of its own: a row if it
 * lies inside of the sweep. */
static void print_best(int mode, int at, struct out *o)
{
    struct damper d = c.damper[0];
    enum status s;

    if (at == 0 || at == sweep.n - 1) {
        warn("mode %d: the best coefficient lies beyond those of the sweep", mode + 1);
        return;
    }
    s = damper_best(&damping, c.alpha, c.beta, mode, coefficient_at(at - 1), coefficient_at(at + 1),
                    &d);
    if (s != SW_OK)
        die(s, "complex modes: %s", status_text(s));
    solve_damped(&d);
    print_swept(mode, d.coefficient, 1, o);
}

static void print_sweep(struct out *o)
{
    struct damper d = c.damper[0];
    struct {
        double most, least;
        int at;
    } seen[MODES_DAMPED] = {{0}};

    fputs("mode,coefficient_N_s_m,damped_omega_rad_s,damped_frequency_Hz,decay_1_s,damped_ratio,"
          "best\n",
          o->f);
    for (int i = 0; i < sweep.n && !out_failed(o); i++) {
        d.coefficient = coefficient_at(i);
        solve_damped(&d);
        for (int k = 0; k < printed; k++) {
            double ratio = damper_ratio(&damping, k);

            if (i == 0 || ratio > seen[k].most) {
                seen[k].most = ratio;
                seen[k].at = i;
            }
            if (i == 0 || ratio < seen[k].least)
                seen[k].least = ratio;
            print_swept(k, d.coefficient, 0, o);
        }
        progress((double)i / sweep.n, "modal");
    }
    progress_end();
    for (int k = 0; k < printed; k++)
        if (seen[k].most > seen[k].least + 1e-9)
            print_best(k, seen[k].at, o);
}

/* How many modes the result needs if --modes does not say it. */
static int modes_needed(int all)
{
    int most = 1;

    for (int i = 0; i < shapes.n; i++)
        most = shapes.mode[i] > most ? shapes.mode[i] : most;
    if (args.shapes && !args.common.dir) /* a model directory holds all of them */
        return most;
    return args.sweep && all > MODES_SWEPT ? MODES_SWEPT : all;
}

/* How many modes are printed, and how many are found for that. */
static int modes_wanted(void)
{
    int all = 6 * c.elements, damped = args.damped || args.sweep;

    if (args.modes > all)
        die(SW_USAGE, "option --modes: the mesh has only %d modes", all);
    printed = args.modes > 0 ? (int)args.modes : modes_needed(all);
    if (damped && printed > MODES_DAMPED)
        die(SW_USAGE, "damping is computed for up to %d modes at once: give --modes %d or less",
            MODES_DAMPED, MODES_DAMPED);
    return damped && printed + MODES_MORE < all ? printed + MODES_MORE : damped ? all : printed;
}

static void judge_options(void)
{
    if (args.shapes && args.sweep)
        die(SW_USAGE, "only one of --shapes and --damper-sweep can be the result");
    if ((args.shapes || args.sweep) && (args.irvine || args.participation || args.damped))
        die(SW_USAGE, "--irvine, --participation and --damped add to the table of modes, which "
                      "--shapes and --damper-sweep replace");
    if (args.shapes)
        read_shapes();
    if (args.sweep)
        read_sweep();
}

static void find_damping(void)
{
    enum status s = damper_basis_new(&model, &modes, c.damper, c.n_dampers, &damping);

    if (s != SW_OK)
        die(s, "dampers: %s", status_text(s));
}

static void write_directory(void)
{
    struct modes stored = modes;
    struct why why;

    stored.k = printed;
    must(modeldir_make(args.common.dir, &why), &why);
    must(modeldir_write(args.common.dir, &c, &model, &stored, &why), &why);
}

int main(int argc, char **argv)
{
    struct out o;
    struct why why;
    double *V;
    enum status s;

    start_case(&tool, &args.common, argc, argv, &c);
    judge_options();
    s = case_model(&c, &model);
    if (s != SW_OK)
        die(s, "model: %s", status_text(s));
    find_modes(modes_wanted());
    V = model_vector(&model);
    if (!V)
        die(SW_NOMEM, "%s", status_text(SW_NOMEM));
    if (args.damped || args.sweep)
        find_damping();
    if (args.damped)
        solve_damped(c.damper);
    must(out_open(&o, args.common.out, &why), &why);
    if (args.common.dir)
        write_directory();
    if (args.shapes)
        print_shapes(&o);
    else if (args.sweep)
        print_sweep(&o);
    else
        print_modes(V, &o);
    must(out_close(&o, &why), &why);
    free(V);
    damper_basis_free(&damping);
    modes_free(&modes);
    model_free(&model);
    opt_list_free(&args.common.sets);
    case_free(&c);
    return 0;
}
