/* Floquet multipliers. */
#include "phys/floquet.h"
#include "num/dense.h"
#include "num/mem.h"
#include "num/pi.h"
#include "num/simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST_STEPS 65536

/* Exact flow of q'' + c q' + w^2 q = 0 over h: (q, v) := E (q, v). */
static void oscillator(double w, double c, double h, double E[4])
{
    double square = w * w - c * c / 4, fade = exp(-c * h / 2), C, S;

    if (square > 0) {
        double r = sqrt(square);

        C = cos(r * h);
        S = sin(r * h) / r;
    } else {
        double r = sqrt(-square);

        C = cosh(r * h);
        S = r > 0 ? sinh(r * h) / r : h;
    }
    E[0] = fade * (C + c / 2 * S);
    E[1] = fade * S;
    E[2] = -fade * w * w * S;
    E[3] = fade * (C - c / 2 * S);
}

/* Y (2 s, 2 s) stands row by row, each filled up to whole groups of four columns. */
typedef double lanes __attribute__((vector_size(32), aligned(8), may_alias));

static int groups_of(int s)
{
    return (2 * s + 3) / 4;
}

/* Rows q_k, v_k of all columns of Y; E: 4 s numbers of oscillator(). */
static INLINE_BODY void flow(int s, const double *E, double *Y)
{
    int groups = groups_of(s);
    lanes *y = (lanes *)Y;

    for (int k = 0; k < s; k++, E += 4) {
        lanes *q = y + groups * k, *v = y + groups * (s + k);

        for (int j = 0; j < groups; j++) {
            lanes old = q[j];

            q[j] = E[0] * old + E[1] * v[j];
            v[j] = E[2] * old + E[3] * v[j];
        }
    }
}

/* v -= h B q. */
static INLINE_BODY void subtract(int s, double h, const double *B, double *Y)
{
    int groups = groups_of(s);
    lanes *y = (lanes *)Y;

    for (int j = 0; j < groups; j++)
        for (int i = 0; i < s; i++) {
            lanes sum = h * B[i] * y[j];

            for (int k = 1; k < s; k++)
                sum += h * B[i + s * k] * y[groups * k + j];
            y[groups * (s + i) + j] -= sum;
        }
}

static void subtract_plain(int s, double h, const double *B, double *Y)
{
    subtract(s, h, B, Y);
}

FOR_AVX2 static void subtract_avx2(int s, double h, const double *B, double *Y)
{
    subtract(s, h, B, Y);
}

static void flow_plain(int s, const double *E, double *Y)
{
    flow(s, E, Y);
}

FOR_AVX2 static void flow_avx2(int s, const double *E, double *Y)
{
    flow(s, E, Y);
}

static void run_flow(int s, const double *E, double *Y)
{
    if (has_avx2())
        flow_avx2(s, E, Y);
    else
        flow_plain(s, E, Y);
}

/* v -= h B(t) q; B: s s places of work. */
static void kick(const struct parametric *p, double Omega, double kappa, double t, double h,
                 double *B, double *Y)
{
    int s = p->s;
    double c1 = kappa * cos(Omega * t), s1 = kappa * sin(Omega * t), square = kappa * kappa;
    double c2 = square * cos(2 * Omega * t), s2 = square * sin(2 * Omega * t);

    for (int i = 0; i < s * s; i++) {
        B[i] = c1 * p->psi_c[i] + s1 * p->psi_s[i];
        if (p->quadratic)
            B[i] += square * p->mean[i] + c2 * p->double_c[i] + s2 * p->double_s[i];
    }
    if (has_avx2())
        subtract_avx2(s, h, B, Y);
    else
        subtract_plain(s, h, B, Y);
}

/*
 * Y := monodromy matrix, row by row, by fourth-order steps of five symmetric ones each: flow over
 * half a part, kick, flow.  Flows that meet are one, so that there are three lengths of them: half
 * an outer part, a whole one, and half an outer with half the inner part.  work: s s + 12 s.
 */
static void monodromy(const struct parametric *p, double Omega, double kappa, int steps,
                      double *work, double *Y)
{
    const double outer = 1 / (4 - cbrt(4)), inner = 1 - 4 * outer;
    const double part[5] = {outer, outer, inner, outer, outer};
    const double length[3] = {outer / 2, outer, (outer + inner) / 2};
    const int before[5] = {1, 1, 2, 2, 1}; /* which flow comes before the kick */
    double h = 2 * PI / Omega / steps, t = 0, *E = work, *B = work + 12 * p->s;
    int s = p->s, stride = 4 * groups_of(s);

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < s; k++)
            oscillator(p->omega[k], p->c[k], length[i] * h, E + 4 * (s * i + k));
    memset(Y, 0, sizeof *Y * 2 * (size_t)s * (size_t)stride);
    for (int i = 0; i < 2 * s; i++)
        Y[i + stride * i] = 1;
    for (int k = 0; k < steps; k++)
        for (int i = 0; i < 5; i++) {
            run_flow(s, E + 4 * s * (k == 0 && i == 0 ? 0 : before[i]), Y);
            t += part[i] * h / 2;
            kick(p, Omega, kappa, t, part[i] * h, B, Y);
            t += part[i] * h / 2;
        }
    run_flow(s, E, Y);
}

/* Work space of one group: monodromy matrix row by row and column by column, and the rest. */
struct work {
    double *rows, *A, *steps;
};

static enum status work_new(int modes, struct work *w)
{
    size_t s = (size_t)modes, n = 2 * s;

    w->rows = mem_doubles(4 * n * (size_t)groups_of(modes));
    w->A = mem_doubles(n * n);
    w->steps = mem_doubles(s * s + 12 * s);
    return w->rows && w->A && w->steps ? SW_OK : SW_NOMEM;
}

static void work_free(struct work *w)
{
    free(w->rows);
    free(w->A);
    free(w->steps);
}

/* Eigenvalues, and vectors unless x is NULL, of the matrix in w->rows. */
static enum status eigen(int s, struct work *w, double *re, double *im, double *x)
{
    int n = 2 * s, stride = 4 * groups_of(s);

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            w->A[i + n * j] = w->rows[j + stride * i];
    return dense_general(n, w->A, re, im, x);
}

enum status floquet_multipliers(const struct parametric *p, double Omega, double kappa, int steps,
                                double *re, double *im, double *x)
{
    struct work w;
    enum status s = work_new(p->s, &w);

    if (s == SW_OK) {
        monodromy(p, Omega, kappa, steps, w.steps, w.rows);
        s = eigen(p->s, &w, re, im, x);
    }
    work_free(&w);
    return s;
}

/* The largest multiplier, of equal ones the one with im >= 0 that comes first. */
static int largest(int n, const double *re, const double *im)
{
    int k = 0;

    for (int i = 1; i < n; i++)
        if (im[i] >= 0 && hypot(re[i], im[i]) > hypot(re[k], im[k]) * (1 + 1e-12))
            k = i;
    return k;
}

/* The modes of vector k, velocities over frequencies counted with the displacements. */
static void name_modes(const struct parametric *p, const double *x, int k, int pair,
                       struct floquet *ret)
{
    int s = p->s, n = 2 * s;
    double most = -1, second = -1, all = 0;

    ret->mode = ret->partner = -1;
    for (int i = 0; i < s; i++) {
        double share = 0;

        for (int part = 0; part <= pair; part++) {
            const double *y = x + (size_t)n * (size_t)(k + part);

            share += y[i] * y[i] + pow(y[s + i] / p->omega[i], 2);
        }
        all += share;
        if (share > most) {
            second = most;
            ret->partner = ret->mode;
            most = share;
            ret->mode = i;
        } else if (share > second) {
            second = share;
            ret->partner = i;
        }
    }
    if (!(second > 0.1 * all))
        ret->partner = -1;
}

/* Size of the difference of two monodromy matrices over that of the first, velocities counted over
 * frequencies. */
static double change(const struct parametric *p, const double *M, const double *N)
{
    int s = p->s, n = 2 * s, stride = 4 * groups_of(s);
    double off = 0, all = 0;

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double weight = (i < s ? 1 : 1 / p->omega[i - s]) * (j < s ? 1 : p->omega[j - s]);
            double x = weight * M[j + stride * i], y = weight * N[j + stride * i];

            off += (x - y) * (x - y);
            all += x * x;
        }
    return sqrt(off / all);
}

/* Monodromy matrix of one group of coupled modes into w->rows.  Its error has even orders from the
 * fourth on: it is known within a fifteenth of the change from half as many steps, and extrapolated
 * by that. */
static enum status converge(const struct parametric *p, double Omega, double kappa,
                            double tolerance, struct work *w, int *steps)
{
    size_t size = 8 * (size_t)p->s * (size_t)groups_of(p->s);
    double *half = mem_doubles(size);
    int n = *steps > 8 ? *steps / 2 : 4;
    enum status s = half ? SW_NOCONV : SW_NOMEM;

    if (half)
        monodromy(p, Omega, kappa, n, w->steps, w->rows);
    while (s == SW_NOCONV && n < MOST_STEPS) {
        memcpy(half, w->rows, size * sizeof *half);
        n *= 2;
        monodromy(p, Omega, kappa, n, w->steps, w->rows);
        if (change(p, w->rows, half) <= 15 * tolerance)
            s = SW_OK;
    }
    for (size_t i = 0; i < size && s == SW_OK; i++)
        w->rows[i] += (w->rows[i] - half[i]) / 15;
    *steps = n;
    free(half);
    return s;
}

static enum status solve_group(const struct parametric *p, double Omega, double kappa,
                               double tolerance, struct floquet *ret)
{
    size_t n = 2 * (size_t)p->s;
    double *re = mem_doubles(n), *im = mem_doubles(n), *x = mem_doubles(n * n), modulus;
    int steps = ret->steps, k;
    struct work w;
    enum status s = work_new(p->s, &w);

    if (!re || !im || !x)
        s = SW_NOMEM;
    if (s == SW_OK)
        s = converge(p, Omega, kappa, tolerance, &w, &steps);
    if (s == SW_OK)
        s = eigen(p->s, &w, re, im, x);
    if (s == SW_OK) {
        k = largest((int)n, re, im);
        modulus = hypot(re[k], im[k]);
        *ret = (struct floquet){.modulus = modulus,
                                .growth = log(modulus) * Omega / (2 * PI),
                                .re = re[k],
                                .im = im[k],
                                .crossing = im[k] > 1e-6 * modulus ? CROSSING_COMBINATION
                                            : re[k] > 0            ? CROSSING_T
                                                                   : CROSSING_2T,
                                .steps = steps};
        name_modes(p, x, k, im[k] > 0, ret);
    }
    work_free(&w);
    free(re);
    free(im);
    free(x);
    return s;
}

enum status floquet_solve(const struct parametric *p, double Omega, double kappa, double tolerance,
                          struct floquet *ret)
{
    int *group = mem_zeroed(2 * (size_t)p->s, sizeof *group);
    int *mode = group + p->s, groups = group ? parametric_groups(p, group) : 0;
    int hint = ret->steps;
    enum status s = group ? SW_OK : SW_NOMEM;

    ret->modulus = -1;
    for (int i = 0; i < groups && s == SW_OK; i++) {
        struct parametric part;
        struct floquet f = {.modulus = -1, .steps = hint};

        s = parametric_group(p, group, i, &part, mode);
        if (s == SW_OK)
            s = solve_group(&part, Omega, kappa, tolerance, &f);
        if (s == SW_OK && f.modulus > ret->modulus) {
            *ret = f;
            ret->mode = mode[f.mode];
            ret->partner = f.partner < 0 ? -1 : mode[f.partner];
        }
        parametric_free(&part);
    }
    free(group);
    return s;
}
