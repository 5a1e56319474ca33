/*
 * The march against a plain one that is written here from equation (4.17) in increment form (theory
 * section 3): matrices of all unknowns in one band, assembled element by element, one factor, no
 * shortcut for what does not couple, forces by the plain element, dampers in C itself.
 */
#include "check.h"
#include "phys/march.h"

#include <string.h>

enum { MOST = 6 * 34, STEPS = 1000, HALF = 11 };

struct reference {
    const struct model *m;
    const struct march_options *o;
    struct band M, C, A;          /* over all nodes, half bandwidth 11 */
    struct band_factor factor;    /* of A for the free unknowns */
    int keep[MOST], held[6], all; /* free unknowns, prescribed ones, number of all */
    long step;
    double V[MOST], D[MOST], F[MOST], dd[MOST]; /* as in struct march */
};

static void add_element(const struct reference *r, int k, struct band *M, struct band *K)
{
    static const double rest[12];
    struct element e = model_element(r->m, k);
    double one[16], E[144] = {0};

    element_mass(r->m->line.cable.mu, r->m->h, one);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                int row = i / 2 * 6 + 2 * c + i % 2, column = j / 2 * 6 + 2 * c + j % 2;

                E[row + 12 * column] = one[i + 4 * j];
            }
    band_add_block(M, 6 * k, 12, E);
    element_tangent(&e, 0, 0, rest, E);
    band_add_block(K, 6 * k, 12, E);
}

/* C += c b b^T, b^T V the displacement at the damper along its unit direction. */
static void add_damper(const struct reference *r, const struct damper *d, struct band *C)
{
    double at = d->position * r->m->n, f[4], f1[4], b[12], E[144];
    double size = sqrt(pow(d->direction[0], 2) + pow(d->direction[1], 2) + pow(d->direction[2], 2));
    int k = (int)at;

    hermite(r->m->h, at - k, f, f1);
    for (int i = 0; i < 12; i++)
        b[i] = f[i / 6 * 2 + i % 2] * d->direction[i % 6 / 2] / size;
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 12; i++)
            E[i + 12 * j] = d->coefficient * b[i] * b[j];
    band_add_block(C, 6 * k, 12, E);
}

static void factor(const struct reference *r, const struct band *A, struct band_factor *ret)
{
    struct band free_part;

    assert_int_equal(band_restrict(A, r->keep, 6 * r->m->n, &free_part), SW_OK);
    assert_int_equal(band_cholesky(&free_part, ret), SW_OK);
    band_free(&free_part);
}

static void reference_new(const struct model *m, const struct march_options *o, struct reference *r)
{
    struct band K;

    *r = (struct reference){.m = m, .o = o, .all = 6 * (m->n + 1)};
    for (int i = 0, j = 0; i < r->all; i++)
        if ((i < 6 || i >= 6 * m->n) && i % 2 == 0)
            r->held[i < 6 ? i / 2 : 3 + i % 6 / 2] = i;
        else
            r->keep[j++] = i;
    assert_int_equal(band_new(r->all, HALF, &r->M), SW_OK);
    assert_int_equal(band_new(r->all, HALF, &K), SW_OK);
    for (int k = 0; k < m->n; k++)
        add_element(r, k, &r->M, &K);
    assert_int_equal(band_combine(o->alpha, &r->M, o->beta, &K, &r->C), SW_OK);
    for (int i = 0; i < o->n_dampers; i++)
        add_damper(r, &o->damper[i], &r->C);
    assert_int_equal(band_combine(1 / (o->dt * o->dt), &r->M, 1 / (2 * o->dt), &r->C, &r->A),
                     SW_OK);
    factor(r, &r->A, &r->factor);
    band_free(&K);
}

static void reference_free(struct reference *r)
{
    band_free(&r->M);
    band_free(&r->C);
    band_free(&r->A);
    band_factor_free(&r->factor);
}

/* x with A x = -F - C D/dt in the free rows and held values; F of the present V. */
static void solve(struct reference *r, const struct band *A, const struct band_factor *Af,
                  const double held[6], double *x)
{
    double rhs[MOST];

    memset(r->F, 0, sizeof r->F);
    for (int k = 0; k < r->m->n; k++) {
        struct element e = model_element(r->m, k);

        element_force(&e, r->o->terms, r->V + 6 * k, r->F + 6 * k, NULL);
    }
    memset(x, 0, sizeof r->dd);
    for (int i = 0; i < 6; i++)
        x[r->held[i]] = held[i];
    for (int i = 0; i < r->all; i++)
        rhs[i] = -r->F[i];
    band_multiply_add(&r->C, -1 / r->o->dt, r->D, rhs);
    band_multiply_add(A, -1, x, rhs);
    for (int i = 0; i < 6 * r->m->n; i++)
        rhs[i] = rhs[r->keep[i]];
    band_solve(Af, rhs);
    for (int i = 0; i < 6 * r->m->n; i++)
        x[r->keep[i]] = rhs[i];
}

static void supports_at(const struct reference *r, double t, double u[6], double v[6], double a[6])
{
    motion_sum(r->o->motion, r->o->n_motions, t, u, v, a);
}

/* At rest but for the supports: V(-dt) = V(0) - dt V' + dt^2/2 V'', M V'' = -F - C V'. */
static void reference_start(struct reference *r, const double *V0)
{
    double u[6], v[6], a[6], past[6], dt = r->o->dt;
    struct band_factor Mf;

    supports_at(r, 0, u, v, a);
    supports_at(r, -dt, past, NULL, NULL);
    memcpy(r->V, V0, (size_t)r->all * sizeof *V0);
    for (int i = 0; i < 6; i++) {
        r->V[r->held[i]] = u[i];
        r->D[r->held[i]] = dt * v[i];
    }
    factor(r, &r->M, &Mf);
    solve(r, &r->M, &Mf, a, r->dd);
    band_factor_free(&Mf);
    for (int i = 0; i < r->all; i++)
        r->D[i] -= dt * dt / 2 * r->dd[i];
    for (int i = 0; i < 6; i++)
        r->D[r->held[i]] = u[i] - past[i];
}

static void reference_solve(struct reference *r)
{
    double next[6], held[6];

    supports_at(r, (double)(r->step + 1) * r->o->dt, next, NULL, NULL);
    for (int i = 0; i < 6; i++)
        held[i] = next[i] - r->V[r->held[i]] - r->D[r->held[i]];
    solve(r, &r->A, &r->factor, held, r->dd);
}

static void reference_advance(struct reference *r)
{
    for (int i = 0; i < r->all; i++) {
        r->D[i] += r->dd[i];
        r->V[i] += r->D[i];
    }
    r->step++;
}

/* A dd + C D/dt + F in the rows of the supports, and the static reactions. */
static void reference_support(const struct reference *r, double ret[6])
{
    const struct line *s = &r->m->line;
    const double at_rest[6] = {-s->H, -s->V, 0, s->H, s->V - s->W, 0};
    double f[MOST];

    memcpy(f, r->F, sizeof f);
    band_multiply_add(&r->A, 1, r->dd, f);
    band_multiply_add(&r->C, 1 / r->o->dt, r->D, f);
    for (int i = 0; i < 6; i++)
        ret[i] = f[r->held[i]] + at_rest[i];
}

/* Both supports move in all three directions, by little: terms 1 and 2 alone are not bounded. */
static const struct motion shake[] = {
    {SUPPORT_RIGHT, {0.02, 0.01, 0.015}, 9.124, {0.4, 0, 1}, 0, NULL, NULL},
    {SUPPORT_LEFT, {0.005, -0.01, 0.01}, 4.9, {1, 2, 0}, 0, NULL, NULL},
};

/* How far the march and the reference are apart after STEPS steps, over the largest displacement,
 * slopes times the element length; and the forces of the supports over H. */
static void run_both(const struct model *m, const struct march_options *o, double *apart,
                     double *force_apart)
{
    double V0[MOST], u[6], f[6], g[6], most = 0;
    struct reference r;
    struct march a;

    motion_sum(shake, 2, 0, u, NULL, NULL);
    assert_int_equal(model_equilibrium(m, 3, u, V0), SW_OK);
    reference_new(m, o, &r);
    assert_int_equal(march_new(m, o, &a), SW_OK);
    reference_start(&r, V0);
    assert_int_equal(march_start(&a, V0, NULL), SW_OK);
    *apart = *force_apart = 0;
    for (int k = 0; k <= STEPS; k++) {
        reference_solve(&r);
        assert_int_equal(march_solve(&a), SW_OK);
        if (k == STEPS)
            break;
        reference_advance(&r);
        march_advance(&a);
    }
    for (int i = 0; i < r.all; i++) {
        double scale = i % 2 ? m->h : 1;

        most = fmax(most, scale * fabs(r.V[i]));
        if (!(scale * fabs(r.V[i] - a.V[i]) <= *apart))
            *apart = scale * fabs(r.V[i] - a.V[i]);
    }
    *apart /= most;
    reference_support(&r, g);
    march_support_force(&a, f);
    for (int i = 0; i < 6; i++)
        if (!(fabs(f[i] - g[i]) <= *force_apart))
            *force_apart = fabs(f[i] - g[i]);
    *force_apart /= m->line.H;
    assert_true(most > 0.04 && most < 2);
    reference_free(&r);
    march_free(&a);
}

static void every_mesh_and_term(void **state)
{
    static const int elements[] = {1, 2, 3, 10, 33};
    double worst = 0, worst_force = 0;
    (void)state;

    for (int k = 0; k < 5; k++) {
        struct model m;

        assert_int_equal(model_new(&seil2, k % 2 ? LAW_THESIS : LAW_HOOKE, elements[k], &m), SW_OK);
        for (int terms = 0; terms <= 3; terms++)
            for (int stiff = 0; stiff <= 1; stiff++) {
                struct march_options o = {.alpha = 0.10951,
                                          .beta = stiff ? 3.5061e-3 : 0,
                                          .dt = 0.9 * march_critical_step(&m),
                                          .terms = terms,
                                          .motion = shake,
                                          .n_motions = 2};
                double apart, force;

                run_both(&m, &o, &apart, &force);
                worst = fmax(worst, apart);
                worst_force = fmax(worst_force, force);
                below(apart, 1e-12);
                below(force, 1e-11); /* EA/H = 900 times a strain */
            }
        model_free(&m);
    }
    print_message("# march and reference: %.2g apart, forces %.2g\n", worst, worst_force);
}

/* Dampers at and beside nodes, in the element at a support, alone and together. */
static void with_dampers(void **state)
{
    static const int elements[] = {1, 3, 10};
    static const struct damper skew[] = {{0.02, {1, -2, 3}, 4000},
                                         {0.5, {0.3, 0.5, -0.2}, 150},
                                         {0.97, {-1, 1, 0.5}, 900}};
    double worst = 0, worst_force = 0;
    (void)state;

    for (int k = 0; k < 3; k++) {
        struct model m;

        assert_int_equal(model_new(&seil2, LAW_THESIS, elements[k], &m), SW_OK);
        for (int from = 0; from < 3; from++)
            for (int stiff = 0; stiff <= 1; stiff++) {
                struct march_options o = {.alpha = 0.10951,
                                          .beta = stiff ? 3.5061e-3 : 0,
                                          .dt = 0.9 * march_critical_step(&m),
                                          .terms = 3,
                                          .motion = shake,
                                          .n_motions = 2,
                                          .damper = from < 2 ? skew + from : skew,
                                          .n_dampers = from < 2 ? 1 : 3};
                double apart, force;

                run_both(&m, &o, &apart, &force);
                worst = fmax(worst, apart);
                worst_force = fmax(worst_force, force);
                below(apart, 1e-12);
                below(force, 1e-11);
            }
        model_free(&m);
    }
    print_message("# with dampers: %.2g apart, forces %.2g\n", worst, worst_force);
}

/* Four elements at a time against one: numbers of elements that fill no group of four, too. */
static void forces_of_all_elements(void **state)
{
    uint64_t seed = 4711;
    double worst = 0;
    (void)state;

    for (int n = 1; n <= 33; n++) {
        struct force_table table;
        struct model m;

        assert_int_equal(model_new(&seil2, (enum law)(n % 3), n, &m), SW_OK);
        assert_int_equal(force_new(&m, &table), SW_OK);
        for (int terms = 0; terms <= 3; terms++) {
            double V[MOST], F[MOST], G[MOST], most = 0;
            struct force_extremes seen;
            struct strain_watch watch;

            for (int i = 0; i < 6 * (n + 1); i++)
                V[i] = uniform_in(&seed, -0.1, 0.1);
            model_force(&m, terms, V, F, &watch);
            force_all(&table, terms, V, G, &seen);
            for (int i = 0; i < 6 * (n + 1); i++)
                most = fmax(most, fabs(F[i]));
            for (int i = 0; i < 6 * (n + 1); i++) {
                worst = fmax(worst, fabs(F[i] - G[i]) / most);
                near_abs(G[i], F[i], 1e-14 * most);
            }
            assert_true((seen.least_force < 0) == (watch.least_force < 0)); /* no more is said */
            near_rel(seen.most_stiffened, watch.most_stiffened, 1e-12);
        }
        force_free(&table);
        model_free(&m);
    }
    print_message("# forces of all elements: %.2g apart\n", worst);
}

TEST_MAIN(cmocka_unit_test(every_mesh_and_term), cmocka_unit_test(with_dampers),
          cmocka_unit_test(forces_of_all_elements))
