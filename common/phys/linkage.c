/* The planar linkage from the measures of the check formulas. */
#include "phys/linkage.h"

#include "num/pi.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

const char *linkage_refused(const struct linkage *l)
{
    double half = l->v * tan(l->phi) + l->s * tan(l->gamma);

    if (!(l->v > 0 && l->v <= DBL_MAX))
        return "v must be positive";
    if (!(l->s >= 0 && l->s <= DBL_MAX))
        return "s must not be negative";
    if (!(fabs(l->z) <= DBL_MAX && fabs(l->offset) <= DBL_MAX))
        return "z and the offset must be numbers";
    if (!(l->phi > 0 && l->phi < PI / 2))
        return "phi must lie between 0 and 90 degrees";
    if (!(fabs(l->gamma) < PI / 2))
        return "gamma must lie between -90 and 90 degrees";
    if (!(half > 1e-9 * (l->v + l->s)))
        return "the lifting points must lie apart: v tan(phi) + s tan(gamma) > 0";
    if (!(l->m_load > 0 && l->m_load <= DBL_MAX && l->m_spreader >= 0 && l->m_spreader <= DBL_MAX))
        return "masses must be positive";
    if (!(l->g > 0 && l->g <= DBL_MAX))
        return "g must be positive";
    if (!(l->radius_load >= 0 && l->radius_spreader >= 0 &&
          l->radius_load + l->radius_spreader <= DBL_MAX))
        return "radii of gyration must not be negative";
    if (!(l->stretch_primary >= 0 && l->stretch_primary < 1 && l->stretch_secondary >= 0 &&
          l->stretch_secondary < 1))
        return "the stretch must lie in [0, 1)";
    if (l->edges < 0 || l->edges > GEAR_CORNERS)
        return "too many edges";
    for (int i = 0; i < l->edges; i++)
        if (!(l->half[i] > 0 && l->half[i] <= DBL_MAX && fabs(l->height[i]) <= DBL_MAX))
            return "edges must lie beside the middle of the load";
    return NULL;
}

/* Of the load's mass: a spreader without any must still know where to hang when slings go slack. */
static const double lightest = 1e-8;

/* A body whose moment of inertia about y is that of the radius, or of a rod of the half length. */
static int add_body(struct gear *s, double mass, double x, double z, double radius, double half)
{
    double I = mass * (radius > 0 ? radius * radius : half * half / 3);

    return gear_add_body(s, mass, (double[3]){x, 0, z},
                         (const double[3][3]){{I, 0, 0}, {0, I, 0}, {0, 0, I}});
}

/* A pair of slings from the points a + side to b + side, each under the force as drawn. */
static void add_pair(struct gear *s, int a, int step, int b, double force, double stretch)
{
    double EA = stretch > 0 ? force * (1 - stretch) / stretch : INFINITY;

    for (int side = 0; side < 2; side++) {
        int k = gear_add_sling(s, a + side * step, b + side, 0, EA);

        gear_tighten(s, k, stretch);
    }
}

/* The slings k and k + 1 lean on the edges of the load, whose lifting points lie at the height z.
 */
static enum status add_edges(const struct linkage *l, double z, double stretch, int k,
                             struct gear *ret)
{
    enum status status = SW_OK;

    for (int side = 0; side < 2 && status == SW_OK && l->edges > 0; side++) {
        double out = side ? 1 : -1, corner[GEAR_CORNERS][3] = {{0}};

        for (int i = 0; i < l->edges; i++) {
            corner[i][0] = out * l->half[i];
            corner[i][2] = z + l->height[i];
        }
        status = gear_add_edges(ret, k + side, LINKAGE_LOAD, (double[3]){0, 1, 0},
                                (double[3]){out, 0, 0}, l->edges, (const double(*)[3])corner);
        if (status == SW_OK)
            gear_tighten(ret, k + side, stretch);
    }
    return status;
}

enum status linkage_gear(const struct linkage *l, struct gear *ret)
{
    double d, b, z, weight, total;
    int hook, load, spreader;

    if (linkage_refused(l))
        return SW_ADMISSIBLE;
    d = l->v * tan(l->phi);
    b = d + l->s * tan(l->gamma);
    z = -l->v - l->s;
    weight = l->m_load * l->g;
    total = weight + (l->s > 0 ? l->m_spreader * l->g : 0);
    *ret = (struct gear){.planar = 1, .g = l->g};
    add_body(ret, l->m_load, l->offset, z + l->z, l->radius_load, b);
    hook = gear_add_point(ret, GEAR_HOOK, 0, 0, 0);
    load = gear_add_point(ret, LINKAGE_LOAD, -b, 0, z);
    gear_add_point(ret, LINKAGE_LOAD, b, 0, z);
    if (l->s == 0) {
        add_pair(ret, hook, 0, load, total / (2 * cos(l->phi)), l->stretch_primary);
        return add_edges(l, z, l->stretch_primary, LINKAGE_LEFT, ret);
    }
    add_body(ret, fmax(l->m_spreader, lightest * l->m_load), 0, -l->v, l->radius_spreader, d);
    spreader = gear_add_point(ret, LINKAGE_SPREADER, -d, 0, -l->v);
    gear_add_point(ret, LINKAGE_SPREADER, d, 0, -l->v);
    add_pair(ret, hook, 0, spreader, total / (2 * cos(l->phi)), l->stretch_primary);
    add_pair(ret, spreader, 1, load, weight / (2 * cos(l->gamma)), l->stretch_secondary);
    return add_edges(l, z, l->stretch_secondary, LINKAGE_SECOND_LEFT, ret);
}
