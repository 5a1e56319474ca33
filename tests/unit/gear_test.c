/* Suspensions: derivatives against differences, paths round edges, units, what is refused. */
#include "rig.h"

#include "phys/path.h"
#include "phys/potential.h"
#include "phys/space.h"

/* A box 2 x 2 x 2 hung from two hooks by four slings that lean on edges of any direction, under
 * another box; every second one elastic. */
static struct gear random_gear(uint64_t *seed, int planar)
{
    struct gear s = {.planar = planar, .g = 9.81};
    double edge[3] = {0, 1, 0}, cg[2][3];

    for (int b = 0; b < 2; b++) {
        double I = uniform_in(seed, 1, 2);

        for (int i = 0; i < 3; i++)
            cg[b][i] = planar && i == 1 ? 0 : uniform_in(seed, -0.3, 0.3);
        cg[b][2] -= 3 + 4 * b;
        gear_add_body(&s, uniform_in(seed, 1, 3), cg[b],
                      (const double[3][3]){{I, 0, 0}, {0, I, 0}, {0, 0, I}});
    }
    for (int i = 0; i < 3 && !planar; i++)
        edge[i] += uniform_in(seed, -0.3, 0.3);
    for (int k = 0; k < 4; k++) {
        double side = k % 2 ? 1 : -1, y = planar ? 0 : k / 2 ? 1 : -1;
        int body = k / 2, a, b, sling;
        double out[3] = {side, 0, 0}, corner[2][3] = {{side, 0, 0}, {side, 0, 0}};

        a = gear_add_point(&s, body - 1, side * uniform_in(seed, 0, 0.9), planar ? 0 : -y,
                           -4 * body);
        b = gear_add_point(&s, body, side * uniform_in(seed, 0.2, 0.9), y, -4 - 4 * body);
        sling = gear_add_sling(&s, a, b, 0, k % 3 ? 50 : INFINITY);
        corner[0][2] = -2 - 4 * body + uniform_in(seed, -0.2, 0.2);
        corner[1][2] = -4 - 4 * body + uniform_in(seed, -0.2, 0.2);
        assert_int_equal(gear_add_edges(&s, sling, body, edge, out, 2, (const double(*)[3])corner),
                         SW_OK);
        gear_tighten(&s, sling, k % 3 ? 0.1 : 0);
    }
    assert_int_equal(gear_check(&s), SW_OK);
    return s;
}

struct energy {
    const struct gear *s;
    const struct pose *pose;
    const struct freedom *f;
    const struct sling_law *law;
};

/* Energy of the pose moved by t q. */
static double energy_at(const struct energy *e, const double *q, double t)
{
    struct pose moved[GEAR_BODIES];
    double x[GEAR_FREE];

    memcpy(moved, e->pose, sizeof moved);
    for (int i = 0; i < e->f->n; i++)
        x[i] = t * q[i];
    pose_move(e->f, x, moved);
    return potential_energy(e->s, moved, e->law);
}

/* First and second derivative along q by differences of sixth and fourth order. */
static void differences(const struct energy *e, const double *q, double *ret_first,
                        double *ret_second)
{
    const double t = 2e-3;
    double d[3], dd[2] = {0}, middle = energy_at(e, q, 0);

    for (int i = 0; i < 3; i++) {
        double plus = energy_at(e, q, t * (i + 1)), minus = energy_at(e, q, -t * (i + 1));

        d[i] = (plus - minus) / (2 * t);
        if (i < 2)
            dd[i] = (plus + minus - 2 * middle) / (t * t);
    }
    *ret_first = (45 * d[0] - 9 * d[1] + d[2]) / 30;
    *ret_second = (16 * dd[0] - dd[1]) / 12;
}

/* What touches and pulls at t q: an edge or slackness within a difference spoils it. */
static unsigned contacts_at(const struct energy *e, const double *q, double t)
{
    struct pose moved[GEAR_BODIES];
    double x[GEAR_FREE];
    struct potential p;
    unsigned sum = 0;

    memcpy(moved, e->pose, sizeof moved);
    for (int i = 0; i < e->f->n; i++)
        x[i] = t * q[i];
    pose_move(e->f, x, moved);
    potential_at(e->s, moved, e->f, e->law, &p);
    for (int k = 0; k < e->s->slings; k++)
        sum = 6 * sum + 2 * (unsigned)p.contacts[k] + (p.force[k] > 0);
    return sum;
}

static void derivatives(void **state)
{
    uint64_t seed = 3;
    int touched = 0, climbing = 0;
    (void)state;

    for (int turn = 0; turn < 400; turn++) {
        struct gear s = random_gear(&seed, turn % 2);
        struct pose pose[GEAR_BODIES];
        struct sling_law law[GEAR_SLINGS];
        double force[GEAR_SLINGS] = {20, 0, 0, 10}, q[GEAR_FREE], first, second;
        double gq = 0, qHq = 0;
        struct freedom f;
        struct potential p;
        struct energy e = {&s, pose, &f, law};

        gear_freedom(&s, -1, &f);
        gear_drawn(&s, pose);
        for (int i = 0; i < f.n; i++)
            q[i] = uniform_in(&seed, -0.3, 0.3);
        pose_move(&f, q, pose);
        potential_laws(&s, force, law);
        potential_at(&s, pose, &f, law, &p);
        near_rel(p.energy, potential_energy(&s, pose, law), 1e-14);
        for (int i = 0; i < f.n; i++)
            q[i] = uniform_in(&seed, -1, 1);
        for (int i = 0; i < f.n; i++) {
            gq += p.gradient[i] * q[i];
            for (int j = 0; j < f.n; j++) {
                near_abs(p.H[i + j * f.n], p.H[j + i * f.n], 1e-11);
                qHq += q[i] * p.H[i + j * f.n] * q[j];
            }
        }
        differences(&e, q, &first, &second);
        if (contacts_at(&e, q, -6e-3) != contacts_at(&e, q, 6e-3))
            continue;
        for (int k = 0; k < s.slings; k++) {
            touched += p.contacts[k] > 0;
            climbing += p.contacts[k] == 2 && !s.planar;
        }
        near_abs(first, gq, 1e-9 * (1 + fabs(gq)));
        near_abs(second, qHq, 1e-6 * (1 + fabs(qHq)));
    }
    assert_true(touched > 100 && climbing > 10);
}

/* Two edges, seen along them sqrt(2) + 1 + hypot(0.5, 1), 3 along them; none in the way: straight.
 */
static void unfolded(void **state)
{
    struct gear s = {.g = 1};
    const double corner[2][3] = {{1, 0, 1}, {1, 7, 0}}, edge[3] = {0, -2, 0}, out[3] = {1, 0, 0};
    struct pose pose[1];
    struct path p;
    int a, b, k;
    (void)state;

    gear_add_body(&s, 1, (double[3]){0}, (const double[3][3]){{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    a = gear_add_point(&s, GEAR_HOOK, 0, 0, 2);
    b = gear_add_point(&s, 0, 0.5, 3, -1);
    k = gear_add_sling(&s, a, b, 0, INFINITY);
    near_rel(s.sling[k].length, sqrt(0.25 + 9 + 9), 1e-15);
    assert_int_equal(gear_add_edges(&s, k, 0, edge, out, 2, corner), SW_OK);
    gear_drawn(&s, pose);
    path_lay(&s, pose, k, &p);
    assert_int_equal(p.n, 4);
    near_rel(p.length, hypot(sqrt(2) + 1 + hypot(0.5, 1), 3), 1e-15);
    near_rel(p.x[1][1] / sqrt(2), p.x[2][1] / (sqrt(2) + 1), 1e-14); /* climbs evenly */
    assert_int_equal(gear_add_edges(&s, k, 0, edge, (double[3]){-1, 0, 0}, 2, corner), SW_OK);
    path_lay(&s, pose, k, &p);
    assert_int_equal(p.n, 2);
    assert_int_equal(gear_add_edges(&s, k, 0, edge, edge, 2, corner), SW_ADMISSIBLE);
    assert_int_equal(gear_add_edges(&s, k, 0, edge, out, 5, corner), SW_ADMISSIBLE);
}

/* A load turns until its sling touches the edge: length and slope go on without a jump, the second
 * derivative jumps up. */
static void touching(void **state)
{
    struct linkage l = inclined;
    struct gear s;
    struct freedom f;
    double before[3] = {0}, after[3] = {0};
    (void)state;

    l.edges = 1;
    l.half[0] = l.v * tan(l.phi) + l.s * tan(l.gamma) - 0.05;
    l.height[0] = 2;
    s = suspended_linkage(&l);
    gear_freedom(&s, -1, &f);
    for (int side = 0; side < 2; side++) {
        double tilt = 0, step = 0.1, H[GEAR_FREE * GEAR_FREE] = {0};
        double g[GEAR_FREE];
        struct pose pose[GEAR_BODIES];
        struct path p;

        for (int i = 0; i < 60;
             i++, step /= 2) { /* the last tilt without contact, the first with */
            gear_drawn(&s, pose);
            pose_tilt(pose, tilt + step);
            path_lay(&s, pose, LINKAGE_SECOND_RIGHT, &p);
            tilt += p.n == 2 ? step : 0;
        }
        gear_drawn(&s, pose);
        pose_tilt(pose, tilt + (side ? 1e-9 : -1e-9));
        path_lay(&s, pose, LINKAGE_SECOND_RIGHT, &p);
        assert_int_equal(p.n, 2 + side);
        path_gradient(&p, &f, g);
        path_add_hessian(&p, &f, 1, H);
        memcpy(side ? after : before, (double[3]){p.length, g[2], H[2 + 2 * f.n]}, sizeof after);
    }
    near_abs(after[0], before[0], 1e-8);
    near_abs(after[1], before[1], 1e-8);
    assert_true(after[2] > before[2] + 0.1);
}

static void no_number_is_lost(void **state)
{
    (void)state;

    assert_true(isnan(larger(NAN, 1)) && isnan(larger(1, NAN)));
    assert_true(isnan(largest(3, (const double[3]){1, NAN, 2})));
    assert_true(largest(3, (const double[3]){1, -3, 2}) == 3);
}

static void refusals(void **state)
{
    struct gear good = suspended_linkage(&inclined), bad;
    struct hang h;
    (void)state;

    assert_int_equal(gear_check(&good), SW_OK);
#define REFUSED(change)                                                                            \
    bad = good;                                                                                    \
    change;                                                                                        \
    assert_int_equal(gear_check(&bad), SW_ADMISSIBLE);                                             \
    assert_int_equal(hang(&bad, HANG_DOWN, NULL, -1, &h), SW_ADMISSIBLE)
    REFUSED(bad.g = 0);
    REFUSED(bad.bodies = 0);
    REFUSED(bad.body[0].mass = NAN);
    REFUSED(bad.body[0].mass = -1);
    REFUSED(bad.body[0].mass = bad.body[1].mass = 0);
    REFUSED(bad.body[0].mass = bad.body[1].mass = 1e308);
    REFUSED(bad.body[0].inertia[1][2] = 1);
    REFUSED(bad.sling[2].length = 0);
    REFUSED(bad.sling[2].length = NAN);
    REFUSED(bad.sling[2].EA = -1);
    REFUSED(bad.sling[2].to = 77);
    REFUSED(bad.point[3].at[0] = INFINITY);
    REFUSED(bad.sling[2].corners = 1); /* on no edge */
    REFUSED(bad.slings = 2);           /* nothing holds the load */
#undef REFUSED
    good.planar = 0;
    assert_int_equal(hang(&good, HANG_NEAR, NULL, 0, &h), SW_ADMISSIBLE);
}

TEST_MAIN(cmocka_unit_test(derivatives), cmocka_unit_test(unfolded), cmocka_unit_test(touching),
          cmocka_unit_test(no_number_is_lost), cmocka_unit_test(refusals))
