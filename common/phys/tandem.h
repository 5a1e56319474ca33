/*
 * Lifts in space: one or two hooks, two or four slings a hook, with or without a spreader under
 * each.
 *
 * x lengthwise, y crosswise, z up; hooks at z = 0.  Measures as in linkage.h; points below a hook
 * lie symmetrically to its vertical: two slings at x = -+ half, four at x = -+ half, y = -+ cross.
 */
#ifndef SEILWERK_PHYS_TANDEM_H
#define SEILWERK_PHYS_TANDEM_H

#include "phys/gear.h"

struct tandem {
    int hooks;         /* 1 or 2 */
    double hook[2][2]; /* x, y of each [m] */
    int slings;        /* a hook: 2 or 4 */
    int spreaders;     /* 0: primary slings go to the load; 1: one under each hook */
    double v, s, z;    /* [m] as in linkage.h; s only with spreaders */
    double spreader_half, spreader_cross; /* points of a spreader [m] */
    double base_half, base_cross;         /* lifting points of the load [m] below each hook */
    double m_spreader, m_load;            /* [kg]; each spreader counts at least 1e-8 of the load */
    double g;                             /* [m/s2] */
    /* Of the load's centre of gravity from the middle of the hooks, along x and y [m]. */
    double offset[2];
    /* Of the load about its centre of gravity [kg m2]; all 0: that of a box round its points. */
    double inertia[3][3];
    /* Elongation over stretched length, under the load as drawn shared evenly; 0: rigid. */
    double stretch_primary, stretch_secondary;
};

enum { TANDEM_LOAD = 0, TANDEM_SPREADER = 1 }; /* the bodies: load, spreader 1, spreader 2 */

/* NULL or, in words, what is out of range. */
const char *tandem_refused(const struct tandem *t);

/* Slings: the primary ones hook by hook, those of a hook at (-, -), (+, -), (-, +), (+, +) of x and
 * y, or at -, + of x; then the secondary ones in the same order.  SW_ADMISSIBLE if refused. */
enum status tandem_gear(const struct tandem *t, struct gear *ret);

#endif
