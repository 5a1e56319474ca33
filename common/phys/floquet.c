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

/* Rows q_k, v_k of all columns of Y (2 s, 2 s), row by row. */
static void flow(const struct parametric *p, double h, double *Y)
{
    int s = p->s, columns = 2 * s;

    for (int k = 0; k < s; k++) {
        double E[4], *q = Y + columns * k, *v = Y + columns * (s + k);

        oscillator(p->omega[k], p->c[k], h, E);
        for (int j = 0; j < columns; j++) {
            double old = q[j];

            q[j] = E[0] * old + E[1] * v[j];
            v[j] = E[2] * old + E[3] * v[j];
        }
    }
}

/* v -= h B q. */
static INLINE_BODY void subtract(int s, double h, const double *B, double *Y)
{
    int columns = 2 * s;

    for (int i = 0; i < s; i++)
        for (int k = 0; k < s; k++) {
            double b = h * B[i + s * k];
            double *v = Y + columns * (s + i);
            const double *q = Y + columns * k;

            for (int j = 0; j < columns; j++)
                v[j] -= b * q[j];
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

/* Y := monodromy matrix, row by row, by fourth-order steps of five symmetric ones each. */
static void monodromy(const struct parametric *p, double Omega, double kappa, int steps, double *B,
                      double *Y)
{
    const double outer = 1 / (4 - cbrt(4)), inner = 1 - 4 * outer;
    const double part[5] = {outer, outer, inner, outer, outer};
    double h = 2 * PI / Omega / steps, t = 0, pending = 0;
    int columns = 2 * p->s;

    memset(Y, 0, sizeof *Y * (size_t)columns * (size_t)columns);
    for (int i = 0; i < columns; i++)
        Y[i + columns * i] = 1;
    for (int k = 0; k < steps; k++)
        for (int i = 0; i < 5; i++) {
            double step = part[i] * h;

            flow(p, pending + step / 2, Y);
            t += step / 2;
            kick(p, Omega, kappa, t, step, B, Y);
            t += step / 2;
            pending = step / 2;
        }
    flow(p, pending, Y);
}

enum status floquet_multipliers(const struct parametric *p, double Omega, double kappa, int steps,
                                double *re, double *im, double *x)
{
    size_t s = (size_t)p->s, n = 2 * s;
    double *B = mem_doubles(s * s), *Y = mem_doubles(n * n), *A = mem_doubles(n * n);
    enum status status = SW_NOMEM;

    if (B && Y && A) {
        monodromy(p, Omega, kappa, steps, B, Y);
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                A[i + n * j] = Y[j + n * i];
        status = dense_general((int)n, A, re, im, x);
    }
    free(B);
    free(Y);
    free(A);
    return status;
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

/* One group of coupled modes.  The error of the modulus has even orders from the fourth on: two
 * numbers of steps give an extrapolated one, which must stand still. */
static enum status solve_group(const struct parametric *p, double Omega, double kappa,
                               double tolerance, struct floquet *ret)
{
    size_t n = 2 * (size_t)p->s;
    double *re = mem_doubles(n), *im = mem_doubles(n), *x = mem_doubles(n * n);
    double modulus = NAN, limit = NAN, T = 2 * PI / Omega;
    int k = 0, steps = ret->steps > 16 ? ret->steps / 4 : 4;
    enum status s = re && im && x ? SW_OK : SW_NOMEM;

    for (int done = 0; s == SW_OK && !done; steps *= 2) {
        double before = modulus, last = limit;

        s = floquet_multipliers(p, Omega, kappa, steps, re, im, x);
        if (s != SW_OK)
            break;
        k = largest((int)n, re, im);
        modulus = hypot(re[k], im[k]);
        limit = (16 * modulus - before) / 15;
        done = fabs(limit - last) <= tolerance * modulus;
        if (!done && steps >= MOST_STEPS)
            s = SW_NOCONV;
    }
    if (s == SW_OK) {
        *ret = (struct floquet){.modulus = limit,
                                .growth = log(limit) / T,
                                .re = re[k],
                                .im = im[k],
                                .crossing = im[k] > 1e-6 * modulus ? CROSSING_COMBINATION
                                            : re[k] > 0            ? CROSSING_T
                                                                   : CROSSING_2T,
                                .steps = steps / 2};
        name_modes(p, x, k, im[k] > 0, ret);
    }
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
