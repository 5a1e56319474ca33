/* The curved element: geometry, flexibility, exact end forces and their derivative. */
#include "check.h"

#include "num/jacobi.h"
#include "num/quat.h"
#include "num/vec3.h"
#include "phys/corotate.h"
#include "phys/divide.h"
#include "phys/hinge.h"

#include <string.h>

static struct section values(void)
{
    struct section s = {.shape = SECTION_VALUES,
                        .E = 2,
                        .G = 0.8,
                        .area = 3,
                        .Ixx = 0.4,
                        .Iyy = 0.7,
                        .It = 0.9,
                        .ex = 1,
                        .ey = 1,
                        .Wt = 1};

    assert_int_equal(section_complete(&s, 1.3), SW_OK);
    return s;
}

static void random_vector(uint64_t *u, double size, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = uniform_in(u, -size, size);
}

/* A skew element of random orientation, end angles up to about half a radian, twisted. */
static void random_beam(uint64_t *u, const struct section *s, struct beam *b, double x[2][3])
{
    double A[2][9], turn[3], q[4];
    struct bow bow;

    random_vector(u, 3, x[0]);
    random_vector(u, 3, x[1]);
    random_vector(u, 3, turn);
    for (int end = 0; end < 2; end++) {
        double R[9], e[3], B[9], tilt[3];

        for (int i = 0; i < 3; i++)
            e[i] = x[1][i] - x[0][i];
        vec3_scale(1 / vec3_length(e), e);
        bow_axes(e, B);
        random_vector(u, 0.5, tilt);
        quat_exp(tilt, q);
        quat_matrix(q, R);
        mat3_multiply(R, B, A[end]);
    }
    below(bow_between(x[0], x[1], A[0], A[1], 0, uniform_in(u, -0.3, 0.3), &bow), PI / 2);
    assert_int_equal(beam_new(&bow, s, b), SW_OK);
}

/* The frames that come out are those that went in; any orientation, along z0 too. */
static void keeps_end_frames(void **state)
{
    uint64_t u = 7;

    (void)state;
    for (int k = 0; k < 1000; k++) {
        double x[2][3] = {{0}}, A[2][9], back[9], v[3], q[4];
        struct bow bow;

        random_vector(&u, 2, x[1]);
        if (k % 3 == 0)
            x[1][0] = x[1][1] = 0;
        for (int end = 0; end < 2; end++) {
            double e[3] = {x[1][0], x[1][1], x[1][2]}, B[9], R[9], C[9];

            vec3_scale(1 / vec3_length(e), e);
            bow_axes(e, B);
            near_abs(B[0] * B[3] + B[1] * B[4] + B[2] * B[5], 0, 1e-15);
            near_abs(vec3_length(B), 1, 1e-15);
            random_vector(&u, 0.7, v);
            quat_exp(v, q);
            quat_matrix(q, R);
            random_vector(&u, 0, v);
            v[2] = uniform_in(&u, -PI, PI);
            quat_exp(v, q);
            quat_matrix(q, C);
            mat3_multiply(C, R, A[end]); /* turned about its own tangent */
            mat3_multiply(A[end], B, C);
            memcpy(A[end], C, sizeof C);
        }
        if (bow_between(x[0], x[1], A[0], A[1], 0, 0, &bow) > 1.5)
            continue;
        for (int end = 0; end < 2; end++) {
            bow_global(&bow, end, back);
            for (int i = 0; i < 9; i++)
                near_abs(back[i], A[end][i], 4e-15 / (1 - sin(1.5))); /* slopes up to tan 1.5 */
        }
    }
}

static void strain_energy_gradient(void **state)
{
    struct section s = values();
    uint64_t u = 11;

    (void)state;
    for (int k = 0; k < 200; k++) {
        struct beam b;
        struct corotate e;
        double x[2][3], q[2][4], v[3], load[3];
        const double h = 1e-5;

        random_beam(&u, &s, &b, x);
        e = corotate_beam(&b);
        random_vector(&u, 1, load);
        for (int end = 0; end < 2; end++) {
            random_vector(&u, k % 4 == 0 ? 1e-3 : 1.2, v);
            quat_exp(v, q[end]);
            random_vector(&u, 0.3, v);
            vec3_add(1, v, x[end]);
        }
        double K[144], d0[3] = {x[0][0] - x[1][0], x[0][1] - x[1][1], x[0][2] - x[1][2]};
        struct corotated mid;
        double D[144], largest = 0;

        corotate(&e, d0, q[0], q[1], load, NULL, &mid, K);
        for (int j = 0; j < 12; j++) {
            struct corotated side[2];
            double U[2];

            for (int sign = 0; sign < 2; sign++) {
                double at[2][3], turned[2][4], step = sign ? h : -h;

                memcpy(at, x, sizeof at);
                memcpy(turned, q, sizeof turned);
                if (j % 6 < 3) {
                    at[j / 6][j % 6] += step;
                } else {
                    double spin[3] = {0}, dq[4];

                    spin[j % 6 - 3] = step;
                    quat_exp(spin, dq);
                    quat_multiply(dq, turned[j / 6], turned[j / 6]);
                }
                const double d[3] = {at[0][0] - at[1][0], at[0][1] - at[1][1], at[0][2] - at[1][2]};

                corotate(&e, d, turned[0], turned[1], load, NULL, &side[sign], NULL);
                U[sign] = side[sign].energy - b.length * vec3_dot(load, at[1]);
            }
            near_abs(mid.force[j], (U[1] - U[0]) / (2 * h), 3e-8 * (1 + fabs(mid.force[j])));
            for (int i = 0; i < 12; i++) {
                D[i + 12 * j] = (side[1].force[i] - side[0].force[i]) / (2 * h);
                largest = fmax(largest, fabs(D[i + 12 * j]));
            }
        }
        /* full derivative = K + sign/2 [M]x on the diagonal blocks of the moments */
        for (int end = 0; end < 2; end++) {
            double M[9];

            mat3_skew(mid.force + 6 * end + 3, M);
            for (int i = 0; i < 9; i++)
                K[6 * end + 3 + i / 3 + 12 * (6 * end + 3 + i % 3)] -= M[i] / 2;
        }
        for (int i = 0; i < 144; i++)
            near_abs(D[i], K[i], 2e-8 * largest);
    }
}

/* Textbook stiffness of a straight Bernoulli beam along x, ends u phi u phi. */
static void bernoulli(double EA, double EIy, double EIz, double GI, double L, double K[12][12])
{
    double a = EA / L, t = GI / L;
    const double bend[2] = {EIz, EIy}; /* in x-y by Iz, in x-z by Iy */

    memset(K, 0, 144 * sizeof(double));
    for (int e = 0; e < 2; e++)
        for (int f = 0; f < 2; f++) {
            double sign = e == f ? 1 : -1;

            K[6 * e][6 * f] = sign * a;
            K[6 * e + 3][6 * f + 3] = sign * t;
            for (int p = 0; p < 2; p++) {
                int v = 1 + p, r = p == 0 ? 5 : 4;
                double EI = bend[p], turn = p == 0 ? 1 : -1;

                K[6 * e + v][6 * f + v] = sign * 12 * EI / pow(L, 3);
                K[6 * e + r][6 * f + r] = (e == f ? 4 : 2) * EI / L;
                K[6 * e + v][6 * f + r] = turn * (e == 0 ? 1 : -1) * 6 * EI / (L * L);
                K[6 * e + r][6 * f + v] = turn * (f == 0 ? 1 : -1) * 6 * EI / (L * L);
            }
        }
}

/* Along x the chord's own x axis is -z0 and its y axis y0: Ixx bends about z, Iyy about y. */
static void straight_is_bernoulli(void **state)
{
    struct section s = values();
    const double x1[3] = {0.3, -1, 2}, x2[3] = {2.1, -1, 2};
    double A[9], K[144], wanted[12][12];
    struct bow bow;
    struct beam b;

    (void)state;
    bow_axes((const double[]){1, 0, 0}, A);
    below(bow_between(x1, x2, A, A, 0, 0, &bow), 1e-15);
    assert_int_equal(beam_new(&bow, &s, &b), SW_OK);
    near_rel(b.length, 1.8, 1e-15);
    beam_stiffness(&b, K);
    bernoulli(6, 1.4, 0.8, 0.72, 1.8, wanted);
    for (int i = 0; i < 144; i++)
        near_abs(K[i], wanted[i / 12][i % 12], 1e-12 * 12); /* of the largest entries */
}

/* Six zero eigenvalues of a free element, the others positive; symmetric. */
static void free_element(void **state)
{
    struct section s = values();
    uint64_t u = 3;

    (void)state;
    for (int k = 0; k < 50; k++) {
        struct beam b;
        double x[2][3], K[144], lambda[12], X[144];

        random_beam(&u, &s, &b, x);
        beam_stiffness(&b, K);
        for (int i = 0; i < 12; i++)
            for (int j = 0; j < 12; j++)
                near_abs(K[i + 12 * j], K[j + 12 * i], 1e-13 * fabs(K[0] + K[13] + K[26]));
        assert_int_equal(jacobi_symmetric(12, K, lambda, X), SW_OK);
        for (int i = 0; i < 6; i++)
            near_abs(lambda[i], 0, 1e-13 * lambda[11]); /* Jacobi: round-off of the largest */
        assert_true(lambda[6] > 1e-4 * lambda[11]);
    }
}

/* A rigid motion of any size gives no force, and one of a strained element turns its forces. */
static void objective(void **state)
{
    struct section s = values();
    uint64_t u = 5;

    (void)state;
    for (int k = 0; k < 100; k++) {
        struct beam b;
        struct corotate e;
        struct corotated rest, first, second;
        double x[2][3], v[3], q[3][4], R[9], scale = 0, forces[3] = {0}, moments[3], arm[3];

        random_beam(&u, &s, &b, x);
        e = corotate_beam(&b);
        for (int end = 0; end < 3; end++) {
            random_vector(&u, end < 2 ? 0.6 : 3, v);
            quat_exp(v, q[end]);
        }
        quat_matrix(q[2], R);
        double d[3] = {x[0][0] - x[1][0], x[0][1] - x[1][1], x[0][2] - x[1][2]}, turned[3];

        mat3_apply(R, d, turned);
        corotate(&e, turned, q[2], q[2], NULL, NULL, &rest, NULL);
        for (int i = 0; i < 144; i += 13)
            scale = fmax(scale, fabs(b.K[i % 36]));
        for (int i = 0; i < 12; i++)
            near_abs(rest.force[i], 0, 2e-14 * scale * 5); /* chords are up to 5 long */
        for (int i = 0; i < 3; i++)
            d[i] += uniform_in(&u, -0.2, 0.2);
        corotate(&e, d, q[0], q[1], NULL, NULL, &first, NULL);
        mat3_apply(R, d, turned);
        quat_multiply(q[2], q[0], q[0]);
        quat_multiply(q[2], q[1], q[1]);
        corotate(&e, turned, q[0], q[1], NULL, NULL, &second, NULL);
        near_rel(second.energy, first.energy, 1e-13);
        for (int i = 0; i < 4; i++) {
            mat3_apply(R, first.force + 3 * i, turned);
            for (int c = 0; c < 3; c++)
                near_abs(second.force[3 * i + c], turned[c], 1e-13 * scale);
        }
        vec3_cross(d, first.force, arm); /* both ends in balance */
        for (int c = 0; c < 3; c++) {
            forces[c] = first.force[c] + first.force[6 + c];
            moments[c] = first.force[3 + c] + first.force[9 + c] + arm[c];
            near_abs(forces[c], 0, 1e-14 * scale);
            near_abs(moments[c], 0, 1e-13 * scale);
        }
    }
}

/* At the natural state the tangent is the document's stiffness, and loads push as in linear theory.
 */
static void natural_state(void **state)
{
    struct section s = values();
    const double none[4] = QUAT_ONE;
    uint64_t u = 13;

    (void)state;
    for (int k = 0; k < 50; k++) {
        struct beam b;
        struct corotate e;
        struct corotated here, other;
        double x[2][3], K[144], linear[144], q[3], minus[3], loads[12], sum[3] = {0}, largest = 0;

        random_beam(&u, &s, &b, x);
        e = corotate_beam(&b);
        const double d[3] = {x[0][0] - x[1][0], x[0][1] - x[1][1], x[0][2] - x[1][2]};

        corotate(&e, d, none, none, NULL, NULL, &here, K);
        beam_stiffness(&b, linear);
        for (int i = 0; i < 144; i++)
            largest = fmax(largest, fabs(linear[i]));
        for (int i = 0; i < 144; i++)
            near_abs(K[i], linear[i], 1e-12 * largest);
        random_vector(&u, 1, q);
        corotate(&e, d, none, none, q, NULL, &here, NULL);
        for (int i = 0; i < 3; i++)
            minus[i] = -q[i];
        corotate(&e, d, none, none, minus, NULL, &other, NULL);
        beam_loads(&b, q, loads);
        for (int i = 0; i < 12; i++) /* what is even in q is the lever of its sag */
            near_abs((here.force[i] - other.force[i]) / 2, -loads[i], 1e-12 * largest);
        for (int i = 0; i < 3; i++) {
            sum[i] = loads[i] + loads[6 + i];
            near_abs(sum[i], q[i] * b.length, 1e-13 * b.length);
        }
    }
}

/* A straight beam under its load: q L/2 and q L^2/12 at the ends; section moment q L^2/24 in the
 * middle; its mass is the textbook's. */
static void straight_load_and_mass(void **state)
{
    struct section s = values();
    const double x1[3] = {0}, x2[3] = {2, 0, 0}, q[3] = {0, 0, -3};
    double A[9], loads[12], M[144], force[4];
    struct bow bow;
    struct beam b;
    struct bow_run run = {.zeta = 0};

    (void)state;
    bow_axes((const double[]){1, 0, 0}, A);
    bow_between(x1, x2, A, A, 0, 0, &bow);
    s.inertia[0] = s.inertia[1] = 0; /* the textbook leaves it out */
    assert_int_equal(beam_new(&bow, &s, &b), SW_OK);
    beam_loads(&b, q, loads);
    near_rel(loads[2], -3, 1e-13);
    near_rel(loads[8], -3, 1e-13);
    near_rel(loads[4], 1, 1e-13);
    near_rel(loads[10], -1, 1e-13);
    bow_run_to(&bow, 0.5, &run);
    beam_section(&bow, &run, (const double[]){0, 0, 3}, (const double[]){0, -1, 0}, q, force);
    near_abs(force[0], 0, 1e-15);
    near_rel(fabs(force[2]), 0.5, 1e-13);
    { /* a load along it is tension at the clamp, linear */
        const double pull[3] = {5, 0, 0};

        beam_section(&bow, &run, (const double[]){-7, 0, 0}, (const double[]){0, 0, 0}, pull,
                     force);
        near_rel(force[0], 7 - 5, 1e-13);
    }
    beam_mass(&b, &s, M);
    near_rel(M[2 + 12 * 2], 3.9 * 2 * 156 / 420, 1e-13);
    near_rel(M[2 + 12 * 8], 3.9 * 2 * 54 / 420, 1e-13);
    near_rel(M[4 + 12 * 4], 3.9 * 8 * 4 / 420, 1e-13);
    near_rel(M[4 + 12 * 10], -3.9 * 8 * 3 / 420, 1e-13);
    near_rel(M[4 + 12 * 8], -3.9 * 4 * 13 / 420, 1e-13); /* ry = -dw/dx */
    near_rel(M[0], 3.9 * 2 / 3, 1e-13);
    near_rel(M[3 + 12 * 3], 1.3 * 1.1 * 2 / 3, 1e-13);
}

/* The mass of a skew element moved as a whole is its mass, and mixes with nothing. */
static void rigid_mass(void **state)
{
    struct section s = values();
    uint64_t u = 17;

    (void)state;
    for (int k = 0; k < 50; k++) {
        struct beam b;
        double x[2][3], M[144];

        random_beam(&u, &s, &b, x);
        beam_mass(&b, &s, M);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                near_abs(M[i + 12 * j] + M[i + 12 * (6 + j)] + M[6 + i + 12 * j] +
                             M[6 + i + 12 * (6 + j)],
                         i == j ? s.mass * b.length : 0,
                         1e-5 * s.mass * b.length); /* six points of a length that has 36 */
    }
}

/* Section forces at the end of an element are those by which its second node is held. */
static void section_forces_in_balance(void **state)
{
    struct section s = values();
    uint64_t u = 19;

    (void)state;
    for (int k = 0; k < 50; k++) {
        struct beam b;
        struct bow_run run = {.zeta = 0};
        double x[2][3], K[144], du[12], p[12] = {0}, force[4], A[9], local[3];
        const double none[3] = {0, 0, 0};

        random_beam(&u, &s, &b, x);
        beam_stiffness(&b, K);
        for (int i = 0; i < 12; i++)
            du[i] = uniform_in(&u, -1, 1);
        for (int i = 0; i < 12; i++)
            for (int j = 0; j < 12; j++)
                p[i] += K[i + 12 * j] * du[j];
        bow_run_to(&b.bow, 1, &run);
        beam_section(&b.bow, &run, p, p + 3, none, force);
        bow_global(&b.bow, 1, A);
        near_abs(force[0], vec3_dot(A + 6, p + 6), 1e-11 * vec3_length(p));
        mat3_apply(A, p + 9, local);
        for (int i = 0; i < 3; i++)
            near_abs(force[1 + i], local[i], 1e-11 * (vec3_length(p) + vec3_length(p + 9)));
    }
}

/* A twisted, curved element with psi bent by its third value against its own pieces: flexibilities
 * add up, so that the whole's stiffness times their sum is the identity. */
static double series_error(int pieces, double bulge)
{
    struct section s = values();
    struct station at[2], *piece = malloc((DIVIDE_MOST + 1) * sizeof *piece);
    const double a0[9] = {0, 0, -1, 0, 1, 0, 1, 0, 0};
    double v[3] = {0.1, 0.2, -0.15}, q[4], R[9], F[36] = {0}, K[36], X[36], lambda[6], worst = 0;
    struct bow bow;
    struct beam b;
    int n;

    memset(at, 0, sizeof at);
    at[1].x[0] = 1.5;
    for (int end = 0; end < 2; end++) {
        quat_exp(v, q);
        quat_matrix(q, R);
        mat3_multiply_nt(a0, R, at[end].A);
        v[0] = 0.7;
        v[1] = -0.25;
        v[2] = 0.1;
    }
    bow_between(at[0].x, at[1].x, at[0].A, at[1].A, 0, bulge, &bow);
    at[0].twist = bow.psi[1] - bow.psi[0];
    at[0].bulge = bulge;
    assert_int_equal(beam_new(&bow, &s, &b), SW_OK);
    n = divide(&at[0], &at[1], 0.35 / pieces, piece);
    assert_true(n >= pieces);
    for (int k = 0; k < n; k++) { /* F += T F_k T^T, moved to end 1 of the whole */
        struct bow part;
        struct beam small;
        double Fk[36], T[36] = {0}, G[36] = {0}, arm[3], local[3], L[9];

        bow_between(piece[k].x, piece[k + 1].x, piece[k].A, piece[k + 1].A, piece[k].twist,
                    piece[k].bulge, &part);
        assert_int_equal(beam_new(&part, &s, &small), SW_OK);
        memcpy(K, small.K, sizeof K);
        assert_int_equal(jacobi_symmetric(6, K, lambda, X), SW_OK);
        for (int i = 0; i < 36; i++) {
            Fk[i] = 0;
            for (int j = 0; j < 6; j++)
                Fk[i] += X[i % 6 + 6 * j] * X[i / 6 + 6 * j] / lambda[j];
        }
        /* displacement of the whole's end 1 by that of the piece's: u + phi x (x1 - xk) */
        for (int c = 0; c < 3; c++)
            arm[c] = at[0].x[c] - piece[k].x[c];
        mat3_apply(part.B, arm, local);
        mat3_skew(local, L);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double Bij = part.B[3 * j + i];

                T[i + 6 * j] = Bij;
                T[i + 3 + 6 * (j + 3)] = Bij;
            }
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int l = 0; l < 3; l++)
                    T[i + 6 * (j + 3)] -= part.B[3 * l + i] * L[3 * l + j];
        for (int i = 0; i < 6; i++)
            for (int j = 0; j < 6; j++)
                for (int l = 0; l < 6; l++)
                    G[i + 6 * j] += T[i + 6 * l] * Fk[l + 6 * j];
        for (int i = 0; i < 6; i++)
            for (int j = 0; j < 6; j++)
                for (int l = 0; l < 6; l++)
                    F[i + 6 * j] += G[i + 6 * l] * T[j + 6 * l];
    }
    for (int i = 0; i < 6; i++) /* K F = I in global axes */
        for (int j = 0; j < 6; j++) {
            double whole[144], sum = 0;

            beam_stiffness(&b, whole);
            for (int l = 0; l < 6; l++)
                sum += whole[i + 12 * l] * F[l + 6 * j];
            worst = fmax(worst, fabs(sum - (i == j)));
        }
    free(piece);
    return worst;
}

static void twisted_pieces(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        double bulge = k ? 0.3 : 0, one = series_error(2, bulge), two = series_error(8, bulge);

        print_message("pieces against the whole: %.3g, %.3g\n", one, two);
        below(two, 0.02); /* the cubic of the whole is not the curve of the pieces: of order 2 in
                             the end angle, 0.25 rad */
    }
}

/* Forces by all unknowns of an element with hinges, where they are. */
struct hinged {
    struct corotate e;
    struct hinge h[2];
    struct hinge_state s[2];
    double x[2][3], q[2][4];
};

static int hinged_forces(const struct hinged *p, double *f, double *K, double M[2][3])
{
    struct corotated here;
    double end[2][4], axis[2][3][3], dense[144];
    const double d[3] = {p->x[0][0] - p->x[1][0], p->x[0][1] - p->x[1][1], p->x[0][2] - p->x[1][2]};

    for (int k = 0; k < 2; k++)
        hinge_end(&p->h[k], &p->s[k], p->q[k], end[k], axis[k]);
    corotate(&p->e, d, end[0], end[1], NULL, NULL, &here, dense);
    memcpy(M[0], here.force + 3, sizeof M[0]);
    memcpy(M[1], here.force + 9, sizeof M[1]);
    return hinge_expand(p->h, axis, here.force, dense, f, K);
}

/* Move unknown j by step. */
static void hinged_move(struct hinged *p, int j, double step)
{
    if (j < 12 && j % 6 < 3) {
        p->x[j / 6][j % 6] += step;
    } else if (j < 12) {
        double spin[3] = {0}, q[4];

        spin[j % 6 - 3] = step;
        quat_exp(spin, q);
        quat_multiply(q, p->q[j / 6], p->q[j / 6]);
    } else {
        double dx[3] = {0};
        int end = j - 12 >= p->h[0].n;

        dx[j - 12 - (end ? p->h[0].n : 0)] = step;
        hinge_move(&p->h[end], dx, &p->s[end]);
    }
}

/* The stiffness of an element with hinges of all kinds, far turned, is the derivative of its forces
 * but for -1/2 of the moment's spin where rotations are free in space: at nodes, at ball joints. */
static void hinges_by_differences(void **state)
{
    struct section s = values();
    const double h = 1e-5;
    uint64_t u = 23;

    (void)state;
    for (int k = 0; k < 160; k++) {
        struct beam b;
        struct hinged p;
        double f[HINGED_MOST], g[2][HINGED_MOST], K[HINGED_MOST * HINGED_MOST], M[2][3], v[3];
        double junk[HINGED_MOST * HINGED_MOST], none[2][3], largest = 0;
        int n;

        memset(&p, 0, sizeof p);
        random_beam(&u, &s, &b, p.x);
        p.e = corotate_beam(&b);
        for (int end = 0; end < 2; end++) {
            p.h[end].n = (end ? k / 4 : k) % 4;
            memcpy(p.h[end].axis[0], b.bow.B, 3 * sizeof *v);
            memcpy(p.h[end].axis[1], b.bow.B + 3, 3 * sizeof *v);
            p.s[end].angle[0] = uniform_in(&u, -1, 1);
            p.s[end].angle[1] = uniform_in(&u, -1, 1);
            random_vector(&u, 0.6, v);
            quat_exp(v, p.s[end].q);
            random_vector(&u, 0.4, v);
            quat_exp(v, p.q[end]);
        }
        n = hinged_forces(&p, f, K, M);
        for (int end = 0, first = 12; end < 2; first += p.h[end++].n) {
            double spin[9];
            int at = p.h[end].n == 3 ? first : 6 * end + 3;

            mat3_skew(M[end], spin);
            for (int i = 0; i < 9; i++)
                K[at + i / 3 + n * (at + i % 3)] -= spin[i] / 2;
        }
        for (int i = 0; i < n * n; i++)
            largest = fmax(largest, fabs(K[i]));
        for (int j = 0; j < n; j++) {
            for (int side = 0; side < 2; side++) {
                struct hinged moved = p;

                hinged_move(&moved, j, side ? h : -h);
                hinged_forces(&moved, g[side], junk, none);
            }
            for (int i = 0; i < n; i++)
                near_abs((g[1][i] - g[0][i]) / (2 * h), K[i + n * j], 3e-8 * largest);
        }
    }
}

/* Series for small turns meet the closed forms, at |w| = 0.1: with forces that are guessed far
 * larger than the element's own the stiffness is all turning. */
static void series_meet_closed_forms(void **state)
{
    struct section s = values();
    uint64_t u = 29;
    double worst = 0;

    (void)state;
    for (int k = 0; k < 100; k++) {
        struct beam b;
        struct corotate e;
        double x[2][3], d[3], w[3], guess[6], K[2][144], largest = 0;

        random_beam(&u, &s, &b, x);
        e = corotate_beam(&b);
        random_vector(&u, 1, w);
        for (int i = 0; i < 3; i++)
            d[i] = x[0][i] - x[1][i];
        for (int i = 0; i < 6; i++)
            guess[i] = uniform_in(&u, -1e9, 1e9);
        for (int side = 0; side < 2; side++) {
            struct corotated here;
            double q[2][4];

            vec3_scale((0.1 + (side ? 1e-14 : -1e-14)) / vec3_length(w), w);
            quat_exp(w, q[0]);
            vec3_scale(-1, w);
            quat_exp(w, q[1]);
            vec3_scale(-1, w);
            corotate(&e, d, q[0], q[1], NULL, guess, &here, K[side]);
        }
        for (int i = 0; i < 144; i++)
            largest = fmax(largest, fabs(K[0][i]));
        for (int i = 0; i < 144; i++)
            worst = fmax(worst, fabs(K[1][i] - K[0][i]) / largest);
    }
    print_message("# stiffness jumps by %.2g\n", worst);
    below(worst, 1e-13);
}

/* An element that knows no load takes none: its foreseen forces are those without. */
static void never_loaded(void **state)
{
    struct section s = values();
    uint64_t u = 12;

    (void)state;
    for (int k = 0; k < 20; k++) {
        struct beam b;
        struct corotate e;
        double x[2][3], q[2][4], v[3], load[3], du[12], with[6], without[6], d[3];

        random_beam(&u, &s, &b, x);
        e = corotate_beam(&b);
        for (int end = 0; end < 2; end++) {
            random_vector(&u, 1, v);
            quat_exp(v, q[end]);
        }
        for (int i = 0; i < 3; i++)
            d[i] = x[0][i] - x[1][i];
        for (int i = 0; i < 12; i++)
            du[i] = uniform_in(&u, -0.01, 0.01);
        random_vector(&u, 1, load);
        e.spread = NULL;
        corotate_foresee(&e, d, q[0], q[1], load, du, with);
        corotate_foresee(&e, d, q[0], q[1], NULL, du, without);
        for (int i = 0; i < 6; i++)
            near_abs(with[i], without[i], 0);
    }
}

TEST_MAIN(cmocka_unit_test(keeps_end_frames), cmocka_unit_test(straight_is_bernoulli),
          cmocka_unit_test(free_element), cmocka_unit_test(objective),
          cmocka_unit_test(natural_state), cmocka_unit_test(straight_load_and_mass),
          cmocka_unit_test(rigid_mass), cmocka_unit_test(section_forces_in_balance),
          cmocka_unit_test(twisted_pieces), cmocka_unit_test(strain_energy_gradient),
          cmocka_unit_test(hinges_by_differences), cmocka_unit_test(series_meet_closed_forms),
          cmocka_unit_test(never_loaded))
