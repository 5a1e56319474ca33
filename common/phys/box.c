/* The heights of phys/rigging.c in interval arithmetic. */
#include "phys/box.h"
#include "num/pi.h"

static int is_given(const struct span *x)
{
    return x->n != SPAN_NONE;
}

/* Within (0, high) if given. */
static int is_positive(const struct span *x, double high)
{
    return !is_given(x) || (x->lo > 0 && x->hi < high);
}

static int in_range(const struct rigging_box *b)
{
    return is_positive(&b->v, 1e4) && is_positive(&b->s, 1e4) && is_positive(&b->phi, PI / 2) &&
           is_positive(&b->m_load, 1e9) && is_positive(&b->sling, 1e4) &&
           is_positive(&b->base[0], 1e4) && is_positive(&b->base[1], 1e4) &&
           is_positive(&b->wll, 1e12) && !(is_given(&b->m_spreader) && b->m_spreader.lo < 0) &&
           !(is_given(&b->strain_wll) && !(b->strain_wll.lo >= 0 && b->strain_wll.hi < 1)) &&
           !(is_given(&b->use) && b->use.lo < 0) &&
           !(is_given(&b->gamma) && !(b->gamma.lo > -PI / 2 && b->gamma.hi < PI / 2));
}

static struct span number(const struct rigging_box *b, double x)
{
    return span_of(b->n, x);
}

static struct span scaled(double k, struct span x)
{
    return span_mul(span_of(x.n, k), x);
}

static struct span half_square(const struct span *x)
{
    return span_square(scaled(0.5, *x));
}

/* v, or v from the sling; 0: the sling may be too short, or nothing tells its angle. */
static int find_v(const struct rigging_box *b, struct span *ret)
{
    const struct span *first, *second;
    struct span reach;

    *ret = b->v;
    if (is_given(ret))
        return 1;
    first = b->type == RIGGING_ELASTIC ? &b->base[b->one_hook] : &b->base[0];
    second = b->type == RIGGING_ELASTIC ? first : &b->base[1]; /* the view along one base alone */
    if (b->type == RIGGING_SECONDARY || (!is_given(first) && !is_given(second))) {
        if (!is_given(&b->phi))
            return 0;
        *ret = span_mul(b->sling, span_cos(b->phi));
        return 1;
    }
    if (first == second || !is_given(second))
        reach = half_square(first);
    else if (!is_given(first))
        reach = half_square(second);
    else
        reach = span_add(half_square(first), half_square(second));
    reach = span_sub(span_square(b->sling), reach);
    if (!(reach.lo > 0))
        return 0;
    *ret = span_root(reach);
    return 1;
}

/* One view without a spreader: high is h of the whole sling, -z that under the rule of 5 degrees.
 */
static struct span ruled(const struct rigging_box *b, struct span T, struct span v,
                         struct span high)
{
    struct span low = scaled(-1, b->z), edge = span_mul(v, T);

    if (b->stabilized || T.lo >= RIGGING_TAN5 || b->z.hi <= edge.lo)
        return high;
    if (T.hi < RIGGING_TAN5 && b->z.lo > edge.hi)
        return low;
    return span_either(span_either(span_either(low, high, T), high, v), high, b->z);
}

static struct span primary_height(const struct rigging_box *b, struct span v)
{
    int main_view = !is_given(&b->base[0]) && is_given(&b->base[1]);
    struct span h[RIGGING_VIEWS], high = span_sub(v, b->z);

    for (int view = 0; view < RIGGING_VIEWS; view++) {
        h[view] = span_none();
        if (is_given(&b->base[view]))
            h[view] = ruled(b, span_div(scaled(0.5, b->base[view]), v), v, high);
        else if (view == main_view && !is_given(&b->phi))
            h[view] = high;
        else if (view == main_view)
            h[view] = ruled(b, span_tan(b->phi), v, high);
    }
    if (is_given(&h[0]) && is_given(&h[1]))
        return span_min(h[0], h[1]);
    return is_given(&h[0]) ? h[0] : h[1];
}

/* v (1 - eps)/(1 + 4 v^2 eps/b^2) - z and l^2/(4 v) (cos^2/eps + sin^2) - z; 0: eps may reach 1. */
static int elastic_height(const struct rigging_box *b, struct span v, struct span *ret)
{
    struct span one = number(b, 1), use = b->use, base = b->base[0], T, T2, cos2, eps, h, h2;

    if (b->one_hook)
        base = b->base[1];
    if (!is_given(&base))
        base = scaled(2, span_mul(v, span_tan(b->phi)));
    T = span_div(scaled(0.5, base), v);
    T2 = span_square(T);
    cos2 = span_div(one, span_add(one, T2));
    if (!is_given(&use) && is_given(&b->wll) && is_given(&b->m_load))
        use = span_div(scaled(RIGGING_GRAVITY / b->slings, b->m_load),
                       span_mul(b->wll, span_root(cos2)));
    eps = is_given(&use) ? span_mul(b->strain_wll, use) : b->strain_wll;
    if (!(eps.hi < 1))
        return 0;
    eps.lo = eps.lo > 0 ? eps.lo : 0; /* a product of what is not negative */
    h = span_div(span_mul(v, span_sub(one, eps)), span_add(one, span_div(eps, T2)));
    h = ruled(b, T, v, span_sub(h, b->z));
    *ret = h;
    if (b->one_hook || eps.hi == 0)
        return 1;
    h2 = span_add(span_div(cos2, eps), span_sub(one, cos2));
    h2 = span_sub(span_mul(span_div(half_square(&b->base[1]), v), h2), b->z);
    *ret = span_min(h, h2);
    return 1;
}

/* (h + z r)/r without cancellation, k = mu/tan(phi), half = d + s t:
 * half (k half + t^2 (k d + s))/(d + t^2 (half + k s)). */
static struct span over_load(const struct span *d, const struct span *half, const struct span *t,
                             const struct span *s, struct span k)
{
    struct span t2 = span_square(*t), above, below;

    above = span_add(span_mul(k, *half), span_mul(t2, span_add(span_mul(k, *d), *s)));
    below = span_add(*d, span_mul(t2, span_add(*half, span_mul(k, *s))));
    return span_mul(above, span_div(*half, below));
}

/* (15); 0: the base may vanish. */
static int secondary_height(const struct rigging_box *b, struct span v, struct span *ret_h,
                            struct span *ret_load)
{
    const struct span *base = is_given(&b->base[0]) ? &b->base[0] : &b->base[1];
    struct span one = number(b, 1), mu = one, T, d, t, half, t2, c, r, lean;

    if (b->m_spreader.hi > 0)
        mu = span_add(one, span_div(b->m_spreader, b->m_load));
    if (!is_given(&b->phi)) { /* gamma = 0: (6) */
        *ret_h = *ret_load = span_sub(span_mul(v, mu), b->z);
        return b->gamma.lo == 0 && b->gamma.hi == 0;
    }
    T = span_tan(b->phi);
    d = span_mul(v, T);
    if (is_given(&b->gamma)) {
        t = span_tan(b->gamma);
        half = span_add(d, span_mul(b->s, t));
    } else {
        half = scaled(0.5, *base);
        t = span_div(span_sub(half, d), b->s);
    }
    if (!(half.lo > 0))
        return 0;
    t2 = span_add(one, span_square(t));
    lean = span_div(span_mul(mu, t), T);
    c = span_div(span_sub(one, lean), t2);
    r = span_sub(one, span_mul(c, span_sub(one, span_div(d, half))));
    *ret_h = span_mul(b->s, span_div(span_add(span_square(t), lean), t2));
    *ret_h = span_add(*ret_h, span_mul(v, mu));
    *ret_load = span_sub(over_load(&d, &half, &t, &b->s, span_div(mu, T)), b->z);
    *ret_h = span_sub(*ret_h, span_mul(b->z, r));
    return 1;
}

int rigging_box_height(const struct rigging_box *b, struct span *ret_h, struct span *ret_load)
{
    struct span v;
    int made = 1;

    if (!in_range(b))
        return 0;
    if (b->type == RIGGING_SINGLE) {
        *ret_h = *ret_load = scaled(-1, b->z);
        return 1;
    }
    if (!find_v(b, &v))
        return 0;
    if (b->type == RIGGING_SECONDARY)
        return secondary_height(b, v, ret_h, ret_load);
    if (b->type == RIGGING_ELASTIC)
        made = elastic_height(b, v, ret_h);
    else
        *ret_h = primary_height(b, v);
    *ret_load = *ret_h;
    return made;
}
