/* Interval arithmetic with derivatives. */
#include "num/span.h"

#include <float.h>
#include <math.h>

struct pair {
    double lo, hi;
};

/* Outwards by the rounding of an operation or of a function of libm. */
static struct pair widen(double lo, double hi)
{
    return (struct pair){lo - 4 * DBL_EPSILON * fabs(lo) - DBL_MIN,
                         hi + 4 * DBL_EPSILON * fabs(hi) + DBL_MIN};
}

/* 0 times infinity is 0: bounds are numbers of the set, infinity is none. */
static double product(double x, double y)
{
    return x == 0 || y == 0 ? 0 : x * y;
}

static struct pair times(double alo, double ahi, double blo, double bhi)
{
    double p = product(alo, blo), q = product(alo, bhi);
    double r = product(ahi, blo), s = product(ahi, bhi);

    return widen(fmin(fmin(p, q), fmin(r, s)), fmax(fmax(p, q), fmax(r, s)));
}

static struct span make(int n, struct pair value)
{
    struct span x;

    x.n = n;
    x.lo = value.lo;
    x.hi = value.hi;
    return x;
}

struct span span_of(int n, double x)
{
    struct span ret = make(n, (struct pair){x, x});

    for (int i = 0; i < n; i++)
        ret.dlo[i] = ret.dhi[i] = 0;
    return ret;
}

struct span span_input(int n, int i, double lo, double hi)
{
    struct span ret = span_of(n, lo);

    ret.hi = hi;
    ret.dlo[i] = ret.dhi[i] = 1;
    return ret;
}

struct span span_none(void)
{
    return make(SPAN_NONE, (struct pair){NAN, NAN});
}

struct span span_add(struct span a, struct span b)
{
    struct span ret = make(a.n, widen(a.lo + b.lo, a.hi + b.hi));

    for (int i = 0; i < a.n; i++) {
        struct pair d = widen(a.dlo[i] + b.dlo[i], a.dhi[i] + b.dhi[i]);

        ret.dlo[i] = d.lo;
        ret.dhi[i] = d.hi;
    }
    return ret;
}

static struct span negative(struct span a)
{
    struct span ret = make(a.n, (struct pair){-a.hi, -a.lo});

    for (int i = 0; i < a.n; i++) {
        ret.dlo[i] = -a.dhi[i];
        ret.dhi[i] = -a.dlo[i];
    }
    return ret;
}

struct span span_sub(struct span a, struct span b)
{
    return span_add(a, negative(b));
}

struct span span_mul(struct span a, struct span b)
{
    struct span ret = make(a.n, times(a.lo, a.hi, b.lo, b.hi));

    for (int i = 0; i < a.n; i++) {
        struct pair da = times(a.dlo[i], a.dhi[i], b.lo, b.hi);
        struct pair db = times(b.dlo[i], b.dhi[i], a.lo, a.hi);
        struct pair d = widen(da.lo + db.lo, da.hi + db.hi);

        ret.dlo[i] = d.lo;
        ret.dhi[i] = d.hi;
    }
    return ret;
}

/* f(a) with f in value and f' in slope. */
static struct span chain(const struct span *a, struct pair value, struct pair slope)
{
    struct span ret = make(a->n, value);

    for (int i = 0; i < a->n; i++) {
        struct pair d = times(a->dlo[i], a->dhi[i], slope.lo, slope.hi);

        ret.dlo[i] = d.lo;
        ret.dhi[i] = d.hi;
    }
    return ret;
}

struct span span_div(struct span a, struct span b)
{
    struct pair value = {-INFINITY, INFINITY}, slope = value;

    if (b.lo > 0 || b.hi < 0) {
        value = widen(1 / b.hi, 1 / b.lo);
        slope = times(value.lo, value.hi, value.lo, value.hi);
        slope = (struct pair){-slope.hi, -slope.lo};
    } else if (b.lo == 0 && b.hi > 0) {
        value.lo = widen(1 / b.hi, 0).lo;
        slope.hi = 0;
    }
    return span_mul(a, chain(&b, value, slope));
}

struct span span_square(struct span a)
{
    double least = a.lo > 0 ? a.lo : a.hi < 0 ? -a.hi : 0;
    double most = fmax(fabs(a.lo), fabs(a.hi));

    return chain(&a, widen(least * least, most * most), widen(2 * a.lo, 2 * a.hi));
}

struct span span_root(struct span a)
{
    return chain(&a, widen(sqrt(a.lo), sqrt(a.hi)), widen(0.5 / sqrt(a.hi), 0.5 / sqrt(a.lo)));
}

struct span span_tan(struct span a)
{
    double lo = tan(a.lo), hi = tan(a.hi), least = a.lo > 0 ? lo : a.hi < 0 ? hi : 0;
    double most = fmax(fabs(lo), fabs(hi));

    return chain(&a, widen(lo, hi), widen(1 + least * least, 1 + most * most));
}

struct span span_cos(struct span a)
{
    return chain(&a, widen(cos(a.hi), cos(a.lo)), widen(-sin(a.hi), -sin(a.lo)));
}

static struct span hull(struct span a, struct span b)
{
    struct span ret = make(a.n, (struct pair){fmin(a.lo, b.lo), fmax(a.hi, b.hi)});

    for (int i = 0; i < a.n; i++) {
        ret.dlo[i] = fmin(a.dlo[i], b.dlo[i]);
        ret.dhi[i] = fmax(a.dhi[i], b.dhi[i]);
    }
    return ret;
}

struct span span_min(struct span a, struct span b)
{
    struct span ret;

    if (a.hi <= b.lo || b.hi <= a.lo)
        return a.hi <= b.lo ? a : b;
    ret = hull(a, b);
    ret.hi = fmin(a.hi, b.hi);
    return ret;
}

struct span span_either(struct span a, struct span b, struct span x)
{
    struct span ret = hull(a, b);

    for (int i = 0; i < x.n; i++)
        if (!(fabs(x.dlo[i]) <= DBL_MIN * 1e9 && fabs(x.dhi[i]) <= DBL_MIN * 1e9)) {
            ret.dlo[i] = -INFINITY;
            ret.dhi[i] = INFINITY;
        }
    return ret;
}
