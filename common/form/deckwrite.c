/*
 * Mooring decks written, in the form of MoorDyn v2, with the positions that were found.
 *
 * What such a deck cannot say is refused before anything is written.  Numbers of nodes, lines and
 * bodies count from 1; names stand behind their rows.
 */
#include "form/deck.h"
#include "form/decksay.h"

#include <math.h>
#include <string.h>

static void cells(const double *x, int n, struct out *o)
{
    for (int i = 0; i < n; i++) {
        putc(' ', o->f);
        out_number(o, x[i]);
    }
}

/* The name of item i behind its row, where its number does not say it. */
static void remark(const struct roll *r, int i, struct out *o)
{
    char number[16];

    snprintf(number, sizeof number, "%d", i + 1);
    if (strcmp(number, roll_name(r, i)) != 0)
        fprintf(o->f, " # %s", roll_name(r, i));
    putc('\n', o->f);
}

static void heading(const char *name, const char *columns, const char *units, struct out *o)
{
    fprintf(o->f, "---------------------- %s ----------------------\n%s\n%s\n", name, columns,
            units);
}

/* The name of a type as one word that no reader takes for something else. */
static void type_name(const struct system *p, int t, struct out *o)
{
    const char *name = roll_name(&p->types, t);

    if (name[strcspn(name, " \t\r\n\f\v#!%")] == '\0' && !strstr(name, "---"))
        fputs(name, o->f);
    else
        fprintf(o->f, "type%d", t + 1);
}

static void write_types(const struct system *p, struct out *o)
{
    heading("LINE TYPES", "TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx",
            "(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)", o);
    for (int t = 0; t < p->types.n; t++) {
        const struct system_type *type = &p->type[t];

        type_name(p, t, o);
        cells((const double[]){type->diameter, type->mass, type->law.EA, -1, 0, type->cd, 1,
                               type->cd_axial, 0},
              9, o);
        if (isfinite(type->breaking)) {
            fputs(" # breaks at N:", o->f);
            cells(&type->breaking, 1, o);
        }
        putc('\n', o->f);
    }
}

static void write_bodies(const struct system *p, const struct net_state *s, struct out *o)
{
    int n = 0;

    for (int b = 0; b < p->bodies.n; b++) {
        const struct net_body *body = &p->net.body[b];
        double x[3], angle[3];

        if (say_body_number(p, b) == 0)
            continue;
        if (n++ == 0)
            heading("BODIES", "ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca",
                    "(#) (word) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)",
                    o);
        say_body_place(p, s, b, x, angle);
        fprintf(o->f, "%d %s", n, body->held ? "Coupled" : "Free");
        cells(x, 3, o);
        cells(angle, 3, o);
        cells(&p->body[b].mass, 1, o);
        for (int c = 0; c < 3; c++) {
            putc(" ||"[c], o -> f);
            out_number(o, body->cg[c]);
        }
        fputs(" 0", o->f);
        cells(&p->body[b].volume, 1, o);
        fprintf(o->f, " 0 0 # %s\n", roll_name(&p->bodies, b));
    }
}

static void write_points(const struct system *p, const struct net_state *s, struct out *o)
{
    heading("POINTS", "ID Attachment X Y Z Mass Volume CdA Ca",
            "(#) (word) (m) (m) (m) (kg) (m^3) (m^2) (-)", o);
    for (int i = 0; i < p->nodes.n; i++) {
        const struct net_node *node = &p->net.node[i];
        int body = node->body > 0 ? say_body_number(p, node->body - 1) : 0;
        double mass, volume;

        fprintf(o->f, "%d ", i + 1);
        if (body > 0)
            fprintf(o->f, "Body%d", body);
        else
            fputs(node->body > 0 ? "Coupled" : node->held ? "Fixed" : "Free", o->f);
        cells(body > 0 ? node->arm : s->x + 3 * i, 3, o);
        say_load(p, i, &mass, &volume);
        cells((const double[]){mass, volume, p->node[i].cda, 0}, 4, o);
        remark(&p->nodes, i, o);
    }
}

static void write_lines(const struct system *p, struct out *o)
{
    heading("LINES", "ID LineType AttachA AttachB UnstrLen NumSegs Outputs",
            "(#) (name) (#) (#) (m) (-) (-)", o);
    for (int r = 0; r < p->ropes.n; r++) {
        const struct net_rope *rope = &p->net.rope[r];
        int said = p->segments[r] > 0 ? p->segments[r] : p->c.elements;
        int n = rope->rope.elements > 0 ? rope->rope.elements : said;

        fprintf(o->f, "%d ", r + 1);
        type_name(p, p->type_of[r], o);
        fprintf(o->f, " %d %d", rope->a + 1, rope->b + 1);
        cells(&rope->rope.L0, 1, o);
        fprintf(o->f, " %d -", n);
        remark(&p->ropes, r, o);
    }
}

static void write_options(const struct system *p, const struct net_state *s, struct out *o)
{
    double depth = say_depth(p, s), friction = say_friction(p);

    fputs("---------------------- OPTIONS ----------------------\n", o->f);
    out_number(o, p->c.gravity);
    fputs(" g\n", o->f);
    out_number(o, p->c.density);
    fputs(" rho\n", o->f);
    out_number(o, depth);
    fprintf(o->f, " WtrDpth%s\n", p->sea.bed.kind == BED_NONE ? " # no bed: below all lines" : "");
    if (friction > 0) {
        out_number(o, friction);
        fputs(" FrictionCoefficient\n", o->f);
        out_number(o, friction);
        fputs(" bed_friction # what statics takes\n", o->f);
    }
    fputs("---------------------- need this line ----------------------\n", o->f);
}

enum status deck_write(const struct system *p, const struct net_state *s, struct out *o,
                       struct why *why)
{
    enum status status = say_judge(p, why);

    if (status != SW_OK)
        return status;
    fputs("---------------------- MoorDyn v2 input ----------------------\n"
          "Written by gapnet " SEILWERK_VERSION ": free points and bodies stand in equilibrium.\n"
          "What only dynamics needs is set to common values: BA, Ca, CaAx, I.\n",
          o->f);
    write_types(p, o);
    write_bodies(p, s, o);
    write_points(p, s, o);
    write_lines(p, o);
    write_options(p, s, o);
    return SW_OK;
}
