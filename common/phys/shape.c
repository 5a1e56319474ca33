/* Kind and participation of modes, from element products. */
#include "phys/shape.h"

#include <math.h>

/* Node k of the mirror image of V: displacements along the chord and all slopes across it change
 * their sign, as the place of node n - k is taken. */
static void mirrored_node(const struct model *m, const double t[2], const double *V, int k,
                          double ret[6])
{
    const double *from = V + 6 * (size_t)(m->n - k);

    for (int s = 0; s < 2; s++) {
        double sign = s == 0 ? 1 : -1, along = from[s] * t[0] + from[2 + s] * t[1];

        ret[s] = sign * (from[s] - 2 * along * t[0]);
        ret[2 + s] = sign * (from[2 + s] - 2 * along * t[1]);
        ret[4 + s] = sign * from[4 + s];
    }
}

/* Integral over element k of mu times the square of the velocity along the cable, for V as
 * velocity. */
static double axial_energy(const struct model *m, int k, const double *v)
{
    double sum = 0;

    for (int q = 0; q < GAUSS; q++) {
        const struct material *at = &m->material[GAUSS * k + q];
        double f[4], f1[4], along = 0, size = hypot(at->x1, at->x2);

        hermite(m->h, gauss_at[q], f, f1);
        for (int i = 0; i < 4; i++) {
            const double *unknown = v + i / 2 * 6 + i % 2;

            along += f[i] * (unknown[0] * at->x1 + unknown[2] * at->x2) / size;
        }
        sum += gauss_weight[q] * along * along;
    }
    return sum * m->h * m->line.cable.mu;
}

void shape_character(const struct model *m, const double *V, struct character *ret)
{
    const struct cable *c = &m->line.cable;
    const double t[2] = {c->span / line_chord(c), c->drop / line_chord(c)};
    double mass[16], all = 0, mirror = 0, axial = 0;

    element_mass(c->mu, m->h, mass);
    for (int k = 0; k < m->n; k++) {
        const double *v = V + 6 * (size_t)k;
        double image[12];

        mirrored_node(m, t, V, k, image);
        mirrored_node(m, t, V, k + 1, image + 6);
        all += element_product(mass, v, v);
        mirror += element_product(mass, v, image);
        axial += axial_energy(m, k, v);
    }
    ret->symmetry = fmax(-1, fmin(1, mirror / all));
    ret->axial = axial / all;
    ret->kind = ret->axial > 0.5     ? KIND_AXIAL
                : ret->symmetry >= 0 ? KIND_SYMMETRIC
                                     : KIND_ANTISYMMETRIC;
}

/* V^T (M_ub - K_ub/omega^2) for the support at node 0 or n, unknowns 2 c of its element's end. */
static void at_support(const struct model *m, const double *V, double omega, int right,
                       double ret[3])
{
    static const double rest[12];
    struct element e = model_element(m, right ? m->n - 1 : 0);
    const double *v = V + (right ? 6 * (size_t)(m->n - 1) : 0);
    double mass[16], K[144], plane[3];

    element_mass(m->line.cable.mu, m->h, mass);
    element_tangent(&e, 0, 0, rest, K);
    for (int c = 0; c < 3; c++) {
        double unit[12] = {0}, stiff = 0;

        unit[6 * right + 2 * c] = 1;
        for (int i = 0; i < 12; i++)
            stiff += v[i] * K[i + 12 * (6 * right + 2 * c)];
        plane[c] = element_product(mass, v, unit) - stiff / (omega * omega);
    }
    axes_to_space(&m->axes, plane, ret);
}

void shape_participation(const struct model *m, const double *V, double omega, double ret[6])
{
    at_support(m, V, omega, 0, ret);
    at_support(m, V, omega, 1, ret + 3);
}
