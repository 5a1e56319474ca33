/* Lowest points of regions, and the damping that lifts them. */
#include "phys/answers.h"
#include "num/mem.h"
#include "num/root.h"

#include <math.h>
#include <stdlib.h>

#define CHUNK 64
#define MOST_FACTOR 1e4
#define MOST_MOVES 100

static int same_region(const struct map_row *a, int period, const struct boundary *b)
{
    return a->period == period && a->boundary.mode == b->mode && a->boundary.order == b->order;
}

/* Takes a point of the map in: into its region if it is the lowest there so far. */
static void take(const struct map_row *row, struct map_answer *ret, int *n)
{
    for (int i = 0; i < *n; i++)
        if (same_region(&ret[i].row, row->period, &row->boundary)) {
            if (row->amplitude < ret[i].row.amplitude)
                ret[i].row = *row;
            return;
        }
    if (*n < MAP_MOST_REGIONS)
        ret[(*n)++] = (struct map_answer){*row, NAN};
}

static enum status survey(const struct map *m, const struct map_task *t, double first, double step,
                          long count, int threads, struct map_answer *ret, int *n)
{
    enum status s = SW_OK;

    for (long at = 0; at < count && s == SW_OK; at += CHUNK) {
        int here = count - at < CHUNK ? (int)(count - at) : CHUNK;
        double ratio[CHUNK];
        struct map_rows rows[CHUNK];

        for (int i = 0; i < here; i++)
            ratio[i] = first + (double)(at + i) * step;
        map_rows(m, t, ratio, here, threads, rows);
        for (int i = 0; i < here; i++) {
            if (rows[i].status != SW_OK && rows[i].status != SW_INDEFINITE)
                s = rows[i].status;
            for (int k = 0; k < rows[i].n; k++)
                take(&rows[i].row[k], ret, n);
            map_rows_free(&rows[i]);
        }
    }
    return s;
}

/* What the searches work on. */
struct search {
    struct map map; /* with its damping scaled; owns nothing */
    double alpha, beta, ground_alpha, ground_beta;
    const struct map_task *task;
    struct map_row region;
    double window;    /* ratios on both sides of the lowest point */
    double low, high; /* which ratios are looked at, at all */
    double lowest;    /* ratio of the last lowest point */
    int follow;       /* whether the window moves on where the lowest point lies at its end */
    enum status status;
};

/* Lowest boundary of the region at a ratio; INFINITY: none. */
static double lowest_at(double ratio, void *context)
{
    struct search *f = context;
    struct parametric p;
    int room = 4 * f->map.projection.s * (f->task->harmonics + 1), n = 0;
    struct boundary *found = mem_zeroed((size_t)room, sizeof *found);
    enum status s = found ? map_equations(&f->map, ratio, &p) : SW_NOMEM;
    double least = INFINITY;

    if (s == SW_OK) {
        s = bolotin_solve(&p, 2 * ratio * f->map.reference, f->region.period, f->task->harmonics,
                          INFINITY, found, room, &n);
        parametric_free(&p);
    }
    for (int i = 0; i < n; i++)
        if (same_region(&f->region, f->region.period, &found[i]) && found[i].kappa < least)
            least = found[i].kappa;
    if (s != SW_OK && s != SW_INDEFINITE)
        f->status = s;
    free(found);
    return least;
}

/* Lowest point of the region near where it was, for damping times a factor given by its logarithm,
 * less the amplitude that shall be safe. */
static double lift(double log_factor, void *context)
{
    struct search *f = context;
    double factor = exp(log_factor), least, middle = f->region.ratio, moved;
    int moves = 0;

    f->map.alpha = factor * f->alpha;
    f->map.beta = factor * f->beta;
    f->map.ground.alpha = factor * f->ground_alpha;
    f->map.ground.beta = factor * f->ground_beta;
    do {
        f->lowest = least_between(lowest_at, f, fmax(middle - f->window, f->low),
                                  fmin(middle + f->window, f->high), &least);
        moved = fabs(f->lowest - middle);
        middle = f->lowest;
    } while (f->follow && f->status == SW_OK && isfinite(least) && moved > 0.9 * f->window &&
             ++moves < MOST_MOVES);
    if (f->status != SW_OK)
        return NAN;
    return fmin(least, 1e300) - f->task->to;
}

/* The map goes from ratio low to high. */
static enum status answer(const struct map *m, const struct map_task *t, double low, double high,
                          double step, struct map_answer *ret)
{
    struct search f = {.map = *m,
                       .alpha = m->alpha,
                       .beta = m->beta,
                       .ground_alpha = m->ground.alpha,
                       .ground_beta = m->ground.beta,
                       .task = t,
                       .region = ret->row,
                       .window = step,
                       .low = low,
                       .high = high};
    double now = lift(0, &f), log_factor = 0, above = now;

    if (f.status == SW_OK && now + t->to < ret->row.amplitude) {
        ret->row.ratio = f.lowest;
        ret->row.Omega = 2 * f.lowest * m->reference;
        ret->row.amplitude = now + t->to;
    }
    if (f.status != SW_OK || !(m->alpha > 0 || m->beta > 0))
        return f.status;
    f.window = 3 * step;
    f.follow = 1; /* damping shifts the lowest point, also out of the map */
    f.low = f.window;
    f.high = INFINITY;
    while (!(above > 0) && log_factor < log(MOST_FACTOR) && f.status == SW_OK)
        above = lift(log_factor += log(2), &f);
    if (above > 0 && now <= 0)
        ret->factor = exp(root_between(lift, &f, 0, now, log_factor, above));
    return f.status;
}

static int ascending(const void *a, const void *b)
{
    double x = ((const struct map_answer *)a)->row.amplitude;
    double y = ((const struct map_answer *)b)->row.amplitude;

    return (x > y) - (x < y);
}

enum status map_answers(const struct map *m, const struct map_task *t, double first, double step,
                        long count, int threads, struct map_answer *ret, int *ret_n)
{
    enum status s, each[MAP_MOST_REGIONS];

    *ret_n = 0;
    s = survey(m, t, first, step, count, threads, ret, ret_n);
    if (s != SW_OK)
        return s;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int i = 0; i < *ret_n; i++)
        each[i] = answer(m, t, first, first + (double)(count - 1) * step, step, &ret[i]);
    for (int i = 0; i < *ret_n; i++)
        if (each[i] != SW_OK)
            s = each[i];
    qsort(ret, (size_t)*ret_n, sizeof *ret, ascending);
    return s;
}
