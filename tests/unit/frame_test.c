/* Frames in linear theory: closed forms, order of convergence, hinges, springs, prescribed moves.
 */
#include "rod.h"

#include "phys/divide.h"

/* Quarter circle of radius 1 in the x-y plane from (1, 0) along y; section axes radial and z. */
static double sweep = PI / 2; /* angle of the arc */

static void circle(double u, double x[3], double A[9])
{
    double a = sweep * u, c = cos(a), s = sin(a);
    const double frame[9] = {c, s, 0, 0, 0, -1, -s, c, 0};

    x[0] = c;
    x[1] = s;
    x[2] = 0;
    mat3_multiply((const double[]){1, 0, 0, 0, 1, 0, 0, 0, 1}, frame, A);
    vec3_cross(A + 6, A, A + 3);
}

static const struct section *thin(void)
{
    static struct section s;

    s = rod_section(1e9, 1, 1, 0.77); /* no stretch to speak of: 1e-9 of bending */
    return &s;
}

/* Clamped quarter circle with a tip force: along the radius of the clamp (in its plane), or z. */
static double quarter(int n, int direction)
{
    struct rod p;
    double load[6] = {0}, moved;

    sweep = PI / 2;
    rod_new(&p, n, *thin(), circle);
    load[direction] = 1;
    rod_load(&p, n, 1, load);
    rod_linear(&p);
    moved = rod_moved(&p, n, direction);
    rod_free(&p);
    return moved;
}

/* The same by chords: straight elements between the same nodes. */
static double quarter_of_chords(int n, int direction)
{
    struct rod p;
    double load[6] = {0}, moved;

    sweep = PI / 2;
    rod_new(&p, n, *thin(), circle);
    for (int i = 0; i < n; i++) {
        struct frame_beam *b = &p.f.beam[i];
        const double *x1 = p.f.node[i].x, *x2 = p.f.node[i + 1].x;
        double e[3] = {x2[0] - x1[0], x2[1] - x1[1], x2[2] - x1[2]};
        struct bow bow;

        vec3_scale(1 / vec3_length(e), e);
        bow_axes(e, b->A[0]);
        memcpy(b->A[1], b->A[0], sizeof b->A[0]);
        bow_between(x1, x2, b->A[0], b->A[1], 0, 0, &bow);
        assert_int_equal(beam_new(&bow, b->section, &b->beam), SW_OK);
    }
    load[direction] = 1;
    rod_load(&p, n, 1, load);
    rod_linear(&p);
    moved = rod_moved(&p, n, direction);
    rod_free(&p);
    return moved;
}

/*
 * By Castigliano with M = R sin a, T = R (1 - cos a), a the angle from the tip:
 * out of plane pi R^3/4 (1/EI) + (3 pi/4 - 2) R^3/GJ; in the plane along the tip's tangent
 * (3 pi/4 - 2) R^3/EI, along its radius pi R^3/(4 EI).
 */
static void quarter_ring(void **state)
{
    const double wanted[3] = {3 * PI / 4 - 2, PI / 4, PI / 4 + (3 * PI / 4 - 2) / 0.77};

    (void)state;
    for (int c = 0; c < 3; c++) {
        double error[5], chords = INFINITY;
        int n = 1, straight = 1;

        for (int k = 0; k < 5; k++, n *= 2)
            error[k] = fabs(quarter(n, c) / wanted[c] - 1);
        for (; straight < 4096 && !(chords < error[1]); straight *= 2)
            chords = fabs(quarter_of_chords(straight, c) / wanted[c] - 1);
        print_message("quarter ring, direction %d: errors %.2g %.2g %.2g %.2g %.2g; %d chords do "
                      "as well as two elements\n",
                      c, error[0], error[1], error[2], error[3], error[4], straight / 2);
        below(error[1], 0.01); /* the bound for two elements */
        for (int k = 3; k < 5; k++)
            near_abs(log2(error[k - 1] / error[k]), 4, 0.3);
        assert_true(straight / 2 >= 16); /* chords are of order 2 */
    }
}

/* Full ring pinched by two forces: (pi/4 - 2/pi) P R^3/EI in line, (2/pi - 1/2) across. */
static void pinched_ring(void **state)
{
    double error[2][3];

    (void)state;
    for (int k = 0; k < 3; k++) {
        int n = 8 << k;
        struct rod p;
        const double wanted[2] = {PI / 4 - 2 / PI, 2 / PI - 0.5};

        sweep = 2 * PI;
        rod_new(&p, n, *thin(), circle);
        p.f.n = n; /* closed: the last node is the first one */
        p.f.beam[n - 1].b = 0;
        p.f.node[0].held = p.f.node[n / 2].held = 2 | 4;
        p.f.node[n / 4].held = 1 | 4;
        rod_load(&p, 0, 1, (double[6]){-1});
        rod_load(&p, n / 2, 1, (double[6]){1});
        rod_linear(&p);
        error[0][k] = fabs((rod_moved(&p, n / 2, 0) - rod_moved(&p, 0, 0)) / wanted[0] - 1);
        error[1][k] = fabs((rod_moved(&p, n / 4, 1) - rod_moved(&p, 3 * n / 4, 1)) / wanted[1] - 1);
        rod_free(&p);
    }
    for (int c = 0; c < 2; c++) {
        print_message("pinched ring: errors %.2g %.2g %.2g\n", error[c][0], error[c][1],
                      error[c][2]);
        below(error[c][2], 1e-4); /* 32 elements; 0.148778 and 0.136620 have six digits */
        near_abs(log2(error[c][1] / error[c][2]), 4, 0.4);
    }
}

/*
 * Semicircular bow, clamped at both ends, a force P out of its plane at the crown.  At the crown
 * the torsion is zero by symmetry, the bending moment M0: from the crown, M = M0 cos a - (P/2) R
 * sin a, T = M0 sin a - (P/2) R (1 - cos a); no rotation about the crown's radius gives M0.
 */
static void bow_out_of_plane(void **state)
{
    const double GJ = 0.77, P = 1, R = 1;
    double aMM = PI / 4 + PI / 4 / GJ, aMP = (0.5 + 0.5 / GJ) / 2;
    double M0 = P * R * aMP / aMM;
    double moved = 0, wanted;

    (void)state;
    /* w = dU/dP over both halves: 2 int [M dM/dP/EI + T dT/dP/GJ] R da */
    for (int k = 0; k < 20000; k++) {
        double a = PI / 2 * (k + 0.5) / 20000;
        double M = M0 * cos(a) - P / 2 * R * sin(a), T = M0 * sin(a) - P / 2 * R * (1 - cos(a));

        moved +=
            2 * R * (M * (-R / 2 * sin(a)) + T / GJ * (-R / 2 * (1 - cos(a)))) * PI / 2 / 20000;
    }
    wanted = moved;
    for (int n = 8; n <= 16; n *= 2) {
        struct rod p;

        sweep = PI;
        rod_new(&p, n, *thin(), circle);
        p.f.node[n].held = 63;
        rod_load(&p, n / 2, 1, (double[6]){0, 0, 1});
        rod_linear(&p);
        near_rel(rod_moved(&p, n / 2, 2), wanted, n == 8 ? 1e-2 : 1e-3); /* order 4 */
        rod_free(&p);
    }
}

static double helix_radius = 1, helix_rise = 0.02, helix_turns = 6; /* rise: of a radian */

static void helix(double u, double x[3], double A[9])
{
    double a = 2 * PI * helix_turns * u, c = cos(a), s = sin(a), R = helix_radius;
    double t[3] = {-R * s, R * c, helix_rise};

    vec3_scale(1 / vec3_length(t), t);
    x[0] = R * c;
    x[1] = R * s;
    x[2] = helix_rise * a;
    A[0] = c;
    A[1] = s;
    A[2] = 0;
    memcpy(A + 6, t, sizeof t);
    vec3_cross(t, A, A + 3);
}

/*
 * Spring of n turns, pitch angle q, whole turns (Love; Wahl for q = 0: d^4 G/(64 R^3 n)): end
 * forces along and about the axis, all else free, do by Castigliano per turn of length 2 pi R/cos q
 *     axial      P R^2 (cos^2 q/GJ + sin^2 q/EI),      torsion  M (sin^2 q/GJ + cos^2 q/EI)
 */
static void springs(void **state)
{
    double order[2] = {0, 0};

    (void)state;
    for (int per = 8; per <= 32; per *= 2) {
        double EI = 1, GJ = 0.77, q, length, error[2];

        helix_rise = 0.05;
        q = atan(helix_rise / helix_radius);
        length = 2 * PI * helix_radius * helix_turns / cos(q);
        for (int c = 0; c < 2; c++) {
            struct rod p;
            int n = per * (int)helix_turns;
            double load[6] = {0}, wanted;

            rod_new(&p, n, rod_section(1e9, EI, EI, GJ), helix);
            load[c ? 5 : 2] = 1;
            if (c == 0) { /* a force along the axis acts at its lever: (x, y) = (1, 0) */
                load[3] = 0;
                load[4] = helix_radius;
            }
            rod_load(&p, n, 1, load);
            rod_linear(&p);
            wanted = c == 0 ? length * (pow(cos(q), 2) / GJ + pow(sin(q), 2) / EI)
                            : length * (pow(sin(q), 2) / GJ + pow(cos(q), 2) / EI);
            error[c] = c == 0 ? rod_moved(&p, n, 2) + helix_radius * rod_moved(&p, n, 4)
                              : rod_moved(&p, n, 5);
            error[c] = fabs(error[c] / wanted - 1);
            rod_free(&p);
            if (per > 8)
                near_abs(log2(order[c] / error[c]), 4, 0.3);
            order[c] = error[c];
        }
        print_message("spring of %d elements a turn: errors %.2g axial, %.2g torsional\n", per,
                      error[0], error[1]);
    }
    below(order[0], 3e-5); /* seen 1.9e-5 */
    below(order[1], 1e-5);
}

static void line(double u, double x[3], double A[9])
{
    const double frame[9] = {0, 0, -1, 0, 1, 0, 1, 0, 0};

    x[0] = u;
    x[1] = x[2] = 0;
    memcpy(A, frame, sizeof frame);
}

/* A cantilever with a hinge at its middle node that rests on a second support: statics tells all.
 * Clamped at 0, hinge at 1/2, roller at 1, load 1 at 3/4 across: roller 1/2, hinge 1/2. */
static void hinged_beam(void **state)
{
    for (int axes = 1; axes <= 2; axes++) { /* one axis, and a universal joint */
        struct rod p;

        (void)state;
        rod_new(&p, 4, rod_section(1e6, 1, 1, 1), line);
        p.f.beam[2].hinge[0].n = axes;
        p.f.beam[2].hinge[0].axis[0][2] = 1; /* bending in x-y turns about z */
        p.f.beam[2].hinge[0].axis[1][1] = 1;
        p.f.node[4].held = 2 | 4;
        rod_load(&p, 3, 1, (double[6]){0, -1, 0});
        rod_linear(&p);
        near_abs(p.w.open[6 * 4 + 1], 0.5, 1e-11);          /* roller */
        near_abs(p.w.open[1], 0.5, 1e-11);                  /* clamp */
        near_abs(p.w.open[5], 0.25, 1e-11);                 /* its moment, 1/2 x 1/2 */
        near_abs(p.w.end[12 * 2 + 5], 0, 1e-11);            /* the hinge */
        near_abs(rod_moved(&p, 2, 1), -0.5 / 3 / 8, 1e-11); /* P L^3/(3 EI), P = L = 1/2 */
        rod_free(&p);
    }
}

/* A ball joint carries no moment; a bar between two of them spins, which a spring stops. */
static void ball_and_spring(void **state)
{
    struct rod p;
    struct frame_spring spring[2] = {{.a = 4, .b = -1, .B = {1, 0, 0, 0, 1, 0, 0, 0, 1}},
                                     {.a = 2, .b = 3, .B = {0, 1, 0, 0, 0, 1, 1, 0, 0}}};

    (void)state;
    rod_new(&p, 4, rod_section(1e6, 1, 1, 1), line);
    p.f.beam[3].hinge[0].n = 3;
    spring[0].k[1] = 7;  /* ground, along y */
    spring[1].k[2] = 11; /* along its own z, which is x */
    p.f.spring = spring;
    p.f.springs = 2;
    p.f.node[4].held = 4 | 8 | 16 | 32;
    rod_load(&p, 4, 1, (double[6]){11, 7, 0});
    rod_linear(&p);
    near_abs(p.w.end[12 * 3 + 5], 0, 1e-10);
    /* the free ball end keeps its direction along y: only the spring carries what the lever does
     * not: the bar's clamped far end pushes back no moment at the ball, so its shear is zero */
    near_abs(p.w.end[12 * 3 + 1] + p.w.end[12 * 3 + 7], 0, 1e-10);
    near_rel(p.w.open[6 * 0], -11, 1e-10);
    rod_free(&p);
}

/* Prescribed ends: a clamped beam whose end is lifted by 1 and turned by 2: textbook forces. */
static void moved_support(void **state)
{
    struct rod p;

    (void)state;
    rod_new(&p, 4, rod_section(1e6, 1, 1, 1), line);
    p.f.node[4].held = 63;
    rod_hold(&p, 4, 1, 1, 1);
    rod_hold(&p, 4, 5, 1, 2);
    rod_linear(&p);
    near_abs(p.w.open[6 * 4 + 1], 12 - 6 * 2, 1e-11);
    near_rel(p.w.open[6 * 4 + 5], 4 * 2 - 6, 1e-11);
    near_rel(p.w.open[5], 2 * 2 - 6, 1e-11);
    rod_free(&p);
}

/* Own weight of a quarter ring, its plane upright, by one load on each element: reactions are the
 * weight and its moment, the tip sinks as by Castigliano (quadrature). */
static void own_weight(void **state)
{
    double error[3];

    (void)state;
    for (int k = 0; k < 3; k++) {
        int n = 4 << k;
        struct rod p;
        double wanted = 0;

        sweep = PI / 2;
        rod_new(&p, n, *thin(), circle);
        free(p.f.load);
        p.f.load = mem_zeroed((size_t)n, sizeof *p.f.load);
        assert_non_null(p.f.load);
        for (int i = 0; i < n; i++)
            p.f.load[p.f.loads++] =
                (struct frame_load){.node = -1, .beam = i, .value = {0, 0, -1}, .stage = 1};
        rod_linear(&p);
        near_rel(p.w.open[2], PI / 2, 1e-3); /* length of the cubics */
        for (int i = 0; i < 4000; i++) {     /* unit load at the tip against the weight beyond a */
            double a = PI / 2 * (i + 0.5) / 4000, s = sin(a), c = cos(a);
            double M1 = s, Mw = 1 - c, T1 = Mw, Tw = a - s;

            wanted -= (M1 * Mw + T1 * Tw / 0.77) * PI / 2 / 4000;
        }
        error[k] = fabs(rod_moved(&p, n, 2) / wanted - 1);
        rod_free(&p);
    }
    print_message("own weight: errors %.2g %.2g %.2g\n", error[0], error[1], error[2]);
    near_abs(log2(error[0] / error[1]), 4, 0.5);
    below(error[2], 1e-5);
}

/* Dividing a half turn but a little into small pieces: all on the circle. */
static void divided_circle(void **state)
{
    struct station end[2], *at = malloc((DIVIDE_MOST + 1) * sizeof *at);
    int n;

    (void)state;
    assert_non_null(at);
    memset(end, 0, sizeof end);
    sweep = 2.9;
    for (int k = 0; k < 2; k++)
        circle(k, end[k].x, end[k].A);
    n = divide(&end[0], &end[1], PI / 6, at);
    assert_int_equal(n, 4);
    for (int k = 0; k <= n; k++) {
        double t[3] = {-at[k].x[1], at[k].x[0], 0};

        near_abs(vec3_length(at[k].x), 1, 1e-14);
        for (int c = 0; c < 3; c++)
            near_abs(at[k].A[6 + c], t[c], 1e-14);
        near_abs(at[k].A[2], 0, 1e-14); /* the radial axis stays in the plane */
    }
    circle(0, end[0].x, end[0].A);
    sweep = PI;
    circle(1, end[1].x, end[1].A);
    assert_int_equal(divide(&end[0], &end[1], PI / 6, at), 0); /* ends point back */
    free(at);
}

TEST_MAIN(cmocka_unit_test(quarter_ring), cmocka_unit_test(pinched_ring),
          cmocka_unit_test(bow_out_of_plane), cmocka_unit_test(springs),
          cmocka_unit_test(hinged_beam), cmocka_unit_test(ball_and_spring),
          cmocka_unit_test(moved_support), cmocka_unit_test(own_weight),
          cmocka_unit_test(divided_circle))
