/*
 * The second half of reading a case: judging keys against each other and filling in what follows
 * from others.
 */
#ifndef SEILWERK_FORM_RESOLVE_H
#define SEILWERK_FORM_RESOLVE_H

#include "form/cable.h"
#include "form/keys.h"

/* Resolve the taken keys of *c: EA, alpha and beta, three phases, the start, output_every, the
 * number of probes.  SW_FORMAT, SW_USAGE, SW_ADMISSIBLE with file and line. */
enum status case_resolve(const struct reading *r, struct cable_case *c);

#endif
