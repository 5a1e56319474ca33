/*
 * Small vibrations of a frame about the state it is in: consistent mass of the curved elements.
 */
#ifndef SEILWERK_PHYS_VIBRATE_H
#define SEILWERK_PHYS_VIBRATE_H

#include "phys/frame.h"

/* Mass of the frame in state s at the places of w->K (w->K.entries).  SW_NOMEM; SW_INDEFINITE: an
 * element has become shapeless. */
enum status vibrate_mass(const struct frame *f, const struct frame_state *s,
                         const struct frame_work *w, double *M);

/* The k lowest modes: squares of the angular frequencies lambda [1/s2], ascending, negative where
 * the state is unstable; shapes (n, 6, k) with unit modal mass, spins as rotations.  w->K belongs
 * to s, as frame_evaluate leaves it.  1 <= k <= unknowns.  Failures as above and of
 * subspace_lowest. */
enum status vibrate(const struct frame *f, const struct frame_state *s, struct frame_work *w, int k,
                    double *lambda, double *shape);

#endif
