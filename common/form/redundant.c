/* What contradicts a number that is varied. */
#include "form/redundant.h"

#include <math.h>

static int is_made(const struct lift_given *g)
{
    struct lift l;
    struct why ignored;

    return lift_make(g, &l, &ignored) == SW_OK;
}

static int without(const struct lift_given *g, int i, const int *varied, int n)
{
    struct lift_given less = *g;

    for (int k = 0; k < n; k++)
        if (varied[k] == i)
            return 0;
    less.x[i] = NAN;
    return !isnan(g->x[i]) && is_made(&less);
}

int redundant_number(const struct lift_given *g, const int *varied, int n)
{
    /* What is measured on a drawing last goes first. */
    static const int first[] = {LIFT_LONG, LIFT_CROSS, LIFT_SLING, LIFT_PHI, LIFT_GAMMA};
    struct lift_given loose = *g;

    loose.loose = 1;
    if (is_made(g) || !is_made(&loose))
        return -1;
    for (size_t k = 0; k < sizeof first / sizeof *first; k++)
        for (int end = 0; end < LIFT_ENDS; end++)
            if (without(g, LIFT_AT(first[k], end), varied, n))
                return LIFT_AT(first[k], end);
    for (int i = 0; i < LIFT_NUMBERS; i++)
        if (without(g, i, varied, n))
            return i;
    return -1;
}

int redundant_near(const struct lift_given *g, int i)
{
    for (int side = -1; side <= 1; side += 2) {
        struct lift_given at = *g;
        double step = side * 1e-3 * fmax(fabs(g->x[i]), lift_unit(i));

        for (int k = 0; k < 120 && is_made(&at); k++) {
            at.x[i] += step;
            step *= 1.1;
        }
        if (redundant_number(&at, &i, 1) >= 0)
            return redundant_number(&at, &i, 1);
    }
    return -1;
}

void redundant_say(const struct lift_given *g, int i, char ret[REDUNDANT_TEXT])
{
    char name[LIFT_NAME];

    lift_name(i, name);
    snprintf(ret, REDUNDANT_TEXT, "%s = %.6g", name, g->x[i] / lift_unit(i));
}
