/*
 * What an offset of the centre of gravity does to a suspension: tilt, forces in the slings,
 * righting moment and its range.
 *
 * First order in the tilt, as the heights of phys/rigging.h, but for what is said to be exact.  SI
 * units, angles in radians.  The slings of a side share its force equally.
 */
#ifndef SEILWERK_PHYS_RIGHTING_H
#define SEILWERK_PHYS_RIGHTING_H

#include "phys/rigging.h"

/* NAN: has no meaning for the type, or what it needs is not given. */
struct righting {
    double spreader;       /* tilt of the spreader, delta; NAN without one */
    double load;           /* tilt of the load, atan(r e/h); without a spreader r = 1 */
    double primary_low;    /* N, in each primary sling of the side that goes down */
    double primary_high;   /* N, of the other side; negative: it cannot bear what this needs */
    double secondary_low;  /* N, the same of the secondary slings */
    double secondary_high; /* N */
    double moment_0;       /* N m, initial righting moment of one sling, (W/n) h tan(phi) (1.3.1) */
    double moment;         /* N m, at the tilt of the offset */
    double range; /* rad, tilt at which a primary sling hangs plumb and the other is slack */
};

/*
 * In the given view, whose height is h, at the tilt tan(delta) = e/h >= 0 of the spreader, or of
 * the load where there is none; e is the offset of the centre of gravity.  NAN: forces without a
 * tilt.
 *
 * Primary slings: F = F0 (cos(delta) +- sin(delta)/tan(phi)), from (17), exact for rigid slings,
 * F0 = W/(n cos(phi)) with the slope in both views; at delta = phi the upper one is slack.  The
 * others by moments about the middle of the base, sides V = (W/2)(1 +- x): elastic slings
 * x = (e + z a)/B + a tan(phi), a tilt of the load, B half the base, crosswise without the last
 * term (26); secondary slings x = (mu/tan(phi) + tan(gamma)) tan(delta), the same with the h of
 * (15). Righting moment: M = (W/n) h cos(delta)(tan(phi) - tan^2(delta)/tan(phi)), tan(delta) =
 * e/h, which is the printed formula of 1.3.1: the moment of one sling's force about the centre of
 * gravity.
 */
void righting_at(const struct suspension *a, enum rigging_view view, double h, double tilt,
                 struct righting *ret);

/* Greatest and least force of the slings when they hang upright [N]: F0 primary, secondary. */
void righting_upright(const struct suspension *a, double *ret_primary, double *ret_secondary);

#endif
