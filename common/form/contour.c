/* Tables of heights over two inputs. */
#include "form/contour.h"
#include "form/appraise.h"
#include "form/redundant.h"
#include "form/result.h"

#include <string.h>

#define KINDS 16

/* Points that are not judged, by their reasons. */
struct tally {
    long points, none;
    int kinds;
    struct kind {
        long n;
        char why[400]; /* of the first one */
    } kind[KINDS];
};

/* Whether texts are the same but for their numbers. */
static int is_alike(const char *a, const char *b)
{
    static const char number[] = "0123456789.-+";

    for (;;) {
        a += strspn(a, number);
        b += strspn(b, number);
        if (*a != *b || *a == '\0')
            return *a == *b;
        a++;
        b++;
    }
}

static void count(struct tally *c, const char *why)
{
    int k = 0;

    c->none++;
    while (k < c->kinds && !is_alike(c->kind[k].why, why))
        k++;
    if (k == KINDS)
        return;
    if (k == c->kinds) {
        c->kind[c->kinds++].n = 0;
        snprintf(c->kind[k].why, sizeof c->kind[k].why, "%s", why);
    }
    c->kind[k].n++;
}

/* What contradicts the point, and which of the two inputs it is that cannot be varied beside it:
 * with the other one as it was it would be no better. */
static int contradicts(const struct lift_given *g, const struct lift_given *at,
                       const struct axis *a, const struct axis *b, char *ret, size_t size)
{
    int both[2] = {a->number, b->number}, by = redundant_number(at, both, 2);
    struct lift_given only_a = *at, only_b = *at;
    char what[REDUNDANT_TEXT];
    struct lift l;
    struct why ignored;

    if (by < 0)
        return 0;
    only_a.x[b->number] = g->x[b->number];
    only_b.x[a->number] = g->x[a->number];
    redundant_say(at, by, what);
    if (lift_make(&only_b, &l, &ignored) == SW_OK)
        snprintf(ret, size, "contradict %s: leave it out to vary %s", what, a->name);
    else if (lift_make(&only_a, &l, &ignored) == SW_OK)
        snprintf(ret, size, "contradict %s: leave it out to vary %s", what, b->name);
    else
        snprintf(ret, size, "contradict %s: leave it out to vary %s and %s", what, a->name,
                 b->name);
    return 1;
}

static void tell(const struct tally *c)
{
    const struct kind *most = c->kind;

    for (int k = 1; k < c->kinds; k++)
        if (c->kind[k].n > most->n)
            most = &c->kind[k];
    if (c->none == 0)
        return;
    if (most->n == c->none && strncmp(most->why, "contradict ", 11) == 0)
        warn("%ld of %ld points %s", most->n, c->points, most->why);
    else if (strncmp(most->why, "contradict ", 11) == 0)
        warn("%ld of %ld points are not judged, %ld %s", c->none, c->points, most->n, most->why);
    else if (most->n == c->none)
        warn("%ld of %ld points are not judged: %s", c->none, c->points, most->why);
    else
        warn("%ld of %ld points are not judged, %ld for this reason: %s", c->none, c->points,
             most->n, most->why);
}

void contour_print(struct lift_table *t, const struct lift_given *g, const struct axis *a,
                   const struct axis *b, double limit, struct out *o)
{
    struct tally c = {.points = a->n * b->n};
    struct lift_given at = *g;

    fprintf(o->f, "%s,%s,h_m,verdict,why\n", a->name, b->name);
    for (long i = 0; i < a->n && !out_failed(o); i++)
        for (long k = 0; k < b->n; k++) {
            struct appraisal p;
            struct lift l;
            struct why why;
            char reason[400];

            at.x[a->number] = axis_value(a, i) * lift_unit(a->number);
            at.x[b->number] = axis_value(b, k) * lift_unit(b->number);
            if (lift_make(&at, &l, &why) == SW_OK) {
                lift_warn(t, &l);
                appraise(&at, &l, limit, 0, &p);
            } else {
                judge_not(why.text, &p.j);
            }
            if (p.j.verdict == VERDICT_NONE)
                count(&c, contradicts(g, &at, a, b, reason, sizeof reason) ? reason : p.j.why);
            out_number(o, axis_value(a, i));
            result_cell(o, axis_value(b, k));
            result_cell(o, p.j.least);
            fprintf(o->f, ",%s,", verdict_name(p.j.verdict));
            out_cell(o, p.j.why);
            putc('\n', o->f);
        }
    tell(&c);
}
