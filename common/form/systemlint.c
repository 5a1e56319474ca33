/* What is admissible in a system of ropes, but seldom meant. */
#include "form/system.h"
#include "form/units.h"
#include "num/pi.h"
#include "phys/touch.h"

#include <math.h>

#define SENSIBLE 0.1  /* strain of a rope between two fixed nodes */
#define LONG 10       /* rope over the distance of two fixed nodes */
#define OFF_BED 1e-3  /* of the depth: an anchor above or below the bed */
#define MIRRORED 0.05 /* of the depth: as high above the water as the bed is below it */
#define LIGHT 500     /* [kg/m3]: no water */

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

        if (a->held != 7 || b->held != 7)
            continue;
        if (d > (1 + SENSIBLE) * p->rope.L0)
            roll_fail(&why, &s->ropes, r,
                      "its nodes are %.6g m apart, %.3g %% more than its length", d,
                      100 * (d / p->rope.L0 - 1));
        else if (d > 0 && p->rope.L0 > LONG * d)
            roll_fail(&why, &s->ropes, r,
                      "its nodes are %.6g m apart, its length is %.3g times that", d,
                      p->rope.L0 / d);
        else
            continue;
        tell(why.text);
        found++;
    }
    return found;
}

/* Mean densities of types, where water makes them matter. */
static int lint_types(const struct system *s, void (*tell)(const char *text))
{
    int found = 0;
    struct why why;

    for (int i = 0; i < s->types.n && s->c.density > 0; i++) {
        const struct system_type *p = &s->type[i];
        double density = p->mass / (PI / 4 * p->diameter * p->diameter);

        if (!(p->mass > 0 && p->diameter > 0) || !units_doubt_density(density, UNITS_LIGHT))
            continue;
        roll_fail(&why, &s->types, i,
                  "mass and diameter make a density of %.3g kg/m3: are the units right?", density);
        tell(why.text);
        found++;
    }
    return found;
}

/* Water that is next to none, where something displaces it. */
static int lint_water(const struct system *s, void (*tell)(const char *text))
{
    struct why why;
    int wet = 0;

    for (int i = 0; i < s->types.n; i++)
        wet |= s->type[i].diameter > 0;
    for (int i = 0; i < s->net.n; i++)
        wet |= s->node[i].volume > 0;
    if (!wet || !(s->c.density > 0 && s->c.density < LIGHT))
        return 0;
    fail(&why, SW_FORMAT, "water_density = %.3g kg/m3: is the unit right?", s->c.density);
    tell(why.text);
    return 1;
}

static int lint_floats(const struct system *s, int solves, void (*tell)(const char *text))
{
    int found = 0;
    struct why why;

    for (int i = 0; i < s->net.n; i++) {
        const struct net_node *p = &s->net.node[i];

        if (solves && !(p->held & 4))
            continue;
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

/* A sign that slipped: what is fixed stands as high above the water as the bed lies below it. */
static int lint_signs(const struct system *s, void (*tell)(const char *text))
{
    int found = 0;
    struct why why;

    for (int i = 0; i < s->net.n && s->sea.bed.kind != BED_NONE && s->c.density > 0; i++) {
        const struct net_node *p = &s->net.node[i];
        double bed = bed_at(&s->sea.bed, p->x[0], p->x[1], NULL);

        if (p->held != 7 || p->body > 0 || !(p->x[2] > 0) ||
            !(fabs(p->x[2] + bed) <= MIRRORED * -bed))
            continue;
        roll_fail(&why, &s->nodes, i,
                  "it is held %.6g m above the water, the bed lies at z = %.6g m; is %.6g meant?",
                  p->x[2], bed, -p->x[2]);
        tell(why.text);
        found++;
    }
    return found;
}

/* Whether rope r would lie on a level bed at the height of its lower end. */
static int would_lie(const struct system *s, int r)
{
    const struct net_rope *p = &s->net.rope[r];
    const double *a = s->net.node[p->a].x, *b = s->net.node[p->b].x;
    double low = fmin(a[2], b[2]);
    struct touch_rope rope = {.L0 = p->rope.L0, .w = -p->rope.q[2], .EA = p->rope.law.EA};
    struct touch_place place = {hypot(b[0] - a[0], b[1] - a[1]), 0, {a[2] - low, b[2] - low}};
    struct touch t;

    return s->net.node[p->a].held == 7 && s->net.node[p->b].held == 7 && rope.w > 0 &&
           touch_solve(&rope, &place, &t) == SW_OK && t.lies;
}

/* In water without a bed: the first rope that would lie on one at its anchor. */
static int lint_no_bed(const struct system *s, void (*tell)(const char *text))
{
    struct why why;

    for (int r = 0; r < s->net.m && s->c.density > 0 && s->sea.bed.kind == BED_NONE; r++) {
        const struct net_rope *p = &s->net.rope[r];

        if ((!is_anchor(s, p->a) && !is_anchor(s, p->b)) || !would_lie(s, r))
            continue;
        roll_fail(&why, &s->ropes, r,
                  "it hangs below its anchor: no depth is given, there is no bed");
        tell(why.text);
        return 1;
    }
    return 0;
}

int system_lint(const struct system *s, int solves, void (*tell)(const char *text))
{
    return lint_ropes(s, tell) + lint_types(s, tell) + lint_water(s, tell) +
           lint_floats(s, solves, tell) + lint_anchors(s, tell) + lint_signs(s, tell) +
           (solves ? 0 : lint_no_bed(s, tell));
}
