/* Generalized-alpha. */
#include "phys/alpha.h"
#include "num/mem.h"
#include "phys/march.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NEWTON_STEPS 12
#define CONVERGED 1e-7 /* last correction over the largest displacement; the next is its square */
#define ROOM 0.5       /* of the tolerance: what a longer step may be expected to need */
#define EVEN 256       /* steps of one length before a longer one: more than a period */
#define LITTLE 0.01    /* of ROOM: a longer step at once */

/* Band += c b b^T, b within one element. */
static void add_product(struct band *A, double c, const double *b)
{
    for (int j = 0; j < A->n; j++)
        for (int i = j; b[j] != 0 && i < A->n && i - j <= A->kd; i++)
            *band_at(A, i, j) += c * b[i] * b[j];
}

static enum status new_matrices(struct march *m)
{
    struct alpha *p = m->alpha;
    struct band K = {0};
    size_t n = model_unknowns(m->model);
    enum status s = model_mass(m->model, PART_ALL, &p->M);

    if (s == SW_OK)
        s = model_stiffness(m->model, PART_ALL, &K);
    if (s == SW_OK)
        s = band_combine(m->options.alpha, &p->M, m->options.beta, &K, &p->C);
    if (s == SW_OK)
        s = band_new(p->M.n, p->M.kd, &p->S);
    if (s == SW_OK)
        s = band_new(p->M.n, p->M.kd, &p->J);
    for (int i = 0; i < m->dampers.r && s == SW_OK; i++)
        add_product(&p->C, m->dampers.c[i], m->dampers.b + n * (size_t)i);
    band_free(&K);
    return s;
}

static enum status new_vectors(struct march *m)
{
    struct alpha *p = m->alpha;
    double **vector[] = {&p->W, &p->A, &p->V1, &p->W1, &p->A1, &p->Vm, &p->Wm, &p->Am, &p->R};

    for (size_t i = 0; i < sizeof vector / sizeof *vector; i++) {
        *vector[i] = model_vector(m->model);
        if (!*vector[i])
            return SW_NOMEM;
    }
    return SW_OK;
}

enum status alpha_new(struct march *m)
{
    double r = m->options.radius;
    struct alpha *p = m->alpha = mem_zeroed(1, sizeof *p);

    if (!p)
        return SW_NOMEM;
    p->am = (2 * r - 1) / (r + 1);
    p->af = r / (r + 1);
    p->g = 0.5 - p->am + p->af;
    p->b = (1 - p->am + p->af) * (1 - p->am + p->af) / 4;
    p->ticks = m->options.substeps > 0 ? m->options.substeps : ALPHA_FINEST;
    p->stride = m->options.substeps > 0 ? 1 : ALPHA_FINEST / 4;
    p->past = -1;
    return new_vectors(m) == SW_OK ? new_matrices(m) : SW_NOMEM;
}

void alpha_free(struct alpha *p)
{
    if (!p)
        return;
    free(p->W);
    free(p->A);
    free(p->V1);
    free(p->W1);
    free(p->A1);
    free(p->Vm);
    free(p->Wm);
    free(p->Am);
    free(p->R);
    band_free(&p->M);
    band_free(&p->C);
    band_free(&p->S);
    band_free(&p->J);
    free(p);
}

static double largest(size_t n, const double *x)
{
    double most = 0;

    for (size_t i = 0; i < n; i += 2) /* displacements, not slopes */
        if (!(fabs(x[i]) <= most))
            most = fabs(x[i]);
    return most;
}

/* State at the end of a step dt by constant acceleration; supports as they move. */
static void predict(struct march *m, double dt)
{
    struct alpha *p = m->alpha;
    double u[6], v[6], a[6];
    int held[6];

    for (size_t i = 0; i < model_unknowns(m->model); i++) {
        p->A1[i] = p->A[i];
        p->W1[i] = p->W[i] + dt * p->A[i];
        p->V1[i] = m->V[i] + dt * (p->W[i] + dt / 2 * p->A[i]);
    }
    march_supports(m, march_time(m) + dt, u, v, a);
    model_prescribed(m->model, held);
    for (int i = 0; i < 6; i++) {
        p->V1[held[i]] = u[i];
        p->W1[held[i]] = v[i];
        p->A1[held[i]] = a[i];
    }
}

/* R = what is missing in the balance between the two ends of the step; zero at the supports. */
static void residual(struct march *m, double dt)
{
    struct alpha *p = m->alpha;
    struct force_extremes seen;
    double u[6], v[6], a[6], between = march_time(m) + (1 - p->af) * dt;
    int held[6];

    for (size_t i = 0; i < model_unknowns(m->model); i++) {
        p->Vm[i] = (1 - p->af) * p->V1[i] + p->af * m->V[i];
        p->Wm[i] = (1 - p->af) * p->W1[i] + p->af * p->W[i];
        p->Am[i] = (1 - p->am) * p->A1[i] + p->am * p->A[i];
    }
    model_prescribed(m->model, held);
    march_supports(m, between, u, v, a);
    for (int i = 0; i < 6; i++) /* A of the free unknowns is that of (af - am) dt earlier */
        p->Am[held[i]] = a[i];
    force_all(&m->forces, m->options.terms, p->Vm, p->R, &seen);
    if (forcing_any(&m->options.forcing))
        forcing_subtract(m->model, &m->options.forcing, between, p->Vm, p->Wm, p->R);
    band_multiply_add(&p->M, 1, p->Am, p->R);
    band_multiply_add(&p->C, 1, p->Wm, p->R);
    for (size_t i = 0; i < model_unknowns(m->model); i++)
        p->R[i] = -p->R[i];
    for (int i = 0; i < 6; i++)
        p->R[held[i]] = 0;
}

/* Unit rows and columns for the supports. */
static void hold(const struct model *m, struct band *J)
{
    int held[6];

    model_prescribed(m, held);
    for (int i = 0; i < 6; i++)
        for (int j = held[i] - J->kd; j <= held[i] + J->kd; j++)
            if (j >= 0 && j < J->n)
                *band_at(J, j > held[i] ? j : held[i], j > held[i] ? held[i] : j) = j == held[i];
}

/* The tangent at Vm, factored. */
static enum status factor(struct march *m, double dt)
{
    struct alpha *p = m->alpha;
    size_t size = (size_t)p->S.n * (size_t)(p->S.kd + 1);

    if (p->S_dt != dt) {
        double mass = (1 - p->am) / (p->b * dt * dt), damping = (1 - p->af) * p->g / (p->b * dt);

        for (size_t i = 0; i < size; i++)
            p->S.a[i] = mass * p->M.a[i] + damping * p->C.a[i];
        p->S_dt = dt;
    }
    memcpy(p->J.a, p->S.a, size * sizeof *p->J.a);
    force_tangent(&m->forces, m->options.terms, p->Vm, 1 - p->af, &p->J);
    hold(m->model, &p->J);
    return band_factor_in_place(&p->J);
}

/* One step dt to V1, W1, A1.  SW_NOCONV, SW_INDEFINITE. */
static enum status step(struct march *m, double dt)
{
    struct alpha *p = m->alpha;
    size_t n = model_unknowns(m->model);

    predict(m, dt);
    p->scale = fmax(p->scale, largest(n, p->V1));
    for (int k = 0; k < NEWTON_STEPS; k++) {
        enum status s;
        double correction;

        residual(m, dt);
        s = factor(m, dt);
        if (s != SW_OK)
            return s;
        p->iterations++;
        band_solve_in_place(&p->J, p->R);
        for (size_t i = 0; i < n; i++) {
            p->V1[i] += p->R[i];
            p->W1[i] += p->g / (p->b * dt) * p->R[i];
            p->A1[i] += 1 / (p->b * dt * dt) * p->R[i];
        }
        correction = largest(n, p->R);
        if (correction <= CONVERGED * p->scale)
            return SW_OK;
        if (!isfinite(correction))
            return SW_NOCONV;
    }
    return SW_NOCONV;
}

/* Acceleration of the present time itself, from M X = R - F - C W; spoils R and J. */
static enum status accelerate(const struct march *m, double *X)
{
    struct alpha *p = m->alpha;
    size_t size = (size_t)p->M.n * (size_t)(p->M.kd + 1), n = model_unknowns(m->model);
    double u[6], v[6], a[6];
    struct force_extremes seen;
    struct force_table forces = m->forces; /* its work space is what changes */
    int held[6];
    enum status s;

    march_supports(m, march_time(m), u, v, a);
    model_prescribed(m->model, held);
    memset(X, 0, sizeof *X * n);
    for (int i = 0; i < 6; i++)
        X[held[i]] = a[i];
    force_all(&forces, m->options.terms, m->V, p->R, &seen);
    if (forcing_any(&m->options.forcing))
        forcing_subtract(m->model, &m->options.forcing, march_time(m), m->V, p->W, p->R);
    band_multiply_add(&p->C, 1, p->W, p->R);
    band_multiply_add(&p->M, 1, X, p->R);
    for (size_t i = 0; i < n; i++)
        X[i] = -p->R[i];
    for (int i = 0; i < 6; i++)
        X[held[i]] = a[i];
    memcpy(p->J.a, p->M.a, size * sizeof *p->J.a);
    hold(m->model, &p->J);
    s = band_factor_in_place(&p->J);
    if (s == SW_OK)
        band_solve_in_place(&p->J, X);
    return s;
}

enum status alpha_settle(struct march *m)
{
    struct alpha *p = m->alpha;
    enum status s = p->settled ? SW_OK : accelerate(m, p->A);

    if (s == SW_OK)
        p->settled = 1;
    return s;
}

/* Error of the step that was tried, over what is allowed; 0 for fixed steps. */
static double error(const struct march *m, double dt)
{
    const struct alpha *p = m->alpha;
    double most = 0;

    if (m->options.substeps > 0)
        return 0;
    for (size_t i = 0; i < model_unknowns(m->model); i += 2)
        if (!(fabs(p->A1[i] - p->A[i]) <= most))
            most = fabs(p->A1[i] - p->A[i]);
    if (most == 0) /* at rest, where the scale may be zero, too */
        return 0;
    return fabs(p->b - 1.0 / 6) * dt * dt * most / (m->options.tolerance * p->scale);
}

static void swap(double **a, double **b)
{
    double *keep = *a;

    *a = *b;
    *b = keep;
}

/* The next number of ticks up and down in 1, 2, 3, 4, 6, 8, 12, ... */
static long longer(long s)
{
    return s == 1 ? 2 : s % 3 == 0 ? s / 3 * 4 : s / 2 * 3;
}

static long shorter(long s)
{
    return s == 2 ? 1 : s % 3 == 0 ? s / 3 * 2 : s / 4 * 3;
}

/* Whether steps of so many ticks lead from here to the end of the interval. */
static int fits(const struct alpha *p, long stride)
{
    return p->ticks % stride == 0 && p->tick % stride == 0;
}

static void set_stride(struct alpha *p, long stride)
{
    p->stride = stride;
    p->worst = 0;
    p->even = 0;
}

/* A longer step where it ends on the interval's grid and its error, which goes with the third
 * power, leaves room.  By the worst of many steps: else their lengths would change to and fro
 * within a period, and never alike, and a limit cycle would not quite be one. */
static void lengthen(struct alpha *p)
{
    int judged = p->even >= EVEN && p->tick == 0; /* where all of them fit */
    long next = p->stride;

    for (int i = 0; i < 2; i++) {
        double ratio, needs;

        next = longer(next);
        ratio = (double)next / (double)p->stride;
        needs = p->worst * ratio * ratio * ratio;
        if (fits(p, next) && needs <= (judged ? 1 : LITTLE) * ROOM) {
            set_stride(p, next);
            return;
        }
    }
    if (judged)
        set_stride(p, p->stride);
}

static void shorten(struct alpha *p)
{
    long next = p->stride;

    do
        next = shorter(next);
    while (!fits(p, next));
    set_stride(p, next);
}

/* Take the tried step. */
static void accept(struct march *m, double error_seen)
{
    struct alpha *p = m->alpha;

    p->past = march_time(m);
    swap(&m->V, &p->V1);
    swap(&p->W, &p->W1);
    swap(&p->A, &p->A1);
    p->tick += p->stride;
    if (p->tick == p->ticks) {
        p->tick = 0;
        p->row++;
    }
    m->step++;
    p->worst = fmax(p->worst, error_seen);
    p->even++;
    if (m->options.substeps == 0)
        lengthen(p);
}

enum status alpha_advance(struct march *m)
{
    struct alpha *p = m->alpha;
    enum status s = alpha_settle(m);

    while (s == SW_OK) {
        double dt = m->options.interval * (double)p->stride / (double)p->ticks, seen;

        s = step(m, dt);
        seen = error(m, dt);
        if (s == SW_OK && seen <= 1) {
            accept(m, seen);
            return SW_OK;
        }
        if (m->options.substeps > 0 || p->stride == 1)
            return s == SW_OK ? SW_NOCONV : s;
        shorten(p);
        p->rejected++;
        s = SW_OK;
    }
    return s;
}

void alpha_support(const struct march *m, double ret[6])
{
    const struct alpha *p = m->alpha;
    int held[6];

    model_prescribed(m->model, held);
    accelerate(m, p->Am); /* cannot fail: M did not when the march settled */
    for (int i = 0; i < 6; i++) {
        int at = held[i];

        ret[i] = m->F[at];
        for (int j = at - p->M.kd; j <= at + p->M.kd; j++)
            if (j >= 0 && j < p->M.n)
                ret[i] += band_get(&p->M, at, j) * p->Am[j] + band_get(&p->C, at, j) * p->W[j];
    }
}
