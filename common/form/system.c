/* A system of ropes from its tables. */
#include "form/system.h"
#include "form/cable.h"
#include "num/mem.h"
#include "num/pi.h"
#include "sys/in.h"
#include "sys/npy.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define AT(member) offsetof(struct system_case, member)
#define BIG CASE_LARGEST

static const struct key keys[] = {
    {"environment", "gravity", NUMBERS, AT(gravity), 1, 1, 0, 1e6, NULL, "9.81"},
    {"environment", "water_density", NUMBERS, AT(density), 1, 1, 0, 1e5, NULL, "1025"},
    {"tables", "nodes", TEXT, AT(nodes), 1, 1, 0, 0, NULL, "nodes.csv"},
    {"tables", "ropes", TEXT, AT(ropes), 1, 1, 0, 0, NULL, "ropes.csv"},
    {"tables", "types", TEXT, AT(types), 1, 1, 0, 0, NULL, "types.csv"},
    {"tables", "loads", TEXT, AT(loads), 1, 1, 0, 0, NULL, NULL},
    {"solve", "method", WORD, AT(method), 1, 1, 0, 0, "gap displacement imaginary", "gap"},
    {"solve", "rope", WORD, AT(rope), 1, 1, 0, 0, "auto chain catenary", "auto"},
    {"solve", "elements", WHOLE, AT(elements), 1, 1, 1, 1e6, NULL, "20"},
    {"solve", "tolerance", NUMBERS, AT(tolerance), 1, 1, 1e-15, 1e-3, NULL, "5e-10"},
    {"solve", "steps", WHOLE, AT(steps), 1, 1, 1, 1e7, NULL, "1000"},
    {"solve", "start", WORD, AT(start), 1, 1, 0, 0, "exact closed fictitious", "exact"},
    {"solve", "start_steps", WHOLE, AT(start_steps), 1, 1, 1, 1e6, NULL, "5"},
    {"solve", "step", WORD, AT(pull), 1, 1, 0, 0, "constant unit span", "constant"},
};
#define N_KEYS ((int)(sizeof keys / sizeof *keys))

static enum status take_keys(const struct reading *r, struct system_case *c)
{
    enum status s = keys_judge_names(r);

    for (int i = 0; i < N_KEYS && s == SW_OK; i++)
        if (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0)
            s = keys_take(r, keys[i].section, c);
    return s;
}

enum status system_case_load(const char *path, const struct opt_list *sets, struct system_case *ret,
                             struct why *why)
{
    struct ini ini = {0};
    struct reading r = {&ini, NULL, keys, N_KEYS, "", why};
    struct in in;
    enum status s = in_open(path, &in, why);

    if (s != SW_OK)
        return s;
    s = ini_read(in.f, in.name, &ini, why);
    in_close(&in);
    for (int i = 0; i < sets->n && s == SW_OK; i++)
        s = ini_set(&ini, sets->item[i], why);
    if (s == SW_OK)
        s = take_keys(&r, ret);
    ini_free(&ini);
    return s;
}

void system_case_print(const struct system_case *c, struct out *o)
{
    for (int i = 0; i < N_KEYS; i++)
        if (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0)
            keys_print(keys, N_KEYS, keys[i].section, c, o);
}

/* Columns of the tables. */
enum { TYPE, DIAMETER, MASS, EA, CD, CD_AXIAL, BREAKING, TENSION_TABLE, N_TYPE };
static const struct sheet_column type_column[N_TYPE] = {{"type", 1},       {"diameter_m", 1},
                                                        {"mass_kg_m", 1},  {"ea_N", 0},
                                                        {"cd", 0},         {"cd_axial", 0},
                                                        {"breaking_N", 0}, {"tension_table", 0}};

enum { ROPE, NODE_A, NODE_B, ROPE_TYPE, LENGTH, ELEMENTS, N_ROPE };
static const struct sheet_column rope_column[N_ROPE] = {{"rope", 1},     {"node_a", 1},
                                                        {"node_b", 1},   {"type", 1},
                                                        {"length_m", 1}, {"elements", 0}};

enum {
    NODE,
    CONDITION,
    X,
    Y,
    Z,
    NODE_MASS,
    VOLUME,
    CDA,
    FX,
    FY,
    FZ,
    KX,
    KY,
    KZ,
    STIFFNESS,
    WATERPLANE,
    BODY,
    N_NODE
};
static const struct sheet_column node_column[N_NODE] = {
    {"node", 1},          {"condition", 1}, {"x_m", 1},    {"y_m", 1},    {"z_m", 1},
    {"mass_kg", 0},       {"volume_m3", 0}, {"cda_m2", 0}, {"fx_N", 0},   {"fy_N", 0},
    {"fz_N", 0},          {"kx_N_m", 0},    {"ky_N_m", 0}, {"kz_N_m", 0}, {"stiffness", 0},
    {"waterplane_m2", 0}, {"body", 0}};

enum { LOAD_NODE, LOAD_X, LOAD_Y, LOAD_Z, N_LOAD };
static const struct sheet_column load_column[N_LOAD] = {{"node", 1},
                                                        {"fx_N", 1},
                                                        {"fy_N", 1},
                                                        {"fz_N", 1}};

static const struct sheet_column strain_column[2] = {{"strain", 1}, {"tension_N", 1}};

/* The tension-strain table of a type: ascending from above zero. */
static enum status read_table(const struct sheet *types, int row, struct system_type *to,
                              struct why *why)
{
    struct sheet t;
    enum status s =
        sheet_read(sheet_text(types, row, TENSION_TABLE), types->name, strain_column, 2, &t, why);
    double before[2] = {0, 0};

    if (s != SW_OK)
        return s;
    to->table = mem_doubles(2 * (size_t)t.n);
    if (!to->table)
        s = fail_plain(why, SW_NOMEM);
    if (s == SW_OK && t.n == 0)
        s = sheet_fail(why, types, row, "tension_table: %.200s has no rows", t.name);
    for (int i = 0; i < t.n && s == SW_OK; i++) {
        double point[2];

        s = sheet_number(&t, i, 0, 0, 10, NAN, &point[0], why);
        if (s == SW_OK)
            s = sheet_number(&t, i, 1, 0, 1e18, NAN, &point[1], why);
        if (s == SW_OK && i == 0 && point[0] == 0 && point[1] == 0)
            continue; /* the origin belongs to every table */
        if (s == SW_OK && !(point[0] > before[0] && point[1] > before[1]))
            s = sheet_fail(why, &t, i, "strain and tension must ascend, from above zero");
        if (s != SW_OK)
            break;
        memcpy(before, point, sizeof before);
        to->table[to->law.n] = point[0];
        to->table[t.n + to->law.n++] = point[1];
    }
    if (s == SW_OK && to->law.n == 0)
        s = sheet_fail(why, types, row, "tension_table: %.200s has no point but zero", t.name);
    if (s == SW_OK) {
        to->law.strain = to->table;
        to->law.tension = to->table + t.n;
        to->law.EA = to->law.tension[0] / to->law.strain[0];
    }
    sheet_free(&t);
    return s;
}

static enum status take_type(struct system *p, int i, struct why *why)
{
    const struct sheet *t = &p->types;
    struct system_type *to = &p->type[i];
    int table = sheet_text(t, i, TENSION_TABLE)[0] != '\0';
    enum status s = sheet_number(t, i, DIAMETER, 0, 1e3, NAN, &to->diameter, why);

    if (s == SW_OK)
        s = sheet_number(t, i, MASS, 0, BIG, NAN, &to->mass, why);
    if (s == SW_OK)
        s = sheet_number(t, i, EA, 1e-9, 1e18, -1, &to->law.EA, why);
    if (s == SW_OK)
        s = sheet_number(t, i, BREAKING, 1e-9, 1e18, INFINITY, &to->breaking, why);
    if (s == SW_OK && table == (to->law.EA > 0))
        s = sheet_fail(why, t, i, "give either ea_N or tension_table");
    return s == SW_OK && table ? read_table(t, i, to, why) : s;
}

static enum status take_types(struct system *p, struct why *why)
{
    enum status s = SW_OK;

    p->type = mem_zeroed((size_t)p->types.n, sizeof *p->type);
    if (!p->type)
        return fail_plain(why, SW_NOMEM);
    for (int i = 0; i < p->types.n && s == SW_OK; i++)
        s = take_type(p, i, why);
    return s;
}

/* free, fixed, or the directions that are held. */
static enum status take_condition(const struct sheet *t, int i, int *ret_held, struct why *why)
{
    const char *text = sheet_text(t, i, CONDITION);

    *ret_held = strcmp(text, "fixed") == 0 ? 7 : 0;
    if (*ret_held || strcmp(text, "free") == 0)
        return SW_OK;
    for (const char *p = text; *p; p++) {
        const char *axis = strchr("xyz", *p);

        if (!axis || *ret_held & 1 << (axis - "xyz"))
            return sheet_fail(why, t, i, "condition '%.60s' is not free, fixed, or some of xyz",
                              text);
        *ret_held |= 1 << (axis - "xyz");
    }
    return *ret_held ? SW_OK : sheet_fail(why, t, i, "the condition is missing");
}

/* The spring of a node: three numbers, or a 3 x 3 matrix in a file. */
static enum status take_spring(const struct sheet *t, int i, struct net_node *to, struct why *why)
{
    static const int diagonal[3] = {SYM_XX, SYM_YY, SYM_ZZ};
    const char *file = sheet_text(t, i, STIFFNESS);
    struct npy a = {.data = NULL};
    struct in in;
    char *path;
    enum status s = SW_OK;

    for (int c = 0; c < 3 && s == SW_OK; c++)
        s = sheet_number(t, i, KX + c, 0, 1e18, 0, &to->K[diagonal[c]], why);
    if (s != SW_OK || file[0] == '\0')
        return s;
    path = case_beside(t->name, file);
    s = path ? in_open(path, &in, why) : fail_plain(why, SW_NOMEM);
    if (s == SW_OK) {
        s = npy_read(&in, &a, why);
        in_close(&in);
    }
    if (s == SW_OK && (a.rows != 3 || a.columns != 3))
        s = sheet_fail(why, t, i, "stiffness: %.200s is no 3 x 3 matrix", file);
    for (int c = 0, at = 0; c < 3 && s == SW_OK; c++)
        for (int d = c; d < 3; d++, at++)
            to->K[at] += (a.data[c + 3 * d] + a.data[d + 3 * c]) / 2;
    npy_free(&a);
    free(path);
    return s;
}

static enum status take_node(const struct system *p, int i, struct net_node *to, struct why *why)
{
    const struct sheet *t = &p->nodes;
    double mass, volume, area;
    enum status s = take_condition(t, i, &to->held, why);

    if (s == SW_OK && sheet_text(t, i, BODY)[0] != '\0')
        s = sheet_fail(why, t, i, "body: rigid bodies are not known");
    for (int c = 0; c < 3 && s == SW_OK; c++) {
        s = sheet_number(t, i, X + c, -BIG, BIG, INFINITY, &to->x[c], why);
        if (s == SW_OK && isinf(to->x[c]) && to->held & 1 << c)
            s = sheet_fail(why, t, i, "a held node needs its coordinate");
        if (s == SW_OK && isinf(to->x[c]))
            to->x[c] = NAN;
    }
    if (s == SW_OK)
        s = sheet_number(t, i, NODE_MASS, 0, 1e15, 0, &mass, why);
    if (s == SW_OK)
        s = sheet_number(t, i, VOLUME, 0, 1e15, 0, &volume, why);
    if (s == SW_OK)
        s = sheet_number(t, i, WATERPLANE, 0, 1e12, 0, &area, why);
    for (int c = 0; c < 3 && s == SW_OK; c++)
        s = sheet_number(t, i, FX + c, -1e18, 1e18, 0, &to->force[c], why);
    if (s == SW_OK)
        s = take_spring(t, i, to, why);
    if (s != SW_OK)
        return s;
    for (int c = 0; c < 3; c++)
        to->anchor[c] = isnan(to->x[c]) ? 0 : to->x[c];
    for (int k = 0; k < SYM; k++)
        if (to->K[k] != 0 && (isnan(to->x[0]) || isnan(to->x[1]) || isnan(to->x[2])))
            return sheet_fail(why, t, i, "a spring needs the point that it pulls to");
    if (area > 0 && !(volume > 0))
        return sheet_fail(why, t, i, "a waterplane needs a volume");
    to->force[2] -= mass * p->c.gravity;
    if (area > 0) {
        to->area = p->c.density * p->c.gravity * area;
        to->height = volume / area;
    } else {
        to->force[2] += volume * p->c.density * p->c.gravity;
    }
    return SW_OK;
}

static enum status take_nodes(struct system *p, struct why *why)
{
    enum status s = SW_OK;

    p->net.n = p->nodes.n;
    p->net.node = mem_zeroed((size_t)p->net.n, sizeof *p->net.node);
    if (!p->net.node)
        return fail_plain(why, SW_NOMEM);
    for (int i = 0; i < p->net.n && s == SW_OK; i++)
        s = take_node(p, i, &p->net.node[i], why);
    return s;
}

static enum status take_loads(struct system *p, const struct sheet_index *nodes, struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i < p->loads.n && s == SW_OK; i++) {
        int node = sheet_find(&p->nodes, NODE, nodes, sheet_text(&p->loads, i, LOAD_NODE));

        if (node < 0)
            return sheet_fail(why, &p->loads, i, "there is no node '%.60s'",
                              sheet_text(&p->loads, i, LOAD_NODE));
        for (int c = 0; c < 3 && s == SW_OK; c++) {
            double f;

            s = sheet_number(&p->loads, i, LOAD_X + c, -1e18, 1e18, NAN, &f, why);
            p->net.node[node].force[c] += s == SW_OK ? f : 0;
        }
    }
    return s;
}

/* Chain or continuous: by the row, the case, the law. */
static enum status take_elements(struct system *p, int r, struct rope *to, struct why *why)
{
    double given;
    enum status s = sheet_number(&p->ropes, r, ELEMENTS, 1, 1e6, -1, &given, why);

    if (s != SW_OK)
        return s;
    if (given != floor(given))
        return sheet_fail(why, &p->ropes, r, "elements must be a whole number");
    if (p->c.rope == ROPE_CATENARY && given != 1) {
        if (to->law.n > 0)
            return sheet_fail(why, &p->ropes, r,
                              "a rope with a tension table is no catenary: take rope = auto");
        to->elements = 0;
    } else if (given > 0) {
        to->elements = (int)given;
    } else {
        to->elements = p->c.rope == ROPE_CHAIN || to->law.n > 0 || p->c.method == NET_DISPLACEMENT
                           ? p->c.elements
                           : 0;
    }
    return SW_OK;
}

static enum status take_rope(struct system *p, int r, const struct sheet_index *nodes,
                             const struct sheet_index *types, struct why *why)
{
    struct net_rope *to = &p->net.rope[r];
    const struct sheet *t = &p->ropes;
    const struct system_type *type;
    enum status s;

    to->a = sheet_find(&p->nodes, NODE, nodes, sheet_text(t, r, NODE_A));
    to->b = sheet_find(&p->nodes, NODE, nodes, sheet_text(t, r, NODE_B));
    p->type_of[r] = sheet_find(&p->types, TYPE, types, sheet_text(t, r, ROPE_TYPE));
    if (to->a < 0 || to->b < 0)
        return sheet_fail(why, t, r, "there is no node '%.60s'",
                          sheet_text(t, r, to->a < 0 ? NODE_A : NODE_B));
    if (p->type_of[r] < 0)
        return sheet_fail(why, t, r, "there is no type '%.60s'", sheet_text(t, r, ROPE_TYPE));
    type = &p->type[p->type_of[r]];
    to->rope.law = type->law;
    to->rope.q[2] =
        -p->c.gravity * (type->mass - p->c.density * PI / 4 * type->diameter * type->diameter);
    s = sheet_number(t, r, LENGTH, 1e-9, BIG, NAN, &to->rope.L0, why);
    return s == SW_OK ? take_elements(p, r, &to->rope, why) : s;
}

static enum status take_ropes(struct system *p, const struct sheet_index *nodes,
                              const struct sheet_index *types, struct why *why)
{
    enum status s = SW_OK;

    p->net.m = p->ropes.n;
    p->net.rope = mem_zeroed((size_t)p->net.m, sizeof *p->net.rope);
    p->type_of = mem_zeroed((size_t)p->net.m, sizeof *p->type_of);
    if (!p->net.rope || !p->type_of)
        return fail_plain(why, SW_NOMEM);
    for (int r = 0; r < p->net.m && s == SW_OK; r++)
        s = take_rope(p, r, nodes, types, why);
    return s;
}

static enum status judge_net(const struct system *p, struct why *why)
{
    int is_rope, at;
    const char *reason;

    if (p->net.m == 0)
        return fail(why, SW_FORMAT, "%.400s: has no ropes", p->ropes.name);
    reason = net_refused(&p->net, &is_rope, &at);
    if (!reason)
        return SW_OK;
    sheet_fail(why, is_rope ? &p->ropes : &p->nodes, at, "%s", reason);
    return SW_ADMISSIBLE;
}

enum status system_load(const char *path, const struct system_case *c, struct system *ret,
                        struct why *why)
{
    struct sheet_index nodes = {NULL, 0}, types = {NULL, 0}, ropes = {NULL, 0};
    enum status s;

    *ret = (struct system){.c = *c};
    s = sheet_read(c->nodes, path, node_column, N_NODE, &ret->nodes, why);
    if (s == SW_OK)
        s = sheet_read(c->types, path, type_column, N_TYPE, &ret->types, why);
    if (s == SW_OK)
        s = sheet_read(c->ropes, path, rope_column, N_ROPE, &ret->ropes, why);
    if (s == SW_OK && c->loads[0] != '\0')
        s = sheet_read(c->loads, path, load_column, N_LOAD, &ret->loads, why);
    if (s == SW_OK)
        s = sheet_sort(&ret->nodes, NODE, &nodes, why);
    if (s == SW_OK)
        s = sheet_sort(&ret->types, TYPE, &types, why);
    if (s == SW_OK)
        s = sheet_sort(&ret->ropes, ROPE, &ropes, why);
    if (s == SW_OK)
        s = take_types(ret, why);
    if (s == SW_OK)
        s = take_nodes(ret, why);
    if (s == SW_OK)
        s = take_loads(ret, &nodes, why);
    if (s == SW_OK)
        s = take_ropes(ret, &nodes, &types, why);
    if (s == SW_OK)
        s = judge_net(ret, why);
    free(nodes.row);
    free(types.row);
    free(ropes.row);
    if (s != SW_OK)
        system_free(ret);
    return s;
}

void system_free(struct system *s)
{
    for (int i = 0; s->type && i < s->types.n; i++)
        free(s->type[i].table);
    free(s->type);
    free(s->type_of);
    free(s->net.node);
    free(s->net.rope);
    sheet_free(&s->nodes);
    sheet_free(&s->ropes);
    sheet_free(&s->types);
    sheet_free(&s->loads);
    *s = (struct system){.type = NULL};
}

const char *system_node(const struct system *s, int i)
{
    return sheet_text(&s->nodes, i, NODE);
}

const char *system_rope(const struct system *s, int r)
{
    return sheet_text(&s->ropes, r, ROPE);
}

#define SENSIBLE 0.1 /* strain of a rope between two fixed nodes */

int system_lint(const struct system *s, void (*tell)(const char *text))
{
    int found = 0;
    struct why why;

    for (int r = 0; r < s->net.m; r++) {
        const struct net_rope *p = &s->net.rope[r];
        const struct net_node *a = &s->net.node[p->a], *b = &s->net.node[p->b];
        double d =
            sqrt(pow(b->x[0] - a->x[0], 2) + pow(b->x[1] - a->x[1], 2) + pow(b->x[2] - a->x[2], 2));

        if (a->held != 7 || b->held != 7 || d <= (1 + SENSIBLE) * p->rope.L0)
            continue;
        sheet_fail(&why, &s->ropes, r, "its nodes are %.6g m apart, %.3g %% more than its length",
                   d, 100 * (d / p->rope.L0 - 1));
        tell(why.text);
        found++;
    }
    for (int i = 0; i < s->net.n; i++) {
        const struct net_node *p = &s->net.node[i];
        double volume;

        if (sheet_number(&s->nodes, i, VOLUME, 0, 1e15, 0, &volume, &why) != SW_OK ||
            !(volume > 0 && s->c.density > 0 && p->area == 0 && p->x[2] > 0))
            continue;
        sheet_fail(&why, &s->nodes, i,
                   "a float above the water keeps its whole buoyancy; has it a waterplane?");
        tell(why.text);
        found++;
    }
    return found;
}
