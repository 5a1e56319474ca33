/* Steady states and response curves. */
#include "form/response.h"
#include "num/pi.h"

#include <math.h>
#include <string.h>

#define PERIODS 2000  /* for which a steady state is looked for without time.end */
#define MULTIPLE 1e-9 /* of a frequency: how far another may be from its multiple */
#define ORBIT_CELLS 24

/* Take in one harmonic excitation: which direction a[3], by its largest component. */
static void reference(const double a[3], const double phase[3], double omega, struct drive *d)
{
    int most = 0;

    for (int i = 1; i < 3; i++)
        if (fabs(a[i]) > fabs(a[most]))
            most = i;
    if (d->order > 0 || a[most] == 0)
        return;
    d->order = 2 * (int)fmin(round(omega / d->omega), 1000);
    d->phase = phase[most] + (a[most] < 0 ? PI : 0);
}

/* The lowest frequency, 0: nothing is harmonic. */
static double lowest(const struct cable_case *c)
{
    double omega = INFINITY;

    for (int i = 0; i < c->n_motions; i++)
        if (c->motion_section[i].file[0] == '\0')
            omega = fmin(omega, c->motion[i].omega);
    for (int i = 0; i < c->n_forces; i++)
        if (!isnan(c->force[i].omega))
            omega = fmin(omega, c->force[i].omega);
    return isfinite(omega) ? omega : 0;
}

static enum status judge(const char *label, const char *file, double omega, int swept,
                         const struct drive *d, struct why *why)
{
    double times = omega / d->omega;

    if (swept)
        return SW_OK;
    if (file[0] != '\0')
        return fail(why, SW_ADMISSIBLE, "[%s] file: a record has no period to compare", label);
    if (!isnan(omega) && !(fabs(times - round(times)) <= MULTIPLE * times))
        return fail(why, SW_ADMISSIBLE,
                    "[%s] omega: %.9g is no multiple of the lowest frequency %.9g: there is no "
                    "period to compare",
                    label, omega, d->omega);
    return SW_OK;
}

enum status drive_of(const struct cable_case *c, const struct model *m, struct drive *ret,
                     struct why *why)
{
    int swept = case_sweeps(c); /* all at one frequency */
    enum status s = SW_OK;

    *ret = (struct drive){.omega = lowest(c)};
    if (ret->omega == 0) {
        s = modes_of_part(m, PART_LATERAL, 1, &ret->omega);
        if (s != SW_OK)
            return fail(why, s, "modes: %s", status_text(s));
    }
    for (int i = 0; i < c->n_motions && s == SW_OK; i++) {
        const struct motion *p = &c->motion[i];

        s = judge(c->motion_label[i], c->motion_section[i].file, p->omega, swept, ret, why);
        if (!p->record)
            reference(p->amplitude, p->phase, swept ? ret->omega : p->omega, ret);
        ret->begin = fmax(ret->begin, p->ramp);
    }
    for (int i = 0; i < c->n_forces && s == SW_OK; i++) {
        const struct force *p = &c->force[i];
        const double phase[3] = {p->phase, p->phase, p->phase};

        s = judge(c->force_label[i], c->force_section[i].file, p->omega, swept, ret, why);
        if (!isnan(p->omega))
            reference(p->value, phase, swept ? ret->omega : p->omega, ret);
    }
    for (int i = 0; i < c->n_disturbances; i++)
        ret->begin = fmax(ret->begin, c->disturbance[i].time);
    return s;
}

double drive_interval(const struct drive *d)
{
    return 2 * PI / d->omega / STEADY_SAMPLES;
}

struct steady_options response_options(const struct cable_case *c, const struct drive *d)
{
    return (struct steady_options){.tolerance = c->steady.tolerance,
                                   .periods = c->steady.periods,
                                   .begin = d->begin,
                                   .n_probes = c->time.n_probes,
                                   .probe = c->time.probe};
}

double response_end(const struct cable_case *c, const struct drive *d)
{
    return isnan(c->time.end) ? PERIODS * 2 * PI / d->omega : c->time.end;
}

void response_take(const struct steady *s, const struct drive *d, double t, double slack_time,
                   struct response *ret)
{
    *ret = (struct response){.kind = s->kind,
                             .period = s->period,
                             .whole = s->blocks > 0,
                             .time = t,
                             .omega = d->omega,
                             .change = s->moving,
                             .slack_time = slack_time};
    memcpy(ret->orbit, s->orbit, sizeof *s->orbit * (size_t)s->options.n_probes);
}

enum status response_find(struct launch *l, const struct drive *d, int (*stop)(double),
                          struct response *ret, struct why *why)
{
    const struct cable_case *c = l->c;
    struct steady_options o = response_options(c, d);
    double end = response_end(c, d);
    long marks = (long)floor(end / l->interval * (1 + 1e-12));
    struct march *m = &l->march;
    struct steady steady;
    int done = 0;
    enum status s = steady_new(l->model, &o, &steady);

    if (s != SW_OK)
        return fail_plain(why, s);
    while (s == SW_OK && !done) {
        for (int i = 0; i < c->n_disturbances; i++)
            if (launch_disturbance_due(l, &c->disturbance[i]))
                launch_disturb(l, &c->disturbance[i]);
        s = march_solve(m);
        if (s == SW_OK && march_at_mark(m) && march_mark(m) > 0) {
            s = steady_add(&steady, march_time(m), d->omega * march_time(m), m->V, &done);
            if (march_mark(m) >= marks || (stop && stop(march_time(m) / end)))
                break;
        }
        if (s == SW_OK && !done)
            s = march_advance(m);
    }
    steady_end(&steady);
    response_take(&steady, d, march_time(m), m->slack_time, ret);
    steady_free(&steady);
    return s == SW_OK ? s : launch_fail(l, s, why);
}

void orbit_header(int n, struct out *o)
{
    for (int p = 1; p <= n; p++) {
        for (int i = 1; i <= 3; i++)
            fprintf(o->f, ",v%d_%d_least_m,v%d_%d_greatest_m,v%d_%d_amplitude_m", i, p, i, p, i, p);
        for (int i = 2; i <= 3; i++)
            fprintf(o->f, ",v%d_%d_half_m,v%d_%d_first_m,v%d_%d_second_m,v%d_%d_third_m", i, p, i,
                    p, i, p, i, p);
        fprintf(o->f,
                ",plane_%d,axes_ratio_%d,half_axis_%d_m,minor_half_axis_%d_m,tilt_%d_deg"
                ",phase_%d_deg,tension_%d_N",
                p, p, p, p, p, p, p);
    }
}

/* NAN: an empty cell. */
static void cell(double x, struct out *o)
{
    putc(',', o->f);
    if (!isnan(x))
        out_number(o, x);
}

/* Phase of v2 against the excitation's, -180..180 degrees; NAN: there is none. */
static double phase_against(const struct orbit *r, int order, double phase)
{
    if (order < 1 || order > ORBIT_ORDERS || !(r->harmonic[order - 1][1] > 0))
        return NAN;
    return remainder(r->phase[order - 1][1] - phase, 2 * PI) * 180 / PI;
}

void orbit_print(const struct orbit *orbit, int n, int order, double phase, struct out *o)
{
    static const int shown[] = {1, 2, 4, 6}; /* half orders */

    for (const struct orbit *r = orbit; r < orbit + n; r++) {
        for (int i = 0; i < 3; i++) {
            cell(r->least[i], o);
            cell(r->greatest[i], o);
            cell(r->amplitude[i], o);
        }
        for (int i = 1; i < 3; i++)
            for (int k = 0; k < 4; k++)
                cell(r->harmonic[shown[k] - 1][i], o);
        fprintf(o->f, ",%s", orbit_plane_name(r->plane));
        cell(r->major > 0 ? r->minor / r->major : NAN, o);
        cell(r->major, o);
        cell(r->minor, o);
        cell(r->major > 0 ? r->tilt * 180 / PI : NAN, o);
        cell(phase_against(r, order, phase), o);
        cell(r->tension, o);
    }
}

void response_header(int n_probes, struct out *o)
{
    fputs("kind,period_ratio,plane,support_phase,time_s,omega_rad_s,change,slack_time_s", o->f);
    orbit_header(n_probes, o);
}

static void empty_cells(int n, struct out *o)
{
    for (int i = 0; i < n; i++)
        putc(',', o->f);
}

/* How the first probe moves down and up against what drives it. */
static const char *phase_word(const struct response *r, const struct drive *d)
{
    double phase = phase_against(&r->orbit[0], d->order, d->phase);

    if (isnan(phase))
        return "";
    return fabs(phase) < 45 ? "in-phase" : fabs(phase) > 135 ? "counter" : "quadrature";
}

void response_print(const struct response *r, const struct drive *d, int n_probes, struct out *o)
{
    fputs(steady_kind_name(r->kind), o->f);
    putc(',', o->f);
    if (r->kind == STEADY_PERIODIC && d->order > 0)
        fprintf(o->f, "1:%d", r->period);
    fprintf(o->f, ",%s,%s", r->whole ? orbit_plane_name(r->orbit[0].plane) : "", phase_word(r, d));
    cell(r->time, o);
    cell(r->omega, o);
    cell(isfinite(r->change) ? r->change : NAN, o);
    cell(r->slack_time >= 0 ? r->slack_time : NAN, o);
    if (r->whole)
        orbit_print(r->orbit, n_probes, d->order, d->phase, o);
    else
        empty_cells(ORBIT_CELLS * n_probes, o);
}

void response_print_none(int n_probes, struct out *o)
{
    empty_cells(7 + ORBIT_CELLS * n_probes, o);
}
