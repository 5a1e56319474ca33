/* Numbers as text: examples, round trips over random bit patterns, shortness, refusals. */
#include "check.h"

#include "sys/number.h"

#include <float.h>
#include <inttypes.h>
#include <string.h>

#define RANDOM_NUMBERS 2000000 /* or the environment's SEILWERK_NUMBERS */
#define SHORTEST_NUMBERS 200000

/* A printed number taken apart: x = digits 10^exponent, digits without zeros at the end. */
struct decimal {
    uint64_t digits;
    int n, exponent;
};

static struct decimal take_apart(const char *text)
{
    struct decimal d = {0, 0, 0};
    int behind_point = 0;

    for (; *text && *text != 'e'; text++) {
        if (*text == '.')
            behind_point = 1;
        if (*text < '0' || *text > '9')
            continue;
        d.digits = 10 * d.digits + (uint64_t)(*text - '0');
        d.exponent -= behind_point;
    }
    if (*text == 'e')
        d.exponent += (int)strtol(text + 1, NULL, 10);
    while (d.digits != 0 && d.digits % 10 == 0) {
        d.digits /= 10;
        d.exponent++;
    }
    for (uint64_t rest = d.digits; rest != 0; rest /= 10)
        d.n++;
    return d;
}

static double from_parts(uint64_t digits, int exponent)
{
    char text[40];

    snprintf(text, sizeof text, "%" PRIu64 "e%d", digits, exponent);
    return strtod(text, NULL);
}

static double from_bits(uint64_t bits)
{
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint64_t next_bits(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state * 2685821657736338717u;
}

/* Read back as the same double, by our reader and the C library's. */
static void round_trip(double x)
{
    char text[NUMBER_SIZE];
    size_t length = number_print(x, text);
    double back = 0;
    const char *reason = number_read(text, &back);

    if (length == strlen(text) && length < NUMBER_SIZE && !reason && back == x &&
        strtod(text, NULL) == x)
        return;
    print_error("%a is printed as %s, %s, and read back as %a\n", x, text,
                reason ? reason : "accepted", back);
    assert_true(0);
}

/* No decimal with one digit less reads back, and the printed one is the nearest of its length. */
static void is_shortest(double x)
{
    char text[NUMBER_SIZE], nearest[40];
    struct decimal d, e;

    number_print(x, text);
    d = take_apart(text);
    x = fabs(x);
    assert_in_range(d.n, 1, 17);
    for (uint64_t up = 0; up <= 1 && d.n > 1; up++)
        if (from_parts(d.digits / 10 + up, d.exponent + 1) == x) {
            print_error("%a is printed as %s, which is too long\n", x, text);
            assert_true(0);
        }
    snprintf(nearest, sizeof nearest, "%.*e", d.n - 1, x);
    e = take_apart(nearest);
    if (strtod(nearest, NULL) == x && (d.digits != e.digits || d.exponent != e.exponent)) {
        print_error("%a is printed as %s, but %s is nearer\n", x, text, nearest);
        assert_true(0);
    }
}

static void examples(void **state)
{
    static const struct {
        double x;
        const char *text;
    } table[] = {
        {0.1, "0.1"},
        {5e-324, "5e-324"},
        {1.7976931348623157e308, "1.7976931348623157e308"},
        {2.2250738585072014e-308, "2.2250738585072014e-308"},
        {2.225073858507201e-308, "2.225073858507201e-308"},
        {1e17, "1e17"},
        {123456789012345680, "1.2345678901234568e17"},
        {99999999999999984, "99999999999999980"},
        {10000000000000000, "10000000000000000"},
        {9007199254740993.0, "9007199254740992"},
        {9007199254740992, "9007199254740992"},
        {9007199254740994, "9007199254740994"},
        {1e23, "1e23"},
        {9.5e-3, "0.0095"},
        {0.00001, "0.00001"},
        {1.5e-5, "0.000015"},
        {9.999e-6, "9.999e-6"},
        {1.5e-6, "1.5e-6"},
        {1e-6, "1e-6"},
        {1, "1"},
        {-1, "-1"},
        {100, "100"},
        {-123.456, "-123.456"},
        {0.3, "0.3"},
        {0.1 + 0.2, "0.30000000000000004"},
        {1.0 / 3, "0.3333333333333333"},
        {-2.0 / 3, "-0.6666666666666666"},
        {2e-323, "2e-323"},
        {9.5367431640625e-7, "9.5367431640625e-7"},
        {4.35, "4.35"},
        {0.000123, "0.000123"},
        {-1e-300, "-1e-300"},
        {0, "0"},
        {-0.0, "0"},
        {(double)NAN, "nan"},
        {-(double)NAN, "nan"},
        {INFINITY, "inf"},
        {-INFINITY, "-inf"},
    };
    (void)state;

    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        char text[NUMBER_SIZE];

        assert_int_equal(number_print(table[i].x, text), strlen(table[i].text));
        assert_string_equal(text, table[i].text);
    }
}

static void powers_of_ten(void **state)
{
    (void)state;
    for (int k = -323; k <= 308; k++) {
        char wanted[40], text[NUMBER_SIZE];
        double x = from_parts(1, k);

        if (k >= 17 || k < -5)
            snprintf(wanted, sizeof wanted, "1e%d", k);
        else
            snprintf(wanted, sizeof wanted, "%.*f", k < 0 ? -k : 0, x);
        number_print(x, text);
        assert_string_equal(text, wanted);
        round_trip(x);
    }
}

/* Below a power of two doubles lie closer than above: the one uneven rounding interval. */
static void powers_of_two(void **state)
{
    (void)state;
    for (int e = -1074; e <= 1023; e++)
        for (int side = -1; side <= 1; side++) {
            double x = ldexp(1, e);

            x = side == 0 ? x : nextafter(x, side > 0 ? INFINITY : 0);
            if (x == 0)
                continue;
            round_trip(x);
            is_shortest(x);
        }
}

/* All numbers with up to four digits and some exponents print as they are written. */
static void short_numbers(void **state)
{
    (void)state;
    for (int digits = 1; digits < 10000; digits++)
        for (int k = -30; k <= 30; k += 3) {
            char text[NUMBER_SIZE];
            struct decimal d;
            uint64_t wanted = (uint64_t)digits;
            int exponent = k;

            number_print(from_parts(wanted, k), text);
            d = take_apart(text);
            for (; wanted % 10 == 0; wanted /= 10)
                exponent++;
            assert_true(d.digits == wanted && d.exponent == exponent);
        }
}

static void random_round_trips(void **state)
{
    const char *count = getenv("SEILWERK_NUMBERS");
    uint64_t seed = 20241105, tried = 0;
    uint64_t wanted = count ? strtoull(count, NULL, 10) : RANDOM_NUMBERS;
    (void)state;

    print_message("# seed %" PRIu64 ", %" PRIu64 " numbers\n", seed, wanted);
    while (tried < wanted) {
        double x = from_bits(next_bits(&seed));

        if (!isfinite(x))
            continue;
        round_trip(x);
        tried++;
    }
}

/* Random bits, then numbers of the usual size, whole numbers and subnormal ones. */
static void random_shortest(void **state)
{
    uint64_t seed = 314159;
    (void)state;

    print_message("# seed %" PRIu64 "\n", seed);
    for (int i = 0; i < SHORTEST_NUMBERS; i++) {
        uint64_t bits = next_bits(&seed);
        double x = from_bits(bits);

        switch (i % 4) {
        case 1: x = ldexp((double)(bits >> 11), -(int)(bits % 64)); break;
        case 2: x = (double)(bits >> (bits % 64)); break;
        case 3: x = from_bits(bits >> 12 >> bits % 52); break;
        default: break;
        }
        if (!isfinite(x) || x == 0)
            continue;
        round_trip(x);
        is_shortest(x);
    }
}

static void read_numbers(void **state)
{
    static const struct {
        const char *text;
        double x;
    } table[] = {
        {"0", 0},
        {"-0", 0},
        {"+1", 1},
        {"1.", 1},
        {".5", 0.5},
        {"-.5", -0.5},
        {"1e3", 1000},
        {"1E+3", 1000},
        {"1e-3", 0.001},
        {"007", 7},
        {"1e-400", 0},
        {"2.1e11", 2.1e11},
        {"1e308", 1e308},
        {"0.1", 0.1},
        {"4.9e-324", 5e-324},
        {"00000000000000000000001", 1},
    };
    (void)state;

    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double x = 42;
        const char *reason = number_read(table[i].text, &x);

        if (reason || x != table[i].x)
            print_error("'%s': %s, %g\n", table[i].text, reason ? reason : "accepted", x);
        assert_null(reason);
        assert_true(x == table[i].x);
    }
}

static void refuse_numbers(void **state)
{
    static const char *const not [] = {"x",     "1x",    "1 ",       " 1",   "1 2",      "nan",
                                       "NaN",   "-nan",  "inf",      "-Inf", "infinity", "0x10",
                                       "1e",    "1e+",   "-",        "+",    ".",        "e5",
                                       "--1",   "1.2.3", "1e5.5",    "\t1",  "1\n",      "1d5",
                                       "1_000", "1'000", "\302\2401"};
    static const char *const large[] = {"1e400", "-1e309", "1.8e308"};
    static const char *const comma[] = {"1,5", "1,", ",", "1,000.5"};
    double x = 42;
    (void)state;

    assert_string_equal(number_read("", &x), "a number is missing");
    for (size_t i = 0; i < sizeof not / sizeof *not ; i++) {
        const char *reason = number_read(not [i], &x);

        if (!reason)
            print_error("'%s' is accepted\n", not [i]);
        assert_string_equal(reason, "not a number");
    }
    for (size_t i = 0; i < sizeof large / sizeof *large; i++)
        assert_string_equal(number_read(large[i], &x), "the number is too large");
    for (size_t i = 0; i < sizeof comma / sizeof *comma; i++)
        assert_string_equal(number_read(comma[i], &x), "a decimal point is expected, not a comma");
    assert_true(x == 42);
}

static void whole_numbers(void **state)
{
    static const char *const not [] = {"",    "x",   "1.0", "1e3", " 1",  "1 ",
                                       "1,0", "0x1", "-",   "1\n", "one", "1-"};
    long i = 42;
    (void)state;

    assert_null(integer_read("1", 1, 3, &i));
    assert_int_equal(i, 1);
    assert_null(integer_read("3", 1, 3, &i));
    assert_int_equal(i, 3);
    assert_null(integer_read("-5", -5, -5, &i));
    assert_int_equal(i, -5);
    assert_null(integer_read("010", 0, 100, &i));
    assert_int_equal(i, 10);
    i = 42;
    for (size_t k = 0; k < sizeof not / sizeof *not ; k++) {
        const char *reason = integer_read(not [k], -100, 100, &i);

        if (!reason)
            print_error("'%s' is accepted\n", not [k]);
        assert_string_equal(reason, "not a whole number");
    }
    assert_string_equal(integer_read("0", 1, 3, &i), "the number is too small");
    assert_string_equal(integer_read("4", 1, 3, &i), "the number is too large");
    assert_string_equal(integer_read("99999999999999999999", 1, 3, &i), "the number is too large");
    assert_string_equal(integer_read("-99999999999999999999", 1, 3, &i), "the number is too small");
    assert_int_equal(i, 42);
}

TEST_MAIN(cmocka_unit_test(examples), cmocka_unit_test(powers_of_ten),
          cmocka_unit_test(powers_of_two), cmocka_unit_test(short_numbers),
          cmocka_unit_test(random_round_trips), cmocka_unit_test(random_shortest),
          cmocka_unit_test(read_numbers), cmocka_unit_test(refuse_numbers),
          cmocka_unit_test(whole_numbers))
