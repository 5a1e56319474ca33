/* Doubts about systems of ropes that were solved. */
#include "form/netdoubt.h"
#include "num/mem.h"
#include "num/vec3.h"

#include <math.h>
#include <stdlib.h>

#define BELOW 1e-6 /* of the size: lower than what holds it, higher than the water */
#define FAR 0.2    /* strain: no rope but one of nylon or rubber bears more at work */

enum about { BREAKING, STRAIN, NO_BED, NODE, BODY, KINDS };

enum status net_doubt_new(const struct system *p, struct net_doubt *ret, struct why *why)
{
    int most = p->net.m > p->net.n ? p->net.m : p->net.n;

    most = most > p->net.bodies ? most : p->net.bodies;
    *ret = (struct net_doubt){.p = p};
    ret->told = mem_zeroed(KINDS * (size_t)most + 1, 1);
    return ret->told ? SW_OK : fail_plain(why, SW_NOMEM);
}

void net_doubt_free(struct net_doubt *d)
{
    free(d->told);
    d->told = NULL;
}

/* Whether it is the first time. */
static int is_news(struct net_doubt *d, enum about what, int which)
{
    char *told = d->told + KINDS * which + (int)what;
    int news = !*told;

    *told = 1;
    return news;
}

static void doubt_rope(struct net_doubt *d, int r, const struct net_outline *line,
                       const char *place)
{
    const struct system *p = d->p;
    const struct rope_law *law = &p->net.rope[r].rope.law;
    double most = fabs(line->most), strain = line->most / law->EA;

    if (most > p->type[p->type_of[r]].breaking && is_news(d, BREAKING, r))
        warn("%srope '%s' is over its breaking load: %.6g N", place, system_rope(p, r), most);
    if (law->n == 0 && strain > FAR && is_news(d, STRAIN, r))
        warn("%srope '%s' is strained by %.3g %%: is the unit of its stiffness right?", place,
             system_rope(p, r), 100 * strain);
}

static void warn_of_float(const char *place, const char *what, const char *name, double height)
{
    warn("%s%s '%s' comes to rest %.3g m above the water and keeps its whole buoyancy; has it a "
         "waterplane?",
         place, what, name, height);
}

/* Buoyancy in the air. */
static void doubt_floats(struct net_doubt *d, const struct net_state *s, const char *place)
{
    const struct system *p = d->p;

    for (int i = 0; i < p->net.n && p->c.density > 0; i++) {
        const struct net_node *node = &p->net.node[i];

        if (p->node[i].volume > 0 && node->area == 0 && !(node->held & 4) &&
            s->x[3 * i + 2] > BELOW * s->size && is_news(d, NODE, i))
            warn_of_float(place, "node", system_node(p, i), s->x[3 * i + 2]);
    }
    for (int b = 0; b < p->net.bodies && p->c.density > 0; b++) {
        const struct net_body *body = &p->net.body[b];
        double cb[3];

        mat3_apply(body->R, body->cb, cb);
        if (!body->held && body->lift > 0 && body->area == 0 &&
            body->x[2] + cb[2] > BELOW * s->size && is_news(d, BODY, b))
            warn_of_float(place, "body", roll_name(&p->bodies, b), body->x[2] + cb[2]);
    }
}

/* In water ropes seldom hang below all that holds them: most of them would lie on a bed. */
static void doubt_bed(struct net_doubt *d, const struct net_state *s, double lowest, int which,
                      const char *place)
{
    const struct system *p = d->p;
    double bottom = INFINITY;

    for (int i = 0; i < p->net.n; i++)
        if (p->net.node[i].held & 4)
            bottom = fmin(bottom, p->net.node[i].x[2]);
    if (p->c.density > 0 && p->sea.bed.kind == BED_NONE && which >= 0 &&
        lowest < bottom - BELOW * s->size && is_news(d, NO_BED, 0))
        warn("%srope '%s' hangs %.3g m below the lowest node that is held: there is no bed", place,
             system_rope(p, which), bottom - lowest);
}

void net_doubt_tell(struct net_doubt *d, const struct net_state *s, const char *place)
{
    double lowest = INFINITY;
    int which = -1;

    for (int r = 0; r < d->p->net.m; r++) {
        struct net_outline line;

        net_outline(&d->p->net, s, r, &line);
        doubt_rope(d, r, &line, place);
        if (line.lowest < lowest) {
            lowest = line.lowest;
            which = r;
        }
    }
    doubt_bed(d, s, lowest, which, place);
    doubt_floats(d, s, place);
}
