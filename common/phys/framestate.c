/* Where a structure of beams is, and how it moves. */
#include "num/mem.h"
#include "num/quat.h"
#include "num/vec3.h"
#include "phys/frame.h"

#include <stdlib.h>
#include <string.h>

enum status frame_state_new(const struct frame *f, struct frame_state *ret)
{
    size_t n = (size_t)f->n;

    *ret = (struct frame_state){.x = mem_doubles(3 * n),
                                .low = mem_doubles(3 * n),
                                .q = mem_doubles(4 * n),
                                .turn = mem_doubles(3 * n),
                                .hinge = mem_zeroed(2 * (size_t)f->beams, sizeof *ret->hinge)};
    if (!ret->x || !ret->low || !ret->q || !ret->turn || !ret->hinge) {
        frame_state_free(ret);
        return SW_NOMEM;
    }
    for (int i = 0; i < f->n; i++) {
        memcpy(ret->x + 3 * i, f->node[i].x, sizeof f->node[i].x);
        ret->q[4 * i] = 1;
    }
    for (int i = 0; i < 2 * f->beams; i++)
        ret->hinge[i].q[0] = 1;
    return SW_OK;
}

void frame_state_free(struct frame_state *s)
{
    free(s->x);
    free(s->low);
    free(s->q);
    free(s->turn);
    free(s->hinge);
    *s = (struct frame_state){.x = NULL};
}

void frame_state_copy(const struct frame *f, const struct frame_state *from, struct frame_state *to)
{
    size_t n = (size_t)f->n;

    to->t = from->t;
    memcpy(to->x, from->x, 3 * n * sizeof *to->x);
    memcpy(to->low, from->low, 3 * n * sizeof *to->low);
    memcpy(to->q, from->q, 4 * n * sizeof *to->q);
    memcpy(to->turn, from->turn, 3 * n * sizeof *to->turn);
    memcpy(to->hinge, from->hinge, 2 * (size_t)f->beams * sizeof *to->hinge);
}

/* A node all of whose rotations are held has the rotation vector that is given, by its share: the
 * spin from one share to the next. */
static void turn_given(const struct frame_node *n, const double from[3], const double to[3],
                       double spin[3])
{
    double q0[4], q1[4];

    if ((n->held & 56) != 56) {
        for (int c = 0; c < 3; c++)
            spin[c] = n->held & 8 << c ? to[c] - from[c] : 0;
        return;
    }
    quat_exp(from, q0);
    quat_exp(to, q1);
    for (int c = 1; c < 4; c++) /* q1 q0^-1 */
        q0[c] = -q0[c];
    quat_multiply(q1, q0, q0);
    quat_log(q0, spin);
}

void frame_given(const struct frame *f, double from, double to, double *move)
{
    for (int i = 0; i < f->n; i++) {
        const struct frame_node *n = &f->node[i];
        double before[6], after[6];

        for (int c = 0; c < 6; c++) {
            before[c] = n->given[c] * frame_factor(f, n->stage[c], from);
            after[c] = n->given[c] * frame_factor(f, n->stage[c], to);
            move[6 * i + c] = c < 3 && n->held & 1 << c ? after[c] - before[c] : 0;
        }
        turn_given(n, before + 3, after + 3, move + 6 * i + 3);
    }
}

/* x + low += d, low being what x cannot hold (two-sum). */
static void add_exactly(double d, double *x, double *low)
{
    double sum = *x + d, part = sum - *x;
    double lost = (*x - (sum - part)) + (d - part) + *low;

    *x = sum + lost;
    *low = lost - (*x - sum);
}

void frame_move(const struct frame *f, const struct frame_work *w, const double *dx,
                const double *move, struct frame_state *s)
{
    for (int i = 0; i < f->n; i++) {
        double d[6], q[4];

        for (int c = 0; c < 6; c++) {
            int unknown = w->dof[6 * i + c];

            d[c] = unknown >= 0 ? (dx ? dx[unknown] : 0) : (move ? move[6 * i + c] : 0);
            if (c < 3)
                add_exactly(d[c], &s->x[3 * i + c], &s->low[3 * i + c]);
        }
        if (d[3] == 0 && d[4] == 0 && d[5] == 0)
            continue;
        quat_exp(d + 3, q);
        quat_multiply(q, s->q + 4 * i, s->q + 4 * i);
        quat_normalize(s->q + 4 * i);
        quat_log_near(s->q + 4 * i, s->turn + 3 * i);
    }
    for (int i = 0; i < 2 * f->beams && dx; i++)
        hinge_move(&f->beam[i / 2].hinge[i % 2], dx + w->first[i], &s->hinge[i]);
}

void frame_ends(const struct frame *f, const struct frame_state *s, int i, double A1[9],
                double A2[9])
{
    const struct frame_beam *b = &f->beam[i];
    double *const A[2] = {A1, A2};

    for (int end = 0; end < 2; end++) {
        double q[4], axis[3][3], R[9];

        hinge_end(&b->hinge[end], &s->hinge[2 * i + end], s->q + 4 * (end ? b->b : b->a), q, axis);
        quat_matrix(q, R);
        mat3_multiply_nt(b->A[end], R, A[end]);
    }
}
