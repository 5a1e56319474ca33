/*
 * Equilibrium of systems of ropes by the gap method (Blendermann 52-70; theory section 5, c5).
 *
 * All ropes are cut free and balanced by themselves; p, their end tensions, and x, the positions of
 * the nodes, are improved together until no rope misses its nodes:
 *
 *     (B^T K B + K_r) dx = R + B^T K gap,   dt = K (gap + B dx),   gap = B x - chord(t)
 *
 * with K = F^{-1} the ropes' stiffness and R the residual of the nodes.  Chords are gradients of
 * convex functions of the tensions and node forces of convex functions of the positions, so that
 * the step runs downhill; it is shortened where the product of the gaps and residuals with the step
 * would change its sign by more than half.  A rope of one element is a bar, which also carries
 * compression; it takes part through its nodes' positions.  z is up.
 *
 * Over a bed (sea.h) continuous ropes take part through their nodes' positions, too, unless none
 * comes near it.  Chains there, ropes over a grid of depths and all ropes in a current are split
 * into their elements, each a rope of its own; nodes do not sink into the bed.  Drag and friction
 * are loads that are held or renewed from step to step (Anhang).
 */
#ifndef SEILWERK_PHYS_NET_H
#define SEILWERK_PHYS_NET_H

#include "num/sparse.h"
#include "phys/rope.h"
#include "phys/touch.h"

struct net_node {
    int held;         /* bits 1, 2, 4: x, y, z do not move */
    double x[3];      /* [m] where held; else a guess, or NAN */
    double force[3];  /* from outside, weight and constant buoyancy in it [N] */
    double K[SYM];    /* spring towards anchor [N/m] */
    double anchor[3]; /* [m] */
    double area;      /* float: buoyancy per depth of its bottom, the node, below z = 0 [N/m] */
    double height;    /* depth at which it is submerged [m] */
    double way[2]; /* of a joint: heading of its rope, in which alone the bed pushes; 0, 0: all */
    double drag;   /* in a current: density cda/2 [kg/m] */
    int body;      /* number of the rigid body that carries it, from 1; 0: none.  Such a node is
                      held, x follows from the body */
    double arm[3]; /* place on the body, in its axes [m] */
};

/* A rigid body with six freedoms, all held or all free. */
struct net_body {
    int held;
    double x[3], R[9];   /* place of its origin [m], axes as columns, row-major */
    double weight, lift; /* [N]; lift: buoyancy when cb is at level */
    double cg[3], cb[3]; /* centres of gravity and buoyancy, in its axes [m] */
    double area, level;  /* buoyancy per depth of cb below level [N/m], [m] */
};

struct net_rope {
    int a, b;                 /* nodes */
    int pulls;                /* a rope of one element: whether it carries tension only */
    int cut;                  /* a rope of one element: cut free like longer ones, and no bar */
    enum touch_pulled pulled; /* set by net_solve: the end that is farther from the anchors */
    int over;                 /* set by net_solve: over a plane bed, by touch.h, for given ends */
    struct rope rope;
    double across, along; /* in a current: density cd diameter/2, density cd_axial pi diameter/2 */
    double friction;      /* on the bed */
};

struct net {
    int n, m;              /* nodes, ropes */
    struct net_node *node; /* (n); owned by the caller, like the next */
    struct net_rope *rope; /* (m) */
    int bodies;
    struct net_body *body; /* (bodies) */
    const struct sea *sea; /* or NULL */
};

enum net_method { NET_GAP, NET_DISPLACEMENT, NET_IMAGINARY };
enum net_stiffness { NET_EXACT, NET_CLOSED, NET_FICTITIOUS };
enum net_pull { NET_CONSTANT, NET_UNIT, NET_SPAN }; /* (78), (79), (80) */

struct net_options {
    enum net_method method;
    enum net_stiffness start; /* stiffness of the first steps */
    int start_steps;
    enum net_pull pull; /* of NET_IMAGINARY */
    int split;          /* elements of a continuous rope that must be split */
    int hold;           /* drag is held until the gaps are small, not renewed in each step */
    double tolerance;   /* of gaps over the system's size, and residuals over the largest
                           tension */
    int steps;          /* at the most */
};

struct net_step {
    double mean_gap, largest_gap; /* over the system's size */
    double gap_of_rope;           /* largest over the rope's own length */
    double residual;              /* largest [N] */
    double factor;                /* by which the step was shortened */
};

struct net_state {
    double *x;             /* (n, 3) positions [m]; owned */
    double *end;           /* (m, 6) tension at a, then at b, both towards b [N]; owned */
    double *push;          /* (n) of the bed, upward [N]; owned */
    double hard;           /* with which it was looked for [N/m]; 0: no bed */
    double *drag;          /* (n, 3) what the current does to them and the halves of the ropes'
                              elements that end there [N]; owned */
    struct net_fine *fine; /* the net with ropes split, and its state; NULL: none was; owned */
    double *t;             /* (m, 3) tension at a, towards b, less the rope's offset [N]; owned */
    double *residual;      /* (n, 3) what is missing at the nodes [N]; at held ones minus the
                              support's reaction; owned */
    double size;           /* of the system [m] */
    double most;           /* largest tension [N] */
    double scale;          /* the same, but not below 1e-5 of the loads over the held nodes; a
                              tenth of them where a bed may bear them */
    struct net_step *step; /* (steps + 1) history; owned */
    int steps;
    double adrift; /* what free bodies are out of balance, over the largest tension or weight */
    int worst;     /* node with the largest residual, or what makes it a mechanism */
};

/* Words for a net that has no answer, or NULL: ends of ropes, lengths, stiffnesses, connection to
 * something held.  *ret_at: the rope or node that they are about. */
const char *net_refused(const struct net *net, int *ret_is_rope, int *ret_at);

/* Find the equilibrium; sets the ropes' epsilon and offset, which
 * belong to the state.  SW_NOCONV: bounds not met, the state is the best
 * one found; SW_INDEFINITE: a mechanism, ret->worst is free to move; SW_ADMISSIBLE: the method does
 * not apply; SW_NOMEM. */
enum status net_solve(struct net *net, const struct net_options *o, struct net_state *ret);

void net_state_free(struct net_state *s);

/* Force on node i at x from springs, floats and outside, and its stiffness -df/dx or NULL. */
void net_node_force(const struct net_node *node, const double x[3], double f[3], double K[SYM]);

/* End tension of rope r at a and at b, both towards b, for the state s [N]. */
void net_ends(const struct net *net, const struct net_state *s, int r, double ta[3], double tb[3]);

/* What is told of a rope: largest and least tension [N], stretched length [m], height of its lowest
 * point [m], unstretched length on the bed [m].  A bar under compression has negative tensions. */
struct net_outline {
    double most, least, length, lowest, flat;
    int elements; /* 0: continuous */
};

void net_outline(const struct net *net, const struct net_state *s, int r, struct net_outline *ret);

#define NET_POINTS 49 /* points of a continuous rope at the most */

/* Points along rope r, seen from its node a: their number, room for which must be there (elements +
 * 1, at least NET_POINTS).  Between two of them loads are uniform. */
int net_points(const struct net *net, const struct net_state *s, int r, struct rope_point *ret);

/*
 * Stiffness of the chosen nodes, condensed on the rest: K (3 k, 3 k), column-major, force needed
 * per displacement [N/m].  They are held where they are, others move.  As net_solve.
 */
enum status net_stiffness(const struct net *net, const struct net_state *s, const int *chosen,
                          int k, double *K);

/*
 * The same of a rigid body that carries the chosen nodes, about a point: K (6, 6), column-major,
 * force and moment [N, N m] needed per displacement and small rotation [m, rad].  The forces that
 * hold the nodes turn their levers with the body: with p the force on a node at r from the point, a
 * rotation w brings r p.w - (p.r) w to the moment.  Free bodies that carry none of the nodes
 * follow.
 */
enum status net_body_stiffness(const struct net *net, const struct net_state *s, const int *chosen,
                               int k, const double about[3], double K[36]);

/* Put the nodes of a body where its place and axes have them. */
void net_place_body(struct net *net, int body);

/* Force and moment about a point that the nodes of a body bring it (ropes and their own loads), and
 * those of its weight and buoyancy [N, N m]. */
void net_body_forces(const struct net *net, const struct net_state *s, int body,
                     const double about[3], double lines[6], double own[6]);

/* net_solve, and free bodies moved until they are in balance, by Newton's method with damping.
 * SW_NOCONV: they are not; ret->adrift tells by how much. */
enum status net_settle(struct net *net, const struct net_options *o, struct net_state *ret);

#define NET_TUNED 1e-9 /* of the wanted tension */

/* A tension that is wanted at one end of a rope. */
struct net_target {
    int rope;
    int at;         /* the node at that end */
    double tension; /* [N] */
    int anchor;     /* the fixed node that is moved for it, level or along the bed, towards or away
                       from the other end; -1: the rope's length is changed */
};

/* net_settle with lengths and anchors changed until all tensions are as wanted; they stay changed
 * in net.  SW_NOCONV: no such lengths or anchors were found. */
enum status net_tune(struct net *net, const struct net_options *o, const struct net_target *target,
                     int k, struct net_state *ret);

#endif
