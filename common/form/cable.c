/* Case file to structs and back: one table of keys serves both ways. */
#include "form/cable.h"
#include "form/keys.h"
#include "form/resolve.h"
#include "num/mem.h"
#include "sys/in.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define BIG CASE_LARGEST

#define AT(member) offsetof(struct cable_case, member)
#define IN_DAMPER(member) offsetof(struct damper, member)
#define IN_MOTION(member) offsetof(struct motion_section, member)
#define IN_FORCE(member) offsetof(struct force_section, member)
#define IN_DISTURBANCE(member) offsetof(struct disturbance, member)

static const struct key keys[] = {
    {"cable", "unstressed_length", NUMBERS, AT(bare.L0), 1, 1, CASE_SHORTEST, BIG, NULL, NULL},
    {"cable", "mass_per_length", NUMBERS, AT(bare.mu), 1, 1, 1e-9, BIG, NULL, NULL},
    {"cable", "youngs_modulus", NUMBERS, AT(youngs_modulus), 1, 1, 1e-3, 1e18, NULL, NULL},
    {"cable", "area", NUMBERS, AT(area), 1, 1, 1e-15, BIG, NULL, NULL},
    {"cable", "axial_stiffness", NUMBERS, AT(bare.EA), 1, 1, 1e-9, 1e18, NULL, NULL},
    {"cable", "horizontal_force", NUMBERS, AT(known.value[GIVEN_HORIZONTAL]), 1, 1, 1e-9, 1e18,
     NULL, NULL},
    {"cable", "midspan_tension", NUMBERS, AT(known.value[GIVEN_MIDSPAN]), 1, 1, 1e-9, 1e18, NULL,
     NULL},
    {"cable", "tension_left", NUMBERS, AT(known.value[GIVEN_LEFT]), 1, 1, 1e-9, 1e18, NULL, NULL},
    {"cable", "tension_right", NUMBERS, AT(known.value[GIVEN_RIGHT]), 1, 1, 1e-9, 1e18, NULL, NULL},
    {"cable", "sag", NUMBERS, AT(known.value[GIVEN_SAG]), 1, 1, 1e-9, BIG, NULL, NULL},
    {"cable", "fundamental_frequency", NUMBERS, AT(known.fundamental), 1, 1, 1e-9, BIG, NULL, NULL},
    {"cable", "frequency", NUMBERS, AT(known.value[GIVEN_FREQUENCY]), 1, 1, 1e-9, BIG, NULL, NULL},
    {"cable", "mode", WHOLE, AT(known.mode), 1, 1, 1, 1000, NULL, NULL},
    {"cable", "plane", WORD, AT(known.plane), 1, 1, 0, 0, "out in", NULL},
    {"cable", "branch", WORD, AT(known.slack), 1, 1, 0, 0, "taut slack", NULL},
    {"supports", "span", NUMBERS, AT(bare.span), 1, 1, 1e-6, BIG, NULL, NULL},
    {"supports", "drop", NUMBERS, AT(bare.drop), 1, 1, -BIG, BIG, NULL, "0"},
    {"gravity", "acceleration", NUMBERS, AT(bare.g), 1, 1, 0, 1e6, NULL, "9.81"},
    {"load", "ice_mass_per_length", NUMBERS, AT(load.ice), 1, 1, 0, BIG, NULL, "0"},
    {"load", "wind", NUMBERS, AT(load.wind), 3, 3, -BIG, BIG, NULL, "0 0 0"},
    {"load", "temperature_change", NUMBERS, AT(load.temperature), 1, 1, -1e4, 1e4, NULL, "0"},
    {"load", "expansion_coefficient", NUMBERS, AT(load.expansion), 1, 1, -1e-2, 1e-2, NULL, "0"},
    {"mesh", "elements", WHOLE, AT(elements), 1, 1, 1, 1e6, NULL, "20"},
    {"mesh", "law", WORD, AT(law), 1, 1, 0, 0, "hooke thesis printed", "hooke"},
    {"damping", "alpha", NUMBERS, AT(alpha), 1, 1, 0, BIG, NULL, NULL},
    {"damping", "beta", NUMBERS, AT(beta), 1, 1, 0, BIG, NULL, NULL},
    {"damping", "zeta", NUMBERS, AT(zeta), 2, 2, 0, 1e3, NULL, NULL},
    {"damping", "omega", NUMBERS, AT(zeta_omega), 2, 2, 1e-9, BIG, NULL, NULL},
    {"damper", "position", NUMBERS, IN_DAMPER(position), 1, 1, 0, 1, NULL, NULL},
    {"damper", "direction", NUMBERS, IN_DAMPER(direction), 3, 3, -BIG, BIG, NULL, NULL},
    {"damper", "coefficient", NUMBERS, IN_DAMPER(coefficient), 1, 1, 0, 1e18, NULL, NULL},
    {"motion", "support", WORD, IN_MOTION(motion.support), 1, 1, 0, 0, "right left", "right"},
    {"motion", "amplitude", NUMBERS, IN_MOTION(motion.amplitude), 3, 3, -BIG, BIG, NULL, NULL},
    {"motion", "omega", NUMBERS, IN_MOTION(motion.omega), 1, 1, 1e-9, BIG, NULL, NULL},
    {"motion", "phase", NUMBERS, IN_MOTION(motion.phase), 1, 3, -BIG, BIG, NULL, "0"},
    {"motion", "ramp", NUMBERS, IN_MOTION(motion.ramp), 1, 1, 0, BIG, NULL, "0"},
    {"motion", "file", TEXT, IN_MOTION(file), 1, 1, 0, 0, NULL, NULL},
    {"force", "position", NUMBERS, IN_FORCE(position), 1, 1, 1e-9, 1, "all", NULL},
    {"force", "value", NUMBERS, IN_FORCE(value), 3, 3, -1e18, 1e18, NULL, NULL},
    {"force", "omega", NUMBERS, IN_FORCE(omega), 1, 1, 1e-9, BIG, NULL, NULL},
    {"force", "phase", NUMBERS, IN_FORCE(phase), 1, 1, -BIG, BIG, NULL, NULL},
    {"force", "file", TEXT, IN_FORCE(file), 1, 1, 0, 0, NULL, NULL},
    {"wind", "speed", NUMBERS, AT(wind.speed), 3, 3, -1e3, 1e3, NULL, NULL},
    {"wind", "drag_coefficient", NUMBERS, AT(wind.cd), 1, 1, 1e-9, 1e3, NULL, NULL},
    {"wind", "diameter", NUMBERS, AT(wind.diameter), 1, 1, 1e-6, 1e3, NULL, NULL},
    {"wind", "air_density", NUMBERS, AT(wind.density), 1, 1, 1e-9, 1e5, NULL, NULL},
    {"time", "end", NUMBERS, AT(time.end), 1, 1, 0, BIG, NULL, NULL},
    {"time", "scheme", WORD, AT(time.scheme), 1, 1, 0, 0, "central alpha", "central"},
    {"time", "step", NUMBERS, AT(time.step), 1, 1, 1e-12, BIG, "auto", "auto"},
    {"time", "radius", NUMBERS, AT(time.radius), 1, 1, 0, 1, NULL, NULL},
    {"time", "tolerance", NUMBERS, AT(time.tolerance), 1, 1, 1e-12, 1, NULL, NULL},
    {"time", "start", TEXT, AT(time.start_text), 1, 1, 0, 0, NULL, "static"},
    {"time", "output_every", NUMBERS, AT(time.output_every), 1, 1, 1e-12, BIG, NULL, NULL},
    {"time", "field_every", NUMBERS, AT(time.field_every), 1, 1, 1e-12, BIG, NULL, NULL},
    {"time", "probes", NUMBERS, AT(time.probe), 1, MAX_PROBES, 0, 1, NULL, "0.5"},
    {"nonlinear", "terms", WHOLE, AT(terms), 1, 1, 0, 3, NULL, "3"},
    {"sweep", "from", NUMBERS, AT(sweep.sweep.from), 1, 1, 1e-9, BIG, NULL, NULL},
    {"sweep", "to", NUMBERS, AT(sweep.sweep.to), 1, 1, 1e-9, BIG, NULL, NULL},
    {"sweep", "rate", NUMBERS, AT(sweep.sweep.rate), 1, 1, 1e-12, BIG, NULL, NULL},
    {"sweep", "step", NUMBERS, AT(sweep.sweep.step), 1, 1, 1e-12, BIG, NULL, NULL},
    {"sweep", "dwell", WHOLE, AT(sweep.sweep.dwell), 1, 1, 1, 1e9, NULL, NULL},
    {"sweep", "back", WORD, AT(sweep.sweep.back), 1, 1, 0, 0, "no yes", NULL},
    {"sweep", "seed", NUMBERS, AT(sweep.seed), 1, 1, 0, BIG, NULL, NULL},
    {"sweep", "window", WHOLE, AT(sweep.window), 1, 1, 1, 1e9, NULL, NULL},
    {"steady", "tolerance", NUMBERS, AT(steady.tolerance), 1, 1, 1e-12, 1, NULL, "1e-4"},
    {"steady", "periods", WHOLE, AT(steady.periods), 1, 1, 2, 1e6, NULL, "20"},
    {"stability", "method", WORD, AT(stability.method), 1, 1, 0, 0, "bolotin floquet", "bolotin"},
    {"stability", "theory", WORD, AT(stability.theory), 1, 1, 0, 0, "indifference classical",
     "indifference"},
    {"stability", "quadratic", WORD, AT(stability.quadratic), 1, 1, 0, 0, "no yes", "no"},
    {"stability", "ground", WORD, AT(stability.undamped), 1, 1, 0, 0, "damped undamped", "damped"},
    {"stability", "modes", NUMBERS, AT(stability.modes), 1, MAX_STABILITY_MODES, 1, 6e6, NULL,
     "1 2"},
    {"stability", "harmonics", WHOLE, AT(stability.harmonics), 1, 1, 1, 99, NULL, "9"},
    {"stability", "ratio_start", NUMBERS, AT(stability.ratio_start), 1, 1, 1e-3, 1e3, NULL, "0.4"},
    {"stability", "ratio_end", NUMBERS, AT(stability.ratio_end), 1, 1, 1e-3, 1e3, NULL, "1.2"},
    {"stability", "ratio_step", NUMBERS, AT(stability.ratio_step), 1, 1, 1e-9, 1e3, NULL, "0.005"},
    {"stability", "reference_mode", WHOLE, AT(stability.reference), 1, 1, 1, 6e6, NULL, "1"},
    {"stability", "amplitude_start", NUMBERS, AT(stability.amplitude_start), 1, 1, 0, BIG, NULL,
     "0"},
    {"stability", "amplitude_end", NUMBERS, AT(stability.amplitude_end), 1, 1, 1e-12, BIG, NULL,
     NULL},
    {"stability", "amplitude_step", NUMBERS, AT(stability.amplitude_step), 1, 1, 1e-12, BIG, NULL,
     "0.001"},
    {"disturbance", "time", NUMBERS, IN_DISTURBANCE(time), 1, 1, 0, BIG, NULL, "0"},
    {"disturbance", "mode", WHOLE, IN_DISTURBANCE(mode), 1, 1, 1, 6e6, NULL, NULL},
    {"disturbance", "node", WHOLE, IN_DISTURBANCE(node), 1, 1, 1, 1e6, NULL, NULL},
    {"disturbance", "amplitude", NUMBERS, IN_DISTURBANCE(amplitude), 1, 3, -BIG, BIG, NULL, NULL},
    {"disturbance", "kind", WORD, IN_DISTURBANCE(kind), 1, 1, 0, 0, "displacement velocity",
     "displacement"},
};
#define N_KEYS ((int)(sizeof keys / sizeof *keys))

/* The sections called name, with or without label, in order: items of size bytes and their labels,
 * allocated. */
static enum status take_labelled(const struct reading *r, const char *name, size_t size,
                                 void **ret_items, char (**ret_label)[KEYS_LABEL_BYTES], int *ret_n)
{
    size_t room = (size_t)r->ini->n_sections;
    char(*label)[KEYS_LABEL_BYTES] = *ret_label = mem_zeroed(room, sizeof *label);
    char *items = *ret_items = mem_zeroed(room, size);
    int n = 0;

    if (!label || !items)
        return fail_plain(r->why, SW_NOMEM);
    for (int i = 0; i < r->ini->n_sections; i++) {
        const struct ini_entry *e = &r->ini->section[i];
        int known = 0;
        enum status s;

        for (int j = 0; j < n; j++)
            known |= strcmp(label[j], e->section) == 0;
        if (known || !section_is(e->section, name))
            continue;
        snprintf(label[n], sizeof *label, "%s", e->section);
        s = keys_take(r, e->section, items + size * (size_t)n);
        if (s != SW_OK)
            return s;
        n++;
    }
    *ret_n = n;
    return SW_OK;
}

/* The sections that may carry a label. */
#define LABELLED "damper motion force disturbance"

static enum status take_all(const struct reading *r, struct cable_case *c)
{
    struct {
        const char *name;
        size_t size;
        void *items; /* the place of a pointer to them */
        char (**label)[KEYS_LABEL_BYTES];
        int *n;
    } labelled[] = {
        {"damper", sizeof *c->damper, &c->damper, &c->damper_label, &c->n_dampers},
        {"motion", sizeof *c->motion_section, &c->motion_section, &c->motion_label, &c->n_motions},
        {"force", sizeof *c->force_section, &c->force_section, &c->force_label, &c->n_forces},
        {"disturbance", sizeof *c->disturbance, &c->disturbance, &c->disturbance_label,
         &c->n_disturbances},
    };
    enum status s = keys_judge_names(r);

    for (int i = 0; i < N_KEYS && s == SW_OK; i++)
        if (!section_labelled(r, keys[i].section) &&
            (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0))
            s = keys_take(r, keys[i].section, c);
    for (size_t i = 0; i < sizeof labelled / sizeof *labelled && s == SW_OK; i++) {
        void *items = NULL;

        s = take_labelled(r, labelled[i].name, labelled[i].size, &items, labelled[i].label,
                          labelled[i].n);
        memcpy(labelled[i].items, &items, sizeof items);
    }
    return s == SW_OK ? case_resolve(r, c) : s;
}

enum status case_read(FILE *f, const char *name, const struct opt_list *sets,
                      struct cable_case *ret, struct why *why)
{
    struct ini ini;
    struct reading r = {&ini, NULL, keys, N_KEYS, LABELLED, why};
    enum status s = ini_read(f, name, &ini, why);

    memset(ret, 0, sizeof *ret);
    for (int i = 0; sets && i < sets->n && s == SW_OK; i++)
        s = ini_set(&ini, sets->item[i], why);
    if (s == SW_OK && ini.n == 0)
        s = fail(why, SW_FORMAT,
                 "%s: is empty; a case with at least [cable] and [supports] is "
                 "expected",
                 name);
    if (s == SW_OK)
        s = take_all(&r, ret);
    if (s != SW_OK)
        case_free(ret);
    ini_free(&ini);
    return s;
}

void case_free(struct cable_case *c)
{
    sweep_free(&c->sweep.sweep);
    free(c->damper);
    free(c->damper_label);
    for (int i = 0; i < c->n_motions; i++)
        series_free(&c->motion_section[i].record);
    for (int i = 0; i < c->n_forces; i++)
        series_free(&c->force_section[i].record);
    free(c->motion_section);
    free(c->motion);
    free(c->motion_label);
    free(c->force_section);
    free(c->force);
    free(c->force_label);
    free(c->disturbance);
    free(c->disturbance_label);
    memset(c, 0, sizeof *c);
}

enum status case_load(const char *path, const struct opt_list *sets, struct cable_case *ret,
                      struct why *why)
{
    struct in in;
    enum status s = in_open(path, &in, why);

    if (s != SW_OK)
        return s;
    s = case_read(in.f, in.name, sets, ret, why);
    in_close(&in);
    return s;
}

int case_sweeps(const struct cable_case *c)
{
    return !isnan(c->sweep.sweep.from);
}

const char *case_model_name(int i)
{
    return i < N_KEYS && strcmp(keys[i].section, "damping") != 0 ? keys[i].name : NULL;
}

const struct key *case_model_key(const char *name)
{
    const char *dot = strchr(name, '.');

    /* the model sections come first in the table */
    for (int i = 0; i < N_KEYS && strcmp(keys[i].section, "damping") != 0; i++) {
        size_t length = strlen(keys[i].section);

        if (strcmp(dot ? dot + 1 : name, keys[i].name) == 0 &&
            (!dot ||
             ((size_t)(dot - name) == length && strncmp(name, keys[i].section, length) == 0)))
            return &keys[i];
    }
    return NULL;
}

int case_knows(const char *name)
{
    const struct reading r = {NULL, NULL, keys, N_KEYS, LABELLED, NULL};
    const char *dot = strrchr(name, '.');
    char section[KEYS_LABEL_BYTES];

    if (!dot || dot - name >= KEYS_LABEL_BYTES)
        return 0;
    memcpy(section, name, (size_t)(dot - name));
    section[dot - name] = '\0';
    for (int i = 0; i < N_KEYS; i++)
        if (section_is(section, keys[i].section) && strcmp(dot + 1, keys[i].name) == 0)
            return strcmp(section, keys[i].section) == 0 || section_labelled(&r, section);
    return 0;
}

enum status case_model_defaults(const struct opt_list *sets, struct cable_case *c, struct why *why)
{
    struct ini ini = {0};
    struct reading r = {&ini, NULL, keys, N_KEYS, LABELLED, why};
    enum status s = SW_OK;

    memset(c, 0, sizeof *c);
    for (int i = 0; i < sets->n && s == SW_OK; i++)
        s = ini_set(&ini, sets->item[i], why);
    if (s == SW_OK)
        s = keys_judge_names(&r);
    for (int i = 0; i < ini.n && s == SW_OK; i++) {
        char name[2 * KEYS_TEXT_BYTES];

        snprintf(name, sizeof name, "%s.%s", ini.entry[i].section, ini.entry[i].key);
        if (!case_model_key(name))
            s = ini_fail(why, &ini, &ini.entry[i], "belongs to no section of the model");
    }
    for (int i = 0; i < N_KEYS && s == SW_OK; i++)
        if (case_model_key(keys[i].name) == &keys[i] &&
            (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0))
            s = keys_take(&r, keys[i].section, c);
    ini_free(&ini);
    return s;
}

enum status case_model(const struct cable_case *c, struct model *ret)
{
    enum status s = model_new(&c->cable, (enum law)c->law, c->elements, ret);

    ret->axes = c->axes;
    return s;
}

/* Print the labelled section that heads the keys from first on, all its instances; 0: it is none.
 */
static int print_labelled(const struct cable_case *c, const char *section, struct out *o)
{
    const struct {
        const char *name;
        int n;
        const void *items;
        size_t size;
        char (*label)[KEYS_LABEL_BYTES];
    } labelled[] = {
        {"damper", c->n_dampers, c->damper, sizeof *c->damper, c->damper_label},
        {"motion", c->n_motions, c->motion_section, sizeof *c->motion_section, c->motion_label},
        {"force", c->n_forces, c->force_section, sizeof *c->force_section, c->force_label},
        {"disturbance", c->n_disturbances, c->disturbance, sizeof *c->disturbance,
         c->disturbance_label},
    };

    for (size_t i = 0; i < sizeof labelled / sizeof *labelled; i++) {
        if (strcmp(section, labelled[i].name) != 0)
            continue;
        for (int j = 0; j < labelled[i].n; j++)
            keys_print(keys, N_KEYS, labelled[i].label[j],
                       (const char *)labelled[i].items + labelled[i].size * (size_t)j, o);
        return 1;
    }
    return 0;
}

void case_print(const struct cable_case *c, struct out *o)
{
    struct cable_case shown = *c;

    if (!isnan(shown.youngs_modulus))
        shown.bare.EA = NAN; /* one of the two ways is printed: the one that was given */
    for (int i = 0; i < N_KEYS; i++) {
        const char *section = keys[i].section;

        if ((i == 0 || strcmp(section, keys[i - 1].section) != 0) && !print_labelled(c, section, o))
            keys_print(keys, N_KEYS, section, &shown, o);
    }
}

const char *case_model_difference(const struct cable_case *a, const struct cable_case *b)
{
    const struct cable *p = &a->bare, *q = &b->bare;
    const struct load *u = &a->load, *v = &b->load;
    const struct {
        const char *name;
        double a, b;
    } value[] = {
        {"cable.unstressed_length", p->L0, q->L0},
        {"cable.mass_per_length", p->mu, q->mu},
        {"cable.axial_stiffness", p->EA, q->EA},
        {"supports.span", p->span, q->span},
        {"supports.drop", p->drop, q->drop},
        {"gravity.acceleration", p->g, q->g},
        {"load.ice_mass_per_length", u->ice, v->ice},
        {"load.wind", u->wind[0], v->wind[0]},
        {"load.wind", u->wind[1], v->wind[1]},
        {"load.wind", u->wind[2], v->wind[2]},
        {"load.temperature_change", u->temperature, v->temperature},
        {"load.expansion_coefficient", u->expansion, v->expansion},
        {"mesh.elements", a->elements, b->elements},
        {"mesh.law", a->law, b->law},
    };

    for (size_t i = 0; i < sizeof value / sizeof *value; i++)
        if (value[i].a != value[i].b)
            return value[i].name;
    return NULL;
}

void case_name_keys(FILE *f)
{
    keys_name(keys, N_KEYS, f);
}
