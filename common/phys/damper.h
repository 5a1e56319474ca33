/*
 * Complex modes of a cable with viscous dampers at points of it.
 *
 * A force at a point bends the cable sharply there, which neither a mesh nor a few modes can
 * follow: both are too stiff against it.  So the exact flexibility of the elastic catenary at the
 * dampers is used, and what the modes taken in lack of it is put into as many residual modes as
 * there are dampers, with the residual mass of the model.
 */
#ifndef SEILWERK_PHYS_DAMPER_H
#define SEILWERK_PHYS_DAMPER_H

#include "phys/modes.h"

struct damper {
    double position;     /* theta/L0, between 0 and 1 */
    double direction[3]; /* in space, any length > 0 */
    double coefficient;  /* [N s/m], >= 0 */
};

/* Modes, and their displacements at the dampers. */
struct damper_basis {
    int modes; /* taken in */
    int n;     /* with the residual ones */
    int dampers;
    double *omega; /* (n) [rad/s]; owned */
    double *value; /* (n, dampers), column-major [kg^(-1/2)]; owned */
    double *decay; /* (modes) of damper_solve [1/s]; owned */
    double *swing; /* (modes) circular frequency of damper_solve [rad/s]; owned */
};

/* Unit direction of d in the axes of the line's plane. */
void damper_direction(const struct damper *d, const struct axes *axes, double ret[3]);

/* Symmetric flexibility matrix [m/N] (n, n) of the line at the dampers, along their directions:
 * exact for small displacements of the elastic catenary.  SW_NOMEM, SW_INDEFINITE. */
enum status damper_flexibility(const struct line *s, const struct axes *axes,
                               const struct damper *d, int n, double *ret);

/* Basis of all modes in p and residual ones.  SW_NOMEM, SW_INDEFINITE, SW_NOCONV. */
enum status damper_basis_new(const struct model *m, const struct modes *p, const struct damper *d,
                             int n_dampers, struct damper_basis *ret);

void damper_basis_free(struct damper_basis *b);

/*
 * Complex modes lambda = -decay +- i swing with Rayleigh damping alpha, beta and the coefficients
 * of the dampers d; decay[k], swing[k] belong to the mode k of the basis that moves most in them. A
 * mode that creeps back has swing 0 and the slower of its two decays; NAN: none is left for it.
 * Time and memory as an eigenproblem of order 2 n.  SW_NOMEM, SW_NOCONV.
 */
enum status damper_solve(struct damper_basis *b, double alpha, double beta, const struct damper *d);

/* The coefficient of the one damper *d, between from and to, that damps mode k of the basis most;
 * to the square root of round-off.  As damper_solve. */
enum status damper_best(struct damper_basis *b, double alpha, double beta, int k, double from,
                        double to, struct damper *d);

/* Damping ratio -Re(lambda)/|lambda| of mode k after damper_solve. */
double damper_ratio(const struct damper_basis *b, int k);

#endif
