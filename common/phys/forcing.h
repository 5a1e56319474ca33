/*
 * Forces from outside on a moving cable: at points or uniform along it, constant, harmonic or
 * recorded; the drag of a steady wind.
 *
 * What is given stands in the axes of space, vectors over all nodes in those of the line's plane.
 */
#ifndef SEILWERK_PHYS_FORCING_H
#define SEILWERK_PHYS_FORCING_H

#include "phys/model.h"
#include "phys/series.h"
#include "phys/sweep.h"

struct force {
    double position;     /* theta/L0; NAN: uniform along the cable */
    double value[3];     /* [N], or uniform [N] per unstressed metre */
    double omega, phase; /* times cos(omega t + phase) [rad/s], [rad]; omega NAN: constant */
    const struct series *record; /* in place of value, or NULL; not owned */
    const struct sweep *sweep;   /* in place of omega t unless omega is NAN, or NULL; not owned */
};

/*
 * Drag on the cable as a cylinder: force per stretched length = density/2 cd diameter |u| u, u the
 * part across the cable of the wind's velocity against it.
 */
struct wind {
    double speed[3]; /* [m/s] */
    double cd;       /* drag coefficient; 0 or NAN: no wind */
    double diameter; /* [m] */
    double density;  /* of the air [kg/m3] */
};

struct forcing {
    const struct force *force; /* not owned */
    int n;
    struct wind wind;
};

/* Whether there is any force at all. */
int forcing_any(const struct forcing *f);

/* F -= forces at time t on the cable displaced by V with velocity W over all nodes (NULL: at rest);
 * the sign is that of internal forces. */
void forcing_subtract(const struct model *m, const struct forcing *f, double t, const double *V,
                      const double *W, double *F);

/* model_equilibrium under the forces at t = 0, the cable at rest; f may be NULL. */
enum status forcing_equilibrium(const struct model *m, const struct forcing *f, int terms,
                                const double b[6], double *V);

#endif
