/*
 * What the unit tests share: cmocka, comparison of doubles, the cables of the thesis.
 */
#ifndef SEILWERK_TESTS_CHECK_H
#define SEILWERK_TESTS_CHECK_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#undef fail /* of cmocka; sys/err.h has a function of this name */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "num/pi.h"
#include "phys/line.h"

/* |x - wanted| <= tolerance; NaN fails. */
#define near_abs(x, wanted, tolerance) near_((x), (wanted), (tolerance), #x, __FILE__, __LINE__)

/* |x - wanted| <= tolerance |wanted|. */
#define near_rel(x, wanted, tolerance)                                                             \
    near_((x), (wanted), (tolerance)*fabs((double)(wanted)), #x, __FILE__, __LINE__)

static inline void near_(double x, double wanted, double tolerance, const char *what,
                         const char *file, int line)
{
    if (fabs(x - wanted) <= tolerance)
        return;
    print_error("%s = %.17g, wanted %.17g within %.3g, is off by %.3g\n", what, x, wanted,
                tolerance, x - wanted);
    _fail(file, line);
}

/* x < limit, printed when it is not; NaN fails. */
#define below(x, limit) below_((x), (limit), #x, __FILE__, __LINE__)

static inline void below_(double x, double limit, const char *what, const char *file, int line)
{
    if (x < limit)
        return;
    print_error("%s = %.17g is not below %.3g\n", what, x, limit);
    _fail(file, line);
}

/* Uniform in [0, 1), own generator: the same numbers on every machine. */
static inline double uniform(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static inline double uniform_in(uint64_t *state, double low, double high)
{
    return low + (high - low) * uniform(state);
}

/* Logarithm uniform. */
static inline double log_uniform(uint64_t *state, double low, double high)
{
    return exp(uniform_in(state, log(low), log(high)));
}

static const struct cable pont = {110.1897, 64.8, 2.1e11 * 8.26e-3, 9.81, 110.5, 0};
static const struct cable seil1 = {100.282, 0.704, 1.5556e11 * 8.48e-5, 9.81, 100.403, 0};
static const struct cable seil2 = {100.429, 0.704, 1.5556e11 * 8.48e-5, 9.81, 100.534, 0};

/* One group a program: cmocka prints TAP that prove accepts for one only. */
#define TEST_MAIN(...)                                                                             \
    int main(void)                                                                                 \
    {                                                                                              \
        const struct CMUnitTest tests[] = {__VA_ARGS__};                                           \
        return cmocka_run_group_tests(tests, NULL, NULL);                                          \
    }

#endif
