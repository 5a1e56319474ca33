/*
 * Structures of curved beams: nodes, elements of any topology, hinges, springs, supports, loads;
 * the forces and the stiffness of a deformed state.
 *
 * Loads and prescribed displacements belong to stages 1, 2, ...; at the time t the factor of stage
 * k is t - k + 1, kept within 0 and 1.
 */
#ifndef SEILWERK_PHYS_FRAME_H
#define SEILWERK_PHYS_FRAME_H

#include "num/sparse.h"
#include "phys/corotate.h"
#include "phys/hinge.h"

#include <stddef.h>

struct frame_node {
    double x[3];     /* [m] */
    int held;        /* bit c: ux uy uz rx ry rz */
    double given[6]; /* what is held is moved by this [m], [rad] */
    int stage[6];    /* in this stage; 0: never */
};

struct frame_beam {
    int a, b; /* nodes */
    const struct section *section;
    struct beam beam; /* natural */
    double A[2][9];   /* natural section frames of the ends */
    struct hinge hinge[2];
};

struct frame_spring {
    int a, b;    /* nodes; b = -1: the ground */
    double B[9]; /* natural axes by rows; they turn with both nodes, those of the ground do not */
    double k[6]; /* along and about them [N/m], [N m/rad] */
};

struct frame_load {
    int node, beam;  /* one of them, the other -1 */
    double value[6]; /* forces and moments [N], [N m]; of a beam [N/m] (3): per natural length */
    int stage;
};

struct frame {
    int n, beams, springs, loads, stages;
    int lumped; /* whether loads of beams go to their nodes, half each, without moments */
    int arc; /* path by arc length: the factor of the last stage is not kept within, others are 1 */
    struct frame_node *node;
    struct frame_beam *beam;
    struct frame_spring *spring;
    struct frame_load *load;
};

/* Where the structure is.  Owned. */
struct frame_state {
    double t;
    double *x, *low; /* (n, 3) places are x + low: bending of thin wires hides behind strains of a
                        unit of rounding */
    double *q;       /* (n, 4) rotations from the natural state */
    double *turn;    /* (n, 3) their rotation vectors, turns counted on */
    struct hinge_state *hinge; /* (beams, 2) */
};

/* Unknowns and matrices of a frame, and what was last evaluated.  Owned. */
struct frame_work {
    int unknowns;
    int *dof;   /* (n, 6) unknown, -1: held */
    int *first; /* (beams, 2) first unknown of each hinge */
    struct sparse K;
    int *at;              /* places of all blocks in K, block after block */
    double *load;         /* (n, 6) */
    double *q;            /* (beams, 3) */
    double *open;         /* (n, 6) force by which nodes are held or missing: ends - loads */
    double *right;        /* (unknowns) minus the same of the unknowns */
    double *end;          /* (beams, 12) end forces */
    double *guess;        /* (beams, 6) forces of corotate_foresee */
    int guessed;          /* whether they make the geometric stiffness */
    double force, moment; /* largest of ends and loads: scales of residuals */
    double floor_force, floor_moment; /* what rounding of places and rotations brings */
    double size, chord;               /* of the structure, mean of the elements [m] */
    double angle;                     /* largest turn within an element */
    double energy;                    /* of deformation and of distributed loads */
    int negative;                     /* pivots of the last factor that were: 0 is stable */
};

/* Factor of a stage at time t. */
double frame_factor(const struct frame *f, int stage, double t);

/* SW_NOMEM. */
enum status frame_state_new(const struct frame *f, struct frame_state *ret);
void frame_state_free(struct frame_state *s);
void frame_state_copy(const struct frame *f, const struct frame_state *from,
                      struct frame_state *to);

/* SW_NOMEM. */
enum status frame_work_new(const struct frame *f, struct frame_work *ret);
void frame_work_free(struct frame_work *w);

/* The unknowns of beam i, or of the spring i - beams, as hinge_expand orders them: to
 * (HINGED_MOST), -1: held.  Returns their number. */
int frame_unknowns(const struct frame *f, const struct frame_work *w, int i, int *to);

/* Loads at time t, to load and q. */
void frame_set_loads(const struct frame *f, double t, struct frame_work *w);

/* Forces and stiffness at s under the loads that are set.  node (n, 6) and hinge (unknowns), each
 * or NULL: small moves that follow; the forces that they bring, by K, are added to those of ends
 * and nodes.  K is not factored. */
struct frame_moves {
    const double *node, *hinge;
};
void frame_evaluate(const struct frame *f, const struct frame_state *s, struct frame_moves moves,
                    struct frame_work *w);
#define FRAME_STILL                                                                                \
    (struct frame_moves)                                                                           \
    {                                                                                              \
        NULL, NULL                                                                                 \
    }

/* The forces that moves from s lead to become the guess of the next evaluations, until
 * w->guessed is set to 0. */
void frame_foresee(const struct frame *f, const struct frame_state *s, struct frame_moves moves,
                   struct frame_work *w);

/*
 * The largest open force over the largest force of ends and loads, or moment over moment; where
 * there is only one of them, lengths compare: a moment over the structure's size, a force times the
 * elements' chord.  What rounding of places brings in stiff elements counts as the tolerance.
 */
double frame_residual(const struct frame *f, const struct frame_work *w, double tolerance);

/* The largest force and moment of end forces and loads, as they stand in w. */
void frame_measure(const struct frame *f, struct frame_work *w);

/* K = L D L^T and its negative pivots.  SW_INDEFINITE: K is singular; SW_NOMEM. */
enum status frame_factorize(struct frame_work *w);

/* The move of what is held between two times, (n, 6). */
void frame_given(const struct frame *f, double from, double to, double *move);

/* Move by dx (unknowns) and by move (n, 6), either may be NULL; rotations compose. */
void frame_move(const struct frame *f, const struct frame_work *w, const double *dx,
                const double *move, struct frame_state *s);

/* The node of an unknown, -1: a hinge's. */
int frame_node_of(const struct frame *f, const struct frame_work *w, int unknown);

/* End frames (global) of beam i in state s, A1 and A2. */
void frame_ends(const struct frame *f, const struct frame_state *s, int i, double A1[9],
                double A2[9]);

#endif
