/*
 * Newton on the exact conditions of equilibrium, in the suspension free of dimension: forces in
 * balance, rigid slings at their length where they pull and not above it where they do not.
 */
#ifndef SEILWERK_PHYS_BALANCE_H
#define SEILWERK_PHYS_BALANCE_H

#include "num/nullspace.h"
#include "phys/potential.h"

/* A place and the forces of the rigid slings in it. */
struct balance {
    const struct gear *s; /* free of dimension */
    struct freedom f;
    struct pose pose[GEAR_BODIES];
    double noise;              /* round-off of a length times the stiffest elastic sling */
    double force[GEAR_SLINGS]; /* of rigid slings */
    int active[GEAR_SLINGS];   /* rigid slings whose length is held */
    int steps;                 /* counts on */
    int by_contact;            /* hang.h */
};

/* Sling k of s does not stretch. */
int balance_rigid(const struct gear *s, int k);

/* Everything at the place and with the forces of w. */
void balance_at(const struct balance *w, struct potential *ret);

/*
 * Forces of the active slings that balance the rest best at the present place, then everything with
 * them; c: how far each active length is off; f: of the active lengths' gradients.
 */
void balance_forces(struct balance *w, struct potential *p, double *c, struct nullspace *f);

/* The equilibrium next to w, by Newton steps, and which slings are active there; p belongs to it.
 * SW_NOCONV. */
enum status balance_solve(struct balance *w, struct potential *p);

#endif
