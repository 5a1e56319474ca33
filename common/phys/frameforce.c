/* Structures of curved beams: forces and stiffness of a state. */
#include "num/quat.h"
#include "num/vec3.h"
#include "phys/frame.h"

#include <string.h>

/* A block while it is put together: of a beam, or of a spring. */
struct block {
    int i, n;                     /* element; its unknowns */
    int ends[2], to[HINGED_MOST]; /* nodes, unknowns */
    double du[HINGED_MOST];       /* moves of them that follow */
    double force[HINGED_MOST], K[HINGED_MOST * HINGED_MOST];
};

static void begin_block(const struct frame *f, const struct frame_work *w, int i,
                        struct frame_moves moves, struct block *b)
{
    const struct frame_beam *beam = i < f->beams ? &f->beam[i] : NULL;

    b->i = i;
    b->ends[0] = beam ? beam->a : f->spring[i - f->beams].a;
    b->ends[1] = beam ? beam->b : f->spring[i - f->beams].b;
    b->n = frame_unknowns(f, w, i, b->to);
    for (int c = 0; c < b->n; c++) {
        int node = c < 12 ? b->ends[c / 6] : -1;

        b->du[c] = node >= 0 && moves.node ? moves.node[6 * node + c % 6] : 0;
        if (c >= 12 && moves.hinge)
            b->du[c] = moves.hinge[b->to[c]];
    }
}

static void add_block(const struct block *b, size_t *at, struct frame_work *w)
{
    for (int r = 0; r < b->n; r++) {
        double x = b->force[r];

        for (int c = 0; c < b->n; c++)
            x += b->K[r + b->n * c] * b->du[c];
        if (r < 12 && b->ends[r / 6] >= 0)
            w->open[6 * b->ends[r / 6] + r % 6] += x;
        else if (r >= 12)
            w->right[b->to[r]] -= x;
    }
    for (int c = 0; c < b->n; c++)
        for (int r = c; r < b->n; r++, (*at)++)
            if (w->at[*at] >= 0)
                w->K.value[w->at[*at]] += b->K[r + b->n * c];
}

static void measure(const double force[12], struct frame_work *w)
{
    for (int i = 0; i < 12; i++)
        if (i % 6 < 3)
            w->force = fmax(w->force, fabs(force[i]));
        else
            w->moment = fmax(w->moment, fabs(force[i]));
}

/* The end forces, with those that moves bring. */
static void keep_ends(const struct frame_beam *beam, const struct block *b, double axis[2][3][3],
                      const double force[12], const double K[144], double *ret)
{
    double moved[12];

    hinge_ends(beam->hinge, axis, b->du, moved);
    for (int r = 0; r < 12; r++) {
        ret[r] = force[r];
        for (int c = 0; c < 12; c++)
            ret[r] += K[r + 12 * c] * moved[c];
    }
}

/* A beam as it is. */
struct posed {
    struct corotate e;
    double d[3], q1[4], q2[4], axis[2][3][3];
    const double *q; /* NULL: no load */
};

static void pose(const struct frame *f, const struct frame_state *s, const struct frame_work *w,
                 int i, struct posed *p)
{
    const struct frame_beam *beam = &f->beam[i];
    const int a = 3 * beam->a, b = 3 * beam->b;

    p->e = corotate_beam(&beam->beam);
    for (int c = 0; c < 3; c++)
        p->d[c] = s->x[a + c] - s->x[b + c] + (s->low[a + c] - s->low[b + c]);
    hinge_end(&beam->hinge[0], &s->hinge[2 * i], s->q + 4 * beam->a, p->q1, p->axis[0]);
    hinge_end(&beam->hinge[1], &s->hinge[2 * i + 1], s->q + 4 * beam->b, p->q2, p->axis[1]);
    p->q = w->q + 3 * i;
    if (p->q[0] == 0 && p->q[1] == 0 && p->q[2] == 0)
        p->q = NULL;
}

static void evaluate_beam(const struct frame *f, const struct frame_state *s, int i,
                          struct frame_moves moves, size_t *at, struct frame_work *w)
{
    const struct frame_beam *beam = &f->beam[i];
    struct posed p;
    struct corotated here;
    struct block b;
    double of_ends[144], *K = b.K; /* apart where hinges add unknowns to those of the ends */

    begin_block(f, w, i, moves, &b);
    if (b.n > 12)
        K = of_ends;
    pose(f, s, w, i, &p);
    corotate(&p.e, p.d, p.q1, p.q2, p.q, w->guessed ? w->guess + 6 * i : NULL, &here, K);
    measure(here.force, w);
    w->angle = fmax(w->angle, here.angle);
    w->energy += here.energy;
    if (p.q)
        w->energy -= p.e.length * vec3_dot(p.q, s->x + 3 * beam->b);
    if (K == of_ends)
        hinge_expand(beam->hinge, p.axis, here.force, K, b.force, b.K);
    else
        memcpy(b.force, here.force, sizeof here.force);
    memcpy(w->end + 12 * i, here.force, sizeof here.force);
    if (moves.node)
        keep_ends(beam, &b, p.axis, here.force, K, w->end + 12 * i);
    add_block(&b, at, w);
}

void frame_foresee(const struct frame *f, const struct frame_state *s, struct frame_moves moves,
                   struct frame_work *w)
{
    for (int i = 0; i < f->beams; i++) {
        struct posed p;
        struct block b;
        double du[12];

        begin_block(f, w, i, moves, &b);
        pose(f, s, w, i, &p);
        hinge_ends(f->beam[i].hinge, p.axis, b.du, du);
        corotate_foresee(&p.e, p.d, p.q1, p.q2, p.q, du, w->guess + 6 * i);
    }
    w->guessed = 1;
}

/* Translations of a spring to the ground. */
static void pull_to_ground(const struct frame *f, const struct frame_state *s,
                           const struct frame_spring *p, struct corotated *here, double *K)
{
    double u[3];

    for (int c = 0; c < 3; c++)
        u[c] = s->x[3 * p->a + c] - f->node[p->a].x[c] + s->low[3 * p->a + c];
    for (int k = 0; k < 3; k++) {
        const double *axis = p->B + 3 * k;
        double moved = vec3_dot(axis, u);

        here->energy += p->k[k] * moved * moved / 2;
        for (int i = 0; i < 3; i++) {
            here->force[i] += p->k[k] * moved * axis[i];
            for (int j = 0; j < 3; j++)
                K[i + 12 * j] += p->k[k] * axis[i] * axis[j];
        }
    }
}

/* A spring is an element without a shape of its own; one to the ground keeps its axes. */
static void evaluate_spring(const struct frame *f, const struct frame_state *s, int i,
                            struct frame_moves moves, size_t *at, struct frame_work *w)
{
    static const double none[4] = QUAT_ONE;
    const struct frame_spring *p = &f->spring[i];
    double K6[36] = {0}, d[3] = {0};
    struct corotate e = {.B = p->B, .K = K6};
    struct corotated here;
    struct block b;

    begin_block(f, w, f->beams + i, moves, &b);
    for (int c = 0; c < 6; c++)
        K6[7 * c] = c < 3 && p->b < 0 ? 0 : p->k[c];
    if (p->b >= 0) {
        double D[3];

        for (int c = 0; c < 3; c++) {
            D[c] = f->node[p->a].x[c] - f->node[p->b].x[c];
            d[c] = s->x[3 * p->a + c] - s->x[3 * p->b + c] +
                   (s->low[3 * p->a + c] - s->low[3 * p->b + c]);
        }
        mat3_apply(p->B, D, e.D);
    }
    corotate(&e, d, s->q + 4 * p->a, p->b < 0 ? none : s->q + 4 * p->b, NULL, NULL, &here, b.K);
    if (p->b < 0)
        pull_to_ground(f, s, p, &here, b.K);
    measure(here.force, w);
    w->energy += here.energy;
    memcpy(b.force, here.force, sizeof here.force);
    add_block(&b, at, w);
}

void frame_evaluate(const struct frame *f, const struct frame_state *s, struct frame_moves moves,
                    struct frame_work *w)
{
    size_t at = 0;

    memset(w->K.value, 0, w->K.entries * sizeof *w->K.value);
    memset(w->right, 0, (size_t)w->unknowns * sizeof *w->right);
    w->force = w->moment = w->angle = w->energy = 0;
    for (int i = 0; i < 6 * f->n; i++) {
        w->open[i] = -w->load[i];
        if (i % 6 < 3)
            w->force = fmax(w->force, fabs(w->load[i]));
        else
            w->moment = fmax(w->moment, fabs(w->load[i]));
    }
    for (int i = 0; i < f->beams; i++)
        evaluate_beam(f, s, i, moves, &at, w);
    for (int i = 0; i < f->springs; i++)
        evaluate_spring(f, s, i, moves, &at, w);
    for (int i = 0; i < 6 * f->n; i++)
        if (w->dof[i] >= 0)
            w->right[w->dof[i]] = -w->open[i];
}

void frame_measure(const struct frame *f, struct frame_work *w)
{
    w->force = w->moment = 0;
    for (int i = 0; i < f->beams; i++)
        measure(w->end + 12 * i, w);
    for (int i = 0; i < 6 * f->n; i++)
        if (i % 6 < 3)
            w->force = fmax(w->force, fabs(w->load[i]));
        else
            w->moment = fmax(w->moment, fabs(w->load[i]));
}
