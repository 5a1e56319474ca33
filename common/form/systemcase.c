/* The case of a system of ropes: its keys. */
#include "form/cable.h"
#include "form/deck.h"
#include "form/system.h"
#include "sys/in.h"

#include <math.h>
#include <string.h>

#define AT(member) offsetof(struct system_case, member)
#define BIG CASE_LARGEST

static const struct key keys[] = {
    {"environment", "gravity", NUMBERS, AT(gravity), 1, 1, 0, 1e6, NULL, "9.81"},
    {"environment", "water_density", NUMBERS, AT(density), 1, 1, 0, 1e5, NULL, "1025"},
    {"environment", "depth", NUMBERS, AT(depth), 1, 1, -BIG, BIG, NULL, NULL},
    {"environment", "bed_slope", NUMBERS, AT(slope), 2, 2, -10, 10, NULL, "0 0"},
    {"environment", "bed", TEXT, AT(bed), 1, 1, 0, 0, NULL, NULL},
    {"environment", "bed_friction", NUMBERS, AT(friction), 1, 1, 0, 100, NULL, NULL},
    {"tables", "nodes", TEXT, AT(nodes), 1, 1, 0, 0, NULL, "nodes.csv"},
    {"tables", "ropes", TEXT, AT(ropes), 1, 1, 0, 0, NULL, "ropes.csv"},
    {"tables", "types", TEXT, AT(types), 1, 1, 0, 0, NULL, "types.csv"},
    {"tables", "loads", TEXT, AT(loads), 1, 1, 0, 0, NULL, NULL},
    {"tables", "current", TEXT, AT(current), 1, 1, 0, 0, NULL, NULL},
    {"tables", "bodies", TEXT, AT(bodies), 1, 1, 0, 0, NULL, NULL},
    {"solve", "method", WORD, AT(method), 1, 1, 0, 0, "gap displacement imaginary", "gap"},
    {"solve", "rope", WORD, AT(rope), 1, 1, 0, 0, "auto chain catenary", "auto"},
    {"solve", "elements", WHOLE, AT(elements), 1, 1, 1, 1e6, NULL, "20"},
    {"solve", "tolerance", NUMBERS, AT(tolerance), 1, 1, 1e-15, 1e-3, NULL, "5e-10"},
    {"solve", "steps", WHOLE, AT(steps), 1, 1, 1, 1e7, NULL, "1000"},
    {"solve", "start", WORD, AT(start), 1, 1, 0, 0, "exact closed fictitious", "exact"},
    {"solve", "start_steps", WHOLE, AT(start_steps), 1, 1, 1, 1e6, NULL, "5"},
    {"solve", "step", WORD, AT(pull), 1, 1, 0, 0, "constant unit span", "constant"},
    {"solve", "drag", WORD, AT(drag), 1, 1, 0, 0, "renew hold", "renew"},
};
#define N_KEYS ((int)(sizeof keys / sizeof *keys))

static enum status take_keys(const struct reading *r, struct system_case *c)
{
    enum status s = keys_judge_names(r);

    for (int i = 0; i < N_KEYS && s == SW_OK; i++)
        if (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0)
            s = keys_take(r, keys[i].section, c);
    return s;
}

enum status system_case_take(const struct ini *ini, struct system_case *ret, struct why *why)
{
    struct reading r = {ini, NULL, keys, N_KEYS, "", why};

    *ret = (struct system_case){.is_deck = 0};
    return take_keys(&r, ret);
}

/* The sections of a case file; of a deck, what it says in their place. */
static enum status read_sections(const char *path, int is_deck, struct ini *ini, struct why *why)
{
    struct in in;
    enum status s;

    if (is_deck)
        return deck_sections(path, ini, why);
    s = in_open(path, &in, why);
    if (s != SW_OK)
        return s;
    s = ini_read(in.f, in.name, ini, why);
    in_close(&in);
    return s;
}

enum status system_case_load(const char *path, const struct opt_list *sets, struct system_case *ret,
                             struct why *why)
{
    struct ini ini = {0};
    int is_deck = 0;
    enum status s = deck_recognize(path, &is_deck, why);

    if (s == SW_OK)
        s = read_sections(path, is_deck, &ini, why);
    for (int i = 0; i < sets->n && s == SW_OK; i++)
        s = ini_set(&ini, sets->item[i], why);
    if (s == SW_OK)
        s = system_case_take(&ini, ret, why);
    ret->is_deck = is_deck;
    ini_free(&ini);
    return s;
}

void system_case_print(const struct system_case *c, struct out *o)
{
    for (int i = 0; i < N_KEYS; i++)
        if (i == 0 || strcmp(keys[i].section, keys[i - 1].section) != 0)
            keys_print(keys, N_KEYS, keys[i].section, c, o);
}

void system_name_keys(FILE *f)
{
    keys_name(keys, N_KEYS, f);
}
