/*
 * The second half of reading a case: judging keys against each other and filling in what follows
 * from others.
 */
#ifndef SEILWERK_FORM_RESOLVE_H
#define SEILWERK_FORM_RESOLVE_H

#include "form/cable.h"
#include "form/keys.h"

/* Resolve the taken keys of the model sections: EA, the unstressed length from whatever was given
 * for it, the cable in the plane of its load.  SW_FORMAT, SW_USAGE, SW_ADMISSIBLE; SW_INFEASIBLE:
 * no length has the given property; SW_NOMEM. */
enum status case_resolve_model(const struct reading *r, struct cable_case *c);

/* Resolve the taken keys of *c: the model, alpha and beta, three phases, the start, output_every,
 * the number of probes.  SW_FORMAT, SW_USAGE, SW_ADMISSIBLE with file and line. */
enum status case_resolve(const struct reading *r, struct cable_case *c);

#endif
