/* compare: whether two tables hold the same numbers within a tolerance, both CSV or both .npy. */
#include "sys/csv.h"
#include "sys/npy.h"
#include "sys/number.h"
#include "sys/opt.h"
#include "sys/out.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static struct {
    const char *relative, *absolute, *columns;
} args;

static const struct opt options[] = {
    {NULL, 'r', OPT_TEXT, &args.relative, "REL", "tolerance, times the larger number", 0, 0},
    {NULL, 'a', OPT_TEXT, &args.absolute, "ABS", "tolerance, added to that", 0, 0},
    {NULL, 'c', OPT_TEXT, &args.columns, "COLUMN,...", "only these columns of CSV files", 0, 0},
    {NULL, 0, OPT_FLAG, NULL, NULL, NULL, 0, 0},
};

static const struct opt_tool tool = {
    "compare", "FILE FILE",
    "Whether two files, both CSV or both .npy, hold the same numbers: |x - y| <= ABS + REL "
    "max(|x|, |y|).\nStatus 0: they do; 1: they do not, and the worst place is printed; 2: they "
    "cannot be read.",
    options, NULL};

/* The worst place so far: excess is |x - y| over what is allowed, infinite for texts. */
struct worst {
    double relative, absolute;
    double excess;
    char text[512];
};

static double tolerance(const char *name, const char *text)
{
    double x = 0;
    const char *reason = text ? number_read(text, &x) : NULL;

    if (!reason && x < 0)
        reason = "must not be negative";
    if (reason)
        die(SW_USAGE, "option %s: '%s': %s", name, text, reason);
    return x;
}

/* Excess of x against y: at most 1 if they agree.  NaN agrees with nothing. */
static double excess_of(const struct worst *w, double x, double y)
{
    double allowed = w->absolute + w->relative * fmax(fabs(x), fabs(y));

    if (x == y)
        return 0;
    if (!isfinite(x) || !isfinite(y))
        return INFINITY;
    return allowed > 0 ? fabs(x - y) / allowed : INFINITY;
}

/* Whether this place is the worst one so far. */
static int is_worst(struct worst *w, double excess)
{
    if (!(excess > 1 && excess > w->excess))
        return 0;
    w->excess = excess;
    return 1;
}

static int is_nan(const char *cell)
{
    return strcasecmp(cell + strspn(cell, "+-"), "nan") == 0;
}

static void compare_cells(struct worst *w, const struct csv *a, int i, const char *x, const char *y,
                          const char *column)
{
    double p, q, excess;

    if (!number_read(x, &p) && !number_read(y, &q))
        excess = excess_of(w, p, q);
    else
        excess = strcmp(x, y) != 0 || is_nan(x) ? INFINITY : 0;
    if (is_worst(w, excess))
        snprintf(w->text, sizeof w->text, "line %d, column %d (%.80s): '%.80s' against '%.80s'",
                 a->line, i + 1, column, x, y);
}

/* The header's cells, copied: name[0..n-1]. */
struct header {
    char **name;
    int n;
};

static struct header read_header(struct csv *c)
{
    struct why why;
    struct header h;

    must(csv_header(c, &why), &why);
    h.n = c->n;
    h.name = calloc((size_t)h.n, sizeof *h.name);
    for (int i = 0; h.name && i < h.n; i++)
        h.name[i] = strdup(c->cell[i]);
    return h;
}

static void header_free(struct header *h)
{
    for (int i = 0; i < h->n; i++)
        free(h->name[i]);
    free(h->name);
}

/* Place of the column in the header; without it wrong usage. */
static int place_of(const struct header *h, const char *name, const char *file)
{
    for (int i = 0; i < h->n; i++)
        if (strcmp(h->name[i], name) == 0)
            return i;
    die(SW_USAGE, "%s: has no column '%s'", file, name);
}

/* Pairs of columns to compare: all of them, or those of -c.  Returns how many; at is allocated. */
static int choose(struct worst *w, const struct header h[2], const struct csv c[2], int (**ret)[2])
{
    int n = 0, room = args.columns ? (int)strlen(args.columns) + 1 : h[0].n;
    int(*at)[2] = calloc((size_t)room, sizeof *at);
    char *names = args.columns ? strdup(args.columns) : NULL, *rest = NULL;

    *ret = at;
    for (char *name = names ? strtok_r(names, ",", &rest) : NULL; name;
         name = strtok_r(NULL, ",", &rest), n++) {
        at[n][0] = place_of(&h[0], name, c[0].name);
        at[n][1] = place_of(&h[1], name, c[1].name);
    }
    free(names);
    if (args.columns)
        return n;
    if (h[0].n != h[1].n && is_worst(w, INFINITY))
        snprintf(w->text, sizeof w->text, "header: %d columns against %d", h[0].n, h[1].n);
    for (n = 0; n < h[0].n && n < h[1].n; n++) {
        at[n][0] = at[n][1] = n;
        compare_cells(w, &c[0], n, h[0].name[n], h[1].name[n], "header");
    }
    return n;
}

static void compare_rows(struct worst *w, const struct header h[2], struct csv c[2])
{
    int(*at)[2];
    int n = choose(w, h, c, &at);
    struct why why;

    for (;;) {
        must(csv_row(&c[0], &why), &why);
        must(csv_row(&c[1], &why), &why);
        if (c[0].n == 0 || c[1].n == 0)
            break;
        if ((c[0].n != h[0].n || c[1].n != h[1].n) && is_worst(w, INFINITY))
            snprintf(w->text, sizeof w->text, "line %d: %d cells against %d", c[0].line, c[0].n,
                     c[1].n);
        for (int i = 0; i < n; i++)
            if (at[i][0] < c[0].n && at[i][1] < c[1].n)
                compare_cells(w, &c[0], at[i][0], c[0].cell[at[i][0]], c[1].cell[at[i][1]],
                              h[0].name[at[i][0]]);
    }
    if (c[0].n != c[1].n && is_worst(w, INFINITY))
        snprintf(w->text, sizeof w->text, "after line %d: only %s has more rows", c[0].line,
                 c[c[0].n == 0].name);
    free(at);
}

static void compare_csv(struct worst *w, const struct in in[2])
{
    struct csv c[2];
    struct header h[2];
    struct why why;

    for (int i = 0; i < 2; i++) {
        must(csv_begin(&in[i], &c[i], &why), &why);
        h[i] = read_header(&c[i]);
    }
    compare_rows(w, h, c);
    for (int i = 0; i < 2; i++) {
        header_free(&h[i]);
        csv_end(&c[i]);
    }
}

static void compare_npy(struct worst *w, const struct in in[2])
{
    struct npy a[2];
    struct why why;

    for (int i = 0; i < 2; i++)
        must(npy_read(&in[i], &a[i], &why), &why);
    if (a[0].dims != a[1].dims || a[0].rows != a[1].rows || a[0].columns != a[1].columns) {
        is_worst(w, INFINITY);
        snprintf(w->text, sizeof w->text, "shape: %d dimensions, %zu x %zu against %d, %zu x %zu",
                 a[0].dims, a[0].rows, a[0].columns, a[1].dims, a[1].rows, a[1].columns);
    } else {
        for (size_t j = 0; j < a[0].rows * a[0].columns; j++)
            if (is_worst(w, excess_of(w, a[0].data[j], a[1].data[j])))
                snprintf(w->text, sizeof w->text, "[%zu, %zu]: %.17g against %.17g", j % a[0].rows,
                         j / a[0].rows, a[0].data[j], a[1].data[j]);
    }
    npy_free(&a[0]);
    npy_free(&a[1]);
}

static int is_npy(const struct in *in)
{
    int c = getc(in->f);

    ungetc(c, in->f);
    return c == 0x93;
}

int main(int argc, char **argv)
{
    struct worst w = {0};
    struct in in[2];
    struct why why;
    int operand;

    out_prepare();
    err_tool(tool.name);
    operand = opt_parse(&tool, argc, argv);
    if (operand != argc - 2)
        opt_usage(&tool);
    w.relative = tolerance("-r", args.relative);
    w.absolute = tolerance("-a", args.absolute);
    for (int i = 0; i < 2; i++)
        must(in_open(argv[operand + i], &in[i], &why), &why);
    if (is_npy(&in[0]) != is_npy(&in[1]))
        die(SW_USAGE, "%s and %s: one is .npy, the other is not", in[0].name, in[1].name);
    if (is_npy(&in[0]))
        compare_npy(&w, in);
    else
        compare_csv(&w, in);
    in_close(&in[0]);
    in_close(&in[1]);
    if (w.excess > 0)
        printf("%s and %s differ: %s\n", argv[operand], argv[operand + 1], w.text);
    return w.excess > 0;
}
