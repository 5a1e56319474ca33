/* The march against a plain one (reference.h), and what it sums up by fours against elements. */
#include "reference.h"

enum { STEPS = 1000 };

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

/* The tangent of all elements against that of each; with a factor, on top of what is there. */
static void tangents_of_all_elements(void **state)
{
    uint64_t seed = 815;
    double worst = 0;
    (void)state;

    for (int n = 1; n <= 33; n++) {
        struct force_table table;
        struct model m;

        assert_int_equal(model_new(&seil2, (enum law)(n % 3), n, &m), SW_OK);
        assert_int_equal(force_new(&m, &table), SW_OK);
        for (int terms = 0; terms <= 3; terms++) {
            double V[MOST], most = 0;
            struct band J, K;

            for (int i = 0; i < 6 * (n + 1); i++)
                V[i] = uniform_in(&seed, -0.1, 0.1);
            assert_int_equal(model_tangent(&m, terms, 0, V, &K), SW_OK);
            assert_int_equal(band_new(K.n, K.kd, &J), SW_OK);
            force_tangent(&table, terms, V, 0.25, &J);
            force_tangent(&table, terms, V, 0.5, &J);
            for (int i = 0; i < K.n * (K.kd + 1); i++)
                most = fmax(most, fabs(K.a[i]));
            for (int i = 0; i < K.n * (K.kd + 1); i++) {
                worst = fmax(worst, fabs(J.a[i] - 0.75 * K.a[i]) / most);
                near_abs(J.a[i], 0.75 * K.a[i], 1e-14 * most);
            }
            band_free(&J);
            band_free(&K);
        }
        force_free(&table);
        model_free(&m);
    }
    print_message("# tangents of all elements: %.2g apart\n", worst);
}

TEST_MAIN(cmocka_unit_test(every_mesh_and_term), cmocka_unit_test(with_dampers),
          cmocka_unit_test(forces_of_all_elements), cmocka_unit_test(tangents_of_all_elements))
