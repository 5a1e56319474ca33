/* Dividing curved elements. */
#include "phys/divide.h"
#include "num/pi.h"
#include "num/vec3.h"

/*
 * A Bezier curve between both ends with handles h = c/(3 cos^2(beta/2)), c the chord, 2 beta the
 * angle between the tangents: on a circle its middle is on the circle.
 */
struct bezier {
    double p[2][3], handle[2][3];
};

static int bezier_of(const struct station *a, const struct station *b, struct bezier *ret)
{
    double chord[3], sum[3], c, cosine, h;

    for (int i = 0; i < 3; i++) {
        chord[i] = b->x[i] - a->x[i];
        sum[i] = a->A[6 + i] + b->A[6 + i];
    }
    c = vec3_length(chord);
    cosine = vec3_length(sum) / 2; /* of beta */
    if (!(c > 0 && cosine > 1e-3))
        return 0;
    h = 2 * c / (3 * (1 + cosine));
    for (int i = 0; i < 3; i++) {
        ret->p[0][i] = a->x[i];
        ret->p[1][i] = b->x[i];
        ret->handle[0][i] = a->x[i] + h * a->A[6 + i];
        ret->handle[1][i] = b->x[i] - h * b->A[6 + i];
    }
    return 1;
}

/* Point and unit tangent at u. */
static void bezier_at(const struct bezier *b, double u, double x[3], double t[3])
{
    double v = 1 - u;

    for (int i = 0; i < 3; i++) {
        double p = b->p[0][i], q = b->handle[0][i], r = b->handle[1][i], s = b->p[1][i];

        x[i] = v * v * v * p + 3 * v * v * u * q + 3 * v * u * u * r + u * u * u * s;
        t[i] = v * v * (q - p) + 2 * v * u * (r - q) + u * u * (s - r);
    }
    vec3_scale(1 / vec3_length(t), t);
}

/* The section frame of the global tangent t in the bow, psi being what it is at u. */
static void frame_at(const struct bow *b, double u, const double t[3], double A[9])
{
    double local[3], C[9];

    mat3_apply(b->B, t, local);
    bow_frame(local, bow_psi(b, u), C);
    mat3_multiply(C, b->B, A);
}

/* How far psi in the middle of a piece, where the frame is A, lies beyond the mean of its ends. */
static double bulge_of(const struct station *a, const struct station *b, const double A[9])
{
    struct bow bow;
    double C[9], psi, mean;

    bow_between(a->x, b->x, a->A, b->A, a->twist, 0, &bow);
    mat3_multiply_nt(A, bow.B, C);
    psi = atan2(C[1] - C[3], C[0] + C[4]);
    mean = (bow.psi[0] + bow.psi[1]) / 2;
    return psi - mean - 2 * PI * floor((psi - mean) / (2 * PI) + 0.5);
}

/* Whether the piece is within the angles. */
static int is_small(const struct station *a, const struct station *b, double angle)
{
    struct bow bow;

    return bow_between(a->x, b->x, a->A, b->A, a->twist, a->bulge, &bow) <= angle &&
           fabs(bow.psi[1] - bow.psi[0]) + 4 * fabs(bow.bulge) <= 3 * angle;
}

/* Appends the pieces from *a on, without their end; their number so far, or 0. */
static int append(const struct station *a, const struct station *b, double angle,
                  struct station *ret, int n)
{
    struct station first = *a, middle;
    struct bezier curve;
    struct bow bow;
    double x[3], t[3], A[2][9];

    if (is_small(a, b, angle)) {
        if (n == DIVIDE_MOST)
            return 0;
        ret[n] = *a;
        return n + 1;
    }
    if (n == DIVIDE_MOST || !bezier_of(a, b, &curve) ||
        !(bow_between(a->x, b->x, a->A, b->A, a->twist, a->bulge, &bow) < PI))
        return 0;
    for (int side = 0; side < 2; side++) {
        bezier_at(&curve, 0.25 + 0.5 * side, x, t);
        frame_at(&bow, 0.25 + 0.5 * side, t, A[side]);
    }
    bezier_at(&curve, 0.5, middle.x, t);
    frame_at(&bow, 0.5, t, middle.A);
    first.twist = bow_psi(&bow, 0.5) - bow.psi[0];
    middle.twist = bow.psi[1] - bow_psi(&bow, 0.5);
    middle.bulge = bulge_of(&middle, b, A[1]);
    first.bulge = bulge_of(&first, &middle, A[0]);
    n = append(&first, &middle, angle, ret, n);
    return n > 0 ? append(&middle, b, angle, ret, n) : 0;
}

int divide(const struct station *a, const struct station *b, double angle, struct station *ret)
{
    int n = append(a, b, angle, ret, 0);

    if (n > 0)
        ret[n] = *b;
    return n;
}
