/* Response curves of slow sweeps. */
#include "form/curve.h"
#include "num/mem.h"
#include "num/pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What changes while a sweep goes on; the orbits' windows stand behind it. */
struct curve_state {
    double slot, seed_slot; /* of the present windows; negative: none yet */
    double omega;           /* sum over the samples; in steps: of the last one */
    double start, end;      /* times of the first and last sample */
    double amplitude;       /* largest of the first lateral mode since the last look */
};

#define HEAD (sizeof(struct curve_state) / sizeof(double))

static struct curve_state *state(struct curve *p)
{
    return (struct curve_state *)(void *)p->more;
}

static struct orbit_window *windows(struct curve *p)
{
    return (struct orbit_window *)(void *)(p->more + HEAD);
}

/* The first mode that moves sideways more than in the plane, of the lowest k; NULL in shape: there
 * is none. */
static enum status find_lateral(const struct model *m, int k, double *shape, int *ret_found)
{
    struct modes modes;
    enum status s = modes_lowest(m, k, SOLVER_AUTO, &modes);

    *ret_found = 0;
    for (int i = 0; i < k && s == SW_OK && !*ret_found; i++)
        if (modes.plane[i] == PART_LATERAL)
            *ret_found = modes_unit_shape(m, &modes, i, shape) == SW_OK;
    if (s == SW_OK)
        modes_free(&modes);
    return s;
}

/* weight = M shape/(shape^T M shape): its product with V is the amplitude of the mode in V. */
static enum status weigh(struct curve *p)
{
    size_t n = model_unknowns(p->model);
    struct band M;
    double size = 0;

    if (model_mass(p->model, PART_ALL, &M) != SW_OK)
        return SW_NOMEM;
    band_multiply_add(&M, 1, p->shape, p->weight);
    band_free(&M);
    for (size_t i = 0; i < n; i++)
        size += p->shape[i] * p->weight[i];
    for (size_t i = 0; i < n; i++)
        p->weight[i] /= size;
    return SW_OK;
}

static enum status find_seed(struct curve *p, struct why *why)
{
    int found = 0, most = 6 * p->model->n;
    enum status s = SW_OK;

    for (int k = most < 4 ? most : 4; s == SW_OK && !found; k = 2 * k < most ? 2 * k : most) {
        s = find_lateral(p->model, k, p->shape, &found);
        if (k == most)
            break;
    }
    if (s == SW_OK && !found)
        return fail(why, SW_ADMISSIBLE,
                    "[sweep] seed: this mesh has no lateral mode to seed; take more elements");
    if (s == SW_OK)
        s = weigh(p);
    return s == SW_OK ? s : fail(why, s, "[sweep] seed: %s", status_text(s));
}

enum status curve_new(const struct cable_case *c, const struct model *m, struct curve *ret,
                      struct why *why)
{
    size_t per_window = sizeof(struct orbit_window) / sizeof(double);
    enum status s;

    *ret = (struct curve){.c = c, .model = m};
    ret->n_more = HEAD + per_window * (size_t)c->time.n_probes;
    ret->more = mem_doubles(ret->n_more);
    ret->shape = model_vector(m);
    ret->weight = model_vector(m);
    s = ret->more && ret->shape && ret->weight ? SW_OK : fail_plain(why, SW_NOMEM);
    if (s == SW_OK && c->sweep.seed > 0)
        s = find_seed(ret, why);
    if (s == SW_OK)
        s = drive_of(c, m, &ret->drive, why);
    if (s != SW_OK) {
        curve_free(ret);
        return s;
    }
    state(ret)->slot = state(ret)->seed_slot = -1;
    return SW_OK;
}

void curve_free(struct curve *p)
{
    free(p->more);
    free(p->shape);
    free(p->weight);
    *p = (struct curve){.c = NULL};
}

void curve_header(const struct curve *p, struct out *o)
{
    fputs("direction,omega_rad_s,time_s", o->f);
    orbit_header(p->c->time.n_probes, o);
    putc('\n', o->f);
}

/* Number of the window of so many periods that phase lies in, its end included. */
static double slot_of(double phase, int periods)
{
    return fmax(ceil(phase / (2 * PI * periods) * (1 - 1e-12)) - 1, 0);
}

/* The windows as a row; they are empty afterwards. */
static int print_row(struct curve *p, struct out *o)
{
    struct curve_state *s = state(p);
    struct orbit_window *w = windows(p);
    struct orbit orbit[MAX_PROBES];
    double n = w[0].n, middle = (s->start + s->end) / 2;

    if (!(n > 0))
        return 0;
    for (int i = 0; i < p->c->time.n_probes; i++)
        orbit_of(&w[i], &orbit[i]);
    fputs(sweep_direction(&p->c->sweep.sweep, middle) > 0 ? "up," : "down,", o->f);
    out_number(o, p->c->sweep.sweep.rate > 0 ? s->omega / n : s->omega);
    putc(',', o->f);
    out_number(o, middle);
    orbit_print(orbit, p->c->time.n_probes, p->drive.order, p->drive.phase, o);
    putc('\n', o->f);
    memset(w, 0, sizeof *w * (size_t)p->c->time.n_probes);
    s->omega = 0;
    return 1;
}

/* The seed, if the mode has been below it for a whole window. */
static void seed(struct curve *p, struct march *m, double phase)
{
    struct curve_state *s = state(p);
    double slot = slot_of(phase, p->c->sweep.window), amplitude = 0;

    if (!(p->c->sweep.seed > 0))
        return;
    for (size_t i = 0; i < model_unknowns(p->model); i++)
        amplitude += p->weight[i] * m->V[i];
    s->amplitude = fmax(s->amplitude, fabs(amplitude));
    if (slot == s->seed_slot)
        return;
    if (s->amplitude < p->c->sweep.seed)
        march_kick(m, KICK_DISPLACEMENT, p->c->sweep.seed, p->shape);
    s->seed_slot = slot;
    s->amplitude = 0;
}

int curve_mark(struct curve *p, struct march *m, struct out *o)
{
    const struct sweep *sweep = &p->c->sweep.sweep;
    struct curve_state *s = state(p);
    int steps = !(sweep->rate > 0), rows = 0;
    double t = march_time(m), phase, omega, rate, slot, within;

    sweep_at(sweep, t, &phase, &omega, &rate);
    slot = slot_of(phase, steps ? sweep->dwell : p->c->sweep.window);
    if (slot != s->slot) {
        rows = print_row(p, o);
        s->slot = slot;
        s->start = t;
    }
    within = phase / (2 * PI) - slot * (steps ? sweep->dwell : 0);
    if (t > 0 && (!steps || within > sweep->dwell - p->c->sweep.window + 1e-9)) {
        if (windows(p)[0].n == 0)
            s->start = t;
        for (int i = 0; i < p->c->time.n_probes; i++) {
            double v[3], tension;

            model_probe(p->model, p->c->time.probe[i], m->V, v, &tension);
            orbit_add(&windows(p)[i], phase, v, tension);
        }
        if (steps) /* the end of a dwell belongs to it */
            sweep_at(sweep, t * (1 - 1e-12), &phase, &s->omega, &rate);
        else
            s->omega += omega;
        s->end = t;
    }
    seed(p, m, phase);
    return rows;
}

int curve_end(struct curve *p, struct out *o)
{
    const struct sweep *sweep = &p->c->sweep.sweep;
    struct curve_state *s = state(p);
    double periods, from, to, omega, rate;

    sweep_at(sweep, s->start, &from, &omega, &rate);
    sweep_at(sweep, s->end, &to, &omega, &rate);
    periods = (to - from) / (2 * PI);
    return periods >= p->c->sweep.window / 2.0 ? print_row(p, o) : 0;
}
