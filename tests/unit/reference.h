/*
 * A plain march, written from equation (4.17) in increment form (theory section 3): matrices of all
 * unknowns in one band, assembled element by element, one factor, no shortcut for what does not
 * couple, forces by the plain element, dampers in C itself.  What faster ones are measured by.
 */
#ifndef SEILWERK_TESTS_REFERENCE_H
#define SEILWERK_TESTS_REFERENCE_H

#include "check.h"
#include "phys/march.h"

#include <string.h>

enum { MOST = 6 * 34, HALF = 11 };

struct reference {
    const struct model *m;
    const struct march_options *o;
    struct band M, C, A;          /* over all nodes, half bandwidth 11 */
    struct band_factor factor;    /* of A for the free unknowns */
    int keep[MOST], held[6], all; /* free unknowns, prescribed ones, number of all */
    long step;
    double V[MOST], D[MOST], F[MOST], dd[MOST]; /* as in struct march */
};

static inline void add_element(const struct reference *r, int k, struct band *M, struct band *K)
{
    static const double rest[12];
    struct element e = model_element(r->m, k);
    double one[16], E[144] = {0};

    element_mass(r->m->line.cable.mu, r->m->h, one);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                int row = i / 2 * 6 + 2 * c + i % 2, column = j / 2 * 6 + 2 * c + j % 2;

                E[row + 12 * column] = one[i + 4 * j];
            }
    band_add_block(M, 6 * k, 12, E);
    element_tangent(&e, 0, 0, rest, E);
    band_add_block(K, 6 * k, 12, E);
}

/* C += c b b^T, b^T V the displacement at the damper along its unit direction. */
static inline void add_damper(const struct reference *r, const struct damper *d, struct band *C)
{
    double at = d->position * r->m->n, f[4], f1[4], b[12], E[144];
    double size = sqrt(pow(d->direction[0], 2) + pow(d->direction[1], 2) + pow(d->direction[2], 2));
    int k = (int)at;

    hermite(r->m->h, at - k, f, f1);
    for (int i = 0; i < 12; i++)
        b[i] = f[i / 6 * 2 + i % 2] * d->direction[i % 6 / 2] / size;
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 12; i++)
            E[i + 12 * j] = d->coefficient * b[i] * b[j];
    band_add_block(C, 6 * k, 12, E);
}

static inline void factor(const struct reference *r, const struct band *A, struct band_factor *ret)
{
    struct band free_part;

    assert_int_equal(band_restrict(A, r->keep, 6 * r->m->n, &free_part), SW_OK);
    assert_int_equal(band_cholesky(&free_part, ret), SW_OK);
    band_free(&free_part);
}

static inline void reference_new(const struct model *m, const struct march_options *o,
                                 struct reference *r)
{
    struct band K;

    *r = (struct reference){.m = m, .o = o, .all = 6 * (m->n + 1)};
    for (int i = 0, j = 0; i < r->all; i++)
        if ((i < 6 || i >= 6 * m->n) && i % 2 == 0)
            r->held[i < 6 ? i / 2 : 3 + i % 6 / 2] = i;
        else
            r->keep[j++] = i;
    assert_int_equal(band_new(r->all, HALF, &r->M), SW_OK);
    assert_int_equal(band_new(r->all, HALF, &K), SW_OK);
    for (int k = 0; k < m->n; k++)
        add_element(r, k, &r->M, &K);
    assert_int_equal(band_combine(o->alpha, &r->M, o->beta, &K, &r->C), SW_OK);
    for (int i = 0; i < o->n_dampers; i++)
        add_damper(r, &o->damper[i], &r->C);
    assert_int_equal(band_combine(1 / (o->dt * o->dt), &r->M, 1 / (2 * o->dt), &r->C, &r->A),
                     SW_OK);
    factor(r, &r->A, &r->factor);
    band_free(&K);
}

static inline void reference_free(struct reference *r)
{
    band_free(&r->M);
    band_free(&r->C);
    band_free(&r->A);
    band_factor_free(&r->factor);
}

/* x with A x = -F - C D/dt in the free rows and held values; F of the present V. */
static inline void solve(struct reference *r, const struct band *A, const struct band_factor *Af,
                         const double held[6], double *x)
{
    double rhs[MOST];

    memset(r->F, 0, sizeof r->F);
    for (int k = 0; k < r->m->n; k++) {
        struct element e = model_element(r->m, k);

        element_force(&e, r->o->terms, r->V + 6 * k, r->F + 6 * k, NULL);
    }
    memset(x, 0, sizeof r->dd);
    for (int i = 0; i < 6; i++)
        x[r->held[i]] = held[i];
    for (int i = 0; i < r->all; i++)
        rhs[i] = -r->F[i];
    band_multiply_add(&r->C, -1 / r->o->dt, r->D, rhs);
    band_multiply_add(A, -1, x, rhs);
    for (int i = 0; i < 6 * r->m->n; i++)
        rhs[i] = rhs[r->keep[i]];
    band_solve(Af, rhs);
    for (int i = 0; i < 6 * r->m->n; i++)
        x[r->keep[i]] = rhs[i];
}

/* In the axes of the line's plane; v and a may be NULL. */
static inline void supports_at(const struct reference *r, double t, double u[6], double v[6],
                               double a[6])
{
    double *const all[3] = {u, v, a};

    motion_sum(r->o->motion, r->o->n_motions, t, u, v, a);
    for (int i = 0; i < 6; i++)
        if (all[i / 2]) {
            double x[3];

            axes_to_plane(&r->m->axes, all[i / 2] + i % 2 * 3, x);
            memcpy(all[i / 2] + i % 2 * 3, x, sizeof x);
        }
}

/* At rest but for the supports: V(-dt) = V(0) - dt V' + dt^2/2 V'', M V'' = -F - C V'. */
static inline void reference_start(struct reference *r, const double *V0)
{
    double u[6], v[6], a[6], past[6], dt = r->o->dt;
    struct band_factor Mf;

    supports_at(r, 0, u, v, a);
    supports_at(r, -dt, past, NULL, NULL);
    memcpy(r->V, V0, (size_t)r->all * sizeof *V0);
    for (int i = 0; i < 6; i++) {
        r->V[r->held[i]] = u[i];
        r->D[r->held[i]] = dt * v[i];
    }
    factor(r, &r->M, &Mf);
    solve(r, &r->M, &Mf, a, r->dd);
    band_factor_free(&Mf);
    for (int i = 0; i < r->all; i++)
        r->D[i] -= dt * dt / 2 * r->dd[i];
    for (int i = 0; i < 6; i++)
        r->D[r->held[i]] = u[i] - past[i];
}

static inline void reference_solve(struct reference *r)
{
    double next[6], held[6];

    supports_at(r, (double)(r->step + 1) * r->o->dt, next, NULL, NULL);
    for (int i = 0; i < 6; i++)
        held[i] = next[i] - r->V[r->held[i]] - r->D[r->held[i]];
    solve(r, &r->A, &r->factor, held, r->dd);
}

static inline void reference_advance(struct reference *r)
{
    for (int i = 0; i < r->all; i++) {
        r->D[i] += r->dd[i];
        r->V[i] += r->D[i];
    }
    r->step++;
}

/* A dd + C D/dt + F in the rows of the supports, and the static reactions. */
static inline void reference_support(const struct reference *r, double ret[6])
{
    const struct line *s = &r->m->line;
    const double at_rest[6] = {-s->H, -s->V, 0, s->H, s->V - s->W, 0};
    double f[MOST];

    memcpy(f, r->F, sizeof f);
    band_multiply_add(&r->A, 1, r->dd, f);
    band_multiply_add(&r->C, 1 / r->o->dt, r->D, f);
    for (int i = 0; i < 6; i++)
        ret[i] = f[r->held[i]] + at_rest[i];
}

#endif
