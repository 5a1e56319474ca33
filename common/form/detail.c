/* What exact statics ask of an arrangement beyond the formulas. */
#include "form/detail.h"
#include "phys/righting.h"

#include <math.h>

#define AGREE 0.01 /* distances that are given twice may differ by so much */

static enum status refuse(struct why *why, int quantity, int end, const char *text)
{
    char name[LIFT_NAME];

    lift_name(LIFT_AT(quantity, end), name);
    return fail(why, SW_ADMISSIBLE, "%s: %s", name, text);
}

/* Sizes are positive; heights lie within 10 km. */
static enum status judge_sizes(const double *x, int end, struct why *why)
{
    for (int q = LIFT_HOOK_DISTANCE; q <= LIFT_LOAD_HEIGHT; q++) {
        int is_height = q == LIFT_EDGE_HEIGHT || q == LIFT_LOW_EDGE_HEIGHT;

        if (!isnan(x[q]) && !(x[q] > (is_height ? -500 : 0) && x[q] < 500))
            return refuse(why, q, end,
                          is_height ? "must lie within 500 m" : "must lie above 0 and below 500 m");
    }
    return SW_OK;
}

static enum status take_hooks(const double *x, int end, const struct suspension *a,
                              struct detail *ret, struct why *why)
{
    int two = a->type == RIGGING_ELASTIC && end == 0;
    double n = x[LIFT_HOOKS];

    ret->hooks = isnan(n) ? 1 + two : n == 2 ? 2 : 1;
    ret->hook_distance = two ? x[LIFT_CROSS] : x[LIFT_HOOK_DISTANCE];
    ret->spreader_width = x[LIFT_SPREADER_WIDTH];
    if (!isnan(n) && n != 1 && n != 2)
        return refuse(why, LIFT_HOOKS, end, "expected 1 or 2");
    if (ret->hooks != 1 + two && (a->type != RIGGING_SECONDARY || end > 0))
        return refuse(why, LIFT_HOOKS, end,
                      two ? "elastic slings without a spreader hang on two hooks"
                          : "two hooks are known of primary-elastic and primary-secondary only");
    if (two && fabs(x[LIFT_HOOK_DISTANCE] - x[LIFT_CROSS]) > AGREE * x[LIFT_CROSS])
        return refuse(why, LIFT_HOOK_DISTANCE, end, "contradicts base_cross_m");
    if (ret->hooks == 2 && isnan(ret->hook_distance))
        return refuse(why, LIFT_HOOK_DISTANCE, end, "is missing: there are two hooks");
    if (ret->hooks == 1 && !isnan(ret->hook_distance))
        return refuse(why, LIFT_HOOK_DISTANCE, end, "is given, but hooks is not 2");
    if (!isnan(ret->spreader_width) && a->type != RIGGING_SECONDARY)
        return refuse(why, LIFT_SPREADER_WIDTH, end, "there is no spreader");
    return SW_OK;
}

static enum status take_edges(const double *x, int end, const struct suspension *a,
                              struct detail *ret, struct why *why)
{
    static const int width[] = {LIFT_EDGE_WIDTH, LIFT_LOW_EDGE_WIDTH};
    static const int height[] = {LIFT_EDGE_HEIGHT, LIFT_LOW_EDGE_HEIGHT};

    ret->edges = 0;
    for (int i = 0; i < 2; i++) {
        if (isnan(x[width[i]]) != isnan(x[height[i]]))
            return refuse(why, isnan(x[width[i]]) ? width[i] : height[i], end,
                          "is missing: an edge has a width and a height");
        if (isnan(x[width[i]]))
            continue;
        if (a->type == RIGGING_SINGLE || end > 0)
            return refuse(why, width[i], end,
                          "slings lean on edges in arrangements of one view only");
        ret->half[ret->edges] = x[width[i]] / 2;
        ret->height[ret->edges++] = x[height[i]];
    }
    if (ret->edges == 2 && !(ret->height[0] > ret->height[1]))
        return refuse(why, LIFT_LOW_EDGE_HEIGHT, end, "must lie below edge_height_m");
    return SW_OK;
}

/* Strain of each part at the present load. */
static enum status take_stretch(const double *x, int end, const struct suspension *a,
                                struct detail *ret, struct why *why)
{
    double force[2], wll[2] = {a->wll, a->wll_secondary};
    double at_wll[2] = {x[LIFT_STRAIN], x[LIFT_STRAIN_SECONDARY]};

    righting_upright(a, &force[0], &force[1]);
    if (isnan(at_wll[1]))
        at_wll[1] = a->type == RIGGING_SECONDARY ? at_wll[0] : NAN;
    for (int i = 0; i < 2; i++) {
        double use = i == 0 && !isnan(x[LIFT_USE]) ? x[LIFT_USE] : force[i] / wll[i];

        ret->stretch[i] = isnan(at_wll[i]) ? 0 : at_wll[i] * (isnan(use) ? 1 : use);
        if (!(at_wll[i] < 0) && !(ret->stretch[i] < 1))
            return refuse(why, i ? LIFT_STRAIN_SECONDARY : LIFT_STRAIN, end,
                          "makes a strain of 1 or more at this load");
        if (at_wll[i] < 0)
            return refuse(why, i ? LIFT_STRAIN_SECONDARY : LIFT_STRAIN, end,
                          "must not be negative");
    }
    if (a->type == RIGGING_ELASTIC)
        ret->stretch[0] = a->strain;
    if (!isnan(x[LIFT_STRAIN_SECONDARY]) && a->type != RIGGING_SECONDARY)
        return refuse(why, LIFT_STRAIN_SECONDARY, end, "there are no secondary slings");
    return SW_OK;
}

enum status detail_make(const double *x, int end, const struct suspension *a, struct detail *ret,
                        struct why *why)
{
    enum status s = judge_sizes(x, end, why);

    for (int i = 0; i < 3; i++)
        ret->load[i] = x[LIFT_LOAD_LONG + i];
    for (int i = 0; i < RIGGING_VIEWS; i++)
        ret->base[i] = x[LIFT_LONG + i];
    if (s == SW_OK)
        s = take_hooks(x, end, a, ret, why);
    if (s == SW_OK)
        s = take_edges(x, end, a, ret, why);
    return s == SW_OK ? take_stretch(x, end, a, ret, why) : s;
}
