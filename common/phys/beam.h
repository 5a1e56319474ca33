/*
 * The linear curved element (Koczyk, Fritzsche, Lenz, 2.3): flexibility by Castigliano, stiffness,
 * loads along the curve, consistent mass.
 *
 * All in the chord axes of the element's bow; forces at end 1 in the order Fx Fy Fz Mx My Mz, with
 * end 2 clamped.  Matrices column-major.
 */
#ifndef SEILWERK_PHYS_BEAM_H
#define SEILWERK_PHYS_BEAM_H

#include "phys/bow.h"
#include "phys/section.h"

struct beam {
    struct bow bow;
    double length;     /* of the curve [m] */
    double K[36];      /* F^-1 (32): force at end 1 by its displacement */
    double spread[18]; /* (6, 3): displacement of end 1 by a load of 1 N/m along each axis */
    double S[3];       /* int (p - p_2) ds [m2] */
};

/* The element on this bow.  SW_INDEFINITE: it has no stiffness (NaN, no length). */
enum status beam_new(const struct bow *bow, const struct section *section, struct beam *ret);

/* K (12, 12) of (37) in global axes, u1 phi1 u2 phi2. */
void beam_stiffness(const struct beam *b, double K[144]);

/* Loads (12) of the ends in global axes that stand for q [N/m, global], in linear theory. */
void beam_loads(const struct beam *b, const double q[3], double ret[12]);

/* Section forces N, Mx, My, Mt at zeta of a bow under the force F and moment M (global) at end 1
 * and the load q [N/m, global] per length of the bow, end 1 to there being `s` long; first its
 * arc length and the integral of position over it (chord axes), as bow_run makes them. */
struct bow_run {
    double zeta, s, c[3];
};
void bow_run_to(const struct bow *b, double zeta, struct bow_run *r);
void beam_section(const struct bow *b, const struct bow_run *at, const double F[3],
                  const double M[3], const double q[3], double ret[4]);

/* Consistent mass (12, 12), global axes, with the rotary inertia of the sections. */
void beam_mass(const struct beam *b, const struct section *section, double M[144]);

#endif
