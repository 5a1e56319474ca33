/* What a mooring deck can say of a system. */
#include "form/decksay.h"
#include "num/pi.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* A vessel without weight and buoyancy is what a deck has without a row for it. */
static int is_vessel(const struct system *p, int b)
{
    return strcmp(roll_name(&p->bodies, b), "vessel") == 0 && p->body[b].mass == 0 &&
           p->body[b].volume == 0 && p->net.body[b].held;
}

int say_body_number(const struct system *p, int b)
{
    int n = 0;

    for (int i = 0; i <= b; i++)
        n += !is_vessel(p, i);
    return is_vessel(p, b) ? 0 : n;
}

/* R = Rx Ry Rz, each about an axis that the ones before it have turned. */
void say_body_place(const struct system *p, const struct net_state *s, int b, double x[3],
                    double angle[3])
{
    const struct net_body *body = &p->net.body[b];
    const double *R = body->R;

    (void)s;
    memcpy(x, body->x, 3 * sizeof *x);
    angle[0] = atan2(-R[5], R[8]) * 180 / PI;
    angle[1] = atan2(R[2], hypot(R[5], R[8])) * 180 / PI;
    angle[2] = atan2(-R[1], R[0]) * 180 / PI;
}

void say_load(const struct system *p, int i, double *ret_mass, double *ret_volume)
{
    double pull = p->node[i].pull[2];

    *ret_mass = p->node[i].mass - (pull < 0 ? pull / p->c.gravity : 0);
    *ret_volume = p->node[i].volume + (pull > 0 ? pull / (p->c.gravity * p->c.density) : 0);
}

double say_depth(const struct system *p, const struct net_state *s)
{
    double lowest = 0;

    if (p->sea.bed.kind == BED_PLANE)
        return -p->sea.bed.level;
    for (int r = 0; r < p->net.m; r++) {
        double ta[3], tb[3];

        net_ends(&p->net, s, r, ta, tb);
        lowest =
            fmin(lowest, s->x[3 * p->net.rope[r].a + 2] + rope_lowest(&p->net.rope[r].rope, ta));
    }
    return ceil(fmax(1, -2 * lowest));
}

double say_friction(const struct system *p)
{
    double friction = p->net.m > 0 ? p->net.rope[0].friction : 0;

    for (int r = 1; r < p->net.m; r++)
        if (p->net.rope[r].friction != friction)
            return NAN;
    return friction;
}

__attribute__((format(printf, 3, 4))) static enum status refuse(struct why *why, const char *name,
                                                                const char *format, ...)
{
    char text[200];
    va_list list;

    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return fail(why, SW_ADMISSIBLE, "no deck can say this: %.200s '%.60s'", text, name);
}

static enum status judge_sea(const struct system *p, struct why *why)
{
    const struct bed *bed = &p->sea.bed;

    if (bed->kind == BED_GRID)
        return fail(why, SW_ADMISSIBLE, "no deck can say this: a bed of given points");
    if (bed->kind == BED_PLANE && (bed->slope[0] != 0 || bed->slope[1] != 0))
        return fail(why, SW_ADMISSIBLE, "no deck can say this: a bed that slopes");
    if (bed->kind == BED_PLANE && isnan(say_friction(p)))
        return fail(why, SW_ADMISSIBLE,
                    "no deck can say this: friction that differs between lines");
    if (!(p->c.gravity > 0))
        return fail(why, SW_ADMISSIBLE, "no deck can say this: a system without gravity");
    return SW_OK;
}

static enum status judge_node(const struct system *p, int i, struct why *why)
{
    const struct net_node *node = &p->net.node[i];
    const char *name = system_node(p, i);

    for (int k = 0; k < SYM; k++)
        if (node->K[k] != 0)
            return refuse(why, name, "the spring of node");
    if (node->area > 0)
        return refuse(why, name, "the waterplane of node");
    if (node->held != 0 && node->held != 7)
        return refuse(why, name, "some directions are held of node");
    if (p->node[i].pull[0] != 0 || p->node[i].pull[1] != 0)
        return refuse(why, name, "a horizontal force on node");
    if (p->node[i].pull[2] > 0 && !(p->c.density > 0))
        return refuse(why, name, "an upward force without water on node");
    return SW_OK;
}

static enum status judge_rope(const struct system *p, int r, struct why *why)
{
    const struct rope *rope = &p->net.rope[r].rope;

    if (rope->law.n > 0)
        return refuse(why, roll_name(&p->types, p->type_of[r]), "the tension table of type");
    if (rope->elements == 1)
        return refuse(why, system_rope(p, r), "a bar, rope");
    if ((rope->elements > 0) != (p->net.rope[0].rope.elements > 0))
        return refuse(why, system_rope(p, r), "chains beside continuous ropes, rope");
    return SW_OK;
}

static enum status judge_body(const struct system *p, int b, struct why *why)
{
    const struct net_body *body = &p->net.body[b];
    const char *name = roll_name(&p->bodies, b);

    if (body->area > 0)
        return refuse(why, name, "the waterplane of body");
    if (p->body[b].volume > 0 && (body->cb[0] != 0 || body->cb[1] != 0 || body->cb[2] != 0))
        return refuse(why, name, "a centre of buoyancy beside the origin, body");
    return SW_OK;
}

enum status say_judge(const struct system *p, struct why *why)
{
    enum status s = judge_sea(p, why);

    for (int b = 0; b < p->bodies.n && s == SW_OK; b++)
        s = judge_body(p, b, why);
    for (int i = 0; i < p->nodes.n && s == SW_OK; i++)
        s = judge_node(p, i, why);
    for (int r = 0; r < p->ropes.n && s == SW_OK; r++)
        s = judge_rope(p, r, why);
    return s;
}
