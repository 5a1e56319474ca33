/* Lifting gear as drawn, its scales, and poses of its bodies. */
#include "phys/gear.h"

#include "phys/path.h"
#include "phys/space.h"

#include <float.h>
#include <math.h>
#include <string.h>

int gear_add_body(struct gear *s, double mass, const double cg[3], const double inertia[3][3])
{
    struct suspended *b = s->body + s->bodies;

    if (s->bodies == GEAR_BODIES)
        return -1;
    b->mass = mass;
    memcpy(b->cg, cg, sizeof b->cg);
    memcpy(b->inertia, inertia, sizeof b->inertia);
    return s->bodies++;
}

int gear_add_point(struct gear *s, int body, double x, double y, double z)
{
    if (s->points == GEAR_POINTS)
        return -1;
    s->point[s->points] = (struct hitch){body, {x, y, z}};
    return s->points++;
}

int gear_add_sling(struct gear *s, int from, int to, double length, double EA)
{
    if (s->slings == GEAR_SLINGS)
        return -1;
    s->sling[s->slings] = (struct tie){.from = from, .to = to, .length = length, .EA = EA};
    if (length == 0)
        gear_tighten(s, s->slings, 0);
    return s->slings++;
}

enum status gear_add_edges(struct gear *s, int k, int body, const double edge[3],
                           const double outward[3], int n, const double corner[][3])
{
    struct tie *t = s->sling + k;
    double along[3], normal[3], size = sqrt(dot(edge, edge)), side;

    if (n > GEAR_CORNERS)
        return SW_ADMISSIBLE;
    subtract(s->point[t->to].at, s->point[t->from].at, along);
    cross(along, outward, normal);
    side = dot(edge, normal);
    if (!(fabs(side) > DBL_EPSILON * size * sqrt(dot(along, along) * dot(outward, outward))))
        return SW_ADMISSIBLE;
    for (int i = 0; i < 3; i++)
        t->edge[i] = edge[i] / copysign(size, side);
    memcpy(t->corner, corner, (size_t)n * sizeof *corner);
    t->corners = n;
    t->leans = body;
    return SW_OK;
}

void gear_tighten(struct gear *s, int k, double stretch)
{
    struct pose pose[GEAR_BODIES];
    struct path path;

    gear_drawn(s, pose);
    path_lay(s, pose, k, &path);
    s->sling[k].length = path.length * (1 - stretch);
}

static int sound_body(const struct suspended *b)
{
    double sum = b->mass + b->cg[0] + b->cg[1] + b->cg[2];

    for (int i = 0; i < 3; i++) {
        if (!(b->inertia[i][i] >= 0))
            return 0;
        for (int j = 0; j < 3; j++) {
            if (!(fabs(b->inertia[i][j] - b->inertia[j][i]) <= 1e-12 * b->inertia[i][i]))
                return 0;
            sum += b->inertia[i][j];
        }
    }
    return b->mass >= 0 && fabs(sum) <= DBL_MAX;
}

static int sound_sling(const struct gear *s, const struct tie *t)
{
    if (t->from < 0 || t->from >= s->points || t->to < 0 || t->to >= s->points || t->corners < 0 ||
        t->corners > GEAR_CORNERS)
        return 0;
    if (t->corners > 0 &&
        (t->leans < 0 || t->leans >= s->bodies || !(fabs(dot(t->edge, t->edge) - 1) <= 1e-12)))
        return 0;
    for (int c = 0; c < t->corners; c++)
        if (!(dot(t->corner[c], t->corner[c]) <= DBL_MAX))
            return 0;
    return t->length > 0 && t->length <= DBL_MAX && t->EA > 0;
}

/* Bodies that hang from a hook over slings, as bits. */
static unsigned reached(const struct gear *s)
{
    unsigned known = 0, before;

    do {
        before = known;
        for (int k = 0; k < s->slings; k++) {
            int a = s->point[s->sling[k].from].body, b = s->point[s->sling[k].to].body;

            if (b >= 0 && (a < 0 || known >> a & 1))
                known |= 1u << b;
            if (a >= 0 && (b < 0 || known >> b & 1))
                known |= 1u << a;
        }
    } while (known != before);
    return known;
}

enum status gear_check(const struct gear *s)
{
    double length, weight;

    if (s->bodies < 1 || !(s->g > 0 && s->g <= DBL_MAX))
        return SW_ADMISSIBLE;
    for (int b = 0; b < s->bodies; b++)
        if (!sound_body(s->body + b))
            return SW_ADMISSIBLE;
    for (int p = 0; p < s->points; p++)
        if (s->point[p].body >= s->bodies || !(dot(s->point[p].at, s->point[p].at) <= DBL_MAX))
            return SW_ADMISSIBLE;
    for (int k = 0; k < s->slings; k++)
        if (!sound_sling(s, s->sling + k))
            return SW_ADMISSIBLE;
    gear_scale(s, &length, &weight);
    if (!(length > 0 && weight > 0 && weight <= DBL_MAX))
        return SW_ADMISSIBLE;
    return reached(s) == (1u << s->bodies) - 1 ? SW_OK : SW_ADMISSIBLE;
}

void gear_scale(const struct gear *s, double *ret_length, double *ret_weight)
{
    *ret_length = *ret_weight = 0;
    for (int p = 1; p < s->points; p++) {
        double d[3];

        subtract(s->point[p].at, s->point[0].at, d);
        *ret_length = fmax(*ret_length, sqrt(dot(d, d)));
    }
    for (int b = 0; b < s->bodies; b++)
        *ret_weight += s->g * s->body[b].mass;
}

static void shrink(double x[3], double factor)
{
    for (int i = 0; i < 3; i++)
        x[i] *= factor;
}

void gear_unit(const struct gear *s, struct gear *ret)
{
    double length, weight;

    gear_scale(s, &length, &weight);
    *ret = *s;
    ret->g = 1;
    for (int b = 0; b < s->bodies; b++) {
        ret->body[b].mass *= s->g / weight;
        shrink(ret->body[b].cg, 1 / length);
        for (int i = 0; i < 3; i++)
            shrink(ret->body[b].inertia[i], s->g / (weight * length * length));
    }
    for (int p = 0; p < s->points; p++)
        shrink(ret->point[p].at, 1 / length);
    for (int k = 0; k < s->slings; k++) {
        ret->sling[k].length /= length;
        ret->sling[k].EA /= weight;
        for (int c = 0; c < s->sling[k].corners; c++)
            shrink(ret->sling[k].corner[c], 1 / length);
    }
}

void gear_drawn(const struct gear *s, struct pose *pose)
{
    memset(pose, 0, (size_t)s->bodies * sizeof *pose);
    for (int b = 0; b < s->bodies; b++)
        for (int i = 0; i < 3; i++) {
            pose[b].r[i] = s->body[b].cg[i];
            pose[b].R[i][i] = 1;
        }
}

void pose_turned(const double A[3][3], const double x[3], double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = dot(A[i], x);
}

void pose_place(const struct gear *s, const struct pose *pose, int body, const double at[3],
                double ret[3])
{
    double d[3];

    if (body < 0) {
        memcpy(ret, at, 3 * sizeof *ret);
        return;
    }
    subtract(at, s->body[body].cg, d);
    pose_turned(pose[body].R, d, ret);
    for (int i = 0; i < 3; i++)
        ret[i] += pose[body].r[i];
}

void gear_freedom(const struct gear *s, int held, struct freedom *ret)
{
    static const int plane[] = {0, 2, 4};

    ret->n = 0;
    for (int b = 0; b < s->bodies; b++)
        for (int i = 0; i < (s->planar ? 3 : 6); i++) {
            int axis = s->planar ? plane[i] : i;

            if (b == held && axis == 4)
                continue;
            ret->body[ret->n] = b;
            ret->axis[ret->n++] = axis;
        }
}

/*
 * R := exp(w^) R, Rodrigues: x + (sin a/a) w x x + ((1 - cos a)/a^2) w x (w x x), a = |w|.
 */
static void turn(const double w[3], double R[3][3])
{
    double a = sqrt(dot(w, w)), half = sin(a / 2);
    double first = a > 0 ? sin(a) / a : 1, second = a > 0 ? 2 * half * half / (a * a) : 0.5;

    for (int j = 0; j < 3; j++) {
        double x[3] = {R[0][j], R[1][j], R[2][j]}, wx[3], wwx[3];

        cross(w, x, wx);
        cross(w, wx, wwx);
        for (int i = 0; i < 3; i++)
            R[i][j] = x[i] + first * wx[i] + second * wwx[i];
    }
}

void pose_move(const struct freedom *f, const double *q, struct pose *pose)
{
    double w[GEAR_BODIES][3] = {{0}};
    int bodies = 0;

    for (int i = 0; i < f->n; i++) {
        if (f->axis[i] < 3)
            pose[f->body[i]].r[f->axis[i]] += q[i];
        else
            w[f->body[i]][f->axis[i] - 3] = q[i];
        bodies = f->body[i] + 1;
    }
    for (int b = 0; b < bodies; b++)
        turn((const double *)w[b], pose[b].R);
}

void pose_tilt(struct pose *pose, double angle)
{
    turn((const double[3]){0, angle, 0}, pose->R);
}

double pose_tilted(const struct pose *pose)
{
    return atan2(-pose->R[2][0], pose->R[0][0]);
}
