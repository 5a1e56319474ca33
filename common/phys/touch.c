/* A continuous rope over a plane bed. */
#include "phys/touch.h"
#include "num/root.h"
#include "phys/line.h"

#include <math.h>
#include <string.h>

#define SLACK 1e-16   /* of the rope's weight: stands for no tension */
#define NARROW 1e-9   /* of its length: stands for no distance */
#define STEPS 60      /* of Newton's method for one end */
#define DOUBLINGS 200 /* of the tension */

/*
 * An end that hangs: from the bed, which it leaves with tension T along the slope m (outwards), up
 * to the height h over it.  With H = T c, V0 = T m c, c = 1/sqrt(1 + m^2), V1 = V0 + w s:
 *
 *     run = H (P + s/EA),  rise = s (V0 + V1) [1/(T + T1) + 1/(2 EA)],  rise - m run = h
 *     P = int ds/T,  R = int H^2 ds/T^3,  Q = int V ds/T^3
 */
struct end {
    double s, run, H, V0, V1, T1;
    double s_T, s_h, s_m, run_T, run_h, run_m; /* derivatives */
};

static double climb(const struct touch_rope *r, double T, double m, double s, struct end *e)
{
    double P, rise;

    e->H = T / sqrt(1 + m * m);
    e->V0 = e->H * m;
    e->s = s;
    e->V1 = e->V0 + r->w * s;
    e->T1 = hypot(e->H, e->V1);
    { /* log((V1 + T1)/(V0 + T)) as log1p(2 W/(T + T1 - W)), W = w s (theory c1) */
        double rest = (e->V0 < 0 ? e->H * e->H / (T - e->V0) : T + e->V0) +
                      (e->V1 > 0 ? e->H * e->H / (e->T1 + e->V1) : e->T1 - e->V1);

        P = s > 0 ? log1p(2 * r->w * s / rest) / r->w : 0;
    }
    e->run = e->H * (P + s / r->EA);
    rise = s * (e->V0 + e->V1) * (1 / (T + e->T1) + 1 / (2 * r->EA));
    return rise - m * e->run;
}

/* The level one has its length in closed form; on a slope Newton's method begins with it. */
static void hang(const struct touch_rope *r, double T, double m, double h, struct end *e)
{
    double stiff = 1 + T / r->EA, u = 2 * r->w * h;
    double up = u / (stiff + sqrt(stiff * stiff + u / r->EA)); /* T1 - T of a level bed */
    double s = sqrt(up * (up + 2 * T)) / r->w, low = 0, high = INFINITY;

    for (int k = 0; k < STEPS && h > 0; k++) {
        double off = climb(r, T, m, s, e) - h, next;

        if (off > 0)
            high = s;
        else
            low = s;
        next = s - off / (r->w * s * (1 / e->T1 + 1 / r->EA));
        if (!(next > low && next < high))
            next = high < INFINITY ? (low + high) / 2 : 2 * s;
        if (m == 0 || fabs(next - s) <= 4e-16 * s)
            break;
        s = next;
    }
    climb(r, T, m, h > 0 ? s : 0, e);
}

/* Derivatives of s and run by T, h and m. */
static void differentiate(const struct touch_rope *r, double T, double m, struct end *e)
{
    double c = 1 / sqrt(1 + m * m), w = r->w, a = e->s / r->EA, P, R, Q, run_s, h_s;
    double run_H, run_V, rise_H, rise_V, rise_T, rise_m;

    if (!(e->s > 0)) { /* lies to its end, as if its height could not change */
        e->s_T = e->s_h = e->s_m = e->run_T = e->run_h = e->run_m = 0;
        return;
    }
    P = e->run / e->H - a;
    R = (e->V1 / e->T1 - e->V0 / T) / w;
    Q = (1 / T - 1 / e->T1) / w;
    run_s = e->H / e->T1 + e->H / r->EA;
    h_s = w * e->s * (1 / e->T1 + 1 / r->EA);
    run_H = P + a - R;
    run_V = rise_H = -e->H * Q;
    rise_V = R + a;
    e->run_T = c * (run_H + m * run_V);
    rise_T = c * (rise_H + m * rise_V);
    e->run_m = T * c * c * c * (run_V - m * run_H); /* H_m = -T m c^3, V0_m = T c^3 */
    rise_m = T * c * c * c * (rise_V - m * rise_H);
    e->s_T = -(rise_T - m * e->run_T) / h_s;
    e->s_m = -(rise_m - m * e->run_m - e->run) / h_s;
    e->s_h = 1 / h_s;
    e->run_T += run_s * e->s_T;
    e->run_m += run_s * e->s_m;
    e->run_h = run_s * e->s_h;
}

/* What lies, as it depends on the slope: by how much the tension falls from the end that carries
 * more (its number: hi). */
struct ground {
    int hi, lo;
    double c, rate;     /* cosine of the slope; fall of tension from hi to lo [N/m] */
    double c_m, rate_m; /* by the slope from a to b */
    int holds;          /* what is slack stays on the slope */
    double out[2];      /* slopes outwards at a and b */
};

static void look_at_ground(const struct touch_rope *r, double m, struct ground *g)
{
    int up = m >= 0 ? 1 : 0; /* the end uphill */
    double pulled = r->pulled == TOUCH_ALIKE ? 0 : (r->pulled == TOUCH_PULLED_B) == up ? 1 : -1;
    double sine, C = r->friction;

    g->c = 1 / sqrt(1 + m * m);
    g->c_m = -m * g->c * g->c * g->c;
    sine = fabs(m) * g->c;
    g->rate = r->w * (sine + pulled * C * g->c);
    g->rate_m = r->w * ((m >= 0 ? 1 : -1) * g->c * g->c * g->c + pulled * C * g->c_m);
    g->hi = up;
    if (g->rate < 0) {
        g->hi = !up;
        g->rate = -g->rate;
        g->rate_m = -g->rate_m;
    }
    g->lo = !g->hi;
    g->holds = C * g->c >= sine;
    g->out[0] = -m;
    g->out[1] = m;
}

/* int max(0, T - rate s) ds over l, and its derivatives by T, rate and l. */
static double carried(double T, double rate, double l, double d[3])
{
    double reach = T >= rate * l ? l : T / rate;

    d[0] = reach;
    d[1] = -reach * reach / 2;
    d[2] = fmax(0, T - rate * l);
    return reach * (T - rate * reach / 2);
}

struct search {
    const struct touch_rope *r;
    const struct touch_place *p;
    struct ground g;
    double none;  /* tension that stands for none [N] */
    double first; /* tension at hi where the first is at lo [N] */
    double T[2];
    struct end e[2];
    double flat; /* unstretched length that lies, heap included [m] */
    int slack;   /* no tension at lo */
    int loose;   /* none at hi either */
    int heap;
};

static void hang_end(struct search *q, int i, double T)
{
    q->T[i] = fmax(T, q->none);
    hang(q->r, q->T[i], q->g.out[i], q->p->h[i], &q->e[i]);
}

/* T_hi + rate s_hi(T_hi) = T_lo + rate (L0 - s_lo): from the one end to the other. */
static double miss_hi(double T, void *context)
{
    struct search *q = context;

    hang_end(q, q->g.hi, T);
    return T + q->g.rate * (q->e[q->g.hi].s + q->e[q->g.lo].s - q->r->L0) - q->T[q->g.lo];
}

static void match_hi(struct search *q)
{
    double low = q->T[q->g.lo] - q->g.rate * q->e[q->g.lo].s;
    double high = q->T[q->g.lo] + q->g.rate * q->r->L0;

    if (q->g.rate == 0 || q->p->h[q->g.hi] == 0)
        hang_end(q, q->g.hi, q->T[q->g.lo] + q->g.rate * (q->r->L0 - q->e[q->g.lo].s));
    else {
        double at_low;

        low = fmax(low, 0);
        at_low = miss_hi(low, q);
        if (at_low < 0) /* else more hangs than there is: too much tension was tried */
            low = root_between(miss_hi, q, low, at_low, high, miss_hi(high, q));
        hang_end(q, q->g.hi, low);
    }
}

/* Distance from a to b that belongs to the tension p: up to `first` it is that at hi, with none at
 * lo; then what exceeds it stands at lo. */
static double spread(double p, void *context)
{
    struct search *q = context;
    const struct ground *g = &q->g;
    double d[3], stretch;

    q->slack = p <= q->first;
    if (q->slack) {
        hang_end(q, g->lo, 0);
        hang_end(q, g->hi, p);
    } else {
        hang_end(q, g->lo, p - q->first);
        match_hi(q);
    }
    q->flat = q->r->L0 - q->e[0].s - q->e[1].s;
    q->heap = q->slack && !g->holds && q->T[g->hi] < g->rate * q->flat;
    stretch = carried(q->T[g->hi], g->rate, q->flat, d);
    if (q->heap) /* the rest lies in a heap; friction has no share in what slides */
        return q->e[0].run + q->e[1].run +
               g->c * (q->T[g->hi] / g->rate) * (1 + q->T[g->hi] / (2 * q->r->EA));
    return q->e[0].run + q->e[1].run + g->c * (q->flat + stretch / q->r->EA);
}

static double miss(double p, void *context)
{
    return spread(p, context) - ((struct search *)context)->p->x;
}

/* Tension at hi where none is left at lo. */
static double first_tension(struct search *q)
{
    hang_end(q, q->g.lo, 0);
    match_hi(q);
    return q->g.rate > 0 ? q->T[q->g.hi] : 0;
}

static enum status find_tension(struct search *q)
{
    double low = 0, high, at_low, at_high;

    q->first = first_tension(q);
    at_low = miss(low, q);
    q->loose = at_low >= 0;
    if (q->loose)
        return SW_OK;
    high = fmax(q->first, q->r->w * q->r->L0);
    at_high = miss(high, q);
    for (int k = 0; k < DOUBLINGS && at_high < 0; k++) {
        low = high;
        at_low = at_high;
        high *= 2;
        at_high = miss(high, q);
    }
    if (!(at_high >= 0))
        return SW_NOCONV;
    spread(root_between(miss, q, low, at_low, high, at_high), q);
    return isfinite(q->T[0] + q->T[1]) ? SW_OK : SW_NOCONV;
}

/* d(T_hi, T_lo)/d(x, slope, h_a, h_b) from the two conditions that hold: that of the distance, and
 * that of the tensions at both ends of what lies. */
static void differentiate_tensions(const struct search *q, double T_by[2][4])
{
    const struct ground *g = &q->g;
    const struct end *e = q->e;
    int hi = g->hi, lo = g->lo;
    double EA = q->r->EA, A[2][2] = {{0, 0}, {0, 0}}, b[2][4] = {{0}, {0}}, det;
    double by_flat, by_T[2] = {0, 0}, by_m, length, d[3];

    /* length of what lies along the slope, and its derivatives */
    if (q->heap) {
        length = q->T[hi] / g->rate * (1 + q->T[hi] / (2 * EA));
        by_T[hi] = (1 + q->T[hi] / EA) / g->rate;
        by_m = -length / g->rate * g->rate_m;
        by_flat = 0;
    } else {
        length = q->flat + carried(q->T[hi], g->rate, q->flat, d) / EA;
        by_T[hi] = d[0] / EA;
        by_m = d[1] * g->rate_m / EA;
        by_flat = 1 + d[2] / EA;
    }
    /* 0: T_hi - T_lo - rate flat = 0, or T_lo = 0; 1: run_a + run_b + c length = x */
    for (int i = 0; i < 2; i++) {
        double sign = i == 1 ? 1 : -1; /* the slope outwards is m at b, -m at a */

        A[0][i] = q->slack ? i == lo : (i == hi ? 1 : -1) + g->rate * e[i].s_T;
        A[1][i] = e[i].run_T + g->c * (by_T[i] - by_flat * e[i].s_T);
        b[0][2 + i] = q->slack ? 0 : -g->rate * e[i].s_h;
        b[1][2 + i] = g->c * by_flat * e[i].s_h - e[i].run_h;
        b[0][1] += q->slack ? 0 : -g->rate * sign * e[i].s_m;
        b[1][1] += sign * (g->c * by_flat * e[i].s_m - e[i].run_m);
    }
    b[0][1] += q->slack ? 0 : g->rate_m * q->flat;
    b[1][1] -= g->c_m * length + g->c * by_m;
    b[1][0] = 1;
    det = A[0][0] * A[1][1] - A[0][1] * A[1][0];
    for (int k = 0; k < 4; k++) {
        T_by[0][k] = (b[0][k] * A[1][1] - A[0][1] * b[1][k]) / det;
        T_by[1][k] = (A[0][0] * b[1][k] - b[0][k] * A[1][0]) / det;
    }
}

/* Forces at the ends and their derivatives: H = T c, V = T m c + w s. */
static void conclude(struct search *q, struct touch *ret)
{
    double T_by[2][4] = {{0}, {0}}, w = q->r->w;

    for (int i = 0; i < 2; i++)
        differentiate(q->r, q->T[i], q->g.out[i], &q->e[i]);
    if (!q->loose)
        differentiate_tensions(q, T_by);
    for (int i = 0; i < 2; i++) {
        const struct end *e = &q->e[i];
        double m = q->g.out[i], c = q->g.c, sign = i == 1 ? 1 : -1;

        ret->H[i] = e->H;
        ret->V[i] = e->V1;
        for (int k = 0; k < 4; k++) {
            double s_by =
                e->s_T * T_by[i][k] + (k == 2 + i ? e->s_h : 0) + (k == 1 ? sign * e->s_m : 0);

            ret->J[2 * i][k] = c * T_by[i][k] - (k == 1 ? sign * q->T[i] * m * c * c * c : 0);
            ret->J[2 * i + 1][k] =
                m * c * T_by[i][k] + w * s_by + (k == 1 ? sign * q->T[i] * c * c * c : 0);
        }
        ret->s[i] = e->s;
        ret->T[i] = q->T[i] > 2 * q->none ? q->T[i] : 0;
    }
    ret->flat = q->flat;
    ret->heap = 0;
    if (q->heap)
        ret->heap = q->flat - q->T[q->g.hi] / q->g.rate;
}

/* How the tension falls along what lies. */
static void describe(const struct search *q, struct touch *ret)
{
    double lies = ret->flat - ret->heap, T = ret->T[q->g.hi];

    ret->fall[q->g.hi] = q->g.rate;
    if (T > 0)
        ret->reach[q->g.hi] = T >= q->g.rate * lies ? lies : T / q->g.rate;
}

/* As if there were no bed: the line of one cable (theory c1).  Whether it stays above the bed. */
static enum status hang_free(const struct touch_rope *r, const struct touch_place *p,
                             int *ret_clear, struct touch *ret)
{
    double x = fmax(p->x, NARROW * r->L0), F[4], det, dip;
    struct cable c = {.L0 = r->L0,
                      .mu = r->w,
                      .EA = r->EA,
                      .g = 1,
                      .span = x,
                      .drop = p->h[0] - p->h[1] - p->slope * p->x};
    struct line line;
    struct line_point point;
    enum status s = line_solve(&c, &line);

    if (s != SW_OK)
        return s;
    dip = (line.V + p->slope * line.H) / r->w; /* where it is parallel to the bed */
    *ret_clear = 1;
    if (dip > 0 && dip < r->L0) {
        line_at(&line, dip, &point);
        *ret_clear = p->h[0] - point.x2 - p->slope * point.x1 >= 0;
    }
    line_flexibility(&line, F);
    det = F[0] * F[3] - F[1] * F[2];
    for (int i = 0; i < 2; i++) {
        double sign = i == 0 ? 1 : -1;
        double by_x[2] = {F[3] / det, -sign * F[2] / det}; /* H and V by the span */
        double by_drop[2] = {-F[1] / det, sign * F[0] / det};

        ret->H[i] = line.H;
        ret->V[i] = i == 0 ? line.V : r->w * r->L0 - line.V;
        for (int k = 0; k < 2; k++) {
            double *J = ret->J[2 * i + k];

            J[0] = by_x[k] - p->slope * by_drop[k];
            J[1] = -p->x * by_drop[k];
            J[2] = by_drop[k];
            J[3] = -by_drop[k];
        }
    }
    return SW_OK;
}

enum status touch_solve(const struct touch_rope *r, const struct touch_place *p, struct touch *ret)
{
    struct search q = {.r = r, .p = p, .none = SLACK * r->w * r->L0};
    int clear = 0;
    enum status s = hang_free(r, p, &clear, ret);

    memset(ret->s, 0, sizeof ret->s);
    memset(ret->T, 0, sizeof ret->T);
    memset(ret->fall, 0, sizeof ret->fall);
    memset(ret->reach, 0, sizeof ret->reach);
    ret->flat = ret->heap = 0;
    ret->lies = !clear;
    if (s != SW_OK || clear)
        return s;
    look_at_ground(r, p->slope, &q.g);
    s = find_tension(&q);
    if (s != SW_OK)
        return s;
    conclude(&q, ret);
    describe(&q, ret);
    return SW_OK;
}
