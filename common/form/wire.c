/* A structure of curved wires from its tables. */
#include "form/wire.h"
#include "form/cable.h"
#include "form/wiretables.h"
#include "num/mem.h"
#include "num/pi.h"
#include "num/vec3.h"
#include "phys/divide.h"
#include "sys/in.h"

#include <stddef.h>
#include <stdlib.h>

#define AT(member) offsetof(struct wire_case, member)

static const struct key keys[] = {
    {"tables", "nodes", TEXT, AT(nodes), 1, 1, 0, 0, NULL, "nodes.csv"},
    {"tables", "elements", TEXT, AT(elements), 1, 1, 0, 0, NULL, "elements.csv"},
    {"tables", "sections", TEXT, AT(sections), 1, 1, 0, 0, NULL, "sections.csv"},
    {"tables", "supports", TEXT, AT(supports), 1, 1, 0, 0, NULL, NULL},
    {"tables", "loads", TEXT, AT(loads), 1, 1, 0, 0, NULL, NULL},
    {"tables", "springs", TEXT, AT(springs), 1, 1, 0, 0, NULL, NULL},
    {"gravity", "acceleration", NUMBERS, AT(gravity), 3, 3, -1e6, 1e6, NULL, "0 0 0"},
    {"solve", "method", WORD, AT(method), 1, 1, 0, 0, "equilibrium linear updated", "equilibrium"},
    {"solve", "path", WORD, AT(path), 1, 1, 0, 0, "load arc", "load"},
    {"solve", "steps", WHOLE, AT(steps), 1, 1, 1, 1e6, NULL, "5"},
    {"solve", "most_steps", WHOLE, AT(most_steps), 1, 1, 1, 1e7, NULL, "1000"},
    {"solve", "iterations", WHOLE, AT(iterations), 1, 1, 1, 1000, NULL, "20"},
    {"solve", "tolerance", NUMBERS, AT(tolerance), 1, 1, 1e-14, 1e-3, NULL, "1e-10"},
    {"solve", "element_loads", WORD, AT(lumped), 1, 1, 0, 0, "consistent lumped", "consistent"},
    {"solve", "critical", WORD, AT(critical), 1, 1, 0, 0, "no yes", "no"},
    {"solve", "divide", WORD, AT(divide), 1, 1, 0, 0, "no yes", "yes"},
    {"solve", "largest_angle", NUMBERS, AT(largest_angle), 1, 1, 0.1, 85, NULL, "30"},
    {"solve", "watch", TEXT, AT(watch), 1, 1, 0, 0, NULL, NULL},
    {"output", "points", WHOLE, AT(points), 1, 1, 2, 10000, NULL, "5"},
};
#define N_KEYS ((int)(sizeof keys / sizeof *keys))

static enum status take_keys(const struct reading *r, struct wire_case *c)
{
    enum status s = keys_judge_names(r);

    for (int i = 0; i < N_KEYS && s == SW_OK; i++)
        if (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0)
            s = keys_take(r, keys[i].section, c);
    return s;
}

enum status wire_case_load(const char *path, const struct opt_list *sets, struct wire_case *ret,
                           struct why *why)
{
    struct ini ini = {0};
    // cppcheck-suppress ctuuninitvar  // why is to be filled
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

void wire_case_print(const struct wire_case *c, struct out *o)
{
    for (int i = 0; i < N_KEYS; i++)
        if (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0)
            keys_print(keys, N_KEYS, keys[i].section, c, o);
}

static enum status take_nodes(struct wire *p, struct why *why)
{
    enum status s = SW_OK;

    p->frame.n = p->nodes.n;
    p->frame.node = mem_zeroed((size_t)p->frame.n, sizeof *p->frame.node);
    if (!p->frame.node)
        return fail_plain(why, SW_NOMEM);
    for (int i = 0; i < p->frame.n; i++)
        for (int c = 0; c < 3 && s == SW_OK; c++)
            s = sheet_number(&p->nodes, i, NODE_X + c, -1e9, 1e9, NAN, &p->frame.node[i].x[c], why);
    return s;
}

/* The section frame of a tangent whose first axis is the part of `axis` that is normal to it. */
static enum status frame_of_axis(const struct sheet *t, int row, const double tangent[3],
                                 const double axis[3], double A[9], struct why *why)
{
    double along = vec3_dot(tangent, axis);

    for (int c = 0; c < 3; c++) {
        A[c] = axis[c] - along * tangent[c];
        A[6 + c] = tangent[c];
    }
    if (!(vec3_length(A) > 1e-6))
        return sheet_fail(why, t, row, "the section axis lies along the tangent");
    vec3_scale(1 / vec3_length(A), A);
    vec3_cross(A + 6, A, A + 3);
    return SW_OK;
}

/* The frame of one end from its cells; B: axes of the chord. */
static enum status take_end(const struct sheet *t, int row, int end, const double B[9],
                            double psi_default, struct station *to, double *ret_psi,
                            struct why *why)
{
    double tangent[3] = {B[6], B[7], B[8]}, axis[3], local[3], C[9], psi;
    int given, column = end == 0 ? PSI_A : PSI_B;
    enum status s = wire_direction(t, row, TANGENT + 3 * end, tangent, &given, why);

    if (s == SW_OK)
        s = wire_direction(t, row, AXIS + 3 * end, axis, &given, why);
    if (s == SW_OK && given && sheet_text(t, row, column)[0] != '\0')
        return sheet_fail(why, t, row, "give either psi or the section axis of an end");
    if (s == SW_OK)
        s = sheet_number(t, row, column, -1e6, 1e6, psi_default * 180 / PI, &psi, why);
    if (s != SW_OK)
        return s;
    *ret_psi = given ? NAN : psi * PI / 180;
    if (given)
        return frame_of_axis(t, row, tangent, axis, to->A, why);
    mat3_apply(B, tangent, local);
    if (!(local[2] > -0.999999))
        return sheet_fail(why, t, row, "the tangent of end %c points straight back", "ab"[end]);
    bow_frame(local, psi * PI / 180, C);
    mat3_multiply(C, B, to->A);
    return SW_OK;
}

/* Both ends of a row, with the twist between them. */
static enum status take_ends(const struct wire *p, int row, const struct frame_beam *beam,
                             struct station ends[2], struct why *why)
{
    const struct sheet *t = &p->elements;
    double e[3], B[9], psi[2], middle;
    struct bow bow;
    enum status s = SW_OK;

    for (int c = 0; c < 3; c++) {
        ends[0].x[c] = p->frame.node[beam->a].x[c];
        ends[1].x[c] = p->frame.node[beam->b].x[c];
        e[c] = ends[1].x[c] - ends[0].x[c];
    }
    if (!(vec3_length(e) > 1e-9))
        return sheet_fail(why, t, row, "the nodes '%.60s' and '%.60s' are at one place",
                          wire_node(p, beam->a), wire_node(p, beam->b));
    vec3_scale(1 / vec3_length(e), e);
    bow_axes(e, B);
    for (int end = 0; end < 2 && s == SW_OK; end++)
        s = take_end(t, row, end, B, end == 1 && !isnan(psi[0]) ? psi[0] : 0, &ends[end], &psi[end],
                     why);
    if (s != SW_OK)
        return s;
    bow_between(ends[0].x, ends[1].x, ends[0].A, ends[1].A, 0, 0, &bow);
    ends[0].twist = isnan(psi[0]) || isnan(psi[1]) ? bow.psi[1] - bow.psi[0] : psi[1] - psi[0];
    s = sheet_number(t, row, PSI_MID, -1e6, 1e6, INFINITY, &middle, why);
    middle = middle * PI / 180 - (isnan(psi[0]) ? bow.psi[0] : psi[0]);
    ends[0].bulge = isinf(middle) ? 0 : middle - ends[0].twist / 2;
    return s;
}

/* Letters of released axes. */
static enum status take_hinge(const struct sheet *t, int row, int column, const double A[9],
                              struct hinge *to, struct why *why)
{
    const char *text = sheet_text(t, row, column);
    int seen = 0;

    for (const char *p = text; *p; p++) {
        const char *axis = strchr("xyt", *p);

        if (!axis || seen & 1 << (axis - "xyt"))
            return sheet_fail(why, t, row, "hinge '%.60s' is not made of x, y and t", text);
        seen |= 1 << (axis - "xyt");
    }
    for (int k = 0; k < 3; k++)
        if (seen & 1 << k) {
            if (to->n < 2)
                memcpy(to->axis[to->n], A + 3 * k, 3 * sizeof *A);
            to->n++;
        }
    return SW_OK;
}

/* Room for n more nodes and beams. */
static enum status make_room(struct wire *p, int n, int *room, struct why *why)
{
    struct frame *f = &p->frame;
    void *more;

    if (f->beams + n <= *room)
        return SW_OK;
    *room = 2 * (f->beams + n);
    more = mem_resize(f->beam, (size_t)*room, sizeof *f->beam);
    if (more)
        f->beam = more;
    if (more)
        more = mem_resize(p->piece, (size_t)*room, sizeof *p->piece);
    if (more)
        p->piece = more;
    if (more)
        more = mem_resize(f->node, (size_t)(p->nodes.n + *room), sizeof *f->node);
    if (more)
        f->node = more;
    return more ? SW_OK : fail_plain(why, SW_NOMEM);
}

/* The pieces of a row between stations, n of them. */
static enum status add_pieces(struct wire *p, int row, const struct frame_beam *whole,
                              const struct station *at, int n, struct why *why)
{
    struct frame *f = &p->frame;
    double s = 0;

    for (int k = 0; k < n; k++) {
        struct frame_beam *beam = &f->beam[f->beams];
        struct bow bow;
        double angle =
            bow_between(at[k].x, at[k + 1].x, at[k].A, at[k + 1].A, at[k].twist, at[k].bulge, &bow);

        *beam = (struct frame_beam){.a = whole->a, .b = whole->b, .section = whole->section};
        if (k > 0)
            beam->a = f->n - 1;
        if (k < n - 1) {
            beam->b = f->n;
            f->node[f->n] = (struct frame_node){.held = 0};
            memcpy(f->node[f->n++].x, at[k + 1].x, sizeof at->x);
        }
        memcpy(beam->A[0], at[k].A, sizeof at->A);
        memcpy(beam->A[1], at[k + 1].A, sizeof at->A);
        if (k == 0)
            beam->hinge[0] = whole->hinge[0];
        if (k == n - 1)
            beam->hinge[1] = whole->hinge[1];
        if (!(angle < PI / 2) || beam_new(&bow, beam->section, &beam->beam) != SW_OK)
            return sheet_fail(why, &p->elements, row, "the element has no stiffness");
        p->piece[f->beams++] = (struct wire_piece){row, s};
        s += beam->beam.length;
    }
    return SW_OK;
}

static enum status take_element(struct wire *p, int row, const struct wire_names *nodes,
                                const struct wire_names *sections, struct station *at, int *room,
                                struct why *why)
{
    const struct sheet *t = &p->elements;
    struct frame_beam whole = {.a = 0};
    struct station ends[2] = {{.twist = 0}};
    struct bow bow;
    double angle;
    int section = 0, n = 1;
    enum status s = wire_find(t, row, NODE_A, "node", nodes, &whole.a, why);

    if (s == SW_OK)
        s = wire_find(t, row, NODE_B, "node", nodes, &whole.b, why);
    if (s == SW_OK)
        s = wire_find(t, row, SECTION_OF, "section", sections, &section, why);
    if (s == SW_OK)
        s = take_ends(p, row, &whole, ends, why);
    for (int end = 0; end < 2 && s == SW_OK; end++)
        s = take_hinge(t, row, HINGE_A + end, ends[end].A, &whole.hinge[end], why);
    if (s != SW_OK)
        return s;
    whole.section = &p->section[section];
    angle = bow_between(ends[0].x, ends[1].x, ends[0].A, ends[1].A, ends[0].twist, 0, &bow);
    at[0] = ends[0];
    at[1] = ends[1];
    if (p->c.divide)
        n = divide(&ends[0], &ends[1], p->c.largest_angle * PI / 180, at);
    else if (!(angle <= p->c.largest_angle * PI / 180))
        n = 0;
    if (n == 0)
        return sheet_fail(why, t, row,
                          "its end tangent is %.4g degrees off the chord, more than %s %g: "
                          "divide the element",
                          angle * 180 / PI, p->c.divide ? "can be divided down to" : "the",
                          p->c.largest_angle);
    s = make_room(p, n, room, why);
    return s == SW_OK ? add_pieces(p, row, &whole, at, n, why) : s;
}

static enum status take_elements(struct wire *p, const struct wire_names *nodes,
                                 const struct wire_names *sections, struct why *why)
{
    struct station *at = mem_zeroed(DIVIDE_MOST + 1, sizeof *at);
    int room = 0;
    enum status s = at ? SW_OK : fail_plain(why, SW_NOMEM);

    for (int i = 0; i < p->elements.n && s == SW_OK; i++)
        s = take_element(p, i, nodes, sections, at, &room, why);
    if (s == SW_OK && p->frame.beams == 0)
        s = fail(why, SW_FORMAT, "%.400s: has no elements", p->elements.name);
    free(at);
    return s;
}

/* A node that nothing is tied to would drift. */
static enum status judge_nodes(const struct wire *p, struct why *why)
{
    char *tied = mem_zeroed((size_t)p->frame.n, 1);
    enum status s = tied ? SW_OK : fail_plain(why, SW_NOMEM);

    for (int i = 0; i < p->frame.beams && tied; i++)
        tied[p->frame.beam[i].a] = tied[p->frame.beam[i].b] = 1;
    for (int i = 0; i < p->frame.springs && tied; i++)
        tied[p->frame.spring[i].a] = 1;
    for (int i = 0; i < p->nodes.n && s == SW_OK; i++)
        if (!tied[i] && p->frame.node[i].held != 63)
            s = sheet_fail(why, &p->nodes, i, "no element leads to node '%.60s'", wire_node(p, i));
    free(tied);
    return s;
}

static enum status read_tables(const char *path, struct wire *p, struct why *why)
{
    const struct wire_case *c = &p->c;
    const struct {
        const char *name;
        const struct sheet_column *column;
        int n;
        struct sheet *to;
    } table[] = {{c->nodes, wire_node_column, N_NODE, &p->nodes},
                 {c->elements, wire_element_column, N_ELEMENT, &p->elements},
                 {c->sections, wire_section_column, N_SECTION, &p->sections},
                 {c->supports, wire_support_column, N_SUPPORT, &p->supports},
                 {c->loads, wire_load_column, N_LOAD, &p->loads},
                 {c->springs, wire_spring_column, N_SPRING, &p->springs}};
    enum status s = SW_OK;

    for (size_t k = 0; k < sizeof table / sizeof *table && s == SW_OK; k++)
        if (table[k].name[0] != '\0')
            s = sheet_read(table[k].name, path, table[k].column, table[k].n, table[k].to, why);
    return s;
}

static enum status take_tables(struct wire *p, struct wire_names index[3], struct why *why)
{
    enum status s = wire_names_new(&p->nodes, &index[0], why);

    if (s == SW_OK)
        s = wire_names_new(&p->sections, &index[1], why);
    if (s == SW_OK)
        s = wire_names_new(&p->elements, &index[2], why);
    if (s == SW_OK)
        s = wire_take_sections(p, why);
    if (s == SW_OK)
        s = take_nodes(p, why);
    if (s == SW_OK)
        s = take_elements(p, &index[0], &index[1], why);
    if (s == SW_OK && p->supports.n > 0)
        s = wire_take_supports(p, &index[0], why);
    if (s == SW_OK && p->springs.n > 0)
        s = wire_take_springs(p, &index[0], why);
    if (s == SW_OK)
        s = wire_take_loads(p, &index[0], &index[2], why);
    return s == SW_OK ? judge_nodes(p, why) : s;
}

enum status wire_load(const char *path, const struct wire_case *c, struct wire *ret,
                      struct why *why)
{
    struct wire_names index[3] = {{.index = {NULL, 0}}};
    enum status s;

    *ret = (struct wire){.c = *c, .frame.stages = 1, .frame.lumped = c->lumped, .watch = -1};
    s = read_tables(path, ret, why);
    if (s == SW_OK)
        s = take_tables(ret, index, why);
    if (s == SW_OK && c->watch[0] != '\0') {
        ret->watch = roll_find(&index[0].roll, &index[0].index, c->watch);
        if (ret->watch < 0)
            s = fail(why, SW_FORMAT, "[solve] watch: there is no node '%.60s'", c->watch);
    }
    for (int i = 0; i < 3; i++)
        wire_names_free(&index[i]);
    if (s != SW_OK)
        wire_free(ret);
    return s;
}

void wire_free(struct wire *p)
{
    free(p->section);
    free(p->piece);
    free(p->frame.node);
    free(p->frame.beam);
    free(p->frame.spring);
    free(p->frame.load);
    sheet_free(&p->nodes);
    sheet_free(&p->elements);
    sheet_free(&p->sections);
    sheet_free(&p->supports);
    sheet_free(&p->loads);
    sheet_free(&p->springs);
    *p = (struct wire){.section = NULL};
}

const char *wire_node(const struct wire *p, int i)
{
    return i < p->nodes.n ? sheet_text(&p->nodes, i, NODE) : "";
}

const char *wire_element(const struct wire *p, int i)
{
    return sheet_text(&p->elements, i, ELEMENT);
}

void wire_name_keys(FILE *f)
{
    keys_name(keys, N_KEYS, f);
}
