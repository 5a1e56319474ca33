/*
 * Static line of one elastic cable.
 *
 * The chord of the piece from the left support to theta is, with W and L0 of the piece,
 *     V2 = V - W,  T1 = |(H, V)|,  T2 = |(H, V2)|,  S = T1 + T2,  A = log(1 + 2 W/(S - W))
 *     l = H L0 (1/EA + A/W),    h = L0 (V - W/2)(1/EA + 2/S)
 * which cancels nowhere if S - W is summed from T1 - V and T2 + V2, each without cancellation.
 */
#include "phys/line.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#define MAX_STEPS 200

double line_chord(const struct cable *c)
{
    return hypot(c->span, c->drop);
}

/* T - v for T = hypot(H, v). */
static double excess(double H, double T, double v)
{
    return v > 0 ? H / (T + v) * H : T - v;
}

/* log(1 + x)/x, 1 at x = 0. */
static double log1p_ratio(double x)
{
    return x > 0 ? log1p(x) / x : 1;
}

/* sinh(A)/A - 1: series below 0.25 (last term used 6e-17 of the first). */
static double sinhc_minus_1(double A)
{
    double q = A * A;

    if (A < 0.25)
        return q / 6 * (1 + q / 20 * (1 + q / 42 * (1 + q / 72 * (1 + q / 110 * (1 + q / 156)))));
    return sinh(A) / A - 1;
}

/* What the chord and its derivatives share. */
struct piece {
    double L, V2, T1, T2, S;
    double A, A_over_W; /* A_over_W stays finite as W goes to 0 */
};

static struct piece cut(double L, double W, double H, double V)
{
    struct piece p = {.L = L, .V2 = V - W};
    double rest;

    p.T1 = hypot(H, V);
    p.T2 = hypot(H, p.V2);
    p.S = p.T1 + p.T2;
    rest = excess(H, p.T1, V) + excess(H, p.T2, -p.V2);
    p.A_over_W = 2 / rest * log1p_ratio(2 * W / rest);
    p.A = W * p.A_over_W;
    return p;
}

static void chord(const struct piece *p, double EA, double H, double V, double ret[2])
{
    ret[0] = H * p->L * (1 / EA + p->A_over_W);
    ret[1] = p->L * ((V + p->V2) / 2) * (1 / EA + 2 / p->S);
}

/* Derivatives of the chord by (H, V), symmetric, positive definite. */
static void flexibility(const struct piece *p, double EA, double H, double V, double ret[4])
{
    double H1 = H / p->T1, H2 = H / p->T2, v1 = V / p->T1, v2 = p->V2 / p->T2;
    double k = H1 * H2;
    double one_minus_k = (H1 * H1 * v2 * v2 + v1 * v1 * H2 * H2 + v1 * v1 * v2 * v2) / (1 + k);
    double bow = k * sinhc_minus_1(p->A);

    ret[0] = p->L / EA + p->L * p->A_over_W * (one_minus_k - bow);
    ret[1] = ret[2] = -p->L * H1 * (V + p->V2) / (p->S * p->T2);
    ret[3] = p->L / EA + p->L * p->A_over_W * (k + bow);
}

const char *line_inadmissible(const struct cable *c)
{
    if (!(c->L0 > 0 && isfinite(c->L0)))
        return "the unstressed length must be positive";
    if (!(c->mu > 0 && isfinite(c->mu)))
        return "the mass per length must be positive";
    if (!(c->EA > 0 && isfinite(c->EA)))
        return "the axial stiffness must be positive";
    if (!(c->span > 0 && isfinite(c->span) && isfinite(c->drop)))
        return "the span must be positive";
    if (!(c->g >= 0 && isfinite(c->g)))
        return "the acceleration of gravity must not be negative";
    if (c->g == 0 && !(line_chord(c) > c->L0))
        return "without gravity the chord must be longer than the unstressed length";
    return NULL;
}

/* Start of the Newton iteration (theory c1). */
static void start(struct line *s)
{
    const struct cable *c = &s->cable;
    double l = c->span, h = c->drop, d = hypot(l, h), strain = d / c->L0 - 1;
    double lambda = 0.2, q = (c->L0 - h) * (c->L0 + h) / (l * l) - 1;

    if (c->L0 > d && q > 0)
        lambda = sqrt(3 * q);
    s->H = fmax(s->W * l / (2 * c->L0 * lambda), c->EA * strain * l / d);
    s->V = strain > 0 ? s->W / 2 + s->H * h / l : s->W / 2 * (1 + h / (c->L0 * tanh(lambda)));
}

/* Error of the chord at (H, V) in ret and its norm over the chord's length. */
static double residual(const struct cable *c, double W, double H, double V, struct piece *p,
                       double ret[2])
{
    *p = cut(c->L0, W, H, V);
    chord(p, c->EA, H, V, ret);
    ret[0] -= c->span;
    ret[1] -= c->drop;
    return hypot(ret[0], ret[1]) / line_chord(c);
}

/*
 * One damped step.  The chord is the gradient of a convex function of (H, V), so a step may be
 * taken whole unless it overshoots along its own direction and the residual does not fall.
 * Returns the new relative residual, or a negative number where the step no longer helps.
 */
static double newton_step(struct line *s, struct piece *p, double r[2], double old)
{
    const struct cable *c = &s->cable;
    double F[4], det, dH, dV;

    flexibility(p, c->EA, s->H, s->V, F);
    det = F[0] * F[3] - F[1] * F[2];
    dH = -(F[3] * r[0] - F[1] * r[1]) / det;
    dV = -(F[0] * r[1] - F[2] * r[0]) / det;
    /* NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter,cert-flp30-c): halves are exact */
    for (double f = 1; f > 1e-10; f /= 2) {
        double H = fmax(s->H + f * dH, s->H / 10), V = s->V + f * dV, trial[2];
        struct piece q;
        double rel = residual(c, s->W, H, V, &q, trial);

        if (rel < old || trial[0] * dH + trial[1] * dV <= 0) {
            *p = q;
            s->H = H;
            s->V = V;
            r[0] = trial[0];
            r[1] = trial[1];
            return rel;
        }
    }
    return -1;
}

enum status line_solve(const struct cable *c, struct line *ret)
{
    struct line s = {.cable = *c, .W = c->mu * c->g * c->L0}, best;
    struct piece p;
    double r[2], rel, least, longest;

    if (line_inadmissible(c))
        return SW_ADMISSIBLE;
    start(&s);
    best = s;
    rel = least = residual(c, s.W, s.H, s.V, &p, r);
    while (s.steps < MAX_STEPS && rel > 2 * DBL_EPSILON) {
        rel = newton_step(&s, &p, r, rel);
        s.steps++;
        if (!(rel >= 0) || (least < 1e-13 && rel >= least))
            break; /* round-off reached */
        if (rel < least) {
            best = s;
            least = rel;
        }
    }
    *ret = best;
    ret->steps = s.steps;
    /* round-off of the chord is that of the longer of stretched cable and chord */
    longest = c->L0 * (1 + (best.H + fabs(best.V) + s.W) / c->EA) / line_chord(c);
    return least < 1e-13 * (1 + longest) ? SW_OK : SW_NOCONV;
}

void line_at(const struct line *s, double theta, struct line_point *ret)
{
    const struct cable *c = &s->cable;
    double W = s->W * (theta / c->L0), x[2] = {0, 0};
    struct piece p = cut(theta, W, s->H, s->V);

    if (theta > 0)
        chord(&p, c->EA, s->H, s->V, x);
    *ret = (struct line_point){theta, x[0], x[1], p.V2, p.T2, 1 + p.T2 / c->EA};
}

void line_flexibility(const struct line *s, double ret[4])
{
    struct piece p = cut(s->cable.L0, s->W, s->H, s->V);

    flexibility(&p, s->cable.EA, s->H, s->V, ret);
}

void line_stiffness(const struct line *s, double ret[9])
{
    double F[4], det;

    line_flexibility(s, F);
    det = F[0] * F[3] - F[1] * F[2];
    for (int i = 0; i < 9; i++)
        ret[i] = 0;
    ret[0] = F[3] / det;
    ret[1] = ret[3] = -F[1] / det;
    ret[4] = F[0] / det;
    ret[8] = s->H / s->cable.span;
}

void line_piece(const struct line *s, double a, double b, struct line *ret)
{
    double per_metre = s->W / s->cable.L0, x[2];
    struct piece p;

    *ret = *s;
    ret->cable.L0 = b - a;
    ret->W = per_metre * (b - a);
    ret->V = s->V - per_metre * a;
    p = cut(ret->cable.L0, ret->W, ret->H, ret->V);
    chord(&p, s->cable.EA, ret->H, ret->V, x);
    ret->cable.span = x[0];
    ret->cable.drop = x[1];
}

/* (h1 l2 - h2 l1)/l of the two pieces' chords: no difference of places that nearly agree. */
double line_below_chord(const struct line *s, double theta)
{
    struct line left, right;

    line_piece(s, 0, theta, &left);
    line_piece(s, theta, s->cable.L0, &right);
    return (left.cable.drop * right.cable.span - right.cable.drop * left.cable.span) /
           s->cable.span;
}

double line_deepest(const struct line *s)
{
    const struct cable *c = &s->cable;
    double parallel = s->H / c->span * c->drop; /* V of a tangent along the chord */

    return s->W > 0 ? fmin(fmax((s->V - parallel) / s->W, 0), 1) * c->L0 : c->L0 / 2;
}

double line_sag(const struct line *s)
{
    return line_below_chord(s, s->cable.L0 / 2);
}

/*
 * L0 (1 + mean tension/EA).  The mean of |(H, v)| over v from V2 to V1 is
 * [(V1 T1 - V2 T2)/W + H^2 A/W]/2 with V1 T1 - V2 T2 = W S/2 + (V1 + V2)/2 W (V1 + V2)/S.
 */
double line_length(const struct line *s)
{
    double V1 = s->V, V2 = s->V - s->W, L = s->cable.L0;
    struct piece p = cut(L, s->W, s->H, V1);
    double both = V1 + V2;
    double mean = (p.S / 2 + both / 2 * (both / p.S) + s->H * s->H * p.A_over_W) / 2;

    return L * (1 + mean / s->cable.EA);
}

double line_lambda2(const struct line *s, double m)
{
    const struct cable *c = &s->cable;
    double d = line_chord(c), cosine = c->span / d;
    double T = s->H / cosine;             /* chord tension */
    double q = m * c->g * cosine * d / T; /* m g cos(angle) Lc/Tc */
    double Le = d * (1 + q * q / 8);

    return q * q * d * c->EA / (T * Le);
}
