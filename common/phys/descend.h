/*
 * Downhill in the potential energy of a suspension whose slings all have a law: a trust-region
 * Newton method that ends in a minimum from any start.
 */
#ifndef SEILWERK_PHYS_DESCEND_H
#define SEILWERK_PHYS_DESCEND_H

#include "phys/potential.h"

/*
 * pose (bodies): start and result.  s free of dimension.  Ends where no component of the gradient
 * is above tolerance and the second derivative is not negative.  *steps counts on.
 * SW_NOCONV: not within 1000 steps.
 */
enum status descend(const struct gear *s, const struct freedom *f, const struct sling_law *law,
                    double tolerance, struct pose *pose, int *steps);

#endif
