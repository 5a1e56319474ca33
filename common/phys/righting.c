/* Tilt, forces and righting moment of suspensions. */
#include "phys/righting.h"

#include <math.h>

/* 1/cos of the slope of a primary sling, tan^2 of which is the sum of both views'; NAN: not known.
 */
static double slope(const struct suspension *a)
{
    double sum = 1;

    for (int view = 0; view < RIGGING_VIEWS; view++)
        if (!isnan(a->T[view]))
            sum += a->T[view] * a->T[view];
    return isinf(sum) ? NAN : sqrt(sum);
}

void righting_upright(const struct suspension *a, double *ret_primary, double *ret_secondary)
{
    double each = a->m_load * RIGGING_GRAVITY / a->slings;

    *ret_secondary = NAN;
    *ret_primary = a->type == RIGGING_SINGLE ? each : each * slope(a);
    if (a->type != RIGGING_SECONDARY)
        return;
    *ret_primary = (a->m_load + a->m_spreader) * RIGGING_GRAVITY / a->slings * slope(a);
    *ret_secondary = each * sqrt(1 + a->t * a->t);
}

/*
 * Forces over the upright one for the share x that moves from side to side: V = V0 (1 +- x), while
 * the horizontal part, V0 q, is even in x.
 */
static void shift(double upright, double q, double x, double *ret_low, double *ret_high)
{
    double low = 1 + x, high = 1 - x, all = sqrt(1 + q * q);

    *ret_low = upright * sqrt(low * low + q * q) / all;
    *ret_high = high < 0 ? -upright * sqrt(high * high + q * q) / all
                         : upright * sqrt(high * high + q * q) / all;
}

static void moments(const struct suspension *a, double T, double h, double tan_delta,
                    struct righting *ret)
{
    double each = a->m_load * RIGGING_GRAVITY / a->slings;

    ret->range = atan(T);
    if (a->type == RIGGING_SECONDARY)
        return;
    ret->moment_0 = each * h * T;
    ret->moment = each * h * (T - tan_delta * tan_delta / T) / sqrt(1 + tan_delta * tan_delta);
}

void righting_at(const struct suspension *a, enum rigging_view view, double h, double tilt,
                 struct righting *ret)
{
    double up, up2, T = a->T[view], by = isnan(tilt) ? 0 : tilt, delta = atan(by);
    double load = rigging_tilt_ratio(a) * by;

    *ret = (struct righting){NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    righting_upright(a, &up, &up2);
    ret->load = atan(isnan(tilt) ? NAN : load);
    if (a->type == RIGGING_SECONDARY)
        ret->spreader = atan(tilt);
    if (isfinite(T))
        moments(a, T, h, by, ret);
    if (a->type == RIGGING_SINGLE) {
        ret->primary_low = ret->primary_high = up;
    } else if (a->type == RIGGING_ELASTIC) {
        double q = isnan(T) ? 0 : T;

        shift(up, q, 2 * (h + a->z) * by / a->base[view] + by * q, &ret->primary_low,
              &ret->primary_high);
    } else {
        ret->primary_low = up * (cos(delta) + sin(delta) / T);
        ret->primary_high = up * (cos(delta) - sin(delta) / T);
    }
    if (a->type == RIGGING_SECONDARY)
        shift(up2, a->t,
              by == 0    ? 0
              : isinf(T) ? NAN
                         : by * (a->mu / T + a->t),
              &ret->secondary_low, &ret->secondary_high);
}
