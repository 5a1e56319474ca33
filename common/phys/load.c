/* Uniform loads: the cable in the plane of its load. */
#include "phys/load.h"

#include <float.h>
#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Axes by the direction e2 of the load and the chord; returns the extent of the chord across e2. */
static double turn(const double e2[3], const double chord[3], struct axes *ret)
{
    double(*e)[3] = ret->e, along = dot(chord, e2), across;

    for (int i = 0; i < 3; i++) {
        e[1][i] = e2[i];
        e[0][i] = chord[i] - along * e2[i];
    }
    across = sqrt(dot(e[0], e[0]));
    for (int i = 0; i < 3; i++)
        e[0][i] /= across;
    e[2][0] = e[0][1] * e2[2] - e[0][2] * e2[1];
    e[2][1] = e[0][2] * e2[0] - e[0][0] * e2[2];
    e[2][2] = e[0][0] * e2[1] - e[0][1] * e2[0];
    return across;
}

int load_is_calm(const struct load *load)
{
    return load->wind[0] == 0 && load->wind[1] == 0 && load->wind[2] == 0;
}

void load_apply(const struct cable *c, const struct load *load, struct cable *ret,
                struct axes *ret_axes)
{
    const double chord[3] = {c->span, c->drop, 0};
    double stretch = 1 + load->expansion * load->temperature, mass = c->mu + load->ice;
    double p[3] = {load->wind[0], mass * c->g + load->wind[1], load->wind[2]}, size;

    *ret = *c;
    *ret_axes = (struct axes){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    ret->L0 = c->L0 * stretch;
    ret->mu = mass / stretch;
    size = hypot(hypot(p[0], p[2]), p[1]);
    if (load_is_calm(load))
        return; /* gravity as given, to the last digit and however small */
    if (size <= 8 * DBL_EPSILON * (mass * c->g + hypot(hypot(p[0], p[2]), load->wind[1])))
        size = 0; /* balanced; the rest is round-off and no direction */
    ret->g = size / mass;
    if (size == 0)
        return;
    for (int i = 0; i < 3; i++)
        p[i] /= size;
    ret->span = turn(p, chord, ret_axes);
    ret->drop = dot(chord, p);
}

double load_cold_length(const struct load *load, double L0)
{
    return L0 / (1 + load->expansion * load->temperature);
}

void axes_to_plane(const struct axes *a, const double x[3], double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = dot(a->e[i], x);
}

void axes_to_space(const struct axes *a, const double x[3], double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = a->e[0][i] * x[0] + a->e[1][i] * x[1] + a->e[2][i] * x[2];
}

int axes_are_plain(const struct axes *a)
{
    return a->e[0][0] == 1 && a->e[1][1] == 1 && a->e[2][2] == 1;
}
