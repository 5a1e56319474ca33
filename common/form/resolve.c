/* What the keys of a cable mean together: either-or, defaults that depend on others. */
#include "form/resolve.h"
#include "num/mem.h"
#include "num/pi.h"
#include "sys/number.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const char *const known_key[N_GIVEN] = {
    [GIVEN_HORIZONTAL] = "horizontal_force",
    [GIVEN_MIDSPAN] = "midspan_tension",
    [GIVEN_LEFT] = "tension_left",
    [GIVEN_RIGHT] = "tension_right",
    [GIVEN_SAG] = "sag",
    [GIVEN_FREQUENCY] = "frequency",
};

/* What is known in place of the length into *ret; its key is returned, or NULL where it is the
 * length itself.  *s is SW_OK unless more or less than one is given. */
static const char *take_known(const struct reading *r, struct cable_case *c, struct known *ret,
                              enum status *s)
{
    static const char *const one = "give exactly one of unstressed_length, horizontal_force, "
                                   "midspan_tension, tension_left, tension_right, sag, "
                                   "fundamental_frequency, frequency";
    struct known_keys *k = &c->known;
    const char *key = NULL;
    int n = !isnan(c->bare.L0);

    for (int i = 0; i < N_GIVEN; i++)
        if (!isnan(k->value[i])) {
            n++;
            key = known_key[i];
            *ret = (struct known){.given = (enum given)i, .value = k->value[i]};
        }
    if (!isnan(k->fundamental)) {
        n++;
        key = "fundamental_frequency";
        *ret = (struct known){.given = GIVEN_FREQUENCY, .value = k->fundamental};
    }
    *s = SW_OK;
    if (n == 0)
        *s = keys_fail(r, "cable", "unstressed_length",
                       "is missing, and nothing that it follows from is given");
    else if (n > 1)
        *s = keys_fail(r, "cable", key, one);
    else if ((k->mode > 0 || k->plane >= 0) && isnan(k->value[GIVEN_FREQUENCY]))
        *s = keys_fail(r, "cable", k->mode > 0 ? "mode" : "plane",
                       "tells of which mode frequency is; there is none");
    else if (!key && k->slack >= 0)
        *s = keys_fail(r, "cable", "branch", "the unstressed length is given, which is one cable");
    ret->part = k->plane == 1 ? PART_PLANE : PART_LATERAL;
    ret->mode = k->mode > 0 ? k->mode : 1;
    ret->slack = k->slack == 1;
    ret->law = (enum law)c->law;
    ret->elements = c->elements;
    if (*s == SW_OK && ret->mode > c->elements)
        *s = keys_fail(r, "cable", "mode", "needs at least as many elements");
    return key;
}

/* Why no length, or none that a case may have, gives what is known. */
static void tell_infeasible(const struct reading *r, const char *key, double value, double least)
{
    char text[200];

    if (isnan(least))
        snprintf(text, sizeof text, "only one cable, the tauter one, has it");
    else if (isinf(least))
        snprintf(text, sizeof text, "no length gives %.9g; the cable would be stretched too far",
                 value);
    else if (least < value)
        snprintf(text, sizeof text, "no length gives %.9g", value);
    else
        snprintf(text, sizeof text, "no length gives %.9g; the least possible is %.9g", value,
                 least);
    keys_fail(r, "cable", key, text);
}

/* The unstressed length from what is known of the cable. */
static enum status resolve_length(const struct reading *r, struct cable_case *c)
{
    struct known known;
    double least = NAN;
    enum status s;
    const char *key = take_known(r, c, &known, &s);

    if (s != SW_OK || !key)
        return s;
    s = find_length(&c->bare, &c->load, &known, &c->bare.L0, &least);
    if (s == SW_OK && c->bare.L0 < CASE_SHORTEST) {
        s = SW_INFEASIBLE;
        least = INFINITY;
    }
    if (s == SW_INFEASIBLE) {
        tell_infeasible(r, key, known.value, least);
        return s;
    }
    if (s != SW_OK)
        return fail(r->why, s, "%.400s: [cable] %s: %s", keys_place(r), key, status_text(s));
    for (int i = 0; i < N_GIVEN; i++)
        c->known.value[i] = NAN;
    c->known.fundamental = NAN;
    c->known.mode = c->known.plane = c->known.slack = -1;
    c->found = 1;
    return SW_OK;
}

enum status case_resolve_model(const struct reading *r, struct cable_case *c)
{
    static const char *const one = "give either axial_stiffness or youngs_modulus and area";
    double stretch = 1 + c->load.expansion * c->load.temperature;
    const char *reason;
    enum status s;

    if (isnan(c->bare.mu))
        return keys_fail(r, "cable", "mass_per_length", "is missing");
    if (isnan(c->bare.span))
        return keys_fail(r, "supports", "span", "is missing");
    if (isnan(c->youngs_modulus) != isnan(c->area) ||
        isnan(c->youngs_modulus) != !isnan(c->bare.EA))
        return keys_fail(r, "cable", "axial_stiffness", one);
    if (isnan(c->bare.EA))
        c->bare.EA = c->youngs_modulus * c->area;
    if (!(stretch > 0.5 && stretch < 2))
        return keys_fail(r, "load", "temperature_change",
                         "changes the length by half or more; are the units right?");
    s = resolve_length(r, c);
    if (s != SW_OK)
        return s;
    load_apply(&c->bare, &c->load, &c->cable, &c->axes);
    if (!(c->cable.span > 1e-9 * line_chord(&c->bare)))
        return keys_fail(r, "load", "wind", "together with the weight acts along the chord");
    reason = line_inadmissible(&c->cable);
    if (reason)
        return fail(r->why, SW_ADMISSIBLE, "%.400s: %s", keys_place(r), reason);
    return SW_OK;
}

/* a - b, 0 where nothing but round-off is left. */
static double difference(double a, double b)
{
    return fabs(a - b) <= 4 * DBL_EPSILON * fmax(fabs(a), fabs(b)) ? 0 : a - b;
}

/* Two-point fit: zeta_i = alpha/(2 omega_i) + beta omega_i/2. */
static enum status resolve_damping(const struct reading *r, struct cable_case *c)
{
    double *z = c->zeta, *w = c->zeta_omega;
    double square;

    if (isnan(z[0]) != isnan(w[0]))
        return keys_fail(r, "damping", isnan(z[0]) ? "zeta" : "omega", "is missing");
    if (!isnan(z[0])) {
        if (!isnan(c->alpha) || !isnan(c->beta))
            return keys_fail(r, "damping", "zeta",
                             "give either alpha and beta or zeta and omega "
                             "(--set damping.alpha= removes a key)");
        square = (w[1] - w[0]) * (w[1] + w[0]);
        if (square == 0)
            return keys_fail(r, "damping", "omega", "the two must differ");
        c->alpha = 2 * w[0] * w[1] * difference(z[0] * w[1], z[1] * w[0]) / square;
        c->beta = 2 * difference(z[1] * w[1], z[0] * w[0]) / square;
        if (!(c->alpha >= 0 && c->beta >= 0))
            return keys_fail(r, "damping", "zeta",
                             "these ratios need a negative alpha or beta, which would feed energy");
        if (!(c->alpha <= CASE_LARGEST && c->beta <= CASE_LARGEST))
            return keys_fail(r, "damping", "zeta",
                             "these ratios need an alpha or beta above 1e+09");
        z[0] = z[1] = w[0] = w[1] = NAN;
    }
    if (isnan(c->alpha))
        c->alpha = 0;
    if (isnan(c->beta))
        c->beta = 0;
    return SW_OK;
}

static enum status resolve_damper(const struct reading *r, const char *section,
                                  const struct damper *d)
{
    if (isnan(d->position))
        return keys_fail(r, section, "position", "is missing");
    if (!(d->position > 0 && d->position < 1))
        return keys_fail(r, section, "position",
                         "must lie between the supports, above 0 and below 1");
    if (isnan(d->direction[0]))
        return keys_fail(r, section, "direction", "is missing");
    if (d->direction[0] == 0 && d->direction[1] == 0 && d->direction[2] == 0)
        return keys_fail(r, section, "direction", "must not be zero");
    if (isnan(d->coefficient))
        return keys_fail(r, section, "coefficient", "is missing");
    return SW_OK;
}

static enum status resolve_motion(const struct reading *r, const char *section,
                                  const struct sweep_plan *sweep, struct motion_section *p)
{
    struct motion *m = &p->motion;

    if (p->file[0] != '\0' && (!isnan(m->amplitude[0]) || !isnan(m->omega)))
        return keys_fail(r, section, "file", "give either a file, or amplitude and omega");
    if (p->file[0] != '\0') {
        m->phase[0] = NAN; /* tells nothing, and is not printed */
        return SW_OK;
    }
    if (isnan(m->amplitude[0]))
        return keys_fail(r, section, "amplitude", "is missing");
    if (isnan(m->omega))
        m->omega = sweep->sweep.from; /* the sweep's, if there is one */
    if (isnan(m->omega))
        return keys_fail(r, section, "omega", "is missing");
    if (!isnan(m->phase[1]) && isnan(m->phase[2]))
        return keys_fail(r, section, "phase", "give one number or three");
    if (isnan(m->phase[1]))
        m->phase[1] = m->phase[2] = m->phase[0];
    return SW_OK;
}

static enum status resolve_force(const struct reading *r, const char *section,
                                 struct force_section *p)
{
    if (isnan(p->position))
        return keys_fail(r, section, "position", "is missing");
    if (!(p->position < 1))
        return keys_fail(r, section, "position", "must lie between the supports, or be all");
    if ((p->file[0] != '\0') == !isnan(p->value[0]))
        return keys_fail(r, section, "value", "give either value or file");
    if (!isnan(p->omega) && p->file[0] != '\0')
        return keys_fail(r, section, "omega", "belongs to value, not to file");
    if (!isnan(p->phase) && isnan(p->omega))
        return keys_fail(r, section, "phase", "needs omega");
    if (!isnan(p->omega) && isnan(p->phase))
        p->phase = 0;
    return SW_OK;
}

static enum status resolve_wind(const struct reading *r, struct wind *w)
{
    int given = !isnan(w->speed[0]) + !isnan(w->cd) + !isnan(w->diameter);

    if (given == 0 && isnan(w->density))
        return SW_OK;
    if (isnan(w->speed[0]))
        return keys_fail(r, "wind", "speed", "is missing");
    if (isnan(w->cd))
        return keys_fail(r, "wind", "drag_coefficient", "is missing");
    if (isnan(w->diameter))
        return keys_fail(r, "wind", "diameter", "is missing");
    if (isnan(w->density))
        w->density = 1.225;
    return SW_OK;
}

/* Which of the two kinds of sweep it is, and that all its keys are there. */
static enum status judge_sweep(const struct reading *r, const struct sweep_plan *p)
{
    const struct sweep *s = &p->sweep;
    int steps = !isnan(s->step) || s->dwell >= 0;

    if (isnan(s->from))
        return keys_fail(r, "sweep", "from", "is missing");
    if (isnan(s->to))
        return keys_fail(r, "sweep", "to", "is missing");
    if (s->from == s->to)
        return keys_fail(r, "sweep", "to", "must not equal from");
    if (steps == !isnan(s->rate))
        return keys_fail(r, "sweep", "rate", "give either rate, or step and dwell");
    if (steps && isnan(s->step))
        return keys_fail(r, "sweep", "step", "is missing");
    if (steps && s->dwell < 0)
        return keys_fail(r, "sweep", "dwell", "is missing");
    if (steps && s->dwell < p->window)
        return keys_fail(r, "sweep", "window", "is longer than dwell");
    return SW_OK;
}

static enum status resolve_sweep(const struct reading *r, struct cable_case *c)
{
    struct sweep_plan *p = &c->sweep;
    struct sweep *s = &p->sweep;
    enum status status;

    if (isnan(s->from) && isnan(s->to) && isnan(s->rate) && isnan(s->step) && s->dwell < 0 &&
        s->back < 0 && isnan(p->seed) && p->window < 0)
        return SW_OK;
    if (isnan(p->seed))
        p->seed = 1e-4;
    if (s->back < 0)
        s->back = 0;
    if (p->window < 0)
        p->window = s->dwell >= 0 && s->dwell < 10 ? s->dwell : 10;
    status = judge_sweep(r, p);
    if (status != SW_OK)
        return status;
    status = sweep_new(s);
    return status == SW_OK ? SW_OK
                           : keys_fail(r, "sweep", "step",
                                       status == SW_NOMEM ? status_text(status)
                                                          : "makes more than 1e7 frequencies");
}

/* The motions and forces of their sections, side by side; records come later. */
static enum status collect(const struct reading *r, struct cable_case *c)
{
    double cold = c->bare.L0 / c->cable.L0;
    int swept = 0;

    c->motion = mem_zeroed((size_t)c->n_motions, sizeof *c->motion);
    c->force = mem_zeroed((size_t)c->n_forces, sizeof *c->force);
    if (!c->motion || !c->force)
        return fail_plain(r->why, SW_NOMEM);
    for (int i = 0; i < c->n_motions; i++) {
        c->motion[i] = c->motion_section[i].motion;
        swept += c->motion_section[i].file[0] == '\0';
        if (case_sweeps(c) && c->motion_section[i].file[0] == '\0')
            c->motion[i].sweep = &c->sweep.sweep;
    }
    for (int i = 0; i < c->n_forces; i++) {
        const struct force_section *p = &c->force_section[i];
        double scale = p->position > 0 ? 1 : cold; /* per metre before expansion, and after it */

        c->force[i] =
            (struct force){p->position > 0 ? p->position : NAN,
                           {scale * p->value[0], scale * p->value[1], scale * p->value[2]},
                           p->omega,
                           p->phase,
                           NULL,
                           case_sweeps(c) ? &c->sweep.sweep : NULL};
        swept += !isnan(p->omega);
    }
    if (case_sweeps(c) && swept == 0)
        return keys_fail(r, "sweep", "from", "there is no harmonic [motion] or [force] to sweep");
    return SW_OK;
}

static enum status resolve_disturbance(const struct reading *r, const char *section,
                                       const struct cable_case *c, const struct disturbance *d)
{
    if ((d->mode < 0) == (d->node < 0))
        return keys_fail(r, section, "mode", "give either mode or node");
    if (isnan(d->amplitude[0]))
        return keys_fail(r, section, "amplitude", "is missing");
    if (d->mode > 0 && !isnan(d->amplitude[1]))
        return keys_fail(r, section, "amplitude", "a mode takes one number");
    if (d->node > 0 && isnan(d->amplitude[2]))
        return keys_fail(r, section, "amplitude", "a node takes three numbers");
    if (d->mode > 6 * c->elements)
        return keys_fail(r, section, "mode", "the mesh has fewer modes (six an element)");
    if (d->node >= c->elements)
        return keys_fail(r, section, "node", "must lie between the supports, 1 to elements - 1");
    return SW_OK;
}

/* Default of output_every: 1/50 of the shortest excitation period, without a motion 1/50 of the
 * first lateral period. */
static double output_interval(const struct cable_case *c)
{
    double omega = 0;
    struct line line;

    if (case_sweeps(c))
        omega = fmax(c->sweep.sweep.from, c->sweep.sweep.to);
    for (int i = 0; i < c->n_motions && !case_sweeps(c); i++)
        omega = fmax(omega, c->motion[i].omega);
    for (int i = 0; i < c->n_forces && !case_sweeps(c); i++)
        omega = fmax(omega, c->force[i].omega);
    if (omega == 0 && line_solve(&c->cable, &line) == SW_OK)
        omega = PI / c->cable.span * sqrt(line.H * c->cable.span / (c->cable.mu * c->cable.L0));
    return fmin(fmax(2 * PI / omega / 50, 1e-12), CASE_LARGEST); /* the key's range */
}

/* Count the probes; they must fit on one line when they are printed. */
static enum status resolve_probes(const struct reading *r, struct time_plan *t)
{
    char text[NUMBER_SIZE];
    size_t length = strlen("probes =");

    for (; t->n_probes < MAX_PROBES && !isnan(t->probe[t->n_probes]); t->n_probes++)
        length += 1 + number_print(t->probe[t->n_probes], text);
    return length <= INI_LINE_BYTES
               ? SW_OK
               : keys_fail(r, "time", "probes", "the list, printed, is longer than 198 bytes");
}

/* What belongs to one scheme only. */
static enum status resolve_scheme(const struct reading *r, struct time_plan *t)
{
    if (t->scheme == SCHEME_ALPHA) {
        t->radius = isnan(t->radius) ? 0.8 : t->radius;
        if (t->step > 0 && !isnan(t->tolerance))
            return keys_fail(r, "time", "tolerance", "belongs to step = auto");
        if (!(t->step > 0) && isnan(t->tolerance))
            t->tolerance = 2e-5;
    } else if (!isnan(t->radius)) {
        return keys_fail(r, "time", "radius", "belongs to scheme = alpha");
    } else if (!isnan(t->tolerance)) {
        return keys_fail(r, "time", "tolerance", "belongs to scheme = alpha");
    }
    return SW_OK;
}

static enum status resolve_time(const struct reading *r, struct cable_case *c)
{
    struct time_plan *t = &c->time;
    char mode[64], amplitude[64], extra;
    int n = sscanf(t->start_text, "mode%*[ \t]%63s %63s %c", mode, amplitude, &extra);
    long k = 0;
    enum status s = resolve_probes(r, t);

    if (s == SW_OK)
        s = resolve_scheme(r, t);
    if (s != SW_OK)
        return s;
    if (!isnan(t->end) && !(t->end > 0))
        return keys_fail(r, "time", "end", "must be positive");
    if (isnan(t->end) && case_sweeps(c))
        t->end = c->sweep.sweep.duration;
    if (strcmp(t->start_text, "static") == 0)
        t->start = START_STATIC;
    else if (strcmp(t->start_text, "rest") == 0)
        t->start = START_REST;
    else if (n == 2 && !integer_read(mode, 1, 6L * c->elements, &k) &&
             !number_read(amplitude, &t->start_amplitude))
        t->start = START_MODE;
    else if (strcmp(t->start_text, "mode") != 0 && strncmp(t->start_text, "mode ", 5) != 0)
        t->start = START_STATE;
    else
        return keys_fail(r, "time", "start",
                         "expected mode K AMPLITUDE with a mode that the mesh has");
    t->start_mode = (int)k;
    for (int i = 0; i < c->n_motions && t->start == START_REST; i++)
        if (!(c->motion[i].ramp > 0))
            return keys_fail(r, "time", "start", "rest needs a ramp in each [motion]");
    if (isnan(t->output_every))
        t->output_every = output_interval(c);
    return SW_OK;
}

static enum status resolve_stability(const struct reading *r, struct cable_case *c)
{
    struct stability *p = &c->stability;

    for (; p->n_modes < MAX_STABILITY_MODES && !isnan(p->modes[p->n_modes]); p->n_modes++) {
        double mode = p->modes[p->n_modes];

        if (mode != floor(mode) || mode > 6.0 * c->elements)
            return keys_fail(r, "stability", "modes",
                             "each must be a mode that the mesh has, from 1");
        for (int i = 0; i < p->n_modes; i++)
            if (p->modes[i] == mode)
                return keys_fail(r, "stability", "modes", "a mode is given twice");
        p->mode[p->n_modes] = (int)mode - 1;
    }
    if (p->reference > 6 * c->elements)
        return keys_fail(r, "stability", "reference_mode", "the mesh has fewer modes");
    if (!(p->ratio_end >= p->ratio_start))
        return keys_fail(r, "stability", "ratio_end", "must not lie below ratio_start");
    if (isnan(p->amplitude_end))
        p->amplitude_end = p->method == METHOD_FLOQUET ? 0.1 : 1;
    if (!(p->amplitude_end >= p->amplitude_start))
        return keys_fail(r, "stability", "amplitude_end", "must not lie below amplitude_start");
    return SW_OK;
}

enum status case_resolve(const struct reading *r, struct cable_case *c)
{
    enum status s = case_resolve_model(r, c);

    if (s == SW_OK)
        s = resolve_damping(r, c);
    if (s == SW_OK)
        s = resolve_sweep(r, c);
    for (int i = 0; i < c->n_dampers && s == SW_OK; i++)
        s = resolve_damper(r, c->damper_label[i], &c->damper[i]);
    for (int i = 0; i < c->n_motions && s == SW_OK; i++)
        s = resolve_motion(r, c->motion_label[i], &c->sweep, &c->motion_section[i]);
    for (int i = 0; i < c->n_forces && s == SW_OK; i++)
        s = resolve_force(r, c->force_label[i], &c->force_section[i]);
    if (s == SW_OK)
        s = resolve_wind(r, &c->wind);
    if (s == SW_OK)
        s = resolve_stability(r, c);
    if (s == SW_OK)
        s = collect(r, c);
    for (int i = 0; i < c->n_disturbances && s == SW_OK; i++)
        s = resolve_disturbance(r, c->disturbance_label[i], c, &c->disturbance[i]);
    return s == SW_OK ? resolve_time(r, c) : s;
}
