/* Frames that have no answer, and what is told of them; answers that rest on one load, one hinge,
 * one short step. */
#include "rod.h"

#include "phys/updated.h"
#include "phys/vibrate.h"

#include <float.h>

#define N 4

static double tilt[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}; /* of the axis */

static void line(double u, double x[3], double A[9])
{
    static const double along_x[9] = {0, 1, 0, 0, 0, 1, 1, 0, 0};
    const double at[3] = {u, 0, 0};

    mat3_apply(tilt, at, x);
    for (int i = 0; i < 3; i++)
        mat3_apply(tilt, along_x + 3 * i, A + 3 * i);
}

/* A quarter of a circle of radius 1. */
static void arch(double u, double x[3], double A[9])
{
    double a = PI / 2 * u, c = cos(a), s = sin(a);
    const double frame[9] = {s, -c, 0, 0, 0, 0, c, s, 0}, at[3] = {s, 1 - c, 0};

    mat3_apply(tilt, at, x);
    mat3_apply(tilt, frame, A);
    mat3_apply(tilt, frame + 6, A + 6);
    vec3_cross(A + 6, A, A + 3);
}

/* Rod with nothing that holds it: whichever theory names a node and gives no answer. */
static void adrift(void **state)
{
    (void)state;
    for (int k = 0; k < 12; k++) {
        struct follow_options o = rod_options(1);
        double c = cos(k), s = sin(k);
        struct rod p;
        int failed = -2;
        enum status status;

        tilt[0] = tilt[4] = c;
        tilt[1] = -s;
        tilt[3] = s;
        rod_new(&p, N, rod_section(k % 2 ? 1e9 : 100, 1, 1.3, 0.7), k % 3 ? line : arch);
        p.f.node[0].held = k < 6 ? 0 : 7; /* free, or on a ball joint */
        rod_load(&p, N, 1, (double[6]){0.1, 0.2, 0.3, 0, 0, 0});
        rod_begin(&p);
        if (k % 4 == 0)
            status = follow_linear(&p.f, &p.s, &p.w, &failed);
        else if (k % 4 == 1 && k < 6)
            status = updated(&p.f, &o, &p.s, &p.w, &p.path);
        else
            status = follow(&p.f, &o, &p.s, &p.w, &p.path);
        if (k % 4 != 0)
            failed = p.path.failed_node;
        assert_int_equal(status, SW_INDEFINITE);
        assert_in_range(failed, 0, N);
        if (k % 4 != 0)
            near_abs(p.s.t, 0, 0);
        rod_free(&p);
    }
    tilt[0] = tilt[4] = 1;
    tilt[1] = tilt[3] = 0;
}

/* However rounding falls in the pivots: linear theory does not solve what hangs on a ball joint. */
static void adrift_anyhow(void **state)
{
    (void)state;
    for (int k = 0; k < 60; k++) {
        double c = cos(0.1 * k), s = sin(0.1 * k);
        struct follow_options o = rod_options(1);
        struct rod p;
        int failed = -2;

        tilt[4] = tilt[8] = c;
        tilt[5] = -s;
        tilt[7] = s;
        rod_new(&p, 3 * N, rod_section(1e9, 1, 1.3, 0.7), arch);
        p.f.node[0].held = 7;
        rod_load(&p, 3 * N, 1, (double[6]){0.1, 0.2, 0.3, 0, 0, 0});
        rod_begin(&p);
        assert_int_equal(follow_linear(&p.f, &p.s, &p.w, &failed), SW_INDEFINITE);
        assert_in_range(failed, 0, 3 * N);
        frame_work_free(&p.w);
        frame_state_free(&p.s);
        assert_int_equal(rod_follow(&p, &o), SW_INDEFINITE); /* nor does a path begin */
        assert_in_range(p.path.failed_node, 0, 3 * N);
        rod_free(&p);
    }
    tilt[4] = tilt[8] = 1;
    tilt[5] = tilt[7] = 0;
}

/* A node that no element reaches is the one that is named. */
static void loose_node(void **state)
{
    (void)state;
    for (int way = 0; way < 2; way++) {
        struct follow_options o = rod_options(1);
        struct rod p;
        int failed = -2;

        rod_new(&p, N, rod_section(100, 1, 1, 1), line);
        p.f.beams = N - 1; /* the last one is left out */
        rod_load(&p, N - 1, 1, (double[6]){0, 0.1, 0, 0, 0, 0});
        rod_begin(&p);
        if (way == 0) {
            assert_int_equal(follow_linear(&p.f, &p.s, &p.w, &failed), SW_INDEFINITE);
        } else {
            assert_int_equal(follow(&p.f, &o, &p.s, &p.w, &p.path), SW_INDEFINITE);
            failed = p.path.failed_node;
        }
        assert_int_equal(failed, N);
        assert_int_equal(frame_node_of(&p.f, &p.w, p.w.unknowns), -1);
        rod_free(&p);
    }
}

/* What the document's iteration does not take is named. */
static void not_the_documents(void **state)
{
    struct frame_spring spring = {.a = N, .b = -1};
    struct rod p;

    (void)state;
    rod_new(&p, N, rod_section(100, 1, 1, 1), line);
    p.f.spring = &spring;
    assert_null(updated_refused(&p.f));
    p.f.springs = 1;
    assert_string_equal(updated_refused(&p.f), "springs");
    p.f.springs = 0;
    p.f.stages = 2;
    assert_string_equal(updated_refused(&p.f), "stages");
    p.f.stages = 1;
    for (int end = 0; end < 2; end++) {
        p.f.beam[1].hinge[end].n = 1;
        assert_string_equal(updated_refused(&p.f), "hinges");
        p.f.beam[1].hinge[end].n = 0;
    }
    p.f.node[N].given[5] = 1e-9;
    assert_string_equal(updated_refused(&p.f), "prescribed displacements");
    p.f.node[N].given[5] = 0;
    assert_null(updated_refused(&p.f));
    free(p.f.node);
    free(p.f.beam);
    free(p.f.load);
}

/* The document's iteration: too few of them, a load that bends an element out of shape; the path
 * that is watched ends where the state does. */
static void documents_iteration(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        struct follow_options o = rod_options(4);
        struct rod p;
        enum status s;

        o.tolerance = 1e-9;
        o.iterations = k == 0 ? 1 : 200;
        o.watch = N;
        rod_new(&p, N, rod_section(100, 1, 1, 1), line);
        rod_load(&p, N, 1, (double[6]){0, k == 1 ? 1e3 : 0.1, 0, 0, 0, 0});
        rod_begin(&p);
        s = updated(&p.f, &o, &p.s, &p.w, &p.path);
        assert_int_equal(s, k < 2 ? SW_NOCONV : SW_OK);
        if (k < 2)
            assert_true(p.s.t < 1);
        else
            for (int c = 0; c < 6; c++)
                near_abs(p.path.step[p.path.n - 1].watch[c], rod_moved(&p, N, c), 0);
        rod_free(&p);
    }
}

/* An element whose ends look away from each other has no mass, and a frame with it no modes. */
static void shapeless(void **state)
{
    struct rod p;
    double lambda[1], shape[6 * (N + 1)];

    (void)state;
    rod_new(&p, N, rod_section(100, 1, 1, 1), line);
    rod_begin(&p);
    frame_evaluate(&p.f, &p.s, FRAME_STILL, &p.w);
    assert_int_equal(vibrate(&p.f, &p.s, &p.w, 1, lambda, shape), SW_OK);
    p.s.x[3 * N] = p.s.x[3 * (N - 1)] - 0.1; /* the tip behind the node before it */
    lambda[0] = shape[0] = 77;
    assert_int_equal(vibrate(&p.f, &p.s, &p.w, 1, lambda, shape), SW_INDEFINITE);
    assert_true(lambda[0] == 77 && shape[0] == 77);
    rod_free(&p);
}

/* Lumped loads of beams are halves at their nodes. */
static void lumped(void **state)
{
    double tip[2][6];

    (void)state;
    for (int k = 0; k < 2; k++) {
        struct rod p;

        rod_new(&p, N, rod_section(100, 1, 1, 1), arch);
        p.f.lumped = k == 0;
        for (int i = 0; i < N; i++) {
            double part = p.f.beam[i].beam.length / 2;
            const double value[6] = {0.1, 0.2, -0.3};

            if (k == 0) {
                rod_load(&p, -1, 1, value);
                p.f.load[p.f.loads - 1].beam = i;
                continue;
            }
            for (int end = 0; end < 2; end++)
                rod_load(&p, i + end, 1,
                         (double[6]){part * value[0], part * value[1], part * value[2], 0, 0, 0});
        }
        rod_solve(&p, 2);
        for (int c = 0; c < 6; c++)
            tip[k][c] = rod_moved(&p, N, c);
        rod_free(&p);
    }
    for (int c = 0; c < 6; c++)
        near_abs(tip[0][c], tip[1][c], 1e-9);
}

/* Between two clamps, hinged to one: the hinge is all that moves, and that its moment vanishes is
 * the only equation. */
static void one_hinge(void **state)
{
    struct rod p;

    (void)state;
    rod_new(&p, 1, rod_section(100, 1, 1, 1), line);
    p.f.node[1].held = 63;
    p.f.beam[0].hinge[1].n = 1;
    p.f.beam[0].hinge[1].axis[0][2] = 1;
    rod_load(&p, -1, 1, (double[6]){0, 0.01, 0, 0, 0, 0});
    p.f.load[0].beam = 0;
    rod_solve(&p, 1);
    assert_int_equal(p.w.unknowns, 1);
    near_abs(p.w.end[11], 0, 1e-12);
    near_rel(p.w.end[1], -0.01 * 5 / 8, 1e-6); /* a propped beam */
    near_rel(p.w.end[7], -0.01 * 3 / 8, 1e-6);
    near_rel(p.w.end[5], -0.01 / 8, 1e-6);
    rod_free(&p);
}

/* A first step by arc length that is far too long is halved until it holds: the same end. */
static void long_first_step(void **state)
{
    double tip[2][6];

    (void)state;
    for (int k = 0; k < 2; k++) {
        struct rod p;
        struct follow_options o = rod_options(k ? 50 : 1);

        rod_new(&p, 8, rod_section(1e4, 1, 1, 1), arch);
        rod_load(&p, 8, 1, (double[6]){0, 6, 0, 0, 0, 0});
        o.arc = 1;
        assert_int_equal(rod_follow(&p, &o), SW_OK);
        for (int c = 0; c < 6; c++)
            tip[k][c] = rod_moved(&p, 8, c);
        rod_free(&p);
    }
    for (int c = 0; c < 6; c++)
        near_abs(tip[0][c], tip[1][c], 1e-8);
}

/* Without room for iterations a path by arc length ends where it began. */
static void no_iterations(void **state)
{
    struct rod p;
    struct follow_options o = rod_options(4);

    (void)state;
    rod_new(&p, 8, rod_section(1e4, 1, 1, 1), arch);
    rod_load(&p, 8, 1, (double[6]){0, 6, 0, 0, 0, 0});
    o.arc = 1;
    o.iterations = 0;
    assert_int_equal(rod_follow(&p, &o), SW_NOCONV);
    assert_int_equal(p.path.n, 1);
    near_abs(p.s.t, 0, 0);
    near_abs(rod_moved(&p, 8, 1), 0, 0);
    rod_free(&p);
}

/* Scales of what is compared: of the structure wherever it stands, and of its stiffest spring. */
static void scales(void **state)
{
    struct frame_spring spring = {.a = N, .b = -1, .k = {3e9, 1e20, 2e9, 1, 1, 1}};
    struct rod p;

    (void)state;
    rod_new(&p, N, rod_section(100, 1, 1, 1), line);
    for (int i = 0; i <= N; i++)
        for (int c = 0; c < 3; c++)
            p.f.node[i].x[c] += 5 - 7 * c;
    p.f.spring = &spring;
    p.f.springs = 1;
    rod_begin(&p);
    near_rel(p.w.size, 1, 1e-14);
    near_rel(p.w.chord, 1.0 / N, 1e-14);
    near_rel(p.w.floor_force, 4 * DBL_EPSILON * 1e20 / N, 1e-12);
    near_rel(p.w.floor_moment, 4 * DBL_EPSILON * 1e20 / N / N, 1e-12);
    rod_free(&p);
}

TEST_MAIN(cmocka_unit_test(scales), cmocka_unit_test(adrift), cmocka_unit_test(adrift_anyhow),
          cmocka_unit_test(loose_node), cmocka_unit_test(not_the_documents),
          cmocka_unit_test(documents_iteration), cmocka_unit_test(shapeless),
          cmocka_unit_test(lumped), cmocka_unit_test(one_hinge), cmocka_unit_test(long_first_step),
          cmocka_unit_test(no_iterations))
