/* The gear of an arrangement. */
#include "form/tackle.h"
#include "phys/linkage.h"
#include "phys/pair.h"
#include "phys/tandem.h"

#include <math.h>
#include <string.h>

static const double ton = 1000;

static double mass_of(const struct suspension *a)
{
    return isnan(a->m_load) ? ton : a->m_load;
}

static double spreader_of(const struct suspension *a)
{
    return (a->mu - 1) * mass_of(a);
}

int tackle_has_mass(const struct lift *l)
{
    return !isnan(l->end[0].m_load) && (l->ends == 1 || !isnan(l->end[1].m_load));
}

/* Radius of gyration of a box of two of the load's sizes; 0: not known. */
static double radius(double a, double b)
{
    return isnan(a + b) ? 0 : sqrt((a * a + b * b) / 12);
}

/* Moments of inertia of the load as a box, along the gear's axes; all 0: its size is not known. */
static void inertia(const struct detail *d, double mass, int turned, double ret[3][3])
{
    double x = d->load[turned ? 1 : 0], y = d->load[turned ? 0 : 1], z = d->load[2];

    memset(ret, 0, 9 * sizeof(double));
    if (isnan(x + y + z))
        return;
    ret[0][0] = mass * (y * y + z * z) / 12;
    ret[1][1] = mass * (x * x + z * z) / 12;
    ret[2][2] = mass * (x * x + y * y) / 12;
}

/* The measures of one suspension in a view. */
static enum status measure(const struct lift *l, int end, enum rigging_view view,
                           struct linkage *ret, struct why *why)
{
    const struct suspension *a = &l->end[end];
    const struct detail *d = &l->detail[end];
    double T = a->T[view];

    *ret = (struct linkage){.v = a->v,
                            .s = a->s,
                            .z = a->z,
                            .phi = atan(T),
                            .gamma = atan(a->t),
                            .m_spreader = spreader_of(a),
                            .m_load = mass_of(a),
                            .g = RIGGING_GRAVITY,
                            .radius_load = radius(d->load[view], d->load[2]),
                            .stretch_primary = d->stretch[0],
                            .stretch_secondary = d->stretch[1]};
    if (a->type == RIGGING_SINGLE) {
        ret->v = isnan(a->v) || a->v == 0 ? fmax(1, 2 * fabs(a->z)) : a->v;
        ret->phi = 0;
        return SW_OK;
    }
    if (!isfinite(T))
        return fail(why, SW_ADMISSIBLE,
                    "phi_deg: is missing, and no base gives it: exact statics need it");
    return SW_OK;
}

/* Each sling of the gear stands for a part of the real ones, and lies in one view while a primary
 * sling slopes in both. */
static void share(int end, int from, int n, int part, double each, double slope, struct tackle *ret)
{
    for (int k = from; k < from + n; k++) {
        ret->part[k] = part;
        ret->end[k] = end;
        ret->real[k] = slope / each;
    }
}

/* Length of a primary sling over that which the view shows. */
static double slope_of(const struct suspension *a, enum rigging_view view)
{
    double other = a->T[1 - view], T = a->T[view];

    if (a->type == RIGGING_SECONDARY || !isfinite(other) || !isfinite(T))
        return 1;
    return sqrt((1 + T * T + other * other) / (1 + T * T));
}

/* One sling from the hook to one point of the load. */
static enum status single_gear(const struct linkage *m, struct gear *ret)
{
    double r = m->radius_load > 0 ? m->radius_load : fmax(fabs(m->z), 0.1 * m->v);
    double I = m->m_load * r * r;
    int hook, point, k;

    *ret = (struct gear){.planar = 1, .g = m->g};
    gear_add_body(ret, m->m_load, (double[3]){0, 0, -m->v + m->z},
                  (const double[3][3]){{I, 0, 0}, {0, I, 0}, {0, 0, I}});
    hook = gear_add_point(ret, GEAR_HOOK, 0, 0, 0);
    point = gear_add_point(ret, LINKAGE_LOAD, 0, 0, -m->v);
    k = gear_add_sling(ret, hook, point, 0, INFINITY);
    if (m->stretch_primary > 0) {
        ret->sling[k].EA = m->m_load * m->g * (1 - m->stretch_primary) / m->stretch_primary;
        gear_tighten(ret, k, m->stretch_primary);
    }
    return SW_OK;
}

static enum status refused(const char *text, struct why *why)
{
    return fail(why, SW_ADMISSIBLE, "exact statics: %s", text ? text : "no gear");
}

enum status tackle_planar(const struct lift *l, enum rigging_view view, int edges,
                          struct tackle *ret, struct why *why)
{
    const struct suspension *a = &l->end[0];
    const struct detail *d = &l->detail[0];
    struct linkage m;
    enum status s = measure(l, 0, view, &m, why);

    if (s != SW_OK)
        return s;
    *ret = (struct tackle){.load = LINKAGE_LOAD,
                           .spreader = a->type == RIGGING_SECONDARY ? LINKAGE_SPREADER : -1,
                           .turned = view == RIGGING_CROSS,
                           .reach = m.v * tan(m.phi) + m.s * tan(m.gamma)};
    if (a->type == RIGGING_SINGLE) {
        ret->reach = m.v;
        share(0, 0, 1, 0, a->slings, 1, ret);
        return single_gear(&m, &ret->gear);
    }
    if (fmod(a->slings, 2) != 0)
        return fail(why, SW_ADMISSIBLE,
                    "slings: exact statics need an even number, half of them on each side");
    for (m.edges = 0; edges && m.edges < d->edges; m.edges++) {
        m.half[m.edges] = d->half[m.edges];
        m.height[m.edges] = d->height[m.edges];
    }
    share(0, 0, 2, 0, a->slings / 2, slope_of(a, view), ret);
    share(0, 2, 2, 1, a->slings / 2, 1, ret);
    return linkage_gear(&m, &ret->gear) == SW_OK ? SW_OK : refused(linkage_refused(&m), why);
}

/* Both ends of a pair, seen crosswise. */
static enum status pair_tackle(const struct lift *l, struct tackle *ret, struct why *why)
{
    struct pair p = {.apart = l->apart};
    enum status s = SW_OK;
    double size = 0;
    int k = 0;

    for (int i = 0; i < 2 && s == SW_OK; i++) {
        const struct suspension *a = &l->end[i];
        enum rigging_view view = isnan(a->T[RIGGING_CROSS]) ? RIGGING_LONG : RIGGING_CROSS;
        int n = a->type == RIGGING_SINGLE ? 1 : 2;

        s = measure(l, i, view, &p.end[i], why);
        if (s == SW_OK && n == 2 && fmod(a->slings, 2) != 0)
            s = fail(why, SW_ADMISSIBLE,
                     "slings: exact statics need an even number, half of them on each side");
        size = fmax(size, p.end[i].v + p.end[i].s + fabs(p.end[i].z));
        share(i, k, n, 0, a->slings / n, 1, ret);
        k += n;
        if (a->type == RIGGING_SECONDARY) {
            share(i, k, n, 1, a->slings / n, 1, ret);
            k += n;
        }
    }
    if (s != SW_OK)
        return s;
    if (isnan(p.apart))
        p.apart = 2 * size;
    inertia(&l->detail[0], p.end[0].m_load + p.end[1].m_load, 1, p.inertia);
    ret->turned = 1;
    ret->spreader = l->end[0].type == RIGGING_SECONDARY || l->end[1].type == RIGGING_SECONDARY;
    ret->spreader = ret->spreader ? PAIR_LOAD + 1 : -1;
    ret->reach = size;
    return pair_gear(&p, &ret->gear) == SW_OK ? SW_OK : refused(pair_refused(&p), why);
}

/* Slings of two hooks, or four of one hook to both bases; what one view shows is no tandem. */
static int is_spatial(const struct suspension *a, const struct detail *d)
{
    double each = a->slings / d->hooks;

    if (a->type == RIGGING_SINGLE || (each != 2 && each != 4))
        return 0;
    if (a->type == RIGGING_SECONDARY)
        return each == 4 ? !isnan(d->spreader_width) : d->hooks == 2;
    return each == 4 ? !isnan(d->base[0] + d->base[1]) && d->hooks == 1 : d->hooks == 2;
}

static void hooks_of(const struct detail *d, struct tandem *t)
{
    for (int i = 0; i < 2 && d->hooks == 2; i++)
        t->hook[i][1] = (i - 0.5) * d->hook_distance;
}

/* x of the tandem is the view of the spreader, or lengthwise. */
static enum status tandem_tackle(const struct lift *l, struct tackle *ret, struct why *why)
{
    const struct suspension *a = &l->end[0];
    const struct detail *d = &l->detail[0];
    enum rigging_view view = isnan(a->T[RIGGING_LONG]) ? RIGGING_CROSS : RIGGING_LONG;
    struct linkage m;
    struct tandem t;
    enum status s = measure(l, 0, view, &m, why);
    int spreaders = a->type == RIGGING_SECONDARY, n;
    double other = d->base[1 - view];

    if (s != SW_OK)
        return s;
    t = (struct tandem){.hooks = d->hooks,
                        .slings = (int)a->slings / d->hooks,
                        .spreaders = spreaders,
                        .v = m.v,
                        .s = m.s,
                        .z = m.z,
                        .spreader_half = m.v * tan(m.phi),
                        .spreader_cross = d->spreader_width / 2,
                        .base_half = m.v * tan(m.phi) + m.s * tan(m.gamma),
                        .m_spreader = m.m_spreader / d->hooks,
                        .m_load = m.m_load,
                        .g = m.g,
                        .stretch_primary = m.stretch_primary,
                        .stretch_secondary = m.stretch_secondary};
    if (t.slings == 4)
        t.base_cross = spreaders && (isnan(other) || d->hooks == 2) ? t.spreader_cross : other / 2;
    hooks_of(d, &t);
    inertia(d, m.m_load, view == RIGGING_CROSS, t.inertia);
    ret->turned = view == RIGGING_CROSS;
    ret->spreader = spreaders ? TANDEM_SPREADER : -1;
    ret->reach = t.base_half;
    n = t.slings * t.hooks;
    share(0, 0, n, 0, 1, 1, ret);
    share(0, n, spreaders ? n : 0, 1, 1, 1, ret);
    return tandem_gear(&t, &ret->gear) == SW_OK ? SW_OK : refused(tandem_refused(&t), why);
}

enum status tackle_space(const struct lift *l, struct tackle *ret, struct why *why)
{
    *ret = (struct tackle){.load = LINKAGE_LOAD};
    if (l->ends == 2)
        return pair_tackle(l, ret, why);
    if (!is_spatial(&l->end[0], &l->detail[0]))
        return fail(why, SW_INFEASIBLE, "one view shows all");
    return tandem_tackle(l, ret, why);
}
