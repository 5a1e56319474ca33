/* Rows of the tables of wirebeam. */
#include "form/wiretables.h"
#include "num/mem.h"
#include "num/vec3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct sheet_column wire_node_column[N_NODE] = {{"node", 1},
                                                      {"x_m", 1},
                                                      {"y_m", 1},
                                                      {"z_m", 1}};

const struct sheet_column wire_element_column[N_ELEMENT] = {
    {"element", 1}, {"node_a", 1},    {"node_b", 1},    {"section", 1},     {"tax", 0},
    {"tay", 0},     {"taz", 0},       {"tbx", 0},       {"tby", 0},         {"tbz", 0},
    {"xax", 0},     {"xay", 0},       {"xaz", 0},       {"xbx", 0},         {"xby", 0},
    {"xbz", 0},     {"psi_a_deg", 0}, {"psi_b_deg", 0}, {"psi_mid_deg", 0}, {"hinge_a", 0},
    {"hinge_b", 0}};

const struct sheet_column wire_support_column[N_SUPPORT] = {{"node", 1}, {"ux", 0},   {"uy", 0},
                                                            {"uz", 0},   {"rx", 0},   {"ry", 0},
                                                            {"rz", 0},   {"stage", 0}};

const struct sheet_column wire_load_column[N_LOAD] = {{"node", 0},   {"fx_N", 0},    {"fy_N", 0},
                                                      {"fz_N", 0},   {"mx_Nm", 0},   {"my_Nm", 0},
                                                      {"mz_Nm", 0},  {"element", 0}, {"qx_N_m", 0},
                                                      {"qy_N_m", 0}, {"qz_N_m", 0},  {"stage", 0}};

const struct sheet_column wire_spring_column[N_SPRING] = {
    {"spring", 1}, {"node_a", 1}, {"node_b", 0}, {"kx_N_m", 0}, {"ky_N_m", 0}, {"kz_N_m", 0},
    {"krx_Nm", 0}, {"kry_Nm", 0}, {"krz_Nm", 0}, {"xx", 0},     {"xy", 0},     {"xz", 0}};

enum status wire_names_new(const struct sheet *s, struct wire_names *ret, struct why *why)
{
    enum status status = sheet_roll(s, 0, &ret->roll, why);

    return status == SW_OK ? roll_sort(&ret->roll, &ret->index, why) : status;
}

void wire_names_free(struct wire_names *n)
{
    free(n->index.at);
    roll_free(&n->roll);
}

enum status wire_find(const struct sheet *from, int row, int column, const char *kind,
                      const struct wire_names *in, int *ret, struct why *why)
{
    *ret = roll_find(&in->roll, &in->index, sheet_text(from, row, column));
    return *ret >= 0 ? SW_OK
                     : sheet_fail(why, from, row, "there is no %s '%.60s'", kind,
                                  sheet_text(from, row, column));
}

enum status wire_direction(const struct sheet *t, int row, int column, double ret[3],
                           int *ret_given, struct why *why)
{
    int given = 0;
    enum status s = SW_OK;

    for (int c = 0; c < 3; c++)
        given += sheet_text(t, row, column + c)[0] != '\0';
    *ret_given = given == 3;
    if (given == 0)
        return SW_OK;
    if (given < 3)
        return sheet_fail(why, t, row, "a direction needs all of its three numbers");
    for (int c = 0; c < 3 && s == SW_OK; c++)
        s = sheet_number(t, row, column + c, -1e6, 1e6, NAN, &ret[c], why);
    if (s == SW_OK && !(vec3_length(ret) > 1e-6))
        s = sheet_fail(why, t, row, "a direction is zero");
    if (s == SW_OK)
        vec3_scale(1 / vec3_length(ret), ret);
    return s;
}

/* A stage, 1 where the cell is empty; the frame has as many as the last one. */
static enum status take_stage(struct wire *p, const struct sheet *t, int row, int column, int *ret,
                              struct why *why)
{
    double stage;
    enum status s = sheet_number(t, row, column, 1, 1000, 1, &stage, why);

    if (s == SW_OK && stage != floor(stage))
        s = sheet_fail(why, t, row, "stage must be a whole number");
    *ret = s == SW_OK ? (int)stage : 1;
    if (*ret > p->frame.stages)
        p->frame.stages = *ret;
    return s;
}

/* Rows of one node hold what their cells say; no direction twice. */
static enum status take_support(struct wire *p, int row, const struct wire_names *nodes,
                                struct why *why)
{
    const struct sheet *t = &p->supports;
    struct frame_node *to;
    int node, stage;
    enum status s = wire_find(t, row, HELD, "node", nodes, &node, why);

    if (s == SW_OK)
        s = take_stage(p, t, row, HELD_STAGE, &stage, why);
    for (int c = 0; c < 6 && s == SW_OK; c++) {
        if (sheet_text(t, row, HELD_U + c)[0] == '\0')
            continue;
        to = &p->frame.node[node];
        if (to->held & 1 << c)
            return sheet_fail(why, t, row, "%s of node '%.60s' is held already",
                              wire_support_column[HELD_U + c].name, wire_node(p, node));
        s = sheet_number(t, row, HELD_U + c, -1e6, 1e6, NAN, &to->given[c], why);
        to->held |= 1 << c;
        to->stage[c] = stage;
        p->moved |= to->given[c] != 0;
    }
    return s;
}

enum status wire_take_supports(struct wire *p, const struct wire_names *nodes, struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i < p->supports.n && s == SW_OK; i++)
        s = take_support(p, i, nodes, why);
    return s;
}

/* Axes: global ones, or x as given, then y level, z. */
static enum status take_axes(const struct sheet *t, int row, double B[9], struct why *why)
{
    double x[3] = {1, 0, 0}, chord[9];
    int given;
    enum status s = wire_direction(t, row, SPRING_AXIS, x, &given, why);

    memset(B, 0, 9 * sizeof *B);
    B[0] = B[4] = B[8] = 1;
    if (s != SW_OK || !given)
        return s;
    bow_axes(x, chord); /* third row: x */
    memcpy(B, chord + 6, 3 * sizeof *B);
    memcpy(B + 3, chord, 6 * sizeof *B);
    return SW_OK;
}

static enum status take_spring(struct wire *p, int row, const struct wire_names *nodes,
                               struct frame_spring *to, struct why *why)
{
    const struct sheet *t = &p->springs;
    enum status s = wire_find(t, row, SPRING_A, "node", nodes, &to->a, why);

    to->b = -1;
    if (s == SW_OK && sheet_text(t, row, SPRING_B)[0] != '\0')
        s = wire_find(t, row, SPRING_B, "node", nodes, &to->b, why);
    if (s == SW_OK && to->a == to->b)
        s = sheet_fail(why, t, row, "both ends are node '%.60s'", wire_node(p, to->a));
    for (int c = 0; c < 6 && s == SW_OK; c++)
        s = sheet_number(t, row, SPRING_K + c, 0, WIRE_BIG, 0, &to->k[c], why);
    return s == SW_OK ? take_axes(t, row, to->B, why) : s;
}

enum status wire_take_springs(struct wire *p, const struct wire_names *nodes, struct why *why)
{
    struct wire_names names = {.index = {NULL, 0}};
    enum status s = wire_names_new(&p->springs, &names, why);

    wire_names_free(&names);
    p->frame.spring = mem_zeroed((size_t)p->springs.n, sizeof *p->frame.spring);
    if (s == SW_OK && !p->frame.spring)
        s = fail_plain(why, SW_NOMEM);
    for (int i = 0; i < p->springs.n && s == SW_OK; i++)
        s = take_spring(p, i, nodes, &p->frame.spring[p->frame.springs++], why);
    return s;
}

/* The pieces of an element, beams first to end - 1. */
static void pieces_of(const struct wire *p, int element, int *first, int *end)
{
    int low = 0, high = p->frame.beams;

    while (low < high) { /* pieces stand in the order of the elements */
        int middle = low + (high - low) / 2;

        if (p->piece[middle].element < element)
            low = middle + 1;
        else
            high = middle;
    }
    *first = low;
    for (*end = low; *end < p->frame.beams && p->piece[*end].element == element;)
        ++*end;
}

static enum status add_load(struct wire *p, const struct frame_load *load, struct why *why)
{
    int n = p->frame.loads;

    if ((n & (n - 1)) == 0) { /* full at powers of two */
        struct frame_load *more =
            mem_resize(p->frame.load, n > 0 ? 2 * (size_t)n : 1, sizeof *more);

        if (!more)
            return fail_plain(why, SW_NOMEM);
        p->frame.load = more;
    }
    p->frame.load[p->frame.loads++] = *load;
    for (int c = 0; c < 6; c++)
        p->moved |= load->value[c] != 0;
    return SW_OK;
}

static enum status add_element_load(struct wire *p, int element, const double q[3], int stage,
                                    struct why *why)
{
    struct frame_load load = {.node = -1, .value = {q[0], q[1], q[2]}, .stage = stage};
    int end;
    enum status s = SW_OK;

    for (pieces_of(p, element, &load.beam, &end); load.beam < end && s == SW_OK; load.beam++)
        s = add_load(p, &load, why);
    return s;
}

static enum status take_load(struct wire *p, int row, const struct wire_names *nodes,
                             const struct wire_names *elements, struct why *why)
{
    const struct sheet *t = &p->loads;
    int of_node = sheet_text(t, row, LOAD_NODE)[0] != '\0', at = 0;
    int first = of_node ? LOAD_F : LOAD_Q, n = of_node ? 6 : 3;
    int other = of_node ? LOAD_Q : LOAD_F, others = of_node ? 3 : 6;
    struct frame_load load = {.node = -1, .beam = -1};
    enum status s;

    if (of_node == (sheet_text(t, row, LOAD_ELEMENT)[0] != '\0'))
        return sheet_fail(why, t, row, "a load needs either a node or an element");
    for (int c = 0; c < others; c++)
        if (sheet_text(t, row, other + c)[0] != '\0')
            return sheet_fail(why, t, row, "%s does not belong to a load of %s",
                              wire_load_column[other + c].name, of_node ? "a node" : "an element");
    s = of_node ? wire_find(t, row, LOAD_NODE, "node", nodes, &at, why)
                : wire_find(t, row, LOAD_ELEMENT, "element", elements, &at, why);
    for (int c = 0; c < n && s == SW_OK; c++)
        s = sheet_number(t, row, first + c, -WIRE_BIG, WIRE_BIG, 0, &load.value[c], why);
    if (s == SW_OK)
        s = take_stage(p, t, row, LOAD_STAGE, &load.stage, why);
    if (s != SW_OK)
        return s;
    load.node = at;
    return of_node ? add_load(p, &load, why) : add_element_load(p, at, load.value, load.stage, why);
}

enum status wire_take_loads(struct wire *p, const struct wire_names *nodes,
                            const struct wire_names *elements, struct why *why)
{
    const double *g = p->c.gravity;
    enum status s = SW_OK;

    for (int i = 0; i < p->loads.n && s == SW_OK; i++)
        s = take_load(p, i, nodes, elements, why);
    for (int i = 0; i < p->frame.beams && s == SW_OK; i++) {
        double mass = p->frame.beam[i].section->mass;
        const struct frame_load weight = {.node = -1,
                                          .beam = i,
                                          .value = {mass * g[0], mass * g[1], mass * g[2]},
                                          .stage = 1};

        if (mass > 0 && (g[0] != 0 || g[1] != 0 || g[2] != 0))
            s = add_load(p, &weight, why);
    }
    return s;
}
