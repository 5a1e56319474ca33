/* Eigenmodes: plane and lateral pencils solved apart, then merged by frequency. */
#include "phys/modes.h"
#include "num/mem.h"
#include "num/pencil.h"
#include "num/pi.h"

#include <math.h>
#include <stdlib.h>

/* All modes of one part; lambda and x are allocated, order width n. */
struct part_modes {
    int n;
    double *lambda, *x;
};

static void part_modes_free(struct part_modes *p)
{
    free(p->lambda);
    free(p->x);
}

static enum status solve_part(const struct model *m, enum part part, struct part_modes *ret)
{
    struct band K = {0}, M = {0}, K_free = {0}, M_free = {0};
    int n = part_width(part) * m->n;
    int *keep = mem_zeroed((size_t)n, sizeof *keep);
    enum status s = keep ? SW_OK : SW_NOMEM;

    ret->n = n;
    ret->lambda = mem_doubles((size_t)n);
    ret->x = mem_doubles((size_t)n * (size_t)n);
    if (!ret->lambda || !ret->x)
        s = SW_NOMEM;
    if (s == SW_OK) {
        model_free_unknowns(m, part, keep);
        s = model_stiffness(m, part, &K);
    }
    if (s == SW_OK)
        s = model_mass(m, part, &M);
    if (s == SW_OK)
        s = band_restrict(&K, keep, n, &K_free);
    if (s == SW_OK)
        s = band_restrict(&M, keep, n, &M_free);
    if (s == SW_OK)
        s = pencil_all(&K_free, &M_free, ret->lambda, ret->x);
    free(keep);
    band_free(&K);
    band_free(&M);
    band_free(&K_free);
    band_free(&M_free);
    return s;
}

/* Free unknown i of a part as one of the model's. */
static int place(const struct model *m, enum part part, int i)
{
    int width = part_width(part), slopes = width / 2; /* free ones of the first node */
    int node, c;

    if (i < slopes)
        return part_first(part) / 2 + i;
    node = (i - slopes) / width;
    c = (i - slopes) % width;
    if (node == m->n - 1) /* slopes of the last node */
        return 3 + 6 * node + part_first(part) / 2 + c;
    return 3 + 6 * node + part_first(part) + c;
}

/* Whether free unknown i is a displacement: the slopes of the first and last node come alone. */
static int is_displacement(const struct model *m, int i)
{
    return i >= 3 && i < 6 * m->n - 3 && (i - 3) % 2 == 0;
}

static void fix_sign(const struct model *m, double *phi, int n)
{
    double most = 0, sign = 1;

    for (int i = 0; i < n; i++)
        if (is_displacement(m, i))
            most = fmax(most, fabs(phi[i]));
    for (int i = 0; i < n; i++)
        if (is_displacement(m, i) && fabs(phi[i]) >= (1 - 1e-6) * most) {
            sign = phi[i] < 0 ? -1 : 1;
            break;
        }
    for (int i = 0; i < n; i++)
        phi[i] *= sign;
}

static void merge(const struct model *m, const struct part_modes part[2], struct modes *ret)
{
    int next[2] = {0, 0};

    for (int k = 0; k < ret->k; k++) {
        int lateral = next[0] == part[0].n ||
                      (next[1] < part[1].n && part[1].lambda[next[1]] < part[0].lambda[next[0]]);
        const struct part_modes *p = &part[lateral];
        const double *x = p->x + (size_t)p->n * (size_t)next[lateral];
        double *phi = ret->phi + (size_t)ret->n * (size_t)k;

        ret->omega[k] = sqrt(p->lambda[next[lateral]++]);
        ret->plane[k] = lateral ? PART_LATERAL : PART_PLANE;
        for (int i = 0; i < p->n; i++)
            phi[place(m, ret->plane[k], i)] = x[i];
        fix_sign(m, phi, ret->n);
    }
}

enum status modes_all(const struct model *m, int k, struct modes *ret)
{
    struct part_modes part[2] = {{0}, {0}};
    enum status s = SW_ADMISSIBLE;

    *ret = (struct modes){.n = 6 * m->n, .k = k};
    if (m->n <= MODES_MAX_ELEMENTS)
        s = solve_part(m, PART_PLANE, &part[0]);
    if (s == SW_OK)
        s = solve_part(m, PART_LATERAL, &part[1]);
    if (s == SW_OK) {
        ret->omega = mem_doubles((size_t)k);
        ret->phi = mem_doubles((size_t)ret->n * (size_t)k);
        ret->plane = mem_zeroed((size_t)k, sizeof *ret->plane);
        s = ret->omega && ret->phi && ret->plane ? SW_OK : SW_NOMEM;
    }
    if (s == SW_OK)
        merge(m, part, ret);
    else
        modes_free(ret);
    part_modes_free(&part[0]);
    part_modes_free(&part[1]);
    return s;
}

void modes_free(struct modes *p)
{
    free(p->omega);
    free(p->phi);
    free(p->plane);
    *p = (struct modes){0};
}

double modes_frequency(const struct modes *p, int i)
{
    return p->omega[i] / (2 * PI);
}

enum status modes_unit_shape(const struct model *m, const struct modes *p, int i, double *V)
{
    const double *phi = p->phi + (size_t)p->n * (size_t)i;
    double most = 0, steepest = 0;

    for (int k = 0; k <= m->n; k++) {
        double *v = V + 6 * (size_t)k;

        for (int c = 0; c < 6; c++) {
            int at_support = k == 0 || k == m->n;

            v[c] = at_support && c % 2 == 0 ? 0 : *phi++;
        }
        most = fmax(most, sqrt(v[0] * v[0] + v[2] * v[2] + v[4] * v[4]));
        steepest = fmax(steepest, sqrt(v[1] * v[1] + v[3] * v[3] + v[5] * v[5]));
    }
    if (!(most > 1e-3 * m->h * steepest)) /* others have 1e-2 and more, those with nodes 3e-4 */
        return SW_ADMISSIBLE;
    for (size_t j = 0; j < model_unknowns(m); j++)
        V[j] /= most;
    return SW_OK;
}
