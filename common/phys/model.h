/*
 * The finite element model of one cable: uniform mesh, matrices, free unknowns, probes.
 *
 * Unknown 6 node + c, c = 0..5 for v1, v1,1, v2, v2,1, v3, v3,1; node 0 is the left support.  Only
 * v1, v2, v3 of the two supports are prescribed, in this order left then right; the other 6 n are
 * free.  Vectors over all nodes have 6 (n + 1) entries, in the axes of the line's plane.  The plane
 * of the static line (c = 0..3) and the lateral direction (c = 4, 5) decouple in all linear
 * matrices.
 */
#ifndef SEILWERK_PHYS_MODEL_H
#define SEILWERK_PHYS_MODEL_H

#include "num/band.h"
#include "phys/element.h"
#include "phys/load.h"

struct model {
    struct line line;
    struct axes axes; /* of the line's plane; those of space itself until they are set */
    enum law law;
    int n;    /* elements, >= 1 */
    double h; /* unstressed length of each [m] */
    double slope[GAUSS][4];
    struct material *material; /* GAUSS n, owned */
};

/* The unknowns of a node that a matrix takes in: all, those in the plane of the static line, or the
 * lateral ones. */
enum part { PART_ALL, PART_PLANE, PART_LATERAL };

/* Solve the static line of c and lay n elements on it.  SW_ADMISSIBLE, SW_NOCONV, SW_NOMEM. */
enum status model_new(const struct cable *c, enum law law, int n, struct model *ret);

void model_free(struct model *m);

/* Length of a vector over all nodes, 6 (n + 1). */
static inline size_t model_unknowns(const struct model *m)
{
    return 6 * ((size_t)m->n + 1);
}

/* A zero vector over all nodes, to be freed; NULL: memory ran out. */
double *model_vector(const struct model *m);

/* Element k, 0 <= k < n. */
struct element model_element(const struct model *m, int k);

/* Number of unknowns a node and the first of them, for a part. */
static inline int part_width(enum part part)
{
    return part == PART_ALL ? 6 : part == PART_PLANE ? 4 : 2;
}

static inline int part_first(enum part part)
{
    return part == PART_LATERAL ? 4 : 0;
}

/* Mass and stiffness over all nodes, prescribed unknowns included, order part_width (n + 1), half
 * bandwidth 2 part_width - 1; tangent at V (PART_ALL), definite as in element_tangent.  SW_NOMEM.
 */
enum status model_mass(const struct model *m, enum part part, struct band *ret);
enum status model_stiffness(const struct model *m, enum part part, struct band *ret);
enum status model_tangent(const struct model *m, int terms, int definite, const double *V,
                          struct band *ret);

/* free[] = numbers of the part's free unknowns among its all-node numbers, ascending;
 * part_width n of them. */
void model_free_unknowns(const struct model *m, enum part part, int *ret);

/* The 6 all-node numbers of the prescribed unknowns. */
void model_prescribed(const struct model *m, int ret[6]);

/* A matrix over all nodes, cut by free and prescribed unknowns. */
struct partition {
    struct band free;    /* order 6 n */
    double *support;     /* (6 n, 6): free rows, prescribed columns; owned */
    double reaction[36]; /* (6, 6) */
};

/* Partition of all (PART_ALL).  SW_NOMEM. */
enum status model_partition(const struct model *m, const struct band *all, struct partition *ret);

void partition_free(struct partition *p);

/* F = internal forces at V over all nodes; watch as in element_force, started here; may be
 * NULL. */
void model_force(const struct model *m, int terms, const double *V, double *F,
                 struct strain_watch *watch);

/* Rayleigh quotient of V over all nodes [1/s2]: twice the strain energy of the linear model over
 * V^T M V, summed by elements from differences.  It keeps its accuracy where the round-off of the
 * assembled K, epsilon omega_max^2, would not. */
double model_quotient(const struct model *m, const double *V);

/* theta of Gauss point number point, counted over the whole cable. */
double model_gauss_theta(const struct model *m, int point);

/* Displacement v, in the axes of space, at theta = fraction L0 and, if asked for, the physical
 * tension there [N]. */
void model_probe(const struct model *m, double fraction, const double *V, double v[3],
                 double *tension);

/* The same for a small V: displacement in the axes of space, and the first-order change of the
 * physical tension [N]. */
void model_probe_small(const struct model *m, double fraction, const double *V, double v[3],
                       double *change);

/* Unit force at a point: b^T V is direction . v at theta = fraction L0, direction in the
 * axes of the line's plane.  b is over all nodes and is set whole. */
void model_point_load(const struct model *m, double fraction, const double direction[3], double *b);

/* Largest circular frequency of the model [rad/s], sqrt(42 max c^2)/h with
 * c^2 = (EA a^2 + T)/mu: exact for a straight uniform cable, else slightly high (theory c4). */
double model_omega_max(const struct model *m);

/*
 * V = static equilibrium for the prescribed displacements b of the supports (terms as in
 * element_force).  Newton steps from the exact static line between the moved supports; the
 * residual falls below 1e-10 of the largest end force, times h where that is above 1 m, and
 * round-off.  SW_ADMISSIBLE: no such line;
 * SW_INDEFINITE, SW_NOCONV, SW_NOMEM.
 */
enum status model_equilibrium(const struct model *m, int terms, const double b[6], double *V);

#endif
