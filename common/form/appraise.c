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

/* How near an arrangement is to capsizing: by the tilt of its offset, or else by its height. */
static double danger(const struct lift_given *g)
{
    struct exact e;
    struct lift l;
    struct why why;

    if (lift_make(g, &l, &why) != SW_OK || exact_make(&l, 1, &e, &why) != SW_OK)
        return NAN;
    if (!e.stable || e.lost || !(exact_least(&e) > 0))
        return INFINITY;
    return l.offset > 0 ? e.tilt_load : -exact_least(&e);
}

/* From the corner of the tolerances that is worst to first order on, one input after the other to
 * the end that is more dangerous, twice. */
static enum status find_corner(const struct lift_given *g, struct lift *ret)
{
    struct lift_given at;
    struct why why;
    double most;

    doubt_corner(g, &at);
    most = danger(&at);
    for (int i = 0; i < 2 * LIFT_NUMBERS && most < INFINITY; i++) {
        int k = i % LIFT_NUMBERS;

        for (int side = -1; side <= 1 && g->tol[k] > 0 && lift_is_input(k); side += 2) {
            double before = at.x[k], now;

            at.x[k] = g->x[k] + side * g->tol[k];
            now = danger(&at);
            if (now > most)
                most = now;
            else
                at.x[k] = before;
        }
    }
    return lift_make(&at, ret, &why);
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
    if (has_tolerances(g) && find_corner(g, &worst) == SW_OK &&
        exact_make(&worst, 1, corner, &ignored) == SW_OK)
        by->corner = corner;
}

void appraise(const struct lift_given *g, const struct lift *l, double limit, int exact,
              struct appraisal *ret)
{
    struct judge_by by = {.limit = limit, .worst = doubt_worst(g, l), .use = doubt_use(g, l)};
    struct exact corner;

    ret->has_exact = ret->failed = 0;
    if (exact || exact_needed(l))
        prove(g, l, exact, ret, &corner, &by);
    judge_by(l, &by, &ret->j);
}
