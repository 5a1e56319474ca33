/* catenary: static line of one elastic cable, or of each cable of a table. */
#include "form/start.h"
#include "form/table.h"
#include "phys/irvine.h"
#include "phys/modes.h"
#include "sys/npy.h"

#include <math.h>
#include <string.h>

static struct {
    struct opt_common common;
    int summary, table, stiffness;
} args;

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {"summary", 0, OPT_FLAG, &args.summary, NULL,
     "one row of forces, sag, strain, frequencies instead", 0, 0},
    {"table", 0, OPT_FLAG, &args.table, NULL, "a CSV table of cables in, summaries appended out", 0,
     0},
    {"stiffness", 0, OPT_FLAG, &args.stiffness, NULL, "the 3x3 stiffness between the ends instead",
     0, 0},
    OPT_COMMON(&args.common),
};

static const struct opt_tool tool = {
    "catenary", "CASE | --table [FILE]",
    "Static line of one elastic cable under its own weight, ice, wind and temperature.", options,
    case_name_keys};

/* Point of the line in space: place, and tension as a vector towards the right end. */
struct space_point {
    double x[3], t[3];
    double tension;
};

static struct space_point point(const struct cable_case *c, const struct line *s, double theta)
{
    struct space_point ret;
    struct line_point p;

    line_at(s, theta, &p);
    axes_to_space(&c->axes, (double[3]){p.x1, p.x2, 0}, ret.x);
    axes_to_space(&c->axes, (double[3]){s->H, p.V, 0}, ret.t);
    ret.tension = p.tension;
    return ret;
}

/* Angle of the tension t below the horizontal [rad]. */
static double descent(const double t[3])
{
    return atan2(t[1], t[2] == 0 ? t[0] : hypot(t[0], t[2]));
}

static void print_line(const struct cable_case *c, const struct line *s, struct out *o)
{
    fputs("theta_m,x1_m,x2_m,tension_N,slope,angle_rad,x3_m\n", o->f);
    for (int k = 0; k <= c->elements; k++) {
        double theta = s->cable.L0 * ((double)k / c->elements);
        struct space_point p = point(c, s, theta);

        out_row(o,
                (double[]){theta, p.x[0], p.x[1], p.tension, p.t[1] / p.t[0], descent(p.t), p.x[2]},
                7);
    }
}

/* Columns of the summary and what stands in them (what, below). */
#define SUMMARY(X)                                                                                 \
    X(horizontal_force_N, left.t[0])                                                               \
    X(vertical_left_N, left.t[1])                                                                  \
    X(vertical_right_N, -right.t[1])                                                               \
    X(tension_left_N, left.tension)                                                                \
    X(tension_mid_N, mid.tension)                                                                  \
    X(tension_right_N, right.tension)                                                              \
    X(sag_m, find_sag(s, &c->axes, L0 / 2))                                                        \
    X(length_m, line_length(s))                                                                    \
    X(lambda2, line_lambda2(s, s->cable.mu *L0 / chord))                                           \
    X(unstressed_length_m, c->bare.L0)                                                             \
    X(angle_left_rad, descent(left.t))                                                             \
    X(angle_right_rad, descent(right.t))                                                           \
    X(tension_min_N, s->V > 0 && s->V < s->W ? s->H : fmin(left.tension, right.tension))           \
    X(tension_max_N, fmax(left.tension, right.tension))                                            \
    X(sag_max_m, find_sag(s, &c->axes, deepest))                                                   \
    X(sag_normal_m, below * s->cable.span / chord)                                                 \
    X(sag_theta_m, deepest)                                                                        \
    X(sag_x1_m, point(c, s, deepest).x[0])                                                         \
    X(sway_m, below * c->axes.e[1][2])                                                             \
    X(lateral_left_N, left.t[2])                                                                   \
    X(lateral_right_N, -right.t[2])                                                                \
    X(strain_max, fmax(left.tension, right.tension) / s->cable.EA)                                 \
    X(slack_factor, L0 / chord)                                                                    \
    X(frequency_out_Hz, hertz(irvine_lateral(s, 1)))                                               \
    X(frequency_symmetric_Hz, hertz(irvine_symmetric(s, 1)))                                       \
    X(frequency_antisymmetric_Hz, hertz(irvine_antisymmetric(s, 1)))

#define COLUMN(name, value) "," #name
#define EMPTY(name, value) ","
#define VALUE(name, value) value,
static const char *const summary_columns = SUMMARY(COLUMN) "\n";
static const char *const summary_empty = SUMMARY(EMPTY) "\n";

static void print_summary(const struct cable_case *c, const struct line *s, struct out *o)
{
    double L0 = s->cable.L0, chord = line_chord(&s->cable), deepest = line_deepest(s);
    double below = line_below_chord(s, deepest);
    struct space_point left = point(c, s, 0), mid = point(c, s, L0 / 2), right = point(c, s, L0);

    const double row[] = {SUMMARY(VALUE)};

    out_row(o, row, (int)(sizeof row / sizeof *row));
}

/* Stiffness of the right end against the left one in x1, x2, x3, row by row. */
static void print_stiffness(const struct cable_case *c, const struct line *s, struct out *o)
{
    size_t length = args.common.out ? strlen(args.common.out) : 0;
    double plane[9], space[9] = {0};

    line_stiffness(s, plane);
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < 9; j++)
            space[i] += c->axes.e[j / 3][i / 3] * plane[j] * c->axes.e[j % 3][i % 3];
    if (length > 4 && strcmp(args.common.out + length - 4, ".npy") == 0) {
        npy_write(o, 2, 3, 3, space);
        return;
    }
    fputs("x1_N_m,x2_N_m,x3_N_m\n", o->f);
    for (int i = 0; i < 9; i += 3)
        out_row(o, space + i, 3);
}

/* Summaries of all rows that can be used; returns whether that is all rows. */
static int run_table(const char *path, struct out *o)
{
    struct table t;
    struct in in;
    struct why why;
    char place[512];
    int all = 1;

    must(in_open(path, &in, &why), &why);
    must(table_begin(&in, &args.common.sets, &t, &why), &why);
    must(out_open(o, args.common.out, &why), &why);
    table_print(&t, o);
    fputs(summary_columns, o->f);
    while (!out_failed(o)) {
        struct cable_case c;
        struct line line;
        enum status s = table_row(&t, &c, &why);

        if (s == SW_READ || s == SW_NOMEM)
            must(s, &why);
        if (s == SW_OK && !t.csv.cell)
            break;
        table_print(&t, o);
        if (s == SW_OK) {
            s = line_solve(&c.cable, &line);
            if (s != SW_OK)
                csv_fail(&why, &t.csv, "static line: %s", status_text(s));
        }
        if (s == SW_OK) {
            snprintf(place, sizeof place, "%.400s:%d: ", t.csv.name, t.csv.line);
            start_doubt(&c, &line, place);
            putc(',', o->f);
            print_summary(&c, &line, o);
        } else {
            report(&why);
            fputs(summary_empty, o->f);
            all = 0;
        }
    }
    table_end(&t);
    in_close(&in);
    return all;
}

static void run_case(int operand, int argc, char **argv, struct out *o)
{
    static struct cable_case c;
    struct line line;
    struct why why;
    enum status s;

    start_load(&tool, &args.common, operand, argc, argv, &c);
    s = line_solve(&c.cable, &line);
    if (s != SW_OK)
        die(s, "static line: %s", status_text(s));
    note("%d Newton steps", line.steps);
    must(out_open(o, args.common.out, &why), &why);
    if (args.summary) {
        fputs(summary_columns + 1, o->f);
        print_summary(&c, &line, o);
    } else if (args.stiffness) {
        print_stiffness(&c, &line, o);
    } else {
        print_line(&c, &line, o);
    }
    opt_list_free(&args.common.sets);
    case_free(&c);
}

int main(int argc, char **argv)
{
    struct out o;
    struct why why;
    int operand = start_options(&tool, &args.common, argc, argv), all = 1;

    if (args.summary + args.table + args.stiffness > 1)
        die(SW_USAGE, "only one of --summary, --table, --stiffness can be the result");
    if (args.table && args.common.print_case)
        die(SW_USAGE, "--print-case needs a case; a table has none");
    if (args.table && operand < argc - 1)
        opt_usage(&tool);
    if (args.table)
        all = run_table(operand < argc ? argv[operand] : "-", &o);
    else
        run_case(operand, argc, argv, &o);
    must(out_close(&o, &why), &why);
    return all ? 0 : status_exit(SW_INFEASIBLE);
}
