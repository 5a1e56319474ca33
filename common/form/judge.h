/*
 * What sling says of an arrangement: heights, what would make them zero, forces, verdict and why.
 *
 * The verdict stands on the worst view by the corrected formulas, and in a pair on the lesser of
 * two joint heights: (36) adds heights over the tilts of the spreaders, while what both ends share
 * is the tilt of a stiff load, over which end k has the height h_k/r_k, r_k tilt of the load over
 * that of its spreader.
 */
#ifndef SEILWERK_FORM_JUDGE_H
#define SEILWERK_FORM_JUDGE_H

#include "form/exact.h"
#include "form/lift.h"
#include "phys/righting.h"

enum verdict { VERDICT_STABLE, VERDICT_MARGINAL, VERDICT_UNSTABLE, VERDICT_NONE };

const char *verdict_name(enum verdict v);

/* SI units; NAN: has no meaning for the arrangement. */
struct judgement {
    double c, h;    /* as published, corrected where theory says so; h in the worst view */
    double least;   /* the height that judges */
    double worst;   /* the one within the tolerances; NAN: there are none, or it is not known */
    double coupled; /* in a pair over the tilt of a stiff load: sum of shares of h/r */
    double view[RIGGING_VIEWS]; /* h in each */
    double document[RIGGING_VIEWS], document_least;
    /* z at which stability ends; how far the centre may rise; NAN, too, if slings stretch and no
     * formula counts it. */
    double z_critical, rise, v_critical, gamma_critical;
    double centre, virtual_centre;     /* above the centre of gravity: of suspension, virtual one */
    struct righting at;                /* in the worst view; in a pair the worst of both ends */
    double use_primary, use_secondary; /* greatest force over working load limit */
    struct judged_end {
        double c, h, m, centre, virtual_centre, use_primary, use_secondary;
        struct righting at;
    } end[2]; /* of a pair */
    enum verdict verdict;
    char why[400];
};

/* Heights up to this [m] are round-off, and not above 0. */
#define JUDGE_ROUND 1e-9

/* The height that judges, alone: for the many arrangements of samples and tables.  NAN: slings
 * stretch, and exact statics find nothing. */
double judge_height(const struct lift *l);

/* The greatest force of a sling over its working load limit, at the offset; NAN: not known. */
double judge_use(const struct lift *l);

/* What a verdict depends on beside the arrangement.  NAN: not asked for. */
struct judge_by {
    double limit;              /* of h: below it the verdict is marginal */
    double worst;              /* bound of the height within the tolerances, by formulas */
    double use;                /* greatest judge_use within them */
    const struct exact *exact; /* NULL: formulas alone */
    /* The same, brief, of the arrangement within the tolerances that seems the worst, or NULL. */
    const struct exact *corner;
    const char *inexact; /* why exact statics were wanted in vain, or NULL */
};

/* Where formulas and exact statics differ the lesser stands, and why has both numbers. */
void judge_by(const struct lift *l, const struct judge_by *by, struct judgement *ret);

/* By the formulas alone. */
void judge(const struct lift *l, double limit, double worst, struct judgement *ret);

/* A row that cannot be used: no numbers, no verdict, and the reason. */
void judge_not(const char *reason, struct judgement *ret);

#endif
