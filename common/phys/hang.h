/*
 * How a suspension hangs: equilibrium, forces in the slings, stability of the place.
 *
 * Equilibrium is a stationary point of the potential energy under L <= length for rigid slings,
 * whose forces are the multipliers: no penalty remains in the result.  All work is done free of
 * dimension (lengths, weight and g of gear_scale), so that units do not matter.
 */
#ifndef SEILWERK_PHYS_HANG_H
#define SEILWERK_PHYS_HANG_H

#include "phys/gear.h"

enum hang_way {
    HANG_NEAR, /* the equilibrium next to the start, stable or not: Newton */
    HANG_DOWN  /* downhill from the start to a stable one; there may be several, see offset.h */
};

struct hang {
    struct pose pose[GEAR_BODIES];
    double force[GEAR_SLINGS];  /* [N], 0: slack */
    double length[GEAR_SLINGS]; /* of the path [m] */
    int contacts[GEAR_SLINGS];  /* edges that the sling leans on */
    double energy;              /* against the place as drawn, slings without force [J] */
    double moment;              /* that holds the held body, about +y [N m]; 0: none is */
    /* Largest unbalanced force, or moment over the length of gear_scale, over the weight. */
    double residual;
    /* Least eigenvalue of the second derivative in the room of the taut rigid slings and without
     * neutral motions, free of dimension: > 0 stable, < 0 unstable; INFINITY: nothing can move. */
    double least;
    /* It is below 0, and yet the place is reached again from both sides: edges that are just
     * touched hold it (told by HANG_DOWN only). */
    int by_contact;
    /* Motions that cost nothing whatever the numbers: yaw about one hook, a bar about itself. */
    int neutral;
    /* Forces of rigid slings that equilibrium leaves open: those given have the least sum of
     * squares, and slings that would push are slack. */
    int indeterminate;
    int steps; /* of the iteration */
};

/*
 * Equilibrium from start (bodies; NULL: as drawn).  held: a body whose tilt stays that of start
 * (planar suspensions), or -1.  The residual is below 1e-10; above it only for elastic slings of
 * EA beyond 1e4 weights, whose forces are round-off of their lengths.
 * SW_NOCONV; SW_ADMISSIBLE: gear_check finds fault, or held in space.
 */
enum status hang(const struct gear *s, enum hang_way way, const struct pose *start, int held,
                 struct hang *ret);

/* The same from the equilibrium before, with the held body (or -1) turned by angle about y first;
 * the forces before are the first guess of those now. */
enum status hang_on(const struct gear *s, enum hang_way way, const struct hang *before, int held,
                    double angle, struct hang *ret);

#endif
