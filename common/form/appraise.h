/*
 * All that a verdict on one arrangement depends on, put together: formulas, tolerances, exact
 * statics where they are asked for, or needed.
 */
#ifndef SEILWERK_FORM_APPRAISE_H
#define SEILWERK_FORM_APPRAISE_H

#include "form/doubt.h"

struct appraisal {
    int has_exact; /* exact was computed, whole if it was asked for, else brief */
    int failed;    /* exact statics were asked for in vain; why tells */
    struct why why;
    struct exact exact;
    struct judgement j;
};

/*
 * l was made from g.  exact: asked for.  Without being asked, exact statics judge what the formulas
 * do not know: an offset, which may capsize what hangs stably without one, and slings that stretch
 * where no formula counts it (exact_needed).
 */
void appraise(const struct lift_given *g, const struct lift *l, double limit, int exact,
              struct appraisal *ret);

#endif
