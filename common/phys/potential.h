/*
 * Potential energy of a suspension in a pose, with its first and second derivatives.
 *
 * E = sum m g z + sum of the slings' energies; forces are -dE/dx.  The law of every sling is
 * T = max(0, before + stiffness (L - length)), its energy T^2/(2 stiffness): an elastic one has
 * before = 0 and stiffness EA/length.  The law of a rigid one is the caller's: force and stiffness
 * make E the augmented Lagrangian function; a force of either sign without stiffness, of energy
 * before (L - length), makes it the Lagrangian function.
 */
#ifndef SEILWERK_PHYS_POTENTIAL_H
#define SEILWERK_PHYS_POTENTIAL_H

#include "phys/gear.h"

struct sling_law {
    double before, stiffness;
};

struct potential {
    int n; /* free motions */
    double energy;
    double gradient[GEAR_FREE];      /* (n) */
    double H[GEAR_FREE * GEAR_FREE]; /* (n, n) */
    double length[GEAR_SLINGS];      /* of the path */
    double force[GEAR_SLINGS];
    int contacts[GEAR_SLINGS];         /* corners touched */
    double J[GEAR_FREE * GEAR_SLINGS]; /* (n, slings): gradients of the lengths */
};

/* The laws of the elastic slings; rigid ones get the forces given, force (slings), no stiffness. */
void potential_laws(const struct gear *s, const double *force, struct sling_law *law);

/* Everything at the pose; law (slings).  Weight counts from z = 0. */
void potential_at(const struct gear *s, const struct pose *pose, const struct freedom *f,
                  const struct sling_law *law, struct potential *ret);

/* The energy alone. */
double potential_energy(const struct gear *s, const struct pose *pose, const struct sling_law *law);

#endif
