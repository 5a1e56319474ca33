/* Static line: random cables, published numbers, closed forms, differences, symmetries. */
#include "check.h"

#define RANDOM_CABLES 1000000

/* Admissible random cable of the issue: L0/chord 0.955 to 100, EA/W 10 to 1e9, chord within 89.9
 * degrees of the level. */
static struct cable random_cable(uint64_t *seed)
{
    double chord = log_uniform(seed, 1e-2, 1e4);
    double angle = uniform_in(seed, -89.9, 89.9) * PI / 180;
    struct cable c = {.g = 9.81, .mu = log_uniform(seed, 1e-3, 1e4)};

    c.L0 = chord * log_uniform(seed, 0.955, 100);
    c.EA = c.mu * c.g * c.L0 * log_uniform(seed, 10, 1e9);
    c.span = chord * cos(angle);
    c.drop = chord * sin(angle);
    return c;
}

static double largest_strain(const struct line *s)
{
    return fmax(hypot(s->H, s->V), hypot(s->H, s->V - s->W)) / s->cable.EA;
}

/* 1e-12 of the chord is asked for; a cable of 100 chords has round-off of its own length. */
static void random_cables_close(void **state)
{
    uint64_t seed = 20031;
    int tried = 0, most = 0;
    double worst = 0, steps = 0;
    (void)state;

    print_message("# seed %llu\n", (unsigned long long)seed);
    while (tried < RANDOM_CABLES) {
        struct cable c = random_cable(&seed);
        struct line s;
        struct line_point end;
        enum status status = line_solve(&c, &s);

        if (status == SW_OK && largest_strain(&s) > 0.05)
            continue;
        tried++;
        if (status != SW_OK)
            print_error("L0 %.17g span %.17g drop %.17g EA %.17g mu %.17g\n", c.L0, c.span, c.drop,
                        c.EA, c.mu);
        assert_int_equal(status, SW_OK);
        line_at(&s, c.L0, &end);
        worst = fmax(worst, hypot(end.x1 - c.span, end.x2 - c.drop) / hypot(c.span, c.drop));
        assert_true(s.H > 0);
        steps += s.steps;
        most = s.steps > most ? s.steps : most;
    }
    print_message("# worst residual %.2g of the chord, steps %.2f on average, %d at most\n", worst,
                  steps / tried, most);
    below(worst, 1e-12);
}

/* Rubber: cables stretched to many times their length, which fuzzing found first. */
static void soft_cables(void **state)
{
    uint64_t seed = 11;
    (void)state;

    for (int i = 0; i < 100000; i++) {
        struct cable c = random_cable(&seed);
        struct line s;
        struct line_point end;
        double chord = hypot(c.span, c.drop);

        c.EA = c.mu * c.g * c.L0 * log_uniform(&seed, 1e-5, 10);
        assert_int_equal(line_solve(&c, &s), SW_OK);
        line_at(&s, c.L0, &end);
        below(hypot(end.x1 - c.span, end.x2 - c.drop), 1e-12 * (chord + line_length(&s)));
    }
}

/* Theory section 2, Table 6.1: midspan tension, sag, lambda^2 with m = mu, to the printed digits.
 */
static void published_numbers(void **state)
{
    static const struct {
        const struct cable *cable;
        double tension, half_tension, sag, half_sag, lambda2, half_lambda2;
    } row[] = {{&pont, 4899.50e3, 5, 0.1975, 5e-5, 0.0728, 5e-5},
               {&seil1, 16.846e3, 0.5, 0.5160, 5e-5, 1.3265, 5e-5},
               {&seil2, 14.971e3, 0.5, 0.5822, 5e-5, 1.8946, 5e-5}};
    (void)state;

    for (int i = 0; i < 3; i++) {
        struct line s;
        struct line_point mid;

        assert_int_equal(line_solve(row[i].cable, &s), SW_OK);
        line_at(&s, s.cable.L0 / 2, &mid);
        near_abs(mid.tension, row[i].tension, row[i].half_tension);
        near_abs(line_sag(&s), row[i].sag, row[i].half_sag);
        near_abs(line_lambda2(&s, s.cable.mu), row[i].lambda2, row[i].half_lambda2);
    }
}

/* (A.109) as written, in long double: cancellation costs at most 1e-19 (span/sag)^2 here. */
static void points_of_a109(void **state)
{
    const struct cable inclined = {120, 2, 1e6, 9.81, 100, 35};
    const struct cable *const cable[] = {&pont, &seil2, &inclined};
    (void)state;

    for (int i = 0; i < 3; i++) {
        struct line s;

        assert_int_equal(line_solve(cable[i], &s), SW_OK);
        for (int k = 0; k <= 8; k++) {
            long double H = s.H, V = s.V, W = s.W, EA = s.cable.EA, L0 = s.cable.L0;
            long double theta = L0 * k / 8, v = V - W * theta / L0;
            struct line_point p;

            line_at(&s, (double)theta, &p);
            near_abs(p.x1, (double)(H * theta / EA + H * L0 / W * (asinhl(V / H) - asinhl(v / H))),
                     1e-12 * s.cable.L0);
            near_abs(p.x2,
                     (double)(W * theta / EA * (V / W - theta / (2 * L0)) +
                              H * L0 / W *
                                  (sqrtl(1 + V / H * (V / H)) - sqrtl(1 + v / H * (v / H)))),
                     1e-12 * s.cable.L0);
            near_rel(p.tension, (double)sqrtl(H * H + v * v), 1e-15);
        }
    }
}

/* The flexibility against differences of the chord, and the stiffness as its inverse. */
static void stiffness_by_differences(void **state)
{
    const struct cable slack = {300, 2, 1e6, 9.81, 100, -35};
    const struct cable *const cable[] = {&pont, &seil1, &slack};
    (void)state;

    for (int i = 0; i < 3; i++) {
        struct line s;
        double K[9];

        assert_int_equal(line_solve(cable[i], &s), SW_OK);
        line_stiffness(&s, K);
        for (int axis = 0; axis < 2; axis++) {
            struct line side[2];
            double step = 1e-5 * (s.cable.span - (i < 2 ? 0.999 * s.cable.span : 0));

            for (int j = 0; j < 2; j++) {
                struct cable moved = s.cable;

                *(axis == 0 ? &moved.span : &moved.drop) += j == 0 ? -step : step;
                assert_int_equal(line_solve(&moved, &side[j]), SW_OK);
            }
            near_abs(K[axis], (side[1].H - side[0].H) / (2 * step), 1e-6 * K[0]);
            near_abs(K[3 + axis], (side[1].V - side[0].V) / (2 * step), 1e-6 * K[0]);
        }
        assert_true(K[1] == K[3]);
    }
}

/* Across its plane the cable swings like a pendulum of length span under H: K33 = H/l, also found
 * from a sidewise displacement of the right end. */
static void stiffness_across(void **state)
{
    struct cable moved = seil2;
    double d = 1e-3, K[9];
    struct line s, t;
    (void)state;

    assert_int_equal(line_solve(&seil2, &s), SW_OK);
    line_stiffness(&s, K);
    moved.span = hypot(seil2.span, d);
    assert_int_equal(line_solve(&moved, &t), SW_OK);
    near_rel(K[8], t.H * (d / moved.span) / d, 1e-6); /* second order in d: K11 d^2/(2 l H) */
}

/* Theory section 5, own weight: nearly inextensible level catenary with end angle phi. */
static void stiffness_of_the_catenary(void **state)
{
    (void)state;
    for (double phi = 0.2; phi < 1.3; phi += 0.2) {
        double A = log((1 + sin(phi)) / cos(phi));             /* half span over H/w */
        struct cable c = {2 * tan(phi), 1, 1e12, 1, 2 * A, 0}; /* H = w = 1 */
        struct line s;
        double K[9], T, span = 2 * A;

        assert_int_equal(line_solve(&c, &s), SW_OK);
        near_rel(s.H, 1, 1e-9);
        T = 1 / cos(phi);
        line_stiffness(&s, K);
        near_rel(K[0] * span / T, 2 * cos(phi) * A / (2 * A - 2 * sin(phi)), 1e-9);
        near_rel(K[4] * span / T, A / tan(phi), 1e-9);
        near_rel(K[8] * span / T, cos(phi), 1e-9);
    }
}

/* Level cables from taut to slack: dH/dl = 1/[L0/EA + (2/w)(asinh a - a/sqrt(1 + a^2))], a = W/(2
 * H), in long double, where the difference costs a digit or two. */
static void stiffness_to_the_last_digits(void **state)
{
    (void)state;
    for (double longer = 1e-5; longer < 0.2; longer *= 1.3) {
        const struct cable c = {100 * (1 + longer), 1, 1e15, 10, 100, 0};
        struct line s;
        double K[9];
        long double a, slope;

        assert_int_equal(line_solve(&c, &s), SW_OK);
        line_stiffness(&s, K);
        a = (long double)s.W / (2 * (long double)s.H);
        slope = 2 * (long double)c.L0 / s.W * (asinhl(a) - a / sqrtl(1 + a * a));
        near_rel(1 / K[0], (double)(c.L0 / (long double)c.EA + slope), 1e-13);
    }
}

static void without_gravity(void **state)
{
    struct cable c = {100, 1, 1e6, 0, 80, 60.5};
    double chord = hypot(c.span, c.drop), T = c.EA * (chord / c.L0 - 1), K[9];
    struct line s;
    struct line_point p;
    (void)state;

    assert_int_equal(line_solve(&c, &s), SW_OK);
    near_rel(hypot(s.H, s.V), T, 1e-12);
    near_rel(s.V / s.H, c.drop / c.span, 1e-13);
    line_at(&s, 25, &p);
    near_rel(p.x1, c.span / 4, 1e-13);
    near_rel(p.x2, c.drop / 4, 1e-13);
    near_rel(line_length(&s), chord, 1e-13);
    line_stiffness(&s, K); /* EA/L0 along, T/chord across */
    near_rel(K[8], T / chord, 1e-11);
    near_rel(K[0] + K[4], c.EA / c.L0 + T / chord, 1e-11);
    c.g = 1e-9; /* the limit is smooth */
    assert_int_equal(line_solve(&c, &s), SW_OK);
    near_rel(hypot(s.H, s.V), T, 1e-9);
}

/* Length against Simpson's rule on the stretch; forces on the cut piece balance. */
static void length_and_balance(void **state)
{
    const struct cable c = {150, 3, 2e5, 9.81, 100, 35};
    struct line s;
    struct line_point p;
    double sum = 0;
    int n = 2000;
    (void)state;

    assert_int_equal(line_solve(&c, &s), SW_OK);
    for (int k = 0; k <= n; k++) {
        line_at(&s, c.L0 * k / n, &p);
        sum += p.stretch * (k == 0 || k == n ? 1 : k % 2 ? 4 : 2);
    }
    near_rel(line_length(&s), sum * c.L0 / n / 3, 1e-9);
    line_at(&s, c.L0 / 3, &p);
    near_rel(s.V - p.V, c.mu * c.g * c.L0 / 3, 1e-13);
    near_rel(p.tension, hypot(s.H, p.V), 1e-15);
}

/* A piece is a line of its own: its ends are points of the whole, it needs no other forces, and
 * solved anew it is the same. */
static void pieces(void **state)
{
    uint64_t seed = 31;
    (void)state;

    for (int i = 0; i < 2000; i++) {
        struct cable c = random_cable(&seed);
        struct line s, piece, again;
        struct line_point a, b, p;
        double from = uniform(&seed) * c.L0, to = from + uniform_in(&seed, 0.01, 1) * (c.L0 - from);
        double size, least;

        c.L0 = line_chord(&c) * uniform_in(&seed, 0.999, 3);
        from = fmin(from, 0.9 * c.L0);
        to = fmin(fmax(to, from + 0.01 * c.L0), c.L0);
        assert_int_equal(line_solve(&c, &s), SW_OK);
        size = 1e-14 * (line_chord(&c) + line_length(&s)); /* the subtraction below rounds */
        line_at(&s, from, &a);
        line_at(&s, to, &b);
        line_piece(&s, from, to, &piece);
        near_rel(piece.cable.L0, to - from, 0);
        near_rel(piece.W, s.W * (to - from) / c.L0, 1e-14);
        near_abs(piece.cable.span, b.x1 - a.x1, size);
        near_abs(piece.cable.drop, b.x2 - a.x2, size);
        near_abs(piece.V, a.V, 1e-14 * (s.W + fabs(s.V)));
        line_at(&piece, (to - from) / 3, &p);
        line_at(&s, from + (to - from) / 3, &b);
        near_abs(a.x1 + p.x1, b.x1, size);
        near_abs(a.x2 + p.x2, b.x2, size);
        near_rel(p.tension, b.tension, 1e-12);
        assert_int_equal(line_solve(&piece.cable, &again), SW_OK);
        least = fmin(fabs(piece.H), c.EA);
        /* the piece's length and chord round, which a stiff cable feels */
        near_abs(again.H, piece.H, 1e-11 * least + 1e-13 * c.EA);
    }
}

/* The whole cable as its own piece: to the last digits. */
static void whole_piece(void **state)
{
    struct line s, piece;
    (void)state;

    assert_int_equal(line_solve(&seil2, &s), SW_OK);
    line_piece(&s, 0, seil2.L0, &piece);
    near_rel(piece.cable.span, seil2.span, 1e-14);
    near_abs(piece.cable.drop, 0, 1e-14 * seil2.span);
    near_rel(piece.H, s.H, 0);
    near_rel(piece.V, s.V, 0);
}

/* Below the chord: the difference of places, the deepest of many; there the tangent lies along the
 * chord. */
static void below_the_chord(void **state)
{
    uint64_t seed = 32;
    (void)state;

    for (int i = 0; i < 2000; i++) {
        struct cable c = random_cable(&seed);
        struct line s;
        struct line_point p;
        double deepest, most, size;
        int n = 200;

        c.L0 = line_chord(&c) * uniform_in(&seed, 0.999, 3);
        assert_int_equal(line_solve(&c, &s), SW_OK);
        deepest = line_deepest(&s);
        /* steep: the chord's height over a point is uncertain by drop/span times its place */
        size = 1e-14 * (line_length(&s) + line_chord(&c)) * line_chord(&c) / c.span;
        assert_true(deepest > 0 && deepest < c.L0);
        most = line_below_chord(&s, deepest);
        assert_true(most > 0);
        for (int k = 1; k < n; k++) {
            double below_chord = line_below_chord(&s, c.L0 * k / n);

            line_at(&s, c.L0 * k / n, &p);
            near_abs(below_chord, p.x2 - p.x1 * (c.drop / c.span), size);
            assert_true(below_chord <= most * (1 + 1e-12));
        }
        line_at(&s, deepest, &p);
        near_abs(p.V / s.H, c.drop / c.span, 1e-12 * (1 + s.W / s.H + fabs(c.drop) / c.span));
        near_rel(line_sag(&s), line_below_chord(&s, c.L0 / 2), 0);
    }
}

/* Tauter than the places can tell: w x (l - x)/(2 H), where the difference of places is round-off
 * only.  Deepest at half span, and of a weightless cable at half length. */
static void sag_of_taut_cables(void **state)
{
    const struct cable taut = {100, 1e-9, 1e5, 9.81, 101, 0};
    struct cable weightless = taut;
    struct line s;
    (void)state;

    assert_int_equal(line_solve(&taut, &s), SW_OK);
    for (double part = 0.1; part < 1; part += 0.2) /* W/H = 1e-9: its square is lost */
        near_rel(line_below_chord(&s, part * 100), s.W * 101 * part * (1 - part) / 2 / s.H, 1e-13);
    near_rel(line_deepest(&s), 50, 1e-6); /* V of 1e-9 H, known to its 16 digits of H */
    weightless.g = 0;
    assert_int_equal(line_solve(&weightless, &s), SW_OK);
    near_abs(line_sag(&s), 0, 0);
    assert_true(line_deepest(&s) == 50);
}

/* An inextensible level catenary: H/w (cosh(v) - cosh(v - w x/H)) at the arc length of x. */
static void sag_of_the_catenary(void **state)
{
    const double v = 1.3; /* w l/(2 H), H = w = 1 */
    const struct cable c = {2 * sinh(v), 1, 1e13, 1, 2 * v, 0};
    struct line s;
    (void)state;

    assert_int_equal(line_solve(&c, &s), SW_OK);
    for (double x = 0.2; x < 2 * v - 0.1; x += 0.3)
        near_rel(line_below_chord(&s, sinh(v) - sinh(v - x)), cosh(v) - cosh(v - x), 1e-11);
}

/* Turned end for end: the same reactions, exchanged.  Metres to millimetres: the same digits. */
static void symmetries(void **state)
{
    const struct cable c = {113, 3, 2e5, 9.81, 100, 35};
    struct cable turned = c, scaled = {113e3, 3e-3, 2e5, 9.81, 100e3, 35e3};
    struct line s, t;
    (void)state;

    turned.drop = -c.drop;
    assert_int_equal(line_solve(&c, &s), SW_OK);
    assert_int_equal(line_solve(&turned, &t), SW_OK);
    near_rel(t.H, s.H, 1e-13);
    near_rel(t.V, s.W - s.V, 1e-13);
    assert_int_equal(line_solve(&scaled, &t), SW_OK); /* only the products mu L0, EA enter */
    near_rel(t.H, s.H, 1e-13);
    near_rel(t.V, s.V, 1e-13);
}

static void inadmissible_is_refused(void **state)
{
    struct line s;
    const struct cable bad[] = {
        {0, 1, 1e6, 9.81, 10, 0},  {-1, 1, 1e6, 9.81, 10, 0},        {NAN, 1, 1e6, 9.81, 10, 0},
        {10, 0, 1e6, 9.81, 10, 0}, {10, 1, 0, 9.81, 10, 0},          {10, 1, 1e6, -1, 10, 0},
        {10, 1, 1e6, 9.81, 0, 5},  {10, 1, 1e6, 9.81, 10, INFINITY}, {10, 1, 1e6, NAN, 10, 0},
        {10.1, 1, 1e6, 0, 10, 0},
    };
    (void)state;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_non_null(line_inadmissible(&bad[i]));
        assert_int_equal(line_solve(&bad[i], &s), SW_ADMISSIBLE);
    }
    assert_null(line_inadmissible(&pont));
}

TEST_MAIN(cmocka_unit_test(random_cables_close), cmocka_unit_test(soft_cables),
          cmocka_unit_test(published_numbers), cmocka_unit_test(points_of_a109),
          cmocka_unit_test(stiffness_by_differences), cmocka_unit_test(stiffness_across),
          cmocka_unit_test(stiffness_of_the_catenary),
          cmocka_unit_test(stiffness_to_the_last_digits), cmocka_unit_test(without_gravity),
          cmocka_unit_test(length_and_balance), cmocka_unit_test(pieces),
          cmocka_unit_test(whole_piece), cmocka_unit_test(below_the_chord),
          cmocka_unit_test(sag_of_taut_cables), cmocka_unit_test(sag_of_the_catenary),
          cmocka_unit_test(symmetries), cmocka_unit_test(inadmissible_is_refused))
