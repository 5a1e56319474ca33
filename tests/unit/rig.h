/*
 * What the tests of suspensions share: the check formula, random linkages, balance of forces summed
 * apart from the code under test.
 */
#ifndef SEILWERK_TESTS_RIG_H
#define SEILWERK_TESTS_RIG_H

#include "check.h"

#include "phys/hang.h"
#include "phys/linkage.h"
#include "phys/path.h"
#include "phys/tandem.h"

#include <string.h>

#define DEGREES (PI / 180)

struct formula {
    double c, r, h, z_critical;
};

/* c = d gamma/d phi, h = offset over tilt of the spreader, r = tilt of the load over that. */
static inline struct formula formula_of(const struct linkage *l)
{
    double q = 1 + l->m_spreader / l->m_load, swing = l->s * tan(l->gamma);
    struct formula f;

    f.c = cos(l->gamma) * cos(l->gamma) - q * sin(l->gamma) * cos(l->gamma) / tan(l->phi);
    f.r = 1 - f.c * swing / (l->v * tan(l->phi) + swing);
    f.h = l->s * (1 - f.c) + l->v * q - l->z * f.r;
    f.z_critical = (l->s * (1 - f.c) + l->v * q) / f.r;
    return f;
}

/* Hook, spreader, load; gamma within 60 degrees, lifting points well apart. */
static inline struct linkage random_linkage(uint64_t *seed)
{
    struct linkage l;

    do {
        l = (struct linkage){.v = log_uniform(seed, 0.5, 20),
                             .s = log_uniform(seed, 0.5, 20),
                             .phi = uniform_in(seed, 5, 75) * DEGREES,
                             .gamma = uniform_in(seed, -60, 60) * DEGREES,
                             .m_load = log_uniform(seed, 1e3, 1e6),
                             .g = 9.81};
        l.m_spreader = uniform(seed) < 0.1 ? 0 : l.m_load * log_uniform(seed, 1e-3, 0.5);
    } while (!(l.v * tan(l.phi) + l.s * tan(l.gamma) > 0.2 * (l.v * tan(l.phi))));
    l.z = uniform_in(seed, -1, 1) * (l.v + l.s);
    return l;
}

/* Case 1.2.4. */
static const struct linkage inclined = {.v = 3.6,
                                        .s = 7.5,
                                        .z = 1.1,
                                        .phi = 26 * DEGREES,
                                        .gamma = -4 * DEGREES,
                                        .m_spreader = 2000,
                                        .m_load = 60000,
                                        .g = 9.81};

/* Cases 1.2.1 to 1.2.3: short primary slings, the centre of gravity high above the lifting points,
 * vertical secondary slings along the load's sides. */
static inline struct linkage leaning(double h, double gap)
{
    struct linkage l = {.v = 1,
                        .s = 8,
                        .phi = 70 * DEGREES,
                        .m_spreader = 8e3,
                        .m_load = 1e5,
                        .g = 9.81,
                        .edges = 1,
                        .height = {3}};

    l.z = formula_of(&l).h - h;
    l.half[0] = l.v * tan(l.phi) - gap;
    return l;
}

static inline struct gear suspended_linkage(const struct linkage *l)
{
    struct gear s;

    assert_int_equal(linkage_gear(l, &s), SW_OK);
    return s;
}

static inline struct gear suspended_tandem(const struct tandem *t)
{
    struct gear s;

    assert_int_equal(tandem_gear(t, &s), SW_OK);
    return s;
}

static inline struct hang hung(const struct gear *s, enum hang_way way)
{
    struct hang h;

    assert_int_equal(hang(s, way, NULL, -1, &h), SW_OK);
    return h;
}

/* Place of point p of s. */
static inline void place(const struct gear *s, const struct hang *h, int p, double ret[3])
{
    const struct hitch *at = s->point + p;

    for (int i = 0; i < 3; i++) {
        ret[i] = at->body < 0 ? at->at[i] : h->pose[at->body].r[i];
        for (int j = 0; j < 3 && at->body >= 0; j++)
            ret[i] += h->pose[at->body].R[i][j] * (at->at[j] - s->body[at->body].cg[j]);
    }
}

/* Force F at x on body: onto the sums of forces and moments about the origin. */
static inline void pull_at(double sum[][6], int body, const double x[3], const double F[3])
{
    if (body < 0)
        return;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;

        sum[body][i] += F[i];
        sum[body][3 + i] += x[j] * F[k] - x[k] * F[j];
    }
}

/* Where sling k goes off a and b, and in which direction: between its ends, or between the edge
 * that it touches first and its end at from. */
static inline void free_part(const struct gear *s, const struct hang *h, int k, double a[3],
                             double b[3])
{
    struct path p;

    place(s, h, s->sling[k].from, a);
    place(s, h, s->sling[k].to, b);
    if (h->contacts[k] == 0)
        return;
    path_lay(s, h->pose, k, &p);
    assert_int_equal(p.n, h->contacts[k] + 2);
    assert_int_equal(p.body[1], s->point[s->sling[k].to].body);
    memcpy(b, p.x[1], sizeof p.x[1]);
}

/* Largest sum of forces, or of moments over the size of everything, on any body, over the weight of
 * all; slings lean on edges of the body at their end to only. */
static inline double unbalanced(const struct gear *s, const struct hang *h)
{
    double sum[GEAR_BODIES][6] = {{0}}, weight, length, most = 0;

    gear_scale(s, &length, &weight);
    for (int b = 0; b < s->bodies; b++)
        pull_at(sum, b, h->pose[b].r, (double[3]){0, 0, -s->body[b].mass * s->g});
    for (int k = 0; k < s->slings; k++) {
        double a[3], b[3], F[3], minus[3], l;
        const struct tie *t = s->sling + k;

        free_part(s, h, k, a, b);
        l = sqrt(pow(b[0] - a[0], 2) + pow(b[1] - a[1], 2) + pow(b[2] - a[2], 2));
        for (int i = 0; i < 3; i++) {
            F[i] = h->force[k] * (b[i] - a[i]) / l;
            minus[i] = -F[i];
        }
        pull_at(sum, s->point[t->from].body, a, F);
        pull_at(sum, s->point[t->to].body, b, minus);
        assert_true(h->force[k] >= 0);
        l = h->contacts[k] > 0 ? h->length[k] : l;
        if (isinf(t->EA))
            below(l / t->length, 1 + 1e-12);
        else
            near_abs(h->force[k], fmax(0, t->EA * (l / t->length - 1)), 1e-10 * weight);
    }
    for (int b = 0; b < s->bodies; b++)
        for (int i = 0; i < 6; i++)
            if (!(fabs(sum[b][i]) / (i < 3 ? weight : weight * length) <= most))
                most = fabs(sum[b][i]) / (i < 3 ? weight : weight * length);
    return most;
}

#endif
