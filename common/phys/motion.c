/* Harmonic motions of the supports. */
#include "phys/motion.h"

#include <math.h>

/* Ramp r and its first two derivatives by time. */
static void ramp_at(double ramp, double t, double r[3])
{
    double s = ramp > 0 ? t / ramp : 1;

    r[0] = s >= 1;
    r[1] = r[2] = 0;
    if (s > 0 && s < 1) {
        r[0] = s * s * s * (10 + s * (6 * s - 15));
        r[1] = 30 * s * s * (s - 1) * (s - 1) / ramp;
        r[2] = 60 * s * (2 * s - 1) * (s - 1) / (ramp * ramp);
    }
}

static void add(const struct motion *m, double t, double *u, double *v, double *a)
{
    double r[3];

    ramp_at(m->ramp, t, r);
    for (int i = 0; i < 3; i++) {
        double arg = m->omega * t + m->phase[i], c0, c1;

        if (m->amplitude[i] == 0)
            continue;
        c0 = m->amplitude[i] * cos(arg);
        u[i] += r[0] * c0;
        if (!v && !a)
            continue;
        c1 = -m->amplitude[i] * m->omega * sin(arg);
        if (v)
            v[i] += r[1] * c0 + r[0] * c1;
        if (a)
            a[i] += r[2] * c0 + 2 * r[1] * c1 - r[0] * m->omega * m->omega * c0;
    }
}

void motion_sum(const struct motion *m, int n, double t, double u[6], double v[6], double a[6])
{
    for (int i = 0; i < 6; i++) {
        u[i] = 0;
        if (v)
            v[i] = 0;
        if (a)
            a[i] = 0;
    }
    for (int k = 0; k < n; k++) {
        int at = m[k].support == SUPPORT_LEFT ? 0 : 3;

        add(&m[k], t, u + at, v ? v + at : 0, a ? a + at : 0);
    }
}
