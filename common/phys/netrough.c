/* Stiffness of ropes in closed form (theory section 5, Bild 3) and fictitious, for first steps. */
#include "phys/network.h"

#include <math.h>

/* Of a rope under its own weight, inextensible and level, with angle phi between rope and chord at
 * the ends, times T/s: along the chord, across it in its plane, out of the plane. */
static void catenary_form(double phi, double ret[3])
{
    double A = log((1 + sin(phi)) / cos(phi));

    ret[0] = cos(phi) * A / (A - sin(phi));
    ret[1] = A / tan(phi);
    ret[2] = cos(phi);
}

/*
 * Closed: the rope as if it hung symmetrically about its chord's direction c, sag from its load
 * across the chord: tan(phi) = load/(2 T).  Elastic stretch EA/L0 in series along the chord.
 */
static void closed(const struct rope *r, const double t[3], double K[SYM])
{
    double load[3], middle[3], T, across[3], along = 0, phi, form[3], c[3], n[3], size = 0, k[3];

    rope_load(r, load);
    for (int i = 0; i < 3; i++)
        middle[i] = t[i] - load[i] / 2;
    T = sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2] +
             r->epsilon * r->epsilon);
    for (int i = 0; i < 3; i++) {
        c[i] = middle[i] / T;
        along += load[i] * c[i];
    }
    for (int i = 0; i < 3; i++) {
        across[i] = load[i] - along * c[i];
        size += across[i] * across[i];
    }
    size = sqrt(size);
    phi = fmin(fmax(atan(size / (2 * T)), 1e-3), 1.5);
    catenary_form(phi, form);
    T /= cos(phi); /* at the ends */
    k[0] = 1 / (r->L0 / (form[0] * T) + r->L0 / r->law.EA);
    k[1] = form[1] * T / r->L0;
    k[2] = form[2] * T / r->L0;
    for (int i = 0; i < 3; i++)
        n[i] = size > 0 ? across[i] / size : 0;
    for (int i = 0, at = 0; i < 3; i++)
        for (int j = i; j < 3; j++, at++)
            K[at] = k[2] * (i == j) + (k[0] - k[2]) * c[i] * c[j] + (k[1] - k[2]) * n[i] * n[j];
}

void net_rough_stiffness(const struct rope *r, enum net_stiffness kind, const double t[3],
                         double reference, double K[SYM])
{
    if (kind == NET_CLOSED) {
        closed(r, t, K);
        return;
    }
    for (int i = 0; i < SYM; i++)
        K[i] = 0;
    K[SYM_XX] = K[SYM_YY] = K[SYM_ZZ] = reference / r->L0;
}
