/*
 * What the tests of stability maps share: a rope of the thesis whose right support moves, and
 * equations that are written down by hand.
 */
#ifndef SEILWERK_TESTS_ROPE_H
#define SEILWERK_TESTS_ROPE_H

#include "check.h"
#include "phys/map.h"

#define MOST_MODES 8

struct rope {
    struct model m;
    struct modes p;
    int mode[MOST_MODES];
    struct map map; /* its mode points into this struct: not to be copied */
};

/* The s lowest modes on n elements; the right support moves by 1 m along the chord. */
static inline void rope_begin(const struct cable *c, enum law law, int n, int s, double alpha,
                              double beta, int ground_damped, struct rope *r)
{
    assert_int_equal(model_new(c, law, n, &r->m), SW_OK);
    assert_int_equal(modes_lowest(&r->m, s, SOLVER_AUTO, &r->p), SW_OK);
    for (int i = 0; i < s; i++)
        r->mode[i] = i;
    assert_int_equal(map_new(&r->m, &r->p, r->mode, s, ground_damped ? alpha : 0,
                             ground_damped ? beta : 0, &r->map),
                     SW_OK);
    r->map.alpha = alpha;
    r->map.beta = beta;
    r->map.reference = r->p.omega[0];
    r->map.b[3] = 1;
}

static inline void rope_end(struct rope *r)
{
    map_free(&r->map);
    modes_free(&r->p);
    model_free(&r->m);
}

/* Equations of one or two modes, all zero at first. */
struct hand {
    double number[2 * 2 + 5 * 4];
    struct parametric p;
};

static inline struct parametric *hand_begin(int s, struct hand *h)
{
    // cppcheck-suppress ctuuninitvar  // a place in it, which is filled here
    double *at = h->number;

    *h = (struct hand){.number = {0}};
    h->p = (struct parametric){.s = s,
                               .omega = at,
                               .c = at + 2,
                               .psi_c = at + 4,
                               .psi_s = at + 8,
                               .mean = at + 12,
                               .double_c = at + 16,
                               .double_s = at + 20};
    return &h->p;
}

#define ALPHA_2 1.0951e-1 /* damping of SEIL2, sheet A.5 */
#define BETA_2 3.5061e-3
#define ALPHA_1 8.3083e-2 /* of SEIL1, table 6.3 */
#define BETA_1 5.8940e-4

#endif
