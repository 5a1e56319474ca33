/* Trust-region Newton on the potential energy. */
#include "phys/descend.h"

#include "num/jacobi.h"
#include "phys/space.h"

#include <math.h>
#include <string.h>

enum { STEPS = 1000 };

static const double widest = 0.2; /* step: lengths of the suspension, radians */
static const double least_radius = 1e-6;
static const double regular = 1e-10; /* neutral motions have no curvature of their own ... */

static double norm(int n, const double *x)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sqrt(sum);
}

/* ... but what the gradient lends them away from equilibrium, of either sign: less negative than
 * this is not told from neutral. */
static double doubtful(const struct potential *p)
{
    return regular + fmin(largest(p->n, p->gradient), 1e-6);
}

/* H + doubtful I = L L^T. */
static enum status factor(const struct potential *p, double *L)
{
    double shift = doubtful(p);

    memcpy(L, p->H, (size_t)(p->n * p->n) * sizeof *L);
    for (int i = 0; i < p->n; i++)
        L[i + i * p->n] += shift;
    return cholesky_factor(p->n, L, 0);
}

/* q = -(H + doubtful I)^{-1} g if that matrix is positive definite and q within the radius. */
static int newton_step(const struct potential *p, double radius, double *q)
{
    double A[GEAR_FREE * GEAR_FREE];
    int n = p->n;

    if (factor(p, A) != SW_OK)
        return 0;
    for (int i = 0; i < n; i++)
        q[i] = -p->gradient[i];
    cholesky_forward(n, A, q);
    cholesky_backward(n, A, q);
    return norm(n, q) <= radius;
}

/* Length of y = -(Lambda + mu)^{-1} b. */
static double shifted(int n, const double *lambda, const double *b, double mu, double *y)
{
    for (int i = 0; i < n; i++)
        y[i] = b[i] == 0 ? 0 : -b[i] / (lambda[i] + mu);
    return norm(n, y);
}

/*
 * The least of the quadratic model within the radius: (H + mu I) q = -g, |q| = radius, mu above
 * -lambda_1, found by bisection; where no mu reaches the radius (the gradient has no part along the
 * lowest vector) that vector fills it up.
 */
static enum status bounded_step(const struct potential *p, double radius, double *q)
{
    double A[GEAR_FREE * GEAR_FREE], X[GEAR_FREE * GEAR_FREE];
    double lambda[GEAR_FREE], b[GEAR_FREE], y[GEAR_FREE], low, high, length;
    int n = p->n;
    enum status s;

    memcpy(A, p->H, (size_t)(n * n) * sizeof *A);
    s = jacobi_symmetric(n, A, lambda, X);
    if (s != SW_OK)
        return s;
    for (int i = 0; i < n; i++) {
        b[i] = 0;
        for (int j = 0; j < n; j++)
            b[i] += X[j + i * n] * p->gradient[j];
    }
    low = fmax(0, -lambda[0]) + regular;
    high = low + norm(n, b) / radius + 1;
    length = shifted(n, lambda, b, low, y);
    if (length < radius && lambda[0] < -doubtful(p))
        /* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): n > 0, else newton_step was enough */
        y[0] += copysign(sqrt(radius * radius - length * length), -b[0]);
    for (int i = 0; i < 60 && length > radius; i++) {
        double mid = (low + high) / 2, l = shifted(n, lambda, b, mid, y);

        *(l > radius ? &low : &high) = mid;
        if (fabs(l - radius) <= 0.1 * radius)
            break;
    }
    for (int i = 0; i < n; i++) {
        q[i] = 0;
        for (int j = 0; j < n; j++)
            q[i] += X[i + j * n] * y[j];
    }
    return SW_OK;
}

/* Energy that the quadratic model gains with q. */
static double promised(const struct potential *p, const double *q)
{
    double sum = 0;

    for (int i = 0; i < p->n; i++) {
        double Hq = 0;

        for (int j = 0; j < p->n; j++)
            Hq += p->H[i + j * p->n] * q[j];
        sum -= (p->gradient[i] + Hq / 2) * q[i];
    }
    return sum;
}

/* One step; the radius follows how well the model foretold the energy. */
static enum status step(const struct gear *s, const struct freedom *f, const struct sling_law *law,
                        const struct potential *p, struct pose *pose, double *radius)
{
    struct pose next[GEAR_BODIES];
    double q[GEAR_FREE], ratio, gain, length, noise = 1e-15 * (1 + fabs(p->energy));

    memcpy(next, pose, (size_t)s->bodies * sizeof *next);
    if (!newton_step(p, *radius, q)) {
        enum status status = bounded_step(p, *radius, q);

        if (status != SW_OK)
            return status;
    }
    pose_move(f, q, next);
    length = norm(f->n, q);
    gain = promised(p, q);
    /* round-off of the energy is not to spoil the last steps */
    ratio = (p->energy - potential_energy(s, next, law) + noise) / (gain + noise);
    if (!(ratio > 0.1))
        *radius = length / 4;
    else if (ratio > 0.7 && length > *radius / 2)
        *radius = fmin(widest, 2 * *radius);
    if (ratio > 0.01)
        memcpy(pose, next, (size_t)s->bodies * sizeof *pose);
    return *radius > 1e-14 ? SW_OK : SW_NOCONV;
}

static int convex(const struct potential *p)
{
    double L[GEAR_FREE * GEAR_FREE];

    return factor(p, L) == SW_OK;
}

enum status descend(const struct gear *s, const struct freedom *f, const struct sling_law *law,
                    double tolerance, struct pose *pose, int *steps)
{
    double radius = widest / 4;

    for (int i = 0; i < STEPS; i++) {
        struct potential p;
        enum status status;

        potential_at(s, pose, f, law, &p);
        /* a minimum; or no step that the second derivative promises leads down: one held by edges
         * that are just touched */
        if (largest(f->n, p.gradient) <= tolerance && (radius < least_radius || convex(&p)))
            return SW_OK;
        status = step(s, f, law, &p, pose, &radius);
        if (status != SW_OK)
            return status;
        ++*steps;
    }
    return SW_NOCONV;
}
