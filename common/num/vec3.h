/*
 * Vectors of space and 3 x 3 matrices, the latter by rows: A[3 i + j].
 *
 * Results may not be an argument, but for vec3_scale and vec3_add.
 */
#ifndef SEILWERK_NUM_VEC3_H
#define SEILWERK_NUM_VEC3_H

#include <math.h>
#include <string.h>

static inline double vec3_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vec3_length(const double a[3])
{
    return sqrt(vec3_dot(a, a));
}

/* c = a x b */
static inline void vec3_cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* y += c x */
static inline void vec3_add(double c, const double x[3], double y[3])
{
    for (int i = 0; i < 3; i++)
        y[i] += c * x[i];
}

static inline void vec3_scale(double c, double x[3])
{
    for (int i = 0; i < 3; i++)
        x[i] *= c;
}

/* W x = w x x */
static inline void mat3_skew(const double w[3], double W[9])
{
    W[0] = W[4] = W[8] = 0;
    W[5] = -w[0];
    W[7] = w[0];
    W[2] = w[1];
    W[6] = -w[1];
    W[1] = -w[2];
    W[3] = w[2];
}

/* y = A x */
static inline void mat3_apply(const double A[9], const double x[3], double y[3])
{
    for (int i = 0; i < 3; i++)
        y[i] = A[3 * i] * x[0] + A[3 * i + 1] * x[1] + A[3 * i + 2] * x[2];
}

/* y = A^T x */
static inline void mat3_apply_t(const double A[9], const double x[3], double y[3])
{
    for (int i = 0; i < 3; i++)
        y[i] = A[i] * x[0] + A[3 + i] * x[1] + A[6 + i] * x[2];
}

/* C = A B */
static inline void mat3_multiply(const double A[9], const double B[9], double C[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            C[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
}

/* C = A^T B */
static inline void mat3_multiply_tn(const double A[9], const double B[9], double C[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            C[3 * i + j] = A[i] * B[j] + A[3 + i] * B[3 + j] + A[6 + i] * B[6 + j];
}

/* C = A B^T */
static inline void mat3_multiply_nt(const double A[9], const double B[9], double C[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            C[3 * i + j] = vec3_dot(A + 3 * i, B + 3 * j);
}

/* B += c A */
static inline void mat3_add(double c, const double A[9], double B[9])
{
    for (int i = 0; i < 9; i++)
        B[i] += c * A[i];
}

/* B += c A^T */
static inline void mat3_add_t(double c, const double A[9], double B[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            B[3 * i + j] += c * A[3 * j + i];
}

#endif
