/* The unstressed length that gives a known force, sag or frequency. */
#include "phys/find.h"
#include "num/pi.h"
#include "num/root.h"
#include "phys/modes.h"

#include <math.h>

#define LONGEST 1e9           /* length [m] at which the search ends */
#define SLACKEST 100          /* chords at which it ends for a frequency */
#define MOST_STRETCHED 1e3    /* strain of the chord at which it begins at the latest */
#define LEAST_STRETCHED 1e-15 /* and at which that of a weightless cable ends */

/*
 * The search runs over s: the hot unstressed length is chord/(1 - s) where s < 0, a stretched
 * chord, and chord (1 + s) where the cable is longer.  Forces and frequencies fall with s at first;
 * so does minus the sag.
 */
struct search {
    const struct cable *c;
    const struct load *load;
    const struct known *known;
    enum status failed; /* SW_NOMEM and the like, met on the way */
    double least;       /* least value seen */
};

static double length_of(const struct search *f, double s)
{
    double d = line_chord(f->c);

    return load_cold_length(f->load, s < 0 ? d / (1 - s) : d * (1 + s));
}

double find_sag(const struct line *s, const struct axes *axes, double theta)
{
    const struct cable *c = &s->cable;
    const double plane[3] = {c->span, c->drop, 0};
    double chord[3];

    axes_to_space(axes, plane, chord);
    return line_below_chord(s, theta) * (axes->e[1][1] - chord[1] / chord[0] * axes->e[1][0]);
}

static double frequency(struct search *f, const struct cable *c, const struct axes *axes)
{
    struct model m;
    double omega = NAN;
    enum status s = model_new(c, f->known->law, f->known->elements, &m);

    if (s == SW_OK) {
        m.axes = *axes;
        s = modes_of_part(&m, f->known->part, f->known->mode, &omega);
        model_free(&m);
    }
    if (s != SW_OK)
        f->failed = s;
    return omega / (2 * PI);
}

/* The line at the length of s, in the plane of its load. */
static enum status hang(const struct search *f, double s, struct line *ret, struct axes *ret_axes)
{
    struct cable c = *f->c, hung;

    c.L0 = length_of(f, s);
    load_apply(&c, f->load, &hung, ret_axes);
    return line_solve(&hung, ret);
}

/* The known quantity at the length of s, or NAN. */
static double quantity(struct search *f, double s)
{
    struct axes axes;
    struct line line;
    struct line_point p;

    if (hang(f, s, &line, &axes) != SW_OK)
        return NAN;
    switch (f->known->given) {
    case GIVEN_HORIZONTAL: return line.H * axes.e[0][0] + line.V * axes.e[1][0];
    case GIVEN_MIDSPAN: line_at(&line, line.cable.L0 / 2, &p); return p.tension;
    case GIVEN_LEFT: return hypot(line.H, line.V);
    case GIVEN_RIGHT: return hypot(line.H, line.V - line.W);
    case GIVEN_SAG: return find_sag(&line, &axes, line.cable.L0 / 2);
    default: return frequency(f, &line.cable, &axes);
    }
}

/* What falls through zero at the tauter cable that is looked for. */
static double excess(double s, void *context)
{
    struct search *f = context;
    double x = quantity(f, s);

    f->least = fmin(f->least, x);
    return f->known->given == GIVEN_SAG ? f->known->value - x : x - f->known->value;
}

/* A strain of the chord that is likely to give more than is known. */
static double first_strain(const struct search *f)
{
    const struct cable *c = f->c;
    double d = line_chord(c), x = f->known->value, speed = 2 * d * x / f->known->mode;

    if (f->known->given == GIVEN_SAG)
        return 1e-4;
    if (f->known->given == GIVEN_FREQUENCY)
        return fmax(1e-12, 2 * (c->mu + f->load->ice) * speed * speed / c->EA);
    return fmax(1e-12, 1.5 * x * d / c->span / c->EA);
}

struct bracket {
    double a, fa, b, fb;
};

static double minus_excess(double s, void *context)
{
    return -excess(s, context);
}

/* Both sides of the crossing number wanted (1, 2) of three neighbours s with the value v[1] nearest
 * to zero, if there is a value of the other sign between them. */
static int cross_at_extreme(struct search *f, const double s[3], const double v[3], int wanted,
                            struct bracket *ret)
{
    int above = v[1] > 0;
    double x, at = least_between(above ? excess : minus_excess, f, s[0], s[2], &x);

    if (!(x <= 0))
        return 0;
    x = above ? x : -x;
    *ret = wanted == 1 ? (struct bracket){s[0], v[0], at, x} : (struct bracket){at, x, s[2], v[2]};
    return 1;
}

/*
 * The place after s, about a step on, which grows.  Frequencies in the plane fall, rise and fall
 * again while the tension halves (Irvine's lambda^2 grows by its third power): it may fall by a
 * seventh at a time.
 */
static double next_place(const struct search *f, double s, double *step)
{
    struct axes axes;
    struct line here, there;
    double next;

    if (f->known->given == GIVEN_FREQUENCY && f->known->part == PART_PLANE &&
        hang(f, s, &here, &axes) == SW_OK)
        while (hang(f, s + *step, &there, &axes) == SW_OK && there.H < 0.86 * here.H)
            *step /= 2;
    next = s + *step;
    *step *= 2;
    return next;
}

/* Whether nothing loads the cable; wind and weight may balance. */
static int is_weightless(const struct search *f)
{
    struct cable hung;
    struct axes axes;

    load_apply(f->c, f->load, &hung, &axes);
    return hung.g == 0;
}

/*
 * Go from taut to slack in growing steps until the wanted crossing lies between two of them.  A
 * weightless cable is only ever stretched.
 */
static int find_bracket(struct search *f, double strain, struct bracket *ret)
{
    int weightless = is_weightless(f), crossings = 0, wanted = f->known->slack ? 2 : 1;
    double s[3] = {0, 0, -strain}, v[3] = {NAN, NAN, excess(-strain, f)}, step = strain / 2;

    while (f->failed == SW_OK) {
        double next = weightless ? s[2] / 2 : next_place(f, s[2], &step);
        double limit = f->known->given == GIVEN_FREQUENCY ? SLACKEST * line_chord(f->c) : LONGEST;

        if (length_of(f, next) > limit || (weightless && -next < LEAST_STRETCHED))
            return 0;
        for (int i = 0; i < 2; i++) {
            s[i] = s[i + 1];
            v[i] = v[i + 1];
        }
        s[2] = next;
        v[2] = excess(next, f);
        if (isnan(v[2]))
            return 0;
        if ((v[2] > 0) != (v[1] > 0) && ++crossings == wanted) {
            *ret = (struct bracket){s[1], v[1], s[2], v[2]};
            return 1;
        }
        if ((v[1] > 0) == (v[0] > 0) && (v[1] > 0) == (v[2] > 0) &&
            fabs(v[1]) <= fmin(fabs(v[0]), fabs(v[2])) &&
            cross_at_extreme(f, s, v, wanted - crossings, ret))
            return 1;
    }
    return 0;
}

enum status find_length(const struct cable *c, const struct load *load, const struct known *k,
                        double *ret, double *ret_least)
{
    struct search f = {c, load, k, SW_OK, INFINITY};
    double strain = first_strain(&f), s;
    struct bracket at;

    while (strain < MOST_STRETCHED && !(excess(-strain, &f) > 0) && f.failed == SW_OK)
        strain *= 2;
    f.least = INFINITY; /* which it stays where no cable has as much */
    if (strain < MOST_STRETCHED && find_bracket(&f, strain, &at)) {
        s = root_between(excess, &f, at.a, at.fa, at.b, at.fb);
        *ret = length_of(&f, s);
        if (!isnan(s))
            return SW_OK;
    }
    *ret_least = k->slack && f.least < k->value ? NAN : f.least;
    return f.failed != SW_OK ? f.failed : SW_INFEASIBLE;
}
