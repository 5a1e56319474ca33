/* From the cells of a row to suspensions: what belongs to which type, and to which end of a pair.
 */
#include "form/lift.h"

#include <math.h>
#include <string.h>

#define AGREE 0.01 /* masses and lever arms that are both given may differ by so much */

/* x[quantity] of an end as column name, before text. */
static enum status refuse(struct why *why, int i, const char *text)
{
    char name[LIFT_NAME];

    lift_name(i, name);
    return fail(why, SW_ADMISSIBLE, "%s: %s", name, text);
}

/* A quantity that the type does not know is an error unless it is 0: the row may mean another type.
 */
static enum status judge_unused(const double *x, int end, enum rigging_type type, struct why *why)
{
    static const int of_spreaders[] = {LIFT_S, LIFT_GAMMA, LIFT_SPREADER};

    for (int k = 0; k < 3 && type != RIGGING_SECONDARY; k++)
        if (!isnan(x[of_spreaders[k]]) && x[of_spreaders[k]] != 0) {
            char text[100];

            snprintf(text, sizeof text, "type %s has no such quantity; is primary-secondary meant?",
                     lift_type_name((int)type));
            return refuse(why, LIFT_AT(of_spreaders[k], end), text);
        }
    return SW_OK;
}

/* The quantities of one suspension, numbered by enum lift_quantity, as struct rigging. */
static void to_rigging(const double *x, enum rigging_type type, int loose, struct rigging *ret)
{
    int spreader = type == RIGGING_SECONDARY;

    *ret = (struct rigging){.type = type,
                            .v = type == RIGGING_SINGLE ? NAN : x[LIFT_V],
                            .s = spreader ? x[LIFT_S] : NAN,
                            .z = x[LIFT_Z],
                            .phi = type == RIGGING_SINGLE ? NAN : x[LIFT_PHI],
                            .gamma = spreader ? x[LIFT_GAMMA] : NAN,
                            .m_spreader = spreader ? x[LIFT_SPREADER] : NAN,
                            .m_load = x[LIFT_LOAD],
                            .sling = x[LIFT_SLING],
                            .base = {x[LIFT_LONG], x[LIFT_CROSS]},
                            .strain_wll = x[LIFT_STRAIN],
                            .use = x[LIFT_USE],
                            .wll = x[LIFT_WLL],
                            .wll_secondary = x[LIFT_WLL_SECONDARY],
                            .slings = x[LIFT_SLINGS],
                            .stabilized = x[LIFT_STABILIZED],
                            .loose = loose};
}

/* What rigging_complete refuses, by the name of the column. */
static enum status refuse_fault(const struct rigging_fault *f, int end, struct why *why)
{
    char name[LIFT_NAME] = "", number[40] = "";

    for (int i = 0; i < LIFT_QUANTITIES; i++)
        if (strcmp(f->quantity, lift_stem(i)) == 0)
            lift_name(LIFT_AT(i, end), name);
    if (!isnan(f->value))
        snprintf(number, sizeof number, " (%.6g%s%s)", f->value, f->unit[0] ? " " : "", f->unit);
    return fail(why, SW_ADMISSIBLE, "%s: %s%s", name, f->text, number);
}

static enum status complete(const double *x, int end, enum rigging_type type, int loose,
                            struct suspension *ret, struct detail *ret_detail, struct why *why)
{
    struct rigging r;
    struct rigging_fault fault;
    enum status s = judge_unused(x, end, type, why);

    if (s != SW_OK)
        return s;
    to_rigging(x, type, loose, &r);
    s = rigging_complete(&r, ret, &fault);
    return s == SW_OK ? detail_make(x, end, ret, ret_detail, why) : refuse_fault(&fault, end, why);
}

static enum status make_one(const struct lift_given *g, struct lift *ret, struct why *why)
{
    double x[LIFT_QUANTITIES];

    for (int i = 0; i < LIFT_E1; i++)
        if (i % LIFT_ENDS > 0 && !isnan(g->x[i]))
            return refuse(why, i, "belongs to an end of a pair; the type is not pair");
    for (int q = 0; q < LIFT_QUANTITIES; q++)
        x[q] = g->x[LIFT_AT(q, 0)];
    ret->ends = 1;
    ret->assumed[0] = isnan(x[LIFT_SLINGS]);
    ret->share[0] = 1;
    ret->share[1] = 0;
    return complete(x, 0, (enum rigging_type)g->type[0], g->loose, &ret->end[0], &ret->detail[0],
                    why);
}

/* Shares of the mass by the lever arms, m1 : m2 = e2 : e1 (33), or by the masses. */
static enum status find_shares(const struct lift_given *g, double share[2], double m[2],
                               struct why *why)
{
    double e1 = g->x[LIFT_E1], e2 = g->x[LIFT_E2], all = g->x[LIFT_AT(LIFT_LOAD, 0)];

    for (int k = 0; k < 2; k++) {
        m[k] = g->x[LIFT_AT(LIFT_LOAD, k + 1)];
        if (!isnan(m[k]) && !(m[k] > 0))
            return refuse(why, LIFT_AT(LIFT_LOAD, k + 1), "must be positive");
        if (!isnan(g->x[LIFT_E1 + k]) && !(g->x[LIFT_E1 + k] > 0))
            return refuse(why, LIFT_E1 + k, "must be positive");
    }
    if (!isnan(all) && !(all > 0))
        return refuse(why, LIFT_AT(LIFT_LOAD, 0), "must be positive");
    share[0] = isnan(m[0] + m[1]) ? e2 / (e1 + e2) : m[0] / (m[0] + m[1]);
    if (isnan(share[0]) && m[0] < all)
        share[0] = m[0] / all;
    if (isnan(share[0]) && m[1] < all)
        share[0] = 1 - m[1] / all;
    if (isnan(share[0]))
        return refuse(why, LIFT_E1,
                      "is missing; a pair needs e1_m and e2_m, or m_load_1_t and m_load_2_t");
    if (!g->loose && !isnan(e1 + e2) && fabs(share[0] - e2 / (e1 + e2)) > AGREE)
        return refuse(why, LIFT_E1, "contradicts the masses: m_1 to m_2 must be as e2 to e1");
    share[1] = 1 - share[0];
    if (!g->loose && !isnan(all + m[0] + m[1]) && !(fabs(m[0] + m[1] - all) <= AGREE * all))
        return refuse(why, LIFT_AT(LIFT_LOAD, 0), "is not the sum of the masses of the ends");
    for (int k = 0; k < 2; k++) {
        double of_other = m[1 - k] * share[k] / share[1 - k];

        if (isnan(m[k]))
            m[k] = isnan(all) ? of_other : all * share[k];
    }
    return SW_OK;
}

/* Type of an end by what is given of it. */
static int guess_type(const double *x)
{
    if (!isnan(x[LIFT_S]))
        return RIGGING_SECONDARY;
    return !isnan(x[LIFT_V]) ? RIGGING_PRIMARY : RIGGING_SINGLE;
}

/* Quantities of an end: its own, or those of both ends.  The view is the crosswise one; an elastic
 * end has its slings in it. */
static enum status make_end(const struct lift_given *g, int end, double m_load, struct lift *ret,
                            struct why *why)
{
    double x[LIFT_QUANTITIES];
    int type = g->type[end];

    for (int q = 0; q < LIFT_QUANTITIES; q++)
        x[q] = g->x[LIFT_AT(q, isnan(g->x[LIFT_AT(q, end)]) ? 0 : end)];
    x[LIFT_LOAD] = m_load;
    if (type == LIFT_UNKNOWN)
        type = guess_type(x);
    if (type == LIFT_PAIR)
        return fail(why, SW_ADMISSIBLE, "type_%d: an end of a pair is no pair", end);
    if (!isnan(x[LIFT_LONG]))
        return refuse(why, LIFT_AT(LIFT_LONG, end),
                      "a pair is judged in the crosswise view; give base_cross");
    if (type == RIGGING_ELASTIC)
        x[LIFT_LONG] = x[LIFT_CROSS];
    ret->assumed[end - 1] = isnan(x[LIFT_SLINGS]);
    if (ret->assumed[end - 1])
        x[LIFT_SLINGS] = type == RIGGING_SINGLE ? 1 : 2;
    return complete(x, end, (enum rigging_type)type, g->loose, &ret->end[end - 1],
                    &ret->detail[end - 1], why);
}

static enum status make_pair(const struct lift_given *g, struct lift *ret, struct why *why)
{
    double m[2] = {NAN, NAN};
    enum status s = find_shares(g, ret->share, m, why);

    ret->ends = 2;
    if (s == SW_OK && g->x[LIFT_AT(LIFT_SPREADER, 0)] > 0)
        s = refuse(why, LIFT_AT(LIFT_SPREADER, 0),
                   "a pair has m_spreader_1_t and m_spreader_2_t, each with its end");
    for (int end = 1; end <= 2 && s == SW_OK; end++)
        s = make_end(g, end, m[end - 1], ret, why);
    return s;
}

enum status lift_make(const struct lift_given *g, struct lift *ret, struct why *why)
{
    double offset = g->x[LIFT_OFFSET];

    ret->offset = fabs(offset);
    ret->apart = g->x[LIFT_E1] + g->x[LIFT_E2];
    if (g->tol[LIFT_OFFSET] > 0)
        ret->offset = (isnan(offset) ? 0 : fabs(offset)) + g->tol[LIFT_OFFSET];
    if (!isnan(offset) && !(fabs(offset) < 500))
        return refuse(why, LIFT_OFFSET, "must lie within 500 m");
    if (g->type[0] == LIFT_UNKNOWN)
        return fail(why, SW_ADMISSIBLE, "type: is missing");
    return g->type[0] == LIFT_PAIR ? make_pair(g, ret, why) : make_one(g, ret, why);
}

/* A number of an end that follows, unless it is given for both. */
static void put(struct lift_given *g, int q, int end, double value)
{
    if (isnan(g->x[LIFT_AT(q, 0)]) || end == 0 || q == LIFT_LOAD)
        g->x[LIFT_AT(q, end)] = value;
}

static void write_back(const struct suspension *a, int end, struct lift_given *g)
{
    int main_view = isnan(a->T[RIGGING_LONG]) && !isnan(a->T[RIGGING_CROSS]);
    double T = a->T[main_view];

    put(g, LIFT_Z, end, a->z);
    put(g, LIFT_SLINGS, end, a->slings);
    put(g, LIFT_STABILIZED, end, a->stabilized);
    put(g, LIFT_LOAD, end, a->m_load);
    if (a->type == RIGGING_SINGLE)
        return;
    put(g, LIFT_V, end, a->v);
    if (isfinite(T)) {
        put(g, LIFT_PHI, end, atan(T));
        put(g, end > 0 || main_view ? LIFT_CROSS : LIFT_LONG, end, 2 * (a->v * T + a->s * a->t));
    }
    if (a->type == RIGGING_ELASTIC)
        put(g, LIFT_USE, end, a->use);
    if (a->type != RIGGING_SECONDARY)
        return;
    put(g, LIFT_S, end, a->s);
    put(g, LIFT_GAMMA, end, atan(a->t));
    put(g, LIFT_SPREADER, end, a->m_spreader);
}

void lift_resolve(const struct lift *l, struct lift_given *g)
{
    if (l->ends == 1)
        write_back(&l->end[0], 0, g);
    for (int end = 1; end <= 2 && l->ends == 2; end++) {
        g->type[end] = (int)l->end[end - 1].type;
        write_back(&l->end[end - 1], end, g);
    }
}
