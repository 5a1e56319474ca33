/* Suspensions: published cases, corrected formulas, limits, the planar linkage, forces, refusals.
 */
#include "check.h"

#include "phys/righting.h"

#include <string.h>

#define RAD (PI / 180)

/* Nothing given. */
static struct rigging blank(enum rigging_type type)
{
    return (struct rigging){type,       NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN,
                            {NAN, NAN}, NAN, NAN, NAN, NAN, NAN, NAN, 0};
}

static struct rigging spreader(double v, double s, double z, double phi, double gamma, double mT,
                               double mC)
{
    struct rigging r = blank(RIGGING_SECONDARY);

    r.v = v;
    r.s = s;
    r.z = z;
    r.phi = phi * RAD;
    r.gamma = gamma * RAD;
    r.m_spreader = 1000 * mT;
    r.m_load = 1000 * mC;
    return r;
}

/* Case 1.2.5. */
static struct rigging tandem(double strain)
{
    struct rigging r = blank(RIGGING_ELASTIC);

    r.v = 14.5;
    r.z = 8.4;
    r.sling = 15;
    r.base[0] = 7.7;
    r.base[1] = 5.9;
    r.strain_wll = strain;
    return r;
}

static struct rigging primary(double v, double z, double base_long, double base_cross)
{
    struct rigging r = blank(RIGGING_PRIMARY);

    r.v = v;
    r.z = z;
    r.base[0] = base_long;
    r.base[1] = base_cross;
    return r;
}

static struct suspension complete(const struct rigging *r)
{
    struct suspension a;
    struct rigging_fault f;

    if (rigging_complete(r, &a, &f) != SW_OK) {
        print_error("%s: %s (%g)\n", f.quantity, f.text, f.value);
        _fail(__FILE__, __LINE__);
    }
    return a;
}

static struct rigging_heights heights(struct rigging r)
{
    struct suspension a = complete(&r);
    struct rigging_heights h;

    rigging_heights(&a, &h);
    return h;
}

/* As printed: half a unit of the last digit. */
static void published(void **state)
{
    struct rigging_heights h;
    (void)state;

    h = heights(spreader(3.6, 7.5, 1.1, 26, -4, 2, 60));
    near_abs(h.c, 1.14256, 0.5e-5);
    near_abs(h.h[1], 1.0, 0.05);
    assert_true(isnan(h.h[0]) && h.document[1] == h.h[1]);
    below(heights(spreader(3.6, 7.5, 1.1, 26, -6, 2, 60)).h[1], 0);
    h = heights(spreader(4.56, 8.46, 2.66, 42, -7, 18, 64));
    near_abs(h.c, 1.15727, 0.5e-5);
    near_abs(h.h[1], 0.809, 0.5e-3);
    h = heights(spreader(2, 3.5, -1, 45, -8, 1, 15));
    near_abs(h.c, 1.12764, 0.5e-5);
    near_abs(h.h[1], 3.05, 0.5e-2);
    h = heights(spreader(6.05, 18.19, 3.54, 27.1, -2.1, 1.6, 185.6));
    near_abs(h.c, 1.07083, 0.5e-5);
    near_abs(h.h[1], 0.233, 0.5e-3);
    h = heights(spreader(6.28, 7.2, 3.54, 22.5, -1.4, 1.6, 160.4));
    near_abs(h.c, 1.05896, 0.5e-5);
    near_abs(h.h[1], 2.106, 0.5e-3);
}

/* 1.2.5: the document's numbers under its formulas, the corrected ones judge. */
static void elastic(void **state)
{
    static const struct {
        double strain, document[2], digit, corrected[2], corrected_digit[2];
    } cases[] = {{0.004, {5.6, 141.6}, 0.05, {5.267, 131.80}, {0.5e-3, 0.5e-2}},
                 {0.023, {3.2, 17.7}, 0.05, {2.282, 16.015}, {0.5e-3, 0.5e-3}}};
    struct rigging_heights h = heights(tandem(0));
    (void)state;

    near_abs(h.h[0], 6.1, 1e-12);
    near_abs(h.document[0], 6.1, 1e-12);
    assert_true(isinf(h.h[1]) && h.h[1] > 0 && isinf(h.document[1]));
    for (int i = 0; i < 2; i++) {
        h = heights(tandem(cases[i].strain));
        for (int view = 0; view < 2; view++) {
            near_abs(h.document[view], cases[i].document[view], cases[i].digit);
            near_abs(h.h[view], cases[i].corrected[view], cases[i].corrected_digit[view]);
        }
    }
}

/* use scales the strain; it follows from weight and limit, and must not be given as less. */
static void use(void **state)
{
    struct rigging r = tandem(0.023), half = tandem(0.0115), by_weight = tandem(0.023);
    struct suspension a;
    struct rigging_fault f;
    (void)state;

    near_rel(complete(&r).use, 1, 0);
    r.use = 0.5;
    near_rel(heights(r).h[0], heights(half).h[0], 1e-15);
    by_weight.m_load = 1e5;
    by_weight.wll = 1e5 * RIGGING_GRAVITY / 2 / cos(atan(7.7 / 29));
    a = complete(&by_weight);
    near_rel(a.use, 0.5, 1e-12);
    near_rel(heights(by_weight).h[1], heights(half).h[1], 1e-12);
    by_weight.use = 0.49;
    assert_int_equal(rigging_complete(&by_weight, &a, &f), SW_ADMISSIBLE);
    assert_string_equal(f.quantity, "use");
}

/* The rule of 5 degrees, in each view by itself. */
static void rule(void **state)
{
    double narrow = 2 * 6 * tan(4.9 * RAD), wide = 2 * 6 * tan(5.1 * RAD);
    struct rigging r = primary(6, 0.6, wide, narrow);
    struct rigging_heights h = heights(r);
    struct suspension a = complete(&r);
    enum rigging_view view;
    (void)state;

    near_rel(h.h[0], 5.4, 1e-15);
    near_rel(h.h[1], -0.6, 0);
    assert_true(!h.ruled[0] && h.ruled[1] && h.centre[0] == 6 && h.centre[1] == 0);
    near_rel(rigging_least(h.h, &view), -0.6, 0);
    assert_int_equal(view, RIGGING_CROSS);
    near_rel(rigging_critical_z(&a), 6 * tan(4.9 * RAD), 1e-14);
    r.stabilized = 1;
    near_rel(heights(r).h[1], 5.4, 1e-15);
    a = complete(&r);
    near_rel(rigging_critical_z(&a), 6, 1e-15);
    r.stabilized = 0;
    r.z = 0.5; /* below v tan(phi) = 0.514 */
    near_rel(heights(r).h[1], 5.5, 1e-15);
    r.z = NAN;
    r = tandem(0.023);
    r.base[0] = 14.5 * 2 * tan(4.9 * RAD);
    r.sling = NAN;
    near_rel(heights(r).h[0], -8.4, 0);
}

static struct rigging any_spreader(uint64_t *seed)
{
    double phi = uniform_in(seed, 8, 75), v = log_uniform(seed, 0.5, 10);
    double s = log_uniform(seed, 0.3, 20);
    double least = fmax(-60, atan(-0.95 * v * tan(phi * RAD) / s) / RAD);

    return spreader(v, s, uniform_in(seed, -3, 5), phi, uniform_in(seed, least, 60),
                    uniform_in(seed, 0, 20), log_uniform(seed, 20, 300));
}

/* Between the types. */
static void limits(void **state)
{
    uint64_t seed = 7;
    (void)state;

    for (int i = 0; i < 1000; i++) {
        struct rigging r = any_spreader(&seed), t = tandem(1e-9), p;
        double mu = 1 + r.m_spreader / r.m_load;

        r.gamma = 0;
        near_abs(heights(r).h[1], r.v * mu - r.z, 1e-12 * (r.v * mu + fabs(r.z)));
        near_rel(heights(r).c, 1, 1e-15);
        r.phi = NAN; /* is not needed then */
        near_abs(heights(r).h[1], r.v * mu - r.z, 1e-12 * (r.v * mu + fabs(r.z)));
        r = any_spreader(&seed);
        r.s = 1e-9;
        r.gamma = fmax(r.gamma, -60 * RAD);
        near_abs(heights(r).h[1], r.v * (1 + r.m_spreader / r.m_load) - r.z, 1e-6);
        t.v = r.v;
        t.z = r.z;
        t.sling = NAN;
        p = primary(t.v, t.z, t.base[0], NAN);
        near_abs(heights(t).h[0], heights(p).h[0], 1e-6);
        assert_true(heights(t).h[1] > 1e5);
    }
}

/* Crosswise the document is too high by 1/cos^2(phi) in its first term; lengthwise while z < v. */
static void document_is_unsafe(void **state)
{
    uint64_t seed = 11;
    (void)state;

    for (int i = 0; i < 1000; i++) {
        struct rigging r = tandem(uniform_in(&seed, 1e-3, 0.05));
        struct rigging_heights h;
        double cosine;

        r.sling = NAN;
        r.v = log_uniform(&seed, 2, 30);
        r.z = uniform_in(&seed, 0, 0.9) * r.v;
        r.base[0] = r.v * uniform_in(&seed, 0.3, 2);
        h = heights(r);
        cosine = cos(atan(r.base[0] / (2 * r.v)));
        assert_true(h.document[1] > h.h[1]);
        near_rel((h.document[1] + r.z) * cosine * cosine,
                 h.h[1] + r.z - r.base[1] * r.base[1] / (4 * r.v) * (1 - cosine * cosine), 1e-12);
        if (r.z > 0 && h.h[0] > 0)
            assert_true(h.document[0] > h.h[0]);
    }
}

static void critical(void **state)
{
    uint64_t seed = 3;
    int gammas = 0, vs = 0;
    (void)state;

    for (int i = 0; i < 2000; i++) {
        struct rigging r = any_spreader(&seed), q;
        struct suspension a = complete(&r);
        double z = rigging_critical_z(&a), v = rigging_critical_v(&a);
        double gamma = rigging_critical_gamma(&a), size = r.v + r.s + fabs(r.z);

        q = r;
        q.z = z;
        near_abs(heights(q).h[1], 0, 1e-11 * (size + fabs(z)));
        q.z = z + 0.1;
        near_rel(heights(q).h[1], -0.1 * heights(r).r, 1e-9);
        assert_true(heights(r).r > 0);
        if (!isnan(v)) {
            q = r;
            q.v = v;
            near_abs(heights(q).h[1], 0, 1e-10 * (size + v));
            vs++;
        }
        if (!isnan(gamma)) {
            q = r;
            q.gamma = gamma;
            near_abs(heights(q).h[1], 0, 1e-8 * size);
            gammas++;
        }
    }
    assert_true(vs > 500 && gammas > 500);
}

/*
 * The planar linkage by itself: spreader tilted by p, left secondary sling by q more than gamma;
 * the load's tilt follows from the length of the right one.  Against the spreader it swings by p -
 * q.  Returns the potential over g, for the centre of gravity offset by e to the left.
 */
struct linkage {
    double v, s, z, d, b, sling, gamma, mT, mC;
};

static double potential(const struct linkage *k, double p, double q, double e, double *ret_tilt)
{
    double ax = k->v * sin(p) - k->d * cos(p), ay = -k->v * cos(p) - k->d * sin(p);
    double bx = k->v * sin(p) + k->d * cos(p), by = -k->v * cos(p) + k->d * sin(p);
    double x = ax - k->sling * sin(k->gamma - q), y = ay - k->sling * cos(k->gamma - q);
    double dx = bx - x, dy = by - y, w = 2 * k->b;
    double toward = atan2(dy, dx);
    double inside =
        acos((dx * dx + dy * dy + w * w - k->sling * k->sling) / (2 * w * hypot(dx, dy)));
    double one = toward + inside, other = toward - inside;
    double tilt = fabs(one) < fabs(other) ? one : other;

    if (ret_tilt)
        *ret_tilt = tilt;
    return k->mC * (y + sin(tilt) * (k->b - e) + cos(tilt) * k->z) - k->mT * k->v * cos(p);
}

static struct linkage linkage_of(const struct rigging *r)
{
    double d = r->v * tan(r->phi);

    return (struct linkage){
        r->v,     r->s,          r->z,     d, d + r->s * tan(r->gamma), r->s / cos(r->gamma),
        r->gamma, r->m_spreader, r->m_load};
}

/* The equilibrium to first order by differences: e = h p, q = (1 - c) p, tilt = r p; and the
 * stiffness of the load's tilt, the spreader left free, is m g h/r. */
static void against_linkage(void **state)
{
    uint64_t seed = 5;
    int compared = 0;
    (void)state;

    for (int i = 0; i < 3000; i++) {
        struct rigging r = any_spreader(&seed);
        struct linkage k = linkage_of(&r);
        struct rigging_heights h = heights(r);
        const double t = 2e-4;
        double pp, qq, pq, e_p, e_q, tilt, slope_p, slope_q, minus, swing, ratio, stiff, offset;

        if (fabs(r.gamma) < 3 * RAD || k.b < 0.2 * k.d || k.b < 0.2 || k.d < 0.2 || k.s < 0.5)
            continue; /* differences are too rough there */
#define V(p, q) potential(&k, p, q, 0, NULL)
        pp = (V(t, 0) - 2 * V(0, 0) + V(-t, 0)) / (t * t);
        qq = (V(0, t) - 2 * V(0, 0) + V(0, -t)) / (t * t);
        pq = (V(t, t) - V(t, -t) - V(-t, t) + V(-t, -t)) / (4 * t * t);
#undef V
        potential(&k, t, 0, 0, &tilt);
        potential(&k, -t, 0, 0, &minus);
        slope_p = (tilt - minus) / (2 * t);
        potential(&k, 0, t, 0, &tilt);
        potential(&k, 0, -t, 0, &minus);
        slope_q = (tilt - minus) / (2 * t);
        e_p = r.m_load * slope_p; /* moment of the offset against p, q */
        e_q = r.m_load * slope_q;
        /* equilibrium: pp p + pq q = e e_p, pq p + qq q = e e_q, p = 1 */
        swing = (pp * e_q - pq * e_p) / (qq * e_p - pq * e_q);
        offset = (pp + pq * swing) / e_p;
        if (fabs(e_p) < fabs(e_q))
            offset = (pq + qq * swing) / e_q;
        ratio = slope_p + slope_q * swing;
        stiff = (pp * qq - pq * pq) /
                (slope_p * slope_p * qq - 2 * slope_p * slope_q * pq + slope_q * slope_q * pp);
        near_abs(offset, h.h[1], 2e-4 * (r.v + r.s + fabs(r.z)) * fmax(1, h.r));
        near_abs(ratio, h.r, 2e-4 * fmax(1, fabs(h.c)));
        near_abs(1 - swing, h.c, 2e-4 * fmax(1, fabs(h.c)));
        near_abs(stiff / r.m_load, h.h[1] / h.r,
                 1e-3 * (r.v + r.s + fabs(r.z) + fabs(h.h[1] / h.r)));
        compared++;
    }
    assert_true(compared > 1000);
}

/* Hook and load in equilibrium: exact for rigid primary slings, upright for all. */
static void forces(void **state)
{
    uint64_t seed = 9;
    (void)state;

    for (int i = 0; i < 1000; i++) {
        struct rigging r = any_spreader(&seed);
        struct suspension a;
        struct righting at;
        double h = uniform_in(&seed, 0.1, 5), tilt = uniform(&seed) * tan(r.phi),
               delta = atan(tilt);
        double weight;

        r.m_load = 6e4;
        a = complete(&r);
        weight = (r.m_load + r.m_spreader) * RIGGING_GRAVITY;
        righting_at(&a, RIGGING_CROSS, h, tilt, &at);
        near_rel(2 * at.primary_low * cos(r.phi - delta) + 2 * at.primary_high * cos(r.phi + delta),
                 weight, 1e-12);
        near_abs(at.primary_low * sin(r.phi - delta), at.primary_high * sin(r.phi + delta),
                 1e-12 * weight);
        righting_at(&a, RIGGING_CROSS, h, NAN, &at);
        near_rel(4 * at.secondary_low * cos(r.gamma), r.m_load * RIGGING_GRAVITY, 1e-12);
        near_rel(at.secondary_low, at.secondary_high, 0);
        assert_true(isnan(at.spreader) && isnan(at.load));
        near_rel(at.range, r.phi, 1e-12);
    }
}

/* Secondary slings of the tilted linkage, solved by their directions: first order in the tilt. */
static void secondary_forces(void **state)
{
    uint64_t seed = 21;
    int compared = 0;
    (void)state;

    for (int i = 0; i < 3000; i++) {
        struct rigging r = any_spreader(&seed);
        struct suspension a = complete(&r);
        struct linkage k = linkage_of(&r);
        struct rigging_heights h;
        struct righting at;
        const double p = 1e-4;
        double ax, ay, bx, by, x, y, tilt, ux, uy, wx, wy, left, right, weight, q;

        rigging_heights(&a, &h);
        if (fabs(r.gamma) < 3 * RAD || k.b < 0.3 || k.s < 0.5 || !(h.h[1] > 0.1))
            continue;
        q = (1 - h.c) * p;
        potential(&k, p, q, 0, &tilt);
        near_abs(tilt, h.r * p, 0.01 * h.r * p);
        ax = k.v * sin(p) - k.d * cos(p);
        ay = -k.v * cos(p) - k.d * sin(p);
        bx = k.v * sin(p) + k.d * cos(p);
        by = -k.v * cos(p) + k.d * sin(p);
        x = ax - k.sling * sin(k.gamma - q);
        y = ay - k.sling * cos(k.gamma - q);
        ux = (ax - x) / k.sling;
        uy = (ay - y) / k.sling;
        wx = (bx - x - 2 * k.b * cos(tilt)) / k.sling;
        wy = (by - y - 2 * k.b * sin(tilt)) / k.sling;
        weight = r.m_load * RIGGING_GRAVITY;
        /* ux L + wx R = 0, uy L + wy R = W */
        left = weight * wx / (uy * wx - ux * wy);
        right = weight * ux / (ux * wy - uy * wx);
        righting_at(&a, RIGGING_CROSS, h.h[1], p, &at);
        near_abs(2 * fmin(at.secondary_low, at.secondary_high), fmin(left, right),
                 2e-2 * fabs(left - right) + 1e-5 * weight);
        near_abs(2 * fmax(at.secondary_low, at.secondary_high), fmax(left, right),
                 2e-2 * fabs(left - right) + 1e-5 * weight);
        compared++;
    }
    assert_true(compared > 500);
}

/* Elastic slings: the rigid ones' forces as the strain goes to 0, lengthwise; (26) crosswise. */
static void elastic_forces(void **state)
{
    const double tilt = 1e-4;
    struct rigging r = tandem(1e-10), rigid = primary(14.5, 8.4, 7.7, NAN);
    struct suspension a, b;
    struct righting at, wanted;
    struct rigging_heights h;
    double F0 = 9e4 * RIGGING_GRAVITY / 4 / cos(atan(7.7 / 29));
    (void)state;

    r.m_load = rigid.m_load = 9e4;
    a = complete(&r);
    b = complete(&rigid);
    righting_at(&a, RIGGING_LONG, 6.1, tilt, &at);
    righting_at(&b, RIGGING_LONG, 6.1, tilt, &wanted);
    near_rel(wanted.primary_low - F0, F0 * tilt * 29 / 7.7, 1e-3);
    near_rel(at.primary_low - F0, wanted.primary_low - F0, 1e-3);
    near_rel(F0 - at.primary_high, F0 - wanted.primary_high, 1e-3);
    near_rel(at.moment_0, 9e4 * RIGGING_GRAVITY / 4 * 6.1 * 7.7 / 29, 1e-12);
    r.strain_wll = 0.023;
    a = complete(&r);
    rigging_heights(&a, &h);
    righting_at(&a, RIGGING_CROSS, h.h[1], tilt, &at);
    near_rel(at.primary_low, F0 * (1 + 2 * (h.h[1] + 8.4) * tilt / 5.9), 1e-12);
    near_rel(at.primary_high, F0 * (1 - 2 * (h.h[1] + 8.4) * tilt / 5.9), 1e-12);
    assert_true(isnan(at.moment) && isnan(at.range) && isnan(at.secondary_low));
    near_rel(at.load, tilt, 1e-6);
}

/* The printed formula of 1.3.1, and its zero. */
static void righting_moment(void **state)
{
    (void)state;
    for (double phi = 10; phi < 70; phi += 7)
        for (double part = 0; part <= 1; part += 0.125) {
            struct rigging r = primary(5, 2, 10 * tan(phi * RAD), NAN);
            double f = phi * RAD, d = part * f, W = 8e4 * RIGGING_GRAVITY;
            struct suspension a;
            struct righting at;

            r.m_load = 8e4;
            a = complete(&r);
            righting_at(&a, RIGGING_LONG, 3, tan(d), &at);
            near_abs(at.moment,
                     W / 4 * 3 *
                         (sin(f) * sin(f) * cos(d) * cos(d) - cos(f) * cos(f) * sin(d) * sin(d)) /
                         (sin(f) * cos(f) * cos(d)),
                     1e-12 * W);
            near_rel(at.moment_0, W / 4 * 3 * tan(f), 1e-12);
            if (part == 1)
                near_abs(at.moment, 0, 1e-11 * W);
            near_rel(at.range, f, 1e-14);
        }
}

static void follows(void **state)
{
    struct rigging r = primary(NAN, 2, 6, 4), s = spreader(3, 5, 1, 40, -5, 2, 60), t;
    struct suspension a, b;
    (void)state;

    r.sling = sqrt(49 + 9 + 4);
    a = complete(&r);
    near_rel(a.v, 7, 1e-14);
    near_rel(a.T[0], 3.0 / 7, 1e-14);
    near_rel(a.T[1], 2.0 / 7, 1e-14);
    t = s;
    t.v = NAN;
    t.sling = 3 / cos(40 * RAD);
    t.gamma = NAN;
    t.base[0] = 2 * (3 * tan(40 * RAD) + 5 * tan(-5 * RAD));
    a = complete(&s);
    b = complete(&t);
    near_rel(b.v, a.v, 1e-14);
    near_rel(b.t, a.t, 1e-12);
    assert_true(isnan(a.T[0]) && isnan(b.T[1]) && b.T[0] == a.T[1]);
    r.type = RIGGING_SINGLE; /* one sling is one, the others are four unless told */
    near_abs(complete(&r).slings, 1, 0);
    r.slings = 1;
    near_abs(complete(&r).slings, 1, 0);
    near_abs(a.slings, 4, 0);
}

static void refused(void **state)
{
    struct rigging good = spreader(3, 5, 1, 40, -5, 2, 60), wide = primary(6, 2, 6, 4);
    const struct {
        const char *quantity;
        struct rigging base;
        size_t member;
        double value;
    } bad[] = {
#define BAD(base, member, value) {#member, base, offsetof(struct rigging, member), value}
        BAD(good, v, 0),
        BAD(good, v, -3),
        BAD(good, v, INFINITY),
        BAD(good, s, 0),
        BAD(good, s, -1),
        BAD(good, z, NAN),
        BAD(good, z, INFINITY),
        BAD(good, phi, 0),
        BAD(good, phi, 90 * RAD),
        BAD(good, phi, -0.1),
        BAD(good, gamma, 90 * RAD),
        BAD(good, gamma, -90 * RAD),
        BAD(good, gamma, -60 * RAD),
        BAD(good, gamma, NAN),
        BAD(good, m_spreader, -1),
        BAD(good, m_spreader, NAN),
        BAD(good, m_load, 0),
        BAD(good, m_load, -1),
        BAD(good, m_load, NAN),
        BAD(good, phi, NAN),
        BAD(good, s, NAN),
        BAD(good, v, NAN),
        BAD(good, sling, -1),
        BAD(good, sling, 5),
        BAD(wide, sling, 3),
        BAD(wide, sling, 9),
        BAD(wide, phi, 40 * RAD),
        BAD(good, slings, 0),
        BAD(good, wll, 0),
        BAD(good, wll_secondary, -1),
#undef BAD
    };
    (void)state;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct rigging r = bad[i].base;
        struct suspension a;
        struct rigging_fault f = {"", "", 0, ""};

        complete(&r);
        memcpy((char *)&r + bad[i].member, &bad[i].value, sizeof(double));
        if (rigging_complete(&r, &a, &f) != SW_ADMISSIBLE || strcmp(f.quantity, bad[i].quantity)) {
            print_error("%zu: %s = %g: %s %s\n", i, bad[i].quantity, bad[i].value, f.quantity,
                        f.text);
            _fail(__FILE__, __LINE__);
        }
        assert_true(f.text[0] != '\0');
    }
}

/* What is given twice, and does not agree; which of two bases the spreader belongs to. */
static void refused_twice(void **state)
{
    struct rigging flat = primary(6, 2, 6, 4), two = spreader(3, 5, 1, 40, -5, 2, 60);
    struct suspension a;
    struct rigging_fault f;
    (void)state;

    flat.sling = 6.8; /* longer than the reach of 3.6 m, shorter than the 7.0 m up to the hook */
    assert_int_equal(rigging_complete(&flat, &a, &f), SW_ADMISSIBLE);
    assert_string_equal(f.quantity, "sling");
    assert_string_equal(f.text, "is too short to reach the lifting points");
    flat.sling = 7;
    assert_int_equal(rigging_complete(&flat, &a, &f), SW_OK);
    two.gamma = NAN;
    two.base[RIGGING_LONG] = 4;
    two.base[RIGGING_CROSS] = 5;
    assert_int_equal(rigging_complete(&two, &a, &f), SW_ADMISSIBLE);
    assert_string_equal(f.quantity, "gamma");
    two.base[RIGGING_LONG] = NAN;
    assert_int_equal(rigging_complete(&two, &a, &f), SW_OK);
}

/* The base of elastic slings follows from their angle, too. */
static void complete_base(const struct rigging *given)
{
    struct rigging r = *given;
    struct suspension a;
    struct rigging_fault f;
    double base = r.base[RIGGING_LONG];

    r.phi = atan(base / (2 * r.v));
    r.base[RIGGING_LONG] = NAN;
    assert_int_equal(rigging_complete(&r, &a, &f), SW_OK);
    near_rel(a.base[RIGGING_LONG], base, 1e-14);
    near_rel(a.T[RIGGING_LONG], base / (2 * r.v), 1e-14);
}

static void refused_elastic(void **state)
{
    struct rigging r = tandem(0.02);
    struct suspension a;
    struct rigging_fault f;
    (void)state;

    r.base[RIGGING_LONG] = NAN;
    r.phi = NAN;
    assert_int_equal(rigging_complete(&r, &a, &f), SW_ADMISSIBLE);
    assert_string_equal(f.quantity, "base_long");
    r = tandem(0.02);
    complete_base(&r);
    r.strain_wll = 1;
    assert_int_equal(rigging_complete(&r, &a, &f), SW_ADMISSIBLE);
    r.strain_wll = 0.3;
    r.use = 4;
    assert_int_equal(rigging_complete(&r, &a, &f), SW_ADMISSIBLE);
    assert_string_equal(f.quantity, "use");
    r = tandem(0.02);
    r.base[1] = -1;
    assert_int_equal(rigging_complete(&r, &a, &f), SW_ADMISSIBLE);
    r.base[1] = NAN;
    assert_int_equal(rigging_complete(&r, &a, &f), SW_ADMISSIBLE);
    assert_string_equal(f.quantity, "base_cross");
    r = tandem(NAN);
    assert_int_equal(rigging_complete(&r, &a, &f), SW_ADMISSIBLE);
}

TEST_MAIN(cmocka_unit_test(published), cmocka_unit_test(elastic), cmocka_unit_test(use),
          cmocka_unit_test(rule), cmocka_unit_test(limits), cmocka_unit_test(document_is_unsafe),
          cmocka_unit_test(critical), cmocka_unit_test(against_linkage), cmocka_unit_test(forces),
          cmocka_unit_test(secondary_forces), cmocka_unit_test(elastic_forces),
          cmocka_unit_test(righting_moment), cmocka_unit_test(follows), cmocka_unit_test(refused),
          cmocka_unit_test(refused_elastic), cmocka_unit_test(refused_twice))
