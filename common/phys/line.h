/*
 * The static line of one elastic cable under its own weight (Thalheim A.1; theory c1).
 *
 * Frame: origin at the left support, x1 horizontal towards the right one, x2 vertical and positive
 * DOWNWARD.  theta in [0, L0] runs along the unstressed cable.  SI units, angles in radians.
 */
#ifndef SEILWERK_PHYS_LINE_H
#define SEILWERK_PHYS_LINE_H

#include "num/status.h"

struct cable {
    double L0;   /* unstressed length [m], > 0 */
    double mu;   /* mass per unstressed metre [kg/m], > 0 */
    double EA;   /* axial stiffness [N], > 0 */
    double g;    /* acceleration of gravity [m/s2], >= 0; 0 only for a chord longer than L0 */
    double span; /* horizontal distance of the supports [m], > 0 */
    double drop; /* right support below the left one [m], any sign */
};

struct line {
    struct cable cable;
    double W;    /* weight mu g L0 [N] */
    double H, V; /* reactions of the left support [N]: horizontal, upward */
    int steps;   /* Newton steps taken */
};

struct line_point {
    double theta;   /* [m] */
    double x1, x2;  /* place [m] */
    double V;       /* vertical component V - W theta/L0 of the tension [N] */
    double tension; /* physical tension T* [N] (A.108) */
    double stretch; /* a = ds/dtheta = 1 + T* / EA */
};

/* Why the cable c has no static line that could be computed, or NULL if it has one. */
const char *line_inadmissible(const struct cable *c);

/* Reactions H, V of (A.110) to round-off, by damped Newton steps from taut to slack.
 * SW_ADMISSIBLE as line_inadmissible tells; SW_NOCONV (not seen in 1e6 random cables). */
enum status line_solve(const struct cable *c, struct line *ret);

/* The point at theta (A.108, A.109), 0 <= theta <= L0. */
void line_at(const struct line *s, double theta, struct line_point *ret);

/* Flexibility of the ends in the cable's plane, d(span, drop)/d(H, V) [m/N], 2x2 symmetric. */
void line_flexibility(const struct line *s, double ret[4]);

/* Exact stiffness [N/m] of the right end against the left one, 3x3 symmetric, axes x1 x2 x3. */
void line_stiffness(const struct line *s, double ret[9]);

/* The piece from theta a to b, a < b, as a line of its own; its origin is the point at a. */
void line_piece(const struct line *s, double a, double b, struct line *ret);

/* How far the point at theta, 0 < theta < L0, lies below the chord along axis 2 [m]. */
double line_below_chord(const struct line *s, double theta);

/* theta of the point farthest below the chord, where the tangent is parallel to it [m]. */
double line_deepest(const struct line *s);

/* Sag at theta = L0/2, vertically below the chord [m]. */
double line_sag(const struct line *s);

/* Stretched length [m], the integral of a over theta. */
double line_length(const struct line *s);

/* Irvine's lambda^2 = (m g l/H)^2 l EA/(H Le), Le = l (1 + (m g l/H)^2/8), for the mass m [kg] per
 * metre of chord: mu L0/chord for frequencies; the thesis puts mu.  Inclined cables: the chord for
 * l, its tension for H, and gravity across it. */
double line_lambda2(const struct line *s, double m);

/* Length of the chord [m]. */
double line_chord(const struct cable *c);

#endif
