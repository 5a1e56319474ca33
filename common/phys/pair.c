/* A load with two different ends, from their measures. */
#include "phys/pair.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

static const double lightest = 1e-8; /* spreader, of its share of the load, as in linkage.c */

static int single(const struct linkage *l)
{
    return l->s == 0 && l->phi == 0;
}

const char *pair_refused(const struct pair *p)
{
    for (int i = 0; i < 2; i++) {
        struct linkage l = p->end[i];
        const char *why;

        if (single(&l))
            l.phi = 1;
        why = linkage_refused(&l);
        if (why)
            return why;
        if (l.edges > 0)
            return "edges are not taken in for a pair";
    }
    if (!(p->apart > 0 && p->apart <= DBL_MAX))
        return "the ends must lie apart";
    for (int i = 0; i < 9; i++)
        if (!(fabs((&p->inertia[0][0])[i]) <= DBL_MAX))
            return "moments of inertia must be numbers";
    return NULL;
}

/* One sling, drawn under a force. */
static void add_sling(struct gear *s, int a, int b, double force, double stretch)
{
    int k = gear_add_sling(s, a, b, 0, stretch > 0 ? force * (1 - stretch) / stretch : INFINITY);

    gear_tighten(s, k, stretch);
}

static int add_spreader(struct gear *s, const struct linkage *l, double y, double z, double half)
{
    double m = fmax(l->m_spreader, lightest * l->m_load), r2 = l->radius_spreader, I;

    r2 = r2 > 0 ? r2 * r2 : half * half / 3;
    I = m * r2;
    return gear_add_body(s, m, (double[3]){0, y, z},
                         (const double[3][3]){{I / 1000, 0, 0}, {0, I, 0}, {0, 0, I}});
}

/* What hangs the load at y; its centre of gravity has x = offset. */
static void add_end(const struct pair *p, int i, double y, struct gear *s)
{
    const struct linkage *l = p->end + i;
    double low = -l->z, middle = low + l->s, d = l->v * tan(l->phi), g = p->end[0].g;
    double b = d + l->s * tan(l->gamma), x = -p->end[0].offset, weight = l->m_load * g;
    double total = weight + (l->s > 0 ? l->m_spreader * g : 0);
    int hook = gear_add_point(s, GEAR_HOOK, x, y, middle + l->v), spreader = -1;

    if (l->s > 0)
        spreader = add_spreader(s, l, y, middle, d);
    if (spreader >= 0)
        s->body[spreader].cg[0] = x;
    for (int side = single(l) ? 1 : -1; side <= 1; side += 2) {
        int load = gear_add_point(s, PAIR_LOAD, x + side * b, y, low);
        int up = l->s > 0 ? gear_add_point(s, spreader, x + side * d, y, middle) : load;

        add_sling(s, hook, up, single(l) ? total : total / (2 * cos(l->phi)), l->stretch_primary);
    }
    for (int side = 0; side < 2 && l->s > 0; side++) /* points: load, spreader, load, spreader */
        add_sling(s, hook + 2 + 2 * side, hook + 1 + 2 * side, weight / (2 * cos(l->gamma)),
                  l->stretch_secondary);
}

enum status pair_gear(const struct pair *p, struct gear *ret)
{
    double m1, m2, I[3][3], sum = 0;

    if (pair_refused(p))
        return SW_ADMISSIBLE;
    m1 = p->end[0].m_load;
    m2 = p->end[1].m_load;
    *ret = (struct gear){.g = p->end[0].g};
    for (int i = 0; i < 9; i++)
        sum += fabs((&p->inertia[0][0])[i]);
    memcpy(I, p->inertia, sizeof I);
    for (int i = 0; i < 3 && sum == 0; i++) /* a long box, a fifth as wide and high */
        I[i][i] = (m1 + m2) * p->apart * p->apart / (i == 1 ? 150 : 12);
    gear_add_body(ret, m1 + m2, (const double[3]){0, 0, 0}, (const double(*)[3])I);
    add_end(p, 0, -p->apart * m2 / (m1 + m2), ret);
    add_end(p, 1, p->apart * m1 / (m1 + m2), ret);
    return SW_OK;
}
