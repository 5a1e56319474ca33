/* Slow sweeps of the excitation's frequency. */
#include "phys/sweep.h"
#include "num/mem.h"
#include "num/pi.h"

#include <math.h>
#include <stdlib.h>

#define MOST_STEPS 1e7

/* Frequencies of one way, both ends included where the step divides it. */
static double one_way(const struct sweep *s)
{
    return floor(fabs(s->to - s->from) / s->step * (1 + 1e-12)) + 1;
}

/* Frequency number i of all steps. */
static double step_omega(const struct sweep *s, int i)
{
    int way = (int)one_way(s);

    if (i >= way) /* the way back, without the turning point */
        i = 2 * way - 2 - i;
    return s->from + (s->to > s->from ? s->step : -s->step) * i;
}

enum status sweep_new(struct sweep *s)
{
    double way;

    s->n = 0;
    s->start = NULL;
    if (s->rate > 0) {
        s->duration = fabs(s->to - s->from) / s->rate * (s->back ? 2 : 1);
        return SW_OK;
    }
    way = one_way(s);
    if (!(way <= MOST_STEPS))
        return SW_ADMISSIBLE;
    s->n = (int)(s->back ? 2 * way - 1 : way);
    s->start = mem_doubles((size_t)s->n + 1);
    if (!s->start)
        return SW_NOMEM;
    for (int i = 0; i < s->n; i++)
        s->start[i + 1] = s->start[i] + s->dwell * 2 * PI / step_omega(s, i);
    s->duration = s->start[s->n];
    return SW_OK;
}

void sweep_free(struct sweep *s)
{
    free(s->start);
    s->start = NULL;
}

/* The step that t belongs to. */
static int step_at(const struct sweep *s, double t)
{
    int low = 0, high = s->n;

    while (high - low > 1) {
        int middle = low + (high - low) / 2;

        if (s->start[middle] <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* One leg of a continuous sweep, that begins at t = 0 with Omega = from. */
static void leg(double from, double rate, double t, double *phase, double *omega)
{
    *phase = (from + rate * t / 2) * t;
    *omega = from + rate * t;
}

void sweep_at(const struct sweep *s, double t, double *phase, double *omega, double *rate)
{
    double up = s->to > s->from ? s->rate : -s->rate, turn = fabs(s->to - s->from) / s->rate;
    double within = fmin(fmax(t, 0), s->duration), start;

    *rate = within == t && s->rate > 0 ? up : 0;
    if (!(s->rate > 0)) {
        int i = step_at(s, within);

        *omega = step_omega(s, i);
        *phase = 2 * PI * s->dwell * i + *omega * (within - s->start[i]);
    } else if (within <= turn) {
        leg(s->from, up, within, phase, omega);
    } else {
        leg(s->from, up, turn, &start, omega);
        leg(s->to, -up, within - turn, phase, omega);
        *phase += start;
        *rate = -*rate;
    }
    *phase += *omega * (t - within);
}

int sweep_direction(const struct sweep *s, double t)
{
    int out = s->to > s->from ? 1 : -1;
    int on_way_back =
        s->rate > 0 ? t > fabs(s->to - s->from) / s->rate : step_at(s, t) >= (int)one_way(s);

    return s->back && on_way_back ? -out : out;
}
