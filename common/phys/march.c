/* Central differences in increment form. */
#include "phys/march.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>

double march_critical_step(const struct model *m)
{
    return 2 / model_omega_max(m);
}

/* part := all, or all := part, for the unknowns that the part takes in. */
static void gather(const struct march_part *p, const double *all, double *part)
{
    int width = part_width(p->part), n = p->A.n / width;

    for (int k = 0; k < n; k++)
        for (int c = 0; c < width; c++)
            part[width * k + c] = all[6 * k + part_first(p->part) + c];
}

static void scatter(const struct march_part *p, const double *part, double *all)
{
    int width = part_width(p->part), n = p->A.n / width;

    for (int k = 0; k < n; k++)
        for (int c = 0; c < width; c++)
            all[6 * k + part_first(p->part) + c] = part[width * k + c];
}

/* Place among the six prescribed displacements (left v1 v2 v3, right) of held unknown i. */
static int support_component(const struct march_part *p, int i)
{
    int a_side = p->n_held / 2;

    return i / a_side * 3 + part_first(p->part) / 2 + i % a_side;
}

/* Factor of B (A or M) with unit rows and columns for the held unknowns. */
static enum status factor_held(const struct march_part *p, const struct band *B,
                               struct band_factor *ret)
{
    struct band copy = *B;
    enum status s;

    copy.a = mem_copy(B->a, sizeof(double) * (size_t)B->n * (size_t)(B->kd + 1));
    if (!copy.a)
        return SW_NOMEM;
    for (int i = 0; i < p->n_held; i++) {
        int b = p->held[i];

        for (int j = b - B->kd; j <= b + B->kd; j++)
            if (j >= 0 && j < B->n)
                *band_at(&copy, j > b ? j : b, j > b ? b : j) = j == b;
    }
    s = band_cholesky(&copy, ret);
    band_free(&copy);
    return s;
}

static enum status part_new(const struct model *m, const struct march_options *o, enum part part,
                            struct march_part *ret)
{
    struct band K = {0};
    double dt = o->dt;
    int width = part_width(part);
    enum status s;

    ret->part = part;
    for (int i = 0; i < width; i++) /* value unknowns of the first, then of the last node */
        if (i % 2 == 0) {
            ret->held[i / 2] = i;
            ret->held[i / 2 + width / 2] = width * m->n + i;
        }
    ret->n_held = width;
    s = model_mass(m, part, &ret->M);
    if (s == SW_OK)
        s = model_stiffness(m, part, &K);
    if (s == SW_OK)
        s = band_combine(o->alpha, &ret->M, o->beta, &K, &ret->C);
    if (s == SW_OK)
        s = band_combine(1 / (dt * dt), &ret->M, 1 / (2 * dt), &ret->C, &ret->A);
    if (s == SW_OK)
        s = factor_held(ret, &ret->A, &ret->factor);
    band_free(&K);
    ret->x = mem_doubles((size_t)width * ((size_t)m->n + 1));
    ret->d = mem_doubles((size_t)width * ((size_t)m->n + 1));
    if (s == SW_OK && !(ret->x && ret->d))
        s = SW_NOMEM;
    return s;
}

enum status march_new(const struct model *m, const struct march_options *o, struct march *ret)
{
    enum status s;

    *ret = (struct march){.model = m, .options = *o, .slack_time = -1};
    ret->omega_max = model_omega_max(m);
    ret->V = model_vector(m);
    ret->D = model_vector(m);
    ret->F = model_vector(m);
    ret->dd = model_vector(m);
    s = ret->V && ret->D && ret->F && ret->dd ? SW_OK : SW_NOMEM;
    if (s == SW_OK)
        s = part_new(m, o, PART_PLANE, &ret->part[0]);
    if (s == SW_OK)
        s = part_new(m, o, PART_LATERAL, &ret->part[1]);
    if (s != SW_OK)
        march_free(ret);
    return s;
}

void march_free(struct march *m)
{
    for (int i = 0; i < 2; i++) {
        band_free(&m->part[i].M);
        band_free(&m->part[i].C);
        band_free(&m->part[i].A);
        band_factor_free(&m->part[i].factor);
        free(m->part[i].x);
        free(m->part[i].d);
    }
    free(m->V);
    free(m->D);
    free(m->F);
    free(m->dd);
    *m = (struct march){0};
}

double march_time(const struct march *m)
{
    return (double)m->step * m->options.dt;
}

/* Motion of the supports at t in the axes of the line's plane; v and a as in motion_sum. */
static void supports(const struct march *m, double t, double u[6], double v[6], double a[6])
{
    const struct axes *axes = &m->model->axes;
    double *const all[3] = {u, v, a};

    motion_sum(m->options.motion, m->options.n_motions, t, u, v, a);
    for (int i = 0; i < 3 && !axes_are_plain(axes); i++)
        for (int at = 0; all[i] && at < 6; at += 3) {
            double x[3] = {all[i][at], all[i][at + 1], all[i][at + 2]};

            axes_to_plane(axes, x, all[i] + at);
        }
}

/*
 * Solve A x = p->x with the held unknowns at given values (by support component, 6).  Keeps the
 * right side of the held rows in p->residual.
 */
static void solve_held(struct march_part *p, const struct band *A, const struct band_factor *factor,
                       const double value[6])
{
    for (int i = 0; i < p->n_held; i++)
        p->residual[i] = p->x[p->held[i]];
    for (int i = 0; i < p->n_held; i++) {
        double known = value[support_component(p, i)];
        int b = p->held[i];

        for (int j = b - A->kd; known != 0 && j <= b + A->kd; j++)
            if (j >= 0 && j < A->n)
                p->x[j] -= band_get(A, j, b) * known;
    }
    for (int i = 0; i < p->n_held; i++)
        p->x[p->held[i]] = value[support_component(p, i)];
    band_solve(factor, p->x);
}

/* x = -F - C d/dt, d the part of D. */
static void right_side(const struct march *m, struct march_part *p)
{
    gather(p, m->F, p->x);
    for (int i = 0; i < p->A.n; i++)
        p->x[i] = -p->x[i];
    if (m->options.alpha != 0 || m->options.beta != 0) {
        gather(p, m->D, p->d);
        band_multiply_add(&p->C, -1 / m->options.dt, p->d, p->x);
    }
}

/*
 * Acceleration V'' of a part into m->dd, from M V'' = -F - C V' with D = V' dt and the supports'
 * accelerations a.
 */
static enum status first_acceleration(struct march *m, struct march_part *p, const double a[6])
{
    struct band_factor factor;
    enum status s = factor_held(p, &p->M, &factor);

    if (s != SW_OK)
        return s;
    right_side(m, p);
    solve_held(p, &p->M, &factor, a);
    scatter(p, p->x, m->dd);
    band_factor_free(&factor);
    return SW_OK;
}

enum status march_start(struct march *m, const double *V0)
{
    double u[6], v[6], a[6], past[6], dt = m->options.dt;
    int held[6];
    enum status s;

    supports(m, 0, u, v, a);
    supports(m, -dt, past, NULL, NULL);
    model_prescribed(m->model, held);
    m->step = 0;
    for (size_t i = 0; i < model_unknowns(m->model); i++) {
        m->V[i] = V0[i];
        m->D[i] = 0;
    }
    for (int i = 0; i < 6; i++) {
        m->V[held[i]] = u[i];
        m->D[held[i]] = dt * v[i];
    }
    model_force(m->model, m->options.terms, m->V, m->F, NULL);
    s = first_acceleration(m, &m->part[0], a);
    if (s == SW_OK)
        s = first_acceleration(m, &m->part[1], a);
    for (size_t i = 0; i < model_unknowns(m->model); i++)
        m->D[i] -= dt * dt / 2 * m->dd[i]; /* V(0) - V(-dt) = dt V' - dt^2/2 V'' */
    for (int i = 0; i < 6; i++)
        m->D[held[i]] = u[i] - past[i];
    return s;
}

void march_kick(struct march *m, enum kick kind, double size, const double *shape)
{
    double *to = kind == KICK_DISPLACEMENT ? m->V : m->D;
    double factor = kind == KICK_DISPLACEMENT ? size : size * m->options.dt;
    int held[6];
    double keep[6];

    model_prescribed(m->model, held);
    for (int i = 0; i < 6; i++)
        keep[i] = to[held[i]];
    for (size_t i = 0; i < model_unknowns(m->model); i++)
        to[i] += factor * shape[i];
    for (int i = 0; i < 6; i++)
        to[held[i]] = keep[i];
}

/* Internal forces; looks for slack places and at the bound of the stable step. */
static enum status forces(struct march *m)
{
    struct strain_watch watch;
    double w = m->options.dt * m->omega_max, stretched;

    model_force(m->model, m->options.terms, m->V, m->F, &watch);
    m->stiffened = watch.most_stiffened;
    if (watch.least_force < 0 && m->slack_time < 0) {
        m->slack_time = march_time(m);
        m->slack_theta = model_gauss_theta(m->model, watch.least_point);
    }
    stretched = m->options.terms > 0 ? fmax(0, watch.most_stiffened) : 0;
    return isfinite(watch.most_stiffened) && w * w * (1 + stretched) <= 4 ? SW_OK : SW_DIVERGED;
}

enum status march_solve(struct march *m)
{
    double next[6], dd[6];
    enum status s = forces(m);
    int held[6];

    if (s != SW_OK)
        return s;
    model_prescribed(m->model, held);
    supports(m, (double)(m->step + 1) * m->options.dt, next, NULL, NULL);
    for (int i = 0; i < 6; i++) /* from V itself: round-off does not add up */
        dd[i] = next[i] - m->V[held[i]] - m->D[held[i]];
    for (int i = 0; i < 2; i++) {
        right_side(m, &m->part[i]);
        solve_held(&m->part[i], &m->part[i].A, &m->part[i].factor, dd);
        scatter(&m->part[i], m->part[i].x, m->dd);
    }
    return SW_OK;
}

void march_support_force(const struct march *m, double ret[6])
{
    const struct line *s = &m->model->line;
    double force[6] = {-s->H, -s->V, 0, s->H, s->V - s->W, 0};

    for (int part = 0; part < 2; part++) {
        const struct march_part *p = &m->part[part];

        for (int i = 0; i < p->n_held; i++) {
            double R = -p->residual[i];

            for (int j = p->held[i] - p->A.kd; j <= p->held[i] + p->A.kd; j++)
                if (j >= 0 && j < p->A.n)
                    R += band_get(&p->A, p->held[i], j) * p->x[j];
            force[support_component(p, i)] += R;
        }
    }
    axes_to_space(&m->model->axes, force, ret);
    axes_to_space(&m->model->axes, force + 3, ret + 3);
}

void march_advance(struct march *m)
{
    for (size_t i = 0; i < model_unknowns(m->model); i++) {
        m->D[i] += m->dd[i];
        m->V[i] += m->D[i];
    }
    m->step++;
}
