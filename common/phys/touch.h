/*
 * A continuous rope over a plane bed, between two points of one vertical plane: its ends hang, its
 * middle lies (theory c5, and the same on a slope); or it hangs free.
 *
 * The bed pushes at right angles to itself and holds the rope in its plane.  Friction acts along
 * the rope, against a rope that is pulled from one end towards it, until no tension is left; where
 * both ends are alike it acts from both towards the middle of what lies, and takes nothing from the
 * ends. What no tension holds stays where it is if friction can hold it on the slope, else it
 * gathers at the lower end.
 */
#ifndef SEILWERK_PHYS_TOUCH_H
#define SEILWERK_PHYS_TOUCH_H

#include "num/status.h"

enum touch_pulled { TOUCH_ALIKE, TOUCH_PULLED_A, TOUCH_PULLED_B };

struct touch_rope {
    double L0, w, EA; /* [m], weight > 0 [N/m], [N] */
    double friction;
    enum touch_pulled pulled;
};

/* Where the ends are: a at 0, b at x >= 0; heights over the bed, straight up, >= 0; the bed rises
 * by slope from a to b. */
struct touch_place {
    double x, slope, h[2];
};

struct touch {
    int lies;          /* 0: hangs free */
    double H[2], V[2]; /* pull of the rope on a and b: towards the other end, down [N] */
    double J[4][4];    /* d(H_a, V_a, H_b, V_b)/d(x, slope, h_a, h_b) */
    /* of one that lies: */
    double s[2];     /* unstretched length that hangs at a and b [m] */
    double T[2];     /* tension where it meets the bed there [N] */
    double flat;     /* unstretched length that lies [m] */
    double heap;     /* of it, gathered at the lower end */
    double fall[2];  /* by which the tension falls from there on: along `reach` [N/m] */
    double reach[2]; /* unstretched length along which it falls, seen from a and b [m] */
};

/* SW_NOCONV (not seen). */
enum status touch_solve(const struct touch_rope *r, const struct touch_place *p, struct touch *ret);

#endif
