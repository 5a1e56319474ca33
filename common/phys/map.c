/* Maps of parametric resonance. */
#include "phys/map.h"
#include "num/dense.h"
#include "num/mem.h"
#include "num/root.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TOLERANCE_GRID 2e-5  /* of matrices before they are extrapolated; multipliers get 1e-6 */
#define TOLERANCE_TRACE 1e-9 /* where a crossing of 1 is looked for */
#define MARGIN 1e-9 /* log of the modulus that counts as stable: undamped it is 0 or more */

enum status map_new(const struct model *m, const struct modes *p, const int *mode, int s,
                    double ground_alpha, double ground_beta, struct map *ret)
{
    enum status status;

    *ret = (struct map){.modes = p, .mode = mode};
    status = ground_new(m, ground_alpha, ground_beta, &ret->ground);
    if (status == SW_OK)
        status = projection_new(m, p, mode, s, &ret->projection);
    if (status != SW_OK)
        map_free(ret);
    return status;
}

void map_free(struct map *m)
{
    ground_free(&m->ground);
    projection_free(&m->projection);
    free(m->R);
    m->R = NULL;
}

enum status map_equations(const struct map *m, double ratio, struct parametric *ret)
{
    double complex *V = mem_zeroed(model_unknowns(m->ground.model), sizeof *V);
    enum status s = parametric_new(m->modes, m->mode, m->projection.s, m->alpha, m->beta, ret);

    if (!V)
        s = SW_NOMEM;
    if (s == SW_OK)
        s = ground_response(&m->ground, 2 * ratio * m->reference, m->b, m->R, V);
    if (s == SW_OK)
        parametric_fill(&m->projection, m->theory, m->quadratic, V, ret);
    else
        parametric_free(ret);
    free(V);
    return s;
}

/* One more row; NULL: memory ran out. */
static struct map_row *add_row(struct map_rows *r, double ratio, double Omega, double amplitude)
{
    if (r->n == r->room) {
        int room = 2 * r->room + 16;
        struct map_row *row = mem_resize(r->row, (size_t)room, sizeof *row);

        if (!row)
            return NULL;
        r->row = row;
        r->room = room;
    }
    r->row[r->n] = (struct map_row){.ratio = ratio, .Omega = Omega, .amplitude = amplitude};
    return &r->row[r->n++];
}

static enum status boundaries(const struct parametric *p, const struct map_task *t, double ratio,
                              double Omega, struct map_rows *ret)
{
    int room = 4 * p->s * (t->harmonics + 1), n;
    struct boundary *found = mem_zeroed((size_t)room, sizeof *found);
    enum status s = found ? SW_OK : SW_NOMEM;

    for (int period = 1; period <= 2 && s == SW_OK; period++) {
        s = bolotin_solve(p, Omega, period, t->harmonics, t->to, found, room, &n);
        if (s == SW_OK && t->change)
            s = bolotin_change(p, Omega, period, t->harmonics, found, n);
        for (int i = 0; i < n && s == SW_OK; i++) {
            struct map_row *row = add_row(ret, ratio, Omega, found[i].kappa);

            if (!row)
                s = SW_NOMEM;
            else {
                row->period = period;
                row->boundary = found[i];
            }
        }
    }
    free(found);
    return s;
}

/* Logarithm of the largest modulus at an amplitude, less the margin. */
struct crossing_search {
    const struct parametric *p;
    double Omega, tolerance;
    struct floquet last;
    enum status status;
};

static double log_modulus(double kappa, void *context)
{
    struct crossing_search *c = context;

    c->status = floquet_solve(c->p, c->Omega, kappa, c->tolerance, &c->last);
    return c->status == SW_OK ? log(c->last.modulus) - MARGIN : NAN;
}

/* The amplitudes of the grid, or those between them at which the modulus goes through 1. */
static enum status multipliers(const struct parametric *p, const struct map_task *t, double ratio,
                               double Omega, struct map_rows *ret)
{
    struct crossing_search c = {.p = p,
                                .Omega = Omega,
                                .tolerance = t->trace ? TOLERANCE_TRACE : TOLERANCE_GRID};
    long count = lround(floor((t->to - t->from) / t->step * (1 + 1e-12)));
    double before = NAN, last = NAN;

    for (long i = 0; i <= count; i++) {
        double kappa = t->from + (double)i * t->step, now = log_modulus(kappa, &c), at = kappa;
        struct map_row *row;

        if (c.status != SW_OK)
            return c.status;
        if (t->trace) {
            int crossed = i > 0 && (now > 0) != (before > 0);

            if (crossed)
                at = root_between(log_modulus, &c, last, before, kappa, now);
            if (c.status != SW_OK)
                return c.status;
            before = now;
            last = kappa;
            if (!crossed)
                continue;
        }
        row = add_row(ret, ratio, Omega, at);
        if (!row)
            return SW_NOMEM;
        row->floquet = c.last;
    }
    return SW_OK;
}

static void one_frequency(const struct map *m, const struct map_task *t, double ratio,
                          struct map_rows *ret)
{
    double Omega = 2 * ratio * m->reference;
    struct parametric p;

    *ret = (struct map_rows){.status = map_equations(m, ratio, &p)};
    if (ret->status != SW_OK)
        return;
    ret->status =
        t->floquet ? multipliers(&p, t, ratio, Omega, ret) : boundaries(&p, t, ratio, Omega, ret);
    parametric_free(&p);
}

void map_rows(const struct map *m, const struct map_task *t, const double *ratio, int count,
              int threads, struct map_rows *rows)
{
    dense_threads(1); /* each of ours runs BLAS alone */
    (void)threads;    /* without OpenMP */
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int i = 0; i < count; i++)
        one_frequency(m, t, ratio[i], &rows[i]);
}

void map_rows_free(struct map_rows *r)
{
    free(r->row);
    *r = (struct map_rows){.row = NULL};
}
