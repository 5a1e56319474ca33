/*
 * A net in the sea on its way to balance: loads of the present shape, then steps with these.
 * Private to phys/net*.c.
 */
#ifndef SEILWERK_PHYS_VOYAGE_H
#define SEILWERK_PHYS_VOYAGE_H

#include "phys/network.h"

#define VOYAGE_BRIEF 120 /* steps without further care */

/* A net in the sea on its way to balance. */
struct voyage {
    struct net *net; /* the fine one */
    const struct net_options *o;
    struct net_work w;
    struct net_state *s;
    double *base;  /* (n, 3) forces without sea; owned */
    double *load;  /* (n, 3) of current and friction, as they act; owned */
    double *fresh; /* (n, 3) as the present shape would have them; owned */
    double *held;  /* (n, 3) friction; owned */
    int rounds;    /* of renewal */
    int joints;    /* first node that is a joint of a rope that was split */
    double size;   /* of the coarse net [m] */
    double part;   /* of the difference that a renewal takes */
    double before; /* difference at the last renewal */
};

/* Room and first loads for a net and its new state s.  SW_NOMEM. */
enum status voyage_new(struct net *net, const struct net_options *o, struct net_state *s,
                       struct voyage *v);

/* The net's forces as they were; room is given back. */
void voyage_end(struct voyage *v);

/* What current and friction do in the present shape, to v->fresh; split: ropes that were split, and
 * their number.  Friction is looked for in states near to balance only: what a tension on the way
 * has called forth would hold itself up. */
void voyage_look(struct voyage *v, const struct net_split *split, int ropes, int near);

/* Loads of the nodes move by v->part towards v->fresh; v->before: largest difference. */
void voyage_renew(struct voyage *v);

/* To balance, from the state of a solution without the bed or from nothing (dry NULL); v->s tells
 * how far it came.  SW_NOCONV, SW_INDEFINITE, SW_NOMEM. */
enum status voyage_travel(struct voyage *v, const struct net_split *split, int ropes,
                          const struct net_state *dry);

#endif
