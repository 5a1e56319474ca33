/*
 * Numbers known to lie in an interval, with intervals for their derivatives: enclosures of a
 * formula and of its gradient over a box of its inputs (interval arithmetic, forward
 * differentiation).
 *
 * Every result is widened by its rounding error, so that the enclosure holds in exact arithmetic.
 * Values are passed and returned as structs; nothing is allocated.
 */
#ifndef SEILWERK_NUM_SPAN_H
#define SEILWERK_NUM_SPAN_H

#define SPAN_INPUTS 52

struct span {
    int n;                                     /* inputs; SPAN_NONE: no number at all */
    double lo, hi;                             /* the value */
    double dlo[SPAN_INPUTS], dhi[SPAN_INPUTS]; /* its derivatives by the inputs */
};

#define SPAN_NONE -1

/* x of n inputs that it does not depend on; the input i itself in [lo, hi], i < n; no number. */
struct span span_of(int n, double x);
struct span span_input(int n, int i, double lo, double hi);
struct span span_none(void);

struct span span_add(struct span a, struct span b);
struct span span_sub(struct span a, struct span b);
struct span span_mul(struct span a, struct span b);
struct span span_div(struct span a, struct span b); /* unbounded where b holds 0 */
struct span span_square(struct span a);
struct span span_root(struct span a); /* a.lo > 0 */
struct span span_tan(struct span a);  /* within (-pi/2, pi/2) */
struct span span_cos(struct span a);  /* within [0, pi/2) */
struct span span_min(struct span a, struct span b);

/* a or b, as some condition on x says: derivatives by what x depends on are unbounded. */
struct span span_either(struct span a, struct span b, struct span x);

#endif
