/*
 * Warnings of wirebeam: numbers that are surely wrong though they can be computed with, and what
 * the theory does not know.
 */
#ifndef SEILWERK_FORM_WIREDOUBT_H
#define SEILWERK_FORM_WIREDOUBT_H

#include "form/wirefiles.h"

/* Sections whose density, moduli or thickness cannot be meant. */
void wire_doubt(const struct wire *p);

/* Large strains, and elements that pass through each other.  SW_NOMEM. */
enum status wire_doubt_result(const struct wire *p, const struct wire_result *r);

#endif
