/* Eight marches side by side. */
#include "phys/lanes.h"
#include "num/mem.h"
#include "num/simd.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { FIELD_X1, FIELD_X2, FIELD_EA, FIELD_T, FIELD_STIFF, N_FIELDS };

/*
 * A node's block of the factor, A = L D L^T with unit L:  BEFORE: rows of this node, columns of the
 * one before; WITHIN: strictly lower part; INVERSE: of D.  The plane has four unknowns a node, the
 * lateral part (and each component of M) two.
 */
enum { PLANE_BEFORE = 0, PLANE_WITHIN = 16, PLANE_INVERSE = 22, LATERAL = 26, BLOCK = 33 };
enum { PAIR_BEFORE = 0, PAIR_WITHIN = 4, PAIR_INVERSE = 5, PAIR = 7 };

/* Columns of A at a support: of v1, v2 (slopes of its node, then the next node's unknowns), of
 * v3. */
enum { SUPPORT_PLANE = 6, SUPPORT_LATERAL = 12, SUPPORT = 15 };

/* Place of unknown u among the strictly lower entries of row r. */
static inline int within(int r, int u)
{
    return r * (r - 1) / 2 + u;
}

/* The vectors, aligned, into one piece of memory. */
static void carve(struct lanes *p, double *memory)
{
    size_t nodes = (size_t)p->model->n + 1;
    lanes_vector *at = (lanes_vector *)(void *)(((uintptr_t)memory + sizeof(lanes_vector) - 1) /
                                                sizeof(lanes_vector) * sizeof(lanes_vector));

    p->V = at;
    p->D = p->V + 6 * nodes;
    p->Y = p->D + 6 * nodes;
    p->factor = p->Y + 6 * nodes;
    p->support = p->factor + (p->beta ? BLOCK * nodes : 0);
    p->motion = (struct lanes_motion *)(void *)(p->support + 2 * SUPPORT);
}

/* Blocks of one part's factor: width unknowns a node, from F to every stride-th double of to. */
static void take_blocks(const struct band_factor *F, int width, size_t stride, double *to,
                        size_t block)
{
    int nodes = F->n / width, kd = F->kd;

    for (int k = 0; k < nodes; k++, to += stride * block) {
        double *own = to + stride * (size_t)(width * width);
        double *inverse = own + stride * (size_t)within(width, 0);

        for (int r = 0; r < width; r++) {
            const double *row = F->row + (size_t)kd * (size_t)(width * k + r);

            for (int u = 0; u < width && k > 0; u++)
                to[stride * (size_t)(width * r + u)] = row[kd - width - r + u];
            for (int u = 0; u < r; u++)
                own[stride * (size_t)within(r, u)] = row[kd - r + u];
            inverse[stride * (size_t)r] = F->inverse[width * k + r];
        }
    }
}

/* Column of A at unknown `held` of a support's node: its slopes, then the next node. */
static void take_column(const struct band *A, int width, int node, int next, int held,
                        size_t stride, double *to)
{
    int at = width * node + held;

    for (int r = 1; r < width; r += 2, to += stride)
        *to = band_get(A, width * node + r, at);
    for (int r = 0; r < width; r++, to += stride)
        *to = band_get(A, width * next + r, at);
}

enum status lanes_new(const struct model *m, int terms, int beta, int n_motions, struct lanes *ret)
{
    size_t nodes = (size_t)m->n + 1,
           vectors = (size_t)(18 + (beta ? BLOCK : 0)) * nodes + 2 * SUPPORT +
                     (size_t)n_motions * sizeof(struct lanes_motion) / sizeof(lanes_vector);
    double h = m->h, unit = m->line.cable.mu * h / 420;
    const double assembled[] = {312, 54, 13 * h, 8 * h * h, 3 * h * h, 22 * h, 4 * h * h};
    struct inertia mass;
    enum status s = SW_OK;

    *ret = (struct lanes){.model = m, .terms = terms, .beta = beta, .n_motions = n_motions};
    ret->memory = mem_doubles(LANES * (vectors + 1));
    ret->material = mem_doubles((size_t)m->n * GAUSS * N_FIELDS);
    ret->mass_factor = mem_doubles(PAIR * nodes);
    if (!ret->memory || !ret->material || !ret->mass_factor) {
        lanes_free(ret);
        return SW_NOMEM;
    }
    carve(ret, ret->memory);
    for (int q = 0; q < GAUSS; q++) {
        ret->slope[q][0] = m->slope[q][2];
        ret->slope[q][1] = m->slope[q][1];
        ret->slope[q][2] = m->slope[q][3];
    }
    for (size_t i = 0; i < (size_t)m->n * GAUSS; i++) {
        const struct material *from = &m->material[i];
        double *to = ret->material + N_FIELDS * i;

        to[FIELD_X1] = from->x1;
        to[FIELD_X2] = from->x2;
        to[FIELD_EA] = gauss_weight[i % GAUSS] * m->h * from->EA;
        to[FIELD_T] = gauss_weight[i % GAUSS] * m->h * from->T;
        to[FIELD_STIFF] = 3 * from->EA / (from->EA * from->stretch * from->stretch + from->T);
    }
    for (int i = 0; i < 7; i++)
        ret->mass[i] = unit * assembled[i];
    if (!beta) {
        s = inertia_new(m, 1, 0, 1, 0, 0, &mass);
        if (s == SW_OK) {
            take_blocks(&mass.part[0].factor, 2, 1, ret->mass_factor, PAIR);
            take_column(&mass.part[0].A, 2, 0, 1, 0, 1, ret->mass_support[0]);
            take_column(&mass.part[0].A, 2, m->n, m->n - 1, 0, 1, ret->mass_support[1]);
            inertia_free(&mass);
        }
    }
    if (s != SW_OK)
        lanes_free(ret);
    else
        for (int i = 0; i < LANES; i++)
            lanes_clear(ret, i);
    return s;
}

void lanes_free(struct lanes *p)
{
    free(p->memory);
    free(p->material);
    free(p->mass_factor);
    *p = (struct lanes){0};
}

void lanes_clear(struct lanes *p, int i)
{
    size_t nodes = (size_t)p->model->n + 1;

    for (size_t j = 0; j < 18 * nodes; j++)
        p->V[j][i] = 0;
    for (size_t j = 0; j < BLOCK * nodes && p->beta; j++)
        p->factor[j][i] = 0;
    for (size_t j = 0; j < 2 * SUPPORT; j++)
        p->support[j][i] = 0;
    for (int j = 0; j < p->n_motions; j++) {
        lanes_vector *v = &p->motion[j].c; /* nothing but vectors */

        for (size_t k = 0; k < sizeof(struct lanes_motion) / sizeof *v; k++)
            v[k][i] = 0; // cppcheck-suppress objectIndex  // all of the struct, see there
    }
    p->ramps[i] = p->n_source[i] = 0;
    p->dt[i] = 0;
    p->step[i] = 0;
    p->gamma[i] = p->bad[i] = p->slack[i] = 0;
    p->scale[i] = 1;
    p->limit[i] = INFINITY;
}

/* Ramps of lane i at the end of the next step; those that are over stay so. */
static void ramp(struct lanes *p, int i)
{
    double t = (double)(p->step[i] + 1) * p->dt[i];

    p->ramps[i] = 0;
    for (int j = 0; j < p->n_source[i]; j++) {
        p->motion[j].r[i] = motion_ramp(&p->source[i][j], t);
        p->ramps[i] |= t < p->source[i][j].ramp;
    }
}

void lanes_tune(struct lanes *p, int i)
{
    double t = (double)p->step[i] * p->dt[i];

    for (int j = 0; j < p->n_source[i]; j++) {
        double omega = p->source[i][j].omega;

        p->motion[j].c[i] = cos(omega * t);
        p->motion[j].s[i] = sin(omega * t);
    }
}

/* The motions of m, at its present step. */
static void put_motions(struct lanes *p, int i, const struct march *m)
{
    p->source[i] = m->options.motion;
    p->n_source[i] = m->options.n_motions;
    p->dt[i] = m->options.dt;
    p->step[i] = m->step;
    for (int j = 0; j < p->n_source[i]; j++) {
        const struct motion *from = &p->source[i][j];
        struct lanes_motion *to = &p->motion[j];
        double u[3], v[3], re[3], im[3];
        int at = from->support == SUPPORT_LEFT ? 0 : 3;

        for (int c = 0; c < 3; c++) {
            u[c] = from->amplitude[c] * cos(from->phase[c]);
            v[c] = -from->amplitude[c] * sin(from->phase[c]);
        }
        axes_to_plane(&p->model->axes, u, re);
        axes_to_plane(&p->model->axes, v, im);
        for (int c = 0; c < 3; c++) {
            to->p[at + c][i] = re[c];
            to->q[at + c][i] = im[c];
        }
        to->dc[i] = cos(from->omega * p->dt[i]);
        to->ds[i] = sin(from->omega * p->dt[i]);
    }
    lanes_tune(p, i);
    ramp(p, i);
}

void lanes_put(struct lanes *p, int i, const struct march *m)
{
    const struct inertia *A = &m->inertia;
    const struct march_options *o = &m->options;
    double w = o->dt * m->omega_max, *lane = (double *)p->factor + i;
    double *support = (double *)p->support + i;
    int n = p->model->n;

    lanes_clear(p, i);
    put_motions(p, i, m);
    for (size_t j = 0; j < 6 * ((size_t)n + 1); j++) {
        p->V[j][i] = m->V[j];
        p->D[j][i] = m->D[j];
    }
    p->limit[i] = p->terms > 0 ? 4 / (w * w) - 1 : INFINITY;
    p->scale[i] =
        p->beta ? 2 / (o->dt * o->dt) : 1 / (1 / (o->dt * o->dt) + o->alpha / (2 * o->dt));
    p->gamma[i] = A->gamma;
    if (!p->beta)
        return;
    take_blocks(&A->part[1].factor, 4, LANES, lane, BLOCK);
    take_blocks(&A->part[0].factor, 2, LANES, lane + LANES * LATERAL, BLOCK);
    for (int side = 0; side < 2; side++, support += LANES * SUPPORT) {
        int node = side * n, next = side ? n - 1 : 1;

        take_column(&A->part[1].A, 4, node, next, 0, LANES, support);
        take_column(&A->part[1].A, 4, node, next, 2, LANES, support + LANES * SUPPORT_PLANE);
        take_column(&A->part[0].A, 2, node, next, 0, LANES, support + LANES * SUPPORT_LATERAL);
    }
}

/* The step by registers of 2, 4 and 8 lanes. */
#define WIDTH 2
#define STEP step_plain
#define STEP_FOR
#include "phys/lanes_step.h"

#define WIDTH 4
#define STEP step_avx2
#define STEP_FOR FOR_AVX2
#include "phys/lanes_step.h"

#define WIDTH 8
#define STEP step_avx512
#define STEP_FOR FOR_AVX512
#include "phys/lanes_step.h"

void lanes_step_by(struct lanes *p, int width)
{
    for (int i = 0; i < LANES; i++)
        if (p->ramps[i])
            ramp(p, i);
    if (width == 8)
        step_avx512(p);
    else if (width == 4)
        step_avx2(p);
    else
        step_plain(p);
    for (int i = 0; i < LANES; i++)
        p->step[i]++;
}

int lanes_width(void)
{
    return has_avx512() ? 8 : has_avx2() ? 4 : 2;
}

void lanes_step(struct lanes *p)
{
    lanes_step_by(p, lanes_width());
}

void lanes_look(const struct lanes *p, int i, double *V)
{
    for (size_t j = 0; j < model_unknowns(p->model); j++)
        V[j] = p->V[j][i];
}

void lanes_add(struct lanes *p, int i, const double *V, const double *D)
{
    for (size_t j = 0; j < model_unknowns(p->model); j++) {
        p->V[j][i] += V[j];
        p->D[j][i] += D[j];
    }
}
