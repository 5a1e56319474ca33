/*
 * The model directory: matrices, static line and modes as .npy files, and the resolved case
 * (seilwerk-formats(5)).
 */
#ifndef SEILWERK_FORM_MODELDIR_H
#define SEILWERK_FORM_MODELDIR_H

#include "form/cable.h"
#include "phys/modes.h"

/* Make the directory if it is missing.  SW_WRITE. */
enum status modeldir_make(const char *dir, struct why *why);

/* Write all files into dir.  They are written beside their final
 * names and renamed together, case.ini last.  SW_WRITE, SW_USAGE, SW_NOMEM. */
enum status modeldir_write(const char *dir, const struct cable_case *c, const struct model *m,
                           const struct modes *modes, struct why *why);

/*
 * Read the modes of dir, after judging that the directory is whole and belongs to case c with model
 * m: same model keys, matrices equal to those assembled again within 1e-12 of the largest entry,
 * modes that solve K phi = omega^2 M phi with phi^T M phi = 1.  A directory of another model,
 * damaged or mixed: SW_FORMAT; SW_READ, SW_NOMEM.
 */
enum status modeldir_read(const char *dir, const struct cable_case *c, const struct model *m,
                          struct modes *ret, struct why *why);

#endif
