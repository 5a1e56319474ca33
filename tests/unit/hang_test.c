/* Equilibrium: closed forms, any start, forces in balance, units and turns, edges. */
#include "rig.h"

#include "phys/sway.h"

/* Two slings from the hook to the load: tan(tilt) = e/h with h = v - z,
 * F = (W/2) sin(phi -+ tilt)/(sin(phi) cos(phi)); the far one slack from tilt = phi on, and then
 * the load hangs plumb below the other, if it can (z < 0). */
static void primary_only(void **state)
{
    struct linkage l = {.v = 5, .z = 2, .phi = 20 * DEGREES, .m_load = 1000, .g = 9.81};
    (void)state;

    for (int low = 0; low < 2; low++) {
        double h, b = l.v * tan(l.phi);

        l.z = low ? -1 : 2;
        h = l.v - l.z;
        for (int i = 0; i <= 20; i++) {
            double delta = (i - 10) / 10.0 * (low ? 30 : 19) * DEGREES, tilt = fabs(delta);
            struct gear s;
            struct hang is;

            l.offset = h * tan(delta);
            s = suspended_linkage(&l);
            is = hung(&s, HANG_DOWN);
            below(unbalanced(&s, &is), 1e-12);
            if (tilt > l.phi)
                tilt = atan((fabs(l.offset) - b) / -l.z);
            near_abs(pose_tilted(is.pose), copysign(tilt, delta), 1e-11);
            for (int k = 0; k < 2; k++) {
                double side = (k ? 1 : -1) * delta;
                double F = 9810 / (2 * sin(l.phi) * cos(l.phi)) * sin(l.phi + side);

                near_abs(is.force[k], tilt > l.phi ? side > 0 ? 9810 : 0 : F, 1e-7);
            }
        }
    }
}

static void random_start(uint64_t *seed, const struct gear *s, double size, struct pose *pose)
{
    double q[GEAR_FREE], length, weight;
    struct freedom f;

    gear_freedom(s, -1, &f);
    gear_drawn(s, pose);
    gear_scale(s, &length, &weight);
    for (int i = 0; i < f.n; i++)
        q[i] = uniform_in(seed, -1, 1) * size * (f.axis[i] < 3 ? 0.5 * length : 1.5);
    pose_move(&f, q, pose);
}

static struct tandem random_tandem(uint64_t *seed, int i)
{
    struct tandem t = {.hooks = 1 + i % 2,
                       .slings = i & 2 ? 2 : 4,
                       .spreaders = i >> 2 & 1,
                       .v = log_uniform(seed, 1, 10),
                       .s = log_uniform(seed, 1, 10),
                       .z = uniform_in(seed, -3, 3),
                       .spreader_half = log_uniform(seed, 1, 5),
                       .spreader_cross = log_uniform(seed, 0.3, 1),
                       .base_half = log_uniform(seed, 1, 5),
                       .base_cross = log_uniform(seed, 0.3, 1),
                       .m_spreader = 2e3,
                       .m_load = 1e5,
                       .g = 9.81,
                       .offset = {uniform_in(seed, -1, 1), uniform_in(seed, -1, 1)}};

    t.hook[1][1] = log_uniform(seed, 2, 20);
    if (i & 8)
        t.stretch_primary = t.stretch_secondary = log_uniform(seed, 1e-3, 0.05);
    return t;
}

/* From wherever it is let go it comes to rest where all forces are in balance and it is stable. */
static void any_start(void **state)
{
    uint64_t seed = 11;
    int slack = 0;
    (void)state;

    for (int i = 0; i < 800; i++) {
        struct gear s;
        struct pose start[GEAR_BODIES];
        struct hang h;

        if (i % 2) {
            struct linkage l = random_linkage(&seed);

            l.offset = uniform_in(&seed, -0.3, 0.3) * l.v;
            l.stretch_primary = i % 3 ? 0 : log_uniform(&seed, 1e-3, 0.1);
            s = suspended_linkage(&l);
        } else {
            struct tandem t = random_tandem(&seed, i / 2);

            s = suspended_tandem(&t);
        }
        random_start(&seed, &s, i % 5 ? 0.3 : 1, start);
        assert_int_equal(hang(&s, HANG_DOWN, start, -1, &h), SW_OK);
        below(unbalanced(&s, &h), 1e-10);
        below(h.residual, 1e-10);
        assert_true(h.least > -1e-9);
        for (int k = 0; k < s.slings; k++)
            slack += h.force[k] == 0;
    }
    assert_true(slack > 20);
}

/* Beside the start Newton finds what the way down finds.  (Neutral motions once led it away.) */
static void near_and_down(void **state)
{
    uint64_t seed = 14;
    (void)state;

    for (int i = 0; i < 200; i++) {
        struct tandem t = random_tandem(&seed, i);
        struct gear s;
        struct hang h, g;

        t.offset[0] *= 0.1 * t.base_half;
        t.offset[1] *= 0.1 * t.base_half;
        t.z = -fabs(t.z) - 1;
        s = suspended_tandem(&t);
        h = hung(&s, HANG_NEAR);
        g = hung(&s, HANG_DOWN);
        below(unbalanced(&s, &h), 1e-10);
        assert_true(h.least > 0);
        for (int k = 0; k < s.slings; k++)
            near_abs(g.force[k], h.force[k], 1e-8 * 1e6);
    }
}

static void turn_point(double angle, double x[3])
{
    double a = cos(angle) * x[0] - sin(angle) * x[1];

    x[1] = sin(angle) * x[0] + cos(angle) * x[1];
    x[0] = a;
}

/* Everything turned about the vertical axis. */
static struct gear turned(const struct gear *s, double angle)
{
    struct gear r = *s;
    double c = cos(angle), d = sin(angle), R[3][3] = {{c, -d, 0}, {d, c, 0}, {0, 0, 1}};

    for (int p = 0; p < s->points; p++)
        turn_point(angle, r.point[p].at);
    for (int b = 0; b < s->bodies; b++) {
        turn_point(angle, r.body[b].cg);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                r.body[b].inertia[i][j] = 0;
                for (int k = 0; k < 3; k++)
                    for (int l = 0; l < 3; l++)
                        r.body[b].inertia[i][j] += R[i][k] * s->body[b].inertia[k][l] * R[j][l];
            }
    }
    return r;
}

/* Millimetres, tonnes: lengths by a, masses by m, times as they are. */
static struct gear in_units(const struct gear *s, double a, double m)
{
    struct gear r = *s;

    r.g *= a;
    for (int p = 0; p < s->points; p++)
        for (int i = 0; i < 3; i++)
            r.point[p].at[i] *= a;
    for (int b = 0; b < s->bodies; b++) {
        r.body[b].mass *= m;
        for (int i = 0; i < 3; i++) {
            r.body[b].cg[i] *= a;
            for (int j = 0; j < 3; j++)
                r.body[b].inertia[i][j] *= m * a * a;
        }
    }
    for (int k = 0; k < s->slings; k++) {
        r.sling[k].length *= a;
        r.sling[k].EA *= m * a;
    }
    return r;
}

static void same(const struct gear *s, const struct gear *r, double force)
{
    struct hang h = hung(s, HANG_DOWN), g = hung(r, HANG_DOWN);
    struct sway m, n;

    assert_int_equal(sway_of(s, &h, &m), SW_OK);
    assert_int_equal(sway_of(r, &g, &n), SW_OK);
    for (int k = 0; k < s->slings; k++)
        near_abs(g.force[k], force * h.force[k], force * 1e-9 * 1e6);
    assert_int_equal(m.n, n.n);
    for (int k = 0; k < m.n; k++)
        near_abs(n.omega2[k], m.omega2[k], 1e-8 * fabs(m.omega2[m.n - 1]));
}

static void turns_and_units(void **state)
{
    uint64_t seed = 12;
    (void)state;

    for (int i = 0; i < 32; i++) {
        struct tandem t = random_tandem(&seed, i);
        struct gear s, r;

        t.z = -fabs(t.z);
        s = suspended_tandem(&t);
        r = turned(&s, 0.7);
        same(&s, &r, 1);
        r = in_units(&s, 1000, 1e-3);
        same(&s, &r, 1);
    }
}

/* The other way round of a symmetric lift is the same. */
static void crossed_over(void **state)
{
    uint64_t seed = 13;
    (void)state;

    for (int i = 0; i < 16; i++) {
        struct tandem t = random_tandem(&seed, i);
        struct gear s;
        struct hang h, g;

        t.z = -fabs(t.z);
        s = suspended_tandem(&t);
        h = hung(&s, HANG_DOWN);
        t.offset[0] = -t.offset[0];
        s = suspended_tandem(&t);
        g = hung(&s, HANG_DOWN);
        for (int k = 0; k < s.slings; k++)
            near_abs(g.force[k ^ 1], h.force[k], 1e-9 * 1e6);
    }
}

/* Unstable by the formula, and held upright by the edges that both slings touch. */
static void upright_by_contact(void **state)
{
    struct linkage l = leaning(-0.2, 0);
    struct gear s = suspended_linkage(&l);
    struct hang h = hung(&s, HANG_NEAR);
    (void)state;

    assert_true(h.least < 0);
    for (double tilt = 0; tilt < 0.1; tilt += 0.03) { /* and comes back to it */
        struct pose start[GEAR_BODIES];

        gear_drawn(&s, start);
        pose_tilt(start + LINKAGE_LOAD, tilt);
        pose_tilt(start + LINKAGE_SPREADER, tilt);
        assert_int_equal(hang(&s, HANG_DOWN, start, -1, &h), SW_OK);
        assert_int_equal(h.by_contact, 1);
        near_abs(pose_tilted(h.pose + LINKAGE_LOAD), 0, 1e-9);
        near_abs(pose_tilted(h.pose + LINKAGE_SPREADER), 0, 1e-9);
    }
    for (double fall = 0.5; fall < 3; fall += 0.5) { /* or falls into it */
        struct pose start[GEAR_BODIES];

        gear_drawn(&s, start);
        start[LINKAGE_LOAD].r[2] += fall;
        assert_int_equal(hang(&s, HANG_DOWN, start, -1, &h), SW_OK);
        assert_int_equal(h.by_contact, 1);
    }
    l.edges = 0;
    s = suspended_linkage(&l);
    h = hung(&s, HANG_DOWN);
    assert_int_equal(h.by_contact, 0);
    assert_true(fabs(pose_tilted(h.pose)) > 0.5);
}

/* With a gap it leans until a sling touches: a little beyond atan(gap/height), stable, on one edge,
 * balanced with the edge's pressure; stable by the formula it does not move. */
static void leans_on_an_edge(void **state)
{
    (void)state;

    for (double gap = 0.01; gap < 0.3; gap *= 2) {
        struct linkage l = leaning(-0.2, gap);
        struct gear s = suspended_linkage(&l);
        struct hang h = hung(&s, HANG_DOWN);
        double tilt = fabs(pose_tilted(h.pose)), touch = atan(gap / 3);

        assert_int_equal(h.by_contact, 0);
        assert_true(h.least > 0);
        assert_int_equal(h.contacts[LINKAGE_SECOND_LEFT] + h.contacts[LINKAGE_SECOND_RIGHT], 1);
        assert_true(tilt > touch && tilt < 1.2 * touch);
        below(unbalanced(&s, &h), 1e-12);
        l = leaning(0.2, gap);
        s = suspended_linkage(&l);
        h = hung(&s, HANG_DOWN);
        near_abs(pose_tilted(h.pose), 0, 1e-12);
    }
}

/* A place that is no place gives no equilibrium. */
static void no_numbers(void **state)
{
    (void)state;

    for (int way = HANG_NEAR; way <= HANG_DOWN; way++)
        for (int elastic = 0; elastic < 2; elastic++) {
            struct linkage l = inclined;
            struct gear s;
            struct pose start[GEAR_BODIES];
            struct hang h;

            l.stretch_primary = l.stretch_secondary = elastic ? 0.01 : 0;
            s = suspended_linkage(&l);
            gear_drawn(&s, start);
            start[0].r[0] = NAN;
            assert_int_not_equal(hang(&s, (enum hang_way)way, start, -1, &h), SW_OK);
        }
}

/* The held tilt of a body and the moment that holds it: W (v - z) sin(tilt). */
static void held(void **state)
{
    struct linkage l = {.v = 5, .z = 2, .phi = 20 * DEGREES, .m_load = 1000, .g = 9.81};
    struct gear s = suspended_linkage(&l);
    struct pose start[GEAR_BODIES];
    struct hang h;
    (void)state;

    gear_drawn(&s, start);
    pose_tilt(start, 0.25);
    assert_int_equal(hang(&s, HANG_DOWN, start, 0, &h), SW_OK);
    near_rel(pose_tilted(h.pose), 0.25, 1e-14);
    near_rel(h.moment, 9810 * 3 * sin(0.25), 1e-11);
    near_rel(h.energy, 9810 * 3 * (1 - cos(0.25)), 1e-11);
}

/* From beyond the world, and from nowhere, there is no way back. */
static void far_away(void **state)
{
    static const double far[3] = {1e9, 1e300, NAN};
    (void)state;

    for (int k = 0; k < 3; k++) {
        struct gear s = suspended_linkage(&inclined);
        struct hang near = hung(&s, HANG_NEAR), h;
        struct pose start[GEAR_BODIES];

        memcpy(start, near.pose, sizeof start);
        start[0].r[2] = far[k];
        assert_int_equal(hang(&s, HANG_NEAR, start, -1, &h), SW_NOCONV);
    }
}

TEST_MAIN(cmocka_unit_test(primary_only), cmocka_unit_test(any_start),
          cmocka_unit_test(near_and_down), cmocka_unit_test(turns_and_units),
          cmocka_unit_test(crossed_over), cmocka_unit_test(upright_by_contact),
          cmocka_unit_test(leans_on_an_edge), cmocka_unit_test(held), cmocka_unit_test(no_numbers),
          cmocka_unit_test(far_away))
