/* The proof of a solution from its tables. */
#include "form/netproof.h"
#include "form/sheet.h"
#include "num/mem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SLACK 1e-8        /* of the largest tension: of less, only the length is judged */
#define SMALL_STRAIN 1e-5 /* a system that strains its softest rope by less carries nothing */
#define SMALL_PART 1e-5   /* of the largest load: where springs and floats carry it */
#define DEEPEST 48        /* halvings of a piece */

enum {
    NODE,
    NX,
    NF = NX + 3,
    RESIDUAL = NF + 3,
    LOAD,
    SUPPORT = LOAD + 3,
    HELD = SUPPORT + 3,
    N_NODE
};
static const struct sheet_column node_column[N_NODE] = {
    {"node", 1},     {"x_m", 1},         {"y_m", 1},         {"z_m", 1},         {"fx_N", 1},
    {"fy_N", 1},     {"fz_N", 1},        {"residual_N", 1},  {"load_x_N", 1},    {"load_y_N", 1},
    {"load_z_N", 1}, {"support_x_N", 1}, {"support_y_N", 1}, {"support_z_N", 1}, {"held", 1}};

enum { ROPE, END_A = 7, END_B = 10, A = 13, B, UNSTRETCHED, ELEMENTS, STIFFNESS, LAW = 21, N_ROPE };
static const struct sheet_column rope_column[N_ROPE] = {{"rope", 1},
                                                        {"tension_a_N", 1},
                                                        {"tension_b_N", 1},
                                                        {"tension_max_N", 1},
                                                        {"tension_min_N", 1},
                                                        {"length_m", 1},
                                                        {"length_on_bed_m", 1},
                                                        {"ta_x_N", 1},
                                                        {"ta_y_N", 1},
                                                        {"ta_z_N", 1},
                                                        {"tb_x_N", 1},
                                                        {"tb_y_N", 1},
                                                        {"tb_z_N", 1},
                                                        {"node_a", 1},
                                                        {"node_b", 1},
                                                        {"unstretched_m", 1},
                                                        {"elements", 1},
                                                        {"ea_N", 1},
                                                        {"use", 0},
                                                        {"lowest_z_m", 0},
                                                        {"remark", 0},
                                                        {"law", 1}};

enum {
    SHAPE_ROPE,
    JOINT,
    SX,
    TENSION = SX + 3,
    SLOAD,
    S = SLOAD + 3,
    ST,
    STRAIN = ST + 3,
    BED,
    N_SHAPE
};
static const struct sheet_column shape_column[N_SHAPE] = {
    {"rope", 1},      {"joint", 1},    {"x_m", 1},      {"y_m", 1},      {"z_m", 1},
    {"tension_N", 1}, {"load_x_N", 1}, {"load_y_N", 1}, {"load_z_N", 1}, {"s_m", 1},
    {"tx_N", 1},      {"ty_N", 1},     {"tz_N", 1},     {"strain", 1},   {"bed_N", 0}};

/* Everything as numbers. */
struct tables {
    struct sheet nodes, ropes, shapes;
    double *x, *sum;          /* (nodes, 3): position; balance so far */
    double *ta, *tb;          /* (ropes, 3) */
    double *point, *load, *t; /* (points, 3) */
    double *s, *strain, *bed; /* (points) */
    int *a, *b, *first;       /* (ropes): nodes, first point; (ropes + 1) of the last */
    double *L0, *EA;
    int *hooke; /* (ropes): strain is tension over EA; else as the table of shapes has it */
    int *elements;
};

static double size(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

static enum status numbers(const struct sheet *t, int row, int column, int n, double *ret,
                           struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i < n && s == SW_OK; i++)
        s = sheet_number(t, row, column + i, -1e300, 1e300, NAN, &ret[i], why);
    return s;
}

static enum status take_nodes(struct tables *p, struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i < p->nodes.n && s == SW_OK; i++) {
        double load[3] = {0}, support[3] = {0};
        const char *held = sheet_text(&p->nodes, i, HELD);

        s = numbers(&p->nodes, i, NX, 3, p->x + 3 * i, why);
        if (s == SW_OK)
            s = numbers(&p->nodes, i, LOAD, 3, load, why);
        if (s == SW_OK)
            s = numbers(&p->nodes, i, SUPPORT, 3, support, why);
        for (int c = 0; c < 3 && s == SW_OK; c++) {
            if (support[c] != 0 && !strchr(held, "xyz"[c]))
                s = sheet_fail(why, &p->nodes, i, "a support where nothing is held");
            p->sum[3 * i + c] = load[c] + support[c];
        }
    }
    return s;
}

static enum status take_ropes(struct tables *p, struct why *why)
{
    struct roll names = {.n = 0};
    struct roll_index index = {NULL, 0};
    enum status s = sheet_roll(&p->nodes, NODE, &names, why);

    if (s == SW_OK)
        s = roll_sort(&names, &index, why);

    for (int r = 0; r < p->ropes.n && s == SW_OK; r++) {
        double elements = 0;

        p->a[r] = roll_find(&names, &index, sheet_text(&p->ropes, r, A));
        p->b[r] = roll_find(&names, &index, sheet_text(&p->ropes, r, B));
        if (p->a[r] < 0 || p->b[r] < 0)
            s = sheet_fail(why, &p->ropes, r, "an end is no node of the table");
        if (s == SW_OK)
            s = numbers(&p->ropes, r, END_A, 3, p->ta + 3 * r, why);
        if (s == SW_OK)
            s = numbers(&p->ropes, r, END_B, 3, p->tb + 3 * r, why);
        if (s == SW_OK)
            s = numbers(&p->ropes, r, UNSTRETCHED, 1, &p->L0[r], why);
        if (s == SW_OK)
            s = numbers(&p->ropes, r, ELEMENTS, 1, &elements, why);
        if (s == SW_OK)
            s = numbers(&p->ropes, r, STIFFNESS, 1, &p->EA[r], why);
        if (s == SW_OK && !(elements >= 0 && elements <= 1e6 && elements == floor(elements)))
            s = sheet_fail(why, &p->ropes, r, "elements must be a whole number");
        if (s == SW_OK && !(p->L0[r] > 0 && p->EA[r] > 0))
            s = sheet_fail(why, &p->ropes, r, "its length or stiffness is not positive");
        p->elements[r] = s == SW_OK ? (int)elements : 0;
        p->hooke[r] = strcmp(sheet_text(&p->ropes, r, LAW), "hooke") == 0;
    }
    free(index.at);
    roll_free(&names);
    return s;
}

/* The points of rope r cover its length, element by element. */
static enum status whole_rope(const struct tables *p, int r, struct why *why)
{
    int first = p->first[r], last = p->first[r + 1] - 1, n = p->elements[r];

    if (last == first || (n > 0 && last - first != n))
        return sheet_fail(why, &p->shapes, last, "the rope has another number of elements");
    for (int k = first; k <= last; k++) {
        double s = n > 0 ? p->L0[r] / n * (k - first) : k == first ? 0 : p->L0[r];

        if ((n > 0 || k == first || k == last) && !(fabs(p->s[k] - s) <= 1e-12 * p->L0[r]))
            return sheet_fail(why, &p->shapes, k, "s_m does not belong to the rope's length");
    }
    return SW_OK;
}

/* Points stand in the order of the ropes. */
static enum status take_points(struct tables *p, struct why *why)
{
    enum status s = SW_OK;
    int r = -1;

    for (int k = 0; k < p->shapes.n && s == SW_OK; k++) {
        double joint;

        s = numbers(&p->shapes, k, JOINT, 1, &joint, why);
        if (s == SW_OK && joint == 0 && ++r < p->ropes.n)
            p->first[r] = k;
        if (s == SW_OK &&
            (r < 0 || r >= p->ropes.n || joint != k - p->first[r] ||
             strcmp(sheet_text(&p->shapes, k, SHAPE_ROPE), sheet_text(&p->ropes, r, ROPE)) != 0))
            s = sheet_fail(why, &p->shapes, k, "is not in the order of the table of ropes");
        if (s == SW_OK)
            s = numbers(&p->shapes, k, SX, 3, p->point + 3 * k, why);
        if (s == SW_OK)
            s = numbers(&p->shapes, k, SLOAD, 3, p->load + 3 * k, why);
        if (s == SW_OK)
            s = numbers(&p->shapes, k, S, 1, p->s + k, why);
        if (s == SW_OK)
            s = numbers(&p->shapes, k, ST, 3, p->t + 3 * k, why);
        if (s == SW_OK)
            s = numbers(&p->shapes, k, STRAIN, 1, p->strain + k, why);
        if (s == SW_OK)
            s = sheet_number(&p->shapes, k, BED, -1e300, 1e300, 0, p->bed + k, why);
    }
    p->first[p->ropes.n] = p->shapes.n;
    if (s == SW_OK && r != p->ropes.n - 1)
        s = fail(why, SW_FORMAT, "%.400s: %d ropes; there are %d", p->shapes.name, r + 1,
                 p->ropes.n);
    for (r = 0; r < p->ropes.n && s == SW_OK; r++)
        s = whole_rope(p, r, why);
    return s;
}

static enum status read_one(const char *dir, const char *name, const struct sheet_column *column,
                            int n, struct sheet *ret, struct why *why)
{
    size_t bytes = strlen(dir) + strlen(name) + 2;
    char *path = mem_zeroed(bytes, 1);
    enum status s = SW_NOMEM;

    if (!path)
        return fail_plain(why, s);
    snprintf(path, bytes, "%s/%s", dir, name);
    s = sheet_read(path, NULL, column, n, ret, why);
    free(path);
    return s;
}

static enum status make_room(struct tables *p, struct why *why)
{
    size_t n = (size_t)p->nodes.n, m = (size_t)p->ropes.n, k = (size_t)p->shapes.n;

    p->x = mem_doubles(3 * n);
    p->sum = mem_doubles(3 * n);
    p->ta = mem_doubles(3 * m);
    p->tb = mem_doubles(3 * m);
    p->point = mem_doubles(3 * k);
    p->load = mem_doubles(3 * k);
    p->t = mem_doubles(3 * k);
    p->s = mem_doubles(k);
    p->strain = mem_doubles(k);
    p->bed = mem_doubles(k);
    p->L0 = mem_doubles(m);
    p->EA = mem_doubles(m);
    p->a = mem_zeroed(m, sizeof *p->a);
    p->b = mem_zeroed(m, sizeof *p->b);
    p->first = mem_zeroed(m + 1, sizeof *p->first);
    p->elements = mem_zeroed(m, sizeof *p->elements);
    p->hooke = mem_zeroed(m, sizeof *p->hooke);
    return p->x && p->sum && p->ta && p->tb && p->point && p->load && p->t && p->s && p->strain &&
                   p->bed && p->L0 && p->EA && p->a && p->b && p->first && p->elements && p->hooke
               ? SW_OK
               : fail_plain(why, SW_NOMEM);
}

static void tables_free(struct tables *p)
{
    void *const all[] = {p->x, p->sum, p->ta,     p->tb,       p->point, p->load,
                         p->t, p->s,   p->strain, p->bed,      p->L0,    p->EA,
                         p->a, p->b,   p->first,  p->elements, p->hooke};

    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
    sheet_free(&p->nodes);
    sheet_free(&p->ropes);
    sheet_free(&p->shapes);
}

static void measure(const struct tables *p, struct net_proof *ret)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double softest = INFINITY, load = 0;

    for (int k = 0; k < p->shapes.n; k++) {
        ret->tension = fmax(ret->tension, size(p->t + 3 * k));
        for (int c = 0; c < 3; c++) {
            low[c] = fmin(low[c], p->point[3 * k + c]);
            high[c] = fmax(high[c], p->point[3 * k + c]);
        }
    }
    for (int r = 0; r < p->ropes.n; r++)
        softest = fmin(softest, p->EA[r]);
    for (int i = 0; i < 3 * p->nodes.n; i++)
        load = fmax(load, fabs(p->sum[i]));
    ret->force = fmax(ret->tension, fmax(SMALL_STRAIN * softest, SMALL_PART * load));
    for (int c = 0; c < 3 && p->shapes.n > 0; c++)
        ret->size = fmax(ret->size, high[c] - low[c]);
    for (int r = 0; r < p->ropes.n; r++)
        ret->size = fmax(ret->size, p->L0[r]);
}

static void keep_worst(double now, double *most, const char *name, char to[PROOF_NAME])
{
    if (now <= *most || isnan(*most))
        return;
    *most = now; /* also one that is no number, which stays */
    snprintf(to, PROOF_NAME, "%s", name);
}

static void prove_nodes(struct tables *p, struct net_proof *ret)
{
    for (int r = 0; r < p->ropes.n; r++)
        for (int c = 0; c < 3; c++) {
            p->sum[3 * p->a[r] + c] += p->ta[3 * r + c];
            p->sum[3 * p->b[r] + c] -= p->tb[3 * r + c];
        }
    for (int i = 0; i < p->nodes.n; i++)
        keep_worst(size(p->sum + 3 * i) / ret->force, &ret->unbalance,
                   sheet_text(&p->nodes, i, NODE), ret->node);
}

/* Joints of rope r, and its ends against the table of ropes. */
static void prove_joints(const struct tables *p, int r, struct net_proof *ret)
{
    int first = p->first[r], last = p->first[r + 1] - 1;
    const char *name = sheet_text(&p->ropes, r, ROPE);
    double open[3];

    for (int k = first; k <= last; k++) {
        const double *before = k > first ? p->t + 3 * (k - 1) : p->ta + 3 * r;

        for (int c = 0; c < 3; c++)
            open[c] = before[c] - (k > first ? p->load[3 * k + c] : 0) - p->t[3 * k + c];
        keep_worst(size(open) / ret->force, &ret->joint, name, ret->rope);
    }
    for (int c = 0; c < 3; c++)
        open[c] = p->t[3 * last + c] - p->tb[3 * r + c];
    keep_worst(size(open) / ret->force, &ret->joint, name, ret->rope);
}

/* (1/T + 1/EA) t at u = 0..1 between two tensions. */
static void integrand(const double t1[3], const double t2[3], double EA, double u, double ret[3])
{
    double t[3], T;

    for (int c = 0; c < 3; c++)
        t[c] = t1[c] + u * (t2[c] - t1[c]);
    T = size(t);
    for (int c = 0; c < 3; c++)
        ret[c] = T > 0 ? t[c] * (1 / T + 1 / EA) : 0;
}

/* Integral from u to u + h by Simpson's rule, halved until two of them agree. */
static void integrate(const double t1[3], const double t2[3], double EA, double u, double h,
                      int depth, double ret[3])
{
    double f[5][3], whole[3], halves[3], apart = 0;

    for (int i = 0; i < 5; i++)
        integrand(t1, t2, EA, u + h * i / 4, f[i]);
    for (int c = 0; c < 3; c++) {
        whole[c] = h / 6 * (f[0][c] + 4 * f[2][c] + f[4][c]);
        halves[c] = h / 12 * (f[0][c] + 4 * f[1][c] + 2 * f[2][c] + 4 * f[3][c] + f[4][c]);
        apart = fmax(apart, fabs(halves[c] - whole[c]));
    }
    if (apart <= 1e-13 || depth == 0) {
        for (int c = 0; c < 3; c++)
            ret[c] += halves[c] + (halves[c] - whole[c]) / 15;
        return;
    }
    integrate(t1, t2, EA, u, h / 2, depth - 1, ret);
    integrate(t1, t2, EA, u + h / 2, h / 2, depth - 1, ret);
}

/* Stretched length of the piece of rope r from point k, if it were straight. */
static double reach(const struct tables *p, int r, int k)
{
    double length = p->s[k + 1] - p->s[k];
    double T = fmax(size(p->t + 3 * k), size(p->t + 3 * (k + 1)));

    return length * (1 + (p->elements[r] > 0 ? p->strain[k] : T / p->EA[r]));
}

/* Where the piece of rope r from point k leads; 0: it carries nothing and leads anywhere within its
 * length. */
static int piece(const struct tables *p, int r, int k, double tension, double ret[3])
{
    const double *t1 = p->t + 3 * k, *t2 = p->t + 3 * (k + 1);
    double length = p->s[k + 1] - p->s[k], T = size(t1);

    ret[0] = ret[1] = ret[2] = 0;
    if (p->elements[r] == 0) {
        integrate(t1, t2, p->EA[r], 0, 1, DEEPEST, ret);
        for (int c = 0; c < 3; c++)
            ret[c] *= length;
        return size(t1) + size(t2) > SLACK * tension;
    }
    for (int c = 0; c < 3; c++)
        ret[c] = T > 0 ? length * (1 + p->strain[k]) * t1[c] / T : 0;
    return T > SLACK * tension;
}

/* A bar may be compressed: its tension then points the other way, and its strain is its length's.
 */
static double prove_bar(const struct tables *p, int r, double tension)
{
    const double *a = p->x + 3 * p->a[r], *b = p->x + 3 * p->b[r], *t = p->ta + 3 * r;
    double d[3], l, N, across[3];

    for (int c = 0; c < 3; c++)
        d[c] = b[c] - a[c];
    l = size(d);
    N = p->EA[r] * (l / p->L0[r] - 1);
    if (!p->hooke[r] && l > p->L0[r]) /* tension by a table: only its direction and strain tell */
        N = size(t) + p->EA[r] * (l / p->L0[r] - 1 - p->strain[p->first[r]]);
    for (int c = 0; c < 3; c++)
        across[c] = t[c] - (l > 0 ? N * d[c] / l : 0);
    return (l > 0 ? size(across) : fabs(N)) / tension; /* no length: it can push nowhere */
}

/* The bed pushes, or does nothing. */
static void prove_bed(const struct tables *p, int r, struct net_proof *ret)
{
    for (int k = p->first[r]; k < p->first[r + 1]; k++)
        keep_worst(-p->bed[k] / ret->force, &ret->bed, sheet_text(&p->ropes, r, ROPE),
                   ret->bed_rope);
}

static void prove_shape(const struct tables *p, int r, struct net_proof *ret)
{
    const char *name = sheet_text(&p->ropes, r, ROPE);
    int first = p->first[r], last = p->first[r + 1] - 1;

    for (int k = first; k < last; k++) {
        double lead[3], open[3], d[3], far;

        for (int c = 0; c < 3; c++)
            d[c] = p->point[3 * (k + 1) + c] - p->point[3 * k + c];
        if (piece(p, r, k, ret->force, lead)) {
            for (int c = 0; c < 3; c++)
                open[c] = d[c] - lead[c];
            far = size(open);
        } else {
            far = fmax(0, size(d) - reach(p, r, k));
        }
        if (p->elements[r] > 0 && p->hooke[r])
            far = fmax(far, fabs(p->strain[k] - size(p->t + 3 * k) / p->EA[r]) *
                                (p->s[k + 1] - p->s[k]));
        keep_worst(far / ret->size, &ret->gap, name, ret->gap_rope);
    }
    for (int end = 0; end < 2; end++) {
        const double *node = p->x + 3 * (end ? p->b[r] : p->a[r]);
        const double *point = p->point + 3 * (end ? last : first);
        const double open[3] = {node[0] - point[0], node[1] - point[1], node[2] - point[2]};

        keep_worst(size(open) / ret->size, &ret->gap, name, ret->gap_rope);
    }
}

enum status net_prove(const char *dir, struct net_proof *ret, struct why *why)
{
    struct tables p = {.x = NULL};
    enum status s = read_one(dir, "nodes.csv", node_column, N_NODE, &p.nodes, why);

    *ret = (struct net_proof){.nodes = 0};
    if (s == SW_OK)
        s = read_one(dir, "ropes.csv", rope_column, N_ROPE, &p.ropes, why);
    if (s == SW_OK)
        s = read_one(dir, "shapes.csv", shape_column, N_SHAPE, &p.shapes, why);
    if (s == SW_OK)
        s = make_room(&p, why);
    if (s == SW_OK)
        s = take_nodes(&p, why);
    if (s == SW_OK)
        s = take_ropes(&p, why);
    if (s == SW_OK)
        s = take_points(&p, why);
    if (s == SW_OK) {
        ret->nodes = p.nodes.n;
        ret->ropes = p.ropes.n;
        ret->points = p.shapes.n;
        measure(&p, ret);
        prove_nodes(&p, ret);
        for (int r = 0; r < p.ropes.n; r++) {
            prove_joints(&p, r, ret);
            prove_bed(&p, r, ret);
            if (p.elements[r] == 1)
                keep_worst(prove_bar(&p, r, ret->force), &ret->joint, sheet_text(&p.ropes, r, ROPE),
                           ret->rope);
            else
                prove_shape(&p, r, ret);
        }
    }
    tables_free(&p);
    return s;
}
