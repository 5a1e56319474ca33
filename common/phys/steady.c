/* Steady states. */
#include "phys/steady.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ROUND_OFF 1e-9                   /* of an amplitude: changes below it may grow */
#define QUARTER (STEADY_SAMPLES * 3 / 4) /* sample of the earlier one of two looks in a period */
#define STAND 0.02 /* of an amplitude: bounds that stand still, over thirds of the run */

static size_t places(const struct steady *s)
{
    return 3 * ((size_t)s->model->n + 1);
}

static void begin_block(struct steady *s)
{
    for (size_t i = 0; i < places(s); i++) {
        s->least[i] = INFINITY;
        s->greatest[i] = -INFINITY;
    }
    memset(s->window, 0, sizeof *s->window * (size_t)s->options.n_probes);
}

enum status steady_new(const struct model *m, const struct steady_options *o, struct steady *ret)
{
    size_t n = 3 * ((size_t)m->n + 1), probes = (size_t)o->n_probes;

    *ret = (struct steady){.model = m, .options = *o, .moving = INFINITY};
    ret->least = mem_doubles(n);
    ret->greatest = mem_doubles(n);
    ret->strobe = mem_doubles((STEADY_MOST_PERIODS + 1) * 2 * n);
    ret->window = mem_zeroed(probes, sizeof *ret->window);
    ret->orbit = mem_zeroed(probes, sizeof *ret->orbit);
    if (!ret->least || !ret->greatest || !ret->strobe || !ret->window || !ret->orbit) {
        steady_free(ret);
        return SW_NOMEM;
    }
    begin_block(ret);
    return SW_OK;
}

void steady_free(struct steady *s)
{
    free(s->least);
    free(s->greatest);
    free(s->strobe);
    free(s->window);
    free(s->orbit);
    free(s->history);
    *s = (struct steady){0};
}

/* Bounds of all nodes, windows of the probes.  Of an odd number of periods the first one is left
 * out of the windows: harmonics of half the frequency need pairs. */
static void take_sample(struct steady *s, double phi, const double *V)
{
    long in_block = (s->samples - 1) % (s->options.periods * STEADY_SAMPLES);

    for (size_t i = 0; i < places(s); i++) {
        s->least[i] = fmin(s->least[i], V[2 * i]);
        s->greatest[i] = fmax(s->greatest[i], V[2 * i]);
    }
    if (s->options.periods % 2 == 1 && in_block < STEADY_SAMPLES)
        return;
    for (int p = 0; p < s->options.n_probes; p++) {
        double v[3], tension;

        model_probe(s->model, s->options.probe[p], V, v, &tension);
        orbit_add(&s->window[p], phi, v, tension);
    }
}

static double *strobe_of(struct steady *s, long period)
{
    return s->strobe + 2 * places(s) * (size_t)(period % (STEADY_MOST_PERIODS + 1));
}

/* R_m,c and A_c at the end of a block, period number `now`. */
static void measure(struct steady *s, long now)
{
    const double *present = strobe_of(s, now);

    memcpy(s->before, s->amplitude, sizeof s->before);
    memset(s->amplitude, 0, sizeof s->amplitude);
    for (size_t i = 0; i < places(s); i++) {
        double span = (s->greatest[i] - s->least[i]) / 2;

        s->amplitude[i % 3] = fmax(s->amplitude[i % 3], span);
        s->peak = fmax(s->peak, span);
    }
    for (int m = 1; m <= STEADY_MOST_PERIODS; m++) {
        const double *past = strobe_of(s, now > m ? now - m : now + 1);

        memset(s->change[m], 0, sizeof s->change[m]);
        for (size_t i = 0; i < 2 * places(s); i++)
            s->change[m][i % 3] = fmax(s->change[m][i % 3], fabs(present[i] - past[i]));
    }
}

static enum status remember(struct steady *s)
{
    if (s->blocks == s->room) {
        long room = s->room > 0 ? 2 * s->room : 64;
        double *more = mem_resize(s->history, 3 * (size_t)room, sizeof *more);

        if (!more)
            return SW_NOMEM;
        s->history = more;
        s->room = room;
    }
    memcpy(s->history + 3 * s->blocks++, s->amplitude, sizeof s->amplitude);
    return SW_OK;
}

static double largest(const double a[3])
{
    return fmax(fmax(a[0], a[1]), a[2]);
}

/* Component c is small beside the others and becomes smaller. */
static int dies(const struct steady *s, int c)
{
    return s->amplitude[c] <= s->options.tolerance * largest(s->amplitude) &&
           s->amplitude[c] <= s->before[c];
}

/* Whether the changes of m periods, grown since the last block, are more than round-off. */
static int grows(const struct steady *s, int m, const double old[3])
{
    for (int c = 0; c < 3; c++)
        if (s->change[m][c] > old[c] && s->change[m][c] > ROUND_OFF * s->amplitude[c])
            return 1;
    return 0;
}

/* Largest relative change by amplitudes and R_m. */
static double relative_change(const struct steady *s, int m)
{
    double most = 0;

    for (int c = 0; c < 3; c++)
        if (s->amplitude[c] > 0 && !dies(s, c))
            most = fmax(most, fmax(fabs(s->amplitude[c] - s->before[c]), s->change[m][c]) /
                                  s->amplitude[c]);
    return most;
}

static void judge(struct steady *s, double old[][3])
{
    double tolerance = s->options.tolerance;

    s->kind = STEADY_NONE;
    s->period = 0;
    if (largest(s->amplitude) <= tolerance * s->peak) {
        s->kind = STEADY_DECAYED;
        s->moving = s->peak > 0 ? largest(s->amplitude) / s->peak : 0;
        return;
    }
    s->moving = INFINITY;
    for (int m = 1; m <= STEADY_MOST_PERIODS && m <= s->options.periods; m++) {
        double change = relative_change(s, m);

        s->moving = fmin(s->moving, change);
        if (!(change <= tolerance))
            continue;
        if (!grows(s, m, old[m])) { /* else neither do multiples of m count */
            s->kind = STEADY_PERIODIC;
            s->period = m;
        }
        s->moving = change;
        return;
    }
}

static enum status end_block(struct steady *s, double t, long period, int *ret_done)
{
    double old[STEADY_MOST_PERIODS + 1][3];
    double length = t * s->options.periods / (double)period;
    enum status status;

    memcpy(old, s->change, sizeof old);
    measure(s, period);
    status = remember(s);
    for (int p = 0; p < s->options.n_probes; p++)
        orbit_of(&s->window[p], &s->orbit[p]);
    begin_block(s);
    if (status == SW_OK && s->blocks >= 2 && t - 2 * length >= s->options.begin * (1 - 1e-12)) {
        s->judged = 1;
        judge(s, old);
        *ret_done = s->kind != STEADY_NONE;
    }
    return status;
}

static void look(const struct steady *s, double *to, const double *V)
{
    for (size_t i = 0; i < places(s); i++)
        to[i] = V[2 * i];
}

enum status steady_add(struct steady *s, double t, double phi, const double *V, int *ret_done)
{
    long period;

    *ret_done = 0;
    s->samples++;
    take_sample(s, phi, V);
    period = (s->samples + STEADY_SAMPLES - 1) / STEADY_SAMPLES;
    if (s->samples % STEADY_SAMPLES == QUARTER)
        look(s, strobe_of(s, period) + places(s), V);
    if (s->samples % STEADY_SAMPLES != 0)
        return SW_OK;
    look(s, strobe_of(s, period), V);
    return period % s->options.periods == 0 ? end_block(s, t, period, ret_done) : SW_OK;
}

/* Least and greatest A_c in blocks from..to-1. */
static void bounds(const struct steady *s, int c, long from, long to, double *least,
                   double *greatest)
{
    *least = INFINITY;
    *greatest = 0;
    for (long k = from; k < to; k++) {
        *least = fmin(*least, s->history[3 * k + c]);
        *greatest = fmax(*greatest, s->history[3 * k + c]);
    }
}

/*
 * Quasi-periodic: the last third of the blocks has the bounds of the third before it, within 2 % of
 * the amplitude, and no return after m periods comes as near as that: a motion that still settles
 * returns nearly.
 */
void steady_end(struct steady *s)
{
    long third = s->blocks / 3;
    double most = largest(s->amplitude);

    if (s->kind != STEADY_NONE || third < 2 || !s->judged || !(s->moving > STAND))
        return;
    for (int c = 0; c < 3; c++) {
        double least[2], greatest[2];

        bounds(s, c, s->blocks - 2 * third, s->blocks - third, &least[0], &greatest[0]);
        bounds(s, c, s->blocks - third, s->blocks, &least[1], &greatest[1]);
        if (!(fabs(least[1] - least[0]) <= STAND * most) ||
            !(fabs(greatest[1] - greatest[0]) <= STAND * most))
            return;
    }
    s->kind = STEADY_QUASI;
}

const char *steady_kind_name(enum steady_kind kind)
{
    static const char *const name[] = {"none", "periodic", "quasi-periodic", "decayed"};

    return name[kind];
}
