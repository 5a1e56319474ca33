/*
 * How a judgement finds its verdict and its words, between judge.c and verdict.c.
 */
#ifndef SEILWERK_FORM_VERDICT_H
#define SEILWERK_FORM_VERDICT_H

#include "form/judge.h"

/* Heights of both ends of a pair, or of the whole. */
struct judge_found {
    struct rigging_heights heights[2];
    enum rigging_view view[2];
    double h[2]; /* in that view */
};

/* Greatest use of a sling in j; an elastic sling's given use counts, too. */
double verdict_use(const struct lift *l, const struct judgement *j);

/* Verdict and why of j, whose numbers are complete. */
void verdict_decide(const struct lift *l, const struct judge_found *f, const struct judge_by *by,
                    struct judgement *j);

#endif
