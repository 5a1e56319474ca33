/*
 * Large deformation by the document's own iteration (Koczyk, Fritzsche, Lenz, 2.4 and 2.5): load
 * steps, each with the linear stiffness of the geometry that the last one left, corrected by (50).
 *
 * There is no out-of-balance force: what it converges to as steps shrink is the displacement that
 * linear theory gives on the deformed geometry, V = K(V)^-1 F, and not the equilibrium.
 */
#ifndef SEILWERK_PHYS_UPDATED_H
#define SEILWERK_PHYS_UPDATED_H

#include "phys/follow.h"

/* Why the method does not take this frame, or NULL. */
const char *updated_refused(const struct frame *f);

/* o->parts equal steps to time 1 from the natural state s; a step is iterated until its
 * displacement changes by less than o->tolerance of itself.  w->end are the end forces of (38) on
 * the last geometry, in balance with the loads; the residual of a step is its last relative change.
 * SW_NOCONV: a step did not come to rest, or an element has lost its shape; SW_INDEFINITE with
 * failed_node; SW_NOMEM.  The path is to be freed in each case. */
enum status updated(const struct frame *f, const struct follow_options *o, struct frame_state *s,
                    struct frame_work *w, struct follow_path *ret);

#endif
