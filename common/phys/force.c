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

void force_all(struct force_table *t, int terms, const double *V, double *F,
               struct force_extremes *ret)
{
    size_t stride = LANES * (size_t)t->groups + LANES, nodes = (size_t)t->n + 1;

    for (size_t k = 0; k < nodes; k++)
        for (size_t c = 0; c < 6; c++)
            t->v[c * stride + k] = V[6 * k + c];
    memset(t->f, 0, 6 * stride * sizeof *t->f);
    if (has_avx2())
        all_groups_avx2(t, terms, ret);
    else
        all_groups_plain(t, terms, ret);
    for (size_t k = 0; k < nodes; k++)
        for (size_t c = 0; c < 6; c++)
            F[6 * k + c] = t->f[c * stride + k];
}
