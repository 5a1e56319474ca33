/*
 * What the methods for systems of ropes share: unknowns, global stiffness, first state.  Private to
 * phys/net*.c.
 */
#ifndef SEILWERK_PHYS_NETWORK_H
#define SEILWERK_PHYS_NETWORK_H

#include "phys/net.h"

#include <math.h>

struct net_work {
    int *dof; /* (n, 3) unknown of each direction of each node, -1: held; owned */
    int unknowns;
    struct sparse A;
    int *at_node;     /* (n, 6) places of the nodes' diagonal blocks, -1: none; owned */
    int *at_rope;     /* (m, 9) of the block of rows a, columns b; owned */
    double reference; /* a force of the system's loads [N] */
    /* as last evaluated: */
    double *gap;      /* (m, 3) [m] */
    double *bar;      /* (m, 3) tension of bars towards b [N] */
    double *K;        /* (m, SYM) */
    double *node_K;   /* (n, SYM) */
    double *residual; /* (n, 3) [N] */
    /* a step: */
    double *dx, *dt, *x1, *t1, *rhs;
};

static inline double net_length(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/* SW_NOMEM. */
enum status net_work_new(const struct net *net, struct net_work *ret);
void net_work_free(struct net_work *w);

/* A = B^T K B + K_r from K and node_K. */
void net_assemble(const struct net *net, struct net_work *w);

/* The node of an unknown; -1: none. */
int net_node_of(const struct net *net, const struct net_work *w, int unknown);

/* Whether a rope is a bar. */
int net_is_bar(const struct net_rope *r);

/* Largest distance of fixed nodes, or the longest rope if that is more [m]. */
double net_size(const struct net *net);

/* A force that ropes will carry: all loads over the held nodes; without loads a thousandth of the
 * softest rope's EA [N]. */
double net_reference(const struct net *net);

/* Set epsilon of all ropes: this part of a rope's load, or, where that is next to none, of the
 * reference force or a thousandth of the softest rope's EA; but not below `least` [N]. */
void net_smooth(struct net *net, double part, double reference, double least);

/* Chord, stiffness and gap of all ropes and residual of all nodes at x and t. */
void net_evaluate(const struct net *net, const double *x, const double *t, struct net_work *w);

/* dx and dt of a step from what was last evaluated.  SW_INDEFINITE with the node; SW_NOMEM. */
enum status net_find_step(const struct net *net, struct net_work *w, int *ret_worst);

/* First state: ropes as springs of no length, whose forces balance all loads.  As net_find_step. */
enum status net_begin(const struct net *net, struct net_work *w, struct net_state *s);

/* Stiffness of a rope that carries t, in place of the exact one. */
void net_rough_stiffness(const struct rope *r, enum net_stiffness kind, const double t[3],
                         double reference, double K[SYM]);

/* Gaps, residuals and tensions as they were last evaluated; factor 1. */
struct net_step net_measure(const struct net *net, const double *t, const struct net_work *w,
                            struct net_state *s);

/* The method of imaginary reactions on s, from nothing.  SW_ADMISSIBLE: closed parts, bars, springs
 * or nodes held in some directions only. */
enum status net_imaginary(const struct net *net, const struct net_options *o, struct net_work *w,
                          struct net_state *s);

/* The matrix displacement method (71-76) on s, from nothing: all elements at once, no cuts.
 * SW_ADMISSIBLE: continuous ropes. */
enum status net_displace(const struct net *net, const struct net_options *o, struct net_work *w,
                         struct net_state *s);

/* Steps from the state s, without smoothing.  SW_NOCONV, and as net_find_step. */
enum status net_iterate(const struct net *net, const struct net_options *o, struct net_work *w,
                        struct net_state *s);

#endif
