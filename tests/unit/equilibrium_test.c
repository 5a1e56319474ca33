/* Nonlinear equilibrium for moved supports against the exact line between them. */
#include "check.h"
#include "num/mem.h"
#include "phys/model.h"

enum { N = 60 };

/* Place of the moved cable at theta from the exact line, which hangs in the vertical plane through
 * the moved supports. */
static void exact_place(const struct cable *c, const double b[6], double theta, double x[3],
                        double *tension)
{
    struct cable moved = *c;
    double along = c->span + b[3] - b[0], across = b[5] - b[2];
    struct line s;
    struct line_point p;

    moved.span = hypot(along, across);
    moved.drop += b[4] - b[1];
    assert_int_equal(line_solve(&moved, &s), SW_OK);
    line_at(&s, theta, &p);
    x[0] = b[0] + p.x1 * along / moved.span;
    x[1] = b[1] + p.x2;
    x[2] = b[2] + p.x1 * across / moved.span;
    *tension = p.tension;
}

/* Law hooke is a cubic about the static line: the force is off by 1.5 EA gamma^2, 1.1e-4 (PONT) or
 * 2e-4 of T (SEIL2), which moves the points by as much of the sag. */
static void check(const struct cable *c, const double b[6], double tolerance)
{
    struct model m;
    static double V[6 * (N + 1)], F[6 * (N + 1)];

    assert_int_equal(model_new(c, LAW_HOOKE, N, &m), SW_OK);
    assert_int_equal(model_equilibrium(&m, 3, b, V), SW_OK);
    for (int k = 1; k < 8; k++) {
        double v[3], x[3], tension, exact;
        struct line_point p;

        line_at(&m.line, c->L0 * k / 8, &p);
        model_probe(&m, k / 8.0, V, v, &tension);
        exact_place(c, b, c->L0 * k / 8, x, &exact);
        near_abs(p.x1 + v[0], x[0], tolerance);
        near_abs(p.x2 + v[1], x[1], tolerance);
        near_abs(v[2], x[2], tolerance);
        near_rel(tension, exact, 10 * tolerance);
    }
    for (int i = 0; i < 6; i++)
        near_abs(V[i % 3 * 2 + (i < 3 ? 0 : 6 * N)], b[i], 0);
    model_force(&m, 3, V, F, NULL);
    for (int i = 0; i < 6 * (N + 1); i++)
        if (i % 2 == 1 || (i >= 6 && i < 6 * N))
            near_abs(F[i], 0, 1e-9 * hypot(m.line.H, m.line.V));
    model_free(&m);
}

static void taut_cable(void **state)
{
    const double along[6] = {0, 0, 0, 0.05, 0, 0}, any[6] = {0.01, -0.2, 0.3, -0.03, 0.1, -0.5};
    (void)state;

    check(&pont, along, 2e-5);
    check(&seil2, any, 1e-4);
}

static void slack_cable(void **state)
{
    const struct cable c = {150, 2, 1e7, 9.81, 100, 20};
    const double far[6] = {0, 1, -2, 5, -3, 4};
    (void)state;

    check(&c, far, 2e-4);
}

/* A nearly vertical cable with a tight loop below, coarser than its bend: the tangent is indefinite
 * on the way.  Converges for each mesh, and with the mesh to the line of the moved supports. */
static void tight_loop(void **state)
{
    const struct cable c = {20.1, 2, 1e6, 9.81, 1, -19};
    const double b[6] = {0, 0, 0, 1e-3, 0, 0};
    const int n[] = {10, 40, 80, 160, 640};
    (void)state;

    for (int i = 0; i < 5; i++) {
        double *V = mem_doubles(6 * ((size_t)n[i] + 1)), v[3], x[3], tension, exact;
        struct model m;
        struct line_point p;

        assert_int_equal(model_new(&c, LAW_HOOKE, n[i], &m), SW_OK);
        assert_int_equal(model_equilibrium(&m, 3, b, V), SW_OK);
        line_at(&m.line, 2.5, &p);
        model_probe(&m, 2.5 / 20.1, V, v, &tension);
        exact_place(&c, b, 2.5, x, &exact);
        near_abs(p.x1 + v[0], x[0], n[i] < 160 ? 1e-3 : 1e-5);
        near_abs(p.x2 + v[1], x[1], n[i] < 160 ? 1e-3 : 1e-5);
        model_free(&m);
        free(V);
    }
}

/* terms = 0: the linear answer, doubled by doubled motion; terms 1 converges, too. */
static void fewer_terms(void **state)
{
    const double b[6] = {0, 0, 0, 0.02, 0.01, 0.03};
    double twice[6], *V[4];
    struct model m;
    (void)state;

    assert_int_equal(model_new(&seil1, LAW_THESIS, N, &m), SW_OK);
    for (int i = 0; i < 6; i++)
        twice[i] = 2 * b[i];
    for (int t = 0; t < 4; t++) {
        V[t] = mem_doubles(6 * (N + 1));
        assert_int_equal(model_equilibrium(&m, t, b, V[t]), SW_OK);
    }
    near_rel(V[1][6 * 30 + 2], V[3][6 * 30 + 2], 0.05);
    near_rel(V[2][6 * 30 + 2], V[3][6 * 30 + 2], 0.05);
    assert_true(V[1][6 * 30 + 2] != V[2][6 * 30 + 2] && V[2][6 * 30 + 2] != V[3][6 * 30 + 2]);
    assert_int_equal(model_equilibrium(&m, 0, twice, V[1]), SW_OK);
    for (int i = 0; i < 6 * (N + 1); i++)
        near_abs(V[1][i], 2 * V[0][i], 1e-10);
    for (int t = 0; t < 4; t++)
        free(V[t]);
    model_free(&m);
}

static void impossible_motion(void **state)
{
    const double torn[6] = {0, 0, 0, -120, 0, 0};
    struct cable weightless = {100, 1, 1e6, 0, 101, 0};
    const double loose[6] = {0, 0, 0, -2, 0, 0};
    double V[6 * (N + 1)];
    struct model m;
    (void)state;

    assert_int_equal(model_new(&weightless, LAW_HOOKE, N, &m), SW_OK);
    assert_int_equal(model_equilibrium(&m, 3, loose, V), SW_ADMISSIBLE);
    model_free(&m);
    assert_int_equal(model_new(&seil1, LAW_HOOKE, N, &m), SW_OK);
    assert_int_not_equal(model_equilibrium(&m, 3, torn, V), SW_OK); /* ends have passed */
    model_free(&m);
}

/* A small motion of a short cable, in metres and in millimetres: the same to round-off, which some
 * sums of forces of EA bring into displacements. */
static void units(void **state)
{
    const struct cable c = {.L0 = 4.7153301555289,
                            .mu = 0.101284759053,
                            .EA = 3045222.26644542,
                            .span = 4.45131707820821,
                            .drop = 1.58825415511031,
                            .g = 5.58010145369};
    struct cable thin = c;
    const double b[6] = {0, 0, 0, 0.000472618, 0.000945236, 0.000236309};
    double b_thin[6], V[6 * 9], V_thin[6 * 9];
    struct model m;
    (void)state;

    thin.L0 *= 1000;
    thin.mu /= 1000;
    thin.EA *= 1000;
    thin.span *= 1000;
    thin.drop *= 1000;
    thin.g *= 1000;
    for (int i = 0; i < 6; i++)
        b_thin[i] = 1000 * b[i];
    assert_int_equal(model_new(&c, LAW_HOOKE, 8, &m), SW_OK);
    assert_int_equal(model_equilibrium(&m, 3, b, V), SW_OK);
    model_free(&m);
    assert_int_equal(model_new(&thin, LAW_HOOKE, 8, &m), SW_OK);
    assert_int_equal(model_equilibrium(&m, 3, b_thin, V_thin), SW_OK);
    model_free(&m);
    for (int i = 0; i < 6 * 9; i += 2)
        near_abs(V_thin[i], 1000 * V[i], 1e-9 * 1000 * b[4]);
}

/* Linear theory needs no line between the supports: a string pushed together by more than its
 * stretch, evenly. */
static void linear_beyond_slackness(void **state)
{
    const struct cable string = {99.9, 10, 1e9, 0, 100, 0};
    const double b[6] = {0, 0, 0, -1, 0.5, -0.25};
    static double V[6 * (N + 1)];
    struct model m;
    (void)state;

    assert_int_equal(model_new(&string, LAW_HOOKE, N, &m), SW_OK);
    assert_int_equal(model_equilibrium(&m, 0, b, V), SW_OK);
    for (int i = 0; i <= N; i++)
        for (int c = 0; c < 3; c++)
            near_abs(V[6 * i + 2 * c], b[3 + c] * i / N, 1e-9);
    model_free(&m);
}

TEST_MAIN(cmocka_unit_test(taut_cable), cmocka_unit_test(slack_cable), cmocka_unit_test(tight_loop),
          cmocka_unit_test(fewer_terms), cmocka_unit_test(impossible_motion),
          cmocka_unit_test(linear_beyond_slackness), cmocka_unit_test(units))
