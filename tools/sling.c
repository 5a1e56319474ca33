/* sling: is this lift stable?  Metacentric heights of arrangements, one a row. */
#include "form/appraise.h"
#include "form/contour.h"
#include "form/lever.h"
#include "form/redundant.h"
#include "form/result.h"
#include "sys/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct {
    struct opt_common common;
    const char *limit, *require, *design, *contour;
    long samples, seed;
    int derivatives, exact, lever;
} args = {.seed = 1};

static const struct opt options[] = {
    OPT_OUT(&args.common),
    {"limit", 0, OPT_TEXT, &args.limit, "H", "metres of height below which a lift is marginal", 0,
     0},
    {"require", 0, OPT_TEXT, &args.require, "stable|marginal|unstable",
     "status 1 if a row has a worse verdict", 0, 0},
    {"exact", 0, OPT_FLAG, &args.exact, NULL,
     "judge by exact statics, too: large tilts, elastic slings, edges, two hooks", 0, 0},
    {"lever", 0, OPT_FLAG, &args.lever, NULL, "table of righting levers and moments over the tilt",
     0, 0},
    {"samples", 0, OPT_INTEGER, &args.samples, "N", "arrangements drawn within the tolerances", 1,
     1000000000},
    {"seed", 0, OPT_INTEGER, &args.seed, "S", "of their random numbers, default 1", 0, 2147483647},
    {"derivatives", 0, OPT_FLAG, &args.derivatives, NULL,
     "of the height by each input, and which matters most", 0, 0},
    {"design", 0, OPT_TEXT, &args.design, "COLUMN=H", "value of the column that gives the height H",
     0, 0},
    {"contour", 0, OPT_TEXT, &args.contour, "COL,COL",
     "table of heights over two inputs; COL=FROM:TO:N", 0, 0},
    {"set", 0, OPT_LIST, &args.common.sets, "COLUMN=VALUE",
     "set a column of every row, or of the one arrangement", 0, 0},
    {"print-case", 0, OPT_FLAG, &args.common.print_case, NULL,
     "print the rows with all that follows, and stop", 0, 0},
    {"quiet", 'q', OPT_FLAG, &args.common.quiet, NULL, "no warnings", 0, 0},
    {"verbose", 'v', OPT_FLAG, &args.common.verbose, NULL, "tell how many rows have which verdict",
     0, 0},
    {NULL, 0, OPT_FLAG, NULL, NULL, NULL, 0, 0},
};

static const struct opt_tool tool = {
    "sling", "[FILE | -]",
    "Is this lift stable?  Metacentric height of each row of a table of arrangements.", options,
    lift_name_columns};

/* What the options ask for. */
struct asked {
    double limit;
    enum verdict require;
    int design; /* number to find, -1: none */
    double wanted;
    struct result_asked result;
    int tolerances; /* whether their columns are printed */
};

static void print_header(const struct lift_table *t, const struct asked *a, struct out *o)
{
    char name[LIFT_NAME];

    lift_print_header(t, o);
    result_header(&a->result, o);
    if (a->tolerances)
        fputs(",h_worst_m", o->f);
    if (args.samples)
        fputs(",p_below,h_mean_m,h_deviation_m", o->f);
    for (int i = 0; i < LIFT_NUMBERS && args.derivatives; i++)
        if (lift_is_input(i) && lift_has(t, i, 0)) {
            lift_name(i, name);
            fprintf(o->f, ",dh_d%s", name);
        }
    if (args.derivatives)
        fputs(",matters_most", o->f);
    if (a->design >= 0) {
        lift_name(a->design, name);
        fprintf(o->f, ",design_%s", name);
    }
    putc('\n', o->f);
}

static void print_derivatives(const struct lift_table *t, const struct lift_given *g,
                              const struct lift *l, struct out *o)
{
    double slopes[LIFT_NUMBERS];
    char name[LIFT_NAME];
    int greatest;

    doubt_slopes(g, l, slopes);
    for (int i = 0; i < LIFT_NUMBERS; i++)
        if (lift_is_input(i) && lift_has(t, i, 0))
            result_cell(o, slopes[i]);
    greatest = doubt_greatest(g, slopes);
    if (greatest >= 0)
        lift_name(greatest, name);
    fprintf(o->f, ",%s", greatest >= 0 ? name : "");
}

/* Why no value was found. */
static void explain_design(const struct asked *a, const struct lift_given *g, struct why *why)
{
    char name[LIFT_NAME], other[REDUNDANT_TEXT];
    int given = !isnan(g->x[a->design]), by = given ? redundant_near(g, a->design) : -1;

    lift_name(a->design, name);
    if (!given)
        fail(why, SW_INFEASIBLE, "--design: %s has no value to begin with", name);
    else if (by < 0)
        fail(why, SW_INFEASIBLE, "--design: no %s near the present one gives %.6g m", name,
             a->wanted);
    else {
        redundant_say(g, by, other);
        fail(why, SW_INFEASIBLE, "--design: other values of %s contradict %s: leave it out", name,
             other);
    }
}

/* One row that can be used; returns whether what was asked for was found. */
static int print_row(struct lift_table *t, const struct asked *a, const struct lift_given *g,
                     const struct lift *l, enum verdict *ret, struct why *why, struct out *o)
{
    struct appraisal p;
    double found = 0;

    lift_warn(t, l);
    appraise(g, l, a->limit, a->result.exact, &p);
    result_row(&p.j, &a->result, p.has_exact ? &p.exact : NULL, o);
    *ret = p.j.verdict;
    if (a->tolerances)
        result_cell(o, p.j.worst);
    if (args.samples) {
        struct doubt d;

        doubt_sample(g, args.samples, args.seed, a->limit, &d);
        result_cells(o, (double[]){d.probability, d.mean, d.deviation}, 3);
    }
    if (args.derivatives)
        print_derivatives(t, g, l, o);
    if (a->design >= 0) {
        found = doubt_design(g, a->design, a->wanted);
        result_cell(o, found / lift_unit(a->design));
    }
    putc('\n', o->f);
    if (isnan(found))
        explain_design(a, g, why);
    if (p.failed)
        *why = p.why;
    return !p.failed && !isnan(found);
}

/* A row that cannot be used: the reason stands in why, numbers are empty. */
static void print_refused(const struct lift_table *t, const struct asked *a, const char *reason,
                          struct out *o)
{
    struct judgement j;

    judge_not(reason, &j);
    result_row(&j, &a->result, NULL, o);
    for (int n = a->tolerances + (args.samples ? 3 : 0) + args.derivatives + (a->design >= 0);
         n > 0; n--)
        putc(',', o->f);
    for (int i = 0; i < LIFT_NUMBERS && args.derivatives; i++)
        if (lift_is_input(i) && lift_has(t, i, 0))
            putc(',', o->f);
    putc('\n', o->f);
}

/* The present row into *o, whose cells were read with s; returns whether it could be used and does
 * not fall short.  Its verdict is counted. */
static int run_row(struct lift_table *t, const struct asked *a, enum status s,
                   const struct lift_given *g, long count[], struct why *why, struct out *o)
{
    enum verdict verdict = VERDICT_NONE;
    struct lift l;
    int found;

    lift_print_row(t, o);
    if (s == SW_OK) {
        s = lift_make(g, &l, why);
        if (s != SW_OK)
            lift_fail(t, why);
    }
    if (s != SW_OK) {
        report(why);
        print_refused(t, a, lift_reason(t, why), o);
        count[VERDICT_NONE]++;
        return 0;
    }
    found = print_row(t, a, g, &l, &verdict, why, o);
    count[verdict]++;
    if (!found) {
        lift_fail(t, why);
        report(why);
        return 0;
    }
    return !args.require || verdict <= a->require;
}

/* The rows resolved; returns whether all could be used. */
static int print_cases(struct lift_table *t, struct out *o)
{
    struct lift_given g;
    struct lift l;
    struct why why;
    int all = 1, end;

    fputs("type,type_1,type_2", o->f);
    for (int i = 0; i < LIFT_NUMBERS; i++) {
        char name[LIFT_NAME];

        lift_name(i, name);
        fprintf(o->f, ",%s", name);
    }
    putc('\n', o->f);
    for (;;) {
        enum status s = lift_row(t, &g, &end, &why);

        if (s == SW_READ || s == SW_NOMEM)
            must(s, &why);
        if (s == SW_OK && end)
            return all;
        if (s == SW_OK && (s = lift_make(&g, &l, &why)) != SW_OK)
            lift_fail(t, &why);
        if (s != SW_OK) {
            report(&why);
            all = 0;
            continue;
        }
        lift_resolve(&l, &g);
        fprintf(o->f, "%s,%s,%s", lift_type_name(g.type[0]), lift_type_name(g.type[1]),
                lift_type_name(g.type[2]));
        for (int i = 0; i < LIFT_NUMBERS; i++)
            result_cell(o, g.x[i] / lift_unit(i));
        putc('\n', o->f);
    }
}

/* All rows; returns whether all could be used and none falls short. */
static int run_table(struct lift_table *t, const struct asked *a, struct out *o)
{
    long count[VERDICT_NONE + 1] = {0};
    struct lift_given g;
    struct why why;
    int all = 1, end;

    print_header(t, a, o);
    while (!out_failed(o)) {
        enum status s = lift_row(t, &g, &end, &why);

        if (s == SW_READ || s == SW_NOMEM)
            must(s, &why);
        if (s == SW_OK && end)
            break;
        all &= run_row(t, a, s, &g, count, &why, o);
    }
    note("%ld stable, %ld marginal, %ld unstable, %ld not judged", count[VERDICT_STABLE],
         count[VERDICT_MARGINAL], count[VERDICT_UNSTABLE], count[VERDICT_NONE]);
    if (args.require && count[0] + count[1] + count[2] + count[VERDICT_NONE] == 0) {
        fail(&why, SW_INFEASIBLE, "%s: has no row that could be %s", t->csv.name, args.require);
        report(&why);
        return 0;
    }
    return all;
}

/* Levers of all rows; returns whether all could be used. */
static int print_levers(struct lift_table *t, struct out *o)
{
    struct lift_given g;
    struct lift l;
    struct why why;
    int all = 1, end;

    lever_header(o);
    for (long row = 1; !out_failed(o); row++) {
        enum status s = lift_row(t, &g, &end, &why);

        if (s == SW_READ || s == SW_NOMEM)
            must(s, &why);
        if (s == SW_OK && end)
            break;
        if (s == SW_OK && ((s = lift_make(&g, &l, &why)) != SW_OK ||
                           (s = lever_row(&l, row, lift_label(t), o, &why)) != SW_OK))
            lift_fail(t, &why);
        if (s != SW_OK) {
            report(&why);
            all = 0;
        }
    }
    return all;
}

/* The first row, which must be the only one. */
static void the_row(struct lift_table *t, struct lift_given *ret, struct why *why)
{
    struct lift_given more;
    int end;

    must(lift_row(t, ret, &end, why), why);
    if (end)
        die(SW_FORMAT, "%s: has no row; one arrangement is expected", t->csv.name);
    must(lift_row(t, &more, &end, why), why);
    if (!end)
        die(SW_USAGE, "%s:%d: a second row; --contour takes one arrangement", t->csv.name,
            t->csv.line);
}

static void read_options(struct asked *a)
{
    const char *equals = args.design ? strchr(args.design, '=') : NULL;
    int tolerance;

    *a = (struct asked){.require = VERDICT_NONE, .design = -1, .result = {.exact = args.exact}};
    if (args.limit && (number_read(args.limit, &a->limit) || !(a->limit >= 0)))
        die(SW_USAGE, "--limit %s: expected a height in metres, not negative", args.limit);
    while (args.require && a->require > VERDICT_STABLE &&
           strcmp(args.require, verdict_name(a->require)) != 0)
        a->require--;
    if (args.require &&
        (strcmp(args.require, verdict_name(a->require)) != 0 || a->require == VERDICT_NONE))
        die(SW_USAGE, "--require %s: expected stable, marginal or unstable", args.require);
    if (equals) {
        char name[LIFT_NAME + 8];

        snprintf(name, sizeof name, "%.*s", (int)(equals - args.design), args.design);
        a->design = lift_column(name, &tolerance);
        if (tolerance || a->design < 0 || !lift_is_input(a->design) ||
            number_read(equals + 1, &a->wanted))
            a->design = -1;
    }
    if (args.design && a->design < 0)
        die(SW_USAGE, "--design %s: expected COLUMN=H, a number of the arrangement and a height",
            args.design);
    if ((args.contour || args.lever) &&
        (args.design || args.samples || args.derivatives || args.require || args.exact ||
         (args.contour && args.lever)))
        die(SW_USAGE, "--%s cannot be combined with other questions",
            args.contour ? "contour" : "lever");
}

/* Whether the arrangement is that of --set alone: no file is named, and its type is set. */
static int is_alone(int n_operands)
{
    for (int i = 0; i < args.common.sets.n; i++)
        if (n_operands == 0 && strncmp(args.common.sets.item[i], "type=", 5) == 0)
            return 1;
    return 0;
}

/* The one arrangement of --set is judged before anything is written: it ends the tool if it is
 * none. */
static void judge_alone(struct lift_table *t)
{
    struct lift_given g;
    struct lift l;
    struct why why;
    int end;
    enum status s = lift_row(t, &g, &end, &why);

    must(s, &why);
    s = lift_make(&g, &l, &why);
    if (s != SW_OK)
        lift_fail(t, &why);
    must(s, &why);
    t->done = 0;
}

int main(int argc, char **argv)
{
    struct lift_table t;
    struct asked asked;
    struct out o;
    struct in in = {.f = NULL};
    struct why why;
    int operand, all = 1, alone;

    out_prepare();
    err_tool(tool.name);
    operand = opt_parse(&tool, argc, argv);
    err_level(args.common.quiet, args.common.verbose);
    if (operand < argc - 1)
        opt_usage(&tool);
    read_options(&asked);
    alone = is_alone(argc - operand);
    if (!alone)
        must(in_open(operand < argc ? argv[operand] : "-", &in, &why), &why);
    must(lift_begin(alone ? NULL : &in, &args.common.sets, &t, &why), &why);
    asked.result.ends = lift_has_ends(&t);
    for (int i = 0; i < LIFT_NUMBERS; i++)
        asked.tolerances |= lift_has(&t, i, 1);
    if (args.samples && !asked.tolerances)
        die(SW_USAGE, "--samples needs tolerances: columns such as z_m_tol");
    if (alone)
        judge_alone(&t);
    if (args.contour) {
        struct lift_given g;
        struct axis a, b;

        the_row(&t, &g, &why);
        must(axes_read(args.contour, &g, &a, &b, &why), &why);
        must(out_open(&o, args.common.out, &why), &why);
        contour_print(&t, &g, &a, &b, asked.limit, &o);
    } else {
        must(out_open(&o, args.common.out, &why), &why);
        all = args.common.print_case ? print_cases(&t, &o)
              : args.lever           ? print_levers(&t, &o)
                                     : run_table(&t, &asked, &o);
    }
    lift_end(&t);
    in_close(&in);
    opt_list_free(&args.common.sets);
    must(out_close(&o, &why), &why);
    return all ? 0 : status_exit(SW_INFEASIBLE);
}
