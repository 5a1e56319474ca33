/*
 * A centre of gravity that is not where it was drawn: the equilibrium that is reached when it moves
 * there slowly.
 *
 * Of several stable places this is the one that the upright one turns into; the way downhill from
 * the drawing may end in another, when the offset is large.
 */
#ifndef SEILWERK_PHYS_OFFSET_H
#define SEILWERK_PHYS_OFFSET_H

#include "phys/hang.h"

/*
 * s and its stable equilibrium h are taken to where the centre of gravity of body has been shifted
 * by shift [m] from where it is in s, along the axes of the drawing.  *ret_share: 1, or the share
 * of the shift at which stability is lost; s and h are those just before. SW_INFEASIBLE: it is lost
 * on the way; SW_ADMISSIBLE: no such body, no finite shift.
 */
enum status offset_shift(struct gear *s, int body, const double shift[3], struct hang *h,
                         double *ret_share);

#endif
