/* Doubts about systems of ropes that were solved. */
#include "form/netdoubt.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>

#define BELOW 1e-6 /* of the size: lower than what holds it */

enum status net_doubt_new(const struct system *p, struct net_doubt *ret, struct why *why)
{
    *ret = (struct net_doubt){.p = p};
    ret->told = mem_zeroed((size_t)p->net.m + 1, 1);
    return ret->told ? SW_OK : fail_plain(why, SW_NOMEM);
}

void net_doubt_free(struct net_doubt *d)
{
    free(d->told);
    d->told = NULL;
}

/* Whether it is the first time. */
static int is_news(struct net_doubt *d, int which)
{
    int news = !d->told[which];

    d->told[which] = 1;
    return news;
}

static void doubt_rope(struct net_doubt *d, int r, const struct net_outline *line,
                       const char *place)
{
    const struct system *p = d->p;
    double most = fabs(line->most);

    if (most > p->type[p->type_of[r]].breaking && is_news(d, r))
        warn("%srope '%s' is over its breaking load: %.6g N", place, system_rope(p, r), most);
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
        lowest < bottom - BELOW * s->size && is_news(d, p->net.m))
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
}
