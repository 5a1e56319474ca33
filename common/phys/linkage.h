/*
 * The planar linkage of hook, spreader, load and slings from the measures of the check formulas.
 *
 * Hook at the origin, x to the right, z up.  Ends of the spreader at (-+ v tan(phi), -v), lifting
 * points of the load s lower and s tan(gamma) farther out, the load's centre of gravity z above
 * them and offset to the right.
 */
#ifndef SEILWERK_PHYS_LINKAGE_H
#define SEILWERK_PHYS_LINKAGE_H

#include "phys/gear.h"

struct linkage {
    double v, s, z;    /* heights [m]; s = 0: no spreader, slings from the hook to the load */
    double phi, gamma; /* angles from the vertical [rad]; gamma < 0: inwards going down */
    double m_spreader, m_load;           /* [kg]; a spreader counts at least 1e-8 of the load */
    double g;                            /* [m/s2] */
    double offset;                       /* of the load's centre of gravity to the right [m] */
    double radius_spreader, radius_load; /* of gyration [m]; 0: estimated from the widths */
    /* Elongation over stretched length, under the load as drawn without offset; 0: rigid. */
    double stretch_primary, stretch_secondary;
    int edges;        /* of the load on each side, 0 to 4, that the slings can lean on */
    double half[4];   /* distance of each from the middle [m], from above to below */
    double height[4]; /* above the lifting points [m] */
};

enum { LINKAGE_LOAD = 0, LINKAGE_SPREADER = 1 }; /* the bodies */

enum { LINKAGE_LEFT, LINKAGE_RIGHT, LINKAGE_SECOND_LEFT, LINKAGE_SECOND_RIGHT }; /* the slings */

/* NULL, or in words what is out of range: v <= 0, phi not in (0, 90) degrees, |gamma| >= 90
 * degrees, v tan(phi) + s tan(gamma) <= 0, masses, stretch not in [0, 1), anything that is no
 * number. */
const char *linkage_refused(const struct linkage *l);

/* SW_ADMISSIBLE if it is refused. */
enum status linkage_gear(const struct linkage *l, struct gear *ret);

#endif
