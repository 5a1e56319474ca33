/* Words and verdicts on lifts. */
#include "form/verdict.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *verdict_name(enum verdict v)
{
    static const char *const names[] = {"stable", "marginal", "unstable", "not-judged"};

    return names[v];
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
static const char *rule(const struct lift *l, const struct judge_found *f,
                        const struct judgement *j)
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

static const char *where(const struct lift *l, const struct judge_found *f)
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

/* What exact statics find wrong, whatever the formulas say; 0: nothing. */
static int refute(const struct lift *l, const struct exact *e, const char *h, struct judgement *j)
{
    if (!e)
        return 0;
    if (!(exact_least(e) > JUDGE_ROUND))
        say(j, VERDICT_UNSTABLE,
            "exact statics: h = %.4g m is not above 0; by the formula %s = %.4g m", exact_least(e),
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
    double use = verdict_use(l, j);

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

/* The least height within the tolerances that judges: the bound by the formulas, less what exact
 * statics take from the height itself, or that of the corner; NAN: there are no tolerances, or
 * the slings stretch and only exact statics could tell. */
static double least_within(const struct lift *l, const struct judge_by *by, double h)
{
    double exact = exact_least(by->exact), worst = by->worst;

    if (isnan(worst) || (!by->exact && exact_stretches(l)))
        return NAN;
    if (!isinf(exact))
        worst -= fmax(0, h - exact);
    return by->corner ? fmin(worst, exact_least(by->corner)) : worst;
}

/* What the tolerances may do; 0: they leave it stable. */
static int doubtful(const struct judge_by *by, const char *h, const char *formula,
                    struct judgement *j)
{
    const struct exact *c = by->corner;
    double worst = j->worst, limit = by->limit;

    if (isnan(worst) && !c)
        return 0;
    if (isinf(worst) && worst < 0)
        say(j, VERDICT_MARGINAL, "%s = %.4g m but the tolerances reach what is no arrangement: %s",
            h, j->least, formula);
    else if (!isnan(worst) && !(worst > JUDGE_ROUND && worst >= limit))
        say(j, VERDICT_MARGINAL, "%s = %.4g m but %.4g m within the tolerances; limit %.4g m: %s",
            h, j->least, worst, limit, formula);
    else if (c && (!c->stable || c->lost))
        say(j, VERDICT_MARGINAL, "%s = %.4g m but within the tolerances %s: exact statics", h,
            j->least, c->lost ? "the offset capsizes it" : "it is not stable");
    else
        return 0;
    return 1;
}

/* A height above 0, against the limit and the tolerances. */
static void compare(const struct lift *l, const struct judge_found *f, const struct judge_by *by,
                    struct judgement *j)
{
    const char *h = where(l, f), *formula = rule(l, f, j);
    double exact = exact_least(by->exact), limit = by->limit;

    if (j->least < limit)
        say(j, VERDICT_MARGINAL, "%s = %.4g m is below the limit %.4g m: %s", h, j->least, limit,
            formula);
    else if (exact < limit)
        say(j, VERDICT_MARGINAL,
            "%s = %.4g m but by exact statics %.4g m is below the limit %.4g m: %s", h, j->least,
            exact, limit, formula);
    else if (doubtful(by, h, formula, j))
        return;
    else if (limit > 0)
        say(j, VERDICT_STABLE, "%s = %.4g m is not below the limit %.4g m: %s", h, j->least, limit,
            formula);
    else
        say(j, VERDICT_STABLE, "%s = %.4g m is above 0: %s", h, j->least, formula);
}

/* Both numbers where they differ, and what contact does, which no verdict stands on. */
static void add_exact(const struct lift *l, const struct exact *e, struct judgement *j)
{
    double formula = l->ends == 2 ? j->coupled : j->h, exact = exact_least(e);
    size_t n = strlen(j->why);

    if (formula != exact && !(fabs(formula - exact) <= 1e-6 * (1 + fabs(formula))))
        snprintf(j->why + n, sizeof j->why - n, "; exact statics %.4g m", exact);
    n = strlen(j->why);
    if (e->by_contact)
        snprintf(j->why + n, sizeof j->why - n,
                 "; only the edges of the load hold it, at a tilt of %.3g deg",
                 e->rest * 57.29577951308232);
}

/* A number of slings that nobody gave, where forces or uses depend on it. */
static void add_slings(const struct lift *l, const struct exact *e, struct judgement *j)
{
    for (int k = 0; k < l->ends; k++) {
        const struct judged_end *end = &j->end[k];
        double force = l->ends == 1 ? j->at.primary_low : end->at.primary_low;
        char which[20] = "";
        size_t n = strlen(j->why);

        if (!l->assumed[k] || (isnan(force) && !(e && !isnan(e->greatest[EXACT_PRIMARY])) &&
                               isnan(verdict_use(l, j))))
            continue;
        if (l->ends == 2)
            snprintf(which, sizeof which, " at end %d", k + 1);
        snprintf(j->why + n, sizeof j->why - n, "; %g sling%s assumed%s", l->end[k].slings,
                 l->end[k].slings == 1 ? "" : "s", which);
    }
}

void verdict_decide(const struct lift *l, const struct judge_found *f, const struct judge_by *by,
                    struct judgement *j)
{
    const char *h = where(l, f);

    j->worst = least_within(l, by, j->least);
    if (isnan(j->least))
        say(j, VERDICT_NONE, "no height could be computed");
    else if (!(j->least > JUDGE_ROUND))
        say(j, VERDICT_UNSTABLE, "%s = %.4g m is not above 0: %s", h, j->least, rule(l, f, j));
    else if (!refute(l, by->exact, h, j) && !abstain(l, by, h, j))
        compare(l, f, by, j);
    if (by->exact)
        add_exact(l, by->exact, j);
    add_slings(l, by->exact, j);
}
