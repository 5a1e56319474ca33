/* Motions of the supports. */
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

double motion_ramp(const struct motion *m, double t)
{
    double r[3];

    ramp_at(m->ramp, t, r);
    return r[0];
}

/* The motion without its ramp: displacement, velocity, acceleration. */
static void unramped(const struct motion *m, double t, double u[3], double v[3], double a[3])
{
    double phase = m->omega * t, omega = m->omega, rate = 0;

    if (m->record) {
        series_at(m->record, t, u, v, a);
        return;
    }
    if (m->sweep)
        sweep_at(m->sweep, t, &phase, &omega, &rate);
    for (int i = 0; i < 3; i++) {
        double arg = phase + m->phase[i];

        u[i] = v[i] = a[i] = 0;
        if (m->amplitude[i] == 0)
            continue;
        u[i] = m->amplitude[i] * cos(arg);
        v[i] = -m->amplitude[i] * omega * sin(arg);
        a[i] = -omega * omega * u[i] - m->amplitude[i] * rate * sin(arg);
    }
}

static void add(const struct motion *m, double t, double *u, double *v, double *a)
{
    double r[3], u0[3], v0[3], a0[3];

    ramp_at(m->ramp, t, r);
    unramped(m, t, u0, v0, a0);
    for (int i = 0; i < 3; i++) {
        u[i] += r[0] * u0[i];
        if (v)
            v[i] += r[1] * u0[i] + r[0] * v0[i];
        if (a)
            a[i] += r[2] * u0[i] + 2 * r[1] * v0[i] + r[0] * a0[i];
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
