/* Steady linear response to moving supports. */
#include "phys/ground.h"
#include "num/mem.h"
#include "num/zband.h"

#include <stdlib.h>

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
    if (s != SW_OK)
        ground_free(ret);
    return s;
}

void ground_free(struct ground *g)
{
    partition_free(&g->M);
    partition_free(&g->K);
}

enum status ground_response(const struct ground *g, double Omega, const double complex b[6],
                            const double *R, double complex *V)
{
    double complex k = 1 + I * (Omega * g->beta), m = -Omega * Omega + I * (Omega * g->alpha);
    int n = 6 * g->model->n, held[6], i = 0;
    double complex *x = mem_zeroed((size_t)n, sizeof *x);
    enum status s;

    if (!x)
        return SW_NOMEM;
    for (int node = 0; node <= g->model->n; node++)
        for (int c = 0; c < 6; c++)
            if ((node > 0 && node < g->model->n) || c % 2 == 1)
                x[i++] = R ? R[6 * node + c] : 0;
    for (int j = 0; j < 6; j++)
        for (i = 0; i < n && b[j] != 0; i++)
            x[i] -= (k * g->K.support[i + n * j] + m * g->M.support[i + n * j]) * b[j];
    s = zband_solve(k, &g->K.free, m, &g->M.free, x);
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
