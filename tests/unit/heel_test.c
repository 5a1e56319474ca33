/* Large tilt: closed forms of the suspension by primary slings alone, work of the moment, ends. */
#include "rig.h"

#include "phys/heel.h"

static const struct linkage primary = {
    .v = 5, .z = 2, .phi = 20 * DEGREES, .m_load = 1000, .g = 9.81};

/*
 * Both slings taut: the triangle turns about the hook, M = W (h sin(tilt) - e cos(tilt)).  At
 * tilt = phi one sling hangs plumb and the other goes slack; from there on the load turns about its
 * lifting point: M = W ((b/2 - e) cos(tilt) - z sin(tilt)), zero at tan = (b/2 - e)/z.
 */
static double moment(const struct linkage *l, double tilt)
{
    double W = l->m_load * l->g, b = l->v * tan(l->phi);

    if (tilt < l->phi)
        return W * ((l->v - l->z) * sin(tilt) - l->offset * cos(tilt));
    return W * ((b - l->offset) * cos(tilt) - l->z * sin(tilt));
}

/* Its integral from 0. */
static double work(const struct linkage *l, double tilt)
{
    double W = l->m_load * l->g, b = l->v * tan(l->phi), h = l->v - l->z, e = l->offset;
    double first = fmin(tilt, l->phi), sum = W * (h * (1 - cos(first)) - e * sin(first));

    if (tilt > l->phi)
        sum += W * ((b - e) * (sin(tilt) - sin(l->phi)) + l->z * (cos(tilt) - cos(l->phi)));
    return sum;
}

static void closed_range(void **state)
{
    (void)state;

    for (int i = 0; i < 5; i++) {
        struct linkage l = primary;
        double b = l.v * tan(l.phi), tilt, end;
        struct gear s;
        struct hang h;
        struct heel_range r;

        l.offset = 0.2 * i;
        tilt = atan(l.offset / 3);
        end = atan((b - l.offset) / l.z);
        s = suspended_linkage(&l);
        h = hung(&s, HANG_DOWN);
        assert_int_equal(heel_range(&s, 0, &h, PI, &r), SW_OK);
        assert_int_equal(r.end, HEEL_CAPSIZES);
        near_abs(r.tilt, tilt, 1e-11);
        near_rel(r.capsizing, end, 1e-11);
        near_rel(r.energy, work(&l, end) - work(&l, tilt), 1e-9);
        near_abs(r.at, l.phi, 1e-6); /* the kink is the top */
        near_rel(r.moment, moment(&l, l.phi), 1e-6);
    }
}

/* A range far narrower than any step along the path, and none. */
static void narrow_range(void **state)
{
    struct linkage l = primary;
    (void)state;

    for (l.phi = 0.5 * DEGREES; l.phi > 0.01 * DEGREES; l.phi /= 5) {
        struct gear s;
        struct hang h;
        struct heel_range r;

        l.z = 4.5;
        s = suspended_linkage(&l);
        h = hung(&s, HANG_NEAR);
        assert_int_equal(heel_range(&s, 0, &h, PI / 2, &r), SW_OK);
        near_rel(r.capsizing, atan(l.v * tan(l.phi) / l.z), 1e-6);
        l.z = 5.1;
        s = suspended_linkage(&l);
        h = hung(&s, HANG_NEAR);
        assert_int_equal(heel_range(&s, 0, &h, PI / 2, &r), SW_INFEASIBLE);
    }
}

static void closed_path(void **state)
{
    struct gear s = suspended_linkage(&primary);
    struct heel p[61];
    int n;
    (void)state;

    assert_int_equal(heel_path(&s, 0, NULL, 0, 60 * DEGREES, 61, p, &n), SW_OK);
    assert_int_equal(n, 61);
    for (int i = 0; i < n; i++) {
        near_abs(p[i].tilt, i * DEGREES, 1e-14);
        near_abs(p[i].moment, moment(&primary, p[i].tilt), 1e-7);
        near_abs(p[i].energy, work(&primary, p[i].tilt), 1e-7);
        if (i != 20)
            assert_int_equal(p[i].slack, i > 20);
    }
    /* Energies are against the beginning, wherever that is. */
    assert_int_equal(heel_path(&s, 0, NULL, 5 * DEGREES, 15 * DEGREES, 11, p, &n), SW_OK);
    assert_int_equal(n, 11);
    near_abs(p[0].energy, 0, 0);
    for (int i = 1; i < n; i++)
        near_abs(p[i].energy, work(&primary, p[i].tilt) - work(&primary, 5 * DEGREES), 1e-7);
}

/* The printed moment of one side, M = (W/4) h (sin^2 phi cos^2 delta - cos^2 phi sin^2 delta)/(sin
 * phi cos phi cos delta) of one of four slings, is that of its force about the centre of gravity.
 */
static void printed_moment(void **state)
{
    struct linkage l = primary;
    const double phi = l.phi, h = l.v - l.z, W = l.m_load * l.g;
    (void)state;

    for (int i = 0; i < 20; i++) {
        double delta = i * DEGREES, M, arm, a[3], b[3];
        struct gear s;
        struct hang is;

        l.offset = h * tan(delta);
        s = suspended_linkage(&l);
        is = hung(&s, HANG_DOWN);
        place(&s, &is, s.sling[LINKAGE_RIGHT].from, a);
        place(&s, &is, s.sling[LINKAGE_RIGHT].to, b);
        arm =
            ((b[0] - is.pose[0].r[0]) * (a[2] - b[2]) - (b[2] - is.pose[0].r[2]) * (a[0] - b[0])) /
            hypot(a[0] - b[0], a[2] - b[2]);
        M = W / 4 * h * (pow(sin(phi) * cos(delta), 2) - pow(cos(phi) * sin(delta), 2)) /
            (sin(phi) * cos(phi) * cos(delta));
        near_abs(is.force[LINKAGE_RIGHT] / 2 * arm, M, 1e-7);
    }
}

/* The moment is the slope of the energy, and begins with weight times h/r times the tilt. */
static void slope_of_energy(void **state)
{
    struct gear s = suspended_linkage(&inclined);
    struct formula f = formula_of(&inclined);
    struct heel p[401];
    int n;
    (void)state;

    assert_int_equal(heel_path(&s, LINKAGE_LOAD, NULL, 0, 40 * DEGREES, 401, p, &n), SW_OK);
    assert_int_equal(n, 401);
    near_abs(p[0].moment, 0, 1e-6);
    near_rel(p[1].moment, inclined.m_load * 9.81 * f.h / f.r * p[1].tilt, 1e-4);
    near_rel(p[1].others[LINKAGE_LOAD] / p[1].others[LINKAGE_SPREADER], f.r, 1e-4);
    for (int i = 2; i < n - 2; i++)
        near_rel((8 * (p[i + 1].energy - p[i - 1].energy) - p[i + 2].energy + p[i - 2].energy) /
                     (12 * 0.1 * DEGREES),
                 p[i].moment, 1e-6);
}

/* The other end of the path is another equilibrium, an unstable one; to either side the same. */
static void capsizing(void **state)
{
    uint64_t seed = 30;
    int judged = 0, folded = 0;
    (void)state;

    for (int i = 0; i < 100; i++) {
        struct linkage l = random_linkage(&seed);
        struct gear s = suspended_linkage(&l);
        struct heel_range r, left;
        struct hang h = hung(&s, HANG_NEAR);
        enum status status = heel_range(&s, LINKAGE_LOAD, &h, PI, &r);

        if (!(formula_of(&l).h > 1e-3 * l.v)) {
            if (formula_of(&l).h < -1e-3 * l.v)
                assert_int_equal(status, SW_INFEASIBLE);
            continue;
        }
        assert_int_equal(status, SW_OK);
        assert_int_equal(heel_range(&s, LINKAGE_LOAD, &h, -PI, &left), SW_OK);
        near_rel(left.capsizing, -r.capsizing, 1e-6);
        near_rel(left.energy, r.energy, 1e-6);
        near_rel(left.moment, r.moment, 1e-6);
        near_rel(left.at, -r.at, 1e-4);
        assert_true(r.energy > 0 && r.moment > 0 && r.at < r.capsizing);
        folded += r.end == HEEL_FOLDS;
        if (r.end == HEEL_CAPSIZES) {
            struct heel p;
            int n;

            judged++;
            assert_int_equal(heel_path(&s, LINKAGE_LOAD, NULL, r.capsizing, 0, 1, &p, &n), SW_OK);
            assert_int_equal(n, 1);
            below(fabs(p.moment), 1e-8 * l.m_load * 9.81 * (l.v + l.s));
        }
    }
    assert_true(judged > 10 && folded > 10);
}

/* What the load's edges do: they raise the moment once they are touched, and only then. */
static void edges_hold(void **state)
{
    struct linkage l = inclined;
    struct gear bare = suspended_linkage(&l), s;
    struct heel p[41], q[41];
    int n, m, touched = 0;
    (void)state;

    l.edges = 1;
    l.half[0] = l.v * tan(l.phi) + l.s * tan(l.gamma) - 0.3;
    l.height[0] = 2.5;
    s = suspended_linkage(&l);
    assert_int_equal(heel_path(&bare, LINKAGE_LOAD, NULL, 0, 0.6, 41, p, &n), SW_OK);
    assert_int_equal(heel_path(&s, LINKAGE_LOAD, NULL, 0, 0.6, 41, q, &m), SW_OK);
    assert_int_equal(n, 41);
    assert_int_equal(m, 41);
    for (int i = 0; i < 41; i++) {
        touched += q[i].contacts > 0;
        if (q[i].contacts == 0)
            near_abs(q[i].moment, p[i].moment, 1e-5);
        else
            assert_true(q[i].moment > p[i].moment - 1e-5);
    }
    assert_true(touched > 5 && touched < 40);
}

/* What only edges hold upright has a range as well; without them nothing rights it. */
static void held_by_edges(void **state)
{
    struct linkage l = leaning(-0.2, 0);
    struct gear s = suspended_linkage(&l);
    struct hang h = hung(&s, HANG_DOWN);
    struct heel_range right, left;
    (void)state;

    assert_int_equal(heel_range(&s, LINKAGE_LOAD, &h, PI / 2, &right), SW_OK);
    assert_int_equal(heel_range(&s, LINKAGE_LOAD, &h, -PI / 2, &left), SW_OK);
    assert_true(right.energy > 0 && right.moment > 0 && right.capsizing > 0.3);
    near_rel(left.capsizing, -right.capsizing, 1e-8);
    near_rel(left.energy, right.energy, 1e-8);
    l.edges = 0;
    s = suspended_linkage(&l);
    h = hung(&s, HANG_NEAR);
    assert_int_equal(heel_range(&s, LINKAGE_LOAD, &h, PI / 2, &right), SW_INFEASIBLE);
}

static void refusals(void **state)
{
    struct gear s = suspended_linkage(&inclined);
    struct hang h = hung(&s, HANG_DOWN);
    struct heel_range r;
    struct heel p;
    int n;
    (void)state;

    assert_int_equal(heel_range(&s, 2, &h, 1, &r), SW_ADMISSIBLE);
    assert_int_equal(heel_range(&s, 0, &h, NAN, &r), SW_ADMISSIBLE);
    assert_int_equal(heel_path(&s, -1, NULL, 0, 1, 1, &p, &n), SW_ADMISSIBLE);
    assert_int_equal(heel_path(&s, 0, NULL, 0, NAN, 1, &p, &n), SW_ADMISSIBLE);
    s.planar = 0;
    assert_int_equal(heel_range(&s, 0, &h, 1, &r), SW_ADMISSIBLE);
}

TEST_MAIN(cmocka_unit_test(closed_range), cmocka_unit_test(narrow_range),
          cmocka_unit_test(closed_path), cmocka_unit_test(printed_moment),
          cmocka_unit_test(slope_of_energy), cmocka_unit_test(capsizing),
          cmocka_unit_test(edges_hold), cmocka_unit_test(held_by_edges), cmocka_unit_test(refusals))
