/* What is admissible in a system of ropes, but seldom meant. */
#include "form/system.h"

#include <math.h>

#define SENSIBLE 0.1 /* strain of a rope between two fixed nodes */

static double apart(const struct net_node *a, const struct net_node *b)
{
    return hypot(hypot(b->x[0] - a->x[0], b->x[1] - a->x[1]), b->x[2] - a->x[2]);
}

static int lint_ropes(const struct system *s, void (*tell)(const char *text))
{
    int found = 0;
    struct why why;

    for (int r = 0; r < s->net.m; r++) {
        const struct net_rope *p = &s->net.rope[r];
        const struct net_node *a = &s->net.node[p->a], *b = &s->net.node[p->b];
        double d = apart(a, b);

        if (a->held != 7 || b->held != 7 || d <= (1 + SENSIBLE) * p->rope.L0)
            continue;
        roll_fail(&why, &s->ropes, r, "its nodes are %.6g m apart, %.3g %% more than its length", d,
                  100 * (d / p->rope.L0 - 1));
        tell(why.text);
        found++;
    }
    return found;
}

static int lint_floats(const struct system *s, void (*tell)(const char *text))
{
    int found = 0;
    struct why why;

    for (int i = 0; i < s->net.n; i++) {
        const struct net_node *p = &s->net.node[i];

        if (!(s->node[i].volume > 0 && s->c.density > 0 && p->area == 0 && p->x[2] > 0))
            continue;
        roll_fail(&why, &s->nodes, i,
                  "a float above the water keeps its whole buoyancy; has it a waterplane?");
        tell(why.text);
        found++;
    }
    return found;
}

int system_lint(const struct system *s, void (*tell)(const char *text))
{
    return lint_ropes(s, tell) + lint_floats(s, tell);
}
