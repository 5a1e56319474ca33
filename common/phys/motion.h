/*
 * Harmonic and recorded motions of the supports, switched on smoothly.
 *
 * u_i(t) = amplitude_i cos(omega t + phase_i) times 10 s^3 - 15 s^4 + 6 s^5, s = min(t/ramp, 1);
 * without a ramp the factor is 1, also at t < 0.  In a sweep its phase stands for omega t.  Several
 * motions add.
 */
#ifndef SEILWERK_PHYS_MOTION_H
#define SEILWERK_PHYS_MOTION_H

#include "phys/series.h"
#include "phys/sweep.h"

enum support { SUPPORT_RIGHT, SUPPORT_LEFT };

struct motion {
    enum support support;
    double amplitude[3]; /* [m], axes x1 x2 x3 */
    double omega;        /* [rad/s] */
    double phase[3];     /* [rad] */
    double ramp;         /* [s], 0: none */
    const struct series
        *record;               /* in place of amplitude, omega and phase [m]; or NULL; not owned */
    const struct sweep *sweep; /* in place of omega, or NULL; not owned */
};

/* The factor by which m is switched on at t. */
double motion_ramp(const struct motion *m, double t);

/* Sum of n motions at t: displacement u [m], velocity v [m/s], acceleration a [m/s2] of the left,
 * then of the right support, three axes each; v and a may be NULL. */
void motion_sum(const struct motion *m, int n, double t, double u[6], double v[6], double a[6]);

#endif
