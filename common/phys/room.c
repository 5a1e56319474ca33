/* Null space of the taut rigid slings, and neutral motions. */
#include "phys/room.h"

#include "phys/space.h"

#include <math.h>
#include <string.h>

/* Points nearer than this to a line, of the greatest distance, lie on it. */
static const double aligned = 1e-10;

static int used(const struct gear *s, int point)
{
    for (int k = 0; k < s->slings; k++)
        if (s->sling[k].from == point || s->sling[k].to == point)
            return 1;
    return 0;
}

/* The vertical through all hooks goes through x, y of ret; 0: there is none. */
static int hooks_line(const struct gear *s, double length, double ret[3])
{
    int found = 0;

    for (int p = 0; p < s->points; p++) {
        const double *x = s->point[p].at;

        if (s->point[p].body >= 0 || !used(s, p))
            continue;
        if (!found)
            memcpy(ret, x, 3 * sizeof *ret);
        else if (!(hypot(x[0] - ret[0], x[1] - ret[1]) <= aligned * length))
            return 0;
        found = 1;
    }
    return found;
}

/* Unit direction, as drawn, of the line through the centre of gravity of b and all its points; 0:
 * there is none. */
static int points_line(const struct gear *s, int b, double length, double ret[3])
{
    double most = 0;

    for (int turn = 0; turn < 2; turn++)
        for (int p = 0; p < s->points; p++) {
            double d[3], side[3];

            if (s->point[p].body != b || !used(s, p))
                continue;
            subtract(s->point[p].at, s->body[b].cg, d);
            if (turn == 0 && dot(d, d) > most * most) {
                most = sqrt(dot(d, d));
                for (int i = 0; i < 3; i++)
                    ret[i] = d[i] / most;
            }
            cross(ret, d, side);
            if (turn == 1 && !(sqrt(dot(side, side)) <= aligned * length))
                return 0;
        }
    for (int k = 0; k < s->slings; k++)
        if (s->sling[k].corners > 0 && s->sling[k].leans == b)
            return 0;
    return most > aligned * length;
}

/* Column t: turn of everything about the vertical through x. */
static void yaw(const struct pose *pose, const struct freedom *f, const double x[3], double *t)
{
    for (int c = 0; c < f->n; c++) {
        const double *r = pose[f->body[c]].r;

        t[c] = f->axis[c] == 0 ? x[1] - r[1] : f->axis[c] == 1 ? r[0] - x[0] : f->axis[c] == 5;
    }
}

int room_neutral(const struct gear *s, const struct pose *pose, const struct freedom *f, double *T)
{
    double length, weight, x[3];
    int n = 0;

    if (s->planar)
        return 0;
    gear_scale(s, &length, &weight);
    if (hooks_line(s, length, x))
        yaw(pose, f, x, T + f->n * n++);
    for (int b = 0; b < s->bodies; b++) {
        double d[3] = {0}, now[3];

        if (!points_line(s, b, length, d))
            continue;
        pose_turned(pose[b].R, d, now);
        for (int c = 0; c < f->n; c++)
            T[c + f->n * n] = f->body[c] == b && f->axis[c] >= 3 ? now[f->axis[c] - 3] : 0;
        n++;
    }
    return n;
}

/* A t for a column t of length n, in place. */
static void multiply(int n, const double *A, double *t)
{
    double y[GEAR_FREE] = {0};

    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++)
            y[i] += A[i + j * n] * t[j];
    memcpy(t, y, (size_t)n * sizeof *t);
}

/* Gradients of the taut rigid slings' lengths as columns of A (n, ...), their number. */
static int taut_slings(const struct gear *s, const struct potential *p, const double *force,
                       double least, double *A)
{
    int taut = 0;

    for (int k = 0; k < s->slings; k++)
        if (isinf(s->sling[k].EA) && force[k] > least)
            memcpy(A + p->n * taut++, p->J + p->n * k, (size_t)p->n * sizeof *A);
    return taut;
}

void room_of(const struct gear *s, const struct pose *pose, const struct freedom *f,
             const struct potential *p, const double *force, double least, const double *metric,
             struct room *ret)
{
    double A[GEAR_FREE * (GEAR_SLINGS + GEAR_BODIES + 1)];
    int n = f->n, taut = taut_slings(s, p, force, least, A), rank, neutral;

    nullspace_of(n, taut, A, 1e-9, &ret->f);
    rank = ret->f.rank;
    taut_slings(s, p, force, least, A);
    neutral = room_neutral(s, pose, f, A + n * taut);
    for (int k = 0; k < neutral && metric; k++)
        multiply(n, metric, A + n * (taut + k));
    if (neutral > 0)
        nullspace_of(n, taut + neutral, A, 1e-9, &ret->f);
    ret->n = n;
    ret->redundant = taut - rank;
    ret->neutral = ret->f.rank - rank;
    ret->m = n - ret->f.rank;
    ret->Z = ret->f.Q + n * ret->f.rank;
}

void room_project(const struct room *r, const double *A, double *ret)
{
    double AZ[GEAR_FREE * GEAR_FREE];
    int n = r->n, m = r->m;

    for (int j = 0; j < m; j++) {
        memcpy(AZ + j * n, r->Z + j * n, (size_t)n * sizeof *AZ);
        multiply(n, A, AZ + j * n);
    }
    for (int i = 0; i < m; i++)
        for (int j = 0; j <= i; j++) {
            double sum = 0;

            for (int l = 0; l < n; l++)
                sum += r->Z[l + i * n] * AZ[l + j * n];
            ret[i + j * m] = ret[j + i * m] = sum;
        }
}
