/*
 * Matrices and vectors of a model between the axes of the line's plane and those of space.
 */
#ifndef SEILWERK_PHYS_TURN_H
#define SEILWERK_PHYS_TURN_H

#include "phys/model.h"

/* A over all nodes (PART_ALL), from the axes of the plane to those of space. */
void turn_matrix(const struct axes *axes, struct band *A);

enum turn { TURN_TO_SPACE, TURN_TO_PLANE };

/* A vector of the 6 n free unknowns. */
void turn_free(const struct axes *axes, enum turn to, int n, double *x);

#endif
