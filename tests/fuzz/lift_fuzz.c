/* Any bytes as a table of lifts: each row is refused with words, or has a verdict with its reason
 * that no NaN has part in; a stable one is stable by its numbers. */
#include "form/appraise.h"
#include "fuzz.h"

#include <math.h>
#include <string.h>

/* A row that makes an arrangement. */
static void judged(const struct lift_given *g, const struct lift *l)
{
    struct appraisal p;
    struct judgement j;
    struct lift_given all = *g;
    double worst = doubt_worst(g, l), height = judge_height(l), slopes[LIFT_NUMBERS];
    struct lift again;
    struct why why;

    check(!isnan(height) || exact_stretches(l));
    check(isnan(worst) || worst <= height || exact_stretches(l));
    appraise(g, l, 0.5, 0, &p);
    j = p.j;
    check(isnan(j.worst) || j.worst <= j.least);
    check(j.why[0] != '\0' && memchr(j.why, 0, sizeof j.why));
    check(j.least <= j.h && (p.has_exact || isnan(height) || j.least == height));
    check(height > JUDGE_ROUND || isnan(height) || j.verdict == VERDICT_UNSTABLE);
    check(p.has_exact || j.verdict != VERDICT_UNSTABLE || !(height > JUDGE_ROUND));
    check(j.verdict != VERDICT_STABLE || (height >= 0.5 && !(j.worst < 0.5)));
    check(j.verdict != VERDICT_STABLE || !exact_needed(l) || p.has_exact);
    check(j.verdict != VERDICT_STABLE || !(j.use_primary > 1 || j.use_secondary > 1));
    doubt_slopes(g, l, slopes);
    check(doubt_greatest(g, slopes) < LIFT_NUMBERS);
    lift_resolve(l, &all);
    if (lift_make(&all, &again, &why) == SW_OK && fabs(height) < 1e6)
        check(fabs(judge_height(&again) - height) <= 1e-3 * (1e3 + fabs(height)));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *set = "z_m_tol=0.01";
    struct opt_list sets = {&set, 1};
    struct in in = {.f = bytes(data, size), .name = "fuzz"};
    struct lift_table t;
    struct lift_given g;
    struct lift l;
    struct why why = {""};
    int end = 0;

    err_level(1, 0);
    if (lift_begin(&in, &sets, &t, &why) == SW_OK) {
        while (!end) {
            enum status s = lift_row(&t, &g, &end, &why);

            if (s == SW_OK && !end)
                s = lift_make(&g, &l, &why);
            check(s == SW_OK || why.text[0] != '\0');
            if (s == SW_OK && !end)
                judged(&g, &l);
        }
        lift_end(&t);
    } else {
        check(strncmp(why.text, "fuzz:", 5) == 0);
    }
    fclose(in.f);
    return 0;
}
