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
    double tilt;   /* of the body [rad], positive: its end at larger x went down */
    double moment; /* that brings it back [N m], about -y */
    double energy; /* against the beginning of the path [J] */
    int slack;     /* slings without force */
    int contacts;  /* edges that slings lean on */
    double others[SUSPENSION_BODIES]; /* tilt of every body [rad] */
};

enum heel_end {
    HEEL_CAPSIZES, /* the moment vanishes and turns over */
    HEEL_FOLDS,    /* the path ends: the others give way before the moment vanishes */
    HEEL_HOLDS     /* neither up to the limit */
};

struct heel_range {
    double tilt;      /* equilibrium [rad] */
    double capsizing; /* tilt of the body where the path ends by capsizing or folding; the limit
                         if it holds [rad] */
    double energy;    /* from equilibrium to there [J] */
    double moment;    /* the largest righting moment on the way [N m] ... */
    double at;        /* ... and its tilt [rad] */
    enum heel_end end;
};

/*
 * The path from the pose start (an equilibrium or a held one; NULL: as drawn, settled) at n tilts
 * going evenly from first to last; ret (n), *ret_n points are filled before the path folds.
 * SW_NOCONV, SW_ADMISSIBLE as hang.
 */
enum status heel_path(const struct suspension *s, int body, const struct pose *start, double first,
                      double last, int n, struct heel *ret, int *ret_n);

/* Equilibrium h, a stable one, and the range of tilt from there towards limit (either sign). */
enum status heel_range(const struct suspension *s, int body, const struct hang *h, double limit,
                       struct heel_range *ret);

#endif
