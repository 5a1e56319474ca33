/* Metacentric heights of suspensions: the document's formulas and the corrected ones. */
#include "phys/rigging.h"
#include "num/pi.h"
#include "num/root.h"

#include <math.h>

#define AGREE 0.01 /* quantities given twice may differ by so much: they were rounded */

double rigging_c(double T, double t, double mu)
{
    return (1 - mu * t / T) / (1 + t * t); /* cos^2 - mu sin cos/T */
}

double rigging_tilt_ratio(const struct suspension *a)
{
    double T = a->T[isnan(a->T[RIGGING_LONG])];

    if (a->type != RIGGING_SECONDARY)
        return 1;
    return 1 - rigging_c(T, a->t, a->mu) * a->s * a->t / (a->v * T + a->s * a->t);
}

/* (15), with 1 - c = (t^2 + mu t/T)/(1 + t^2). */
static double secondary_height(const struct suspension *a, double T)
{
    double t = a->t;

    return a->s * (t * t + a->mu * t / T) / (1 + t * t) + a->v * a->mu -
           a->z * rigging_tilt_ratio(a);
}

static double elastic_long(const struct suspension *a, double b)
{
    return a->v * (1 - a->strain) / (1 + 4 * a->v * a->v * a->strain / (b * b)) - a->z;
}

static double elastic_cross(const struct suspension *a, double b, double l)
{
    double v = a->v, cos2 = 1 / (1 + b * b / (4 * v * v));

    if (a->strain == 0)
        return INFINITY;
    return l * l / (4 * v) * (cos2 / a->strain + 1 - cos2) - a->z;
}

/* (25) and (32). */
static double document_elastic(const struct suspension *a, enum rigging_view view)
{
    double b = a->base[RIGGING_LONG], l = a->base[RIGGING_CROSS], v = a->v;

    if (view == RIGGING_LONG)
        return v - a->z * (1 + 4 * (v * v + b * b / 4) * a->strain / (b * b));
    return a->strain == 0 ? INFINITY : l * l / (4 * v * a->strain) - a->z;
}

/* Narrow slings let go at a small disturbance (1.3.1). */
static int is_narrow(const struct suspension *a, enum rigging_view view)
{
    return a->T[view] < RIGGING_TAN5 && a->z > a->v * a->T[view] && !a->stabilized;
}

static void height(const struct suspension *a, enum rigging_view view, struct rigging_heights *ret)
{
    const double *base = a->base;
    double h = NAN, document = NAN;

    switch (a->type) {
    case RIGGING_SINGLE: h = 0 - a->z; break; /* never -0 */
    case RIGGING_PRIMARY: h = a->v - a->z; break;
    case RIGGING_SECONDARY: h = secondary_height(a, a->T[view]); break;
    case RIGGING_ELASTIC:
        document = document_elastic(a, view);
        h = view == RIGGING_LONG ? elastic_long(a, base[0]) : elastic_cross(a, base[0], base[1]);
    }
    if (a->type != RIGGING_ELASTIC)
        document = h;
    ret->ruled[view] =
        a->type != RIGGING_SINGLE && a->type != RIGGING_SECONDARY && is_narrow(a, view);
    if (ret->ruled[view])
        h = document = 0 - a->z;
    ret->h[view] = h;
    ret->document[view] = document;
    ret->centre[view] = a->type == RIGGING_SINGLE || ret->ruled[view] ? 0
                        : isnan(a->T[view])                           ? NAN
                                                                      : a->v + a->s;
}

/* Two hooks hold the load crosswise without an angle; a single sling without a base. */
static int is_described(const struct suspension *a, enum rigging_view view)
{
    return a->type == RIGGING_SINGLE || !isnan(a->T[view]) ||
           (a->type == RIGGING_ELASTIC && view == RIGGING_CROSS);
}

void rigging_heights(const struct suspension *a, struct rigging_heights *ret)
{
    double T = a->T[isnan(a->T[RIGGING_LONG])];

    ret->c = a->type == RIGGING_SECONDARY ? rigging_c(T, a->t, a->mu) : NAN;
    ret->r = rigging_tilt_ratio(a);
    for (int view = 0; view < RIGGING_VIEWS; view++) {
        ret->h[view] = ret->document[view] = ret->centre[view] = NAN;
        ret->ruled[view] = 0;
        if (is_described(a, (enum rigging_view)view))
            height(a, (enum rigging_view)view, ret);
    }
}

double rigging_least(const double h[RIGGING_VIEWS], enum rigging_view *ret_view)
{
    *ret_view =
        isnan(h[RIGGING_LONG]) || h[RIGGING_CROSS] < h[RIGGING_LONG] ? RIGGING_CROSS : RIGGING_LONG;
    return h[*ret_view];
}

static double least_height(const struct suspension *a)
{
    struct rigging_heights heights;
    enum rigging_view view;

    rigging_heights(a, &heights);
    return rigging_least(heights.h, &view);
}

/* h falls with z by r in every view, by 1 without a spreader. */
double rigging_critical_z(const struct suspension *a)
{
    struct suspension wide = *a;
    double z;

    wide.stabilized = 1;
    wide.z = 0;
    z = least_height(&wide) / rigging_tilt_ratio(&wide);
    for (int view = 0; view < RIGGING_VIEWS; view++)
        if ((a->type == RIGGING_PRIMARY || a->type == RIGGING_ELASTIC) && !a->stabilized &&
            a->T[view] < RIGGING_TAN5)
            z = fmin(z, a->v * a->T[view]);
    return z;
}

#define STEPS 48 /* of the search outwards from the present value, each side */

/* x nearest to 0 in (low, high) where f passes 0, f(0) = f0; NAN: none.  Steps grow from first. */
static double nearest(scalar_function *f, void *context, double low, double high, double first)
{
    double at[2] = {0, 0}, value[2], step = first;

    value[0] = value[1] = f(0, context);
    for (int i = 0; i < STEPS && (at[0] > low || at[1] < high); i++) {
        double root[2] = {NAN, NAN};

        for (int side = 0; side < 2; side++) {
            double x = side == 0 ? fmax(at[0] - step, low) : fmin(at[1] + step, high);
            double y = f(x, context);

            if ((y > 0) != (value[side] > 0))
                root[side] = root_between(f, context, at[side], value[side], x, y);
            at[side] = x;
            value[side] = y;
        }
        if (!isnan(root[0]) || !isnan(root[1]))
            return !(fabs(root[1]) < fabs(root[0])) && !isnan(root[0]) ? root[0] : root[1];
        step *= 1.2;
    }
    return NAN;
}

/* Least height at v exp(x); the base of elastic slings stays, and with it their angle changes. */
static double at_v(double x, void *context)
{
    struct suspension a = *(const struct suspension *)context;
    double factor = exp(x);

    a.v *= factor;
    if (a.type == RIGGING_ELASTIC)
        a.T[RIGGING_LONG] /= factor;
    return least_height(&a);
}

double rigging_critical_v(const struct suspension *a)
{
    struct suspension copy = *a;
    double T = a->T[isnan(a->T[RIGGING_LONG])], low = -log(1000);

    if (a->type == RIGGING_SINGLE)
        return NAN;
    if (a->t < 0) /* below this v there is no base */
        low = fmax(low, log(-(1 + 1e-6) * a->s * a->t / (a->v * T)));
    return a->v * exp(nearest(at_v, &copy, fmin(low, 0), log(1000), 0.001));
}

static double at_gamma(double x, void *context)
{
    struct suspension a = *(const struct suspension *)context;

    a.t += x;
    return least_height(&a);
}

double rigging_critical_gamma(const struct suspension *a)
{
    struct suspension copy = *a;
    double T = a->T[isnan(a->T[RIGGING_LONG])], steepest = tan(89 * PI / 180);

    if (a->type != RIGGING_SECONDARY || isinf(T))
        return NAN;
    return atan(a->t + nearest(at_gamma, &copy,
                               fmax(-(1 - 1e-6) * a->v * T / a->s, -steepest) - a->t,
                               steepest - a->t, 1e-3));
}

/* What rigging_complete says of one quantity. */
static enum status refuse(struct rigging_fault *fault, const char *quantity, const char *text,
                          double value, const char *unit)
{
    *fault = (struct rigging_fault){quantity, text, value, unit};
    return SW_ADMISSIBLE;
}

/* Not given, or within (low, high); low itself may be allowed. */
static int outside(double x, double low, int low_allowed, double high)
{
    return !isnan(x) && !((low_allowed ? x >= low : x > low) && x < high);
}

static enum status judge_ranges(const struct rigging *r, struct rigging_fault *fault)
{
    const double quarter = PI / 2;
    const struct {
        const char *quantity;
        double x, low;
        int low_allowed;
        double high;
        const char *text, *unit;
        double size; /* of the unit */
    } range[] = {
        {"v", r->v, 0, 0, 500, "must lie above 0 and below 500 m", "m", 1},
        {"s", r->s, 0, 0, 500, "must lie above 0 and below 500 m", "m", 1},
        {"z", r->z, -500, 0, 500, "must lie within 500 m", "m", 1},
        {"phi", r->phi, 0, 0, quarter, "must lie above 0 and below 90 degrees", "deg", PI / 180},
        {"gamma", r->gamma, -quarter, 0, quarter, "must lie within 90 degrees", "deg", PI / 180},
        {"m_spreader", r->m_spreader, 0, 1, 1e9, "must not be negative", "t", 1000},
        {"m_load", r->m_load, 0, 0, 1e8, "must lie above 0 and below 100000 t", "t", 1000},
        {"sling", r->sling, 0, 0, 500, "must lie above 0 and below 500 m", "m", 1},
        {"base_long", r->base[RIGGING_LONG], 0, 0, 500, "must lie above 0 and below 500 m", "m", 1},
        {"base_cross", r->base[RIGGING_CROSS], 0, 0, 500, "must lie above 0 and below 500 m", "m",
         1},
        {"strain_wll", r->strain_wll, 0, 1, 1, "must lie from 0 to below 1", "", 1},
        {"use", r->use, 0, 1, 1e3, "must not be negative", "", 1},
        {"wll", r->wll, 0, 0, 1e8, "must lie above 0 and below 100 MN", "kN", 1000},
        {"wll_secondary", r->wll_secondary, 0, 0, 1e8, "must lie above 0 and below 100 MN", "kN",
         1000},
        {"slings", r->slings, 0, 0, 1e3, "must be positive", "", 1},
    };

    for (unsigned i = 0; i < sizeof range / sizeof *range; i++)
        if (outside(range[i].x, range[i].low, range[i].low_allowed, range[i].high))
            return refuse(fault, range[i].quantity, range[i].text, range[i].x / range[i].size,
                          range[i].unit);
    if (isnan(r->z))
        return refuse(fault, "z", "is missing", NAN, "");
    if (!isnan(r->slings) &&
        (r->slings != floor(r->slings) || (r->type != RIGGING_SINGLE && r->slings < 2)))
        return refuse(fault, "slings", "expected a whole number, from 2 on unless single",
                      r->slings, "");
    if (!r->loose && r->m_spreader > 10 * r->m_load)
        return refuse(fault, "m_spreader", "is over ten times the load; are both in tonnes?",
                      r->m_spreader / 1000, "t");
    return SW_OK;
}

static int agree(const struct rigging *r, double x, double y)
{
    return r->loose || fabs(x - y) <= AGREE * fabs(y);
}

/* Square of the horizontal reach of a primary sling to the lifting points. */
static double reach2(const struct rigging *r)
{
    double b = r->base[RIGGING_LONG] / 2, l = r->base[RIGGING_CROSS] / 2;

    if (r->type == RIGGING_ELASTIC || isnan(l))
        return b * b;
    return isnan(b) ? l * l : b * b + l * l;
}

/* v, or v from the sling: by its angle under a hook and a spreader, else by the base. */
static enum status find_v(const struct rigging *r, double *ret, struct rigging_fault *fault)
{
    double v = NAN, reach = r->type == RIGGING_SECONDARY ? NAN : reach2(r);
    double give = isnan(r->strain_wll) ? 1 : 1 + r->strain_wll;

    *ret = r->v;
    if (!isnan(r->v) && r->loose)
        return SW_OK;
    if (!isnan(r->sling) && !isnan(reach)) {
        if (!(r->sling * r->sling > reach))
            return refuse(fault, "sling", "is too short to reach the lifting points", r->sling,
                          "m");
        v = sqrt(r->sling * r->sling - reach);
    } else if (!isnan(r->sling) && !isnan(r->phi)) {
        v = r->sling * cos(r->phi);
    }
    *ret = isnan(r->v) ? v : r->v;
    if (isnan(*ret))
        return refuse(fault, "v", "is missing, and no sling that it follows from is given", NAN,
                      "");
    if (isnan(v) || isnan(r->v))
        return SW_OK;
    if (!isnan(reach)) { /* lengths are compared: v is badly determined by a flat sling */
        double wanted = sqrt(r->v * r->v + reach);

        if (!(r->sling * give >= (1 - AGREE) * wanted))
            return refuse(fault, "sling", "is too short to reach the lifting points", r->sling,
                          "m");
        return r->sling <= (1 + AGREE) * wanted
                   ? SW_OK
                   : refuse(fault, "sling", "is longer than v and base say", r->sling, "m");
    }
    return agree(r, v, r->v) ? SW_OK
                             : refuse(fault, "sling", "contradicts v and phi", r->sling, "m");
}

/* Angle of a view without a spreader: phi belongs to the view whose base is given, to the
 * lengthwise one if both or none are. */
static enum status find_angles(const struct rigging *r, struct suspension *a,
                               struct rigging_fault *fault)
{
    int main_view = r->type != RIGGING_ELASTIC && isnan(r->base[RIGGING_LONG]) &&
                    !isnan(r->base[RIGGING_CROSS]);

    for (int view = 0; view < RIGGING_VIEWS; view++)
        a->T[view] = r->base[view] / (2 * a->v);
    if (r->type == RIGGING_ELASTIC)
        a->T[RIGGING_CROSS] = NAN; /* two hooks: the slings hang vertically in this view */
    if (isnan(r->phi)) {
        if (isnan(a->T[main_view]))
            a->T[main_view] = INFINITY;
        return SW_OK;
    }
    if (!isnan(a->T[main_view]) && !agree(r, tan(r->phi), a->T[main_view]))
        return refuse(fault, "phi", "contradicts v and base; base over 2 v makes it",
                      atan(a->T[main_view]) * 180 / PI, "deg");
    if (isnan(a->T[main_view]))
        a->T[main_view] = tan(r->phi);
    return SW_OK;
}

static enum status complete_elastic(const struct rigging *r, struct suspension *a,
                                    struct rigging_fault *fault)
{
    double cosine;

    if (isnan(a->base[RIGGING_LONG]) && !isnan(r->phi))
        a->base[RIGGING_LONG] = 2 * a->v * tan(r->phi);
    if (isnan(a->base[RIGGING_LONG]))
        return refuse(fault, "base_long", "is missing", NAN, "");
    if (isnan(r->base[RIGGING_CROSS]))
        return refuse(fault, "base_cross", "is missing: the distance of the two hooks", NAN, "");
    if (isnan(r->strain_wll))
        return refuse(fault, "strain_wll", "is missing", NAN, "");
    a->T[RIGGING_LONG] = a->base[RIGGING_LONG] / (2 * a->v);
    cosine = 1 / sqrt(1 + a->T[RIGGING_LONG] * a->T[RIGGING_LONG]);
    a->use = r->m_load * RIGGING_GRAVITY / (a->slings * cosine * r->wll);
    if (!r->loose && !isnan(r->use) && a->use > (1 + AGREE) * r->use)
        return refuse(fault, "use", "is less than weight and wll make it", a->use, "");
    if (!isnan(r->use) || isnan(a->use))
        a->use = isnan(r->use) ? 1 : r->use;
    a->strain = r->strain_wll * a->use;
    return a->strain < 1 ? SW_OK : refuse(fault, "use", "makes a strain of 1 or more", a->use, "");
}

/* What a spreader's geometry needs. */
static enum status judge_secondary(const struct rigging *r, struct rigging_fault *fault)
{
    if (isnan(r->s))
        return refuse(fault, "s", "is missing", NAN, "");
    if (isnan(r->phi) && r->gamma != 0)
        return refuse(fault, "phi", "is missing", NAN, "");
    if (isnan(r->gamma) && isnan(r->base[0]) && isnan(r->base[1]))
        return refuse(fault, "gamma", "is missing, and no base that it follows from is given", NAN,
                      "");
    if (isnan(r->gamma) && !isnan(r->base[0]) && !isnan(r->base[1]))
        return refuse(fault, "gamma",
                      "is missing, and which of the two bases belongs to the spreader", NAN, "");
    if (isnan(r->m_spreader))
        return refuse(fault, "m_spreader", "is missing", NAN, "");
    if (r->m_spreader > 0 && isnan(r->m_load))
        return refuse(fault, "m_load", "is missing", NAN, "");
    return SW_OK;
}

/* One view, that in which the spreader is seen in its length: the one whose base is given; of two
 * the one that agrees with the angles; without any the crosswise one. */
static enum status complete_secondary(const struct rigging *r, struct suspension *a,
                                      struct rigging_fault *fault)
{
    enum rigging_view view = isnan(r->base[RIGGING_LONG]) ? RIGGING_CROSS : RIGGING_LONG;
    double T = isnan(r->phi) ? INFINITY : tan(r->phi), half;

    if (judge_secondary(r, fault) != SW_OK)
        return SW_ADMISSIBLE;
    a->s = r->s;
    a->t = isnan(r->gamma) ? (r->base[view] / 2 - a->v * T) / a->s : tan(r->gamma);
    half = a->v * T + a->s * a->t;
    if (!(half > 0))
        return refuse(fault, "gamma", "leaves no base: v tan(phi) + s tan(gamma) must be positive",
                      half, "m");
    if (!isnan(r->base[RIGGING_CROSS]) && agree(r, 2 * half, r->base[RIGGING_CROSS]))
        view = RIGGING_CROSS;
    if (!isnan(r->base[view]) && isfinite(half) && !agree(r, 2 * half, r->base[view]))
        return refuse(fault, "gamma", "contradicts the base; v, s, phi and gamma make it", 2 * half,
                      "m");
    a->T[RIGGING_LONG] = a->T[RIGGING_CROSS] = NAN;
    a->T[view] = T;
    a->mu = r->m_spreader > 0 ? 1 + r->m_spreader / r->m_load : 1;
    a->m_spreader = r->m_spreader;
    return SW_OK;
}

enum status rigging_complete(const struct rigging *r, struct suspension *ret,
                             struct rigging_fault *fault)
{
    enum status s = judge_ranges(r, fault);

    *ret = (struct suspension){.type = r->type,
                               .z = r->z,
                               .mu = 1,
                               .use = NAN,
                               .m_load = r->m_load,
                               .wll = r->wll,
                               .stabilized = !isnan(r->stabilized) && r->stabilized != 0,
                               .T = {NAN, NAN},
                               .base = {r->base[0], r->base[1]}};
    ret->wll_secondary = isnan(r->wll_secondary) ? r->wll : r->wll_secondary;
    ret->slings = !isnan(r->slings) ? r->slings : r->type == RIGGING_SINGLE ? 1 : 4;
    if (s != SW_OK || r->type == RIGGING_SINGLE)
        return s;
    s = find_v(r, &ret->v, fault);
    if (s == SW_OK && r->type == RIGGING_SECONDARY)
        return complete_secondary(r, ret, fault);
    if (s == SW_OK)
        s = find_angles(r, ret, fault);
    if (s == SW_OK && r->type == RIGGING_ELASTIC)
        s = complete_elastic(r, ret, fault);
    return s;
}
