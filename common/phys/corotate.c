/* Exact end forces and stiffness of the curved element. */
#include "phys/corotate.h"
#include "num/quat.h"
#include "num/vec3.h"

#define SMALL 0.01 /* of |w|^2: series below; the terms left out are under 1e-13 */

struct corotate corotate_beam(const struct beam *b)
{
    return (struct corotate){.B = b->bow.B,
                             .K = b->K,
                             .D = {0, 0, -b->bow.Lz},
                             .chord = 1,
                             .spread = b->spread,
                             .S = b->S,
                             .length = b->length};
}

/* Functions of x = |w|^2, a = |w|, and their derivatives by x. */
struct turning {
    double g, g_x; /* tan(a/2)/a */
    double t, t_x; /* a/sin(a) */
    double h, h_x; /* (1 - t)/x */
};

static struct turning turning_of(double x)
{
    struct turning f;

    if (x < SMALL) {
        f.g = 1.0 / 2 + x * (1.0 / 24 + x * (1.0 / 240 + x * (17.0 / 40320 + x * 31.0 / 725760)));
        f.g_x = 1.0 / 24 + x * (1.0 / 120 + x * (17.0 / 13440 + x * 31.0 / 181440));
        f.h = -(1.0 / 6 +
                x * (7.0 / 360 + x * (31.0 / 15120 + x * (127.0 / 604800 + x * 73.0 / 3421440))));
        f.h_x = -(7.0 / 360 + x * (31.0 / 7560 + x * (127.0 / 201600 + x * 73.0 / 855360)));
        f.t = 1 - f.h * x;
        f.t_x = -f.h - f.h_x * x;
    } else {
        double a = sqrt(x), s = sin(a), c = cos(a), half = cos(a / 2);

        f.g = tan(a / 2) / a;
        f.g_x = (a - s) / (4 * x * a * half * half);
        f.t = a / s;
        f.t_x = (s - a * c) / (2 * a * s * s);
        f.h = (1 - f.t) / x;
        f.h_x = -(f.t_x + f.h) / x;
    }
    return f;
}

/* What is known of the element where it is. */
struct place_of {
    double w[3];              /* half the turn of end 1 against end 2 */
    double r[3];              /* end 1 - end 2 in element axes */
    double ql[3];             /* load in element axes */
    double f[6];              /* forces at end 1 */
    double H[9], hz, g[3];    /* strain h by r, dh = H dr; H^T f1, the force on end 1 */
    double L, bend[3];        /* chord; dh_z/dw */
    double y[3];              /* where the load acts */
    double m[3], mw[3], n[3]; /* moments that turn all, that bend, and half the difference */
    struct turning by;
};

/*
 * H = I, but for the chord.  Its strain is that of the bent axis between the ends,
 *     h_z = -|r| - L (rho/10 + (w_x^2 + w_y^2)/6),  rho = (r_x^2 + r_y^2)/|r|^2,
 * the length that a cubic with end slopes s + w, s - w has beyond its chord, s^2 = rho.
 */
static void strain_by_place(const struct corotate *e, struct place_of *p)
{
    double size = vec3_length(p->r), along = p->r[2] / size;

    memset(p->H, 0, sizeof p->H);
    p->H[0] = p->H[4] = p->H[8] = 1;
    p->hz = p->r[2];
    memset(p->bend, 0, sizeof p->bend);
    if (!e->chord)
        return;
    p->L = -e->D[2];
    p->hz = -size - p->L * ((p->r[0] * p->r[0] + p->r[1] * p->r[1]) / (10 * size * size) +
                            (p->w[0] * p->w[0] + p->w[1] * p->w[1]) / 6);
    for (int i = 0; i < 3; i++) /* d rho = 2 along (along r/|r| - e_z) dr/|r| */
        p->H[6 + i] =
            -p->r[i] / size - p->L / 5 * along / size * (along * p->r[i] / size - (i == 2));
    for (int i = 0; i < 2; i++)
        p->bend[i] = -p->L / 3 * p->w[i];
}

/* f = K (deformation - that of the load). */
static void stretch(const struct corotate *e, const double *q, struct place_of *p,
                    struct corotated *ret)
{
    double spin[3], own[6];

    vec3_cross(p->w, e->D, spin);
    for (int i = 0; i < 3; i++) {
        double h = i == 2 ? p->hz : p->r[i];

        ret->deform[i] = own[i] = h - e->D[i] + spin[i];
        ret->deform[3 + i] = own[3 + i] = 2 * p->w[i];
    }
    if (q)
        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 6; i++)
                own[i] -= e->spread[i + 6 * j] * p->ql[j];
    ret->energy = 0;
    for (int i = 0; i < 6; i++) {
        p->f[i] = 0;
        for (int j = 0; j < 6; j++)
            p->f[i] += e->K[i + 6 * j] * own[j];
        ret->energy += p->f[i] * own[i] / 2;
    }
}

/* y = spread^T f + S - w x S */
static void hang(const struct corotate *e, struct place_of *p)
{
    double turned[3];

    vec3_cross(p->w, e->S, turned);
    for (int i = 0; i < 3; i++) {
        p->y[i] = e->S[i] - turned[i];
        for (int k = 0; k < 6; k++)
            p->y[i] += e->spread[k + 6 * i] * p->f[k];
    }
}

/* g = H^T f1,  m = g x r + q x y,  mw = 2 f2 + D x f1 + f_z bend + S x q,
 * n = [t mw + h w (w.mw)]/2 - (g/2) m x w */
static void turn_moments(const struct corotate *e, const double *q, struct place_of *p)
{
    double cross[3], along;

    mat3_apply_t(p->H, p->f, p->g);
    vec3_cross(p->g, p->r, p->m);
    vec3_cross(e->D, p->f, p->mw);
    vec3_add(2, p->f + 3, p->mw);
    vec3_add(p->f[2], p->bend, p->mw);
    if (q) {
        hang(e, p);
        vec3_cross(p->ql, p->y, cross);
        vec3_add(1, cross, p->m);
        vec3_cross(e->S, p->ql, cross);
        vec3_add(1, cross, p->mw);
    }
    along = p->by.h * vec3_dot(p->w, p->mw);
    vec3_cross(p->m, p->w, cross);
    for (int i = 0; i < 3; i++)
        p->n[i] = (p->by.t * p->mw[i] + along * p->w[i] - p->by.g * cross[i]) / 2;
}

static void hold_ends(const struct corotate *e, const double *q, const struct place_of *p,
                      struct corotated *ret)
{
    double first[3], second[3];

    for (int i = 0; i < 3; i++) {
        first[i] = p->m[i] / 2 + p->n[i];
        second[i] = p->m[i] / 2 - p->n[i];
    }
    mat3_apply(ret->G, p->g, ret->force);
    mat3_apply(ret->G, first, ret->force + 3);
    mat3_apply(ret->G, second, ret->force + 9);
    for (int i = 0; i < 3; i++)
        ret->force[6 + i] = -ret->force[i] - (q ? e->length * q[i] : 0);
}

/*
 * The tangent, by blocks of u (displacement of end 1 against end 2), s = (a1 + a2)/2 and
 * d = a1 - a2 (spins), all in element axes:
 *     dw = P d,  frame's spin a = s + A d,  dr = u - a x r,  P = (t I + h w w^T)/2,  A = -(g/2) w^
 *     (g, m, n) = J^T f,  J = [[H; 0], Y, Y A + Z],  Y = [H r^; 0] - spread q^,  Z = [(e_z bend^T -
 * D^) P; 2 P] K = J^T K J + derivative of J^T and of the axes.
 */
struct blocks {
    double P[9], A[9], W[9];
    double Y[2][9], Z[2][9]; /* upper and lower three rows */
    double uu[9], us[9], ud[9], ss[9], sd[9], dd[9];
};

static void kinematics(const struct corotate *e, const double *q, const struct place_of *p,
                       struct blocks *k)
{
    double skew[9];

    mat3_skew(p->w, k->W);
    for (int i = 0; i < 9; i++) {
        k->A[i] = -p->by.g / 2 * k->W[i];
        k->P[i] = (p->by.h * p->w[i / 3] * p->w[i % 3] + (i % 4 == 0 ? p->by.t : 0)) / 2;
        k->Z[1][i] = 2 * k->P[i];
        k->Y[1][i] = 0;
    }
    mat3_skew(p->r, skew);
    mat3_multiply(p->H, skew, k->Y[0]);
    mat3_skew(e->D, skew);
    mat3_multiply(skew, k->P, k->Z[0]);
    for (int i = 0; i < 9; i++)
        k->Z[0][i] = -k->Z[0][i];
    for (int i = 0; i < 3; i++)
        k->Z[0][6 + i] += p->bend[0] * k->P[i] + p->bend[1] * k->P[3 + i];
    if (q) {
        mat3_skew(p->ql, skew);
        for (int half = 0; half < 2; half++) {
            double U[9], part[9];

            for (int i = 0; i < 9; i++)
                U[i] = e->spread[3 * half + i / 3 + 6 * (i % 3)];
            mat3_multiply(U, skew, part);
            mat3_add(-1, part, k->Y[half]);
        }
    }
    for (int half = 0; half < 2; half++) { /* Z: all columns of d */
        double part[9];

        mat3_multiply(k->Y[half], k->A, part);
        mat3_add(1, part, k->Z[half]);
    }
}

/* J^T K J */
static void material(const double K6[36], const double H[9], struct blocks *k)
{
    double K[2][2][9], KY[2][9], KZ[2][9], part[9];

    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++)
            for (int i = 0; i < 9; i++)
                K[a][b][i] = K6[3 * a + i / 3 + 6 * (3 * b + i % 3)];
    for (int a = 0; a < 2; a++) {
        mat3_multiply(K[a][0], k->Y[0], KY[a]);
        mat3_multiply(K[a][1], k->Y[1], part);
        mat3_add(1, part, KY[a]);
        mat3_multiply(K[a][0], k->Z[0], KZ[a]);
        mat3_multiply(K[a][1], k->Z[1], part);
        mat3_add(1, part, KZ[a]);
    }
    mat3_multiply(K[0][0], H, part);
    mat3_multiply_tn(H, part, k->uu);
    mat3_multiply_tn(H, KY[0], k->us);
    mat3_multiply_tn(H, KZ[0], k->ud);
    mat3_multiply_tn(k->Y[0], KY[0], k->ss);
    mat3_multiply_tn(k->Y[1], KY[1], part);
    mat3_add(1, part, k->ss);
    mat3_multiply_tn(k->Y[0], KZ[0], k->sd);
    mat3_multiply_tn(k->Y[1], KZ[1], part);
    mat3_add(1, part, k->sd);
    mat3_multiply_tn(k->Z[0], KZ[0], k->dd);
    mat3_multiply_tn(k->Z[1], KZ[1], part);
    mat3_add(1, part, k->dd);
}

/* Derivative of n by w at fixed m and mw. */
static void bend_further(const struct place_of *p, double D[9])
{
    const struct turning *f = &p->by;
    double wm[3], M[9], along = vec3_dot(p->w, p->mw);

    vec3_cross(p->w, p->m, wm);
    mat3_skew(p->m, M);
    for (int i = 0; i < 9; i++) {
        int r = i / 3, c = i % 3;

        D[i] = (f->g_x * wm[r] + f->t_x * p->mw[r] + f->h_x * along * p->w[r]) * p->w[c] -
               f->g / 2 * M[i] + f->h / 2 * p->w[r] * p->mw[c];
        if (r == c)
            D[i] += f->h / 2 * along;
    }
}

/*
 * The second derivatives of h_z, times f_z: by r on dr = u + r^ (s + A d), with c = r/|r|,
 *     Q = -(I - c c^T)/|r| - (L/10) rho'',
 *     rho'' = 2/|r|^2 [c_z^2 I - e_z e_z^T + 2 c_z (e_z c^T + c e_z^T) - 4 c_z^2 c c^T],
 * and by w on dw = P d, -L/3 across.
 */
static void string(const struct place_of *p, struct blocks *k)
{
    double size = vec3_length(p->r), z = p->r[2] / size;
    double Q[9], R[9], QR[9], RQR[9], part[9];

    for (int i = 0; i < 9; i++) {
        int a = i / 3, b = i % 3;
        double ca = p->r[a] / size, cb = p->r[b] / size, unit = a == b;
        double rho = 2 / (size * size) *
                     (z * z * unit - (a == 2) * (b == 2) + 2 * z * ((a == 2) * cb + ca * (b == 2)) -
                      4 * z * z * ca * cb);

        Q[i] = -p->f[2] * ((unit - ca * cb) / size + p->L / 10 * rho);
        k->dd[i] -= p->f[2] * p->L / 3 * (k->P[a] * k->P[b] + k->P[3 + a] * k->P[3 + b]);
    }
    mat3_skew(p->r, R);
    mat3_multiply(Q, R, QR);
    mat3_multiply_tn(R, QR, RQR);
    mat3_add(1, Q, k->uu);
    mat3_add(1, QR, k->us);
    mat3_multiply(QR, k->A, part);
    mat3_add(1, part, k->ud);
    mat3_add(1, RQR, k->ss);
    mat3_multiply(RQR, k->A, part);
    mat3_add(1, part, k->sd);
    mat3_multiply_tn(k->A, part, R);
    mat3_add(1, R, k->dd);
}

/* The derivatives of J^T and of the axes at fixed f; halves of what stands on both sides. */
static void geometric(const struct corotate *e, const double *q, const struct place_of *p,
                      struct blocks *k)
{
    double F[9], M[9], N[9], R[9], X[9], QS[9] = {0}, SQ[9] = {0}, V[9], part[9], sd[9], ds[9];

    mat3_skew(p->g, F);
    mat3_skew(p->m, M);
    mat3_skew(p->n, N);
    mat3_skew(p->r, R);
    mat3_multiply(F, R, X);
    if (q) {
        double Q[9], S[9], y[9];

        mat3_skew(p->ql, Q);
        mat3_skew(e->S, S);
        mat3_skew(p->y, y);
        mat3_multiply(y, Q, part);
        mat3_add(-1, part, X);
        mat3_multiply(S, Q, part);
        mat3_multiply(k->P, part, SQ);
        mat3_multiply(Q, S, part);
        mat3_multiply(part, k->P, QS);
    }
    mat3_add(-1, F, k->us); /* u and its transpose agree */
    mat3_multiply(F, k->A, part);
    mat3_add(-1, part, k->ud);
    mat3_add(0.5, X, k->ss);
    mat3_add_t(0.5, X, k->ss);
    memcpy(V, X, sizeof V); /* sd = (X - M^) A + QS,  ds = A^T X + SQ - N^ */
    mat3_add(-1, M, V);
    mat3_multiply(V, k->A, sd);
    mat3_add(1, QS, sd);
    mat3_multiply_tn(k->A, X, ds);
    mat3_add(1, SQ, ds);
    mat3_add(-1, N, ds);
    mat3_add(0.5, sd, k->sd);
    mat3_add_t(0.5, ds, k->sd);
    mat3_multiply(ds, k->A, V); /* dd = ds A + A^T QS + D P */
    mat3_multiply_tn(k->A, QS, part);
    mat3_add(1, part, V);
    bend_further(p, X);
    mat3_multiply(X, k->P, part);
    mat3_add(1, part, V);
    mat3_add(0.5, V, k->dd);
    mat3_add_t(0.5, V, k->dd);
}

/* K's block (I, J) and its mirror := G A G^T, I, J: u1 a1 u2 a2. */
static void put(const double G[9], const double A[9], int I, int J, double *K)
{
    double half[9], B[9];

    mat3_multiply(G, A, half);
    mat3_multiply_nt(half, G, B);
    for (int i = 0; i < 9; i++) {
        K[3 * I + i / 3 + 12 * (3 * J + i % 3)] = B[i];
        K[3 * J + i % 3 + 12 * (3 * I + i / 3)] = B[i];
    }
}

/* From u, s, d to both ends. */
static void spread_out(const double G[9], const struct blocks *k, double *K)
{
    double a11[9], a12[9], a22[9], u1[9], u2[9], minus[9];

    for (int i = 0; i < 9; i++) {
        double sd = k->sd[i], ds = k->sd[3 * (i % 3) + i / 3];

        u1[i] = k->us[i] / 2 + k->ud[i];
        u2[i] = k->us[i] / 2 - k->ud[i];
        a11[i] = k->ss[i] / 4 + (sd + ds) / 2 + k->dd[i];
        a12[i] = k->ss[i] / 4 + (ds - sd) / 2 - k->dd[i];
        a22[i] = k->ss[i] / 4 - (sd + ds) / 2 + k->dd[i];
        minus[i] = -k->uu[i];
    }
    put(G, k->uu, 0, 0, K);
    put(G, minus, 0, 2, K);
    put(G, k->uu, 2, 2, K);
    put(G, u1, 0, 1, K);
    put(G, u2, 0, 3, K);
    put(G, a11, 1, 1, K);
    put(G, a12, 1, 3, K);
    put(G, a22, 3, 3, K);
    for (int i = 0; i < 9; i++) {
        u1[i] = -u1[i];
        u2[i] = -u2[i];
    }
    put(G, u1, 2, 1, K);
    put(G, u2, 2, 3, K);
}

/* Axes, turn and place; what it takes to know the strains. */
static void find_place(const struct corotate *e, const double d[3], const double q1[4],
                       const double q2[4], const double *q, struct corotated *ret,
                       struct place_of *p)
{
    double turn[4], half[4], middle[4], theta[3], R[9];

    quat_between(q2, q1, turn); /* R2^T R1 */
    quat_log(turn, theta);
    quat_half(turn, half);
    quat_multiply(q2, half, middle);
    quat_matrix(middle, R);
    mat3_multiply_nt(R, e->B, ret->G);
    mat3_apply(e->B, theta, p->w);
    vec3_scale(0.5, p->w);
    mat3_apply_t(ret->G, d, p->r);
    p->by = turning_of(vec3_dot(p->w, p->w));
    ret->angle = vec3_length(theta);
    if (q)
        mat3_apply_t(ret->G, q, p->ql);
    strain_by_place(e, p);
    stretch(e, q, p, ret);
}

void corotate(const struct corotate *e, const double d[3], const double q1[4], const double q2[4],
              const double *q, const double *guess, struct corotated *ret, double *K)
{
    struct place_of p;

    if (!e->spread)
        q = NULL;
    find_place(e, d, q1, q2, q, ret, &p);
    turn_moments(e, q, &p);
    hold_ends(e, q, &p, ret);
    if (q) { /* energy of the load, end 2's part left out */
        double turned[3];

        vec3_cross(p.w, e->S, turned);
        ret->energy -= vec3_dot(e->S, p.ql) - vec3_dot(turned, p.ql);
    }
    if (K) {
        struct blocks k;

        kinematics(e, q, &p, &k);
        material(e->K, p.H, &k);
        if (guess) {
            memcpy(p.f, guess, sizeof p.f);
            turn_moments(e, q, &p);
        }
        geometric(e, q, &p, &k);
        if (e->chord)
            string(&p, &k);
        spread_out(ret->G, &k, K);
    }
}

void corotate_foresee(const struct corotate *e, const double d[3], const double q1[4],
                      const double q2[4], const double *q, const double du[12], double f[6])
{
    struct place_of p;
    struct corotated here;
    struct blocks k;
    double u[3], a[2][3], strain[6];

    if (!e->spread)
        q = NULL;
    find_place(e, d, q1, q2, q, &here, &p);
    kinematics(e, q, &p, &k);
    for (int i = 0; i < 3; i++)
        u[i] = du[i] - du[6 + i];
    mat3_apply_t(here.G, u, a[0]);
    mat3_apply(p.H, a[0], strain);
    memset(strain + 3, 0, 3 * sizeof *strain);
    mat3_apply_t(here.G, du + 3, a[0]);
    mat3_apply_t(here.G, du + 9, a[1]);
    for (int i = 0; i < 3; i++) {
        double s[3], bend[3];

        for (int j = 0; j < 3; j++) {
            s[j] = (a[0][j] + a[1][j]) / 2;
            bend[j] = a[0][j] - a[1][j];
        }
        for (int half = 0; half < 2; half++)
            strain[3 * half + i] +=
                vec3_dot(k.Y[half] + 3 * i, s) + vec3_dot(k.Z[half] + 3 * i, bend);
    }
    for (int i = 0; i < 6; i++) {
        f[i] = p.f[i];
        for (int j = 0; j < 6; j++)
            f[i] += e->K[i + 6 * j] * strain[j];
    }
}
