/* Root and least value of a function: known ones, both signs, flat, steep and broken functions. */
#include "check.h"

#include "num/root.h"

#include <float.h>

/* A function that counts its calls. */
struct counted {
    double (*f)(double x);
    int calls;
};

static double call(double x, void *context)
{
    struct counted *c = context;

    c->calls++;
    return c->f(x);
}

static double negative(double x, void *context)
{
    return -call(x, context);
}

static double cosine(double x)
{
    return cos(x) - x;
}

static double flat(double x)
{
    return pow(x - 1, 9);
}

static double steep(double x)
{
    return atan(1e12 * (x - 1e-5));
}

static double jump(double x)
{
    return x < PI ? -1 : 1;
}

static double line(double x)
{
    return 3 * x - 1;
}

static double tiny(double x)
{
    return x * x * x - 1e-60;
}

/* Like tension over slack: falls by powers of ten over the bracket. */
static double tension(double x)
{
    return 1 / (x * x) - 1e-6;
}

static double parabola(double x)
{
    return (x - 0.3) * (x - 0.3) + 2;
}

static double kink(double x)
{
    return fabs(x - 1.0 / 3);
}

static double broken(double x)
{
    return x > 0.5 && x < 0.6 ? NAN : x - 0.55;
}

static void known_roots(void **state)
{
    static const struct {
        double (*f)(double x);
        double a, b, root, tolerance;
        int calls; /* most that may be made; bisection to round-off takes 53 */
    } row[] = {
        {cosine, 0, 1, 0.73908513321516064, 4 * DBL_EPSILON, 12},
        {cosine, -1e6, 1e6, 0.73908513321516064, 4 * DBL_EPSILON, 80},
        {line, -1e9, 1e9, 1.0 / 3, 4 * DBL_EPSILON, 6},
        {flat, 0, 3, 1, 4 * DBL_EPSILON, 200},
        {steep, -1, 1, 1e-5, 4 * DBL_EPSILON, 120},
        {jump, 0, 10, PI, 4 * DBL_EPSILON, 60},
        {tiny, -1, 3, 1e-20, 4 * DBL_EPSILON, 200}, /* to round-off of x, however small it is */
        {tension, 1e-3, 1e9, 1e3, 4 * DBL_EPSILON, 80},
    };
    (void)state;

    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct counted c = {row[i].f, 0}, up = c;
        double x = root_between(call, &c, row[i].a, c.f(row[i].a), row[i].b, c.f(row[i].b));

        near_rel(x, row[i].root, row[i].tolerance);
        below(c.calls, row[i].calls + 1);
        /* other sign, other order of the ends: the same root */
        near_rel(root_between(negative, &up, row[i].b, -c.f(row[i].b), row[i].a, -c.f(row[i].a)),
                 row[i].root, row[i].tolerance);
        below(up.calls, row[i].calls + 1);
    }
}

static void root_at_an_end(void **state)
{
    struct counted c = {line, 0};
    (void)state;

    assert_true(root_between(call, &c, 2, 0, 5, 1) == 2);
    assert_true(root_between(call, &c, 2, -1, 5, 0) == 5);
    assert_int_equal(c.calls, 0);
    assert_true(root_between(call, &c, 2, -1, 2, 1) == 2); /* nothing between them */
}

/* Where the function breaks, NAN, and no more calls. */
static void broken_function(void **state)
{
    struct counted c = {broken, 0};
    double f;
    (void)state;

    assert_true(isnan(root_between(call, &c, 0, -0.55, 1, 0.45)));
    below(c.calls, 60);
    c.calls = 0;
    assert_true(isnan(least_between(call, &c, 0.4, 0.7, &f)));
    below(c.calls, 10);
}

/* The least value is flat: its place is known to sqrt(epsilon), itself to epsilon. */
static void least_values(void **state)
{
    struct counted c = {parabola, 0}, k = {kink, 0}, l = {line, 0};
    double f;
    (void)state;

    near_abs(least_between(call, &c, -10, 20, &f), 0.3, 1e-7);
    near_abs(f, 2, 1e-14);
    below(c.calls, 70); /* 1e-9 of 30 by steps of 0.618 */
    near_abs(least_between(call, &k, -1, 1, &f), 1.0 / 3, 2e-9);
    below(f, 2e-9);
    near_abs(least_between(call, &l, 2, 3, &f), 2, 1e-8); /* at an end */
    near_abs(f, 5, 1e-7);
}

TEST_MAIN(cmocka_unit_test(known_roots), cmocka_unit_test(root_at_an_end),
          cmocka_unit_test(broken_function), cmocka_unit_test(least_values))
