/* Finite rotations. */
#include "check.h"

#include "num/quat.h"
#include "num/vec3.h"

static void random_vector(uint64_t *u, double size, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = uniform_in(u, -size, size);
}

/* log(exp(v)) = v up to half a turn, from tiny to large. */
static void there_and_back(void **state)
{
    uint64_t u = 1;

    (void)state;
    for (int k = 0; k < 1000; k++) {
        double v[3], back[3], q[4];

        random_vector(&u, pow(10, -(k % 12)) * 1.8, v); /* |v| < pi */
        quat_exp(v, q);
        quat_log(q, back);
        for (int i = 0; i < 3; i++)
            near_abs(back[i], v[i], 1e-15 * (1 + vec3_length(v)) + 1e-15 * vec3_length(v));
    }
}

/* The matrix is exp(v^) by its series, orthogonal; products are products. */
static void matrices(void **state)
{
    uint64_t u = 2;

    (void)state;
    for (int k = 0; k < 100; k++) {
        double v[3], w[3], p[4], q[4], r[4], P[9], Q[9], R[9], W[9], term[9], sum[9], next[9];

        random_vector(&u, 2, v);
        random_vector(&u, 2, w);
        quat_exp(v, p);
        quat_exp(w, q);
        quat_multiply(p, q, r);
        quat_matrix(p, P);
        quat_matrix(q, Q);
        quat_matrix(r, R);
        mat3_multiply(P, Q, next);
        for (int i = 0; i < 9; i++)
            near_abs(R[i], next[i], 1e-14);
        quat_between(p, r, r); /* p^-1 p q */
        for (int i = 0; i < 4; i++)
            near_abs(r[i], q[i], 1e-15 * 4);
        quat_half(q, r);
        quat_multiply(r, r, r);
        for (int i = 0; i < 4; i++)
            near_abs(fabs(r[i]), fabs(q[i]), 1e-15 * 4);
        mat3_skew(v, W);
        for (int i = 0; i < 9; i++)
            term[i] = sum[i] = i % 4 == 0;
        for (int n = 1; n < 60; n++) {
            mat3_multiply(term, W, next);
            for (int i = 0; i < 9; i++)
                sum[i] += term[i] = next[i] / n;
        }
        for (int i = 0; i < 9; i++)
            near_abs(P[i], sum[i], 1e-13); /* terms up to e^3.5 */
    }
}

/* Turns are counted on through many of them; small sums would be another rotation. */
static void turns(void **state)
{
    const double axis[3] = {0.6, 0, -0.8}, step = 0.3;
    double q[4] = QUAT_ONE, d[4], v[3] = {0, 0, 0}, part[3];

    (void)state;
    for (int c = 0; c < 3; c++)
        part[c] = step * axis[c];
    quat_exp(part, d);
    for (int k = 1; k <= 100; k++) {
        quat_multiply(d, q, q);
        quat_normalize(q);
        quat_log_near(q, v);
        for (int c = 0; c < 3; c++)
            near_abs(v[c], k * step * axis[c], 1e-12);
    }
}

/* Two quarter turns about different axes do not commute, and their sum is neither. */
static void composed(void **state)
{
    const double x[3] = {PI / 2, 0, 0}, y[3] = {0, PI / 2, 0};
    double p[4], q[4], r[4], v[3];

    (void)state;
    quat_exp(x, p);
    quat_exp(y, q);
    quat_multiply(p, q, r); /* first y, then x: a third of a turn about (1, 1, 1) */
    quat_log(r, v);
    for (int c = 0; c < 3; c++)
        near_abs(v[c], 2 * PI / 3 / sqrt(3), 1e-15);
    quat_multiply(q, p, r);
    quat_log(r, v);
    near_abs(v[2], -2 * PI / 3 / sqrt(3), 1e-15);
}

TEST_MAIN(cmocka_unit_test(there_and_back), cmocka_unit_test(matrices), cmocka_unit_test(turns),
          cmocka_unit_test(composed))
