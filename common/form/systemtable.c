/* Nodes, ropes and loads from their tables. */
#include "form/systemtable.h"
#include "form/cable.h"
#include "num/mem.h"
#include "sys/in.h"
#include "sys/npy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* The body that carries node i: its number, 0: none. */
static enum status take_place(const struct sheet *t, int i, struct system *p, struct net_node *to,
                              struct why *why)
{
    const char *name = sheet_text(t, i, BODY);

    if (name[0] == '\0')
        return SW_OK;
    to->body = roll_search(&p->bodies, name, strlen(name)) + 1;
    if (to->body == 0)
        return sheet_fail(why, t, i, "there is no body '%.60s'", name);
    return to->held == 7 ? SW_OK : sheet_fail(why, t, i, "on a body its condition is fixed");
}

/* Whether a node that is fixed may leave it to the bed how high it is. */
static int stands(const struct system *p, const struct net_node *node)
{
    return node->held == 7 && node->body == 0 && (!isnan(p->c.depth) || p->c.bed[0] != '\0');
}

static enum status take_node(const struct sheet *t, int i, struct system *p, struct why *why)
{
    struct net_node *to = &p->net.node[i];
    struct system_node *said = &p->node[i];
    enum status s = take_condition(t, i, &to->held, why);

    if (s == SW_OK)
        s = take_place(t, i, p, to, why);
    for (int c = 0; c < 3 && s == SW_OK; c++) {
        s = sheet_number(t, i, X + c, -SYSTEM_BIG, SYSTEM_BIG, INFINITY, &to->x[c], why);
        if (s == SW_OK && isinf(to->x[c]) && to->held & 1 << c && !(c == 2 && stands(p, to)))
            s = sheet_fail(why, t, i, "a held node needs its coordinate");
        if (s == SW_OK && isinf(to->x[c]))
            to->x[c] = NAN;
    }
    if (s == SW_OK)
        s = sheet_number(t, i, NODE_MASS, 0, 1e15, 0, &said->mass, why);
    if (s == SW_OK)
        s = sheet_number(t, i, VOLUME, 0, 1e15, 0, &said->volume, why);
    if (s == SW_OK)
        s = sheet_number(t, i, CDA, 0, 1e15, 0, &said->cda, why);
    if (s == SW_OK)
        s = sheet_number(t, i, WATERPLANE, 0, 1e12, 0, &to->area, why);
    for (int c = 0; c < 3 && s == SW_OK; c++)
        s = sheet_number(t, i, FX + c, -1e18, 1e18, 0, &said->pull[c], why);
    return s == SW_OK ? take_spring(t, i, to, why) : s;
}

static enum status take_loads(const struct sheet *t, struct system *p,
                              const struct roll_index *nodes, struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i < t->n && s == SW_OK; i++) {
        int node = roll_find(&p->nodes, nodes, sheet_text(t, i, LOAD_NODE));

        if (node < 0)
            return sheet_fail(why, t, i, "there is no node '%.60s'", sheet_text(t, i, LOAD_NODE));
        for (int c = 0; c < 3 && s == SW_OK; c++) {
            double f;

            s = sheet_number(t, i, LOAD_X + c, -1e18, 1e18, NAN, &f, why);
            p->node[node].pull[c] += s == SW_OK ? f : 0;
        }
    }
    return s;
}

static enum status take_rope(const struct sheet *t, int r, struct system *p,
                             const struct roll_index *nodes, const struct roll_index *types,
                             struct why *why)
{
    struct net_rope *to = &p->net.rope[r];
    double given;
    enum status s;

    to->a = roll_find(&p->nodes, nodes, sheet_text(t, r, NODE_A));
    to->b = roll_find(&p->nodes, nodes, sheet_text(t, r, NODE_B));
    p->type_of[r] = roll_find(&p->types, types, sheet_text(t, r, ROPE_TYPE));
    if (to->a < 0 || to->b < 0)
        return sheet_fail(why, t, r, "there is no node '%.60s'",
                          sheet_text(t, r, to->a < 0 ? NODE_A : NODE_B));
    if (p->type_of[r] < 0)
        return sheet_fail(why, t, r, "there is no type '%.60s'", sheet_text(t, r, ROPE_TYPE));
    s = sheet_number(t, r, LENGTH, 1e-9, SYSTEM_BIG, NAN, &to->rope.L0, why);
    if (s == SW_OK)
        s = sheet_number(t, r, ELEMENTS, 1, 1e6, -1, &given, why);
    if (s == SW_OK && given != floor(given))
        s = sheet_fail(why, t, r, "elements must be a whole number");
    return s == SW_OK ? system_take_rope(p, r, (int)given, why) : s;
}

/* Everything into the rooms that are there, in the order in which one needs the other. */
static enum status take_all(const struct sheet *nodes, const struct sheet *ropes,
                            const struct sheet *loads, struct system *p, struct why *why)
{
    struct roll_index node = {NULL, 0}, type = {NULL, 0}, rope = {NULL, 0};
    enum status s = roll_sort(&p->nodes, &node, why);

    if (s == SW_OK)
        s = roll_sort(&p->types, &type, why);
    if (s == SW_OK)
        s = roll_sort(&p->ropes, &rope, why);
    for (int i = 0; i < nodes->n && s == SW_OK; i++)
        s = take_node(nodes, i, p, why);
    if (s == SW_OK)
        s = take_loads(loads, p, &node, why);
    for (int i = 0; i < p->nodes.n && s == SW_OK; i++)
        s = system_take_node(p, i, why);
    for (int r = 0; r < ropes->n && s == SW_OK; r++)
        s = take_rope(ropes, r, p, &node, &type, why);
    free(node.at);
    free(type.at);
    free(rope.at);
    return s;
}

enum status system_read_tables(const char *path, struct system *p, struct why *why)
{
    struct sheet nodes = {.n = 0}, ropes = {.n = 0}, loads = {.n = 0};
    enum status s = sheet_read(p->c.nodes, path, node_column, N_NODE, &nodes, why);

    if (s == SW_OK)
        s = system_read_types(path, p, why);
    if (s == SW_OK)
        s = sheet_read(p->c.ropes, path, rope_column, N_ROPE, &ropes, why);
    if (s == SW_OK && p->c.loads[0] != '\0')
        s = sheet_read(p->c.loads, path, load_column, N_LOAD, &loads, why);
    if (s == SW_OK && p->c.bodies[0] != '\0')
        s = system_read_bodies(path, p, why);
    if (s == SW_OK)
        s = sheet_roll(&nodes, NODE, &p->nodes, why);
    if (s == SW_OK)
        s = sheet_roll(&ropes, ROPE, &p->ropes, why);
    if (s == SW_OK)
        s = system_room(p, why);
    for (int i = 0; i < p->bodies.n && s == SW_OK; i++)
        s = system_take_body(p, i, why);
    if (s == SW_OK)
        s = take_all(&nodes, &ropes, &loads, p, why);
    sheet_free(&nodes);
    sheet_free(&ropes);
    sheet_free(&loads);
    return s;
}
