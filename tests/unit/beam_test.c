/* The curved element: geometry, flexibility, exact end forces and their derivative. */
#include "check.h"

#include "num/jacobi.h"
#include "num/quat.h"
#include "num/vec3.h"
#include "phys/corotate.h"

#include <string.h>

static struct section wire_section(void)
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
    struct section s = wire_section();
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
                const double d[3] = {at[0][0] - at[1][0], at[0][1] - at[1][1],
                                     at[0][2] - at[1][2]};

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

TEST_MAIN(cmocka_unit_test(keeps_end_frames), cmocka_unit_test(strain_energy_gradient))
