/* Linear theory of frames. */
#include "num/mem.h"
#include "num/vec3.h"
#include "phys/follow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BALANCE 1e-4 /* of the largest force: what is left of a hundred thousand elements */

/* Work arrays. */
struct parts {
    double *move; /* (n, 6) of all nodes */
    double *open; /* (n, 6) at held nodes */
    double *end;  /* (beams, 12) */
    double *dx;   /* (unknowns) */
};

static void parts_free(struct parts *p)
{
    free(p->move);
    free(p->open);
    free(p->end);
    free(p->dx);
}

static enum status parts_new(const struct frame *f, const struct frame_work *w, struct parts *p)
{
    size_t n = 6 * (size_t)f->n, m = 12 * (size_t)f->beams;

    *p = (struct parts){mem_doubles(n), mem_doubles(n), mem_doubles(m),
                        mem_doubles((size_t)w->unknowns)};
    return p->move && p->open && p->end && p->dx ? SW_OK : SW_NOMEM;
}

/* Held ends under the loads first; then the stiffness without loads, and what is held moves. */
static enum status solve(const struct frame *f, struct frame_state *s, struct frame_work *w,
                         struct parts *p)
{
    enum status status;

    frame_set_loads(f, f->stages, w);
    frame_evaluate(f, s, FRAME_STILL, w);
    memcpy(p->dx, w->right, (size_t)w->unknowns * sizeof *p->dx);
    memcpy(p->open, w->open, 6 * (size_t)f->n * sizeof *p->open);
    memcpy(p->end, w->end, 12 * (size_t)f->beams * sizeof *p->end);
    memset(w->q, 0, 3 * (size_t)f->beams * sizeof *w->q);
    memset(w->load, 0, 6 * (size_t)f->n * sizeof *w->load);
    for (int i = 0; i < 6 * f->n; i++)
        p->move[i] = w->dof[i] < 0 ? f->node[i / 6].given[i % 6] : 0;
    frame_evaluate(f, s, (struct frame_moves){p->move, NULL}, w);
    for (int i = 0; i < w->unknowns; i++)
        p->dx[i] += w->right[i];
    status = frame_factorize(w);
    return status == SW_OK ? sparse_solve(&w->K, 1, p->dx) : status;
}

/* Whether free nodes are in balance: where nothing holds, displacements are rounding blown up. */
static int is_solved(const struct frame *f, const struct frame_work *w, const struct parts *p)
{
    double most = 0, scale = 0;

    for (int i = 0; i < 6 * f->n; i++) {
        double open = w->open[i] + p->open[i];

        scale = fmax(scale, fabs(p->open[i]));
        most = w->dof[i] < 0 ? most : fmax(most, fabs(open));
        if (w->dof[i] < 0)
            scale = fmax(scale, fabs(open)); /* of moved supports */
    }
    return most <= BALANCE * scale;
}

enum status follow_linear(const struct frame *f, struct frame_state *s, struct frame_work *w,
                          int *failed_node)
{
    struct parts p;
    enum status status = parts_new(f, w, &p);

    *failed_node = -1;
    if (status == SW_OK)
        status = solve(f, s, w, &p);
    if (status == SW_INDEFINITE)
        *failed_node = frame_node_of(f, w, w->K.failed);
    if (status == SW_OK) {
        for (int i = 0; i < 6 * f->n; i++)
            if (w->dof[i] >= 0)
                p.move[i] = p.dx[w->dof[i]];
        frame_evaluate(f, s, (struct frame_moves){p.move, p.dx}, w);
        if (!is_solved(f, w, &p)) {
            *failed_node = frame_node_of(f, w, w->K.weakest);
            status = SW_INDEFINITE;
        }
        for (int i = 0; i < 6 * f->n; i++)
            w->open[i] += p.open[i];
        for (int i = 0; i < 12 * f->beams; i++)
            w->end[i] += p.end[i];
        for (int i = 0; i < 6 * f->n; i++)
            (i % 6 < 3 ? s->x : s->turn)[3 * (i / 6) + i % 3] += p.move[i];
        s->t = f->stages;
        frame_set_loads(f, f->stages, w);
        frame_measure(f, w);
    }
    parts_free(&p);
    return status;
}
