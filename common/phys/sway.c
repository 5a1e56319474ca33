/* Small motions about an equilibrium. */
#include "phys/sway.h"

#include "num/jacobi.h"
#include "phys/room.h"

#include <math.h>
#include <string.h>

static const double lightest = 1e-6; /* of the largest mass; length^2 that for moments */
static const double still = 1e-11;   /* tilt by an offset of the length that is none */
static const double pull = 1e-10;    /* a force below this, over the weight, counts as none */

/* I in space: R I0 R^T. */
static void turned_inertia(const struct suspended *b, const struct pose *p, double ret[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            ret[i][j] = 0;
            for (int k = 0; k < 3; k++)
                for (int l = 0; l < 3; l++)
                    ret[i][j] += p->R[i][k] * b->inertia[k][l] * p->R[j][l];
        }
}

/* The least principal moment of I lifted to least: whatever the axes, and not at all if it need
 * not. */
static void lift_inertia(double I[3][3], double least)
{
    double A[9], X[9], lambda[3];

    memcpy(A, I, sizeof A);
    if (jacobi_symmetric(3, A, lambda, X) == SW_OK && lambda[0] < least)
        for (int i = 0; i < 3; i++)
            I[i][i] += least - lambda[0];
}

/* Mass matrix over the free motions, s free of dimension: the largest mass is of order 1. */
static void mass_matrix(const struct gear *s, const struct pose *pose, const struct freedom *f,
                        double *M)
{
    double most = 0;

    for (int b = 0; b < s->bodies; b++)
        most = fmax(most, s->body[b].mass);
    memset(M, 0, (size_t)(f->n * f->n) * sizeof *M);
    for (int c = 0; c < f->n; c++) {
        const struct suspended *b = s->body + f->body[c];
        double I[3][3];

        turned_inertia(b, pose + f->body[c], I);
        lift_inertia(I, lightest * most);
        for (int d = 0; d < f->n; d++)
            if (f->body[d] == f->body[c] && f->axis[c] >= 3 && f->axis[d] >= 3)
                M[c + d * f->n] = I[f->axis[c] - 3][f->axis[d] - 3];
        if (f->axis[c] < 3)
            M[c + c * f->n] = fmax(b->mass, lightest * most);
    }
}

/* Shape of mode k from x (n), with its kinetic energies. */
static void describe(const struct gear *s, const struct freedom *f, const double *M,
                     const double *x, int k, struct sway *ret)
{
    double part[GEAR_BODIES][SWAY_KINDS] = {{0}}, most = -1, sum[GEAR_BODIES] = {0};

    memset(ret->shape[k], 0, sizeof ret->shape[k]);
    memset(ret->share[k], 0, sizeof ret->share[k]);
    for (int c = 0; c < f->n; c++) {
        double Mx = 0, energy;

        for (int d = 0; d < f->n; d++)
            Mx += M[c + d * f->n] * x[d];
        energy = x[c] * Mx;
        ret->shape[k][f->body[c]][f->axis[c]] = x[c];
        ret->share[k][f->axis[c]] += energy;
        part[f->body[c]][f->axis[c]] = energy;
        sum[f->body[c]] += energy;
    }
    for (int b = 0; b < s->bodies; b++)
        if (sum[b] > most) {
            most = sum[b];
            ret->body[k] = b;
        }
    ret->kind[k] = SWING_LENGTHWISE;
    for (int i = 0; i < SWAY_KINDS; i++)
        if (part[ret->body[k]][i] > part[ret->body[k]][ret->kind[k]])
            ret->kind[k] = (enum sway_kind)i;
}

/* Shapes of s free of dimension become those of masses in units of mass and lengths of length. */
static void scale_shapes(double length, double mass, double g, struct sway *ret)
{
    for (int k = 0; k < ret->n; k++) {
        ret->omega2[k] *= g / length;
        for (int b = 0; b < GEAR_BODIES; b++)
            for (int i = 0; i < 6; i++)
                ret->shape[k][b][i] /= sqrt(mass) * (i < 3 ? 1 : length);
    }
}

/* K x = omega^2 M x in the room; the modes over the free motions are Z x. */
enum status sway_of(const struct gear *s, const struct hang *h, struct sway *ret)
{
    double M[GEAR_FREE * GEAR_FREE], K_Z[GEAR_FREE * GEAR_FREE];
    double M_Z[GEAR_FREE * GEAR_FREE], X[GEAR_FREE * GEAR_FREE];
    double force[GEAR_SLINGS], length, weight;
    struct pose pose[GEAR_BODIES];
    struct sling_law law[GEAR_SLINGS];
    struct gear unit;
    struct freedom f;
    struct potential p;
    struct room room;
    enum status status;

    gear_scale(s, &length, &weight);
    gear_unit(s, &unit);
    gear_freedom(&unit, -1, &f);
    for (int k = 0; k < s->slings; k++)
        force[k] = h->force[k] / weight;
    for (int b = 0; b < s->bodies; b++) {
        pose[b] = h->pose[b];
        for (int i = 0; i < 3; i++)
            pose[b].r[i] /= length;
    }
    potential_laws(&unit, force, law);
    potential_at(&unit, pose, &f, law, &p);
    mass_matrix(&unit, pose, &f, M);
    room_of(&unit, pose, &f, &p, force, pull, M, &room);
    room_project(&room, p.H, K_Z);
    room_project(&room, M, M_Z);
    ret->n = room.m;
    ret->neutral = room.neutral;
    status = jacobi_pencil(room.m, K_Z, M_Z, ret->omega2, X);
    for (int k = 0; k < room.m && status == SW_OK; k++) {
        double x[GEAR_FREE] = {0};

        for (int i = 0; i < room.m; i++)
            for (int l = 0; l < f.n; l++)
                x[l] += room.Z[l + i * f.n] * X[i + k * room.m];
        describe(&unit, &f, M, x, k, ret);
    }
    scale_shapes(length, weight / s->g, s->g, ret);
    return status;
}

const char *sway_words(enum sway_kind kind)
{
    static const char *const words[SWAY_KINDS] = {
        "swing lengthwise", "swing crosswise", "heave", "tilt crosswise", "tilt lengthwise", "yaw",
    };

    return words[kind];
}

/* Tilt = sum over the modes of shape (shape . moment)/omega^2, moment = weight of the load times
 * the offset; the signs of both turns cancel. */
double sway_height(const struct gear *s, const struct sway *m, int load, int tilted, int crosswise)
{
    int turn = crosswise ? 3 : 4;
    double tilt = 0, length, weight;

    for (int k = 0; k < m->n; k++)
        tilt += m->shape[k][load][turn] * m->shape[k][tilted][turn] / m->omega2[k];
    tilt *= s->body[load].mass * s->g;
    gear_scale(s, &length, &weight);
    return fabs(tilt) * length > still ? 1 / tilt : INFINITY;
}
