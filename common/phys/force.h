/*
 * Internal forces of all elements of a model at once, and their tangent: what a march spends its
 * time on.
 *
 * The same sums as element_force, four elements side by side in vector registers, from tables that
 * are laid out for that.  Results agree with element_force to round-off; their last digits may
 * differ between processors.
 */
#ifndef SEILWERK_PHYS_FORCE_H
#define SEILWERK_PHYS_FORCE_H

#include "phys/model.h"

/* Where an entry of an element's tangent comes from and goes to. */
struct tangent_entry {
    int from, to; /* sum of force_tangent; place behind the element's first one in the band */
    double sign;
};

struct force_table {
    int n, groups;           /* elements; groups of four of them, the last one filled up */
    double factor[GAUSS][3]; /* Hermite slopes: of the difference of the ends, of both slopes */
    double *material; /* (groups, GAUSS, 5, 4): x1, x2, weighted EA and T, stiffening; owned */
    struct tangent_entry entry[78]; /* of the lower half of 12 x 12 */
    double *v, *f;                  /* unknowns and forces by component, (6, 4 groups + 4); owned */
};

/* Extremes met: both for the sign and the largest value only. */
struct force_extremes {
    double least_force;    /* negative where EA gamma + T is, somewhere */
    double most_stiffened; /* largest 3 EA gamma/(EA a^2 + T) */
};

/* SW_NOMEM. */
enum status force_new(const struct model *m, struct force_table *ret);

void force_free(struct force_table *t);

/* F = internal forces at V over all nodes; terms as in element_force. */
void force_all(struct force_table *t, int terms, const double *V, double *F,
               struct force_extremes *ret);

/* J += factor times the tangent of these forces at V; J is over all nodes, half bandwidth 11. terms
 * = 1, whose tangent is not symmetric: the symmetric one with F2's part, as in element_tangent. */
void force_tangent(struct force_table *t, int terms, const double *V, double factor,
                   struct band *J);

#endif
