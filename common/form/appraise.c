/* Verdicts put together. */
#include "form/appraise.h"

#include <math.h>

static int has_tolerances(const struct lift_given *g)
{
    for (int i = 0; i < LIFT_NUMBERS; i++)
        if (g->tol[i] > 0)
            return 1;
    return 0;
}

/* Exact statics, and those of the corner of the tolerances, into by. */
static void prove(const struct lift_given *g, const struct lift *l, int whole,
                  struct appraisal *ret, struct exact *corner, struct judge_by *by)
{
    struct lift worst;
    struct why ignored;

    ret->has_exact = exact_make(l, !whole, &ret->exact, &ret->why) == SW_OK;
    if (!ret->has_exact) {
        by->inexact = ret->why.text;
        ret->failed = whole;
        return;
    }
    by->exact = &ret->exact;
    if (has_tolerances(g) && doubt_corner(g, &worst) == SW_OK &&
        exact_make(&worst, 1, corner, &ignored) == SW_OK)
        by->corner = corner;
}

void appraise(const struct lift_given *g, const struct lift *l, double limit, int exact,
              struct appraisal *ret)
{
    struct judge_by by = {.limit = limit, .worst = doubt_worst(g, l), .use = doubt_use(g, l)};
    struct exact corner;

    ret->worst = by.worst;
    ret->has_exact = ret->failed = 0;
    if (exact || exact_needed(l))
        prove(g, l, exact, ret, &corner, &by);
    judge_by(l, &by, &ret->j);
}
