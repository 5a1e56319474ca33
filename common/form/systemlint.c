/* What is admissible in a system of ropes, but seldom meant. */
#include "form/system.h"

#include <math.h>

#define SENSIBLE 0.1 /* strain of a rope between two fixed nodes */
#define OFF_BED 1e-3 /* of the depth: an anchor above or below the bed */

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

/* Whether every rope of fixed node i ends above it, as those of an anchor do. */
static int is_anchor(const struct system *s, int i)
{
    const struct net_node *node = &s->net.node[i];
    int ropes = 0;

    if (node->held != 7 || node->body > 0)
        return 0;
    for (int r = 0; r < s->net.m; r++) {
        const struct net_rope *p = &s->net.rope[r];
        const struct net_node *other = &s->net.node[p->a == i ? p->b : p->a];

        if (p->a != i && p->b != i)
            continue;
        if (other->x[2] <= node->x[2])
            return 0;
        ropes++;
    }
    return ropes > 0;
}

/* Anchors stand on the bed; one inside it was refused before. */
static int lint_anchors(const struct system *s, void (*tell)(const char *text))
{
    int found = 0;
    struct why why;

    for (int i = 0; i < s->net.n && s->sea.bed.kind != BED_NONE; i++) {
        const struct net_node *p = &s->net.node[i];
        double bed = bed_at(&s->sea.bed, p->x[0], p->x[1], NULL), above = p->x[2] - bed;

        if (!(p->held & 4) || !(above > OFF_BED * fabs(bed)) || !is_anchor(s, i))
            continue;
        roll_fail(&why, &s->nodes, i, "it is held %.6g m above the bed, which lies at z = %.6g m",
                  above, bed);
        tell(why.text);
        found++;
    }
    return found;
}

int system_lint(const struct system *s, void (*tell)(const char *text))
{
    return lint_ropes(s, tell) + lint_floats(s, tell) + lint_anchors(s, tell);
}
