/*
 * Slow sweeps of the excitation's frequency, with continuous phase.
 *
 * phase(t) = integral of Omega.  Continuous: Omega = from + rate t; in steps: Omega stays for a
 * number of whole periods, then changes by the step.  Both may return: from - to - from.
 */
#ifndef SEILWERK_PHYS_SWEEP_H
#define SEILWERK_PHYS_SWEEP_H

#include "num/status.h"

struct sweep {
    double from, to; /* [rad/s], > 0, not equal */
    double rate;     /* [rad/s2], > 0; else: in steps */
    double step;     /* [rad/s], > 0: in steps */
    int dwell;       /* periods at each step, >= 1 */
    int back;        /* whether it returns */
    int n;           /* frequencies of all steps, the way back included */
    double *start;   /* (n + 1) times at which they begin [s]; owned */
    double duration; /* [s] */
};

/* Lay out *s from its first six fields.  SW_ADMISSIBLE: more than 1e7 steps; SW_NOMEM. */
enum status sweep_new(struct sweep *s);

void sweep_free(struct sweep *s);

/* Phase [rad], Omega [rad/s] and its rate [rad/s2] at t; before the start and behind the end Omega
 * is constant. */
void sweep_at(const struct sweep *s, double t, double *phase, double *omega, double *rate);

/* 1 while Omega rises at t, -1 while it falls. */
int sweep_direction(const struct sweep *s, double t);

#endif
