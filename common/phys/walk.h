/*
 * What the steps along a load path share.  Private to phys/follow*.c.
 */
#ifndef SEILWERK_PHYS_WALK_H
#define SEILWERK_PHYS_WALK_H

#include "num/pi.h"
#include "phys/follow.h"
#include "phys/twist.h"

#define WALK_SPIN 0.6        /* of a node in one iteration [rad]: more is cut back */
#define WALK_TURN (0.8 * PI) /* within an element: beyond, the next step may pass half a turn */
#define WALK_SMALLEST 1e-9   /* step of a stage */
#define WALK_GROW 1.6        /* of a step that took few iterations */
#define WALK_MOST 4          /* times the first step */
#define WALK_EASY 6          /* iterations */
#define WALK_FINE 1e-10      /* width of the bracket of a critical time */

/* What one path works on. */
struct walk {
    const struct frame *f; /* = &own */
    struct frame own;
    const struct follow_options *o;
    struct frame_state *s, before;
    struct twist twist;
    struct frame_work *w;
    struct follow_path *path;
    double *move;  /* (n, 6) */
    double *all;   /* (n, 6) moves of all nodes */
    double *dx;    /* (unknowns) */
    double *rate;  /* (unknowns) displacement per time */
    double *along; /* (unknowns) direction of the path, weighted */
    double *last;  /* (unknowns) the one before */
    int iterations, factored;
    double residual;
};

/* Largest spin of a node in dx or, where it is held, in move (n, 6) or NULL. */
double walk_spin(const struct walk *k, const double *dx, const double *move);

/* Factor K, with what applied moments add. */
enum status walk_factor(struct walk *k);

/* dx and the held moves become one of all nodes, k->all; the linear forces that they lead to. */
void walk_foresee(struct walk *k, const double *move);

/* In balance: the stiffness without guesses, factored. */
enum status walk_settle(struct walk *k);

enum status walk_record(struct walk *k);

/* Back to the last state in balance, k->before. */
enum status walk_back(struct walk *k);

/* One step of the load from the present state to the time t; SW_NOCONV leaves it where it was. */
enum status walk_by_load(struct walk *k, double t);

/* By arc length to the time end, or for as many steps as there may be. */
enum status walk_arc(struct walk *k, double end);

#endif
