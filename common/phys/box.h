/*
 * Heights of a suspension whose quantities are known to lie in intervals: enclosures of h, of
 * h/r and of their derivatives by the inputs.  The formulas are those of phys/rigging.h.
 */
#ifndef SEILWERK_PHYS_BOX_H
#define SEILWERK_PHYS_BOX_H

#include "num/span.h"
#include "phys/rigging.h"

/* As struct rigging; span_none: not given. */
struct rigging_box {
    enum rigging_type type;
    int n; /* inputs */
    int stabilized;
    int one_hook; /* elastic slings of one end: no crosswise view */
    double slings;
    struct span v, s, z, phi, gamma, m_spreader, m_load, sling, base[RIGGING_VIEWS];
    struct span strain_wll, use, wll;
};

/* Height in the worst view, and the same over the tilt of the load, h/r.  Returns 0 if the box is
 * not surely within the ranges of rigging_complete (what is given twice is not compared; the same
 * of both is used as there). */
int rigging_box_height(const struct rigging_box *b, struct span *ret_h, struct span *ret_load);

#endif
