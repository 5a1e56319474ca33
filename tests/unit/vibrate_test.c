/* Natural frequencies of curved wires: rings, their segments, springs, beams, taut wires. */
#include "rod.h"

#include "num/subspace.h"
#include "phys/vibrate.h"

static double sweep = 2 * PI;

static void circle(double u, double x[3], double A[9])
{
    double a = sweep * u, c = cos(a), s = sin(a);
    const double frame[9] = {c, s, 0, 0, 0, 0, -s, c, 0};

    x[0] = c;
    x[1] = s;
    x[2] = 0;
    memcpy(A, frame, sizeof frame);
    vec3_cross(A + 6, A, A + 3);
}

static void line(double u, double x[3], double A[9])
{
    const double frame[9] = {0, 0, -1, 0, 1, 0, 1, 0, 0};

    x[0] = u;
    x[1] = x[2] = 0;
    memcpy(A, frame, sizeof frame);
}

static void rates(struct rod *p, int k, double *lambda)
{
    double *shape = mem_doubles((size_t)(6 * p->f.n * k));

    assert_non_null(shape);
    assert_int_equal(vibrate(&p->f, &p->s, &p->w, k, lambda, shape), SW_OK);
    free(shape);
}

/*
 * A free thin ring, mass 1 and radius 1: six rigid modes, then pairs
 *     in its plane   n^2 (n^2 - 1)^2/(n^2 + 1) EI            (Hoppe 1871)
 *     out of it      n^2 (n^2 - 1)^2/(n^2 + EI/GJ) EI        (Michell 1890; Love, 293)
 */
static void free_ring(void **state)
{
    double lambda[14], error[2][4];
    const double ratio = 1 / 0.77;

    (void)state;
    for (int m = 0; m < 2; m++) {
        int n = 16 << m;
        struct rod p;

        sweep = 2 * PI;
        rod_new(&p, n, rod_section(1e6, 1, 1, 0.77), circle);
        p.f.n = n;
        p.f.beam[n - 1].b = 0;
        p.f.node[0].held = 0;
        rod_begin(&p);
        frame_evaluate(&p.f, &p.s, FRAME_STILL, &p.w);
        rates(&p, 14, lambda);
        for (int i = 0; i < 6; i++) /* of the first elastic one; rounding of a shift near it */
            near_abs(lambda[i], 0, 1e-7 * lambda[6]);
        for (int k = 2; k < 4; k++) {
            double out = k * k * pow(k * k - 1, 2) / (k * k + ratio);
            double in = k * k * pow(k * k - 1, 2) / (k * k + 1);
            int at = 6 + 4 * (k - 2);

            near_rel(lambda[at], lambda[at + 1], 1e-7); /* pairs */
            near_rel(lambda[at + 2], lambda[at + 3], 1e-7);
            error[m][2 * (k - 2)] = fabs(lambda[at] / out - 1);
            error[m][2 * (k - 2) + 1] = fabs(lambda[at + 2] / in - 1);
        }
        rod_free(&p);
    }
    for (int k = 0; k < 4; k++) {
        print_message("ring: lambda off by %.2g, %.2g with 16, 32 elements\n", error[0][k],
                      error[1][k]);
        below(error[1][k], 2e-4);
    }
}

/* A segment of it whose ends are guided along the radius: n = pi/angle, whole or not. */
static void guided_segment(void **state)
{
    (void)state;
    for (int m = 0; m < 2; m++) {
        struct rod p;
        double lambda, n = PI / (m ? 1.2 : 1.7), wanted;

        sweep = m ? 1.2 : 1.7;
        rod_new(&p, 16, rod_section(1e6, 1, 1, 1), circle);
        for (int i = 0; i <= 16; i++)
            p.f.node[i].held = 4 | 8 | 16;
        for (int end = 0; end < 17; end += 16) { /* a stiff spring along the tangent */
            p.f.node[end].held |= 32;
        }
        p.f.node[0].held |= 2; /* the tangent is y there */
        struct frame_spring guide = {.a = 16, .b = -1};
        memset(guide.B, 0, sizeof guide.B);
        guide.B[0] = -sin(sweep);
        guide.B[1] = cos(sweep);
        guide.B[3] = cos(sweep);
        guide.B[4] = sin(sweep);
        guide.B[8] = 1;
        guide.k[0] = 1e9;
        p.f.spring = &guide;
        p.f.springs = 1;
        rod_begin(&p);
        frame_evaluate(&p.f, &p.s, FRAME_STILL, &p.w);
        rates(&p, 1, &lambda);
        wanted = n * n * pow(n * n - 1, 2) / (n * n + 1);
        near_rel(lambda, wanted, 2e-4); /* stretch: EI/(EA R^2) n^2 */
        rod_free(&p);
    }
}

static double rise = 0.02;
static const double turns = 10;

static void helix(double u, double x[3], double A[9])
{
    double a = 2 * PI * turns * u, c = cos(a), s = sin(a), t[3] = {-s, c, rise};

    vec3_scale(1 / vec3_length(t), t);
    x[0] = c;
    x[1] = s;
    x[2] = rise * a;
    A[0] = c;
    A[1] = s;
    A[2] = 0;
    memcpy(A + 6, t, sizeof t);
    vec3_cross(t, A, A + 3);
}

/* Surge of a close-coiled spring held at both ends: omega = pi sqrt(k/m), k = GJ/(2 pi n R^3): the
 * theory of a rod of springs, without what the ends and the pitch do: 1 % for ten turns. */
static void spring_surge(void **state)
{
    struct rod p;
    double lambda[8], k = 0.77 / (2 * PI * turns), mass = 2 * PI * turns, best = INFINITY;
    int n = 160;

    (void)state;
    rod_new(&p, n, rod_section(1e6, 1, 1, 0.77), helix);
    p.f.node[n].held = 63;
    rod_begin(&p);
    frame_evaluate(&p.f, &p.s, FRAME_STILL, &p.w);
    rates(&p, 8, lambda);
    for (int i = 0; i < 8; i++)
        best = fmin(best, fabs(sqrt(lambda[i]) / (PI * sqrt(k / mass)) - 1));
    print_message("spring surge: off by %.2g\n", best);
    below(best, 0.01);
    rod_free(&p);
}

/* A clamped beam: 22.3733^2; all of its modes against the textbook. */
static void clamped_beam(void **state)
{
    struct rod p;
    double lambda[4];

    (void)state;
    rod_new(&p, 16, rod_section(1e8, 1, 1, 1), line);
    p.f.node[16].held = 63;
    rod_begin(&p);
    frame_evaluate(&p.f, &p.s, FRAME_STILL, &p.w);
    rates(&p, 4, lambda);
    near_rel(lambda[0], 500.5639017, 2e-5);
    near_rel(lambda[1], 500.5639017, 2e-5);
    near_rel(lambda[2], 3803.537080, 1e-4); /* order 4 in a shorter wave */
    rod_free(&p);
}

/* About deformed states: a hinged wire under tension T, omega^2 = pi^2 T + pi^4 EI; almost under
 * its buckling load, -T = pi^2 EI, where it vanishes, and beyond, where it is negative. */
static void strained_wire(void **state)
{
    const double tension[3] = {50, -9.8, -11};

    (void)state;
    for (int k = 0; k < 3; k++) {
        struct rod p;
        double lambda[2];

        rod_new(&p, 16, rod_section(1e7, 1, 1, 1), line);
        p.f.node[0].held = 1 | 2 | 4 | 8;
        p.f.node[16].held = 2 | 4;
        rod_load(&p, 16, 1, (double[6]){tension[k]});
        rod_solve(&p, 1);
        rates(&p, 2, lambda);
        assert_int_equal(p.w.negative > 0, tension[k] < -PI * PI);
        near_abs(lambda[0], pow(PI, 4) + PI * PI * tension[k],
                 2e-5 * (pow(PI, 4) + PI * PI * fabs(tension[k])));
        rod_free(&p);
    }
}

/* A straight wire rolled up to a ring by its end moment: its mass is that of the curve it has now,
 * with the moment of inertia of a ring about a point of it. */
static void mass_where_it_is(void **state)
{
    struct rod p;
    double *M, total = 0, *x;
    int n = 32;

    (void)state;
    rod_new(&p, n, rod_section(1e6, 1, 1, 1), line);
    rod_load(&p, n, 1, (double[6]){0, 0, 0, 0, 0, 2 * PI});
    rod_solve(&p, 5);
    M = mem_doubles(p.w.K.entries);
    x = mem_doubles((size_t)p.w.unknowns);
    assert_int_equal(vibrate_mass(&p.f, &p.s, &p.w, M), SW_OK);
    for (int i = 1; i <= n; i++) { /* spin about the clamp: displacement z x (x - 0), rotation z */
        x[p.w.dof[6 * i]] = -p.s.x[3 * i + 1];
        x[p.w.dof[6 * i + 1]] = p.s.x[3 * i];
        x[p.w.dof[6 * i + 5]] = 1;
    }
    struct sparse view = p.w.K;
    double *y = mem_doubles((size_t)p.w.unknowns);

    view.value = M;
    sparse_multiply_add(&view, 1, x, y);
    for (int i = 0; i < p.w.unknowns; i++)
        total += x[i] * y[i];
    near_rel(total, 2 / (4 * PI * PI),
             1.5e-3); /* 2 m R^2 about a point of the ring, R = 1/(2 pi) */
    free(M);
    free(x);
    free(y);
    rod_free(&p);
}

TEST_MAIN(cmocka_unit_test(free_ring), cmocka_unit_test(guided_segment),
          cmocka_unit_test(spring_surge), cmocka_unit_test(clamped_beam),
          cmocka_unit_test(strained_wire), cmocka_unit_test(mass_where_it_is))
