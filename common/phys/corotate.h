/*
 * Exact end forces and stiffness of the curved element in large displacements and rotations.
 *
 * The element keeps its natural shape; the deformation is measured against it in a frame midway
 * between its ends (theory.md section 10 c7).  Its stretch is that of its axis, bent between the
 * ends: the distance of the ends, and what a cubic with their slopes has more.  So a taut wire
 * whose ends turn does not get shorter by it, and bending in a plane is of order 4.  End forces are
 * the gradient of an energy, so they are objective, in balance, and do no work round a closed path.
 */
#ifndef SEILWERK_PHYS_COROTATE_H
#define SEILWERK_PHYS_COROTATE_H

#include "phys/beam.h"

/* An element's natural quantities as they are needed here; a spring has them, too. */
struct corotate {
    const double *B;      /* (9) axes by rows in which all is given */
    const double *K;      /* (6, 6) */
    double D[3];          /* natural end 1 - end 2 */
    int chord;            /* whether D lies along the third axis, that of a bent beam */
    const double *spread; /* (6, 3), or NULL: never loaded */
    const double *S;      /* (3) */
    double length;
};

struct corotated {
    double energy;    /* of deformation, and of the load q [N m]; a constant is left out */
    double force[12]; /* by which the ends are held: global force and moment at 1, at 2 */
    double angle;     /* by which the ends have turned against each other [rad], below pi */
    double G[9];      /* element axes to global */
    double deform[6]; /* of end 1 against end 2, element axes */
};

/* The natural element. */
struct corotate corotate_beam(const struct beam *b);

/* d = x1 - x2; q1, q2 rotations of the ends from the natural state; q load [N/m, global] or NULL.
 * K (12, 12), or NULL: derivative of the forces by displacements and spins (global), its symmetric
 * part.  What it lacks is -1/2 of each end moment's spin: it cancels where moments of all elements
 * at a node balance.  guess (6), or NULL: forces at end 1 by which the geometric part of K is made
 * in place of the true ones. */
void corotate(const struct corotate *e, const double d[3], const double q1[4], const double q2[4],
              const double *q, const double *guess, struct corotated *ret, double *K);

/*
 * The forces at end 1 (element axes) that small moves du (12) of the ends lead to, in linear theory
 * from here.  Moves along a tangent stretch thin wires, and false tensions stiffen the next step of
 * Newton's method; these forces are free of that (forces as unknowns of their own, condensed).
 */
void corotate_foresee(const struct corotate *e, const double d[3], const double q1[4],
                      const double q2[4], const double *q, const double du[12], double f[6]);

#endif
