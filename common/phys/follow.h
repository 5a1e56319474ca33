/*
 * Equilibrium of a frame along its load path: Newton's method in adaptive steps of the load, or of
 * the arc of the path past limit points.
 */
#ifndef SEILWERK_PHYS_FOLLOW_H
#define SEILWERK_PHYS_FOLLOW_H

#include "phys/frame.h"

struct follow_options {
    double tolerance; /* of the residual */
    int parts;        /* first step: a stage over this */
    int steps;        /* at most */
    int iterations;   /* of one step, at most */
    int arc;          /* whether the last stage goes by arc length */
    int critical;     /* stop where the equilibrium loses its definiteness */
    int watch;        /* a node whose path is kept, -1: none */
};

struct follow_step {
    double t;
    int iterations, negative;
    double residual, energy;
    double watch[6]; /* displacement and rotation vector */
};

struct follow_path {
    struct follow_step *step; /* (n), the first one is the start; owned */
    int n, room;
    double critical; /* time of the loss of definiteness to 1e-9, NAN: not found */
    int failed_node; /* where the last factorization stopped, -1: nowhere */
    double angle;    /* largest turn within an element at the end [rad] */
};

void follow_path_free(struct follow_path *p);

/* From the state s to the time of the last stage's end; *s and w are as they were last in balance.
 * SW_NOCONV: steps became too small, or too many; SW_INDEFINITE: the start is singular
 * (failed_node); SW_NOMEM.  The path is to be freed in each case. */
enum status follow(const struct frame *f, const struct follow_options *o, struct frame_state *s,
                   struct frame_work *w, struct follow_path *ret);

/* Linear theory: the state s (natural) is moved by the displacements of all loads, rotation vectors
 * added; w->end and w->open belong to it.  SW_INDEFINITE with failed_node, SW_NOMEM. */
enum status follow_linear(const struct frame *f, struct frame_state *s, struct frame_work *w,
                          int *failed_node);

#endif
