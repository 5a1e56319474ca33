/*
 * Hinges between a node and the end of an element: one released axis, two (a universal joint), or
 * all three (a ball joint).
 */
#ifndef SEILWERK_PHYS_HINGE_H
#define SEILWERK_PHYS_HINGE_H

#define HINGE_MOST 3 /* unknowns */

struct hinge {
    int n;             /* released axes */
    double axis[2][3]; /* of one or two: natural section axes, global */
};

struct hinge_state {
    double angle[2]; /* about them, the first one first [rad] */
    double q[4];     /* ball joint: rotation of the end from the natural state */
};

/* Rotation of the end by that of its node, and the axes of the unknowns in space. */
void hinge_end(const struct hinge *h, const struct hinge_state *s, const double node[4],
               double ret_end[4], double ret_axis[3][3]);

/* Turn by the unknowns dx (n). */
void hinge_move(const struct hinge *h, const double *dx, struct hinge_state *s);

/* Displacements and spins (12) of the ends by those of the unknowns, du: nodes (12), hinges. */
void hinge_ends(const struct hinge *h, double axis[2][3][3], const double *du, double ret[12]);

/*
 * From forces f (12) and stiffness K (12, 12) of an element to those of its unknowns: 12 of the
 * nodes, then those of both hinges, n in all.  Returns n.
 */
#define HINGED_MOST (12 + 2 * HINGE_MOST)
int hinge_expand(const struct hinge *h, double axis[2][3][3], const double f[12],
                 const double K[144], double *ret_f, double *ret_K);

#endif
