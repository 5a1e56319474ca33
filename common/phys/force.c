/* Internal forces, four elements at a time. */
#include "phys/force.h"
#include "num/mem.h"
#include "num/simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LANES 4

/* Lanes of elements k, k + 1, k + 2, k + 3; loaded from and stored to any double. */
typedef double lanes __attribute__((vector_size(8 * LANES), aligned(8), may_alias));
typedef long mask __attribute__((vector_size(8 * LANES)));

enum { X1, X2, EA, T, STIFF, N_FIELDS };

/* Pairs of (d, a, b) and of components: 0 0, 1 0, 1 1, 2 0, 2 1, 2 2. */
enum { PAIRS = 6 };
static inline int pair(int i, int j)
{
    return i > j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/* Values and slopes at the left, at the right, are -d, a, d, b of a tangent. */
static void lay_entries(struct tangent_entry *to)
{
    static const int base[4] = {0, 1, 0, 2};

    for (int u = 0; u < 12; u++)
        for (int v = u; v < 12; v++, to++) {
            int i = u / 6 * 2 + u % 2, j = v / 6 * 2 + v % 2;

            to->from = LANES * (PAIRS * pair(base[j], base[i]) + pair(v % 6 / 2, u % 6 / 2));
            to->to = 12 * u + v - u;
            to->sign = (i == 0) != (j == 0) ? -1 : 1;
        }
}

enum status force_new(const struct model *m, struct force_table *ret)
{
    size_t groups = ((size_t)m->n + LANES - 1) / LANES, stride = LANES * groups + LANES;

    *ret = (struct force_table){.n = m->n, .groups = (int)groups};
    ret->material = mem_doubles(groups * GAUSS * N_FIELDS * LANES);
    ret->v = mem_doubles(6 * stride);
    ret->f = mem_doubles(6 * stride);
    if (!ret->material || !ret->v || !ret->f) {
        force_free(ret);
        return SW_NOMEM;
    }
    lay_entries(ret->entry);
    for (int q = 0; q < GAUSS; q++) {
        ret->factor[q][0] = m->slope[q][2];
        ret->factor[q][1] = m->slope[q][1];
        ret->factor[q][2] = m->slope[q][3];
    }
    for (int k = 0; k < m->n; k++)
        for (int q = 0; q < GAUSS; q++) {
            const struct material *p = &m->material[GAUSS * k + q];
            double *to = ret->material +
                         LANES * N_FIELDS * ((size_t)q + GAUSS * (size_t)(k / LANES)) + k % LANES;

            to[LANES * X1] = p->x1;
            to[LANES * X2] = p->x2;
            to[LANES * EA] = gauss_weight[q] * m->h * p->EA;
            to[LANES * T] = gauss_weight[q] * m->h * p->T;
            to[LANES * STIFF] = 3 * p->EA / (p->EA * p->stretch * p->stretch + p->T);
        }
    return SW_OK;
}

void force_free(struct force_table *t)
{
    free(t->material);
    free(t->v);
    free(t->f);
    *t = (struct force_table){0};
}

/* Where the three extremes of four lanes are collected; NaN wins. */
struct watch {
    lanes least, most;
};

/*
 * Forces of one group, elements 4 g and so on.  With d the difference of the ends and a, b their
 * slopes, w = v,1 = factor . (d, a, b); force density as in element_force.
 */
static INLINE_BODY void group_force(const struct force_table *t, size_t g, size_t stride, int terms,
                                    struct watch *watch)
{
    const lanes *m = (const lanes *)(t->material + g * GAUSS * N_FIELDS * LANES);
    const double t1 = terms >= 1, t2 = terms >= 2, t3 = terms >= 3;
    lanes d[3], a[3], b[3], fd[3] = {{0}}, fa[3] = {{0}}, fb[3] = {{0}};

    for (size_t c = 0; c < 3; c++) {
        const double *v = t->v + 2 * c * stride + LANES * g;

        d[c] = *(const lanes *)(v + 1) - *(const lanes *)v;
        a[c] = *(const lanes *)(v + stride);
        b[c] = *(const lanes *)(v + stride + 1);
    }
    for (int q = 0; q < GAUSS; q++, m += N_FIELDS) {
        const double *f = t->factor[q];
        lanes w[3], n, along, half, S, Sx, stiffened;

        for (int c = 0; c < 3; c++)
            w[c] = f[0] * d[c] + f[1] * a[c] + f[2] * b[c];
        along = m[X1] * w[0] + m[X2] * w[1];
        half = 0.5 * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        S = m[T] + m[EA] * (t1 * along + t3 * half);
        Sx = m[EA] * (along + t2 * half);
        for (int c = 0; c < 3; c++) {
            n = S * w[c];
            if (c < 2)
                n += Sx * m[c == 0 ? X1 : X2];
            fd[c] += f[0] * n;
            fa[c] += f[1] * n;
            fb[c] += f[2] * n;
        }
        S = m[T] + m[EA] * (along + half);
        stiffened = m[STIFF] * (along + half);
        {
            mask less = ~(mask)(S >= watch->least), more = ~(mask)(stiffened <= watch->most);

            watch->least = (lanes)(((mask)S & less) | ((mask)watch->least & ~less));
            watch->most = (lanes)(((mask)stiffened & more) | ((mask)watch->most & ~more));
        }
    }
    for (size_t c = 0; c < 3; c++) {
        double *to = t->f + 2 * c * stride + LANES * g;

        *(lanes *)to -= fd[c];
        *(lanes *)(to + 1) += fd[c];
        *(lanes *)(to + stride) += fa[c];
        *(lanes *)(to + stride + 1) += fb[c];
    }
}

/* All groups; V has gone to t->v, F comes from t->f. */
static INLINE_BODY void all_groups(const struct force_table *t, int terms,
                                   struct force_extremes *ret)
{
    size_t stride = LANES * (size_t)t->groups + LANES;
    struct watch watch;

    for (int i = 0; i < LANES; i++) {
        watch.least[i] = INFINITY;
        watch.most[i] = -INFINITY;
    }
    /* terms as a constant: the factors 0 and 1 vanish */
    for (size_t g = 0; g < (size_t)t->groups; g++)
        if (terms == 3)
            group_force(t, g, stride, 3, &watch);
        else
            group_force(t, g, stride, terms, &watch);
    *ret = (struct force_extremes){INFINITY, -INFINITY};
    for (int i = 0; i < LANES; i++) {
        if (!(watch.least[i] >= ret->least_force))
            ret->least_force = watch.least[i];
        if (!(watch.most[i] <= ret->most_stiffened))
            ret->most_stiffened = watch.most[i];
    }
}

static void all_groups_plain(const struct force_table *t, int terms, struct force_extremes *ret)
{
    all_groups(t, terms, ret);
}

FOR_AVX2 static void all_groups_avx2(const struct force_table *t, int terms,
                                     struct force_extremes *ret)
{
    all_groups(t, terms, ret);
}

/* V to t->v. */
static size_t lay_out(struct force_table *t, const double *V)
{
    size_t stride = LANES * (size_t)t->groups + LANES, nodes = (size_t)t->n + 1;

    for (size_t k = 0; k < nodes; k++)
        for (size_t c = 0; c < 6; c++)
            t->v[c * stride + k] = V[6 * k + c];
    return stride;
}

void force_all(struct force_table *t, int terms, const double *V, double *F,
               struct force_extremes *ret)
{
    size_t stride = lay_out(t, V), nodes = (size_t)t->n + 1;

    memset(t->f, 0, 6 * stride * sizeof *t->f);
    if (has_avx2())
        all_groups_avx2(t, terms, ret);
    else
        all_groups_plain(t, terms, ret);
    for (size_t k = 0; k < nodes; k++)
        for (size_t c = 0; c < 6; c++)
            F[6 * k + c] = t->f[c * stride + k];
}

/*
 * Tangent of one group in (d, a, b), six pairs of these by six of components: sums of
 * f_i f_j {[T + EA (x'.w + w.w/2)] I + EA (x' + w) (x' + w)^T}, by parts.
 */
static INLINE_BODY void group_tangent(const struct force_table *t, size_t g, size_t stride,
                                      int terms, lanes sum[PAIRS][PAIRS])
{
    const lanes *m = (const lanes *)(t->material + g * GAUSS * N_FIELDS * LANES);
    const double nonlinear = terms >= 1, cubic = terms >= 3;
    lanes d[3], a[3], b[3];

    for (size_t c = 0; c < 3; c++) {
        const double *v = t->v + 2 * c * stride + LANES * g;

        d[c] = *(const lanes *)(v + 1) - *(const lanes *)v;
        a[c] = *(const lanes *)(v + stride);
        b[c] = *(const lanes *)(v + stride + 1);
    }
    for (int i = 0; i < PAIRS * PAIRS; i++)
        sum[i / PAIRS][i % PAIRS] = (lanes){0};
    for (int q = 0; q < GAUSS; q++, m += N_FIELDS) {
        const double *f = t->factor[q];
        lanes w[3], D[PAIRS], along, half;

        for (int c = 0; c < 3; c++)
            w[c] = f[0] * d[c] + f[1] * a[c] + f[2] * b[c];
        along = m[X1] * w[0] + m[X2] * w[1];
        half = 0.5 * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j <= i; j++) {
                lanes xx = {0}, xw = {0};

                if (i < 2 && j < 2)
                    xx = m[X1 + i] * m[X1 + j];
                if (j < 2)
                    xw = w[i] * m[X1 + j];
                if (i < 2)
                    xw += m[X1 + i] * w[j];
                D[pair(i, j)] = m[EA] * (xx + nonlinear * xw + cubic * w[i] * w[j]);
            }
        for (int c = 0; c < 3; c++)
            D[pair(c, c)] += m[T] + m[EA] * (nonlinear * along + cubic * half);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j <= i; j++)
                for (int c = 0; c < PAIRS; c++)
                    sum[pair(i, j)][c] += f[i] * f[j] * D[c];
    }
}

static INLINE_BODY void all_tangents(const struct force_table *t, int terms, double factor,
                                     struct band *J)
{
    size_t stride = LANES * (size_t)t->groups + LANES;
    lanes sum[PAIRS][PAIRS];

    for (int k = 0; k < t->n; k++) {
        if (k % LANES == 0 && terms == 3)
            group_tangent(t, (size_t)k / LANES, stride, 3, sum);
        else if (k % LANES == 0)
            group_tangent(t, (size_t)k / LANES, stride, terms, sum);
        for (int e = 0; e < 78; e++) {
            const struct tangent_entry *p = &t->entry[e];

            band_at(J, 6 * k, 6 * k)[p->to] +=
                factor * p->sign * ((const double *)sum)[p->from + k % LANES];
        }
    }
}

static void all_tangents_plain(const struct force_table *t, int terms, double factor,
                               struct band *J)
{
    all_tangents(t, terms, factor, J);
}

FOR_AVX2 static void all_tangents_avx2(const struct force_table *t, int terms, double factor,
                                       struct band *J)
{
    all_tangents(t, terms, factor, J);
}

void force_tangent(struct force_table *t, int terms, const double *V, double factor, struct band *J)
{
    lay_out(t, V);
    if (has_avx2())
        all_tangents_avx2(t, terms, factor, J);
    else
        all_tangents_plain(t, terms, factor, J);
}
