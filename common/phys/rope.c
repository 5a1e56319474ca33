/* A rope between two nodes. */
#include "phys/rope.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#define POINTS 8    /* of Gauss */
#define NEARLY 0.05 /* load over tension up to which the integrals are done by quadrature */

double rope_strain(const struct rope_law *law, double T, double *ret_slope)
{
    int k = 0;
    double e0 = 0, T0 = 0, e1, T1;

    if (law->n == 0) {
        *ret_slope = 1 / law->EA;
        return T / law->EA;
    }
    while (k < law->n - 1 && law->tension[k] <= T)
        k++;
    if (k > 0) {
        e0 = law->strain[k - 1];
        T0 = law->tension[k - 1];
    }
    e1 = law->strain[k];
    T1 = law->tension[k];
    *ret_slope = (e1 - e0) / (T1 - T0);
    return e0 + (T - T0) * *ret_slope;
}

double rope_tension(const struct rope_law *law, double e, double *ret_slope)
{
    int k = 0;
    double e0 = 0, T0 = 0;

    if (law->n == 0) {
        *ret_slope = law->EA;
        return law->EA * e;
    }
    while (k < law->n - 1 && law->strain[k] <= e)
        k++;
    if (k > 0) {
        e0 = law->strain[k - 1];
        T0 = law->tension[k - 1];
    }
    *ret_slope = (law->tension[k] - T0) / (law->strain[k] - e0);
    return T0 + (e - e0) * *ret_slope;
}

/* x += l0 (1 + e) t/T and F += l0 {(1 + e)/T [I - t t^T/T^2] + e' t t^T/T^2}, T smoothed. */
static void add_element(const struct rope *r, double l0, const double t[3], double x[3],
                        double F[SYM], double *ret_strain)
{
    double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + r->epsilon * r->epsilon;
    double T = sqrt(square), slope, e = rope_strain(&r->law, T, &slope) + r->give * T;
    double along = l0 * (1 + e) / T, change = (l0 * (slope + r->give) - along) / square;

    for (int i = 0; i < 3; i++)
        x[i] += along * t[i];
    if (ret_strain)
        *ret_strain = e;
    if (!F)
        return;
    F[SYM_XX] += along + change * t[0] * t[0];
    F[SYM_XY] += change * t[0] * t[1];
    F[SYM_XZ] += change * t[0] * t[2];
    F[SYM_YY] += along + change * t[1] * t[1];
    F[SYM_YZ] += change * t[1] * t[2];
    F[SYM_ZZ] += along + change * t[2] * t[2];
}

void rope_joint_load(const struct rope *r, int n, int k, double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = r->load ? r->load[3 * (k - 1) + i] : r->q[i] * r->L0 / n;
}

/* Tension of element k of a chain, from 1, where the elements before it carried so much more, which
 * is counted on: exactly t at the one that t is told of. */
static void next_element(const struct rope *r, const double t[3], int k, double carried[3],
                         double ret[3])
{
    double load[3] = {0, 0, 0};

    if (k > 1)
        rope_joint_load(r, r->elements, k - 1, load);
    for (int i = 0; i < 3; i++) {
        carried[i] += load[i];
        ret[i] = t[i] + (r->offset[i] - carried[i]);
    }
}

static void chain_chord(const struct rope *r, const double ta[3], double chord[3], double F[SYM])
{
    double t[3], carried[3] = {0, 0, 0};

    for (int k = 1; k <= r->elements; k++) {
        next_element(r, ta, k, carried, t);
        add_element(r, r->L0 / r->elements, t, chord, F, NULL);
    }
}

/* Of Gauss and Legendre on [0, 1]. */
static const double node_at[POINTS] = {0.019855071751231884, 0.10166676129318663,
                                       0.23723379504183550,  0.40828267875217510,
                                       0.59171732124782490,  0.76276620495816450,
                                       0.89833323870681337,  0.98014492824876812};
static const double node_weight[POINTS] = {0.050614268145188130, 0.11119051722668724,
                                           0.15685332293894363,  0.18134189168918099,
                                           0.18134189168918099,  0.15685332293894363,
                                           0.11119051722668724,  0.050614268145188130};

/* Tension hardly changes along the rope: its elements, weighted. */
static void quadrature(const struct rope *r, const double ta[3], double L, double chord[3],
                       double F[SYM])
{
    for (int k = 0; k < POINTS; k++) {
        double s = node_at[k] * L;
        const double t[3] = {ta[0] - r->q[0] * s, ta[1] - r->q[1] * s, ta[2] - r->q[2] * s};

        add_element(r, node_weight[k] * L, t, chord, F, NULL);
    }
}

/*
 * The continuous rope: with u the direction of -q, v(s) = t.u growing by w = |q| per metre, h the
 * part of t across u (constant), H^2 = h^2 + epsilon^2, T^2 = H^2 + v^2, the integrals
 *
 *     P = int ds/T = A/w,  A = log1p(2 W/(S - W))      (theory c1)
 *     R = int H^2 ds/T^3 = (v2/T2 - v1/T1)/w,  Q = int v ds/T^3 = (1/T1 - 1/T2)/w
 *
 * give chord = h (P + L/EA) + u (v1 + v2) L [1/(T1 + T2) + 1/(2 EA)] and
 * F = (P + L/EA) I - P-weighted t t^T/T^2.
 */
static void continuous_chord(const struct rope *r, const double ta[3], double L, double chord[3],
                             double F[SYM])
{
    const double *q = r->q;
    double w = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]), W = w * L;
    double EA = 1 / (1 / r->law.EA + r->give);
    double u[3], h[3], v1 = 0, v2, H2 = r->epsilon * r->epsilon, T1, T2;
    double S, rest, P, R, Q, vertical;

    for (int i = 0; i < 3; i++) {
        u[i] = w > 0 ? -q[i] / w : 0;
        v1 += ta[i] * u[i];
    }
    v2 = v1 + W;
    for (int i = 0; i < 3; i++) {
        h[i] = ta[i] - v1 * u[i];
        H2 += h[i] * h[i];
    }
    T1 = sqrt(H2 + v1 * v1);
    T2 = sqrt(H2 + v2 * v2);
    if (W <= NEARLY * fmin(T1, T2)) { /* between the ends it is less by a thousandth at most */
        quadrature(r, ta, L, chord, F);
        return;
    }
    S = T1 + T2;
    rest = (v1 < 0 ? H2 / (T1 - v1) : T1 + v1) + (v2 > 0 ? H2 / (T2 + v2) : T2 - v2);
    P = log1p(2 * W / rest) / w;
    if (v1 < 0 && v2 > 0)
        R = (v2 / T2 - v1 / T1) / w;
    else /* v2 T1 - v1 T2 without cancellation */
        R = H2 * L * (v1 + v2) / (T1 * T2 * (v2 * T1 + v1 * T2));
    Q = L * (v1 + v2) / (S * T1 * T2);
    vertical = L * (v1 + v2) * (1 / S + 1 / (2 * EA));
    for (int i = 0; i < 3; i++)
        chord[i] += h[i] * (P + L / EA) + u[i] * vertical;
    if (!F)
        return;
    { /* int t t^T/T^3 = h h^T R/H^2 + (h u^T + u h^T) Q + u u^T (P - R) */
        int at = 0;

        for (int i = 0; i < 3; i++)
            for (int j = i; j < 3; j++)
                F[at++] += (i == j ? P + L / EA : 0) - h[i] * h[j] * R / H2 -
                           (h[i] * u[j] + u[i] * h[j]) * Q - u[i] * u[j] * (P - R);
    }
}

void rope_chord(const struct rope *r, const double t[3], double chord[3], double F[SYM])
{
    for (int i = 0; i < 3; i++)
        chord[i] = 0;
    for (int i = 0; F && i < SYM; i++)
        F[i] = 0;
    if (r->elements > 0)
        chain_chord(r, t, chord, F);
    else
        continuous_chord(r, t, r->L0, chord, F);
}

void rope_load(const struct rope *r, double ret[3])
{
    double joint[3];

    for (int i = 0; i < 3; i++)
        ret[i] = r->elements > 0 ? 0 : r->q[i] * r->L0;
    for (int k = 1; k < r->elements; k++) {
        rope_joint_load(r, r->elements, k, joint);
        for (int i = 0; i < 3; i++)
            ret[i] += joint[i];
    }
}

void rope_end_load(const struct rope *r, double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = r->elements > 0 && !r->load ? r->q[i] * r->L0 / r->elements / 2 : 0;
}

static double size(const double t[3])
{
    return sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
}

void rope_refer(struct rope *r, double t[3])
{
    double at[3], best[3] = {t[0], t[1], t[2]}, carried[3] = {0, 0, 0}, least = INFINITY;
    double offset[3] = {0, 0, 0};

    for (int k = 1; k <= r->elements; k++) {
        next_element(r, t, k, carried, at);
        if (!(size(at) < least))
            continue;
        least = size(at);
        memcpy(best, at, sizeof best);
        memcpy(offset, carried, sizeof offset);
    }
    memcpy(r->offset, offset, sizeof offset);
    memcpy(t, best, sizeof best);
}

void rope_points(const struct rope *r, const double t[3], int n, struct rope_point *ret)
{
    double l0 = r->L0 / (n - 1), slope, carried[3] = {0, 0, 0};

    ret[0] = (struct rope_point){.t = {t[0], t[1], t[2]}};
    if (r->elements > 0)
        next_element(r, t, 1, carried, ret[0].t);
    for (int k = 1; k < n; k++) {
        struct rope_point *p = &ret[k], *before = &ret[k - 1];

        *p = *before;
        p->s = k < n - 1 ? k * l0 : r->L0;
        if (r->elements > 0)
            add_element(r, l0, before->t, p->x, NULL, &before->strain);
        else
            continuous_chord(r, before->t, l0, p->x, NULL);
        for (int i = 0; i < 3; i++)
            p->load[i] = r->elements > 0 ? 0 : r->q[i] * l0;
        if (r->elements > 0 && k < n - 1)
            rope_joint_load(r, r->elements, k, p->load);
        for (int i = 0; i < 3; i++)
            p->t[i] = before->t[i] - p->load[i];
        if (r->elements > 0 && k < n - 1)
            next_element(r, t, k + 1, carried, p->t);
        if (r->elements == 0)
            before->strain = rope_strain(&r->law, size(before->t), &slope);
    }
    ret[n - 1].strain = rope_strain(&r->law, size(ret[n - 1].t), &slope);
}

void rope_extremes(const struct rope *r, const double t[3], double *ret_most, double *ret_least)
{
    double at[3], carried[3] = {0, 0, 0}, w = 0, along = 0;

    *ret_most = r->elements > 0 ? 0 : size(t);
    *ret_least = r->elements > 0 ? INFINITY : size(t);
    for (int k = 1; k <= r->elements; k++) {
        next_element(r, t, k, carried, at);
        *ret_most = fmax(*ret_most, size(at));
        *ret_least = fmin(*ret_least, size(at));
    }
    if (r->elements > 0)
        return;
    for (int i = 0; i < 3; i++) {
        at[i] = t[i] - r->q[i] * r->L0;
        w += r->q[i] * r->q[i];
        along += t[i] * r->q[i];
    }
    *ret_most = fmax(*ret_most, size(at));
    *ret_least = fmin(*ret_least, size(at));
    if (w > 0 && along > 0 && along < w * r->L0) { /* least where t is across q */
        for (int i = 0; i < 3; i++)
            at[i] = t[i] - r->q[i] * along / w;
        *ret_least = fmin(*ret_least, size(at));
    }
}

double rope_lowest(const struct rope *r, const double t[3])
{
    double x[3] = {0, 0, 0}, at[3], carried[3] = {0, 0, 0}, least = 0;

    for (int k = 1; k <= r->elements; k++) {
        next_element(r, t, k, carried, at);
        add_element(r, r->L0 / r->elements, at, x, NULL, NULL);
        least = fmin(least, x[2]);
    }
    if (r->elements > 0)
        return least;
    continuous_chord(r, t, r->L0, x, NULL);
    least = fmin(0, x[2]);
    if (r->q[2] < 0 && t[2] < 0 && t[2] - r->q[2] * r->L0 > 0) { /* where it is level */
        x[0] = x[1] = x[2] = 0;
        continuous_chord(r, t, t[2] / r->q[2], x, NULL);
        least = fmin(least, x[2]);
    }
    return least;
}

/* int sqrt(H^2 + v^2) dv from 0. */
static double primitive(double H2, double v)
{
    double T = sqrt(H2 + v * v);

    return (v * T + (H2 > 0 ? H2 * asinh(v / sqrt(H2)) : 0)) / 2;
}

double rope_length(const struct rope *r, const double t[3])
{
    double at[3] = {t[0], t[1], t[2]}, carried[3] = {0, 0, 0}, sum = r->L0, slope, w = size(r->q);

    for (int k = 1; k <= r->elements; k++) {
        next_element(r, t, k, carried, at);
        sum += r->L0 / r->elements * rope_strain(&r->law, size(at), &slope);
    }
    if (r->elements > 0)
        return sum;
    if (w * r->L0 <= 1e-6 * size(t)) {
        for (int i = 0; i < 3; i++)
            at[i] -= r->q[i] * r->L0 / 2;
        return sum * (1 + size(at) / r->law.EA);
    }
    { /* 1/EA int T ds */
        double v1 = -(t[0] * r->q[0] + t[1] * r->q[1] + t[2] * r->q[2]) / w;
        double H2 = fmax(0, t[0] * t[0] + t[1] * t[1] + t[2] * t[2] - v1 * v1);

        return sum + (primitive(H2, v1 + w * r->L0) - primitive(H2, v1)) / (w * r->law.EA);
    }
}

int sym_invert(const double F[SYM], double K[SYM])
{
    double a = F[SYM_XX], b = F[SYM_XY], c = F[SYM_XZ], d = F[SYM_YY], e = F[SYM_YZ];
    double f = F[SYM_ZZ], l1, l2, p, l3, r;

    /* L D L^T, which keeps the digits of stiff directions beside soft ones */
    if (!(a > 0))
        return 0;
    l1 = b / a;
    l2 = c / a;
    p = d - l1 * b;
    if (!(p > 0))
        return 0;
    l3 = (e - l2 * b) / p;
    r = f - l2 * c - l3 * (e - l2 * b);
    if (!(r > 0))
        return 0;
    {
        double m = l1 * l3 - l2; /* L^{-1} has -l1, m, -l3 */

        K[SYM_ZZ] = 1 / r;
        K[SYM_YZ] = -l3 / r;
        K[SYM_XZ] = m / r;
        K[SYM_YY] = 1 / p + l3 * l3 / r;
        K[SYM_XY] = -l1 / p - l3 * m / r;
        K[SYM_XX] = 1 / a + l1 * l1 / p + m * m / r;
    }
    return 1;
}

void sym_times(const double A[SYM], const double x[3], double y[3])
{
    y[0] = A[SYM_XX] * x[0] + A[SYM_XY] * x[1] + A[SYM_XZ] * x[2];
    y[1] = A[SYM_XY] * x[0] + A[SYM_YY] * x[1] + A[SYM_YZ] * x[2];
    y[2] = A[SYM_XZ] * x[0] + A[SYM_YZ] * x[1] + A[SYM_ZZ] * x[2];
}
