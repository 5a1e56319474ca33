/*
 * What a mode looks like: its kind, and how much of it a moving support excites.
 */
#ifndef SEILWERK_PHYS_SHAPE_H
#define SEILWERK_PHYS_SHAPE_H

#include "phys/model.h"

enum mode_kind { KIND_SYMMETRIC, KIND_ANTISYMMETRIC, KIND_AXIAL };

struct character {
    enum mode_kind kind;
    double symmetry; /* V^T M P V/V^T M V, P the mirror image in the plane that halves the chord at
                        right angles: 1 symmetric, -1 antisymmetric; both exactly in level cables */
    double axial;    /* share of the motion along the cable in the kinetic energy, 0 to 1 */
};

/* Character of the mode V (all nodes).  Axial: more than half of its energy moves along the cable;
 * else by the sign of the symmetry. */
void shape_character(const struct model *m, const double *V, struct character *ret);

/*
 * Participation of the mode V (all nodes, V^T M V = 1) with circular frequency omega in unit
 * motions of the left, then of the right support along x1, x2, x3 [kg^(1/2)]: with b(t) the
 * supports' displacements and quasi-static motion taken off, q'' + omega^2 q = -ret . b''.  The
 * sums over all modes of the squares are the masses that each motion carries.
 */
void shape_participation(const struct model *m, const double *V, double omega, double ret[6]);

#endif
