/* Jacobi rotations and a small Cholesky. */
#include "num/jacobi.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

enum { SWEEPS = 60 };

/* Columns p and q of X (n, n): x_p := c x_p - s x_q, x_q := s x_p + c x_q. */
static void rotate_columns(int n, double *X, int p, int q, double c, double s)
{
    double *x = X + (size_t)p * (size_t)n, *y = X + (size_t)q * (size_t)n;

    for (int i = 0; i < n; i++) {
        double a = x[i], b = y[i];

        x[i] = c * a - s * b;
        y[i] = s * a + c * b;
    }
}

/*
 * A := J^T A J with entry (p, q) turned to zero by the smaller of the two angles:
 * t = tan(angle) is the smaller root of t^2 + 2 theta t - 1 = 0, theta = (a_qq - a_pp)/(2 a_pq).
 */
static void rotate(int n, double *A, double *X, int p, int q)
{
    size_t N = (size_t)n, P = (size_t)p, Q = (size_t)q;
    double a = A[P + Q * N], theta = (A[Q + Q * N] - A[P + P * N]) / (2 * a);
    double t = copysign(1, theta) / (fabs(theta) + sqrt(1 + theta * theta));
    double c = 1 / sqrt(1 + t * t), s = t * c, app = A[P + P * N] - t * a,
           aqq = A[Q + Q * N] + t * a;

    rotate_columns(n, A, p, q, c, s);
    for (size_t i = 0; i < N; i++) { /* rows are what columns have become */
        A[P + i * N] = A[i + P * N];
        A[Q + i * N] = A[i + Q * N];
    }
    A[P + P * N] = app;
    A[Q + Q * N] = aqq;
    A[P + Q * N] = A[Q + P * N] = 0;
    rotate_columns(n, X, p, q, c, s);
}

/* One sweep over all pairs; 1 if any entry was worth turning. */
static int sweep(int n, double *A, double *X, double least)
{
    size_t N = (size_t)n;
    int turned = 0;

    for (int p = 0; p < n - 1; p++)
        for (int q = p + 1; q < n; q++) {
            double a = fabs(A[(size_t)p + (size_t)q * N]);

            if (!(a <= least)) {
                rotate(n, A, X, p, q);
                turned = 1;
            }
        }
    return turned;
}

static void swap_columns(int n, double *X, int p, int q)
{
    for (int i = 0; i < n; i++) {
        double a = X[i + p * n];

        X[i + p * n] = X[i + q * n];
        X[i + q * n] = a;
    }
}

static void sort(int n, double *lambda, double *X)
{
    for (int i = 0; i < n - 1; i++) {
        int k = i;
        double a;

        for (int j = i + 1; j < n; j++)
            if (lambda[j] < lambda[k])
                k = j;
        if (k == i)
            continue;
        a = lambda[i];
        lambda[i] = lambda[k];
        lambda[k] = a;
        swap_columns(n, X, i, k);
    }
}

enum status jacobi_symmetric(int n, double *A, double *lambda, double *X)
{
    size_t N = (size_t)n;
    double norm = 0;
    int sweeps = 0;

    for (size_t i = 0; i < N * N; i++) {
        norm += A[i] * A[i];
        X[i] = i % (N + 1) == 0;
    }
    norm = sqrt(norm);
    if (!(norm <= DBL_MAX))
        return SW_NOCONV;
    while (sweep(n, A, X, 0.01 * DBL_EPSILON * norm))
        if (++sweeps == SWEEPS)
            return SW_NOCONV;
    for (size_t i = 0; i < N; i++)
        lambda[i] = A[i * (N + 1)];
    sort(n, lambda, X);
    return SW_OK;
}

enum status cholesky_factor(int n, double *A, double least)
{
    for (int j = 0; j < n; j++) {
        double *column = A + (size_t)j * (size_t)n, d = column[j];

        for (int k = 0; k < j; k++)
            d -= A[j + k * n] * A[j + k * n];
        if (!(d > least * fabs(column[j]) && d <= DBL_MAX))
            return SW_INDEFINITE;
        column[j] = sqrt(d);
        for (int i = j + 1; i < n; i++) {
            double a = column[i];

            for (int k = 0; k < j; k++)
                a -= A[i + k * n] * A[j + k * n];
            column[i] = a / column[j];
        }
    }
    return SW_OK;
}

void cholesky_forward(int n, const double *L, double *x)
{
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++)
            x[i] -= L[i + k * n] * x[k];
        x[i] /= L[i + i * n];
    }
}

void cholesky_backward(int n, const double *L, double *x)
{
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            x[i] -= L[k + i * n] * x[k];
        x[i] /= L[i + i * n];
    }
}

/* K := K^T, square. */
static void transpose(int n, double *K)
{
    for (int j = 0; j < n; j++)
        for (int i = 0; i < j; i++) {
            double a = K[i + j * n];

            K[i + j * n] = K[j + i * n];
            K[j + i * n] = a;
        }
}

/* M = L L^T, C = L^{-1} K L^{-T}: C y = lambda y, x = L^{-T} y. */
enum status jacobi_pencil(int n, double *K, double *M, double *lambda, double *X)
{
    enum status s = cholesky_factor(n, M, 0);

    if (s != SW_OK)
        return s;
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j < n; j++)
            cholesky_forward(n, M, K + (size_t)j * (size_t)n);
        transpose(n, K);
    }
    for (int j = 0; j < n; j++) /* round-off apart it is symmetric */
        for (int i = 0; i < j; i++)
            K[i + j * n] = K[j + i * n] = (K[i + j * n] + K[j + i * n]) / 2;
    s = jacobi_symmetric(n, K, lambda, X);
    for (int j = 0; j < n && s == SW_OK; j++)
        cholesky_backward(n, M, X + (size_t)j * (size_t)n);
    return s;
}
