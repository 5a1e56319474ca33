/* Equilibrium: downhill with augmented forces of the rigid slings, then Newton on the exact
 * conditions. */
#include "phys/hang.h"

#include "num/jacobi.h"
#include "phys/balance.h"
#include "phys/descend.h"
#include "phys/room.h"
#include "phys/space.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { ROUNDS = 40 };

static const double pull = 1e-10;     /* a force below this, over the weight, counts as none */
static const double unstable = -1e-9; /* least eigenvalue of what is no minimum */

/* Least eigenvalue of the second derivative in the room and its vector v (n), if v is not NULL.
 * INFINITY: there is no room; NAN: it was not found; v is not set by either. */
static double least_in(const struct room *room, const struct potential *p, double *v)
{
    double A[GEAR_FREE * GEAR_FREE], X[GEAR_FREE * GEAR_FREE];
    double lambda[GEAR_FREE];

    if (room->m == 0)
        return INFINITY;
    room_project(room, p->H, A);
    if (jacobi_symmetric(room->m, A, lambda, X) != SW_OK)
        return NAN;
    for (int l = 0; l < p->n && v; l++) {
        v[l] = 0;
        for (int i = 0; i < room->m; i++)
            v[l] += room->Z[l + i * p->n] * X[i];
    }
    return lambda[0];
}

/* Rigid slings as stiff ones with their present forces, stiff enough to be slack at half of their
 * length; their new forces afterwards.  *off: how far the lengths are off. */
static enum status descend_once(struct balance *w, double stiffness, double *off)
{
    struct sling_law law[GEAR_SLINGS];
    struct potential p;
    enum status s;

    potential_laws(w->s, w->force, law);
    for (int k = 0; k < w->s->slings; k++)
        if (balance_rigid(w->s, k))
            law[k].stiffness = fmax(stiffness, 2 * w->force[k] / w->s->sling[k].length);
    s = descend(w->s, &w->f, law, 1e-6 + 50 * w->noise, w->pose, &w->steps);
    if (s != SW_OK)
        return s;
    potential_at(w->s, w->pose, &w->f, law, &p);
    *off = 0;
    for (int k = 0; k < w->s->slings; k++) {
        if (!balance_rigid(w->s, k))
            continue;
        *off = larger(*off, fabs(p.force[k] - w->force[k]) / law[k].stiffness);
        w->force[k] = p.force[k];
        w->active[k] = p.force[k] > 0;
    }
    return SW_OK;
}

static double distance(const struct gear *s, const struct pose *a, const struct pose *b)
{
    double most = 0;

    for (int i = 0; i < s->bodies; i++) {
        most = larger(most, largest(3, (double[3]){a[i].r[0] - b[i].r[0], a[i].r[1] - b[i].r[1],
                                                   a[i].r[2] - b[i].r[2]}));
        for (int j = 0; j < 9; j++)
            most = larger(most, fabs((&a[i].R[0][0])[j] - (&b[i].R[0][0])[j]));
    }
    return most;
}

/* From a little beyond on either side the way down leads back: v (n), the motion that is unstable
 * while no edge that is just touched is counted. */
static int held_by_contact(const struct balance *w, const double *v)
{
    for (int side = -1; side <= 1; side += 2) {
        struct balance aside = *w;
        double q[GEAR_FREE], off;

        for (int i = 0; i < w->f.n; i++)
            q[i] = side * 1e-3 * v[i];
        pose_move(&w->f, q, aside.pose);
        if (descend_once(&aside, 1e4, &off) != SW_OK ||
            !(distance(w->s, w->pose, aside.pose) < 2e-4))
            return 0;
    }
    return 1;
}

static int leans(const struct gear *s)
{
    for (int k = 0; k < s->slings; k++)
        if (s->sling[k].corners > 0)
            return 1;
    return 0;
}

/* Exact equilibrium near the place that descend_once found: SW_OK only if it is a stable one;
 * otherwise w goes a little along what is unstable. */
static enum status finish(struct balance *w, struct potential *p)
{
    struct balance exact = *w;
    struct room room;
    double v[GEAR_FREE] = {0}, least;

    if (balance_solve(&exact, p) != SW_OK || !(distance(w->s, w->pose, exact.pose) < 0.2))
        return SW_NOCONV;
    room_of(w->s, exact.pose, &w->f, p, exact.force, pull, NULL, &room);
    least = least_in(&room, p, v);
    if (isnan(least))
        return SW_NOCONV;
    if (!(least > unstable)) {
        if (leans(w->s) && held_by_contact(&exact, v)) {
            exact.by_contact = 1;
        } else {
            for (int i = 0; i < w->f.n; i++)
                v[i] *= 1e-2;
            pose_move(&w->f, v, w->pose);
            return SW_NOCONV;
        }
    }
    *w = exact;
    return SW_OK;
}

/* First forces, if none are known: those that balance best at the start, so far as they pull.  With
 * them stiff slings follow the rigid ones from the first step on, and no ridge is crossed. */
static void guess_forces(struct balance *w)
{
    double c[GEAR_SLINGS];
    struct nullspace f;
    struct potential p;

    balance_at(w, &p);
    for (int k = 0; k < w->s->slings; k++)
        w->active[k] = balance_rigid(w->s, k) && p.length[k] >= w->s->sling[k].length * (1 - 1e-6);
    balance_forces(w, &p, c, &f);
}

/* The largest force out of balance and length that is off, with the forces in w. */
static double out_of_balance(const struct balance *w)
{
    struct potential p;
    double most;

    balance_at(w, &p);
    most = largest(p.n, p.gradient);
    for (int k = 0; k < w->s->slings; k++)
        most = larger(most, balance_rigid(w->s, k) ? p.length[k] - w->s->sling[k].length : 0);
    return most;
}

/*
 * Downhill.  A stable equilibrium right beside the start is taken as it is: shallow hollows do not
 * survive slings that are only stiff.
 */
static enum status settle(struct balance *w, struct potential *p)
{
    double stiffness = 300, off;
    struct balance aside = *w;

    if (out_of_balance(w) < 0.3 && finish(&aside, p) == SW_OK) {
        *w = aside;
        return SW_OK;
    }
    for (int k = 0; k < w->s->slings; k++)
        w->force[k] = fmin(fmax(w->force[k], 0), 10);
    for (int i = 0; i < ROUNDS; i++) {
        enum status s = descend_once(w, stiffness, &off);

        if (s != SW_OK)
            return s;
        if (off < 3e-3 && finish(w, p) == SW_OK)
            return SW_OK;
        stiffness = fmin(1e5, 2 * stiffness);
    }
    return SW_NOCONV;
}

/* Residual and moment with the forces as given out, all bodies free. */
static void check_balance(const struct balance *w, int held, struct hang *ret)
{
    struct sling_law law[GEAR_SLINGS];
    struct potential p;
    struct freedom f;

    gear_freedom(w->s, -1, &f);
    potential_laws(w->s, w->force, law);
    potential_at(w->s, w->pose, &f, law, &p);
    ret->residual = ret->moment = 0;
    for (int i = 0; i < f.n; i++)
        if (f.body[i] == held && f.axis[i] == 4)
            ret->moment = p.gradient[i];
        else
            ret->residual = larger(ret->residual, fabs(p.gradient[i]));
    for (int k = 0; k < w->s->slings; k++)
        if (balance_rigid(w->s, k))
            ret->residual = larger(ret->residual, p.length[k] / w->s->sling[k].length - 1);
}

static void give_out(const struct gear *s, const struct balance *w, struct potential *p, int held,
                     struct hang *ret)
{
    struct room room;
    double length, weight, start = 0;

    gear_scale(s, &length, &weight);
    room_of(w->s, w->pose, &w->f, p, w->force, pull, NULL, &room);
    ret->least = least_in(&room, p, NULL);
    ret->neutral = room.neutral;
    ret->indeterminate = room.redundant;
    ret->steps = w->steps;
    ret->by_contact = w->by_contact;
    check_balance(w, held, ret);
    ret->moment *= weight * length;
    for (int b = 0; b < s->bodies; b++) {
        ret->pose[b] = w->pose[b];
        start += w->s->body[b].mass * w->s->body[b].cg[2];
        for (int i = 0; i < 3; i++)
            ret->pose[b].r[i] *= length;
    }
    ret->energy = (p->energy - start) * weight * length;
    for (int k = 0; k < s->slings; k++) {
        ret->force[k] = p->force[k] * weight;
        ret->length[k] = p->length[k] * length;
        ret->contacts[k] = p->contacts[k];
    }
}

/* From the place and forces in w, which are those of s free of dimension. */
static enum status run(const struct gear *s, enum hang_way way, struct balance *w, int held,
                       struct hang *ret)
{
    struct potential p;
    enum status status = way == HANG_DOWN ? settle(w, &p) : balance_solve(w, &p);

    if (status != SW_OK)
        return status;
    for (int k = 0; k < s->slings; k++)
        w->force[k] = w->force[k] > pull ? w->force[k] : 0;
    balance_at(w, &p);
    give_out(s, w, &p, held, ret);
    return ret->residual <= 1e-10 + 50 * w->noise ? SW_OK : SW_NOCONV;
}

/* w at the pose (bodies; NULL: as drawn) of s. */
static enum status begin(const struct gear *s, const struct pose *pose, int held, struct gear *unit,
                         struct balance *w)
{
    double length, weight;

    if (gear_check(s) != SW_OK || (held >= 0 && !s->planar))
        return SW_ADMISSIBLE;
    gear_scale(s, &length, &weight);
    gear_unit(s, unit);
    *w = (struct balance){.s = unit};
    gear_freedom(unit, held, &w->f);
    gear_drawn(unit, w->pose);
    for (int k = 0; k < s->slings; k++)
        if (!balance_rigid(s, k))
            w->noise = fmax(w->noise, DBL_EPSILON * unit->sling[k].EA / unit->sling[k].length);
    for (int b = 0; b < s->bodies && pose; b++) {
        w->pose[b] = pose[b];
        for (int i = 0; i < 3; i++)
            w->pose[b].r[i] /= length;
    }
    return SW_OK;
}

enum status hang(const struct gear *s, enum hang_way way, const struct pose *start, int held,
                 struct hang *ret)
{
    struct gear unit;
    struct balance w;
    enum status status = begin(s, start, held, &unit, &w);

    if (status != SW_OK)
        return status;
    guess_forces(&w);
    return run(s, way, &w, held, ret);
}

enum status hang_on(const struct gear *s, enum hang_way way, const struct hang *before, int held,
                    double angle, struct hang *ret)
{
    struct gear unit;
    struct balance w;
    double length, weight;
    enum status status = begin(s, before->pose, held, &unit, &w);

    if (status != SW_OK)
        return status;
    gear_scale(s, &length, &weight);
    for (int k = 0; k < s->slings; k++) {
        w.force[k] = balance_rigid(s, k) ? before->force[k] / weight : 0;
        w.active[k] = w.force[k] > 0;
    }
    if (held >= 0)
        pose_tilt(w.pose + held, angle);
    return run(s, way, &w, held, ret);
}
