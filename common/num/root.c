/* Root and least value of a function of one number. */
#include "num/root.h"

#include <float.h>
#include <math.h>

#define MAX_STEPS 200

/*
 * Next place within the bracket as a fraction from x1 to x2, by the three last points: inverse
 * quadratic interpolation if its curve is monotonous between them, else the middle.
 */
static double next_fraction(double x1, double f1, double x2, double f2, double x3, double f3)
{
    double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);

    if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi))
        return 0.5;
    return f1 / (f2 - f1) * (f3 / (f2 - f3)) +
           (x3 - x1) / (x2 - x1) * (f1 / (f3 - f1)) * (f2 / (f3 - f2));
}

double root_between(scalar_function *f, void *context, double a, double fa, double b, double fb)
{
    double x1 = a, f1 = fa, x2 = b, f2 = fb, x3, f3, t = 0.5;

    for (int step = 0; step < MAX_STEPS; step++) {
        double best = fabs(f1) < fabs(f2) ? x1 : x2, least = fmin(fabs(f1), fabs(f2)), x, fx;
        double limit = (2 * DBL_EPSILON * fabs(best) + DBL_MIN) / fabs(x2 - x1);

        if (least == 0 || !(limit < 0.5))
            return best;
        t = fmin(fmax(t, limit), 1 - limit);
        x = x1 + t * (x2 - x1);
        fx = f(x, context);
        if (isnan(fx))
            return NAN;
        x3 = x1;
        f3 = f1;
        if ((fx > 0) != (f1 > 0)) {
            x3 = x2;
            f3 = f2;
            x2 = x1;
            f2 = f1;
        }
        x1 = x;
        f1 = fx;
        t = next_fraction(x1, f1, x2, f2, x3, f3);
    }
    return fabs(f1) < fabs(f2) ? x1 : x2;
}

double least_between(scalar_function *f, void *context, double a, double b, double *ret_f)
{
    const double golden = 0.61803398874989484820;
    double x1 = b - golden * (b - a), x2 = a + golden * (b - a);
    double f1 = f(x1, context), f2 = f(x2, context);

    for (int step = 0; step < MAX_STEPS && fabs(x2 - x1) > 1e-9 * (fabs(x1) + fabs(x2)); step++) {
        if (f1 < f2) {
            b = x2;
            x2 = x1;
            f2 = f1;
            x1 = b - golden * (b - a);
            f1 = f(x1, context);
        } else {
            a = x1;
            x1 = x2;
            f1 = f2;
            x2 = a + golden * (b - a);
            f2 = f(x2, context);
        }
        if (isnan(f1) || isnan(f2))
            break;
    }
    *ret_f = f1 < f2 ? f1 : f2;
    return isnan(f1 + f2) ? NAN : f1 < f2 ? x1 : x2;
}
