/* The linear systems of a time step. */
#include "phys/inertia.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>

/* part := all, or all := part, for the unknowns that the part takes in. */
static void gather(const struct inertia_part *p, int nodes, const double *all, double *part)
{
    for (int k = 0; k < nodes; k++)
        for (int c = 0; c < p->width; c++)
            part[p->width * k + c] = all[6 * k + part_first(p->part) + c];
}

static void scatter(const struct inertia_part *p, int nodes, const double *part, double *all)
{
    for (int k = 0; k < nodes; k++)
        for (int c = 0; c < p->width; c++)
            all[6 * k + part_first(p->part) + c] = part[p->width * k + c];
}

/* Place among the six prescribed displacements (left v1 v2 v3, right) of held unknown i. */
static int support_component(const struct inertia_part *p, int i)
{
    int a_side = p->n_held / 2;

    return i / a_side * 3 + part_first(p->part) / 2 + i % a_side;
}

/* Factor of A with unit rows and columns for the held unknowns. */
static enum status factor_held(const struct inertia_part *p, struct band_factor *ret)
{
    const struct band *A = &p->A;
    struct band copy = *A;
    enum status s;

    copy.a = mem_copy(A->a, sizeof(double) * (size_t)A->n * (size_t)(A->kd + 1));
    if (!copy.a)
        return SW_NOMEM;
    for (int i = 0; i < p->n_held; i++) {
        int b = p->held[i];

        for (int j = b - A->kd; j <= b + A->kd; j++)
            if (j >= 0 && j < A->n)
                *band_at(&copy, j > b ? j : b, j > b ? b : j) = j == b;
    }
    s = band_cholesky(&copy, ret);
    band_free(&copy);
    return s;
}

/* part: PART_PLANE or PART_LATERAL; the latter also serves all components where beta is 0. */
static enum status part_new(const struct model *m, enum part part, double a, double b, double alpha,
                            double beta, struct inertia_part *ret)
{
    struct band M = {0}, K = {0};
    int width = ret->width = part_width(part);
    size_t size = (size_t)width * ((size_t)m->n + 1);
    enum status s = model_mass(m, part, &M);

    ret->part = part;
    for (int i = 0; i < width; i++) /* value unknowns of the first, then of the last node */
        if (i % 2 == 0) {
            ret->held[i / 2] = i;
            ret->held[i / 2 + width / 2] = width * m->n + i;
        }
    ret->n_held = width;
    if (s == SW_OK)
        s = model_stiffness(m, part, &K);
    if (s == SW_OK)
        s = band_combine(alpha, &M, beta, &K, &ret->C);
    if (s == SW_OK)
        s = band_combine(a, &M, b, &ret->C, &ret->A);
    if (s == SW_OK)
        s = factor_held(ret, &ret->factor);
    band_free(&M);
    band_free(&K);
    ret->x = mem_doubles(4 * size); /* four right sides of one component each */
    ret->d = mem_doubles(size);
    return s == SW_OK && !(ret->x && ret->d) ? SW_NOMEM : s;
}

enum status inertia_new(const struct model *m, double a, double b, double c, double alpha,
                        double beta, struct inertia *ret)
{
    enum status s;

    *ret = (struct inertia){.n = m->n, .c = c, .parts = beta > 0 ? 2 : 1};
    ret->gamma = alpha * c / (a + b * alpha);
    s = part_new(m, PART_LATERAL, a, b, alpha, beta, &ret->part[0]);
    if (s == SW_OK && ret->parts == 2)
        s = part_new(m, PART_PLANE, a, b, alpha, beta, &ret->part[1]);
    if (s != SW_OK)
        inertia_free(ret);
    return s;
}

void inertia_free(struct inertia *p)
{
    for (int i = 0; i < 2; i++) {
        band_free(&p->part[i].A);
        band_free(&p->part[i].C);
        band_factor_free(&p->part[i].factor);
        free(p->part[i].x);
        free(p->part[i].d);
    }
    *p = (struct inertia){0};
}

/* One part with C of its own. */
static void solve_part(const struct inertia *s, struct inertia_part *p, const double *F,
                       const double *D, const double held[6], double *x)
{
    const struct band *A = &p->A;

    gather(p, s->n + 1, F, p->x);
    for (int i = 0; i < A->n; i++)
        p->x[i] = -p->x[i];
    gather(p, s->n + 1, D, p->d);
    band_multiply_add(&p->C, -s->c, p->d, p->x);
    for (int i = 0; i < p->n_held; i++) {
        double known = held[support_component(p, i)];
        int b = p->held[i];

        for (int j = b - A->kd; known != 0 && j <= b + A->kd; j++)
            if (j >= 0 && j < A->n)
                p->x[j] -= band_get(A, j, b) * known;
    }
    for (int i = 0; i < p->n_held; i++)
        p->x[p->held[i]] = held[support_component(p, i)];
    band_solve(&p->factor, p->x);
    scatter(p, s->n + 1, p->x, x);
}

/* Three components at once: A (x + gamma D) = -F. */
static void solve_components(const struct inertia *s, struct inertia_part *p, const double *F,
                             const double *D, const double held[6], double *x)
{
    const struct band *A = &p->A;
    int last = 6 * s->n;

    for (int k = 0; k <= s->n; k++)
        for (int slope = 0; slope < 2; slope++)
            for (int c = 0; c < 3; c++)
                p->x[4 * (2 * k + slope) + c] = -F[6 * k + 2 * c + slope];
    for (int c = 0; c < 3; c++) {
        const double known[2] = {held[c] + s->gamma * D[2 * c],
                                 held[c + 3] + s->gamma * D[last + 2 * c]};

        for (int i = 0; i < 2; i++)
            for (int j = p->held[i] - A->kd; j <= p->held[i] + A->kd; j++)
                if (j >= 0 && j < A->n)
                    p->x[4 * j + c] -= band_get(A, j, p->held[i]) * known[i];
        for (int i = 0; i < 2; i++)
            p->x[4 * p->held[i] + c] = known[i];
    }
    band_solve_four(&p->factor, p->x);
    for (int k = 0; k <= s->n; k++)
        for (int slope = 0; slope < 2; slope++)
            for (int c = 0; c < 3; c++) {
                int i = 6 * k + 2 * c + slope;

                x[i] = p->x[4 * (2 * k + slope) + c] - s->gamma * D[i];
            }
}

void inertia_solve(struct inertia *p, const double *F, const double *D, const double held[6],
                   double *x)
{
    if (p->parts == 1)
        solve_components(p, &p->part[0], F, D, held, x);
    for (int i = 0; i < p->parts && p->parts == 2; i++)
        solve_part(p, &p->part[i], F, D, held, x);
}

/* Row of A and C that belongs to a support's unknown: sum over the unknowns near it. */
static double row(const struct inertia *s, const struct inertia_part *p, int held, int component,
                  const double *x, const double *D)
{
    double sum = 0;

    for (int j = held - p->A.kd; j <= held + p->A.kd; j++) {
        int first = p->part == PART_PLANE ? 0 : 2 * component;

        if (j < 0 || j >= p->A.n)
            continue;
        {
            int i = j / p->width * 6 + first + j % p->width;

            sum += band_get(&p->A, held, j) * x[i] + s->c * band_get(&p->C, held, j) * D[i];
        }
    }
    return sum;
}

void inertia_support(const struct inertia *s, const double *F, const double *D, const double *x,
                     double ret[6])
{
    for (int i = 0; i < 6; i++) {
        int component = i % 3, side = i / 3;
        const struct inertia_part *p =
            &s->part[s->parts == 2 && component < 2 ? 1 : 0]; /* the plane's part */
        int held = p->held[p->part == PART_PLANE ? 2 * side + component : side];

        ret[i] = F[side * 6 * s->n + 2 * component] + row(s, p, held, component, x, D);
    }
}
