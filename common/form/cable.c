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
#define IN_MOTION(member) offsetof(struct motion, member)
#define IN_DISTURBANCE(member) offsetof(struct disturbance, member)

static const struct key keys[] = {
    {"cable", "unstressed_length", NUMBERS, AT(cable.L0), 1, 1, 1e-6, BIG, NULL, NULL},
    {"cable", "mass_per_length", NUMBERS, AT(cable.mu), 1, 1, 1e-9, BIG, NULL, NULL},
    {"cable", "youngs_modulus", NUMBERS, AT(youngs_modulus), 1, 1, 1e-3, 1e18, NULL, NULL},
    {"cable", "area", NUMBERS, AT(area), 1, 1, 1e-15, BIG, NULL, NULL},
    {"cable", "axial_stiffness", NUMBERS, AT(cable.EA), 1, 1, 1e-9, 1e18, NULL, NULL},
    {"supports", "span", NUMBERS, AT(cable.span), 1, 1, 1e-6, BIG, NULL, NULL},
    {"supports", "drop", NUMBERS, AT(cable.drop), 1, 1, -BIG, BIG, NULL, "0"},
    {"gravity", "acceleration", NUMBERS, AT(cable.g), 1, 1, 0, 1e6, NULL, "9.81"},
    {"mesh", "elements", WHOLE, AT(elements), 1, 1, 1, 1e6, NULL, "20"},
    {"mesh", "law", WORD, AT(law), 1, 1, 0, 0, "hooke thesis printed", "hooke"},
    {"damping", "alpha", NUMBERS, AT(alpha), 1, 1, 0, BIG, NULL, NULL},
    {"damping", "beta", NUMBERS, AT(beta), 1, 1, 0, BIG, NULL, NULL},
    {"damping", "zeta", NUMBERS, AT(zeta), 2, 2, 0, 1e3, NULL, NULL},
    {"damping", "omega", NUMBERS, AT(zeta_omega), 2, 2, 1e-9, BIG, NULL, NULL},
    {"motion", "support", WORD, IN_MOTION(support), 1, 1, 0, 0, "right left", "right"},
    {"motion", "amplitude", NUMBERS, IN_MOTION(amplitude), 3, 3, -BIG, BIG, NULL, NULL},
    {"motion", "omega", NUMBERS, IN_MOTION(omega), 1, 1, 1e-9, BIG, NULL, NULL},
    {"motion", "phase", NUMBERS, IN_MOTION(phase), 1, 3, -BIG, BIG, NULL, "0"},
    {"motion", "ramp", NUMBERS, IN_MOTION(ramp), 1, 1, 0, BIG, NULL, "0"},
    {"time", "end", NUMBERS, AT(time.end), 1, 1, 0, BIG, NULL, NULL},
    {"time", "scheme", WORD, AT(time.scheme), 1, 1, 0, 0, "central", "central"},
    {"time", "step", NUMBERS, AT(time.step), 1, 1, 1e-12, BIG, "auto", "auto"},
    {"time", "start", TEXT, AT(time.start_text), 1, 1, 0, 0, NULL, "static"},
    {"time", "output_every", NUMBERS, AT(time.output_every), 1, 1, 1e-12, BIG, NULL, NULL},
    {"time", "probes", NUMBERS, AT(time.probe), 1, MAX_PROBES, 0, 1, NULL, "0.5"},
    {"nonlinear", "terms", WHOLE, AT(terms), 1, 1, 0, 3, NULL, "3"},
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
                                 void **ret_items, char (**ret_label)[KEYS_TEXT_BYTES], int *ret_n)
{
    size_t room = (size_t)r->ini->n_sections;
    char(*label)[KEYS_TEXT_BYTES] = *ret_label = mem_zeroed(room, sizeof *label);
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
        strcpy(label[n], e->section);
        s = keys_take(r, e->section, items + size * (size_t)n);
        if (s != SW_OK)
            return s;
        n++;
    }
    *ret_n = n;
    return SW_OK;
}

static enum status take_all(const struct reading *r, struct cable_case *c)
{
    void *items = NULL;
    enum status s = keys_judge_names(r);

    for (int i = 0; i < N_KEYS && s == SW_OK; i++)
        if (!section_labelled(r, keys[i].section) &&
            (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0))
            s = keys_take(r, keys[i].section, c);
    if (s == SW_OK) {
        s = take_labelled(r, "motion", sizeof *c->motion, &items, &c->motion_label, &c->n_motions);
        c->motion = items;
    }
    if (s == SW_OK) {
        s = take_labelled(r, "disturbance", sizeof *c->disturbance, &items, &c->disturbance_label,
                          &c->n_disturbances);
        c->disturbance = items;
    }
    return s == SW_OK ? case_resolve(r, c) : s;
}

enum status case_read(FILE *f, const char *name, const struct opt_list *sets,
                      struct cable_case *ret, struct why *why)
{
    struct ini ini;
    struct reading r = {&ini, keys, N_KEYS, "motion disturbance", why};
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
    free(c->motion);
    free(c->motion_label);
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

void case_print(const struct cable_case *c, struct out *o)
{
    struct cable_case shown = *c;

    if (!isnan(shown.youngs_modulus))
        shown.cable.EA = NAN; /* one of the two ways is printed: the one that was given */
    for (int i = 0; i < N_KEYS; i++) {
        const char *section = keys[i].section;

        if (i > 0 && strcmp(section, keys[i - 1].section) == 0)
            continue;
        if (strcmp(section, "motion") == 0)
            for (int j = 0; j < c->n_motions; j++)
                keys_print(keys, N_KEYS, c->motion_label[j], &c->motion[j], o);
        else if (strcmp(section, "disturbance") == 0)
            for (int j = 0; j < c->n_disturbances; j++)
                keys_print(keys, N_KEYS, c->disturbance_label[j], &c->disturbance[j], o);
        else
            keys_print(keys, N_KEYS, section, &shown, o);
    }
}

const char *case_model_difference(const struct cable_case *a, const struct cable_case *b)
{
    const struct cable *p = &a->cable, *q = &b->cable;

    if (p->L0 != q->L0)
        return "cable.unstressed_length";
    if (p->mu != q->mu)
        return "cable.mass_per_length";
    if (p->EA != q->EA)
        return "cable.axial_stiffness";
    if (p->span != q->span)
        return "supports.span";
    if (p->drop != q->drop)
        return "supports.drop";
    if (p->g != q->g)
        return "gravity.acceleration";
    if (a->elements != b->elements)
        return "mesh.elements";
    return a->law != b->law ? "mesh.law" : NULL;
}
