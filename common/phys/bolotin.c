/* Bolotin's boundaries. */
#include "phys/bolotin.h"
#include "num/dense.h"
#include "num/mem.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Layout of y: for period T first b_0, then a_j, b_j for j = 2, 4, ...; for 2 T a_j, b_j for
 * j = 1, 3, ...; s entries each. */
struct layout {
    int s, period, last; /* last: highest harmonic */
    int n;               /* entries of y */
};

static struct layout lay_out(int s, int period, int harmonics)
{
    int last = harmonics - (harmonics % 2 != (period == 2));

    return (struct layout){s, period, last, s * (last + 1)};
}

enum wave { SINE, COSINE };

/* First entry of a_j or b_j, or -1. */
static int place(const struct layout *l, enum wave wave, int j)
{
    if (j > l->last || (wave == SINE && j == 0))
        return -1;
    if (j == 0)
        return 0;
    return l->s * (j - 1 + (wave == COSINE));
}

/* Z += c Psi in the rows of wave m (negative ones as positive) for the unknowns at column. */
static void couple(const struct layout *l, enum wave wave, int m, double c, const double *psi,
                   int column, double *Z)
{
    int row = place(l, wave, abs(m));

    if (row < 0)
        return;
    if (wave == SINE && m < 0)
        c = -c;
    for (int j = 0; j < l->s; j++)
        for (int i = 0; i < l->s; i++)
            Z[row + i + l->n * (column + j)] += c * psi[i + l->s * j];
}

/* Z += [C cos(2 q p) + S sin(2 q p)] acting on all waves of q = Omega t/2, by the products of sine
 * and cosine; C or S may be NULL. */
static void modulate(const struct layout *l, int p, const double *C, const double *S, double *Z)
{
    for (int j = l->period == 2 ? 1 : 0; j <= l->last; j += 2) {
        int a = place(l, SINE, j), b = place(l, COSINE, j), up = j + 2 * p, down = j - 2 * p;

        if (a >= 0) {
            couple(l, SINE, up, 0.5, C, a, Z);
            couple(l, SINE, down, 0.5, C, a, Z);
            couple(l, COSINE, down, 0.5, S, a, Z);
            couple(l, COSINE, up, -0.5, S, a, Z);
        }
        couple(l, COSINE, up, 0.5, C, b, Z);
        couple(l, COSINE, down, 0.5, C, b, Z);
        couple(l, SINE, up, 0.5, S, b, Z);
        couple(l, SINE, down, -0.5, S, b, Z);
    }
}

/* Z += Psi acting on all waves. */
static void add_mean(const struct layout *l, const double *psi, double *Z)
{
    for (int block = 0; block < l->n; block += l->s)
        for (int j = 0; j < l->s; j++)
            for (int i = 0; i < l->s; i++)
                Z[block + i + l->n * (block + j)] += psi[i + l->s * j];
}

/* Columns of Z := -X^{-1} Z; X couples a_j and b_j of one mode only. */
static void divide(const struct layout *l, const struct parametric *p, double Omega, double *Z)
{
    for (int j = l->period == 2 ? 1 : 0; j <= l->last; j += 2) {
        int a = place(l, SINE, j), b = place(l, COSINE, j);

        for (int k = 0; k < l->s; k++) {
            double w = j * Omega / 2, square = p->omega[k] * p->omega[k];
            double d = square - w * w, e = w * p->c[k], size = d * d + e * e;

            if (!(size > DBL_MIN)) { /* the tip of an undamped region */
                d = DBL_EPSILON * square;
                size = d * d;
            }
            for (int column = 0; column < l->n; column++) {
                double *zb = &Z[b + k + l->n * column];
                double *za = a >= 0 ? &Z[a + k + l->n * column] : NULL;
                double old = za ? *za : 0;

                if (za)
                    *za = -(d * old + e * *zb) / size;
                *zb = -(d * *zb - e * old) / size;
            }
        }
    }
}

/* Shares of the modes in y, and their harmonics. */
static void name_modes(const struct layout *l, const double *y, struct boundary *ret)
{
    double all = 0, most = -1, second = -1;

    ret->mode = ret->partner = -1;
    for (int k = 0; k < l->s; k++) {
        double share = 0, peak = -1;
        int order = 0;

        for (int j = l->period == 2 ? 1 : 0; j <= l->last; j += 2) {
            int a = place(l, SINE, j), b = place(l, COSINE, j);
            double part = y[b + k] * y[b + k] + (a >= 0 ? y[a + k] * y[a + k] : 0);

            share += part;
            if (part > peak) {
                peak = part;
                order = j;
            }
        }
        all += share;
        if (share > most) {
            second = most;
            ret->partner = ret->mode;
            most = share;
            ret->mode = k;
            ret->order = order;
        } else if (share > second) {
            second = share;
            ret->partner = k;
        }
    }
    ret->share = most / all;
    if (!(second > 0.1 * all))
        ret->partner = -1;
}

/* A = the matrix whose eigenvalues are 1/kappa: -X^{-1} Z, or with Y
 * (-X^{-1} Z, -X^{-1} Y; I, 0). */
static enum status fill(const struct layout *l, const struct parametric *p, double Omega, double *A,
                        int order)
{
    size_t n = (size_t)l->n;
    double *Z = mem_doubles(n * n), *Y = mem_doubles(n * n);

    if (!Z || !Y) {
        free(Z);
        free(Y);
        return SW_NOMEM;
    }
    modulate(l, 1, p->psi_c, p->psi_s, Z);
    divide(l, p, Omega, Z);
    if (p->quadratic) {
        add_mean(l, p->mean, Y);
        modulate(l, 2, p->double_c, p->double_s, Y);
        divide(l, p, Omega, Y);
    }
    for (int j = 0; j < l->n; j++) {
        for (int i = 0; i < l->n; i++) {
            A[i + order * j] = Z[i + l->n * j];
            if (p->quadratic)
                A[i + order * (l->n + j)] = Y[i + l->n * j];
        }
        if (p->quadratic)
            A[l->n + j + order * j] = 1;
    }
    free(Z);
    free(Y);
    return SW_OK;
}

static int ascending(const void *a, const void *b)
{
    double x = ((const struct boundary *)a)->kappa, y = ((const struct boundary *)b)->kappa;

    return (x > y) - (x < y);
}

/* Appends the boundaries of one group of coupled modes; mode[i]: its modes in the whole. */
static enum status solve_group(const struct parametric *p, const int *mode, double Omega,
                               int period, int harmonics, double most, struct boundary *ret,
                               int room, int *ret_n)
{
    struct layout l = lay_out(p->s, period, harmonics);
    size_t order = (size_t)l.n * (p->quadratic ? 2 : 1);
    double *A = mem_doubles(order * order), *x = mem_doubles(order * order);
    double *re = mem_doubles(order), *im = mem_doubles(order);
    enum status s = A && x && re && im ? fill(&l, p, Omega, A, (int)order) : SW_NOMEM;

    if (s == SW_OK)
        s = dense_general((int)order, A, re, im, x);
    for (size_t k = 0; k < order && s == SW_OK; k++) {
        double kappa = 1 / re[k];

        if (!(re[k] > 0 && fabs(im[k]) < 1e-7 * re[k] && kappa <= most) || *ret_n == room)
            continue;
        ret[*ret_n].kappa = kappa;
        ret[*ret_n].change = NAN;
        name_modes(&l, x + order * k + (p->quadratic ? l.n : 0), &ret[*ret_n]);
        ret[*ret_n].mode = mode[ret[*ret_n].mode];
        if (ret[*ret_n].partner >= 0)
            ret[*ret_n].partner = mode[ret[*ret_n].partner];
        (*ret_n)++;
    }
    free(A);
    free(x);
    free(re);
    free(im);
    return s;
}

enum status bolotin_solve(const struct parametric *p, double Omega, int period, int harmonics,
                          double most, struct boundary *ret, int room, int *ret_n)
{
    int *group = mem_zeroed(2 * (size_t)p->s, sizeof *group);
    int *mode = group + p->s, groups = group ? parametric_groups(p, group) : 0;
    enum status s = group ? SW_OK : SW_NOMEM;

    *ret_n = 0;
    for (int i = 0; i < groups && s == SW_OK; i++) {
        struct parametric part;

        s = parametric_group(p, group, i, &part, mode);
        if (s == SW_OK)
            s = solve_group(&part, mode, Omega, period, harmonics, most, ret, room, ret_n);
        parametric_free(&part);
    }
    if (s == SW_OK)
        qsort(ret, (size_t)*ret_n, sizeof *ret, ascending);
    free(group);
    return s;
}

enum status bolotin_change(const struct parametric *p, double Omega, int period, int harmonics,
                           struct boundary *points, int n)
{
    int room = 4 * p->s * (harmonics + 1), m = 0;
    struct boundary *coarse = mem_zeroed((size_t)room, sizeof *coarse);
    enum status s = coarse ? SW_OK : SW_NOMEM;

    if (s == SW_OK && harmonics > 2)
        s = bolotin_solve(p, Omega, period, harmonics - 2, INFINITY, coarse, room, &m);
    for (int i = 0; i < n && s == SW_OK; i++)
        for (int k = 0; k < m; k++) {
            double change = fabs(coarse[k].kappa / points[i].kappa - 1);

            if (coarse[k].mode == points[i].mode && coarse[k].order == points[i].order &&
                !(change >= points[i].change))
                points[i].change = change;
        }
    free(coarse);
    return s;
}
