/*
 * Geometry of a curved and twisted element (Koczyk, Fritzsche, Lenz, 2.1 and 2.2): the centre line
 * is cubic in z between its end slopes, z along the chord from end 1 to end 2; the section turns
 * about it by psi, linear in z or quadratic.
 *
 * Frames are 3 x 3, by rows: section axes x, y, then the tangent (A of (9)).  Regular for every
 * orientation: theory.md section 10 c7 replaces (21) and the angles of (6)-(8).
 */
#ifndef SEILWERK_PHYS_BOW_H
#define SEILWERK_PHYS_BOW_H

struct bow {
    double B[9];        /* chord axes x, y, z by rows (10) */
    double Lz;          /* chord [m] */
    double slope[2][2]; /* dx/dz, dy/dz at both ends (17) */
    double psi[2];      /* at the ends [rad] */
    double bulge;       /* psi in the middle beyond the mean of both [rad] */
};

/* A point of the centre line, in the chord axes, from end 1. */
struct bow_point {
    double p[3]; /* [m] */
    double t[3]; /* unit tangent */
    double C[9]; /* section frame (15) */
    double dsdz; /* (26) */
};

/* Chord axes of the direction e: x in the plane of e and z0, y level; phi_0 = 0 along z0. */
void bow_axes(const double e[3], double B[9]);

/* The section frame of a tangent t (t[2] > -1) turned by psi; all in chord axes. */
void bow_frame(const double t[3], double psi, double C[9]);

/* Through the points x1, x2 between end frames A1, A2 (global).  psi_2 is taken within half a turn
 * of psi_1 + twist.  Returns the larger end angle between tangent and chord [rad]; at pi/2 and
 * above there is no such bow and *ret is not complete.  A chord of length 0 gives pi. */
double bow_between(const double x1[3], const double x2[3], const double A1[9], const double A2[9],
                   double twist, double bulge, struct bow *ret);

/* Point at zeta = z/Lz in [0, 1]. */
void bow_at(const struct bow *b, double zeta, struct bow_point *ret);

double bow_psi(const struct bow *b, double zeta);

/* The section frame at zeta in global axes. */
void bow_global(const struct bow *b, double zeta, double A[9]);

#endif
