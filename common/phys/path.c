/* Paths of slings round edges. */
#include "phys/path.h"

#include "phys/space.h"

#include <math.h>
#include <string.h>

enum { COLUMNS = GEAR_FREE + GEAR_CORNERS };

/* A corner so little in the way (of the square of the path) that it is touched, no more. */
static const double touch = 1e-13;

static void add_point(const struct pose *pose, int body, int corner, const double x[3],
                      struct path *ret)
{
    int i = ret->n++;

    ret->body[i] = body;
    ret->corner[i] = corner;
    memcpy(ret->x[i], x, sizeof ret->x[i]);
    for (int j = 0; j < 3; j++)
        ret->arm[i][j] = body < 0 ? 0 : x[j] - pose[body].r[j];
}

/* edge . ((q - p) x (c - p)): twice the area by which c is in the way from p to q. */
static double in_the_way(const double edge[3], const double p[3], const double q[3],
                         const double c[3])
{
    double pq[3], pc[3], normal[3];

    subtract(q, p, pq);
    subtract(c, p, pc);
    cross(pq, pc, normal);
    return dot(edge, normal);
}

/* Length of b - a seen along the edges. */
static double seen(const double edge[3], const double a[3], const double b[3])
{
    double d[3], along;

    subtract(b, a, d);
    along = dot(edge, d);
    return sqrt(fmax(0, dot(d, d) - along * along));
}

/* Hull from the end to the other by turning outwards as far as any later corner asks for. */
static void wrap(const struct gear *s, const struct pose *pose, const struct tie *t,
                 const double to[3], struct path *ret)
{
    double corner[GEAR_CORNERS][3], *p = ret->x[0], reach = 0;
    int last = -1;

    for (int c = 0; c < t->corners; c++) {
        pose_place(s, pose, t->leans, t->corner[c], corner[c]);
        reach += seen(ret->edge, corner[c], p);
    }
    reach += seen(ret->edge, to, p);
    for (;;) {
        const double *q = to;
        int next = -1;

        for (int c = last + 1; c < t->corners; c++)
            if (in_the_way(ret->edge, p, q, corner[c]) > touch * reach * reach) {
                q = corner[c];
                next = c;
            }
        if (next < 0)
            return;
        add_point(pose, t->leans, next, q, ret);
        p = ret->x[ret->n - 1];
        last = next;
    }
}

/* The corners in between slide along their edges until the path climbs evenly. */
static void slide(const struct pose *pose, struct path *p)
{
    double at[PATH_POINTS] = {0}, d[3], climb;

    for (int i = 1; i < p->n; i++)
        at[i] = at[i - 1] + seen(p->edge, p->x[i - 1], p->x[i]);
    subtract(p->x[p->n - 1], p->x[0], d);
    climb = dot(p->edge, d) / at[p->n - 1];
    for (int i = 1; i < p->n - 1; i++) {
        double shift;

        subtract(p->x[i], p->x[0], d);
        shift = climb * at[i] - dot(p->edge, d);
        for (int j = 0; j < 3; j++) {
            p->x[i][j] += shift * p->edge[j];
            p->arm[i][j] = p->x[i][j] - pose[p->body[i]].r[j];
        }
    }
}

void path_lay(const struct gear *s, const struct pose *pose, int k, struct path *ret)
{
    const struct tie *t = s->sling + k;
    const struct hitch *a = s->point + t->from, *b = s->point + t->to;
    double x[3];

    ret->n = 0;
    pose_place(s, pose, a->body, a->at, x);
    add_point(pose, a->body, -1, x, ret);
    pose_place(s, pose, b->body, b->at, x);
    if (t->corners > 0) {
        pose_turned(pose[t->leans].R, t->edge, ret->edge);
        wrap(s, pose, t, x, ret);
    }
    add_point(pose, b->body, -1, x, ret);
    if (ret->n > 2)
        slide(pose, ret);
    memset(ret->pull, 0, sizeof ret->pull);
    ret->length = 0;
    for (int i = 1; i < ret->n; i++) {
        double d[3], l;

        subtract(ret->x[i], ret->x[i - 1], d);
        l = sqrt(dot(d, d));
        for (int j = 0; j < 3; j++) {
            ret->pull[i][j] += d[j] / l;
            ret->pull[i - 1][j] -= d[j] / l;
        }
        ret->length += l;
    }
}

/* Motion of point i of the path with free motion c: a shift, or axis x arm. */
static void motion(const struct path *p, int i, const struct freedom *f, int c, double ret[3])
{
    double axis[3] = {0};

    axis[f->axis[c] % 3] = 1;
    if (p->body[i] != f->body[c])
        memset(ret, 0, 3 * sizeof *ret);
    else if (f->axis[c] < 3)
        memcpy(ret, axis, sizeof axis);
    else
        cross(axis, p->arm[i], ret);
}

void path_gradient(const struct path *p, const struct freedom *f, double *g)
{
    for (int c = 0; c < f->n; c++) {
        g[c] = 0;
        for (int i = 0; i < p->n; i++) {
            double x[3];

            motion(p, i, f, c, x);
            g[c] += dot(p->pull[i], x);
        }
    }
}

/* K (n, n) += D^T (I - u u^T) D/l for the segment from point i to i + 1, D (3, n) the motions of
 * its end against its beginning; the last columns are the slides of the corners. */
static void add_segment(const struct path *p, int i, const struct freedom *f, int n, double *K)
{
    double D[COLUMNS][3], along[COLUMNS], u[3], l;

    subtract(p->x[i + 1], p->x[i], u);
    l = sqrt(dot(u, u));
    for (int j = 0; j < 3; j++)
        u[j] /= l;
    for (int c = 0; c < n; c++) {
        double a[3] = {0}, b[3] = {0};

        if (c < f->n) {
            motion(p, i, f, c, a);
            motion(p, i + 1, f, c, b);
        } else if (c - f->n + 1 == i) {
            memcpy(a, p->edge, sizeof a);
        } else if (c - f->n == i) {
            memcpy(b, p->edge, sizeof b);
        }
        subtract(b, a, D[c]);
        along[c] = dot(u, D[c]);
    }
    for (int c = 0; c < n; c++)
        for (int d = 0; d < n; d++)
            K[c + d * n] += (dot(D[c], D[d]) - along[c] * along[d]) / l;
}

/*
 * What a turn w adds in second order: the point goes by w x (w x arm)/2, which pull meets with the
 * second derivatives (pull arm^T + arm pull^T)/2 - (pull . arm) I; and its edge turns, which a
 * slide meets with w . (edge x pull).
 */
static void add_turns(const struct path *p, int i, const struct freedom *f, int n, double *K)
{
    const double *pull = p->pull[i], *arm = p->arm[i];
    double sidewise[3];

    cross(p->edge, pull, sidewise);
    for (int c = 0; c < f->n; c++) {
        int a = f->axis[c] - 3, slide = f->n + i - 1;

        if (f->body[c] != p->body[i] || a < 0)
            continue;
        for (int d = 0; d < f->n; d++) {
            int b = f->axis[d] - 3;

            if (f->body[d] == p->body[i] && b >= 0)
                K[c + d * n] +=
                    (pull[a] * arm[b] + arm[a] * pull[b]) / 2 - (a == b ? dot(pull, arm) : 0);
        }
        if (p->corner[i] >= 0 && slide < n) {
            K[c + slide * n] += sidewise[a];
            K[slide + c * n] += sidewise[a];
        }
    }
}

/* The slides follow the motions so that the length stays least: K_ss is eliminated. */
static void eliminate(int n, int keep, double *K)
{
    for (int k = n - 1; k >= keep; k--)
        for (int c = 0; c < k; c++)
            for (int d = 0; d < k; d++)
                K[c + d * n] -= K[c + k * n] * K[k + d * n] / K[k + k * n];
}

void path_add_hessian(const struct path *p, const struct freedom *f, double factor, double *H)
{
    double K[COLUMNS * COLUMNS] = {0};
    int planar = f->n > 0 && f->axis[0] == 0 && (f->n < 2 || f->axis[1] == 2);
    int n = f->n + (planar ? 0 : p->n - 2);

    for (int i = 0; i < p->n - 1; i++)
        add_segment(p, i, f, n, K);
    for (int i = 0; i < p->n; i++)
        if (p->body[i] >= 0)
            add_turns(p, i, f, n, K);
    eliminate(n, f->n, K);
    for (int c = 0; c < f->n; c++)
        for (int d = 0; d < f->n; d++)
            H[c + d * f->n] += factor * K[c + d * n];
}
