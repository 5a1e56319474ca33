/* Cable element: energy, tangent, parts of the force, rigid motion, material, shape functions. */
#include "check.h"
#include "phys/element.h"

static uint64_t seed = 99;

/* Element 2 of 5 of a sagging inclined cable. */
static struct element sample(enum law law, struct material m[GAUSS])
{
    const struct cable c = {115, 2, 1e5, 9.81, 100, 20};
    struct line s;
    struct element e = {.h = c.L0 / 5, .m = m};
    double f[4];

    assert_int_equal(line_solve(&c, &s), SW_OK);
    for (int q = 0; q < GAUSS; q++) {
        hermite(e.h, gauss_at[q], f, e.slope[q]);
        material_at(&s, law, e.h * (2 + gauss_at[q]), &m[q]);
    }
    return e;
}

static void random_unknowns(double v[12])
{
    for (int i = 0; i < 12; i++)
        v[i] = uniform_in(&seed, -1, 1) * (i % 2 ? 0.05 : 1);
}

/* Stored energy of theory c2 by terms: K, + cubic, + quartic. */
static double energy(const struct element *e, int terms, const double v[12])
{
    double U = 0;

    for (int q = 0; q < GAUSS; q++) {
        const struct material *m = &e->m[q];
        double w[3] = {0, 0, 0}, along, square;

        for (int i = 0; i < 12; i++)
            w[i % 6 / 2] += e->slope[q][i / 6 * 2 + i % 2] * v[i];
        along = m->x1 * w[0] + m->x2 * w[1];
        square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
        U += gauss_weight[q] * e->h *
             (m->EA / 2 *
                  (along * along + (terms >= 2) * along * square +
                   (terms >= 3) * square * square / 4) +
              m->T / 2 * square);
    }
    return U;
}

/* Four-point differences: truncation of order step^4 is zero for a quartic but for round-off. */
static void force_is_gradient_of_energy(void **state)
{
    static const int terms[] = {0, 2, 3};
    struct material m[GAUSS];
    struct element e = sample(LAW_HOOKE, m);
    (void)state;

    for (int t = 0; t < 3; t++) {
        double v[12], F[12] = {0};

        random_unknowns(v);
        element_force(&e, terms[t], v, F, NULL);
        for (int i = 0; i < 12; i++) {
            double keep = v[i], step = i % 2 ? 0.005 : 0.1, U[4];
            static const int at[4] = {-2, -1, 1, 2};

            for (int k = 0; k < 4; k++) {
                v[i] = keep + at[k] * step;
                U[k] = energy(&e, terms[t], v);
            }
            v[i] = keep;
            near_abs((U[0] - 8 * U[1] + 8 * U[2] - U[3]) / (12 * step), F[i],
                     1e-9 * fabs(F[i]) + 1e-5);
        }
    }
}

static void tangent_is_derivative_of_force(void **state)
{
    static const int terms[] = {0, 2, 3};
    struct material m[GAUSS];
    struct element e = sample(LAW_THESIS, m);
    (void)state;

    for (int t = 0; t < 3; t++) {
        double v[12], K[144];

        random_unknowns(v);
        element_tangent(&e, terms[t], 0, v, K);
        for (int j = 0; j < 12; j++) {
            double side[2][12] = {{0}}, keep = v[j], step = 1e-5;

            for (int k = 0; k < 2; k++) {
                v[j] = keep + (k ? step : -step);
                element_force(&e, terms[t], v, side[k], NULL);
            }
            v[j] = keep;
            for (int i = 0; i < 12; i++) {
                near_abs((side[1][i] - side[0][i]) / (2 * step), K[i + 12 * j], 1e-7 * 1e6);
                near_abs(K[i + 12 * j], K[j + 12 * i], 1e-9);
            }
        }
    }
}

/* (A.502): terms add the parts of order 2, 2 and 3 one after another; K V + F1 + F2 + F3 is all. */
static void parts_have_their_order(void **state)
{
    struct material m[GAUSS];
    struct element e = sample(LAW_PRINTED, m);
    double v[12], twice[12], F[2][4][12] = {{{0}}};
    static const int order[] = {1, 2, 2, 3};
    (void)state;

    random_unknowns(v);
    for (int i = 0; i < 12; i++)
        twice[i] = 2 * v[i];
    for (int t = 0; t < 4; t++) {
        element_force(&e, t, v, F[0][t], NULL);
        element_force(&e, t, twice, F[1][t], NULL);
    }
    for (int t = 3; t >= 0; t--)
        for (int i = 0; i < 12; i++) {
            double once = F[0][t][i] - (t > 0 ? F[0][t - 1][i] : 0);
            double doubled = F[1][t][i] - (t > 0 ? F[1][t - 1][i] : 0);

            near_abs(doubled, once * pow(2, order[t]), 1e-8);
        }
}

static void rigid_translation_is_free(void **state)
{
    struct material m[GAUSS];
    struct element e = sample(LAW_HOOKE, m);
    double v[12] = {3, 0, -2, 0, 1, 0, 3, 0, -2, 0, 1, 0}, F[12] = {0};
    (void)state;

    element_force(&e, 3, v, F, NULL);
    for (int i = 0; i < 12; i++)
        near_abs(F[i], 0, 1e-9);
}

/* A finite rotation about x3 strains nothing: gamma = 0, so that only T turns with the cable.  The
 * force must be that of the static end tensions, turned, minus the unturned ones. */
static void rigid_rotation_keeps_tension(void **state)
{
    struct material m[GAUSS];
    struct element e = sample(LAW_THESIS, m);
    struct strain_watch watch = {.least_force = INFINITY, .most_stiffened = -INFINITY};
    struct material straight[GAUSS];
    double angle = 0.7, v[12] = {0}, F[12] = {0}, T;
    (void)state;

    for (int q = 0; q < GAUSS; q++)
        straight[q] = m[2]; /* a straight element, which the shape functions rotate exactly */
    e.m = straight;
    T = m[2].T;
    v[1] = v[7] = cos(angle) * m[2].x1 - sin(angle) * m[2].x2 - m[2].x1;
    v[3] = v[9] = sin(angle) * m[2].x1 + cos(angle) * m[2].x2 - m[2].x2;
    v[6] = v[1] * e.h;
    v[8] = v[3] * e.h;
    element_force(&e, 3, v, F, &watch);
    near_abs(watch.least_force, T, 1e-9 * T);
    near_abs(watch.most_stiffened, 0, 1e-12);
    near_abs(F[6], T * v[1], 1e-9 * T);
    near_abs(F[8], T * v[3], 1e-9 * T);
    near_abs(F[0], -T * v[1], 1e-9 * T);
}

/* Physical tension: static at rest, for hooke EA (a_m - 1) to second order in the change. */
static void material_and_tension(void **state)
{
    struct line s;
    struct line_point p;
    (void)state;

    assert_int_equal(line_solve(&seil2, &s), SW_OK);
    line_at(&s, 30, &p);
    for (int law = LAW_HOOKE; law <= LAW_PRINTED; law++) {
        struct material m;

        material_at(&s, (enum law)law, 30, &m);
        near_rel(material_tension(&m, 0), p.tension, 1e-14);
        near_rel(m.stretch, 1 + p.tension / s.cable.EA, 1e-15);
        if (law != LAW_PRINTED) { /* T x,1 is the static tension vector; |x,1| = a */
            near_rel(m.T * m.x1, s.H, 1e-13);
            near_abs(m.T * m.x2, p.V, 1e-13 * s.H);
            near_rel(hypot(m.x1, m.x2), m.stretch, 1e-14);
        }
        if (law == LAW_HOOKE)
            for (double stretch = m.stretch - 1e-4; stretch < m.stretch + 2e-4; stretch += 1e-4)
                near_rel(material_tension(&m, (stretch * stretch - m.stretch * m.stretch) / 2),
                         s.cable.EA * (stretch - 1), 1e-4);
    }
}

static void hermite_functions(void **state)
{
    double f[4], f1[4], h = 2.5;
    (void)state;

    for (double xi = 0; xi <= 1; xi += 0.125) { /* reproduce the cubic t^3 - 2 t + 1 */
        double t = h * xi, u[4] = {1, -2, h * h * h - 2 * h + 1, 3 * h * h - 2}, p = 0, p1 = 0;

        hermite(h, xi, f, f1);
        for (int i = 0; i < 4; i++) {
            p += f[i] * u[i];
            p1 += f1[i] * u[i];
        }
        near_abs(p, t * t * t - 2 * t + 1, 1e-13);
        near_abs(p1, 3 * t * t - 2, 1e-13);
    }
}

/* The closed mass matrix (degree 6) and the weights against the 5-point rule (degree 9). */
static void mass_matrix(void **state)
{
    double M[16], sum[16] = {0}, mu = 3, h = 2, f[4], f1[4];
    (void)state;

    element_mass(mu, h, M);
    for (int q = 0; q < GAUSS; q++) {
        hermite(h, gauss_at[q], f, f1);
        for (int i = 0; i < 16; i++)
            sum[i] += gauss_weight[q] * mu * h * f[i % 4] * f[i / 4];
    }
    for (int i = 0; i < 16; i++)
        near_abs(M[i], sum[i], 1e-14 * mu * h);
}

/* Straight element: N'N' closed form of theory c2 for the lateral direction. */
static void stiffness_of_a_straight_element(void **state)
{
    const struct cable c = {100, 1, 1e6, 0, 101, 0};
    struct line s;
    struct material m[GAUSS];
    struct element e = {.h = 20, .m = m};
    double K[144], f[4], h = 20, T, rest[12] = {0};
    const double lateral[16] = {36,  3 * h,  -36, 3 * h,  3 * h, 4 * h * h, -3 * h, -h * h,
                                -36, -3 * h, 36,  -3 * h, 3 * h, -h * h,    -3 * h, 4 * h * h};
    (void)state;

    assert_int_equal(line_solve(&c, &s), SW_OK);
    T = s.H / 1.01; /* T-star/a */
    for (int q = 0; q < GAUSS; q++) {
        hermite(h, gauss_at[q], f, e.slope[q]);
        material_at(&s, LAW_HOOKE, 50, &m[q]);
    }
    element_tangent(&e, 0, 0, rest, K);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            int I = i / 2 * 6 + i % 2, J = j / 2 * 6 + j % 2;
            double N = lateral[i + 4 * j] / (30 * h);

            near_abs(K[I + 4 + 12 * (J + 4)], T * N, 1e-9 * T);          /* v3 */
            near_abs(K[I + 2 + 12 * (J + 2)], T * N, 1e-9 * T);          /* v2 of a level cable */
            near_abs(K[I + 12 * J], (c.EA / 1.01 + T) * N, 1e-9 * c.EA); /* EA/a^3 a^2 + T */
            near_abs(K[I + 12 * (J + 4)], 0, 1e-9);
        }
}

TEST_MAIN(cmocka_unit_test(force_is_gradient_of_energy),
          cmocka_unit_test(tangent_is_derivative_of_force),
          cmocka_unit_test(parts_have_their_order), cmocka_unit_test(rigid_translation_is_free),
          cmocka_unit_test(rigid_rotation_keeps_tension), cmocka_unit_test(material_and_tension),
          cmocka_unit_test(hermite_functions), cmocka_unit_test(mass_matrix),
          cmocka_unit_test(stiffness_of_a_straight_element))
