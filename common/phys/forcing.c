/* Forces from outside. */
#include "phys/forcing.h"

#include <math.h>

int forcing_any(const struct forcing *f)
{
    return f->n > 0 || f->wind.cd > 0;
}

/* Value of one force at t, in the axes of the line's plane. */
static void value_at(const struct model *m, const struct force *f, double t, double ret[3])
{
    double space[3] = {f->value[0], f->value[1], f->value[2]};
    double phase = f->omega * t, omega, rate;

    if (f->record)
        series_at(f->record, t, space, NULL, NULL);
    if (f->sweep)
        sweep_at(f->sweep, t, &phase, &omega, &rate);
    for (int c = 0; c < 3 && !isnan(f->omega); c++)
        space[c] *= cos(phase + f->phase);
    axes_to_plane(&m->axes, space, ret);
}

/* A force p at a point: by the Hermite functions of its element. */
static void subtract_point(const struct model *m, double position, const double p[3], double *F)
{
    double f[4], f1[4], at = position * m->n;
    int k = at < m->n ? (int)at : m->n - 1;
    double *node = F + 6 * (size_t)k;

    hermite(m->h, at - k, f, f1);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 4; i++)
            node[i / 2 * 6 + 2 * c + i % 2] -= f[i] * p[c];
}

/* A force p per length: integrals of the Hermite functions. */
static void subtract_uniform(const struct model *m, const double p[3], double *F)
{
    double h = m->h;

    for (int k = 0; k <= m->n; k++)
        for (int c = 0; c < 3; c++) {
            double *node = F + 6 * (size_t)k + 2 * c;
            int ends = (k > 0) + (k < m->n); /* elements that meet here */

            node[0] -= ends * h / 2 * p[c];
            node[1] -= ((k < m->n) - (k > 0)) * h * h / 12 * p[c];
        }
}

/* Drag per unstressed length at a Gauss point: tangent t of the moving cable, not normalized, and
 * wind against it u. */
static void drag(const struct wind *w, const double t[3], const double u[3], double ret[3])
{
    double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    double along = (u[0] * t[0] + u[1] * t[1] + u[2] * t[2]) / square, across[3], size = 0;

    for (int c = 0; c < 3; c++) {
        across[c] = u[c] - along * t[c];
        size += across[c] * across[c];
    }
    for (int c = 0; c < 3; c++)
        ret[c] = w->density / 2 * w->cd * w->diameter * sqrt(square * size) * across[c];
}

static void subtract_drag(const struct model *m, const struct wind *wind, const double *V,
                          const double *W, double *F)
{
    double speed[3];

    axes_to_plane(&m->axes, wind->speed, speed);
    for (int point = 0; point < GAUSS * m->n; point++) {
        const struct material *at = &m->material[point];
        size_t first = 6 * (size_t)(point / GAUSS);
        double f[4], f1[4], t[3] = {at->x1, at->x2, 0}, u[3], p[3];

        hermite(m->h, gauss_at[point % GAUSS], f, f1);
        for (int c = 0; c < 3; c++) {
            u[c] = speed[c];
            for (int i = 0; i < 4; i++) {
                size_t j = first + (size_t)(i / 2 * 6 + 2 * c + i % 2);

                t[c] += f1[i] * V[j];
                u[c] -= W ? f[i] * W[j] : 0;
            }
        }
        drag(wind, t, u, p);
        for (int c = 0; c < 3; c++)
            for (int i = 0; i < 4; i++)
                F[first + (size_t)(i / 2 * 6 + 2 * c + i % 2)] -=
                    gauss_weight[point % GAUSS] * m->h * f[i] * p[c];
    }
}

void forcing_subtract(const struct model *m, const struct forcing *f, double t, const double *V,
                      const double *W, double *F)
{
    for (int i = 0; i < f->n; i++) {
        double p[3];

        value_at(m, &f->force[i], t, p);
        if (isnan(f->force[i].position))
            subtract_uniform(m, p, F);
        else
            subtract_point(m, f->force[i].position, p, F);
    }
    if (f->wind.cd > 0)
        subtract_drag(m, &f->wind, V, W, F);
}
