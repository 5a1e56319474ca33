/* Irvine's closed theory of cables with small sag. */
#include "phys/irvine.h"
#include "num/pi.h"
#include "num/root.h"

#include <math.h>

/* What the equation is at y = x/2 = (k - 1/2) pi + delta. */
struct symmetric {
    double lambda2, start;
};

/* The equation times lambda2, its sine and cosine turned by (k - 1/2) pi: no pole, and no loss
 * where lambda2 is small and delta with it. */
static double equation(double delta, void *context)
{
    const struct symmetric *e = context;
    double y = e->start + delta;

    return e->lambda2 * cos(delta) - y * (4 * y * y - e->lambda2) * sin(delta);
}

double irvine_symmetric_root(double lambda2, int k)
{
    struct symmetric e = {lambda2, (k - 0.5) * PI};

    if (!(lambda2 > 0))
        return 2 * e.start;
    return 2 * (e.start + root_between(equation, &e, 0, lambda2, PI, -lambda2));
}

/* sqrt(Tc/m)/Lc: frequency of the root x = 1. */
static double unit(const struct line *s)
{
    const struct cable *c = &s->cable;
    double d = line_chord(c);

    return sqrt(s->H * d / c->span / (c->mu * c->L0 / d)) / d;
}

double irvine_symmetric(const struct line *s, int k)
{
    double m = s->cable.mu * s->cable.L0 / line_chord(&s->cable);

    return irvine_symmetric_root(line_lambda2(s, m), k) * unit(s);
}

double irvine_antisymmetric(const struct line *s, int k)
{
    return 2 * k * PI * unit(s);
}

double irvine_lateral(const struct line *s, int k)
{
    return k * PI * unit(s);
}
