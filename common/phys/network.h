/*
 * What the methods for systems of ropes share: unknowns, global stiffness, first state.  Private to
 * phys/net*.c.
 */
#ifndef SEILWERK_PHYS_NETWORK_H
#define SEILWERK_PHYS_NETWORK_H

#include "phys/net.h"
#include "phys/sea.h"
#include "phys/touch.h"

#include <math.h>

/* Ropes over a bed: with a stiffness that is good enough for a step, the same without friction to
 * come near first, or with the exact one. */
enum over { OVER_STEP, OVER_SMOOTH, OVER_EXACT };

#define NET_SHARP 1e-12    /* smoothing, of a rope's load, with which a solution ends */
#define NET_FREE_POINTS 21 /* points of a continuous rope that hangs free */

/* A net with ropes split into elements; its first nodes are those of the coarse one. */
struct net_split {
    struct net fine;
    int *first; /* (m + 1) first element of each rope; owned, as the fine net's nodes and ropes */
};

/* parts[r]: elements of rope r, 0: left whole; cut: elements are cut free, no bars.  Loads go to
 * the joints, half an element's to the ends.  SW_NOMEM. */
enum status net_split_new(const struct net *net, const int *parts, int cut, struct net_split *ret);
void net_split_free(struct net_split *s);

struct net_fine {
    struct net_split split;
    struct net_state state;
};

void net_fine_free(struct net_fine *f);

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
    double *pull;     /* (m, 6) of ropes over a bed: at a and b, towards b [N]; NULL: no bed */
    double *over_K;   /* (m, 36) their stiffness, column-major: - d(force on a, on b)/d(x_a, x_b) */
    double *lean;     /* (n) push of the bed that is counted on [N] */
    double *push;     /* (n) push that there is: lean and what sinks in [N] */
    enum over over;   /* how ropes over a bed are taken */
    double hard;      /* further push for each metre that a node sinks in [N/m] */
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

/* Room for a state.  SW_NOMEM. */
enum status net_state_new(const struct net *net, const struct net_options *o, struct net_state *s);

/* SW_NOMEM. */
enum status net_work_new(const struct net *net, struct net_work *ret);
void net_work_free(struct net_work *w);

/* A = B^T K B + K_r from K and node_K. */
void net_assemble(const struct net *net, struct net_work *w);

/* The node of an unknown; -1: none. */
int net_node_of(const struct net *net, const struct net_work *w, int unknown);

/* Whether a rope is a bar. */
int net_is_bar(const struct net_rope *r);

/* Whether it takes part through its nodes' positions: a bar, or over a bed. */
int net_is_placed(const struct net_rope *r);

/* Whether it can be taken as a rope over a bed: continuous, heavy, over a plane, no current. */
int net_goes_over(const struct net *net, const struct net_rope *p);

/* End tensions (at a, at b, both towards b) and stiffness or NULL of such a rope between a and b,
 * 0: it cannot be solved. */
int net_over(const struct net *net, const struct net_rope *p, const double *a, const double *b,
             double pull[6], enum over how, double K[36]);

/* Whether it touches the bed. */
int net_over_lies(const struct net *net, const struct net_rope *p, const double *a,
                  const double *b);

/* Its points and outline, as net_points and net_outline. */
int net_over_points(const struct net *net, const struct net_rope *p, const double *a,
                    const double *b, struct rope_point *ret);
void net_over_outline(const struct net *net, const struct net_rope *p, const double *a,
                      const double *b, struct net_outline *ret);

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

/* Direction of the bed's push on node i, upward component 1. */
void net_bed_normal(const struct net *net, const double *x, int i, double n[3]);

/* node_K of node i with a bed that gives way by 1/hard [m/N]. */
void net_add_bed(const struct net *net, const double *x, int i, double hard, struct net_work *w);

/* Tension of rope r at both ends, towards b, as last evaluated. */
void net_ends_now(const struct net *net, const double *t, const struct net_work *w, int r,
                  double ta[3], double tb[3]);

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

/* Steps from the state s until the bounds are met, and a few more while they still bring something;
 * at most to step number `last`, or until `patience` steps in a row were short; tolerance 0: near
 * enough for a stage on the way.  SW_NOCONV, and as net_find_step. */
enum status net_iterate(const struct net *net, const struct net_options *o, double tolerance,
                        int last, int patience, struct net_work *w, struct net_state *s);

/* The same by one way after the other, from the quickest to the safest. */
enum status net_iterate_all_ways(struct net *net, const struct net_options *o, struct net_work *w,
                                 struct net_state *s);

/* Whether a step meets the tolerance, as in net_iterate. */
int net_is_met(const struct net_step *p, const struct net_state *s, double tolerance);

/* Make ready: size, reference force, smoothing; offsets to none. */
void net_prepare(struct net *net, struct net_work *w, struct net_state *s);

/* What the last evaluation says, and the way there: the end of every method.  SW_NOCONV: the bounds
 * are not met. */
enum status net_conclude(const struct net *net, const struct net_options *o, enum status s,
                         const struct net_work *w, struct net_state *ret);

/* net_solve where there is a bed or a current. */
enum status net_solve_in_sea(struct net *net, const struct net_options *o, struct net_state *ret);

/* net_solve without. */
enum status net_solve_dry(struct net *net, const struct net_options *o, struct net_state *ret);

#endif
