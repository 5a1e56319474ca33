/* Projection of the stiffness change in a ground motion on modes. */
#include "phys/parametric.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum status projection_new(const struct model *m, const struct modes *p, const int *mode, int s,
                           struct projection *ret)
{
    double *V = model_vector(m);
    size_t points = GAUSS * (size_t)m->n;

    *ret = (struct projection){m, s, mem_doubles(3 * (size_t)s * points)};
    if (!V || !ret->slope) {
        free(V);
        projection_free(ret);
        return SW_NOMEM;
    }
    for (int k = 0; k < s; k++) {
        modes_shape(m, p, mode[k], V);
        for (size_t point = 0; point < points; point++) {
            const double *f1 = m->slope[point % GAUSS], *v = V + 6 * (point / GAUSS);

            for (size_t c = 0; c < 3; c++)
                ret->slope[c + 3 * ((size_t)k + (size_t)s * point)] =
                    f1[0] * v[2 * c] + f1[1] * v[2 * c + 1] + f1[2] * v[2 * c + 6] +
                    f1[3] * v[2 * c + 7];
        }
    }
    free(V);
    return SW_OK;
}

void projection_free(struct projection *p)
{
    free(p->slope);
    p->slope = NULL;
}

/* Room for s modes. */
static enum status room(int s, struct parametric *ret)
{
    size_t n = (size_t)s, square = n * n;
    double *at = mem_doubles(2 * n + 5 * square);

    *ret = (struct parametric){.s = s, .memory = at};
    if (!at)
        return SW_NOMEM;
    ret->omega = at;
    ret->c = at + n;
    ret->psi_c = at + 2 * n;
    ret->psi_s = ret->psi_c + square;
    ret->mean = ret->psi_s + square;
    ret->double_c = ret->mean + square;
    ret->double_s = ret->double_c + square;
    return SW_OK;
}

enum status parametric_new(const struct modes *p, const int *mode, int s, double alpha, double beta,
                           struct parametric *ret)
{
    if (room(s, ret) != SW_OK)
        return SW_NOMEM;
    for (int k = 0; k < s; k++) {
        ret->omega[k] = p->omega[mode[k]];
        ret->c[k] = alpha + beta * ret->omega[k] * ret->omega[k];
    }
    return SW_OK;
}

void parametric_free(struct parametric *p)
{
    free(p->memory);
    p->memory = NULL;
}

static double dot(const double *x, const double *y)
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/* a^T u and a^T b^T-like products of a real slope with the complex slope w of the ground motion. */
static double complex zdot(const double *x, const double complex *w)
{
    return x[0] * w[0] + x[1] * w[1] + x[2] * w[2];
}

/* Adds what one Gauss point brings to entries (i, j), j <= i. */
static void add_point(const struct projection *p, size_t point, enum theory theory, int quadratic,
                      const double complex *w, double weight, struct parametric *ret)
{
    const struct material *m = &p->model->material[point];
    const double x[3] = {m->x1, m->x2, 0}, *slope = p->slope + 3 * (size_t)p->s * point;
    double complex gamma = zdot(x, w), square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    double mean = creal(w[0] * conj(w[0]) + w[1] * conj(w[1]) + w[2] * conj(w[2]));

    for (int i = 0; i < p->s; i++)
        for (int j = 0; j <= i; j++) {
            const double *a = slope + 3 * i, *b = slope + 3 * j;
            double ab = dot(a, b);
            double complex wa = zdot(a, w), wb = zdot(b, w), change = gamma * ab;
            int at = i + p->s * j;

            if (theory == THEORY_INDIFFERENCE)
                change += dot(x, a) * wb + wa * dot(x, b);
            ret->psi_c[at] += weight * creal(change);
            ret->psi_s[at] -= weight * cimag(change);
            if (!quadratic)
                continue;
            /* Re(w e^{it}) Re(w e^{it}) = [Re(w conj(w)) + Re(w w e^{2it})]/2 */
            change = wa * wb + square / 2 * ab;
            ret->mean[at] += weight / 2 * (creal(wa * conj(wb)) + mean / 2 * ab);
            ret->double_c[at] += weight / 2 * creal(change);
            ret->double_s[at] -= weight / 2 * cimag(change);
        }
}

void parametric_fill(const struct projection *p, enum theory theory, int quadratic,
                     const double complex *V, struct parametric *ret)
{
    const struct model *m = p->model;
    int s = p->s;
    double *const all[5] = {ret->psi_c, ret->psi_s, ret->mean, ret->double_c, ret->double_s};

    ret->quadratic = quadratic;
    memset(ret->psi_c, 0, 5 * (size_t)s * (size_t)s * sizeof *ret->psi_c);
    for (size_t point = 0; point < GAUSS * (size_t)m->n; point++) {
        const double *f1 = m->slope[point % GAUSS];
        const double complex *v = V + 6 * (point / GAUSS);
        double complex w[3];

        for (int c = 0; c < 3; c++)
            w[c] = f1[2] * (v[2 * c + 6] - v[2 * c]) + f1[1] * v[2 * c + 1] + f1[3] * v[2 * c + 7];
        add_point(p, point, theory, quadratic, w,
                  gauss_weight[point % GAUSS] * m->h * m->material[point].EA, ret);
    }
    for (int k = 0; k < 5; k++)
        for (int j = 0; j < s; j++)
            for (int i = j + 1; i < s; i++)
                all[k][j + s * i] = all[k][i + s * j];
}

int parametric_groups(const struct parametric *p, int *ret_group)
{
    const double *const all[5] = {p->psi_c, p->psi_s, p->mean, p->double_c, p->double_s};
    int s = p->s, groups = 0, changed = 1;
    double most[5] = {0};

    for (int k = 0; k < 5; k++)
        for (int i = 0; i < s * s; i++)
            most[k] = fmax(most[k], fabs(all[k][i]));
    for (int i = 0; i < s; i++)
        ret_group[i] = i;
    while (changed) { /* the lower number spreads over all that are coupled */
        changed = 0;
        for (int k = 0; k < 5; k++)
            for (int i = 0; i < s; i++)
                for (int j = 0; j < s; j++)
                    if (fabs(all[k][i + s * j]) > 1e-13 * most[k] && ret_group[j] < ret_group[i]) {
                        ret_group[i] = ret_group[j];
                        changed = 1;
                    }
    }
    for (int i = 0; i < s; i++) /* renumbered without gaps: a group is named by its first mode */
        ret_group[i] = ret_group[i] == i ? groups++ : ret_group[ret_group[i]];
    return groups;
}

enum status parametric_group(const struct parametric *p, const int *group, int which,
                             struct parametric *ret, int *ret_mode)
{
    const double *const from[5] = {p->psi_c, p->psi_s, p->mean, p->double_c, p->double_s};
    int s = 0;

    for (int i = 0; i < p->s; i++)
        if (group[i] == which)
            ret_mode[s++] = i;
    if (room(s, ret) != SW_OK)
        return SW_NOMEM;
    ret->quadratic = p->quadratic;
    for (int i = 0; i < s; i++) {
        double *const to[5] = {ret->psi_c, ret->psi_s, ret->mean, ret->double_c, ret->double_s};

        ret->omega[i] = p->omega[ret_mode[i]];
        ret->c[i] = p->c[ret_mode[i]];
        for (int k = 0; k < 5; k++)
            for (int j = 0; j < s; j++)
                to[k][i + s * j] = from[k][ret_mode[i] + p->s * ret_mode[j]];
    }
    return SW_OK;
}
