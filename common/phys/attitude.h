/*
 * Attitudes of bodies: matrices, by rows, whose columns are the turned axes.
 */
#ifndef SEILWERK_PHYS_ATTITUDE_H
#define SEILWERK_PHYS_ATTITUDE_H

/* R = exp(w^): turns by |w| radians about w. */
void attitude_matrix(const double w[3], double R[9]);

/* w of R, |w| <= pi. */
void attitude_vector(const double R[9], double w[3]);

/* R = exp(w^) R: turned further, about axes of space. */
void attitude_turn(const double w[3], double R[9]);

#endif
