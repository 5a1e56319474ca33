/* Eigenmodes: plane and lateral pencils solved apart, then merged by frequency. */
#include "phys/modes.h"
#include "num/lanczos.h"
#include "num/mem.h"
#include "num/pencil.h"
#include "num/pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DENSE_ELEMENTS 30 /* up to here modes_lowest takes the dense solution */

/* The pencil of one part without its prescribed unknowns, and its modes. */
struct part_modes {
    struct band K, M;
    int n; /* unknowns */
    int k; /* modes wanted, then found */
    double *lambda, *x;
};

static void part_free(struct part_modes *p)
{
    band_free(&p->K);
    band_free(&p->M);
    free(p->lambda);
    free(p->x);
}

/* K and M of a part over its free unknowns. */
static enum status part_new(const struct model *m, enum part part, struct part_modes *ret)
{
    struct band K = {0}, M = {0};
    int n = ret->n = part_width(part) * m->n;
    int *keep = mem_zeroed((size_t)n, sizeof *keep);
    enum status s = keep ? model_stiffness(m, part, &K) : SW_NOMEM;

    if (s == SW_OK)
        s = model_mass(m, part, &M);
    if (s == SW_OK) {
        model_free_unknowns(m, part, keep);
        s = band_restrict(&K, keep, n, &ret->K);
    }
    if (s == SW_OK)
        s = band_restrict(&M, keep, n, &ret->M);
    free(keep);
    band_free(&K);
    band_free(&M);
    return s;
}

/* The k lowest modes of a part: all of them by the dense solution, else by Lanczos. */
static enum status part_solve(struct part_modes *p, int dense)
{
    if (dense)
        p->k = p->n;
    if (p->k == 0)
        return SW_OK;
    p->lambda = mem_doubles((size_t)p->k);
    p->x = mem_doubles((size_t)p->n * (size_t)p->k);
    if (!p->lambda || !p->x)
        return SW_NOMEM;
    return dense ? pencil_all(&p->K, &p->M, p->lambda, p->x)
                 : lanczos_lowest(&p->K, &p->M, p->k, p->lambda, p->x);
}

/* A part's vector over its free unknowns into one over all nodes. */
static void scatter(const struct model *m, enum part part, const double *x, double *V)
{
    int width = part_width(part), first = part_first(part);

    for (int k = 0; k <= m->n; k++)
        for (int c = 0; c < width; c++)
            if ((k > 0 && k < m->n) || c % 2 == 1)
                V[6 * (size_t)k + (size_t)(first + c)] = *x++;
}

/* The free unknowns of V, in ascending order. */
static void gather(const struct model *m, const double *V, double *phi)
{
    for (int k = 0; k <= m->n; k++)
        for (int c = 0; c < 6; c++)
            if ((k > 0 && k < m->n) || c % 2 == 1)
                *phi++ = V[6 * (size_t)k + (size_t)c];
}

/*
 * The sign that makes the largest displacement component positive, the axes being those of space.
 * Displacements of node k >= 1 stand at 6 k - 3 and every second place after it.  A single element
 * has no such node: the slopes at its left end, which come first, tell.
 */
static double sign_of(const struct model *m, const double *phi)
{
    double most = 0, sign = 1;
    int looked_for = 0, single = m->n == 1, step = single ? 1 : 2;

    for (int pass = 0; pass < 2; pass++)
        for (int k = 1; k < m->n + single && !looked_for; k++) {
            const double *at = single ? phi : phi + 6 * (size_t)k - 3;
            const double v[3] = {at[0], at[step], at[2 * step]};
            double x[3];

            axes_to_space(&m->axes, v, x);
            for (int c = 0; c < 3 && !looked_for; c++) {
                if (pass == 0)
                    most = fmax(most, fabs(x[c]));
                else if (fabs(x[c]) >= (1 - 1e-6) * most) {
                    sign = x[c] < 0 ? -1 : 1;
                    looked_for = 1;
                }
            }
        }
    return sign;
}

static enum status merge(const struct model *m, const struct part_modes part[2], struct modes *ret)
{
    int next[2] = {0, 0};
    double *V = model_vector(m);

    ret->omega = mem_doubles((size_t)ret->k);
    ret->phi = mem_doubles((size_t)ret->n * (size_t)ret->k);
    ret->plane = mem_zeroed((size_t)ret->k, sizeof *ret->plane);
    if (!V || !ret->omega || !ret->phi || !ret->plane) {
        free(V);
        return SW_NOMEM;
    }
    for (int k = 0; k < ret->k; k++) {
        int lateral = next[0] == part[0].k ||
                      (next[1] < part[1].k && part[1].lambda[next[1]] < part[0].lambda[next[0]]);
        const struct part_modes *p = &part[lateral];
        const double *x = p->x + (size_t)p->n * (size_t)next[lateral];
        double *phi = ret->phi + (size_t)ret->n * (size_t)k, sign;

        ret->omega[k] = sqrt(p->lambda[next[lateral]++]);
        ret->plane[k] = lateral ? PART_LATERAL : PART_PLANE;
        memset(V, 0, sizeof *V * model_unknowns(m));
        scatter(m, ret->plane[k], x, V);
        gather(m, V, phi);
        sign = sign_of(m, phi);
        for (int i = 0; i < ret->n; i++)
            phi[i] *= sign;
    }
    free(V);
    return SW_OK;
}

/* Modes of both parts below omega, by the Sturm count. */
static int count(struct part_modes part[2], double omega)
{
    for (int i = 0; i < 2; i++)
        part[i].k = band_count_below(&part[i].K, &part[i].M, omega * omega);
    return part[0].k + part[1].k;
}

/*
 * A circular frequency with k modes or a few more below it, the first guess from the taut string;
 * part[].k tells how many of them each part has.
 */
static double find_cut(const struct model *m, int k, struct part_modes part[2])
{
    const struct cable *c = &m->line.cable;
    double low = 0, high = 0;
    double omega = PI / c->span * sqrt(m->line.H * c->span / (c->mu * c->L0)) * (k / 2 + 1.5);

    for (int step = 0; step < 200; step++) {
        int n = count(part, omega);

        if (n < k)
            low = omega;
        else
            high = omega;
        if (n >= k && (n <= k + 2 || high - low < 1e-6 * high))
            break;
        omega = high == 0 ? 2 * omega : (low + high) / 2;
    }
    return omega;
}

/* Exchange modes j and j - 1. */
static void swap_modes(struct modes *p, int j)
{
    double *phi = p->phi + (size_t)p->n * (size_t)j, omega = p->omega[j];
    enum part plane = p->plane[j];

    p->omega[j] = p->omega[j - 1];
    p->plane[j] = p->plane[j - 1];
    p->omega[j - 1] = omega;
    p->plane[j - 1] = plane;
    for (double *other = phi - p->n; other < p->phi + (size_t)p->n * (size_t)j; other++, phi++) {
        double x = *phi;

        *phi = *other;
        *other = x;
    }
}

/* Lanczos gives eigenvalues to the round-off of K, which is that of the highest mode; the quotient
 * of the vector is far better.  Neighbours are put in order again. */
static enum status refine(const struct model *m, struct modes *p)
{
    double *V = model_vector(m);

    if (!V)
        return SW_NOMEM;
    for (int k = 0; k < p->k; k++) {
        modes_shape(m, p, k, V);
        p->omega[k] = sqrt(model_quotient(m, V));
    }
    for (int k = 1; k < p->k; k++)
        for (int j = k; j > 0 && p->omega[j] < p->omega[j - 1]; j--)
            swap_modes(p, j);
    free(V);
    return SW_OK;
}

static enum status by_lanczos(const struct model *m, struct part_modes part[2], struct modes *ret)
{
    enum status s = SW_OK;

    ret->cut = find_cut(m, ret->k, part);
    ret->counted = part[0].k + part[1].k;
    for (int i = 0; i < 2 && s == SW_OK; i++) {
        s = part_solve(&part[i], 0);
        if (s == SW_OK && part[i].k > 0 &&
            !(sqrt(part[i].lambda[part[i].k - 1]) < ret->cut * (1 + 1e-5)))
            s = SW_NOCONV; /* one that was counted has not been found */
    }
    if (s == SW_OK)
        s = merge(m, part, ret);
    return s == SW_OK ? refine(m, ret) : s;
}

static enum status by_lapack(const struct model *m, struct part_modes part[2], struct modes *ret)
{
    enum status s = part_solve(&part[0], 1);

    if (s == SW_OK)
        s = part_solve(&part[1], 1);
    return s == SW_OK ? merge(m, part, ret) : s;
}

int modes_lanczos_most(int n)
{
    return lanczos_most(2 * n) - 2; /* the lateral part may hold nearly all, and a few more */
}

/* Lanczos costs n k^2, the dense solution n^3, and is as fast as that for small n. */
static int takes_dense(const struct model *m, int k, enum solver solver)
{
    if (solver != SOLVER_AUTO)
        return solver == SOLVER_DENSE;
    return m->n <= DENSE_ELEMENTS || (k > m->n && m->n <= MODES_MAX_ELEMENTS) ||
           k > modes_lanczos_most(m->n);
}

enum status modes_lowest(const struct model *m, int k, enum solver solver, struct modes *ret)
{
    struct part_modes part[2] = {{.n = 0}, {.n = 0}};
    int dense = takes_dense(m, k, solver);
    enum status s = SW_OK;

    *ret = (struct modes){.n = 6 * m->n, .k = k};
    if (dense ? m->n > MODES_MAX_ELEMENTS : k > modes_lanczos_most(m->n))
        return SW_ADMISSIBLE;
    s = part_new(m, PART_PLANE, &part[0]);
    if (s == SW_OK)
        s = part_new(m, PART_LATERAL, &part[1]);
    if (s == SW_OK)
        s = dense ? by_lapack(m, part, ret) : by_lanczos(m, part, ret);
    if (s != SW_OK)
        modes_free(ret);
    part_free(&part[0]);
    part_free(&part[1]);
    return s;
}

enum status modes_of_part(const struct model *m, enum part part, int mode, double *ret_omega)
{
    struct part_modes p = {.k = mode};
    int n = part_width(part) * m->n, dense = 2 * mode > m->n;
    double *V = model_vector(m);
    enum status s = V ? SW_OK : SW_NOMEM;

    if (mode > n || (dense && m->n > MODES_MAX_ELEMENTS))
        s = SW_ADMISSIBLE;
    if (s == SW_OK)
        s = part_new(m, part, &p);
    if (s == SW_OK)
        s = part_solve(&p, dense);
    if (s == SW_OK && band_count_below(&p.K, &p.M, p.lambda[mode - 1] * (1 - 1e-5)) >= mode)
        s = SW_NOCONV; /* a lower one has been missed */
    if (s == SW_OK) {
        scatter(m, part, p.x + (size_t)n * (size_t)(mode - 1), V);
        *ret_omega = sqrt(model_quotient(m, V));
    }
    part_free(&p);
    free(V);
    return s;
}

void modes_free(struct modes *p)
{
    free(p->omega);
    free(p->phi);
    free(p->plane);
    *p = (struct modes){0};
}

double hertz(double omega)
{
    return omega / (2 * PI);
}

void modes_shape(const struct model *m, const struct modes *p, int i, double *V)
{
    const double *phi = p->phi + (size_t)p->n * (size_t)i;

    for (int k = 0; k <= m->n; k++)
        for (int c = 0; c < 6; c++) {
            int at_support = k == 0 || k == m->n;

            V[6 * (size_t)k + (size_t)c] = at_support && c % 2 == 0 ? 0 : *phi++;
        }
}

enum status modes_unit_shape(const struct model *m, const struct modes *p, int i, double *V)
{
    double most = 0, steepest = 0;

    modes_shape(m, p, i, V);
    for (int k = 0; k <= m->n; k++) {
        const double *v = V + 6 * (size_t)k;

        most = fmax(most, sqrt(v[0] * v[0] + v[2] * v[2] + v[4] * v[4]));
        steepest = fmax(steepest, sqrt(v[1] * v[1] + v[3] * v[3] + v[5] * v[5]));
    }
    if (!(most > 1e-3 * m->h * steepest)) /* others have 1e-2 and more, those with nodes 3e-4 */
        return SW_ADMISSIBLE;
    for (size_t j = 0; j < model_unknowns(m); j++)
        V[j] /= most;
    return SW_OK;
}
