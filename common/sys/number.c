/*
 * Shortest printing by R. Giulietti's Schubfach ("The Schubfach way to render doubles", 2020):
 * of all decimals in the rounding interval of x take one with the fewest digits, nearest to x.
 *
 * The scaled interval is computed with 128-bit upper approximations g(k) of 10^k.  These 617
 * values are not stored as a table of constants but made on first use, by exact multiplication or
 * division of a long number by ten (about 0.05 ms once).
 */
#include "sys/number.h"
#include "sys/err.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define K_MIN (-292)
#define K_MAX 324

/* Length of a long number in words of 64 bits: 10^324 is below 2^1077, and 10^-292 with 128 digits
 * takes 1098 bits after the point. */
#define WORDS 19

__extension__ typedef unsigned __int128 u128;

struct g {
    uint64_t hi, lo;
};

static struct g power[K_MAX - K_MIN + 1];

/* The 128 leading bits of the long number w, rounded up. */
static struct g leading(const uint64_t w[WORDS])
{
    int top = WORDS - 1, shift;
    struct g g;
    uint64_t rest;

    while (w[top] == 0)
        top--;
    shift = __builtin_clzll(w[top]);
    g.hi = w[top] << shift;
    g.lo = top > 0 ? w[top - 1] << shift : 0;
    rest = top > 1 ? w[top - 2] << shift : 0;
    if (shift > 0) {
        g.hi |= top > 0 ? w[top - 1] >> (64 - shift) : 0;
        g.lo |= top > 1 ? w[top - 2] >> (64 - shift) : 0;
    }
    for (int i = 0; i < top - 2; i++)
        rest |= w[i];
    g.lo += rest != 0;
    g.hi += rest != 0 && g.lo == 0;
    return g;
}

static void make_powers(void)
{
    uint64_t w[WORDS] = {1};

    for (int k = 0; k <= K_MAX; k++) {
        u128 carry = 0;

        power[k - K_MIN] = leading(w);
        for (int i = 0; i < WORDS; i++) {
            carry += (u128)w[i] * 10;
            w[i] = (uint64_t)carry;
            carry >>= 64;
        }
    }
    memset(w, 0, sizeof w);
    w[WORDS - 1] = 1; /* the point stands right below; floors of floors are exact floors */
    for (int k = 0; k > K_MIN;) {
        u128 rest = 0;

        for (int i = WORDS - 1; i >= 0; i--) {
            rest = rest << 64 | w[i];
            w[i] = (uint64_t)(rest / 10);
            rest %= 10;
        }
        w[0] |= rest != 0; /* cut off below: still to be rounded up */
        power[--k - K_MIN] = leading(w);
    }
}

static int floor_log10_pow2(int e)
{
    return (e * 1262611) >> 22;
}

static int floor_log10_three_quarters_pow2(int e)
{
    return (e * 1262611 - 524031) >> 22;
}

static int floor_log2_pow10(int e)
{
    return (e * 1741647) >> 19;
}

/* Upper 64 bits of g c, rounded to odd: the lowest bit also tells that something was cut off. */
static uint64_t round_to_odd(struct g g, uint64_t c)
{
    u128 y = (u128)g.hi * c + (uint64_t)(((u128)g.lo * c) >> 64);

    return (uint64_t)(y >> 64) | ((uint64_t)y > 1);
}

/* Decimal digits d and exponent k with x = d 10^k to reading precision, for x = c 2^q > 0. */
static uint64_t shortest(uint64_t c, int q, int power_of_two, int *ret_k)
{
    int odd = c & 1;
    int k = power_of_two ? floor_log10_three_quarters_pow2(q) : floor_log10_pow2(q);
    int h = q + floor_log2_pow10(-k) + 1;
    struct g g = power[-k - K_MIN];
    uint64_t lower = round_to_odd(g, (4 * c - 2 + (uint64_t)power_of_two) << h) + (uint64_t)odd;
    uint64_t v = round_to_odd(g, (4 * c) << h);
    uint64_t upper = round_to_odd(g, (4 * c + 2) << h) - (uint64_t)odd;
    uint64_t s = v / 4, middle = 4 * s + 2;
    int down, up;

    if (s >= 10) { /* one digit less */
        uint64_t t = s / 10;

        down = lower <= 40 * t;
        up = 40 * t + 40 <= upper;
        if (down != up) {
            *ret_k = k + 1;
            return t + (uint64_t)up;
        }
    }
    *ret_k = k;
    down = lower <= 4 * s;
    up = 4 * s + 4 <= upper;
    if (down != up)
        return s + (uint64_t)up;
    return s + (v > middle || (v == middle && (s & 1)));
}

static uint64_t to_decimal(double x, int *ret_k)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    uint64_t bits, fraction, d;
    int exponent;

    memcpy(&bits, &x, sizeof bits);
    fraction = bits & 0xfffffffffffff;
    exponent = (int)(bits >> 52 & 0x7ff);
    if (exponent >= 1023 && exponent <= 1075) { /* a whole number below 2^53? */
        uint64_t c = fraction | 1ULL << 52;
        int below = 1075 - exponent;

        if ((c & ((1ULL << below) - 1)) == 0) {
            *ret_k = 0;
            return c >> below;
        }
    }
    pthread_once(&once, make_powers);
    if (exponent == 0)
        d = shortest(fraction, -1074, 0, ret_k);
    else
        d = shortest(fraction | 1ULL << 52, exponent - 1075, fraction == 0 && exponent > 1, ret_k);
    return d;
}

/* Digits of d > 0 at the end of buf[20]; returns the first. */
static char *digits_of(uint64_t d, char *end)
{
    while (d > 0) {
        *--end = (char)('0' + d % 10);
        d /= 10;
    }
    return end;
}

/* Text of 0.digits 10^point, n digits. */
static char *lay_out(const char *digits, int n, int point, char *to)
{
    if (point > 17 || point < -4) {
        char exponent[8], *first;
        int e = point - 1;

        *to++ = digits[0];
        if (n > 1) {
            *to++ = '.';
            memcpy(to, digits + 1, (size_t)(n - 1));
            to += n - 1;
        }
        *to++ = 'e';
        if (e < 0)
            *to++ = '-';
        first = digits_of((uint64_t)(e < 0 ? -e : e), exponent + sizeof exponent);
        while (first < exponent + sizeof exponent)
            *to++ = *first++;
        return to;
    }
    if (point <= 0) {
        *to++ = '0';
        *to++ = '.';
        for (int i = point; i < 0; i++)
            *to++ = '0';
    }
    for (int i = 0; i < n || i < point; i++) {
        if (i == point && i > 0)
            *to++ = '.';
        *to++ = i < n ? digits[i] : '0';
    }
    return to;
}

size_t number_print(double x, char ret[NUMBER_SIZE])
{
    char buffer[20], *first, *to = ret;
    uint64_t d;
    int k;

    if (!isfinite(x) || x == 0) {
        const char *word = x == 0 ? "0" : isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
        size_t length = strlen(word);

        memcpy(ret, word, length + 1);
        return length;
    }
    if (x < 0)
        *to++ = '-';
    d = to_decimal(fabs(x), &k);
    while (d % 10 == 0) {
        d /= 10;
        k++;
    }
    first = digits_of(d, buffer + sizeof buffer);
    k += (int)(buffer + sizeof buffer - first);
    to = lay_out(first, (int)(buffer + sizeof buffer - first), k, to);
    *to = '\0';
    return (size_t)(to - ret);
}

const char *number_read(const char *text, double *ret)
{
    char *end;
    double x;

    if (*text == '\0')
        return "a number is missing";
    if (strchr(text, ','))
        return "a decimal point is expected, not a comma";
    if (isspace((unsigned char)*text) || strpbrk(text, "xXnNiI"))
        return "not a number";
    x = strtod(text, &end);
    if (end == text || *end != '\0')
        return "not a number";
    if (!isfinite(x))
        return "the number is too large";
    *ret = x;
    return NULL;
}

const char *integer_read(const char *text, long min, long max, long *ret)
{
    char *end;
    long i;

    errno = 0;
    i = strtol(text, &end, 10);
    if (end == text || *end != '\0' || isspace((unsigned char)*text))
        return "not a whole number";
    if (i > max || (errno != 0 && i > 0))
        return "the number is too large";
    if (i < min || errno != 0)
        return "the number is too small";
    *ret = i;
    return NULL;
}

enum status numbers_read(const char *text, int n, double *ret, struct why *why)
{
    const char *p = text;

    for (int i = 0; i < n; i++) {
        char word[64];
        size_t length = strcspn(p, ",");
        const char *reason;

        if ((p[length] == ',') != (i < n - 1) || length == 0 || length >= sizeof word)
            return fail(why, SW_USAGE, "'%.60s': %d numbers are expected, commas between them",
                        text, n);
        memcpy(word, p, length);
        word[length] = '\0';
        reason = number_read(word, &ret[i]);
        if (reason)
            return fail(why, SW_USAGE, "'%s': %s", word, reason);
        p += length + 1;
    }
    return SW_OK;
}
