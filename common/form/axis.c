/* Axes of contours. */
#include "form/axis.h"
#include "sys/number.h"

#include <math.h>
#include <string.h>

#define VALUES 41

/* About the present value. */
static void range_about(double x, double unit, struct axis *ret)
{
    double by = unit < 1 ? 10 : x == 0 ? 1 : fabs(x) / 2;

    ret->from = x - by;
    ret->to = x + by;
    ret->n = VALUES;
}

/* FROM:TO:N, which is cut up. */
static int read_range(char *from, struct axis *ret)
{
    char *to = strchr(from, ':'), *n = to ? strchr(to + 1, ':') : NULL;

    if (!n)
        return 0;
    *to++ = *n++ = '\0';
    return !number_read(from, &ret->from) && !number_read(to, &ret->to) &&
           !integer_read(n, 2, 10000, &ret->n) && ret->from != ret->to;
}

static enum status axis_read(const char *text, size_t length, const struct lift_given *g,
                             struct axis *ret, struct why *why)
{
    char copy[200], *range;
    int tolerance;
    double unit;

    snprintf(copy, sizeof copy, "%.*s", (int)length, text);
    range = strchr(copy, '=');
    if (range)
        *range++ = '\0';
    ret->number = lift_column(copy, &tolerance);
    if (ret->number < 0 || tolerance || !lift_is_input(ret->number))
        return fail(why, SW_USAGE, "--contour: '%s' is no number that a height depends on", copy);
    lift_name(ret->number, ret->name);
    unit = lift_unit(ret->number);
    if (range && !read_range(range, ret))
        return fail(why, SW_USAGE, "--contour %s: expected FROM:TO:N, N from 2 to 10000", copy);
    if (!range && isnan(g->x[ret->number]))
        return fail(why, SW_USAGE, "--contour %s: has no value; expected COLUMN=FROM:TO:N", copy);
    if (!range)
        range_about(g->x[ret->number] / unit, unit, ret);
    return SW_OK;
}

enum status axes_read(const char *text, const struct lift_given *g, struct axis *ret_a,
                      struct axis *ret_b, struct why *why)
{
    const char *comma = strchr(text, ',');
    enum status s;

    if (!comma || strchr(comma + 1, ','))
        return fail(why, SW_USAGE, "--contour %.100s: expected two columns, a comma between", text);
    s = axis_read(text, (size_t)(comma - text), g, ret_a, why);
    if (s == SW_OK)
        s = axis_read(comma + 1, strlen(comma + 1), g, ret_b, why);
    if (s == SW_OK && ret_a->number == ret_b->number)
        return fail(why, SW_USAGE, "--contour %.100s: both columns are the same", text);
    return s;
}

double axis_value(const struct axis *a, long k)
{
    return a->from + (a->to - a->from) * ((double)k / (double)(a->n - 1));
}
