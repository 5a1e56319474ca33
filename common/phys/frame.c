/* Structures of curved beams: numbering, loads, residuals. */
#include "phys/frame.h"
#include "num/mem.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BLOCK (HINGED_MOST * (HINGED_MOST + 1) / 2)

double frame_factor(const struct frame *f, int stage, double t)
{
    double part = t - stage + 1;

    if (stage < 1)
        return 0;
    if (f->arc)
        return stage == f->stages ? part : 1;
    return part < 0 ? 0 : part > 1 ? 1 : part;
}

int frame_unknowns(const struct frame *f, const struct frame_work *w, int i, int *to)
{
    int n = 12, b;
    const struct frame_beam *beam = i < f->beams ? &f->beam[i] : NULL;
    int a = beam ? beam->a : f->spring[i - f->beams].a;

    b = beam ? beam->b : f->spring[i - f->beams].b;
    for (int c = 0; c < 6; c++) {
        to[c] = w->dof[6 * a + c];
        to[6 + c] = b < 0 ? -1 : w->dof[6 * b + c];
    }
    for (int end = 0; end < 2 && beam; end++)
        for (int j = 0; j < beam->hinge[end].n; j++)
            to[n++] = w->first[2 * i + end] + j;
    return n;
}

static enum status lay_pattern(const struct frame *f, struct frame_work *w)
{
    size_t blocks = (size_t)f->beams + (size_t)f->springs, n = 0, at = 0;
    struct place *place = mem_zeroed(blocks * BLOCK, sizeof *place);
    int *found;
    enum status s;

    w->at = mem_zeroed(blocks * BLOCK, sizeof *w->at);
    if (!place || !w->at) {
        free(place);
        return SW_NOMEM;
    }
    for (int i = 0; i < (int)blocks; i++) {
        int to[HINGED_MOST], m = frame_unknowns(f, w, i, to);

        for (int c = 0; c < m; c++)
            for (int r = c; r < m; r++, at++) {
                w->at[at] = to[c] >= 0 && to[r] >= 0;
                if (w->at[at])
                    place[n++] = to[r] >= to[c] ? (struct place){to[r], to[c]}
                                                : (struct place){to[c], to[r]};
            }
    }
    found = mem_zeroed(n, sizeof *found);
    s = found ? sparse_new(w->unknowns, place, n, found, &w->K) : SW_NOMEM;
    n = 0;
    for (size_t k = 0; k < at && s == SW_OK; k++)
        w->at[k] = w->at[k] ? found[n++] : -1;
    free(found);
    free(place);
    return s;
}

/* Nodes in the order given, hinges behind: CHOLMOD finds its own order. */
static void number(const struct frame *f, struct frame_work *w)
{
    for (int i = 0; i < f->n; i++)
        for (int c = 0; c < 6; c++)
            w->dof[6 * i + c] = f->node[i].held & 1 << c ? -1 : w->unknowns++;
    for (int i = 0; i < 2 * f->beams; i++) {
        w->first[i] = w->unknowns;
        w->unknowns += f->beam[i / 2].hinge[i % 2].n;
    }
}

/* Rounding moves an end by some DBL_EPSILON of the chord, and turns it by as many radians. */
static void find_scales(const struct frame *f, struct frame_work *w)
{
    for (int c = 0; c < 3; c++) {
        double low = INFINITY, high = -INFINITY;

        for (int i = 0; i < f->n; i++) {
            low = fmin(low, f->node[i].x[c]);
            high = fmax(high, f->node[i].x[c]);
        }
        w->size = hypot(w->size, high - low);
    }
    for (int i = 0; i < f->beams; i++) {
        const struct beam *b = &f->beam[i].beam;
        double force = 0, moment = 0;

        for (int k = 0; k < 3; k++) {
            force = fmax(force, b->K[7 * k] * b->bow.Lz);
            moment = fmax(moment, b->K[7 * (k + 3)]);
        }
        w->chord += b->bow.Lz / f->beams;
        w->floor_force = fmax(w->floor_force, 4 * DBL_EPSILON * force);
        w->floor_moment = fmax(w->floor_moment, 4 * DBL_EPSILON * (moment + force * b->bow.Lz));
    }
    for (int i = 0; i < f->springs; i++) {
        const struct frame_spring *p = &f->spring[i];
        double force = fmax(fmax(p->k[0], p->k[1]), p->k[2]) * w->chord;

        w->floor_force = fmax(w->floor_force, 4 * DBL_EPSILON * force);
        w->floor_moment = fmax(w->floor_moment, 4 * DBL_EPSILON * force * w->chord);
    }
}

enum status frame_work_new(const struct frame *f, struct frame_work *ret)
{
    size_t n = (size_t)f->n, m = (size_t)f->beams;
    enum status s = SW_NOMEM;

    *ret = (struct frame_work){.dof = mem_zeroed(6 * n, sizeof *ret->dof),
                               .first = mem_zeroed(2 * m, sizeof *ret->first),
                               .load = mem_doubles(6 * n),
                               .q = mem_doubles(3 * m),
                               .open = mem_doubles(6 * n),
                               .end = mem_doubles(12 * m),
                               .guess = mem_doubles(6 * m)};
    if (ret->dof && ret->first && ret->load && ret->q && ret->open && ret->end && ret->guess) {
        number(f, ret);
        find_scales(f, ret);
        ret->right = mem_doubles((size_t)ret->unknowns);
        if (ret->right)
            s = lay_pattern(f, ret);
    }
    if (s != SW_OK)
        frame_work_free(ret);
    return s;
}

void frame_work_free(struct frame_work *w)
{
    free(w->dof);
    free(w->first);
    sparse_free(&w->K);
    free(w->at);
    free(w->load);
    free(w->q);
    free(w->open);
    free(w->right);
    free(w->end);
    free(w->guess);
    *w = (struct frame_work){.dof = NULL};
}

/* A load of a beam: kept for the element, or halved to its nodes. */
static void load_beam(const struct frame *f, const struct frame_load *l, double part,
                      struct frame_work *w)
{
    const struct frame_beam *b = &f->beam[l->beam];

    for (int c = 0; c < 3; c++)
        if (f->lumped) {
            w->load[6 * b->a + c] += part * b->beam.length / 2 * l->value[c];
            w->load[6 * b->b + c] += part * b->beam.length / 2 * l->value[c];
        } else {
            w->q[3 * l->beam + c] += part * l->value[c];
        }
}

void frame_set_loads(const struct frame *f, double t, struct frame_work *w)
{
    memset(w->load, 0, 6 * (size_t)f->n * sizeof *w->load);
    memset(w->q, 0, 3 * (size_t)f->beams * sizeof *w->q);
    for (int k = 0; k < f->loads; k++) {
        const struct frame_load *l = &f->load[k];
        double part = frame_factor(f, l->stage, t);

        if (l->node < 0)
            load_beam(f, l, part, w);
        for (int c = 0; c < 6 && l->node >= 0; c++)
            w->load[6 * l->node + c] += part * l->value[c];
    }
}

double frame_residual(const struct frame *f, const struct frame_work *w, double tolerance)
{
    double most = 0, force = fmax(w->force, w->moment / w->size);
    double moment = fmax(w->moment, w->force * w->chord);

    force = fmax(fmax(force, w->floor_force / tolerance), 1e-300);
    moment = fmax(fmax(moment, w->floor_moment / tolerance), 1e-300);
    for (int i = 0; i < 6 * f->n; i++)
        if (w->dof[i] >= 0 && !(fabs(w->open[i]) / (i % 6 < 3 ? force : moment) <= most))
            most = fabs(w->open[i]) / (i % 6 < 3 ? force : moment);
    for (int i = 0; i < 2 * f->beams; i++)
        for (int j = 0; j < f->beam[i / 2].hinge[i % 2].n; j++)
            if (!(fabs(w->right[w->first[i] + j]) / moment <= most))
                most = fabs(w->right[w->first[i] + j]) / moment;
    return most;
}

enum status frame_factorize(struct frame_work *w)
{
    return sparse_factor_signed(&w->K, &w->negative);
}

int frame_node_of(const struct frame *f, const struct frame_work *w, int unknown)
{
    for (int i = 0; i < 6 * f->n; i++)
        if (w->dof[i] == unknown)
            return i / 6;
    return -1;
}
