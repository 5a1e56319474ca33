/* Geometry of a curved element. */
#include "phys/bow.h"
#include "num/pi.h"
#include "num/vec3.h"

#define ALONG 1e-12 /* level part of a unit vector that is parallel to z0 */

void bow_axes(const double e[3], double B[9])
{
    double level = hypot(e[0], e[1]);
    double cos_phi = level > ALONG ? e[0] / level : 1, sin_phi = level > ALONG ? e[1] / level : 0;

    B[0] = cos_phi * e[2];
    B[1] = sin_phi * e[2];
    B[2] = -level;
    B[3] = -sin_phi;
    B[4] = cos_phi;
    B[5] = 0;
    B[6] = e[0];
    B[7] = e[1];
    B[8] = e[2];
}

/* (18)-(20): E turns the chord axes into t the shortest way, psi turns about t. */
void bow_frame(const double t[3], double psi, double C[9])
{
    double d = 1 + t[2], c = cos(psi), s = sin(psi);
    const double E1[3] = {1 - t[0] * t[0] / d, -t[0] * t[1] / d, -t[0]};
    const double E2[3] = {-t[0] * t[1] / d, 1 - t[1] * t[1] / d, -t[1]};

    for (int i = 0; i < 3; i++) {
        C[i] = c * E1[i] + s * E2[i];
        C[3 + i] = -s * E1[i] + c * E2[i];
        C[6 + i] = t[i];
    }
}

double bow_between(const double x1[3], const double x2[3], const double A1[9], const double A2[9],
                   double twist, double bulge, struct bow *ret)
{
    const double *const A[2] = {A1, A2};
    double e[3] = {x2[0] - x1[0], x2[1] - x1[1], x2[2] - x1[2]}, angle = 0;

    ret->Lz = vec3_length(e);
    ret->bulge = bulge;
    if (!(ret->Lz > 0))
        return PI;
    vec3_scale(1 / ret->Lz, e);
    bow_axes(e, ret->B);
    for (int i = 0; i < 2; i++) {
        double C[9];

        mat3_multiply_nt(A[i], ret->B, C); /* (16) */
        angle = fmax(angle, atan2(hypot(C[6], C[7]), C[8]));
        ret->slope[i][0] = C[6] / C[8];
        ret->slope[i][1] = C[7] / C[8];
        ret->psi[i] = atan2(C[1] - C[3], C[0] + C[4]);
    }
    twist -= ret->psi[1] - ret->psi[0];
    ret->psi[1] += 2 * PI * floor(twist / (2 * PI) + 0.5);
    return angle;
}

double bow_psi(const struct bow *b, double zeta)
{
    return b->psi[0] + (b->psi[1] - b->psi[0]) * zeta + 4 * b->bulge * zeta * (1 - zeta);
}

void bow_at(const struct bow *b, double zeta, struct bow_point *ret)
{
    double slope[2];

    for (int i = 0; i < 2; i++) { /* (1)-(4) */
        double t1 = b->slope[0][i], t2 = b->slope[1][i];

        ret->p[i] = b->Lz * zeta * (t1 - zeta * (2 * t1 + t2 - zeta * (t1 + t2)));
        slope[i] = t1 - 2 * zeta * (2 * t1 + t2) + 3 * zeta * zeta * (t1 + t2);
    }
    ret->p[2] = b->Lz * zeta;
    ret->dsdz = sqrt(1 + slope[0] * slope[0] + slope[1] * slope[1]);
    ret->t[0] = slope[0] / ret->dsdz;
    ret->t[1] = slope[1] / ret->dsdz;
    ret->t[2] = 1 / ret->dsdz;
    bow_frame(ret->t, bow_psi(b, zeta), ret->C);
}

void bow_global(const struct bow *b, double zeta, double A[9])
{
    struct bow_point q;

    bow_at(b, zeta, &q);
    mat3_multiply(q.C, b->B, A);
}
