/*
 * The cable element with cubic Hermite functions in each displacement (Thalheim 4.1, theory c2).
 *
 * Element of unstressed length h; 12 unknowns v1, v1,1, v2, v2,1, v3, v3,1 of its first node, then
 * of its second; v,1 is the derivative by theta.  Integrals use 5 Gauss points, at which the static
 * state of the cable (struct material) is stored once.
 */
#ifndef SEILWERK_PHYS_ELEMENT_H
#define SEILWERK_PHYS_ELEMENT_H

#include "phys/line.h"

#define GAUSS 5

enum law { LAW_HOOKE, LAW_THESIS, LAW_PRINTED }; /* theory section 2 */

/* Static state at one point and the law's coefficients there. */
struct material {
    double x1, x2;  /* tangent x,1 of the static line, not normalized; x3,1 = 0 */
    double EA;      /* modulus conjugate to Green's strain [N] */
    double T;       /* static force conjugate to Green's strain [N] */
    double stretch; /* a of the static line */
    double tension; /* physical static tension [N] */
};

/* The material of law at theta of the static line s. */
void material_at(const struct line *s, enum law law, double theta, struct material *ret);

/* Physical tension [N] of the moving cable with Green's strain gamma against the static state. */
double material_tension(const struct material *m, double gamma);

/* Its derivative by gamma at gamma = 0. */
double material_tension_rate(const struct material *m);

/* Abscissae in (0, 1) and weights (sum 1) of the Gauss rule. */
extern const double gauss_at[GAUSS], gauss_weight[GAUSS];

/* Values f and derivatives by theta f1 of the four Hermite functions at xi in [0, 1]; unknowns are
 * value and derivative by theta at both ends. */
void hermite(double h, double xi, double f[4], double f1[4]);

/* 4x4 consistent mass matrix of one displacement component, mass mu per length. */
void element_mass(double mu, double h, double ret[16]);

/* Element of length h with its material at the Gauss points: what the integrals need. */
struct element {
    double h;
    double slope[GAUSS][4];   /* f1 of hermite() */
    int first;                /* number of the first Gauss point in the cable */
    const struct material *m; /* GAUSS points */
};

/* Extremes met in element_force, for watching a motion. */
struct strain_watch {
    double least_force;    /* least EA gamma + T [N]; negative: a slack place in compression */
    double most_stiffened; /* largest 3 EA gamma/(EA a^2 + T) */
    int least_point;       /* its Gauss point, counted over the cable */
};

/*
 * F += internal forces at the displacements v (theory c2, A.502): K v, and F1, F2, F3 for terms
 * at least 1, 2, 3.  watch (updated, not started) may be NULL.
 */
void element_force(const struct element *e, int terms, const double v[12], double F[12],
                   struct strain_watch *watch);

/* Potential of element_force at v [N m], terms 0, 2 or 3: int EA gamma^2/2 + T w.w/2 and its parts.
 */
double element_potential(const struct element *e, int terms, const double v[12]);

/* v^T K v of the linear element: twice its strain energy [N m]. */
double element_strain_energy(const struct element *e, const double v[12]);

/* v^T M w, mass as from element_mass. */
double element_product(const double mass[16], const double v[12], const double w[12]);

/*
 * Tangent stiffness 12x12 at v, column-major; v = 0: the linear K.  Exact for terms 0, 2, 3; for
 * terms = 1, whose force has no potential, that of terms = 2.  With definite set it is that of all
 * terms, with T in place of a smaller EA gamma + T: positive definite also where the cable is
 * slack.
 */
void element_tangent(const struct element *e, int terms, int definite, const double v[12],
                     double ret[144]);

#endif
