/* Finite element model of one cable: assembly, forces, probes. */
#include "phys/model.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum status model_new(const struct cable *c, enum law law, int n, struct model *ret)
{
    enum status s = line_solve(c, &ret->line);
    double f[4];

    ret->material = NULL;
    if (s != SW_OK)
        return s;
    if (n < 1)
        return SW_ADMISSIBLE;
    ret->axes = (struct axes){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    ret->law = law;
    ret->n = n;
    ret->h = c->L0 / n;
    ret->material = mem_zeroed((size_t)n * GAUSS, sizeof *ret->material);
    if (!ret->material)
        return SW_NOMEM;
    for (int q = 0; q < GAUSS; q++)
        hermite(ret->h, gauss_at[q], f, ret->slope[q]);
    for (int point = 0; point < n * GAUSS; point++)
        material_at(&ret->line, law, model_gauss_theta(ret, point), &ret->material[point]);
    return SW_OK;
}

void model_free(struct model *m)
{
    free(m->material);
    m->material = NULL;
}

double *model_vector(const struct model *m)
{
    return mem_doubles(model_unknowns(m));
}

struct element model_element(const struct model *m, int k)
{
    struct element e = {.h = m->h, .first = GAUSS * k, .m = &m->material[GAUSS * k]};

    for (int q = 0; q < GAUSS; q++)
        for (int i = 0; i < 4; i++)
            e.slope[q][i] = m->slope[q][i];
    return e;
}

/* Unknown i of a part's element matrix (2 width of them) as one of the 12 of the element. */
static int of_twelve(enum part part, int i)
{
    int width = part_width(part);

    return i / width * 6 + part_first(part) + i % width;
}

/* Add the part of the 12x12 matrix E of element k to A. */
static void add(const double E[144], enum part part, int k, struct band *A)
{
    int width = part_width(part), m = 2 * width;
    double block[144];

    for (int j = 0; j < m; j++)
        for (int i = 0; i < m; i++)
            block[i + m * j] = E[of_twelve(part, i) + 12 * of_twelve(part, j)];
    band_add_block(A, width * k, m, block);
}

static enum status new_matrix(const struct model *m, enum part part, struct band *ret)
{
    return band_new(part_width(part) * (m->n + 1), 2 * part_width(part) - 1, ret);
}

enum status model_mass(const struct model *m, enum part part, struct band *ret)
{
    double one[16], E[144];

    if (new_matrix(m, part, ret) != SW_OK)
        return SW_NOMEM;
    element_mass(m->line.cable.mu, m->h, one);
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 12; i++) {
            int same = i % 6 / 2 == j % 6 / 2;

            E[i + 12 * j] = same ? one[i / 6 * 2 + i % 2 + 4 * (j / 6 * 2 + j % 2)] : 0;
        }
    for (int k = 0; k < m->n; k++)
        add(E, part, k, ret);
    return SW_OK;
}

static enum status assemble(const struct model *m, enum part part, int terms, int definite,
                            const double *V, struct band *ret)
{
    static const double rest[12];

    if (new_matrix(m, part, ret) != SW_OK)
        return SW_NOMEM;
    for (int k = 0; k < m->n; k++) {
        struct element e = model_element(m, k);
        double E[144];

        element_tangent(&e, terms, definite, V ? V + 6 * (size_t)k : rest, E);
        add(E, part, k, ret);
    }
    return SW_OK;
}

enum status model_stiffness(const struct model *m, enum part part, struct band *ret)
{
    return assemble(m, part, 0, 0, NULL, ret);
}

enum status model_tangent(const struct model *m, int terms, int definite, const double *V,
                          struct band *ret)
{
    return assemble(m, PART_ALL, terms, definite, V, ret);
}

void model_free_unknowns(const struct model *m, enum part part, int *ret)
{
    int width = part_width(part), last = width * m->n;

    for (int i = 0; i < width * (m->n + 1); i++)
        if ((i >= width && i < last) || i % 2 == 1)
            *ret++ = i;
}

void model_prescribed(const struct model *m, int ret[6])
{
    for (int c = 0; c < 3; c++) {
        ret[c] = 2 * c;
        ret[c + 3] = 6 * m->n + 2 * c;
    }
}

enum status model_partition(const struct model *m, const struct band *all, struct partition *ret)
{
    int n = 6 * m->n, held[6], *keep = mem_zeroed((size_t)n, sizeof *keep);
    enum status s = SW_NOMEM;

    *ret = (struct partition){.support = mem_doubles(6 * (size_t)n)};
    if (keep && ret->support) {
        model_free_unknowns(m, PART_ALL, keep);
        model_prescribed(m, held);
        for (int j = 0; j < 6; j++) {
            for (int i = 0; i < n; i++)
                ret->support[(size_t)i + (size_t)n * (size_t)j] = band_get(all, keep[i], held[j]);
            for (int i = 0; i < 6; i++)
                ret->reaction[i + 6 * j] = band_get(all, held[i], held[j]);
        }
        s = band_restrict(all, keep, n, &ret->free);
    }
    free(keep);
    if (s != SW_OK)
        partition_free(ret);
    return s;
}

void partition_free(struct partition *p)
{
    band_free(&p->free);
    free(p->support);
    p->support = NULL;
}

void model_force(const struct model *m, int terms, const double *V, double *F,
                 struct strain_watch *watch)
{
    struct element e = model_element(m, 0);

    if (watch)
        *watch = (struct strain_watch){.least_force = INFINITY, .most_stiffened = -INFINITY};
    for (size_t i = 0; i < model_unknowns(m); i++)
        F[i] = 0;
    for (int k = 0; k < m->n; k++) {
        e.first = GAUSS * k;
        e.m = &m->material[e.first];
        element_force(&e, terms, V + 6 * (size_t)k, F + 6 * (size_t)k, watch);
    }
}

double model_quotient(const struct model *m, const double *V)
{
    double mass[16], strain = 0, kinetic = 0;

    element_mass(m->line.cable.mu, m->h, mass);
    for (int k = 0; k < m->n; k++) {
        struct element e = model_element(m, k);
        const double *v = V + 6 * (size_t)k;

        strain += element_strain_energy(&e, v);
        kinetic += element_product(mass, v, v);
    }
    return strain / kinetic;
}

double model_gauss_theta(const struct model *m, int point)
{
    return m->h * (point / GAUSS + gauss_at[point % GAUSS]);
}

/* Element of theta = fraction L0 and the Hermite functions there. */
static int find_place(const struct model *m, double fraction, double f[4], double f1[4])
{
    double at = fraction * m->n;
    int k = at < m->n ? (int)at : m->n - 1;

    hermite(m->h, at - k, f, f1);
    return k;
}

/* Displacement u (axes of the plane) and its slope w at theta = fraction L0. */
static void interpolate(const struct model *m, double fraction, const double *V, double u[3],
                        double w[3])
{
    double f[4], f1[4];
    const double *node = V + 6 * (size_t)find_place(m, fraction, f, f1);

    for (int c = 0; c < 3; c++) {
        u[c] = w[c] = 0;
        for (int i = 0; i < 4; i++) {
            double unknown = node[i / 2 * 6 + 2 * c + i % 2];

            u[c] += f[i] * unknown;
            w[c] += f1[i] * unknown;
        }
    }
}

void model_probe(const struct model *m, double fraction, const double *V, double v[3],
                 double *tension)
{
    double u[3], w[3], gamma;
    struct material here;

    interpolate(m, fraction, V, u, w);
    axes_to_space(&m->axes, u, v);
    if (!tension)
        return;
    material_at(&m->line, m->law, fraction * m->line.cable.L0, &here);
    gamma = here.x1 * w[0] + here.x2 * w[1] + (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / 2;
    *tension = material_tension(&here, gamma);
}

void model_probe_small(const struct model *m, double fraction, const double *V, double v[3],
                       double *change)
{
    double u[3], w[3];
    struct material here;

    interpolate(m, fraction, V, u, w);
    axes_to_space(&m->axes, u, v);
    material_at(&m->line, m->law, fraction * m->line.cable.L0, &here);
    *change = material_tension_rate(&here) * (here.x1 * w[0] + here.x2 * w[1]);
}

void model_point_load(const struct model *m, double fraction, const double direction[3], double *b)
{
    double f[4], f1[4];
    double *node = b + 6 * (size_t)find_place(m, fraction, f, f1);

    memset(b, 0, sizeof *b * model_unknowns(m));
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 4; i++)
            node[i / 2 * 6 + 2 * c + i % 2] = f[i] * direction[c];
}

double model_omega_max(const struct model *m)
{
    double most = 0;

    for (int i = 0; i < GAUSS * m->n; i++) {
        const struct material *p = &m->material[i];
        double stiffness = p->EA * p->stretch * p->stretch + p->T;

        if (stiffness > most)
            most = stiffness;
    }
    return sqrt(42 * most / m->line.cable.mu) / m->h;
}
