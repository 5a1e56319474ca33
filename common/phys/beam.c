/* The linear curved element. */
#include "phys/beam.h"
#include "num/jacobi.h"
#include "num/vec3.h"

#include <string.h>

#define GAUSS 6 /* points: exact for the straight element, mass included */

static const double node[GAUSS] = {0.033765242898423986, 0.16939530676686776, 0.38069040695840156,
                                   0.61930959304159849,  0.83060469323313224, 0.96623475710157603};
static const double weight[GAUSS] = {0.085662246189585178, 0.18038078652406930,
                                     0.23395696728634552,  0.23395696728634552,
                                     0.18038078652406930,  0.085662246189585178};

void bow_run_to(const struct bow *b, double zeta, struct bow_run *r)
{
    double from = r->zeta, step = zeta - from;

    for (int k = 0; k < GAUSS && step != 0; k++) {
        struct bow_point q;
        double ds;

        bow_at(b, from + node[k] * step, &q);
        ds = weight[k] * step * b->Lz * q.dsdz;
        r->s += ds;
        vec3_add(ds, q.p, r->c);
    }
    r->zeta = zeta;
}

/* Ce X of (29), (30), (4, 6): section forces at a point by forces at the origin o of their levers,
 * which act on the part that ends with the section. */
static void transfer(const struct bow_point *at, const double o[3], double Y[24])
{
    const double lever[3] = {at->p[0] - o[0], at->p[1] - o[1], at->p[2] - o[2]};

    for (int j = 0; j < 3; j++) {
        const double e[3] = {j == 0, j == 1, j == 2};
        double M[3];

        vec3_cross(lever, e, M); /* (22)-(24) */
        Y[4 * j] = -at->t[j];    /* (25) */
        mat3_apply(at->C, M, Y + 4 * j + 1);
        Y[4 * (j + 3)] = 0;
        for (int i = 0; i < 3; i++)
            Y[4 * (j + 3) + 1 + i] = -at->C[3 * i + j];
    }
}

/* F (6, n) += ds Z^T H Y, Z (4, 6), Y (4, n). */
static void add_work(double ds, const double Z[24], const double H[16], const double *Y, int n,
                     double *F)
{
    for (int j = 0; j < n; j++) {
        double HY[4];

        for (int i = 0; i < 4; i++)
            HY[i] = ds * (H[i] * Y[4 * j] + H[i + 4] * Y[4 * j + 1] + H[i + 8] * Y[4 * j + 2] +
                          H[i + 12] * Y[4 * j + 3]);
        for (int i = 0; i < 6; i++)
            F[i + 6 * j] += Z[4 * i] * HY[0] + Z[4 * i + 1] * HY[1] + Z[4 * i + 2] * HY[2] +
                            Z[4 * i + 3] * HY[3];
    }
}

/* Section forces (4, 3) by unit loads along the axes on the curve from end 1 to there. */
static void transfer_loads(const struct bow_point *at, const struct bow_run *r, double Y[12])
{
    for (int j = 0; j < 3; j++) {
        const double e[3] = {j == 0, j == 1, j == 2};
        const double lever[3] = {r->s * at->p[0] - r->c[0], r->s * at->p[1] - r->c[1],
                                 r->s * at->p[2] - r->c[2]};
        double M[3];

        vec3_cross(lever, e, M);
        Y[4 * j] = -r->s * at->t[j];
        mat3_apply(at->C, M, Y + 4 * j + 1);
    }
}

/* K = F^-1, scaled to a unit diagonal: metres and radians. */
static enum status invert(const double F[36], double K[36])
{
    double A[36], scale[6];

    for (int i = 0; i < 6; i++)
        scale[i] = 1 / sqrt(F[7 * i]);
    for (int j = 0; j < 6; j++)
        for (int i = 0; i < 6; i++)
            A[i + 6 * j] = scale[i] * F[i + 6 * j] * scale[j];
    if (cholesky_factor(6, A, 1e-15) != SW_OK)
        return SW_INDEFINITE;
    for (int j = 0; j < 6; j++) {
        double x[6] = {0};

        x[j] = scale[j];
        cholesky_forward(6, A, x);
        cholesky_backward(6, A, x);
        for (int i = 0; i < 6; i++)
            K[i + 6 * j] = scale[i] * x[i];
    }
    for (int j = 0; j < 6; j++)
        for (int i = 0; i < j; i++)
            K[i + 6 * j] = K[j + 6 * i] = (K[i + 6 * j] + K[j + 6 * i]) / 2;
    return SW_OK;
}

enum status beam_new(const struct bow *bow, const struct section *section, struct beam *ret)
{
    static const double origin[3] = {0, 0, 0};
    struct bow_run r = {.zeta = 0};
    double F[36] = {0};

    *ret = (struct beam){.bow = *bow};
    for (int k = 0; k < GAUSS; k++) {
        struct bow_point q;
        double Y[24], Q[12], ds;

        bow_run_to(bow, node[k], &r);
        bow_at(bow, node[k], &q);
        ds = weight[k] * bow->Lz * q.dsdz;
        transfer(&q, origin, Y);
        transfer_loads(&q, &r, Q);
        add_work(ds, Y, section->flexibility, Y, 6, F); /* (31) */
        add_work(ds, Y, section->flexibility, Q, 3, ret->spread);
    }
    bow_run_to(bow, 1, &r);
    ret->length = r.s;
    for (int i = 0; i < 3; i++)
        ret->S[i] = r.c[i] - (i == 2 ? r.s * bow->Lz : 0);
    return invert(F, ret->K);
}

/* T^T (12, 6) of (33): both ends' forces by those of end 1. */
static void balance(const struct beam *b, double T[72])
{
    memset(T, 0, 72 * sizeof *T);
    for (int i = 0; i < 6; i++) {
        T[i + 12 * i] = 1;
        T[i + 6 + 12 * i] = -1;
    }
    T[9 + 12 * 1] = -b->bow.Lz;
    T[10 + 12 * 0] = b->bow.Lz;
}

/* A (n blocks of 3, n blocks) := G^T A G, G = diag(B, B, ...). */
static void to_global(const double B[9], int n, double *A)
{
    for (int J = 0; J < n; J++)
        for (int I = 0; I < n; I++) {
            double block[9], half[9], *at = A + 3 * I + 3 * n * 3 * J;

            for (int i = 0; i < 9; i++)
                block[i] = at[i / 3 + 3 * n * (i % 3)];
            mat3_multiply_tn(B, block, half);
            mat3_multiply(half, B, block);
            for (int i = 0; i < 9; i++)
                at[i / 3 + 3 * n * (i % 3)] = block[i];
        }
}

void beam_stiffness(const struct beam *b, double K[144])
{
    double T[72], TK[72];

    balance(b, T);
    memset(TK, 0, sizeof TK);
    memset(K, 0, 144 * sizeof *K);
    for (int j = 0; j < 6; j++)
        for (int l = 0; l < 6; l++)
            for (int i = 0; i < 12; i++)
                TK[i + 12 * j] += T[i + 12 * l] * b->K[l + 6 * j];
    for (int j = 0; j < 12; j++)
        for (int l = 0; l < 6; l++)
            for (int i = 0; i < 12; i++)
                K[i + 12 * j] += TK[i + 12 * l] * T[j + 12 * l];
    to_global(b->bow.B, 4, K);
}

/* Held ends: end 1 pushes back what the load moves it by; end 2 takes the rest. */
void beam_loads(const struct beam *b, const double q[3], double ret[12])
{
    double local[3], T[72], f[6], p[12], M[3];

    mat3_apply(b->bow.B, q, local);
    for (int i = 0; i < 6; i++) {
        double u[6];

        for (int k = 0; k < 6; k++)
            u[k] = b->spread[k] * local[0] + b->spread[k + 6] * local[1] +
                   b->spread[k + 12] * local[2];
        f[i] = 0;
        for (int k = 0; k < 6; k++)
            f[i] += b->K[i + 6 * k] * u[k];
    }
    balance(b, T);
    for (int i = 0; i < 12; i++) {
        p[i] = 0;
        for (int k = 0; k < 6; k++)
            p[i] += T[i + 12 * k] * f[k];
    }
    vec3_cross(b->S, local, M);
    for (int i = 0; i < 3; i++) {
        p[6 + i] += b->length * local[i];
        p[9 + i] += M[i];
    }
    for (int k = 0; k < 4; k++)
        mat3_apply_t(b->bow.B, p + 3 * k, ret + 3 * k);
}

void beam_section(const struct bow *b, const struct bow_run *at, const double F[3],
                  const double M[3], const double q[3], double ret[4])
{
    struct bow_point here;
    double f[3], m[3], ql[3], lever[3], moment[3], part[3];

    bow_at(b, at->zeta, &here);
    mat3_apply(b->B, F, f);
    mat3_apply(b->B, M, m);
    mat3_apply(b->B, q, ql);
    vec3_cross(here.p, f, moment);
    for (int i = 0; i < 3; i++) {
        lever[i] = at->s * here.p[i] - at->c[i];
        f[i] += at->s * ql[i];
    }
    vec3_cross(lever, ql, part);
    for (int i = 0; i < 3; i++)
        moment[i] += part[i] - m[i];
    ret[0] = -vec3_dot(f, here.t);
    mat3_apply(here.C, moment, ret + 1);
}

/* Displacement and rotation (6, 12) of the point at zeta by those of the ends: rigid with end 2,
 * and what the forces bring that move end 1. */
static void shape(const struct beam *b, const struct section *section, double zeta, double N[72])
{
    struct bow_point at;
    double F[36] = {0}, FK[36] = {0}, T[72];

    bow_at(&b->bow, zeta, &at);
    for (int k = 0; k < GAUSS; k++) {
        static const double origin[3] = {0, 0, 0};
        struct bow_point q;
        double Y[24], Z[24];

        bow_at(&b->bow, zeta + node[k] * (1 - zeta), &q);
        transfer(&q, origin, Y);
        transfer(&q, at.p, Z);
        add_work(weight[k] * (1 - zeta) * b->bow.Lz * q.dsdz, Z, section->flexibility, Y, 6, F);
    }
    for (int j = 0; j < 6; j++)
        for (int l = 0; l < 6; l++)
            for (int i = 0; i < 6; i++)
                FK[i + 6 * j] += F[i + 6 * l] * b->K[l + 6 * j];
    balance(b, T);
    memset(N, 0, 72 * sizeof *N);
    for (int j = 0; j < 12; j++)
        for (int l = 0; l < 6; l++)
            for (int i = 0; i < 6; i++)
                N[i + 6 * j] += FK[i + 6 * l] * T[j + 12 * l];
    for (int j = 0; j < 3; j++) { /* u2 + phi2 x (p - p2), phi2 */
        const double e[3] = {j == 0, j == 1, j == 2},
                     lever[3] = {at.p[0], at.p[1], at.p[2] - b->bow.Lz};
        double u[3];

        vec3_cross(e, lever, u);
        N[j + 6 * (6 + j)] += 1;
        N[3 + j + 6 * (9 + j)] += 1;
        for (int i = 0; i < 3; i++)
            N[i + 6 * (9 + j)] += u[i];
    }
}

void beam_mass(const struct beam *b, const struct section *section, double M[144])
{
    memset(M, 0, 144 * sizeof *M);
    for (int k = 0; k < GAUSS; k++) {
        struct bow_point at;
        double N[72], D[72], ds;

        bow_at(&b->bow, node[k], &at);
        shape(b, section, node[k], N);
        ds = weight[k] * b->bow.Lz * at.dsdz;
        for (int j = 0; j < 12; j++) { /* displacement, then rotation in section axes */
            memcpy(D + 6 * j, N + 6 * j, 3 * sizeof *D);
            mat3_apply(at.C, N + 6 * j + 3, D + 6 * j + 3);
        }
        for (int j = 0; j < 12; j++)
            for (int i = 0; i < 12; i++)
                for (int c = 0; c < 6; c++)
                    M[i + 12 * j] += ds * (c < 3 ? section->mass : section->inertia[c - 3]) *
                                     D[c + 6 * i] * D[c + 6 * j];
    }
    to_global(b->bow.B, 4, M);
}
