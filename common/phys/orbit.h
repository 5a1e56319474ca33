/*
 * The path of one point of the cable over a window of time: bounds, harmonics of the excitation,
 * the ellipse that it draws across the cable.
 *
 * With phi the phase of the excitation, v = mean + sum A_k cos(k phi/2 + p_k), k = 1..6: half the
 * excitation's frequency, that itself, and so on.  The sums are exact for equal steps over whole
 * pairs of periods.
 */
#ifndef SEILWERK_PHYS_ORBIT_H
#define SEILWERK_PHYS_ORBIT_H

#define ORBIT_ORDERS 6 /* k = 1..6, half orders */

/* Sums over the samples of a window; a zeroed struct is an empty one.  Nothing but doubles. */
struct orbit_window {
    double n; /* samples */
    double least[3], greatest[3], sum[3];
    double c[ORBIT_ORDERS][3], s[ORBIT_ORDERS][3];
    double tension;
};

enum orbit_plane {
    ORBIT_REST,
    ORBIT_IN,          /* in the plane of x1 and x2 */
    ORBIT_LATERAL,     /* along x3 */
    ORBIT_INCLINED,    /* a line between the two */
    ORBIT_WHIRL_RIGHT, /* round, from x2 towards x3 */
    ORBIT_WHIRL_LEFT
};

struct orbit {
    double least[3], greatest[3];     /* of v1, v2, v3 [m] */
    double amplitude[3];              /* half of greatest - least [m] */
    double mean[3];                   /* [m] */
    double harmonic[ORBIT_ORDERS][3]; /* A_k [m] */
    double phase[ORBIT_ORDERS][3];    /* p_k [rad], -pi..pi */
    int order;                        /* k of the largest harmonic across the cable, 0: none */
    double major, minor;              /* half axes of its ellipse in x2, x3 [m] */
    double tilt;                      /* of the longer one from x2 towards x3 [rad], to pi/2 */
    enum orbit_plane plane;
    double tension; /* greatest [N] */
};

/* Take in displacement v [m] and tension [N] at phase phi of the excitation. */
void orbit_add(struct orbit_window *w, double phi, const double v[3], double tension);

/* The orbit of a window of at least one sample. */
void orbit_of(const struct orbit_window *w, struct orbit *ret);

/* "in", "lateral", ... for tables. */
const char *orbit_plane_name(enum orbit_plane plane);

#endif
