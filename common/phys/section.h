/*
 * Cross sections of wires: shapes by name, stiffness, stresses.
 *
 * Section axes x and y, right-handed with the tangent t.  Section forces and strains in the order
 * N, Mx, My, Mt; strain, curvature about x, about y, twist.
 */
#ifndef SEILWERK_PHYS_SECTION_H
#define SEILWERK_PHYS_SECTION_H

#include "num/status.h"

enum section_shape {
    SECTION_ROUND,     /* diameter */
    SECTION_TUBE,      /* outer diameter, wall */
    SECTION_RECTANGLE, /* width along x, height along y */
    SECTION_VALUES,    /* area, Ixx, Iyy, It given */
    SECTION_GENERAL    /* the whole stiffness given */
};

struct section {
    enum section_shape shape;
    double E, G;            /* [Pa] */
    double diameter, wall;  /* [m] */
    double width, height;   /* [m] */
    double area;            /* [m2] */
    double Ixx, Iyy, It;    /* [m4]; Ixx = int y^2 dA */
    double ex, ey, Wt;      /* largest |x| and |y| [m], Mt/Wt the largest shear stress [m3]; NAN */
    double mass;            /* [kg/m] */
    double inertia[3];      /* of rotation about x, y, t per metre [kg m] */
    double stiffness[16];   /* section forces by strains, symmetric */
    double flexibility[16]; /* its inverse, H of (28) */
};

/* St. Venant's torsion constant of a rectangle [m4], and Wt [m3]: series in tanh and 1/cosh. */
double section_rectangle_torsion(double width, double height, double *ret_Wt);

/* From shape and measures (area ... It of SECTION_VALUES; stiffness, mass and inertia of
 * SECTION_GENERAL) and density [kg/m3] everything else.  SW_INDEFINITE: the stiffness is not
 * positive definite. */
enum status section_complete(struct section *s, double density);

/* Stresses of a section under N, Mx, My, Mt [Pa]. */
struct section_stress {
    double axial;   /* N/area */
    double bending; /* largest of bending alone */
    double shear;   /* largest of torsion */
    double most;    /* |axial| + bending */
    double mises;   /* sqrt(most^2 + 3 shear^2): exact for round sections, a bound for others */
};

/* What is not known of the section is NAN. */
struct section_stress section_stresses(const struct section *s, const double force[4]);

#endif
