/*
 * What surrounds moorings: the bed on which ropes lie and the current that drags at them
 * (Blendermann, Anhang; theory section 5).  z is up, still water at z = 0.
 */
#ifndef SEILWERK_PHYS_SEA_H
#define SEILWERK_PHYS_SEA_H

enum bed_kind { BED_NONE, BED_PLANE, BED_GRID };

/* Plane: z = level + slope . (x, y).  Grid: bilinear between points, beyond them as at the edge. */
struct bed {
    enum bed_kind kind;
    double level, slope[2];  /* [m], [-] */
    int nx, ny;              /* of the grid */
    const double *x, *y, *z; /* (nx), (ny) ascending, (nx, ny) x fastest [m]; not owned */
};

/* Height of the bed [m] and its gradient there, or NULL; -INFINITY where there is none. */
double bed_at(const struct bed *b, double x, double y, double gradient[2]);

/* Horizontal current by height: linear between points, beyond them as at the ends; n = 0: none. */
struct current {
    int n;
    const double *z, *u, *v; /* (n): z ascending [m], components along x and y [m/s]; not owned */
};

/* Velocity at height z [m/s], and its change with z or NULL. */
void current_at(const struct current *c, double z, double U[3], double slope[3]);

struct sea {
    struct bed bed;
    struct current current;
};

/* Drag of a piece of length l along the direction c: across * |Un| Un + along * |Ut| Ut, times l
 * [N]. across = density cd diameter/2, along = density cd_axial pi diameter/2 [kg/m2]. */
void sea_drag(double across, double along, double l, const double c[3], const double U[3],
              double ret[3]);

/* Its change with c and U: 3 x 3, rows of the force; c is changed across itself only. */
void sea_drag_change(double across, double along, double l, const double c[3], const double U[3],
                     double by_c[9], double by_U[9]);

#endif
