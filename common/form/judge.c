/* Verdicts on lifts. */
#include "form/judge.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *verdict_name(enum verdict v)
{
    static const char *const names[] = {"stable", "marginal", "unstable", "not-judged"};

    return names[v];
}

/* Heights of both ends of a pair, or of the whole. */
struct found {
    struct rigging_heights heights[2];
    enum rigging_view view[2];
    double h[2]; /* in that view */
};

static void find(const struct lift *l, struct found *f)
{
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
static double coupled(const struct lift *l, const struct found *f)
{
    return l->share[0] * f->h[0] / f->heights[0].r + l->share[1] * f->h[1] / f->heights[1].r;
}

/* (36). */
static double joint(const struct lift *l, const struct found *f)
{
    return l->share[0] * f->h[0] + l->share[1] * f->h[1];
}

double judge_height(const struct lift *l)
{
    struct found f;

    find(l, &f);
    return l->ends == 1 ? f.h[0] : fmin(joint(l, &f), coupled(l, &f));
}

static void clear(struct judgement *j)
{
    static const struct righting none = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};

    j->c = j->h = j->least = j->coupled = j->document_least = NAN;
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
static void judge_one(const struct lift *l, const struct found *f, int critical,
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

static void judge_end(const struct lift *l, const struct found *f, int k, double load_tilt,
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

static void judge_pair(const struct lift *l, const struct found *f, struct judgement *ret)
{
    struct judged_end *end = ret->end;
    double h = coupled(l, f), tilt = h > 0 ? l->offset / h : NAN;

    ret->h = ret->view[RIGGING_CROSS] = joint(l, f);
    ret->document[RIGGING_CROSS] = ret->document_least =
        between(l, f->heights[0].document[f->view[0]], f->heights[1].document[f->view[1]]);
    ret->coupled = h;
    ret->least = fmin(ret->h, h);
    ret->rise = h; /* raising G by dz takes m g dz from the stiffness against the load's tilt */
    ret->z_critical = l->end[0].z + ret->rise;
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

/* Verdict and the rule and number that decided. */
__attribute__((format(printf, 3, 4))) static void say(struct judgement *j, enum verdict v,
                                                      const char *format, ...)
{
    va_list args;

    j->verdict = v;
    va_start(args, format);
    vsnprintf(j->why, sizeof j->why, format, args);
    va_end(args);
}

/* The formula that gave the height that judges. */
static const char *rule(const struct lift *l, const struct found *f, const struct judgement *j)
{
    const struct suspension *a = &l->end[0];

    if (l->ends == 2)
        return j->coupled < j->h ? "ends tilted alike by a stiff load" : "joint height (36)";
    if (f->heights[0].ruled[f->view[0]])
        return "h = -z: phi < 5 deg and z > v tan(phi) (1.3.1)";
    switch (a->type) {
    case RIGGING_SINGLE: return "h = -z of a single sling (1.2.8)";
    case RIGGING_PRIMARY: return "h = v - z (2)";
    case RIGGING_ELASTIC:
        return f->view[0] == RIGGING_LONG ? "elastic slings lengthwise; (25) corrected"
                                          : "elastic slings crosswise; (32) corrected";
    case RIGGING_SECONDARY: break;
    }
    return "primary and secondary slings (15)";
}

static const char *where(const struct lift *l, const struct found *f)
{
    if (l->ends == 2)
        return "joint h";
    if (l->end[0].type == RIGGING_SINGLE)
        return "h";
    return f->view[0] == RIGGING_LONG ? "h_long" : "h_cross";
}

/* A spreader whose slings are so steep that a small tilt makes one slack: the documents have no
 * rule for it. */
static const struct suspension *narrow_spreader(const struct lift *l)
{
    for (int k = 0; k < l->ends; k++) {
        const struct suspension *a = &l->end[k];
        double T = a->T[isnan(a->T[RIGGING_LONG])];

        if (a->type == RIGGING_SECONDARY && !a->stabilized && T < RIGGING_TAN5 && a->z > a->v * T)
            return a;
    }
    return NULL;
}

/* Primary slings that may be as steep. */
static int without_angle(const struct lift *l)
{
    for (int k = 0; k < l->ends; k++) {
        const struct suspension *a = &l->end[k];

        if (a->type == RIGGING_PRIMARY && !a->stabilized && a->z > 0 &&
            isinf(a->T[isnan(a->T[RIGGING_LONG])]))
            return 1;
    }
    return 0;
}

/* Greatest use of a sling; an elastic sling's given use counts, too. */
static double greatest_use(const struct lift *l, const struct judgement *j)
{
    double use = fmax(j->use_primary, j->use_secondary);

    for (int k = 0; k < l->ends; k++)
        use = fmax(use, l->end[k].use);
    return use;
}

double judge_use(const struct lift *l)
{
    struct judgement j;
    struct found f;

    clear(&j);
    find(l, &f);
    if (l->ends == 1)
        judge_one(l, &f, 0, &j);
    else
        judge_pair(l, &f, &j);
    return greatest_use(l, &j);
}

/* The exact height beside that of the formula: edges count where they make it less. */
static double exact_height(const struct exact *e)
{
    return e ? fmin(e->h, e->contact) : INFINITY; /* fmin of NAN is the other */
}

/* What exact statics find wrong, whatever the formulas say; 0: nothing. */
static int refute(const struct lift *l, const struct exact *e, const char *h, struct judgement *j)
{
    if (!e)
        return 0;
    if (!(exact_height(e) > 0))
        say(j, VERDICT_UNSTABLE,
            "exact statics: h = %.4g m is not above 0; by the formula %s = %.4g m", exact_height(e),
            h, j->least);
    else if (!e->stable)
        say(j, VERDICT_UNSTABLE, "exact statics: not stable, omega^2 = %.4g /s2, %s; %s = %.4g m",
            e->omega2, e->mode, h, j->least);
    else if (e->lost)
        say(j, VERDICT_UNSTABLE,
            "exact statics: the offset of %.4g m capsizes it, stability ends at %.4g m; %s = %.4g "
            "m",
            l->offset, e->offset_lost, h, j->least);
    else
        return 0;
    return 1;
}

/* What leaves a lift without verdict; 0: nothing. */
static int abstain(const struct lift *l, const struct judge_by *by, const char *h,
                   struct judgement *j)
{
    const struct suspension *narrow = narrow_spreader(l);
    const struct exact *e = by->exact;
    double use = greatest_use(l, j);

    for (int i = 0; i < EXACT_PARTS && e; i++)
        use = fmax(use, e->use[i]);
    if (without_angle(l))
        say(j, VERDICT_NONE,
            "phi is missing and no base gives it: slings of less than 5 deg need another rule "
            "(1.3.1);"
            " %s = %.4g m",
            h, j->least);
    else if (narrow)
        say(j, VERDICT_NONE,
            "phi < 5 deg and z > v tan(phi) = %.4g m under a spreader: no rule is known; %s = %.4g "
            "m",
            narrow->v * narrow->T[isnan(narrow->T[RIGGING_LONG])], h, j->least);
    else if (use > 1)
        say(j, VERDICT_NONE, "a sling bears %.4g of its working load limit; %s = %.4g m", use, h,
            j->least);
    else if (by->use > 1)
        say(j, VERDICT_NONE,
            "a sling may bear %.4g of its working load limit within the tolerances; %s = %.4g m",
            by->use, h, j->least);
    else if (j->at.primary_high < 0 || j->at.secondary_high < 0 ||
             (e && l->offset > 0 && e->slack > 0 && !e->indeterminate))
        say(j, VERDICT_NONE, "the offset of %.4g m makes a sling slack: tilt %.4g deg; %s = %.4g m",
            l->offset, (e ? e->tilt_load : j->at.load) * 57.29577951308232, h, j->least);
    else if (by->inexact)
        say(j, VERDICT_NONE, "%s; by the formula %s = %.4g m", by->inexact, h, j->least);
    else
        return 0;
    return 1;
}

/* A height above 0, against the limit and the tolerances. */
static void compare(const struct lift *l, const struct found *f, const struct judge_by *by,
                    struct judgement *j)
{
    const char *h = where(l, f), *formula = rule(l, f, j);
    double exact = exact_height(by->exact), limit = by->limit;
    double worst = by->worst - fmax(0, isinf(exact) ? 0 : j->least - exact);

    if (j->least < limit)
        say(j, VERDICT_MARGINAL, "%s = %.4g m is below the limit %.4g m: %s", h, j->least, limit,
            formula);
    else if (exact < limit)
        say(j, VERDICT_MARGINAL,
            "%s = %.4g m but by exact statics %.4g m is below the limit %.4g m: %s", h, j->least,
            exact, limit, formula);
    else if (isinf(worst))
        say(j, VERDICT_MARGINAL, "%s = %.4g m but the tolerances reach what is no arrangement: %s",
            h, j->least, formula);
    else if (!isnan(worst) && !(worst > 0 && worst >= limit))
        say(j, VERDICT_MARGINAL, "%s = %.4g m but %.4g m within the tolerances; limit %.4g m: %s",
            h, j->least, worst, limit, formula);
    else if (limit > 0)
        say(j, VERDICT_STABLE, "%s = %.4g m is not below the limit %.4g m: %s", h, j->least, limit,
            formula);
    else
        say(j, VERDICT_STABLE, "%s = %.4g m is above 0: %s", h, j->least, formula);
}

/* Both numbers where they differ, and what contact does, which no verdict stands on. */
static void add_exact(const struct lift *l, const struct exact *e, struct judgement *j)
{
    double formula = l->ends == 2 ? j->coupled : j->h, exact = exact_height(e);
    size_t n = strlen(j->why);

    if (formula != exact && !(fabs(formula - exact) <= 1e-6 * (1 + fabs(formula))))
        snprintf(j->why + n, sizeof j->why - n, "; exact statics %.4g m", exact);
    n = strlen(j->why);
    if (e->by_contact)
        snprintf(j->why + n, sizeof j->why - n,
                 "; only the edges of the load hold it, at a tilt of %.3g deg",
                 e->rest * 57.29577951308232);
}

static void decide(const struct lift *l, const struct found *f, const struct judge_by *by,
                   struct judgement *j)
{
    const char *h = where(l, f);

    if (isnan(j->least))
        say(j, VERDICT_NONE, "no height could be computed");
    else if (!(j->least > 0))
        say(j, VERDICT_UNSTABLE, "%s = %.4g m is not above 0: %s", h, j->least, rule(l, f, j));
    else if (!refute(l, by->exact, h, j) && !abstain(l, by, h, j))
        compare(l, f, by, j);
    if (by->exact)
        add_exact(l, by->exact, j);
}

void judge_by(const struct lift *l, const struct judge_by *by, struct judgement *ret)
{
    struct found f;

    clear(ret);
    find(l, &f);
    if (l->ends == 1)
        judge_one(l, &f, 1, ret);
    else
        judge_pair(l, &f, ret);
    decide(l, &f, by, ret);
}

void judge(const struct lift *l, double limit, double worst, struct judgement *ret)
{
    judge_by(l, &(struct judge_by){.limit = limit, .worst = worst, .use = NAN}, ret);
}

void judge_not(const char *reason, struct judgement *ret)
{
    clear(ret);
    say(ret, VERDICT_NONE, "%s", reason);
}
