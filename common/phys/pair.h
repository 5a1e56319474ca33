/*
 * A load whose two ends hang in arrangements of their own, in space: the exact partner of the joint
 * metacentric height.
 *
 * The ends lie apart along y, each in the plane of x and z with the measures of linkage.h; their
 * shares of the mass tell the lever arms, e1 : e2 = m2 : m1.
 *
 * What both ends have in common is the tilt of the load.  An end whose spreader tilts by 1 tilts
 * the load by r_i (r = 1 - c s tan(gamma)/(v tan(phi) + s tan(gamma))) and rights it with
 * m_i g h_i.  Over the tilt of the load, then, h = sum m_i (h_i/r_i)/m.  The source's (36) adds the
 * h_i themselves, as if the spreaders tilted alike: with slings inwards (r_i > 1) on an end that
 * rights it is too high, and may call a lift stable that is not.
 */
#ifndef SEILWERK_PHYS_PAIR_H
#define SEILWERK_PHYS_PAIR_H

#include "phys/linkage.h"

struct pair {
    /* m_load is the share of the end, z its own; s = 0 and phi = 0: one sling of length v to one
     * point; g and the offset are those of the first; edges are not taken in. */
    struct linkage end[2];
    double apart;         /* distance of the ends [m] */
    double inertia[3][3]; /* of the load about its centre of gravity [kg m2]; all 0: estimated */
};

enum { PAIR_LOAD = 0 }; /* the body; spreaders follow in the order of the ends */

/* NULL or, in words, what is out of range. */
const char *pair_refused(const struct pair *p);

/* The load's centre of gravity is the origin.  Slings end by end, of each as in linkage.h.
 * SW_ADMISSIBLE if it is refused. */
enum status pair_gear(const struct pair *p, struct gear *ret);

#endif
