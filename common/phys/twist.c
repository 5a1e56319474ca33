/* Moments about fixed axes in the stiffness of a frame (Sherman, Morrison, Woodbury). */
#include "phys/twist.h"
#include "num/mem.h"
#include "num/vec3.h"

#include <stdlib.h>
#include <string.h>

#define NONE 1e-12 /* of the largest moment */

/* Moment of the loads at a node that may turn. */
static double moment_at(const struct frame *f, const struct frame_work *w, int i)
{
    return (f->node[i].held & 56) == 56 ? 0 : vec3_length(w->load + 6 * i + 3);
}

/* The nodes with the largest moments, by insertion. */
static void choose(const struct frame *f, const struct frame_work *w, struct twist *t)
{
    double size[TWIST_NODES] = {0};

    for (int i = 0; i < f->n; i++) {
        double here = moment_at(f, w, i);
        int at = t->n;

        if (!(here > NONE * w->moment) || (t->n == TWIST_NODES && !(here > size[t->n - 1])))
            continue;
        at -= t->n == TWIST_NODES;
        t->n += t->n < TWIST_NODES;
        for (; at > 0 && size[at - 1] < here; at--) {
            size[at] = size[at - 1];
            t->node[at] = t->node[at - 1];
        }
        size[at] = here;
        t->node[at] = i;
    }
}

/* A gets at the spins of chosen node k what column (n unknowns) has there, through C. */
static void couple(const struct twist *t, const struct frame_work *w, const double *column, int k,
                   double ret[3])
{
    double spin[3];

    for (int c = 0; c < 3; c++) {
        int unknown = w->dof[6 * t->node[k] + 3 + c];

        spin[c] = unknown >= 0 ? column[unknown] : 0;
    }
    mat3_apply(t->C[k], spin, ret);
}

enum status twist_new(const struct frame *f, struct frame_work *w, struct twist *ret)
{
    size_t n = (size_t)w->unknowns;
    int m;
    enum status s;

    memset(ret, 0, sizeof *ret);
    choose(f, w, ret);
    m = 3 * ret->n;
    if (m == 0)
        return SW_OK;
    ret->Z = mem_doubles(n * (size_t)m);
    if (!ret->Z)
        return SW_NOMEM;
    for (int k = 0; k < ret->n; k++) {
        double M[3];

        for (int c = 0; c < 3; c++) {
            int at = 6 * ret->node[k] + 3 + c;

            M[c] = (w->load[at] + w->open[at]) / 2; /* all ends' moments */
            if (w->dof[at] >= 0)
                ret->Z[n * (size_t)(3 * k + c) + (size_t)w->dof[at]] = 1;
        }
        mat3_skew(M, ret->C[k]);
    }
    s = sparse_solve(&w->K, m, ret->Z);
    for (int j = 0; j < m && s == SW_OK; j++)
        for (int k = 0; k < ret->n; k++) {
            double c[3];

            couple(ret, w, ret->Z + n * (size_t)j, k, c);
            for (int i = 0; i < 3; i++)
                ret->A[(3 * k + i) * m + j] = (3 * k + i == j) - c[i];
        }
    if (s != SW_OK)
        twist_free(ret);
    return s;
}

void twist_free(struct twist *t)
{
    free(t->Z);
    t->Z = NULL;
}

/* A y = y by elimination with pivots; A is lost. */
static enum status eliminate(int m, double *A, double *y)
{
    for (int k = 0; k < m; k++) {
        int p = k;

        for (int i = k + 1; i < m; i++)
            if (fabs(A[i * m + k]) > fabs(A[p * m + k]))
                p = i;
        if (!(fabs(A[p * m + k]) > 0))
            return SW_INDEFINITE;
        for (int j = 0; j < m; j++) {
            double x = A[k * m + j];

            A[k * m + j] = A[p * m + j];
            A[p * m + j] = x;
        }
        double x = y[k];

        y[k] = y[p];
        y[p] = x;
        for (int i = k + 1; i < m; i++) {
            double part = A[i * m + k] / A[k * m + k];

            for (int j = k; j < m; j++)
                A[i * m + j] -= part * A[k * m + j];
            y[i] -= part * y[k];
        }
    }
    for (int k = m - 1; k >= 0; k--) {
        for (int j = k + 1; j < m; j++)
            y[k] -= A[k * m + j] * y[j];
        y[k] /= A[k * m + k];
    }
    return SW_OK;
}

/* x + Z y with (I - C Z) y = C x. */
enum status twist_solve(const struct twist *t, struct frame_work *w, double *x)
{
    double A[9 * TWIST_NODES * TWIST_NODES], y[3 * TWIST_NODES];
    int m = 3 * t->n;
    size_t n = (size_t)w->unknowns;
    enum status s = sparse_solve(&w->K, 1, x);

    if (s != SW_OK || t->n < 1)
        return s;
    memcpy(A, t->A, (size_t)(m * m) * sizeof *A);
    for (int k = 0; k < t->n; k++)
        couple(t, w, x, k, y + 3 * k);
    s = eliminate(m, A, y);
    for (int j = 0; j < m && s == SW_OK; j++)
        for (size_t i = 0; i < n; i++)
            x[i] += y[j] * t->Z[n * (size_t)j + i];
    return s;
}
