/* Tolerances of lifts: worst case, samples, derivatives; design. */
#include "form/doubt.h"
#include "num/pi.h"
#include "num/root.h"
#include "phys/box.h"

#include <math.h>
#include <stdint.h>

/* The numbers of a row as spans; input[i] the index of number i among the n inputs, -1: it is
 * constant. */
struct row_box {
    const struct lift_given *g;
    const struct lift *l;
    int n, number[LIFT_NUMBERS], input[LIFT_NUMBERS];
    int joint; /* of a pair: (36), 0: the height over the tilt of the load */
};

struct box {
    double lo[LIFT_NUMBERS], hi[LIFT_NUMBERS]; /* of the inputs */
};

static struct span span_at(const struct row_box *r, const struct box *b, int i)
{
    if (isnan(r->g->x[i]))
        return span_none();
    if (r->input[i] < 0)
        return span_of(r->n, r->g->x[i]);
    return span_input(r->n, r->input[i], b->lo[r->input[i]], b->hi[r->input[i]]);
}

/* A quantity of an end: its own, or that of the whole. */
static struct span quantity(const struct row_box *r, const struct box *b, int q, int end)
{
    return span_at(r, b, LIFT_AT(q, isnan(r->g->x[LIFT_AT(q, end)]) ? 0 : end));
}

static int is_given(const struct span *x)
{
    return x->n != SPAN_NONE;
}

static struct span complement(struct span x)
{
    return span_sub(span_of(x.n, 1), x);
}

/* m_1 over the mass, as find_shares of arrange.c has it. */
static struct span first_share(const struct row_box *r, const struct box *b)
{
    struct span one = span_of(r->n, 1), all = span_at(r, b, LIFT_AT(LIFT_LOAD, 0));
    struct span m1 = span_at(r, b, LIFT_AT(LIFT_LOAD, 1));
    struct span m2 = span_at(r, b, LIFT_AT(LIFT_LOAD, 2));
    struct span e1 = span_at(r, b, LIFT_E1), e2 = span_at(r, b, LIFT_E2);

    if (is_given(&m1) && is_given(&m2))
        return span_div(one, span_add(one, span_div(m2, m1)));
    if (is_given(&e1) && is_given(&e2))
        return span_div(one, span_add(one, span_div(e1, e2)));
    return is_given(&m1) ? span_div(m1, all) : complement(span_div(m2, all));
}

static struct span end_mass(const struct row_box *r, const struct box *b, int end,
                            struct span share)
{
    struct span all = span_at(r, b, LIFT_AT(LIFT_LOAD, 0));
    struct span own = span_at(r, b, LIFT_AT(LIFT_LOAD, end));
    struct span other = span_at(r, b, LIFT_AT(LIFT_LOAD, 3 - end));

    if (is_given(&own))
        return own;
    if (is_given(&all))
        return span_mul(all, share);
    return is_given(&other) ? span_mul(other, span_div(share, complement(share))) : other;
}

/* End 1 or 2 of a pair, or the whole, end 0. */
static int end_height(const struct row_box *r, const struct box *b, int end, struct span share,
                      struct span *ret_h, struct span *ret_load)
{
    const struct suspension *a = &r->l->end[end > 1];
    struct rigging_box e = {.type = a->type,
                            .n = r->n,
                            .stabilized = a->stabilized,
                            .slings = a->slings};

    e.v = quantity(r, b, LIFT_V, end);
    e.s = quantity(r, b, LIFT_S, end);
    e.z = quantity(r, b, LIFT_Z, end);
    e.phi = quantity(r, b, LIFT_PHI, end);
    e.gamma = quantity(r, b, LIFT_GAMMA, end);
    e.m_spreader = quantity(r, b, LIFT_SPREADER, end);
    e.m_load = end == 0 ? quantity(r, b, LIFT_LOAD, 0) : end_mass(r, b, end, share);
    e.sling = quantity(r, b, LIFT_SLING, end);
    e.base[RIGGING_LONG] = quantity(r, b, LIFT_LONG, end);
    e.base[RIGGING_CROSS] = quantity(r, b, LIFT_CROSS, end);
    e.strain_wll = quantity(r, b, LIFT_STRAIN, end);
    e.use = quantity(r, b, LIFT_USE, end);
    e.wll = quantity(r, b, LIFT_WLL, end);
    e.one_hook = end > 0;
    return rigging_box_height(&e, ret_h, ret_load);
}

/* Height over the box, of a pair one of the two that judge_height takes the lesser of; 0: the box
 * leaves what can be hung. */
static int height(const struct row_box *r, const struct box *b, struct span *ret)
{
    struct span share, h1, h2, load1, load2;

    if (r->l->ends == 1)
        return end_height(r, b, 0, span_none(), ret, &load1);
    share = first_share(r, b);
    if (!(share.lo > 0 && share.hi < 1) || !end_height(r, b, 1, share, &h1, &load1) ||
        !end_height(r, b, 2, complement(share), &h2, &load2))
        return 0;
    *ret = r->joint ? span_add(span_mul(share, span_sub(h1, h2)), h2)
                    : span_add(span_mul(share, span_sub(load1, load2)), load2);
    return 1;
}

/* Inputs are the numbers with a tolerance, or all that are given. */
static void begin(struct row_box *r, const struct lift_given *g, const struct lift *l, int all)
{
    r->g = g;
    r->l = l;
    r->n = 0;
    r->joint = 0;
    for (int i = 0; i < LIFT_NUMBERS; i++) {
        int is_input = !isnan(g->x[i]) && lift_is_input(i) && (all || g->tol[i] > 0);

        r->input[i] = is_input ? r->n : -1;
        if (is_input)
            r->number[r->n++] = i;
    }
}

/* Set the inputs of one sign to their worse ends; returns the input to cut at, -1: none is left. */
static int settle(const struct row_box *r, const struct span *h, struct box *b)
{
    double most = 0;
    int cut = -1;

    for (int k = 0; k < r->n; k++) {
        double width = b->hi[k] - b->lo[k];
        double effect =
            width * fmin(fmax(fabs(h->dlo[k]), fabs(h->dhi[k])), 1e100 / r->g->tol[r->number[k]]);

        if (h->dlo[k] >= 0)
            b->hi[k] = b->lo[k];
        else if (h->dhi[k] <= 0)
            b->lo[k] = b->hi[k];
        else if (width > 0 && !(effect <= most)) {
            most = effect;
            cut = k;
        }
    }
    return cut;
}

#define PARTS 2000
#define CLOSE 1e-6 /* of the bound to what is attained */

/*
 * h in the middle of the box, from above, which some arrangement attains; *bound is raised to the
 * mean value form: h there, less the greatest slope times the half width of each input.
 */
static double at_middle(const struct row_box *r, const struct box *b, const struct span *slopes,
                        double *bound)
{
    struct box middle = *b;
    struct span h;
    double fall = 0;

    for (int k = 0; k < r->n; k++) {
        double half = (b->hi[k] - b->lo[k]) / 2;

        middle.lo[k] = middle.hi[k] = b->lo[k] + half;
        if (half > 0)
            fall += half * fmax(fabs(slopes->dlo[k]), fabs(slopes->dhi[k]));
    }
    if (!height(r, &middle, &h))
        return INFINITY;
    *bound = fmax(*bound, h.lo - fall * (1 + 1e-12));
    return h.hi;
}

/* Branch and bound from the whole box of g on; *best: the least height that is known to be
 * attained.
 */
static double lower_bound(const struct row_box *r, double *best)
{
    const struct lift_given *g = r->g;
    struct box stack[64];
    int n = 1, parts = 0;
    double all = INFINITY;

    for (int k = 0; k < r->n; k++) {
        stack[0].lo[k] = g->x[r->number[k]] - g->tol[r->number[k]];
        stack[0].hi[k] = g->x[r->number[k]] + g->tol[r->number[k]];
    }
    while (n > 0) {
        // cppcheck-suppress uninitvar  // of r->n >= 1 numbers, and no others are read
        struct box b = stack[--n];
        struct span h;
        double bound;
        int cut;

        if (!height(r, &b, &h) || isnan(h.lo))
            return -INFINITY;
        bound = h.lo;
        cut = settle(r, &h, &b);
        *best = fmin(*best, at_middle(r, &b, &h, &bound));
        if (cut >= 0 && ++parts < PARTS && n < 62 &&
            !(bound >= *best - CLOSE * (1 + fabs(*best)))) {
            double middle = b.lo[cut] + (b.hi[cut] - b.lo[cut]) / 2;

            stack[n] = stack[n + 1] = b;
            stack[n++].hi[cut] = middle;
            stack[n++].lo[cut] = middle;
        } else {
            all = fmin(all, bound);
        }
    }
    return all;
}

double doubt_worst(const struct lift_given *g, const struct lift *l)
{
    struct row_box r;
    double worst, best = INFINITY;

    begin(&r, g, l, 0);
    if (r.n == 0)
        return NAN;
    worst = lower_bound(&r, &best);
    r.joint = 1;
    return l->ends == 1 ? worst : fmin(worst, lower_bound(&r, &best));
}

void doubt_slopes(const struct lift_given *g, const struct lift *l, double ret[LIFT_NUMBERS])
{
    struct row_box r;
    struct box b;
    struct span h, other;

    begin(&r, g, l, 1);
    for (int k = 0; k < r.n; k++)
        b.lo[k] = b.hi[k] = g->x[r.number[k]];
    for (int i = 0; i < LIFT_NUMBERS; i++)
        ret[i] = NAN;
    if (l->ends == 2 && height(&r, &b, &h)) { /* of two, the one that judges */
        r.joint = 1;
        r.joint = height(&r, &b, &other) && other.lo < h.lo;
    }
    if (height(&r, &b, &h))
        for (int k = 0; k < r.n; k++)
            ret[r.number[k]] = (h.dlo[k] + h.dhi[k]) / 2 * lift_unit(r.number[k]);
}

int doubt_greatest(const struct lift_given *g, const double slopes[LIFT_NUMBERS])
{
    double most = 0;
    int ret = -1, any = 0;

    for (int i = 0; i < LIFT_NUMBERS; i++)
        any |= g->tol[i] > 0 && !isnan(slopes[i]);
    for (int i = 0; i < LIFT_NUMBERS; i++) {
        int q = i < LIFT_E1 ? i / LIFT_ENDS : -1;
        double by = q == LIFT_PHI || q == LIFT_GAMMA ? PI / 360 : 0.01 * fabs(g->x[i]);
        double effect = fabs(slopes[i]) / lift_unit(i) * (any ? g->tol[i] : by);

        if (effect > most) {
            most = effect;
            ret = i;
        }
    }
    return ret;
}

static double use_at(const struct lift_given *g)
{
    struct lift l;
    struct why why;

    return lift_make(g, &l, &why) == SW_OK ? judge_use(&l) : NAN;
}

double doubt_use(const struct lift_given *g, const struct lift *l)
{
    struct lift_given at = *g;
    double use = judge_use(l);
    int any = 0;

    at.loose = 1;
    for (int i = 0; i < LIFT_NUMBERS; i++)
        any |= g->tol[i] > 0;
    if (!any || isnan(use))
        return NAN;
    for (int i = 0; i < 2 * LIFT_NUMBERS;
         i++) { /* twice: what the second one does may turn the first */
        int k = i % LIFT_NUMBERS;

        for (int side = -1; side <= 1 && g->tol[k] > 0 && !isnan(g->x[k]); side += 2) {
            double before = at.x[k], now;

            at.x[k] = g->x[k] + side * g->tol[k];
            now = use_at(&at);
            if (now > use)
                use = now;
            else
                at.x[k] = before;
        }
    }
    return use;
}

void doubt_corner(const struct lift_given *g, struct lift_given *ret)
{
    double slopes[LIFT_NUMBERS];
    struct lift l;
    struct why why;

    *ret = *g;
    ret->loose = 1;
    if (lift_make(g, &l, &why) != SW_OK)
        return;
    doubt_slopes(g, &l, slopes);
    for (int i = 0; i < LIFT_NUMBERS; i++)
        if (g->tol[i] > 0 && !isnan(slopes[i]) && slopes[i] != 0)
            ret->x[i] -= copysign(g->tol[i], slopes[i]);
}

/* splitmix64: well mixed bits of any number. */
static uint64_t mix(uint64_t x)
{
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

/* Uniform in (-1, 1). */
static double uniform(uint64_t seed, uint64_t sample, uint64_t input)
{
    uint64_t bits = mix(mix(mix(seed) + sample) + input);

    return ((double)(bits >> 11) + 0.5) / 4503599627370496.0 - 1;
}

void doubt_sample(const struct lift_given *g, long n, long seed, double limit, struct doubt *ret)
{
    long below = 0, made = 0;
    double mean = 0, squares = 0;
    struct lift_given sample = *g;
    struct lift l;
    struct why why;

    sample.loose = 1;
    for (long k = 0; k < n; k++) {
        double h, off;

        for (int i = 0; i < LIFT_NUMBERS; i++)
            if (g->tol[i] > 0)
                sample.x[i] =
                    g->x[i] + g->tol[i] * uniform((uint64_t)seed, (uint64_t)k, (uint64_t)i);
        if (lift_make(&sample, &l, &why) != SW_OK) {
            below++;
            continue;
        }
        h = judge_height(&l);
        below += !(h > 0 && h >= limit);
        off = h - mean;
        mean += off / (double)++made;
        squares += off * (h - mean);
    }
    ret->probability = (double)below / (double)n;
    ret->mean = made > 0 ? mean : NAN;
    ret->deviation = made > 1 ? sqrt(squares / (double)(made - 1)) : NAN;
}

struct wanted {
    struct lift_given g;
    int i;
    double x, h;
};

/* Height above the wanted one with the number changed by dx. */
static double above(double dx, void *context)
{
    struct wanted *w = context;
    struct lift l;
    struct why why;

    w->g.x[w->i] = w->x + dx;
    return lift_make(&w->g, &l, &why) == SW_OK ? judge_height(&l) - w->h : NAN;
}

/* Change of the number on one side at which the height is the wanted one.  A height that jumps over
 * it does not count. */
static double search(struct wanted *w, double step)
{
    double at = 0, value = above(0, w);

    for (int k = 0; k < 120 && !isnan(value); k++) {
        double next = at + step, found = above(next, w);

        if (!isnan(found) && (found > 0) != (value > 0)) {
            double root = root_between(above, w, at, value, next, found);

            return fabs(above(root, w)) <= 1e-6 * (1 + fabs(w->h)) ? root : NAN;
        }
        at = next;
        value = found;
        step *= 1.1;
    }
    return NAN;
}

double doubt_design(const struct lift_given *g, int i, double h)
{
    struct wanted w = {*g, i, g->x[i], h};
    double unit = lift_unit(i), step = 1e-3 * fmax(fabs(w.x), unit);
    double down, up;

    if (isnan(w.x))
        return NAN;
    down = search(&w, -step);
    up = search(&w, step);
    if (isnan(down) || fabs(up) < fabs(down))
        return w.x + up;
    return w.x + down;
}
