/* A system of ropes: from what its files say to what is computed. */
#include "form/system.h"
#include "form/deck.h"
#include "form/systemtable.h"
#include "num/mem.h"
#include "num/pi.h"
#include "num/vec3.h"
#include "phys/attitude.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define INSIDE 1e-6 /* m, and of the height: deeper than that is inside the bed */

void system_begin(const struct system_case *c, struct system *ret)
{
    *ret = (struct system){.c = *c};
}

/* n elements unless they are there already. */
static int room(void **at, int n, size_t size)
{
    if (!*at)
        *at = mem_zeroed((size_t)n, size);
    return *at != NULL;
}

enum status system_room(struct system *p, struct why *why)
{
    p->net.n = p->nodes.n;
    p->net.m = p->ropes.n;
    p->net.bodies = p->bodies.n;
    return room((void **)&p->net.node, p->net.n, sizeof *p->net.node) &&
                   room((void **)&p->node, p->net.n, sizeof *p->node) &&
                   room((void **)&p->net.rope, p->net.m, sizeof *p->net.rope) &&
                   room((void **)&p->type_of, p->net.m, sizeof *p->type_of) &&
                   room((void **)&p->segments, p->net.m, sizeof *p->segments) &&
                   room((void **)&p->type, p->types.n, sizeof *p->type) &&
                   room((void **)&p->net.body, p->net.bodies, sizeof *p->net.body) &&
                   room((void **)&p->body, p->net.bodies, sizeof *p->body)
               ? SW_OK
               : fail_plain(why, SW_NOMEM);
}

/* A node that sits on a body: its place there is what was given. */
static enum status put_on_body(struct system *p, int i, struct why *why)
{
    struct net_node *to = &p->net.node[i];
    const struct net_body *body = &p->net.body[to->body - 1];

    for (int k = 0; k < SYM; k++)
        if (to->K[k] != 0)
            return roll_fail(why, &p->nodes, i, "on a body a node has no spring");
    if (to->area > 0)
        return roll_fail(why, &p->nodes, i, "on a body a node is no float");
    to->held = 7;
    memcpy(to->arm, to->x, sizeof to->arm);
    mat3_apply(body->R, to->arm, to->x);
    for (int c = 0; c < 3; c++)
        to->x[c] += body->x[c];
    return SW_OK;
}

enum status system_take_node(struct system *p, int i, struct why *why)
{
    struct net_node *to = &p->net.node[i];
    const struct system_node *said = &p->node[i];
    double area = to->area, lift = said->volume * p->c.density * p->c.gravity;

    memcpy(p->node[i].given, to->x, sizeof to->x);
    memcpy(to->force, said->pull, sizeof to->force);
    to->drag = p->c.density * said->cda / 2;
    for (int c = 0; c < 3; c++)
        to->anchor[c] = isnan(to->x[c]) ? 0 : to->x[c];
    for (int k = 0; k < SYM; k++)
        if (to->K[k] != 0 && (isnan(to->x[0]) || isnan(to->x[1]) || isnan(to->x[2])))
            return roll_fail(why, &p->nodes, i, "a spring needs the point that it pulls to");
    if (area > 0 && !(said->volume > 0))
        return roll_fail(why, &p->nodes, i, "a waterplane needs a volume");
    to->force[2] -= said->mass * p->c.gravity;
    if (area > 0) {
        to->area = p->c.density * p->c.gravity * area;
        to->height = said->volume / area;
    } else {
        to->force[2] += lift;
    }
    return to->body > 0 ? put_on_body(p, i, why) : SW_OK;
}

/* Chain or continuous: by the row, the case, the law. */
static enum status take_elements(struct system *p, int r, int given, struct why *why)
{
    struct rope *to = &p->net.rope[r].rope;

    if (p->c.rope == ROPE_CATENARY && given != 1) {
        if (to->law.n > 0)
            return roll_fail(why, &p->ropes, r,
                             "a rope with a tension table is no catenary: take rope = auto");
        to->elements = 0;
    } else if (given > 0) {
        to->elements = given;
    } else {
        to->elements = p->c.rope == ROPE_CHAIN || to->law.n > 0 || p->c.method == NET_DISPLACEMENT
                           ? p->c.elements
                           : 0;
    }
    return SW_OK;
}

enum status system_take_rope(struct system *p, int r, int given, struct why *why)
{
    const struct system_type *type = &p->type[p->type_of[r]];
    struct net_rope *to = &p->net.rope[r];
    double friction = isnan(type->friction) ? p->c.friction : type->friction;

    to->rope.law = type->law;
    to->rope.q[2] =
        -p->c.gravity * (type->mass - p->c.density * PI / 4 * type->diameter * type->diameter);
    to->across = p->c.density * type->cd * type->diameter / 2;
    to->along = p->c.density * type->cd_axial * PI * type->diameter / 2;
    to->friction = isnan(friction) ? 0 : friction;
    return take_elements(p, r, given, why);
}

enum status system_take_body(struct system *p, int i, struct why *why)
{
    const struct system_body *said = &p->body[i];
    struct net_body *to = &p->net.body[i];
    double cb[3];

    (void)why;
    mat3_apply(to->R, to->cb, cb);
    to->weight = said->mass * p->c.gravity;
    to->lift = said->volume * p->c.density * p->c.gravity;
    to->area = said->area * p->c.density * p->c.gravity;
    to->level = to->x[2] + cb[2];
    return SW_OK;
}

/* What stands on the ground may be rounded: within that it is on the bed; or its height was left to
 * the bed. */
enum status system_judge_bed(struct system *p, struct why *why)
{
    for (int i = 0; i < p->net.n; i++) {
        struct net_node *node = &p->net.node[i];
        double deep;

        if (node->held != 7 || p->sea.bed.kind == BED_NONE)
            continue;
        if (isnan(node->x[2]))
            node->x[2] = bed_at(&p->sea.bed, node->x[0], node->x[1], NULL);
        deep = bed_at(&p->sea.bed, node->x[0], node->x[1], NULL) - node->x[2];
        if (deep > INSIDE * (1 + fabs(node->x[2])))
            return roll_fail(why, &p->nodes, i, "'%s' is held %.4g m inside the bed",
                             system_node(p, i), deep);
        if (deep > 0 && node->body == 0)
            node->x[2] += deep;
    }
    return SW_OK;
}

/* A free body that no node ties to anything drifts away. */
static enum status judge_bodies(const struct system *p, struct why *why)
{
    for (int b = 0; b < p->net.bodies; b++) {
        int nodes = 0;

        for (int i = 0; i < p->net.n; i++)
            nodes += p->net.node[i].body == b + 1;
        if (!p->net.body[b].held && nodes == 0)
            return roll_fail(why, &p->bodies, b, "no node sits on this body, which is free");
    }
    return SW_OK;
}

enum status system_judge(struct system *p, struct why *why)
{
    int is_rope, at;
    const char *reason;

    if (p->net.m == 0)
        return fail(why, SW_FORMAT, "%.400s: has no ropes", p->ropes.file);
    if (system_judge_bed(p, why) != SW_OK || judge_bodies(p, why) != SW_OK)
        return SW_FORMAT;
    reason = net_refused(&p->net, &is_rope, &at);
    if (!reason)
        return SW_OK;
    if (at < 0)
        return fail_plain(why, SW_NOMEM);
    roll_fail(why, is_rope ? &p->ropes : &p->nodes, at, "%s", reason);
    return SW_ADMISSIBLE;
}

enum status system_load(const char *path, const struct system_case *c, struct system *ret,
                        struct why *why)
{
    enum status s;

    system_begin(c, ret);
    s = c->is_deck ? deck_load(path, ret, why) : system_read_tables(path, ret, why);
    if (s == SW_OK)
        s = system_read_sea(path, ret, why);
    if (s == SW_OK)
        s = system_judge(ret, why);
    if (s != SW_OK)
        system_free(ret);
    return s;
}

enum status system_pass(struct system *p, int warns, struct why *why, const char *format, ...)
{
    char text[1024];
    struct system_note *note = mem_resize(p->note, (size_t)p->notes + 1, sizeof *note);
    va_list list;

    if (!note)
        return fail_plain(why, SW_NOMEM);
    p->note = note;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    note[p->notes] = (struct system_note){mem_copy(text, strlen(text) + 1), warns};
    if (!note[p->notes].text)
        return fail_plain(why, SW_NOMEM);
    p->notes++;
    return SW_OK;
}

void system_free(struct system *s)
{
    void *const all[] = {s->type_of,  s->segments, s->node,      s->body,         s->net.node,
                         s->net.rope, s->net.body, s->bed_table, s->current_table};

    for (int i = 0; s->type && i < s->types.n; i++)
        free(s->type[i].table);
    free(s->type);
    for (int i = 0; i < s->notes; i++)
        free(s->note[i].text);
    free(s->note);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
    roll_free(&s->nodes);
    roll_free(&s->ropes);
    roll_free(&s->types);
    roll_free(&s->bodies);
    *s = (struct system){.type = NULL};
}

const char *system_node(const struct system *s, int i)
{
    return roll_name(&s->nodes, i);
}

const char *system_rope(const struct system *s, int r)
{
    return roll_name(&s->ropes, r);
}
