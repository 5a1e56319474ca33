/* Newton on the exact conditions of equilibrium. */
#include "phys/balance.h"

#include "num/jacobi.h"
#include "phys/room.h"
#include "phys/space.h"

#include <math.h>
#include <string.h>

enum { NEWTON_STEPS = 60 };

static const double balanced = 1e-14; /* what is asked of forces and lengths */
static const double good = 1e-11;     /* what is good enough when it cannot get there */
static const double wrong_by =
    1e-10; /* a push, or a length too long, that changes the active ones */

int balance_rigid(const struct gear *s, int k)
{
    return isinf(s->sling[k].EA);
}

void balance_at(const struct balance *w, struct potential *p)
{
    struct sling_law law[GEAR_SLINGS];

    potential_laws(w->s, w->force, law);
    potential_at(w->s, w->pose, &w->f, law, p);
}

void balance_forces(struct balance *w, struct potential *p, double *c, struct nullspace *f)
{
    double A[GEAR_FREE * GEAR_SLINGS], b[GEAR_FREE], x[GEAR_SLINGS] = {0};
    int n = w->f.n, m = 0;

    memset(w->force, 0, sizeof w->force);
    balance_at(w, p);
    for (int k = 0; k < w->s->slings; k++)
        if (w->active[k]) {
            c[m] = p->length[k] - w->s->sling[k].length;
            memcpy(A + n * m++, p->J + n * k, (size_t)n * sizeof *A);
        }
    for (int i = 0; i < n; i++)
        b[i] = -p->gradient[i];
    nullspace_of(n, m, A, 1e-9, f);
    nullspace_solve(f, b, x);
    for (int k = w->s->slings - 1; k >= 0; k--)
        w->force[k] = w->active[k] ? x[--m] : 0;
    balance_at(w, p);
}

/*
 * q -= Z (Z^T H Z)^{-1} Z^T r over the room Z that the active lengths leave.  Neutral motions are
 * not in it; other directions without curvature are left alone.
 */
static enum status add_tangential(const struct balance *w, const struct potential *p,
                                  const double *r, double *q)
{
    struct room room;
    double held[GEAR_SLINGS], A[GEAR_FREE * GEAR_FREE], X[GEAR_FREE * GEAR_FREE];
    double lambda[GEAR_FREE], force[GEAR_FREE];
    enum status s;

    for (int k = 0; k < w->s->slings; k++)
        held[k] = w->active[k];
    room_of(w->s, w->pose, &w->f, p, held, 0.5, NULL, &room);
    room_project(&room, p->H, A);
    s = jacobi_symmetric(room.m, A, lambda, X);
    for (int i = 0; i < room.m; i++) {
        force[i] = 0;
        for (int l = 0; l < p->n; l++)
            force[i] += room.Z[l + i * p->n] * r[l];
    }
    for (int k = 0; k < room.m && s == SW_OK; k++) {
        double b = 0;

        for (int i = 0; i < room.m; i++)
            b -= X[i + k * room.m] * force[i];
        if (fabs(lambda[k]) <= 1e-11)
            continue;
        for (int i = 0; i < room.m; i++)
            for (int l = 0; l < p->n; l++)
                q[l] += room.Z[l + i * p->n] * X[i + k * room.m] * b / lambda[k];
    }
    return s;
}

/* One step of Newton: lengths first (shortest motion), then forces. */
static enum status newton_step(struct balance *w, const struct potential *p, const double *c,
                               const struct nullspace *f)
{
    double minus[GEAR_SLINGS], q[GEAR_FREE], r[GEAR_FREE], size;
    enum status s;

    for (int k = 0; k < f->m; k++)
        minus[k] = -c[k];
    nullspace_transposed(f, minus, q);
    for (int i = 0; i < p->n; i++) {
        r[i] = p->gradient[i];
        for (int j = 0; j < p->n; j++)
            r[i] += p->H[i + j * p->n] * q[j];
    }
    s = add_tangential(w, p, r, q);
    size = largest(p->n, q);
    for (int i = 0; i < p->n && size > 0.2; i++)
        q[i] *= 0.2 / size;
    pose_move(&w->f, q, w->pose);
    w->steps++;
    return s;
}

/* Newton with the active slings, until nothing is gained any more. */
static enum status newton(struct balance *w, struct potential *p)
{
    double c[GEAR_SLINGS] = {0}, before = INFINITY;
    struct nullspace f;

    for (int i = 0; i < NEWTON_STEPS; i++) {
        double error;

        balance_forces(w, p, c, &f);
        error = larger(largest(p->n, p->gradient), largest(f.m, c));
        if (error <= balanced || (error <= good + 50 * w->noise && !(error < before / 2)))
            return SW_OK;
        if (!(error <= 1e3) || newton_step(w, p, c, &f) != SW_OK)
            return SW_NOCONV;
        before = error;
    }
    return SW_NOCONV;
}

/* Drops the rigid sling that pushes most, or holds the one that is most too long; 0: neither. */
static int change_active(struct balance *w, const struct potential *p)
{
    double worst = wrong_by;
    int k = -1;

    for (int i = 0; i < w->s->slings; i++) {
        double wrong = !balance_rigid(w->s, i) ? 0
                       : w->active[i]          ? -w->force[i]
                                               : p->length[i] - w->s->sling[i].length;

        if (wrong > worst) {
            worst = wrong;
            k = i;
        }
    }
    if (k >= 0)
        w->active[k] = !w->active[k];
    return k >= 0;
}

enum status balance_solve(struct balance *w, struct potential *p)
{
    for (int i = 0; i <= 2 * w->s->slings; i++) {
        enum status s = newton(w, p);

        if (s != SW_OK || !change_active(w, p))
            return s;
    }
    return SW_NOCONV;
}
