/* The document's iteration for large deformation. */
#include "phys/updated.h"
#include "num/mem.h"
#include "num/pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One geometry as a frame that is natural there. */
struct geometry {
    struct frame f;
    struct frame_state s;
};

struct walk {
    const struct frame *f;
    const struct follow_options *o;
    struct frame_work *w[2]; /* of the last geometry, factored; of a tentative one */
    struct frame_work tentative;
    struct geometry at;
    struct frame_state *s, trial;
    double *v;                  /* K0^-1 F (unknowns) */
    double *dv, *before, *full; /* (unknowns) twice, (n, 6) */
};

const char *updated_refused(const struct frame *f)
{
    if (f->springs > 0)
        return "springs";
    if (f->stages > 1)
        return "stages";
    for (int i = 0; i < f->beams; i++)
        if (f->beam[i].hinge[0].n + f->beam[i].hinge[1].n > 0)
            return "hinges";
    for (int i = 0; i < 6 * f->n; i++)
        if (f->node[i / 6].given[i % 6] != 0)
            return "prescribed displacements";
    return NULL;
}

static enum status walk_new(struct walk *k)
{
    size_t m = (size_t)k->w[0]->unknowns;
    struct geometry *g = &k->at;
    enum status s;

    g->f = *k->f;
    g->f.node = mem_copy(k->f->node, (size_t)k->f->n * sizeof *k->f->node);
    g->f.beam = mem_copy(k->f->beam, (size_t)k->f->beams * sizeof *k->f->beam);
    k->v = mem_doubles(m);
    k->dv = mem_doubles(m);
    k->before = mem_doubles(m);
    k->full = mem_doubles(6 * (size_t)k->f->n);
    if (!g->f.node || !g->f.beam || !k->v || !k->dv || !k->before || !k->full)
        return SW_NOMEM;
    s = frame_state_new(k->f, &g->s);
    if (s == SW_OK)
        s = frame_state_new(k->f, &k->trial);
    if (s == SW_OK)
        s = frame_work_new(k->f, &k->tentative);
    k->w[1] = &k->tentative;
    return s;
}

static void walk_free(struct walk *k)
{
    free(k->at.f.node);
    free(k->at.f.beam);
    frame_state_free(&k->at.s);
    frame_state_free(&k->trial);
    frame_work_free(&k->tentative);
    free(k->v);
    free(k->dv);
    free(k->before);
    free(k->full);
}

/* New nodes and end angles (39)-(42), by the rotations themselves.  SW_NOCONV: an end angle has
 * reached a right angle. */
static enum status update(struct walk *k, const struct frame_state *s)
{
    struct geometry *g = &k->at;

    for (int i = 0; i < k->f->n; i++) {
        memcpy(g->f.node[i].x, s->x + 3 * i, sizeof g->f.node[i].x);
        memcpy(g->s.x + 3 * i, s->x + 3 * i, sizeof g->f.node[i].x);
    }
    for (int i = 0; i < k->f->beams; i++) {
        const struct frame_beam *natural = &k->f->beam[i];
        struct frame_beam *b = &g->f.beam[i];
        struct bow bow;

        frame_ends(k->f, s, i, b->A[0], b->A[1]);
        if (!(bow_between(s->x + 3 * b->a, s->x + 3 * b->b, b->A[0], b->A[1],
                          natural->beam.bow.psi[1] - natural->beam.bow.psi[0],
                          natural->beam.bow.bulge, &bow) < PI / 2) ||
            beam_new(&bow, b->section, &b->beam) != SW_OK)
            return SW_NOCONV;
    }
    return SW_OK;
}

/* K of the present geometry into w; ret (unknowns) = F(to) - F(from) on it. */
static void difference(struct walk *k, struct frame_work *w, double from, double to, double *ret)
{
    size_t bytes = (size_t)w->unknowns * sizeof *ret;

    frame_set_loads(&k->at.f, to - from, w);
    frame_evaluate(&k->at.f, &k->at.s, FRAME_STILL, w);
    memcpy(ret, w->right, bytes);
    memset(w->q, 0, 3 * (size_t)k->f->beams * sizeof *w->q); /* K without loads on it */
    frame_evaluate(&k->at.f, &k->at.s, FRAME_STILL, w);
}

/* Of what the moves dv leave, K1 - K0 pulls at v: ret (unknowns) = dF - (K1 - K0) v. */
static enum status correct(struct walk *k, const double *dF, double *ret)
{
    struct frame_work *w = k->w[1];
    enum status s;

    frame_state_copy(k->f, k->s, &k->trial);
    frame_move(k->f, w, k->dv, NULL, &k->trial);
    s = update(k, &k->trial);
    if (s != SW_OK)
        return s;
    memset(w->q, 0, 3 * (size_t)k->f->beams * sizeof *w->q);
    memset(w->load, 0, 6 * (size_t)k->f->n * sizeof *w->load);
    frame_evaluate(&k->at.f, &k->at.s, FRAME_STILL, w);
    memcpy(ret, dF, (size_t)w->unknowns * sizeof *ret);
    sparse_multiply_add(&w->K, -1, k->v, ret);
    sparse_multiply_add(&k->w[0]->K, 1, k->v, ret);
    return SW_OK;
}

/* |a - b| / |a| */
static double change(const double *a, const double *b, int n)
{
    double size = 0, apart = 0;

    for (int i = 0; i < n; i++) {
        size += a[i] * a[i];
        apart += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return size > 0 ? sqrt(apart / size) : 0;
}

/* (46)-(50) from time t to t + dt; the state is moved. */
static enum status step(struct walk *k, double t, double dt, struct follow_step *done)
{
    struct frame_work *w = k->w[0];
    size_t bytes = (size_t)w->unknowns * sizeof *k->dv;
    double *dF = mem_doubles((size_t)w->unknowns);
    enum status s = dF ? update(k, k->s) : SW_NOMEM;

    if (s == SW_OK) {
        difference(k, w, 0, t, k->v);
        difference(k, w, t, t + dt, dF);
        s = frame_factorize(w);
    }
    if (s == SW_OK)
        s = sparse_solve(&w->K, 1, k->v);
    memcpy(k->dv, dF ? dF : k->dv, bytes);
    if (s == SW_OK)
        s = sparse_solve(&w->K, 1, k->dv);
    done->residual = INFINITY;
    while (s == SW_OK && !(done->residual <= k->o->tolerance)) {
        if (done->iterations++ == k->o->iterations)
            s = SW_NOCONV;
        memcpy(k->before, k->dv, bytes);
        if (s == SW_OK)
            s = correct(k, dF, k->dv);
        if (s == SW_OK)
            s = sparse_solve(&w->K, 1, k->dv);
        done->residual = change(k->dv, k->before, w->unknowns);
    }
    if (s == SW_OK)
        frame_move(k->f, w, k->dv, NULL, k->s);
    free(dF);
    return s;
}

/* End forces by (38) on the last geometry. */
static enum status end_forces(struct walk *k)
{
    struct frame_work *w = k->w[0];
    enum status s = update(k, k->s);

    if (s == SW_OK) {
        difference(k, w, 0, 1, k->v);
        s = frame_factorize(w);
    }
    if (s == SW_OK)
        s = sparse_solve(&w->K, 1, k->v);
    for (int i = 0; i < 6 * k->f->n && s == SW_OK; i++)
        k->full[i] = w->dof[i] >= 0 ? k->v[w->dof[i]] : 0;
    if (s == SW_OK) {
        frame_set_loads(&k->at.f, 1, w);
        for (int i = 0; i < k->f->beams; i++) { /* held ends, then what moves bring */
            double loads[12];

            beam_loads(&k->at.f.beam[i].beam, w->q + 3 * i, loads);
            for (int c = 0; c < 12; c++)
                w->end[12 * i + c] = -loads[c];
        }
        for (int i = 0; i < k->f->beams; i++) {
            const struct frame_beam *b = &k->at.f.beam[i];
            double K[144];

            beam_stiffness(&b->beam, K);
            for (int r = 0; r < 12; r++)
                for (int c = 0; c < 12; c++)
                    w->end[12 * i + r] +=
                        K[r + 12 * c] * k->full[6 * (c < 6 ? b->a : b->b) + c % 6];
        }
    }
    return s;
}

/* Forces by which nodes are held. */
static void sum_ends(const struct frame *f, struct frame_work *w)
{
    for (int i = 0; i < 6 * f->n; i++)
        w->open[i] = -w->load[i];
    for (int i = 0; i < 12 * f->beams; i++) {
        const struct frame_beam *b = &f->beam[i / 12];

        w->open[6 * (i % 12 < 6 ? b->a : b->b) + i % 6] += w->end[i];
    }
}

enum status updated(const struct frame *f, const struct follow_options *o, struct frame_state *s,
                    struct frame_work *w, struct follow_path *ret)
{
    struct walk k = {.f = f, .o = o, .w = {w}, .s = s};
    enum status status = walk_new(&k);

    *ret = (struct follow_path){.critical = NAN, .failed_node = -1};
    ret->step = mem_zeroed((size_t)o->parts + 1, sizeof *ret->step);
    if (!ret->step)
        status = SW_NOMEM;
    ret->n = status == SW_OK;
    for (int i = 0; i < o->parts && status == SW_OK; i++) {
        struct follow_step *done = &ret->step[ret->n++];

        status = step(&k, s->t, 1.0 / o->parts, done);
        s->t = status == SW_OK ? (i + 1.0) / o->parts : s->t;
        done->t = s->t;
        for (int c = 0; c < 6 && o->watch >= 0; c++)
            done->watch[c] =
                c < 3 ? s->x[3 * o->watch + c] - f->node[o->watch].x[c] + s->low[3 * o->watch + c]
                      : s->turn[3 * o->watch + c - 3];
    }
    if (status == SW_OK) {
        status = end_forces(&k);
        sum_ends(f, w);
        frame_measure(f, w);
    }
    if (status == SW_INDEFINITE)
        ret->failed_node = frame_node_of(f, w, w->K.failed);
    walk_free(&k);
    return status;
}
