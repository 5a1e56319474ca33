/* Lifts in space from their measures. */
#include "phys/tandem.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

static int positive(double x)
{
    return x > 0 && x <= DBL_MAX;
}

static int at_least_zero(double x)
{
    return x >= 0 && x <= DBL_MAX;
}

const char *tandem_refused(const struct tandem *t)
{
    double sum = t->z + t->offset[0] + t->offset[1];

    if (t->hooks != 1 && t->hooks != 2)
        return "there are one or two hooks";
    for (int i = 0; i < t->hooks; i++)
        sum += t->hook[i][0] + t->hook[i][1];
    for (int i = 0; i < 9; i++)
        sum += (&t->inertia[0][0])[i];
    if (!(fabs(sum) <= DBL_MAX))
        return "places and moments of inertia must be numbers";
    if (t->hooks == 2 && t->hook[0][0] == t->hook[1][0] && t->hook[0][1] == t->hook[1][1])
        return "two hooks must lie apart";
    if (t->slings != 2 && t->slings != 4)
        return "there are two or four slings a hook";
    if (!positive(t->v) || !positive(t->base_half))
        return "v and the lifting base must be positive";
    if (t->spreaders && (!positive(t->s) || !positive(t->spreader_half)))
        return "s and the spreader's width must be positive";
    if (t->slings == 4 &&
        (!positive(t->base_cross) || (t->spreaders && !positive(t->spreader_cross))))
        return "four slings need a base crosswise";
    if (!positive(t->m_load) || !at_least_zero(t->m_spreader) || !positive(t->g))
        return "masses and g must be positive";
    if (!(t->stretch_primary >= 0 && t->stretch_primary < 1 && t->stretch_secondary >= 0 &&
          t->stretch_secondary < 1))
        return "the stretch must lie in [0, 1)";
    return NULL;
}

/* Moments of inertia of a box of the half widths a, b, c. */
static void box(double mass, double a, double b, double c, double I[3][3])
{
    I[0][0] = mass * (b * b + c * c) / 3;
    I[1][1] = mass * (a * a + c * c) / 3;
    I[2][2] = mass * (a * a + b * b) / 3;
}

/* Half the distance of the outermost lifting points from the middle of the hooks. */
static void extent(const struct tandem *t, double ret[2])
{
    double apart[2] = {0};

    for (int i = 0; i < 2 && t->hooks == 2; i++)
        apart[i] = fabs(t->hook[1][i] - t->hook[0][i]) / 2;
    ret[0] = apart[0] + t->base_half;
    ret[1] = apart[1] + (t->slings == 4 ? t->base_cross : 0);
}

static void add_load(const struct tandem *t, struct gear *s)
{
    double cg[3] = {t->offset[0], t->offset[1], -t->v - (t->spreaders ? t->s : 0) + t->z}, half[2];
    double I[3][3], sum = 0;

    for (int i = 0; i < 2; i++)
        cg[i] += t->hooks == 2 ? (t->hook[0][i] + t->hook[1][i]) / 2 : t->hook[0][i];
    for (int i = 0; i < 9; i++) {
        (&I[0][0])[i] = (&t->inertia[0][0])[i];
        sum += fabs((&I[0][0])[i]);
    }
    extent(t, half);
    if (sum == 0)
        box(t->m_load, half[0], half[1], fmax(fabs(t->z), half[0] / 4), I);
    gear_add_body(s, t->m_load, cg, (const double(*)[3])I);
}

/* Of the load's mass, as in linkage.c. */
static const double lightest = 1e-8;

static void add_spreader(const struct tandem *t, int hook, struct gear *s)
{
    double I[3][3] = {{0}}, thin = t->spreader_half / 50;
    double mass = fmax(t->m_spreader, lightest * t->m_load);

    box(mass, t->spreader_half, t->slings == 4 ? t->spreader_cross : thin, thin, I);
    gear_add_body(s, mass, (const double[3]){t->hook[hook][0], t->hook[hook][1], -t->v},
                  (const double(*)[3])I);
}

/* The points of one body below a hook; the number of the first. */
static int add_points(const struct tandem *t, int hook, int body, double half, double cross,
                      double z, struct gear *s)
{
    int first = s->points;

    for (int i = 0; i < t->slings; i++)
        gear_add_point(s, body, t->hook[hook][0] + (i % 2 ? half : -half),
                       t->hook[hook][1] + (t->slings == 2 ? 0
                                           : i / 2        ? cross
                                                          : -cross),
                       z);
    return first;
}

/* Slings from points a (all the same or one each) to the points from b on, drawn under a share of
 * the weight on one hook. */
static void add_slings(const struct tandem *t, int a, int each, int b, double weight,
                       double stretch, struct gear *s)
{
    for (int i = 0; i < t->slings; i++) {
        int k = gear_add_sling(s, a + (each ? i : 0), b + i, 0, INFINITY);
        double drop = s->point[a].at[2] - s->point[b].at[2];
        double force = weight / t->slings * s->sling[k].length / drop;

        if (stretch > 0) {
            s->sling[k].EA = force * (1 - stretch) / stretch;
            gear_tighten(s, k, stretch);
        }
    }
}

enum status tandem_gear(const struct tandem *t, struct gear *ret)
{
    double load, z;
    int upper[2];

    if (tandem_refused(t))
        return SW_ADMISSIBLE;
    load = t->m_load * t->g / t->hooks;
    z = -t->v - (t->spreaders ? t->s : 0);
    *ret = (struct gear){.g = t->g};
    add_load(t, ret);
    for (int i = 0; i < t->hooks; i++) {
        int hook = gear_add_point(ret, GEAR_HOOK, t->hook[i][0], t->hook[i][1], 0);

        if (t->spreaders) {
            add_spreader(t, i, ret);
            upper[i] = add_points(t, i, TANDEM_SPREADER + i, t->spreader_half, t->spreader_cross,
                                  -t->v, ret);
        } else {
            upper[i] = add_points(t, i, TANDEM_LOAD, t->base_half, t->base_cross, z, ret);
        }
        add_slings(t, hook, 0, upper[i], load + (t->spreaders ? t->m_spreader * t->g : 0),
                   t->stretch_primary, ret);
    }
    for (int i = 0; i < t->hooks && t->spreaders; i++)
        add_slings(t, upper[i], 1,
                   add_points(t, i, TANDEM_LOAD, t->base_half, t->base_cross, z, ret), load,
                   t->stretch_secondary, ret);
    return SW_OK;
}
