/* Tensions that are wanted of ropes. */
#include "form/nettarget.h"
#include "sys/number.h"

#include <math.h>
#include <string.h>

/* The node at an end of the rope that is fixed on the ground; -1: none. */
static int anchor_of(const struct net *net, const struct net_rope *p)
{
    if (net->node[p->a].held == 7 && net->node[p->a].body == 0)
        return p->a;
    return net->node[p->b].held == 7 && net->node[p->b].body == 0 ? p->b : -1;
}

enum status net_take_target(const struct system *p, const char *text, int by_anchor,
                            struct net_target *ret, struct why *why)
{
    const char *equals = strrchr(text, '=');
    int anchor;

    if (!equals)
        return fail(why, SW_USAGE, "'%.60s': ROPE=TENSION is expected", text);
    if (numbers_read(equals + 1, 1, &ret->tension, why) != SW_OK)
        return SW_USAGE;
    if (!(ret->tension > 0))
        return fail(why, SW_USAGE, "'%.60s': a tension is positive", text);
    ret->rope = roll_search(&p->ropes, text, (size_t)(equals - text));
    if (ret->rope < 0)
        return fail(why, SW_USAGE, "there is no rope '%.*s'", (int)(equals - text), text);
    anchor = anchor_of(&p->net, &p->net.rope[ret->rope]);
    ret->at =
        anchor == p->net.rope[ret->rope].b ? p->net.rope[ret->rope].a : p->net.rope[ret->rope].b;
    ret->anchor = by_anchor ? anchor : -1;
    if (by_anchor && anchor < 0)
        return fail(why, SW_USAGE, "rope '%s' has no anchor", system_rope(p, ret->rope));
    return SW_OK;
}

enum status net_explain_targets(const struct system *p, const struct net_state *s,
                                const struct net_target *target, int k, struct why *why)
{
    double most = -1;

    for (int i = 0; i < k; i++) {
        const struct net_target *t = &target[i];
        double end[2][3], T, off;
        const double *at = end[p->net.rope[t->rope].a != t->at];

        net_ends(&p->net, s, t->rope, end[0], end[1]);
        T = hypot(hypot(at[0], at[1]), at[2]);
        off = fabs(T / t->tension - 1);
        if (off <= most)
            continue;
        most = off;
        fail(why, SW_NOCONV, "option --pretension: no %s found that gives rope '%s' %.6g N: %.6g N",
             t->anchor < 0 ? "length" : "place of the anchor", system_rope(p, t->rope), t->tension,
             T);
    }
    return SW_NOCONV;
}
