/*
 * The gear of an arrangement (phys/gear.h): what exact statics compute of it.
 *
 * A planar one shows one view of a lift on one suspension, its edges counted or not; one in space
 * shows two hooks, or four slings a hook, or both ends of a pair.
 */
#ifndef SEILWERK_FORM_TACKLE_H
#define SEILWERK_FORM_TACKLE_H

#include "form/lift.h"
#include "phys/gear.h"

struct tackle {
    struct gear gear;
    int load, spreader;       /* bodies; spreader -1: none.  Of a pair that of the first end */
    int turned;               /* x of the gear lies crosswise */
    int part[GEAR_SLINGS];    /* of each sling: 0 primary, 1 secondary */
    int end[GEAR_SLINGS];     /* of a pair */
    double real[GEAR_SLINGS]; /* force of one real sling over that of the gear's */
    double reach;             /* half of the lifting base, or the height of a sling [m] */
};

/* One view of a single suspension.  SW_ADMISSIBLE: phi is missing, slings cannot be shared evenly
 * between two sides. */
enum status tackle_planar(const struct lift *l, enum rigging_view view, int edges,
                          struct tackle *ret, struct why *why);

/* In space.  SW_INFEASIBLE: not enough is known for it, or nothing is to be seen there that one
 * view does not show; SW_ADMISSIBLE as above. */
enum status tackle_space(const struct lift *l, struct tackle *ret, struct why *why);

/* Whether the mass of the load is known; otherwise that of the gear is a ton. */
int tackle_has_mass(const struct lift *l);

#endif
