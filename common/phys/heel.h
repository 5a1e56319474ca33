/*
 * Large tilt of a planar suspension: righting moment, capsizing, and the energy it takes.
 *
 * The tilt of one body (the load) is prescribed and everything else relaxed: a quasi-static path
 * from the upright equilibrium on.  The moment that holds the body there is dE/d tilt.
 */
#ifndef SEILWERK_PHYS_HEEL_H
#define SEILWERK_PHYS_HEEL_H

#include "phys/hang.h"

struct heel {
    double tilt;                /* of the body [rad], positive: its end at larger x went down */
    double moment;              /* that brings it back [N m], about -y */
    double energy;              /* against the beginning of the path [J] */
    int slack;                  /* slings without force */
    int contacts;               /* edges that slings lean on */
    double others[GEAR_BODIES]; /* tilt of every body [rad] */
};

enum heel_end {
    HEEL_CAPSIZES, /* the moment vanishes and turns over */
    HEEL_FOLDS,    /* the path ends: the others give way before the moment vanishes */
    HEEL_HOLDS     /* neither up to the limit */
};

struct heel_range {
    double tilt;      /* equilibrium [rad] */
    double capsizing; /* where it capsizes or the path folds; the limit if it holds [rad] */
    double energy;    /* from equilibrium to there [J] */
    double moment;    /* the largest righting moment on the way [N m] ... */
    double at;        /* ... and its tilt [rad] */
    enum heel_end end;
};

/*
 * The path from the pose start (an equilibrium or a held one; NULL: as drawn, settled) at n tilts
 * going evenly from first to last [rad]; ret (n), *ret_n points are filled before the path folds.
 * SW_NOCONV: no equilibrium at start; SW_ADMISSIBLE: no planar suspension, no such body.
 */
enum status heel_path(const struct gear *s, int body, const struct pose *start, double first,
                      double last, int n, struct heel *ret, int *ret_n);

/*
 * The range of tilt from the equilibrium h, a stable one, towards limit [rad], either way.
 * SW_INFEASIBLE: nothing rights it, h is not stable; SW_ADMISSIBLE: no planar suspension, no such
 * body.
 */
enum status heel_range(const struct gear *s, int body, const struct hang *h, double limit,
                       struct heel_range *ret);

#endif
