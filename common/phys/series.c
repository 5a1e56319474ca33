/* Cubic splines by their slopes. */
#include "phys/series.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Slope at the end that is sample i, towards j and k, of the parabola through the three. */
static double end_slope(const struct series *s, int c, int i, int j, int k)
{
    double h = s->t[j] - s->t[i], g = s->t[k] - s->t[j];
    double first = (s->x[c + 3 * j] - s->x[c + 3 * i]) / h;
    double second = (s->x[c + 3 * k] - s->x[c + 3 * j]) / g;

    return first - h * (second - first) / (h + g);
}

/*
 * Slopes m of component c: with h the intervals and d the differences over them,
 *     m[i-1]/h[i-1] + 2 (1/h[i-1] + 1/h[i]) m[i] + m[i+1]/h[i] = 3 (d[i-1]/h[i-1] + d[i]/h[i]).
 * Elimination from the left; factor: n places of work.
 */
static void find_slopes(struct series *s, int c, double *factor)
{
    const double *t = s->t, *x = s->x + c;
    double *m = s->slope + c;
    int n = s->n;

    if (n == 2) {
        m[0] = m[3] = (x[3] - x[0]) / (t[1] - t[0]);
        return;
    }
    m[0] = end_slope(s, c, 0, 1, 2);
    m[3 * (n - 1)] = end_slope(s, c, n - 1, n - 2, n - 3);
    factor[0] = 0;
    for (int i = 1; i < n - 1; i++) {
        double left = 1 / (t[i] - t[i - 1]), right = 1 / (t[i + 1] - t[i]);
        double sum = 3 * ((x[3 * i] - x[3 * i - 3]) * left * left +
                          (x[3 * i + 3] - x[3 * i]) * right * right);
        double pivot = 2 * (left + right) - left * factor[i - 1];

        if (i == n - 2)
            sum -= right * m[3 * (n - 1)];
        m[3 * i] = (sum - left * m[3 * i - 3]) / pivot;
        factor[i] = i == n - 2 ? 0 : right / pivot;
    }
    for (int i = n - 3; i > 0; i--)
        m[3 * i] -= factor[i] * m[3 * i + 3];
}

enum status series_new(int n, const double *t, const double *x, struct series *ret)
{
    double *work;

    *ret = (struct series){.n = n};
    if (n < 2)
        return SW_ADMISSIBLE;
    for (int i = 1; i < n; i++)
        if (!(t[i] > t[i - 1]))
            return SW_ADMISSIBLE;
    ret->t = mem_copy(t, sizeof *t * (size_t)n);
    ret->x = mem_copy(x, 3 * sizeof *x * (size_t)n);
    ret->slope = mem_doubles(3 * (size_t)n);
    work = mem_doubles((size_t)n);
    if (!ret->t || !ret->x || !ret->slope || !work) {
        free(work);
        series_free(ret);
        return SW_NOMEM;
    }
    for (int c = 0; c < 3; c++)
        find_slopes(ret, c, work);
    free(work);
    return SW_OK;
}

void series_free(struct series *s)
{
    free(s->t);
    free(s->x);
    free(s->slope);
    *s = (struct series){0};
}

/* The i with t[i] <= t < t[i + 1]. */
static int find_interval(const struct series *s, double t)
{
    int low = 0, high = s->n - 1;

    while (high - low > 1) {
        int middle = low + (high - low) / 2;

        if (s->t[middle] <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}

void series_at(const struct series *s, double t, double x[3], double v[3], double a[3])
{
    int outside = t < s->t[0] || t > s->t[s->n - 1];
    double at = fmin(fmax(t, s->t[0]), s->t[s->n - 1]);
    int i = find_interval(s, at);
    double h = s->t[i + 1] - s->t[i], r = (at - s->t[i]) / h;

    for (int c = 0; c < 3; c++) {
        double x0 = s->x[c + 3 * i], rise = s->x[c + 3 * i + 3] - x0;
        double m0 = h * s->slope[c + 3 * i], m1 = h * s->slope[c + 3 * i + 3];
        double p = 3 * rise - 2 * m0 - m1, q = m0 + m1 - 2 * rise;

        x[c] = x0 + r * (m0 + r * (p + r * q));
        if (v)
            v[c] = outside ? 0 : (m0 + r * (2 * p + 3 * r * q)) / h;
        if (a)
            a[c] = outside ? 0 : (2 * p + 6 * r * q) / (h * h);
    }
}
