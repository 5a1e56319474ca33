/* Numbers of judgements on lifts. */
#include "form/verdict.h"

#include <math.h>
#include <stdio.h>

static void find(const struct lift *l, struct judge_found *f)
{
    *f = (struct judge_found){.h = {NAN, NAN}}; /* of an end that is not there */
    for (int k = 0; k < l->ends; k++) {
        rigging_heights(&l->end[k], &f->heights[k]);
        if (l->ends == 2 && l->end[k].type == RIGGING_ELASTIC)
            f->heights[k].h[RIGGING_CROSS] = f->heights[k].document[RIGGING_CROSS] = NAN;
        f->h[k] = rigging_least(f->heights[k].h, &f->view[k]);
    }
}

/*
 * Offset over tilt of a stiff load, which both ends share: the potential of end k over that tilt,
 * its spreader and swing relaxed, is m_k g (h_k/r_k)/2 times its square, and potentials add.
 */
static double coupled(const struct lift *l, const struct judge_found *f)
{
    return l->share[0] * f->h[0] / f->heights[0].r + l->share[1] * f->h[1] / f->heights[1].r;
}

/* (36). */
static double joint(const struct lift *l, const struct judge_found *f)
{
    return l->share[0] * f->h[0] + l->share[1] * f->h[1];
}

/* h where no formula counts the stretch; what is not stable has no height above 0. */
static double stretched(const struct lift *l, double h)
{
    struct lift straight = *l;
    struct exact e;
    struct why why;

    straight.offset = NAN;
    if (exact_make(&straight, 1, &e, &why) != SW_OK)
        return NAN;
    h = fmin(h, exact_least(&e));
    return e.stable ? h : fmin(h, 0);
}

double judge_height(const struct lift *l)
{
    struct judge_found f;
    double h;

    find(l, &f);
    h = l->ends == 1 ? f.h[0] : fmin(joint(l, &f), coupled(l, &f));
    return exact_stretches(l) ? stretched(l, h) : h;
}

static void clear(struct judgement *j)
{
    static const struct righting none = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};

    j->c = j->h = j->least = j->worst = j->coupled = j->document_least = NAN;
    j->z_critical = j->rise = j->v_critical = j->gamma_critical = NAN;
    j->centre = j->virtual_centre = j->use_primary = j->use_secondary = NAN;
    for (int i = 0; i < RIGGING_VIEWS; i++)
        j->view[i] = j->document[i] = NAN;
    j->at = none;
    for (int k = 0; k < 2; k++)
        j->end[k] = (struct judged_end){NAN, NAN, NAN, NAN, NAN, NAN, NAN, none};
}

/* Greatest force over limit. */
static double use_of(const struct righting *at, double wll, int secondary)
{
    return (secondary ? fmax(at->secondary_low, at->secondary_high)
                      : fmax(at->primary_low, at->primary_high)) /
           wll;
}

/* critical: with what would make h zero. */
static void judge_one(const struct lift *l, const struct judge_found *f, int critical,
                      struct judgement *ret)
{
    const struct suspension *a = &l->end[0];
    const struct rigging_heights *heights = &f->heights[0];
    enum rigging_view view = f->view[0], ignored;

    ret->h = ret->least = f->h[0];
    ret->c = heights->c;
    for (int i = 0; i < RIGGING_VIEWS; i++) {
        ret->view[i] = heights->h[i];
        ret->document[i] = heights->document[i];
    }
    ret->document_least = rigging_least(heights->document, &ignored);
    if (critical) {
        ret->z_critical = rigging_critical_z(a);
        ret->rise = ret->z_critical - a->z;
        ret->v_critical = rigging_critical_v(a);
        ret->gamma_critical = rigging_critical_gamma(a);
    }
    ret->centre = heights->centre[view] - a->z;
    ret->virtual_centre = ret->centre - ret->h;
    righting_at(a, view, ret->h, ret->h > 0 ? l->offset / ret->h : NAN, &ret->at);
    ret->use_primary = use_of(&ret->at, a->wll, 0);
    ret->use_secondary = use_of(&ret->at, a->wll_secondary, 1);
}

static void judge_end(const struct lift *l, const struct judge_found *f, int k, double load_tilt,
                      struct judged_end *ret)
{
    const struct suspension *a = &l->end[k];
    const struct rigging_heights *heights = &f->heights[k];

    ret->h = f->h[k];
    ret->c = heights->c;
    ret->m = a->m_load;
    ret->centre = heights->centre[f->view[k]] - a->z;
    ret->virtual_centre = ret->centre - ret->h;
    righting_at(a, f->view[k], ret->h, load_tilt / heights->r, &ret->at);
    ret->use_primary = use_of(&ret->at, a->wll, 0);
    ret->use_secondary = use_of(&ret->at, a->wll_secondary, 1);
}

/* Joint centres lie on the lines between those of the ends, over the common centre of gravity (Bild
 * 2.12): means with the shares. */
static double between(const struct lift *l, double x1, double x2)
{
    return l->share[0] * x1 + l->share[1] * x2;
}

static void judge_pair(const struct lift *l, const struct judge_found *f, struct judgement *ret)
{
    struct judged_end *end = ret->end;
    double h = coupled(l, f), tilt = h > 0 ? l->offset / h : NAN;

    ret->h = ret->view[RIGGING_CROSS] = joint(l, f);
    ret->document[RIGGING_CROSS] = ret->document_least =
        between(l, f->heights[0].document[f->view[0]], f->heights[1].document[f->view[1]]);
    ret->coupled = h;
    ret->least = fmin(ret->h, h);
    if (!exact_stretches(l)) {
        ret->rise = h; /* raising G by dz takes m g dz from the stiffness against the load's tilt */
        ret->z_critical = l->end[0].z + h;
    }
    for (int k = 0; k < 2; k++)
        judge_end(l, f, k, tilt, &end[k]);
    ret->centre = between(l, end[0].centre, end[1].centre);
    ret->virtual_centre = between(l, end[0].virtual_centre, end[1].virtual_centre);
    ret->at.load = atan(tilt);
    ret->at.spreader = fmax(end[0].at.spreader, end[1].at.spreader);
    ret->at.primary_low = fmax(end[0].at.primary_low, end[1].at.primary_low);
    ret->at.primary_high = fmin(end[0].at.primary_high, end[1].at.primary_high);
    ret->at.secondary_low = fmax(end[0].at.secondary_low, end[1].at.secondary_low);
    ret->at.secondary_high = fmin(end[0].at.secondary_high, end[1].at.secondary_high);
    ret->use_primary = fmax(end[0].use_primary, end[1].use_primary);
    ret->use_secondary = fmax(end[0].use_secondary, end[1].use_secondary);
}

/* Greatest use of a sling; an elastic sling's given use counts, too. */
double verdict_use(const struct lift *l, const struct judgement *j)
{
    double use = fmax(j->use_primary, j->use_secondary);

    for (int k = 0; k < l->ends; k++)
        use = fmax(use, l->end[k].use);
    return use;
}

double judge_use(const struct lift *l)
{
    struct judgement j;
    struct judge_found f;

    clear(&j);
    find(l, &f);
    if (l->ends == 1)
        judge_one(l, &f, 0, &j);
    else
        judge_pair(l, &f, &j);
    return verdict_use(l, &j);
}

void judge_by(const struct lift *l, const struct judge_by *by, struct judgement *ret)
{
    struct judge_found f;

    clear(ret);
    find(l, &f);
    if (l->ends == 1)
        judge_one(l, &f, !exact_stretches(l), ret);
    else
        judge_pair(l, &f, ret);
    verdict_decide(l, &f, by, ret);
    if (by->exact)
        ret->least = fmin(ret->least, exact_least(by->exact));
}

void judge(const struct lift *l, double limit, double worst, struct judgement *ret)
{
    judge_by(l, &(struct judge_by){.limit = limit, .worst = worst, .use = NAN}, ret);
}

void judge_not(const char *reason, struct judgement *ret)
{
    clear(ret);
    ret->verdict = VERDICT_NONE;
    snprintf(ret->why, sizeof ret->why, "%s", reason);
}
