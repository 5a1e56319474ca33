/*
 * Small motions about an equilibrium: omega^2, their shapes in words, metacentric heights.
 */
#ifndef SEILWERK_PHYS_SWAY_H
#define SEILWERK_PHYS_SWAY_H

#include "phys/hang.h"

enum sway_kind {
    SWING_LENGTHWISE, /* shift along x */
    SWING_CROSSWISE,  /* along y */
    HEAVE,            /* along z */
    TILT_CROSSWISE,   /* turn about x */
    TILT_LENGTHWISE,  /* about y */
    YAW,              /* about z */
    SWAY_KINDS
};

/* Modes in the order of omega^2, which is negative where the equilibrium is unstable. */
struct sway {
    int n;                    /* modes */
    int neutral;              /* left out: they cost nothing, hang.h */
    double omega2[GEAR_FREE]; /* [1/s2] */
    /* Shifts of the centres of gravity and turns; sum of (mass, inertia) times squares = 1. */
    double shape[GEAR_FREE][GEAR_BODIES][6];
    double share[GEAR_FREE][SWAY_KINDS]; /* of the kinetic energy, over all bodies */
    int body[GEAR_FREE];                 /* that has most of it */
    enum sway_kind kind[GEAR_FREE];      /* the largest share of that body's */
};

/*
 * All small motions about h, an equilibrium of s (no body held).  A mass or moment of inertia below
 * 1e-6 of the largest one (times length^2) counts as that: signs do not depend on it.
 * SW_NOCONV.
 */
enum status sway_of(const struct gear *s, const struct hang *h, struct sway *ret);

/* "tilt lengthwise", "swing crosswise", "heave", "yaw", ... */
const char *sway_words(enum sway_kind kind);

/*
 * Metacentric height [m]: horizontal offset of the centre of gravity of body load over the tilt of
 * body tilted that it brings about, to first order; lengthwise (offset along x) or crosswise (y).
 * Negative or zero: not stable.  INFINITY where nothing tilts.  Exact: the formulas for h are this
 * with the spreader as tilted (primary-secondary) or the load (elastic primary).
 */
double sway_height(const struct gear *s, const struct sway *m, int load, int tilted, int crosswise);

#endif
