/* Nonlinear static equilibrium of the model for moved supports. */
#include "num/mem.h"
#include "phys/model.h"

#include <math.h>
#include <stdlib.h>

#define MAX_STEPS 60

/*
 * First guess: nodes and slopes from the exact static line between the moved supports, which hangs
 * in the vertical plane through them, minus those of the model's own line.
 */
static enum status guess(const struct model *m, const double b[6], double *V)
{
    struct cable moved = m->line.cable;
    double across = b[5] - b[2], along = moved.span + b[3] - b[0], cosine, sine;
    struct line line;
    enum status s;

    moved.span = hypot(along, across);
    moved.drop += b[4] - b[1];
    cosine = along / moved.span;
    sine = across / moved.span;
    s = line_solve(&moved, &line);
    for (int k = 0; s == SW_OK && k <= m->n; k++) {
        double theta = m->line.cable.L0 * ((double)k / m->n), *v = V + 6 * (size_t)k;
        struct line_point p, p0;
        struct material d, d0;

        line_at(&line, theta, &p);
        line_at(&m->line, theta, &p0);
        material_at(&line, LAW_HOOKE, theta, &d);
        material_at(&m->line, LAW_HOOKE, theta, &d0);
        v[0] = b[0] + cosine * p.x1 - p0.x1;
        v[1] = cosine * d.x1 - d0.x1;
        v[2] = b[1] + p.x2 - p0.x2;
        v[3] = d.x2 - d0.x2;
        v[4] = b[2] + sine * p.x1;
        v[5] = sine * d.x1;
    }
    return s;
}

/* dV = -K_t^{-1} F for the free unknowns; F is overwritten by it. */
static enum status newton_step(const struct model *m, int terms, const int *keep, double *V,
                               double *F, double *small)
{
    int n_free = 6 * m->n;
    struct band K = {0}, K_free = {0};
    struct band_factor factor = {0};
    enum status s = model_tangent(m, terms, V, &K);

    if (s == SW_OK)
        s = band_restrict(&K, keep, n_free, &K_free);
    if (s == SW_OK)
        s = band_cholesky(&K_free, &factor);
    if (s == SW_OK) {
        for (int i = 0; i < n_free; i++)
            small[i] = F[keep[i]];
        band_solve(&factor, small);
        for (int i = 0; i < n_free; i++)
            V[keep[i]] -= small[i];
    }
    band_free(&K);
    band_free(&K_free);
    band_factor_free(&factor);
    return s;
}

static double free_norm(const int *keep, int n_free, const double *F)
{
    double most = 0;

    for (int i = 0; i < n_free; i++) /* slopes' entries are force times length: still comparable */
        if (!(fabs(F[keep[i]]) <= most))
            most = fabs(F[keep[i]]);
    return most;
}

static enum status iterate(const struct model *m, int terms, double *V, double *F, double *small,
                           const int *keep)
{
    double scale = hypot(m->line.H, fmax(fabs(m->line.V), fabs(m->line.W - m->line.V)));
    double limit = 1e-10 * scale * fmax(1, m->h);

    for (int step = 0; step <= MAX_STEPS; step++) {
        enum status s;

        model_force(m, terms, V, F, NULL);
        if (free_norm(keep, 6 * m->n, F) <= limit)
            return SW_OK;
        s = newton_step(m, terms, keep, V, F, small);
        if (s != SW_OK)
            return s;
    }
    return SW_NOCONV;
}

enum status model_equilibrium(const struct model *m, int terms, const double b[6], double *V)
{
    size_t n_all = 6 * ((size_t)m->n + 1);
    double *F = mem_doubles(2 * n_all);
    int *keep = mem_zeroed(n_all, sizeof *keep), held[6];
    enum status s = F && keep ? SW_OK : SW_NOMEM;

    for (size_t i = 0; i < n_all; i++)
        V[i] = 0;
    if (s == SW_OK && terms > 0)
        s = guess(m, b, V);
    if (s == SW_OK) {
        model_free_unknowns(m, PART_ALL, keep);
        model_prescribed(m, held);
        for (int i = 0; i < 6; i++)
            V[held[i]] = b[i];
        s = iterate(m, terms, V, F, F + n_all, keep);
    }
    free(F);
    free(keep);
    return s;
}
