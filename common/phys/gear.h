/*
 * Lifting gear and what hangs in it, as drawn: bodies, points, slings.
 *
 * Axes: x lengthwise, y crosswise, z up.  Everything is given in space in the place where it is
 * drawn, which need not be an equilibrium; a pose tells where the bodies are instead.  Planar
 * suspensions move in the plane of x and z only.  Any consistent units; m, kg, N are named here.
 *
 * Slings pull and never push.  A rigid one holds its path at or below its length; an elastic one
 * has the force EA (L/length - 1) where that is positive.  A sling may lean on parallel edges of a
 * body, without friction: its path is then the shortest one that stays outside of them, so that
 * contact acts exactly when geometry says so.
 *
 * One struct of fixed size holds it all, without pointers: it is copied by assignment.
 */
#ifndef SEILWERK_PHYS_GEAR_H
#define SEILWERK_PHYS_GEAR_H

#include "num/status.h"

enum {
    GEAR_BODIES = 4,
    GEAR_POINTS = 48,
    GEAR_SLINGS = 24,
    GEAR_CORNERS = 4, /* that one sling may lean on */
    GEAR_FREE = 6 * GEAR_BODIES,
    GEAR_HOOK = -1 /* the body of points that are fixed in space */
};

struct suspended {
    double mass;          /* [kg], > 0 (massless: 0) */
    double cg[3];         /* centre of gravity [m] */
    double inertia[3][3]; /* about the centre of gravity, along the axes of space [kg m2] */
};

struct hitch {
    int body; /* or GEAR_HOOK */
    double at[3];
};

struct tie {
    int from, to;                   /* points */
    double length;                  /* unstretched [m], > 0 */
    double EA;                      /* [N], > 0; INFINITY: rigid */
    int corners;                    /* that it may lean on ... */
    int leans;                      /* ... of this body ... */
    double corner[GEAR_CORNERS][3]; /* ... in the order in which they are met from -> to */
    /* Unit direction of the edges, with the sign that makes a corner in the sling's way
     * edge . ((to - from) x (corner - from)) > 0. */
    double edge[3];
};

struct gear {
    int planar;
    double g; /* [m/s2], > 0 */
    int bodies, points, slings;
    struct suspended body[GEAR_BODIES];
    struct hitch point[GEAR_POINTS];
    struct tie sling[GEAR_SLINGS];
};

/* Where a body is: its centre of gravity and its axes (columns of R) that were those of space. */
struct pose {
    double r[3];
    double R[3][3];
};

/* The free motions of a pose: for each the body and 0, 1, 2 for a shift of its centre of gravity
 * along x, y, z or 3, 4, 5 for a turn about axes through it that are parallel to x, y, z. */
struct freedom {
    int n;
    int body[GEAR_FREE], axis[GEAR_FREE];
};

/* Each adds one and returns its number, -1 if there is no room. */
int gear_add_body(struct gear *s, double mass, const double cg[3], const double inertia[3][3]);
int gear_add_point(struct gear *s, int body, double x, double y, double z);

/* A sling as long as it is drawn, if length = 0. */
int gear_add_sling(struct gear *s, int from, int to, double length, double EA);

/*
 * The sling k goes round the n corners of a body, given in the order from -> to, through which
 * edges of the direction edge run; it passes them on the side outward.  A length that was drawn is
 * then measured by gear_tighten.  SW_ADMISSIBLE: too many corners; outward lies along the
 * sling or the edges.
 */
enum status gear_add_edges(struct gear *s, int k, int body, const double edge[3],
                           const double outward[3], int n, const double corner[][3]);

/* The unstretched length of sling k becomes that with which it has the length of its path as drawn
 * under the stretch (L - length)/L; 0 <= stretch < 1. */
void gear_tighten(struct gear *s, int k, double stretch);

/* All sizes and numbers in range, every body reached by slings: SW_OK, else SW_ADMISSIBLE. */
enum status gear_check(const struct gear *s);

/* Length and weight by which everything is made free of dimension: the greatest distance of a point
 * from the first one, and the weight of all bodies. */
void gear_scale(const struct gear *s, double *ret_length, double *ret_weight);

/* The same with length 1, weight 1, g 1. */
void gear_unit(const struct gear *s, struct gear *ret);

/* The place as drawn, pose (bodies). */
void gear_drawn(const struct gear *s, struct pose *pose);

/* Where a place at of the drawing, fixed to body, is in the pose. */
void pose_place(const struct gear *s, const struct pose *pose, int body, const double at[3],
                double ret[3]);

/* ret = A x. */
void pose_turned(const double A[3][3], const double x[3], double ret[3]);

/* Free motions; held: a body whose turn about y is prescribed (planar), or -1. */
void gear_freedom(const struct gear *s, int held, struct freedom *ret);

/* The pose moved by q (f->n): shifts add, turns are rotation vectors composed from the left. */
void pose_move(const struct freedom *f, const double *q, struct pose *pose);

/* pose[body] turned by angle about y through its centre of gravity. */
void pose_tilt(struct pose *pose, double angle);

/* Turn about y since drawn [rad]: positive where the end of the body at larger x went down. */
double pose_tilted(const struct pose *pose);

#endif
