/* Central differences in increment form; the common front of both schemes. */
#include "phys/march.h"
#include "num/dense.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double march_critical_step(const struct model *m)
{
    return 2 / model_omega_max(m);
}

static double dot(size_t n, const double *x, const double *y)
{
    double sum = 0;

    for (size_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* b and c of the dampers with a coefficient above 0, room for the rest. */
static enum status dampers_new(const struct model *m, const struct march_options *o,
                               struct march_dampers *ret)
{
    size_t n = model_unknowns(m), r = 0;

    *ret = (struct march_dampers){.r = 0};
    for (int i = 0; i < o->n_dampers; i++)
        r += o->damper[i].coefficient > 0;
    if (r == 0)
        return SW_OK;
    ret->c = mem_doubles(r);
    ret->b = mem_doubles(n * r);
    ret->z = mem_doubles(n * r);
    ret->S = mem_doubles(r * r);
    ret->w = mem_doubles(2 * r);
    if (!ret->c || !ret->b || !ret->z || !ret->S || !ret->w)
        return SW_NOMEM;
    for (int i = 0; i < o->n_dampers; i++) {
        double direction[3];

        if (!(o->damper[i].coefficient > 0))
            continue;
        damper_direction(&o->damper[i], &m->axes, direction);
        model_point_load(m, o->damper[i].position, direction, ret->b + n * (size_t)ret->r);
        ret->c[ret->r++] = o->damper[i].coefficient;
    }
    return SW_OK;
}

/* z = A^{-1} b and S of the dampers. */
static enum status dampers_solve(const struct model *m, const struct march_options *o,
                                 struct inertia *inertia, struct march_dampers *d)
{
    static const double still[6];
    size_t n = model_unknowns(m), r = (size_t)d->r;
    double *zero = model_vector(m), *minus = model_vector(m);
    enum status s = zero && minus ? SW_OK : SW_NOMEM;

    for (size_t i = 0; i < r && s == SW_OK; i++) {
        for (size_t j = 0; j < n; j++)
            minus[j] = -d->b[n * i + j];
        inertia_solve(inertia, minus, zero, still, d->z + n * i);
    }
    for (size_t i = 0; i < r && s == SW_OK; i++)
        for (size_t j = 0; j < r; j++)
            d->S[i + r * j] =
                dot(n, d->b + n * i, d->z + n * j) + (i == j ? 2 * o->dt / d->c[i] : 0);
    if (s == SW_OK && r > 0)
        s = dense_invert((int)r, d->S);
    free(zero);
    free(minus);
    return s;
}

enum status march_new(const struct model *m, const struct march_options *o, struct march *ret)
{
    double dt = o->dt;
    enum status s;

    *ret = (struct march){.model = m, .options = *o, .slack_time = -1};
    ret->omega_max = model_omega_max(m);
    ret->V = model_vector(m);
    ret->D = model_vector(m);
    ret->F = model_vector(m);
    ret->dd = model_vector(m);
    ret->W = model_vector(m);
    s = ret->V && ret->D && ret->F && ret->dd && ret->W ? force_new(m, &ret->forces) : SW_NOMEM;
    if (s == SW_OK && o->scheme == SCHEME_CENTRAL)
        s = inertia_new(m, 1 / (dt * dt), 1 / (2 * dt), 1 / dt, o->alpha, o->beta, &ret->inertia);
    if (s == SW_OK)
        s = dampers_new(m, o, &ret->dampers);
    if (s == SW_OK && o->scheme == SCHEME_CENTRAL)
        s = dampers_solve(m, o, &ret->inertia, &ret->dampers);
    if (s == SW_OK && o->scheme == SCHEME_ALPHA)
        s = alpha_new(ret);
    if (s != SW_OK)
        march_free(ret);
    return s;
}

void march_free(struct march *m)
{
    inertia_free(&m->inertia);
    force_free(&m->forces);
    free(m->dampers.c);
    free(m->dampers.b);
    free(m->dampers.z);
    free(m->dampers.S);
    free(m->dampers.w);
    free(m->V);
    free(m->D);
    free(m->F);
    free(m->dd);
    free(m->W);
    alpha_free(m->alpha);
    *m = (struct march){0};
}

double march_time(const struct march *m)
{
    const struct alpha *p = m->alpha;

    return p ? ((double)p->row + (double)p->tick / (double)p->ticks) * m->options.interval
             : (double)m->step * m->options.dt;
}

int march_at_mark(const struct march *m)
{
    return m->alpha ? m->alpha->tick == 0 : m->step % m->options.substeps == 0;
}

long march_mark(const struct march *m)
{
    return m->alpha ? m->alpha->row : m->step / m->options.substeps;
}

double march_past(const struct march *m)
{
    return m->alpha ? m->alpha->past : (double)(m->step - 1) * m->options.dt;
}

void march_supports(const struct march *m, double t, double u[6], double v[6], double a[6])
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

/* F += c b (b^T D)/dt of the dampers. */
static void add_damper_forces(struct march *m)
{
    const struct march_dampers *d = &m->dampers;
    size_t n = model_unknowns(m->model);

    for (size_t i = 0; i < (size_t)d->r; i++) {
        const double *b = d->b + n * i;
        double force = d->c[i] * dot(n, b, m->D) / m->options.dt;

        for (size_t j = 0; j < n; j++)
            m->F[j] += force * b[j];
    }
}

/* dd -= z S^{-1} b^T dd. */
static void add_damper_inertia(struct march *m)
{
    const struct march_dampers *d = &m->dampers;
    size_t n = model_unknowns(m->model), r = (size_t)d->r;

    for (size_t i = 0; i < r; i++)
        d->w[i] = dot(n, d->b + n * i, m->dd);
    for (size_t i = 0; i < r; i++) {
        d->w[r + i] = 0;
        for (size_t j = 0; j < r; j++)
            d->w[r + i] += d->S[i + r * j] * d->w[j];
    }
    for (size_t i = 0; i < r; i++)
        for (size_t j = 0; j < n; j++)
            m->dd[j] -= d->w[r + i] * d->z[j + n * i];
}

/* Velocity from the last increment and the last second difference: second order. */
static const double *lagged_velocity(struct march *m)
{
    for (size_t i = 0; i < model_unknowns(m->model); i++)
        m->W[i] = (m->D[i] + m->dd[i] / 2) / m->options.dt;
    return m->W;
}

/* The internal forces have been put into F: those from outside and of the dampers, too. */
static void add_other_forces(struct march *m)
{
    const struct forcing *f = &m->options.forcing;

    if (f->wind.cd > 0 && !m->alpha)
        lagged_velocity(m);
    if (forcing_any(f))
        forcing_subtract(m->model, f, march_time(m), m->V, m->alpha ? m->alpha->W : m->W, m->F);
    if (!m->alpha) /* else they are part of C */
        add_damper_forces(m);
}

/*
 * Acceleration V'' into m->dd, from M V'' = R - F - C V' with D = V' dt and the supports'
 * accelerations a.
 */
static enum status first_acceleration(struct march *m, const double a[6])
{
    const struct march_options *o = &m->options;
    struct inertia mass;
    enum status s = inertia_new(m->model, 1, 0, 1 / o->dt, o->alpha, o->beta, &mass);

    if (s != SW_OK)
        return s;
    model_force(m->model, o->terms, m->V, m->F, NULL);
    add_other_forces(m);
    inertia_solve(&mass, m->F, m->D, a, m->dd);
    inertia_free(&mass);
    return SW_OK;
}

/* The march has been given V: the same for what belongs to the implicit scheme. */
static void start_alpha(struct march *m, const double *W0, const double v[6])
{
    struct alpha *p = m->alpha;
    size_t n = model_unknowns(m->model);
    int held[6];

    for (size_t i = 0; i < n; i++)
        p->W[i] = W0 ? W0[i] : 0;
    model_prescribed(m->model, held);
    for (int i = 0; i < 6; i++)
        p->W[held[i]] = v[i];
    p->row = p->tick = 0;
    p->past = -1;
    p->settled = 0;
}

enum status march_start(struct march *m, const double *V0, const double *W0)
{
    double u[6], v[6], a[6], past[6], dt = m->options.dt;
    int held[6];
    enum status s;

    march_supports(m, 0, u, v, a);
    march_supports(m, -dt, past, NULL, NULL);
    model_prescribed(m->model, held);
    m->step = 0;
    for (size_t i = 0; i < model_unknowns(m->model); i++) {
        m->V[i] = V0[i];
        m->D[i] = W0 ? dt * W0[i] : 0;
        m->dd[i] = 0;
    }
    for (int i = 0; i < 6; i++) {
        m->V[held[i]] = u[i];
        m->D[held[i]] = dt * v[i];
    }
    if (m->alpha) {
        start_alpha(m, W0, v);
        return SW_OK;
    }
    s = first_acceleration(m, a);
    for (size_t i = 0; i < model_unknowns(m->model); i++) {
        m->dd[i] *= dt * dt;
        m->D[i] -= m->dd[i] / 2; /* V(0) - V(-dt) = dt V' - dt^2/2 V'' */
    }
    for (int i = 0; i < 6; i++)
        m->D[held[i]] = u[i] - past[i];
    return s;
}

void march_kick(struct march *m, enum kick kind, double size, const double *shape)
{
    double *speed = m->alpha ? m->alpha->W : m->D;
    double *to = kind == KICK_DISPLACEMENT ? m->V : speed;
    double factor = kind == KICK_DISPLACEMENT || m->alpha ? size : size * m->options.dt;
    int held[6];
    double keep[6];

    if (m->alpha)
        m->alpha->settled = 0;

    model_prescribed(m->model, held);
    for (int i = 0; i < 6; i++)
        keep[i] = to[held[i]];
    for (size_t i = 0; i < model_unknowns(m->model); i++)
        to[i] += factor * shape[i];
    for (int i = 0; i < 6; i++)
        to[held[i]] = keep[i];
}

/* Time and place of the first compression, found by the plain element forces. */
static void find_slack(struct march *m)
{
    struct strain_watch watch;

    model_force(m->model, m->options.terms, m->V, m->W, &watch);
    m->slack_time = march_time(m);
    m->slack_theta = model_gauss_theta(m->model, watch.least_point);
}

/* Internal forces; looks for slack places and at the bound of the stable step. */
static enum status forces(struct march *m)
{
    struct force_extremes seen;
    double w = m->options.dt * m->omega_max, stretched;

    force_all(&m->forces, m->options.terms, m->V, m->F, &seen);
    m->stiffened = seen.most_stiffened;
    if (seen.least_force < 0 && m->slack_time < 0)
        find_slack(m);
    stretched = m->options.terms > 0 ? fmax(0, seen.most_stiffened) : 0;
    if (m->alpha)
        return isfinite(seen.most_stiffened) ? SW_OK : SW_DIVERGED;
    return isfinite(seen.most_stiffened) && w * w * (1 + stretched) <= 4 ? SW_OK : SW_DIVERGED;
}

enum status march_solve(struct march *m)
{
    double next[6], dd[6];
    enum status s = forces(m);
    int held[6];

    if (s != SW_OK)
        return s;
    if (m->alpha) {
        add_other_forces(m);
        return alpha_settle(m);
    }
    model_prescribed(m->model, held);
    march_supports(m, (double)(m->step + 1) * m->options.dt, next, NULL, NULL);
    for (int i = 0; i < 6; i++) /* from V itself: round-off does not add up */
        dd[i] = next[i] - m->V[held[i]] - m->D[held[i]];
    add_other_forces(m);
    inertia_solve(&m->inertia, m->F, m->D, dd, m->dd);
    add_damper_inertia(m);
    return SW_OK;
}

const double *march_velocity(struct march *m)
{
    return m->alpha ? m->alpha->W : lagged_velocity(m);
}

/* The dampers' part of A dd: c/(2 dt) b (b^T dd) in the rows of the supports. */
static void add_damper_support(const struct march *m, const int held[6], double ret[6])
{
    const struct march_dampers *d = &m->dampers;
    size_t n = model_unknowns(m->model);

    for (size_t i = 0; i < (size_t)d->r; i++) {
        const double *b = d->b + n * i;
        double force = d->c[i] / (2 * m->options.dt) * dot(n, b, m->dd);

        for (int j = 0; j < 6; j++)
            ret[j] += force * b[held[j]];
    }
}

void march_support_change(const struct march *m, double ret[6])
{
    int held[6];

    if (m->alpha) {
        alpha_support(m, ret);
        return;
    }
    model_prescribed(m->model, held);
    inertia_support(&m->inertia, m->F, m->D, m->dd, ret);
    add_damper_support(m, held, ret);
}

void march_support_force(const struct march *m, double ret[6])
{
    const struct line *s = &m->model->line;
    const double at_rest[6] = {-s->H, -s->V, 0, s->H, s->V - s->W, 0};
    double force[6];

    march_support_change(m, force);
    for (int i = 0; i < 6; i++)
        force[i] += at_rest[i];
    axes_to_space(&m->model->axes, force, ret);
    axes_to_space(&m->model->axes, force + 3, ret + 3);
}

enum status march_advance(struct march *m)
{
    if (m->alpha)
        return alpha_advance(m);
    for (size_t i = 0; i < model_unknowns(m->model); i++) {
        m->D[i] += m->dd[i];
        m->V[i] += m->D[i];
    }
    m->step++;
    return SW_OK;
}
