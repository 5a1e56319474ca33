/* Kinds, participation and axes of modes: symmetry, closed forms, sums over all modes. */
#include "check.h"
#include "num/mem.h"
#include "phys/irvine.h"
#include "phys/modes.h"
#include "phys/shape.h"
#include "phys/turn.h"

#include <string.h>

/* The case's model and its k lowest modes. */
static struct modes solve(const struct cable *c, int n, int k, struct model *m)
{
    struct modes p;

    assert_int_equal(model_new(c, LAW_HOOKE, n, m), SW_OK);
    assert_int_equal(modes_lowest(m, k, SOLVER_DENSE, &p), SW_OK);
    return p;
}

static struct character character_of(const struct model *m, const struct modes *p, int i)
{
    double *V = model_vector(m);
    struct character it;

    modes_shape(m, p, i, V);
    shape_character(m, V, &it);
    free(V);
    return it;
}

/* Level cables: pure symmetry, in the order of Irvine's roots, out of the plane 1, 2, ... half
 * waves; planes and kinds of SEIL2, whose modes 3 and 4 differ by 1e-4. */
static void level_cables(void **state)
{
    static const struct {
        enum part plane;
        enum mode_kind kind;
    } wanted[8] = {{PART_LATERAL, KIND_SYMMETRIC},   {PART_PLANE, KIND_SYMMETRIC},
                   {PART_PLANE, KIND_ANTISYMMETRIC}, {PART_LATERAL, KIND_ANTISYMMETRIC},
                   {PART_LATERAL, KIND_SYMMETRIC},   {PART_PLANE, KIND_SYMMETRIC},
                   {PART_PLANE, KIND_ANTISYMMETRIC}, {PART_LATERAL, KIND_ANTISYMMETRIC}};
    struct model m;
    struct modes p = solve(&seil2, 20, 60, &m);
    (void)state;

    near_rel(p.omega[3], p.omega[2], 2e-4);
    for (int i = 0; i < 60; i++) {
        struct character it = character_of(&m, &p, i);

        if (i < 8)
            assert_true(p.plane[i] == wanted[i].plane && it.kind == wanted[i].kind);
        near_abs(fabs(it.symmetry), 1, 1e-6); /* round-off of vectors with close neighbours */
        below(it.axial, p.plane[i] == PART_LATERAL ? 1e-30 : 1.01);
    }
    modes_free(&p);
    model_free(&m);
}

/* The first axial mode of a taut bar is one; all of its kinetic energy lies along it. */
static void axial_modes(void **state)
{
    const struct cable bar = {100, 10, 1e7, 9.81, 101, 0};
    double c = sqrt((1e7 + 3 * 1e5) / 10); /* near the speed of axial waves */
    struct model m;
    struct modes p = solve(&bar, 20, 40, &m);
    int found = 0;
    (void)state;

    for (int i = 0; i < 40; i++) {
        struct character it = character_of(&m, &p, i);

        if (it.kind != KIND_AXIAL)
            continue;
        found++;
        near_rel(p.omega[i], PI * c / 100 * found, 0.02);
        below(1 - it.axial, 0.1); /* sag couples it a little to transverse modes nearby */
        assert_true(p.plane[i] == PART_PLANE);
    }
    assert_true(found >= 1);
    modes_free(&p);
    model_free(&m);
}

/* An inclined cable and its mirror image: the same kinds and symmetries. */
static void mirrored(void **state)
{
    const struct cable down = {125, 5, 1e8, 9.81, 100, 60}, up = {125, 5, 1e8, 9.81, 100, -60};
    struct model m, n;
    struct modes p = solve(&down, 20, 20, &m), q = solve(&up, 20, 20, &n);
    double purest = 0, least = 1;
    (void)state;

    for (int i = 0; i < 20; i++) {
        struct character a = character_of(&m, &p, i), b = character_of(&n, &q, i);

        near_rel(p.omega[i], q.omega[i], 1e-10);
        assert_int_equal(a.kind, b.kind);
        near_abs(a.symmetry, b.symmetry, 1e-7);
        near_abs(a.axial, b.axial, 1e-7);
        purest = fmax(purest, fabs(a.symmetry));
        least = fmin(least, fabs(a.symmetry));
    }
    print_message("# symmetries of an inclined cable: %.3f to %.5f\n", least, purest);
    below(purest, 1);
    modes_free(&p);
    modes_free(&q);
    model_free(&m);
    model_free(&n);
}

static double product(const struct model *m, const double *V, const double *W)
{
    double mass[16], sum = 0;

    element_mass(m->line.cable.mu, m->h, mass);
    for (int k = 0; k < m->n; k++)
        sum += element_product(mass, V + 6 * (size_t)k, W + 6 * (size_t)k);
    return sum;
}

/*
 * Both supports together: the factor is phi^T M 1, the mass that moves, and over all modes the
 * squares of the factors are the mass of the cable but for the share that the supports carry
 * themselves, M_bb - M_bu M_uu^-1 M_ub, which is some per cent of an element.  One support alone:
 * the quasi-static shape of a taut string is linear, a third of the mass.
 */
static void participation(void **state)
{
    struct model m;
    struct modes p = solve(&seil1, 20, 120, &m);
    double *V = model_vector(&m), *one = model_vector(&m), sum[6] = {0}, both[3] = {0};
    double mass = seil1.mu * seil1.L0, element = mass / 20;
    (void)state;

    for (int i = 0; i < 120; i++) {
        double part[6];

        modes_shape(&m, &p, i, V);
        shape_participation(&m, V, p.omega[i], part);
        for (int c = 0; c < 3; c++) {
            memset(one, 0, sizeof *one * model_unknowns(&m));
            for (int k = 0; k <= m.n; k++)
                one[6 * k + 2 * c] = 1;
            near_abs(part[c] + part[c + 3], product(&m, V, one), 1e-8 * sqrt(mass));
            both[c] += pow(part[c] + part[c + 3], 2);
        }
        for (int c = 0; c < 6; c++)
            sum[c] += part[c] * part[c];
    }
    for (int c = 0; c < 3; c++) {
        assert_true(both[c] < mass && both[c] > mass - 0.25 * element);
        near_abs(sum[c], sum[c + 3], 1e-9 * mass); /* level: left is right mirrored */
    }
    near_abs(sum[2], mass / 3, 0.25 * element);
    near_abs(sum[5], mass / 3, 0.25 * element);
    modes_free(&p);
    model_free(&m);
    free(V);
    free(one);
}

/* First-order change of tension against differences of the physical tension. */
static void change_of_tension(void **state)
{
    const struct cable inclined = {110, 5, 1e7, 9.81, 100, 40};
    struct model m;
    struct modes p = solve(&inclined, 10, 30, &m);
    double *V = model_vector(&m), *W = model_vector(&m);
    (void)state;

    for (int i = 0; i < 30; i++) {
        modes_shape(&m, &p, i, V);
        for (double at = 0; at <= 1; at += 0.125) {
            double v[3], w[3], plus, minus, change, step = 1e-5;

            model_probe_small(&m, at, V, v, &change);
            for (size_t j = 0; j < model_unknowns(&m); j++)
                W[j] = step * V[j];
            model_probe(&m, at, W, w, &plus);
            for (size_t j = 0; j < model_unknowns(&m); j++)
                W[j] = -step * V[j];
            model_probe(&m, at, W, w, &minus);
            /* round-off of the tension over the step */
            near_abs(change, (plus - minus) / (2 * step),
                     1e-5 * fabs(change) + 1e-14 * plus / step);
            for (int c = 0; c < 3; c++)
                near_abs(w[c], -step * v[c], 1e-15);
        }
    }
    modes_free(&p);
    model_free(&m);
    free(V);
    free(W);
}

/*
 * Turned axes.  Wind across turns the plane about the chord; the matrices in space must have the
 * same frequencies, the turned modes must solve them, and the sign rule holds in space.
 */
static void turned(void **state)
{
    const struct cable bare = {104, 5, 1e7, 9.81, 95, 40};
    const struct load wind = {0.5, {3, -4, 40}, 0, 0};
    struct cable c;
    struct axes axes;
    struct model m;
    struct band K, M;
    struct partition k, mass;
    struct modes p;
    (void)state;

    load_apply(&bare, &wind, &c, &axes);
    assert_int_equal(model_new(&c, LAW_HOOKE, 12, &m), SW_OK);
    m.axes = axes;
    assert_int_equal(modes_lowest(&m, 72, SOLVER_DENSE, &p), SW_OK);
    assert_int_equal(model_stiffness(&m, PART_ALL, &K), SW_OK);
    assert_int_equal(model_mass(&m, PART_ALL, &M), SW_OK);
    turn_matrix(&axes, &K);
    turn_matrix(&axes, &M);
    assert_int_equal(model_partition(&m, &K, &k), SW_OK);
    assert_int_equal(model_partition(&m, &M, &mass), SW_OK);
    for (int i = 0; i < 72; i++) {
        double *x = p.phi + 72 * i, y[72] = {0}, z[72] = {0}, back[72], most = 0, positive = 0;

        memcpy(back, x, sizeof back);
        turn_free(&axes, TURN_TO_SPACE, 12, x);
        band_multiply_add(&k.free, 1, x, y);
        band_multiply_add(&mass.free, p.omega[i] * p.omega[i], x, z);
        for (int j = 0; j < 72; j++)
            near_abs(y[j], z[j], 1e-8 * p.omega[71] * p.omega[71]); /* K's own round-off */
        for (int j = 3; j < 69; j += 2)
            if (fabs(x[j]) > most * (1 + 1e-5)) {
                most = fabs(x[j]);
                positive = x[j];
            }
        assert_true(positive > 0);
        turn_free(&axes, TURN_TO_PLANE, 12, x);
        for (int j = 0; j < 72; j++)
            near_abs(x[j], back[j], 1e-14);
    }
    band_free(&K);
    band_free(&M);
    partition_free(&k);
    partition_free(&mass);
    modes_free(&p);
    model_free(&m);
}

TEST_MAIN(cmocka_unit_test(level_cables), cmocka_unit_test(axial_modes), cmocka_unit_test(mirrored),
          cmocka_unit_test(participation), cmocka_unit_test(change_of_tension),
          cmocka_unit_test(turned))
