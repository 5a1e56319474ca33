/*
 * Suspensions of heavy lifts: geometry, metacentric heights, what would make them zero.
 *
 * Source: "Stabilitaet der Aufhaengung beim Schwergutumschlag" (numbers of sections and equations
 * in brackets are its), with the corrections named at each function.  One suspension hangs a load,
 * or one end of it, on a hook, or on two (elastic).  Two views: lengthwise and crosswise.
 *
 * SI units, angles in radians.  gamma < 0: the secondary slings run inwards going down.  z > 0: the
 * centre of gravity lies above the plane of the lifting points.  Functions own no memory.  A number
 * outside of its range gives SW_ADMISSIBLE and a struct rigging_fault; NAN never comes out of a
 * suspension that was accepted, but INFINITY may: rigid slings on two hooks do not tilt at all.
 */
#ifndef SEILWERK_PHYS_RIGGING_H
#define SEILWERK_PHYS_RIGGING_H

#include "num/status.h"

#define RIGGING_GRAVITY 9.81               /* m/s2 */
#define RIGGING_TAN5 0.0874886635259240052 /* tan of the 5 degrees of section 1.3.1 */

enum rigging_type {
    RIGGING_SINGLE,   /* slings to one point of the load, vertical */
    RIGGING_PRIMARY,  /* slings from one hook to the load, rigid */
    RIGGING_ELASTIC,  /* the same on two hooks, elastic: 2 slings each, hooks base_cross apart */
    RIGGING_SECONDARY /* slings from the hook to a spreader, from it to the load, rigid */
};

enum rigging_view { RIGGING_LONG, RIGGING_CROSS, RIGGING_VIEWS };

/* What is given.  NAN: not given. */
struct rigging {
    enum rigging_type type;
    double v, s, z;    /* m: heights of primary and secondary part, of the centre of gravity */
    double phi, gamma; /* rad from the vertical, of primary and secondary slings */
    double m_spreader; /* kg, all spreaders above m_load */
    double m_load;     /* kg */
    double sling;      /* m, length of a primary sling under load */
    double base[RIGGING_VIEWS]; /* m, distance of the lifting points in each view */
    double strain_wll;          /* strain at the working load limit, - */
    double use;                 /* force over working load limit, -; NAN: from wll, or else 1 */
    double wll;                 /* N, of a primary sling */
    double wll_secondary;       /* N; NAN: wll */
    double slings;              /* that share the load; NAN: 1 (single), else 4 */
    double stabilized;          /* not 0: the rule of 5 degrees does not hold */
    int loose;                  /* what is given twice need not agree */
};

/* A suspension whose geometry is complete. */
struct suspension {
    enum rigging_type type;
    int stabilized;
    double v, s, z;             /* m */
    double T[RIGGING_VIEWS];    /* tan(phi) of each view; NAN: the view is not described; INFINITY:
                                   its angle is not known, and h does not depend on it */
    double base[RIGGING_VIEWS]; /* m; NAN: not given */
    double t;                   /* tan(gamma) */
    double mu;                  /* 1 + m_spreader/m_load */
    double strain;              /* of the slings at the present load */
    double use;                 /* that this strain belongs to; NAN: no matter */
    double m_load, m_spreader;  /* kg; NAN: not given, m_spreader 0 where there is none */
    double wll, wll_secondary;  /* N; NAN: not given */
    double slings;
};

/* Which quantity is wrong, as a member of struct rigging, and why; static storage. */
struct rigging_fault {
    const char *quantity, *text;
    double value; /* the number that decided; NAN: none */
    const char *unit;
};

/*
 * Complete and judge what is given.  Follows if it is not given: v from sling, phi from base and v,
 * gamma from the base, v, s and phi, use from wll and m_load.  What is given twice must agree
 * within 1 %.  Refused: lengths, masses, strains that are negative; phi outside of (0, 90) degrees,
 * gamma outside of (-90, 90); slings that do not reach; v tan(phi) + s tan(gamma) <= 0 (no base is
 * left); a strain of 1 or more; what the type needs and is not there.  SW_ADMISSIBLE.
 */
enum status rigging_complete(const struct rigging *r, struct suspension *ret,
                             struct rigging_fault *fault);

/* Swing of the secondary slings over tilt of the spreader, c = dgamma/dphi (10); mu = 1 + mT/mC. */
double rigging_c(double T, double t, double mu);

/* Tilt of the load over tilt of the spreader, 1 - c s t/(v T + s t), (11) with dalpha; 1 where
 * there is no spreader. */
double rigging_tilt_ratio(const struct suspension *a);

/* Metacentric heights: offset of the centre of gravity over tilt of the spreader, or of the load
 * where there is none. */
struct rigging_heights {
    double h[RIGGING_VIEWS];        /* m; NAN: view not described; INFINITY: cannot tilt */
    double document[RIGGING_VIEWS]; /* the same by the document's formulas */
    int ruled[RIGGING_VIEWS];       /* the rule of 5 degrees (1.3.1) made h = -z */
    double c, r;                    /* rigging_c, rigging_tilt_ratio; NAN, 1 without a spreader */
    double centre[RIGGING_VIEWS];   /* m, centre of suspension above the lifting points; NAN: two
                                       hooks */
};

/*
 *   single      h = -z (1.2.8)
 *   primary     h = v - z (2); phi < 5 degrees and z > v tan(phi), not stabilized: h = -z (1.3.1)
 *   secondary   h = s (1 - c) + v mu - z r (15), exact (planar linkage)
 *   elastic     lengthwise h = v (1 - eps)/(1 + 4 v^2 eps/b^2) - z; document (25):
 *                          h = v - z (1 + 4 L^2 eps/b^2), L^2 = v^2 + b^2/4
 *               crosswise  h = l^2/(4 v) (cos^2(phi)/eps + sin^2(phi)) - z; document (32):
 *                          h = l^2/(4 v eps) - z, too large by 1/cos^2(phi): unsafe
 * The elastic ones are exact to first order in the tilt; (29) of the document is inverted.
 */
void rigging_heights(const struct suspension *a, struct rigging_heights *ret);

/* Least height over the views that are described: the one that judges; *ret_view which. */
double rigging_least(const double h[RIGGING_VIEWS], enum rigging_view *ret_view);

/* z at which the least height passes 0 while all else stays; under the rule of 5 degrees, where it
 * jumps. */
double rigging_critical_z(const struct suspension *a);

/* The v, and the gamma [rad], next to the present one at which the least height passes 0; all else
 * stays: angles where they were given or follow, the base of elastic slings.  NAN: there is none
 * (v up to 1000 times the present one, gamma until 1e-6 of the base is left), or the type has no
 * such quantity. */
double rigging_critical_v(const struct suspension *a);
double rigging_critical_gamma(const struct suspension *a);

#endif
