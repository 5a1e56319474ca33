/*
 * Loads that are uniform along the unstressed cable: ice, a steady wind, a change of temperature.
 *
 * Together with the weight they are one force per length of constant direction.  The cable then
 * hangs in the plane of that force and its chord exactly as a heavier cable hangs under its own
 * weight, so that everything else works in that plane: axis 1 across the load, 2 along it, 3 out
 * of the plane.
 */
#ifndef SEILWERK_PHYS_LOAD_H
#define SEILWERK_PHYS_LOAD_H

#include "phys/line.h"

struct load {
    double ice;         /* mass per unstressed metre [kg/m], >= 0 */
    double wind[3];     /* force per unstressed metre [N/m], axes x1 x2 x3 */
    double temperature; /* change against that of the unstressed length [K] */
    double expansion;   /* coefficient of thermal expansion [1/K] */
};

/* Axes of the plane that holds the line; e[i] is its axis i + 1 in x1, x2, x3. */
struct axes {
    double e[3][3];
};

/*
 * The cable that hangs in its plane as c does under the load: length after expansion, mass with
 * ice, gravity for the whole force, span and drop across and along it.  Masses and forces per metre
 * count on the length before expansion.  Without wind the axes are x1, x2, x3 themselves, and where
 * wind and weight balance but for round-off, gravity being 0 then.
 */
void load_apply(const struct cable *c, const struct load *load, struct cable *ret,
                struct axes *ret_axes);

/* Whether there is no wind. */
int load_is_calm(const struct load *load);

/* Unstressed length before expansion of a cable that has L0 with it. */
double load_cold_length(const struct load *load, double L0);

/* A vector of x1, x2, x3 in the axes of the plane, and back. */
void axes_to_plane(const struct axes *a, const double x[3], double ret[3]);
void axes_to_space(const struct axes *a, const double x[3], double ret[3]);

/* Whether the axes are x1, x2, x3 themselves. */
int axes_are_plain(const struct axes *a);

#endif
