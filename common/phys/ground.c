/* Steady linear response to moving supports. */
#include "phys/ground.h"
#include "num/mem.h"
#include "num/zband.h"

#include <stdlib.h>

/* Rows and columns keep[] of A in a band of their own half bandwidth. */
static enum status take_part(const struct band *A, const int *keep, int n, int kd, struct band *ret)
{
    if (band_new(n, kd, ret) != SW_OK)
        return SW_NOMEM;
    for (int j = 0; j < n; j++)
        for (int i = j; i < n && i - j <= kd; i++)
            *band_at(ret, i, j) = band_get(A, keep[i], keep[j]);
    return SW_OK;
}

/* The plane (part 0) and the lateral direction (1) apart. */
static enum status split(struct ground *g, int part)
{
    int width = part == 0 ? 4 : 2, n = width * g->model->n, at = 0, count = 0;
    enum status s;

    g->keep[part] = mem_zeroed((size_t)n, sizeof *g->keep[part]);
    if (!g->keep[part])
        return SW_NOMEM;
    for (int node = 0; node <= g->model->n; node++)
        for (int c = 0; c < 6; c++)
            if ((node > 0 && node < g->model->n) || c % 2 == 1) {
                if ((c >= 4) == (part == 1))
                    g->keep[part][count++] = at;
                at++;
            }
    s = take_part(&g->K.free, g->keep[part], n, 2 * width - 1, &g->part_K[part]);
    return s == SW_OK ? take_part(&g->M.free, g->keep[part], n, 2 * width - 1, &g->part_M[part])
                      : s;
}

enum status ground_new(const struct model *m, double alpha, double beta, struct ground *ret)
{
    struct band M = {0}, K = {0};
    enum status s;

    *ret = (struct ground){.model = m, .alpha = alpha, .beta = beta};
    s = model_mass(m, PART_ALL, &M);
    if (s == SW_OK)
        s = model_stiffness(m, PART_ALL, &K);
    if (s == SW_OK)
        s = model_partition(m, &M, &ret->M);
    if (s == SW_OK)
        s = model_partition(m, &K, &ret->K);
    band_free(&M);
    band_free(&K);
    for (int part = 0; part < 2 && s == SW_OK; part++)
        s = split(ret, part);
    if (s != SW_OK)
        ground_free(ret);
    return s;
}

void ground_free(struct ground *g)
{
    partition_free(&g->M);
    partition_free(&g->K);
    for (int part = 0; part < 2; part++) {
        band_free(&g->part_M[part]);
        band_free(&g->part_K[part]);
        free(g->keep[part]);
        g->keep[part] = NULL;
    }
}

/* Solve the part of x; nothing to do where it is at rest. */
static enum status solve_part(const struct ground *g, int part, double complex k, double complex m,
                              double complex *x, double complex *work)
{
    const int *keep = g->keep[part];
    int n = g->part_K[part].n, moves = 0;
    enum status s;

    for (int i = 0; i < n; i++) {
        work[i] = x[keep[i]];
        moves |= work[i] != 0;
    }
    if (!moves)
        return SW_OK;
    s = zband_solve(k, &g->part_K[part], m, &g->part_M[part], work);
    for (int i = 0; i < n; i++)
        x[keep[i]] = work[i];
    return s;
}

/* x^H K x of the real or imaginary part of x. */
static double stiffness_of(const struct band *K, const double complex *x, int imaginary,
                           double *work)
{
    double *part = work, *Kx = work + K->n, sum = 0;

    for (int i = 0; i < K->n; i++) {
        part[i] = imaginary ? cimag(x[i]) : creal(x[i]);
        Kx[i] = 0;
    }
    band_multiply_add(K, 1, part, Kx);
    for (int i = 0; i < K->n; i++)
        sum += part[i] * Kx[i];
    return sum;
}

/* Whether x, the undamped response to the right side r, is one at a resonance: of its energy 2 U =
 * x^H K x all but 1e-12 swings by itself, and x^H r is what is left. */
static int is_resonance(const struct ground *g, const double complex *x, const double complex *r,
                        double *work)
{
    const struct band *K = &g->K.free;
    double energy = stiffness_of(K, x, 0, work) + stiffness_of(K, x, 1, work);
    double complex fed = 0;

    for (int i = 0; i < K->n; i++)
        fed += conj(x[i]) * r[i];
    return energy > 0 && !(cabs(fed) > 1e-12 * energy);
}

enum status ground_response(const struct ground *g, double Omega, const double complex b[6],
                            const double *R, double complex *V)
{
    double complex k = 1 + I * (Omega * g->beta), m = -Omega * Omega + I * (Omega * g->alpha);
    int n = 6 * g->model->n, held[6], i = 0;
    double complex *x = mem_zeroed(3 * (size_t)n, sizeof *x), *r;
    enum status s;

    if (!x)
        return SW_NOMEM;
    r = x + 2 * n;
    for (int node = 0; node <= g->model->n; node++)
        for (int c = 0; c < 6; c++)
            if ((node > 0 && node < g->model->n) || c % 2 == 1)
                x[i++] = R ? R[6 * node + c] : 0;
    for (int j = 0; j < 6; j++)
        for (i = 0; i < n && b[j] != 0; i++)
            x[i] -= (k * g->K.support[i + n * j] + m * g->M.support[i + n * j]) * b[j];
    for (i = 0; i < n; i++)
        r[i] = x[i];
    s = solve_part(g, 0, k, m, x, x + n);
    if (s == SW_OK)
        s = solve_part(g, 1, k, m, x, x + n);
    if (s == SW_OK && g->alpha == 0 && g->beta == 0 && is_resonance(g, x, r, (double *)(x + n)))
        s = SW_INDEFINITE;
    i = 0;
    for (int node = 0; node <= g->model->n; node++)
        for (int c = 0; c < 6; c++)
            if ((node > 0 && node < g->model->n) || c % 2 == 1)
                V[6 * node + c] = x[i++];
    model_prescribed(g->model, held);
    for (int j = 0; j < 6; j++)
        V[held[j]] = b[j];
    free(x);
    return s;
}
