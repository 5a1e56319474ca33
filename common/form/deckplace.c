/* Of what the points of a mooring deck are part: the ground, nothing, or a rigid body. */
#include "form/deckparts.h"
#include "num/mem.h"
#include "num/pi.h"
#include "phys/attitude.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ID, ATTACHMENT, X, ROLL = X + 3, MASS = ROLL + 3, CG, INERTIA, VOLUME, CDA, CA, N_BODY };
#define LEAST_OF_BODY 8

static const struct {
    const char *word;
    enum deck_hold hold;
} attachment[] = {
    {"FIXED", DECK_FIXED},    {"FIX", DECK_FIXED},
    {"ANCHOR", DECK_FIXED},   {"VESSEL", DECK_COUPLED},
    {"VES", DECK_COUPLED},    {"COUPLED", DECK_COUPLED},
    {"CPLD", DECK_COUPLED},   {"FAIRLEAD", DECK_COUPLED},
    {"POINT", DECK_FREE},     {"CONNECT", DECK_FREE},
    {"CON", DECK_FREE},       {"FREE", DECK_FREE},
    {"BODY", DECK_BODY},      {"TURBINE", DECK_TURBINE},
    {"T", DECK_TURBINE},      {"PINNED", DECK_PINNED},
    {"PIN", DECK_PINNED},     {"COUPLEDPINNED", DECK_PINNED},
    {"CPLDPIN", DECK_PINNED}, {"VESSELPINNED", DECK_PINNED},
    {"VESPIN", DECK_PINNED},
};

int deck_place(const char *word, struct deck_place *ret)
{
    size_t letters = 0, digits = 0;
    const char *rest;

    *ret = (struct deck_place){DECK_FREE, ""};
    while (isalpha((unsigned char)word[letters]))
        letters++;
    while (isdigit((unsigned char)word[letters + digits]))
        digits++;
    rest = word + letters + digits;
    if (digits >= sizeof ret->number)
        return 0;
    memcpy(ret->number, word + letters, digits);
    for (size_t k = 0; k < sizeof attachment / sizeof *attachment; k++) {
        int numbered = attachment[k].hold == DECK_BODY || attachment[k].hold == DECK_TURBINE;

        if (strlen(attachment[k].word) != letters ||
            strncasecmp(attachment[k].word, word, letters) != 0 || numbered != (digits > 0))
            continue;
        ret->hold = attachment[k].hold;
        if (*rest != '\0' && numbered && (deck_same(rest, "PINNED") || deck_same(rest, "PIN")))
            ret->hold = DECK_PINNED;
        else if (*rest != '\0')
            return 0;
        return 1;
    }
    return 0;
}

/* Which column of a section holds the attachment. */
static int attachment_column(enum deck_section section)
{
    return section == DECK_RODS ? 2 : 1;
}

/* The name of the body of a place; "" where it has none. */
static void name_body(const struct deck_place *place, char ret[32])
{
    ret[0] = '\0';
    if (place->hold == DECK_COUPLED)
        snprintf(ret, 32, "vessel");
    else if (place->hold == DECK_BODY)
        snprintf(ret, 32, "body%s", place->number);
    else if (place->hold == DECK_TURBINE)
        snprintf(ret, 32, "turbine%s", place->number);
}

/* Bodies that no section lists: the vessel, turbines; of the points and rods that sit there. */
static enum status name_unlisted(const struct deck *d, enum deck_hold hold, struct system *p,
                                 struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i < d->n && s == SW_OK; i++) {
        const struct deck_row *row = &d->row[i];
        int column = attachment_column(row->section);
        struct deck_place place;
        char name[32];

        if ((row->section != DECK_POINTS && row->section != DECK_RODS) || row->n <= column ||
            !deck_place(row->word[column], &place) || place.hold != hold)
            continue;
        name_body(&place, name);
        if (roll_search(&p->bodies, name, strlen(name)) < 0)
            s = roll_add(&p->bodies, name, row->line, why);
    }
    return s;
}

enum status deck_name_bodies(const struct deck *d, struct system *p, struct why *why)
{
    enum status s = roll_begin(&p->bodies, d->name, why);

    if (s == SW_OK)
        s = name_unlisted(d, DECK_COUPLED, p, why);
    for (int i = deck_next(d, DECK_BODIES, -1); i >= 0 && s == SW_OK;
         i = deck_next(d, DECK_BODIES, i)) {
        struct deck_place place = {DECK_BODY, ""};
        const char *id = d->row[i].word[0];
        char name[32];
        size_t length;

        id += strspn(id, "BODYbody");
        length = strlen(id);
        if (length == 0 || length >= sizeof place.number || strspn(id, "0123456789") != length)
            return deck_fail(why, d, d->row[i].line, "'%.60s' is no number of a body",
                             d->row[i].word[0]);
        memcpy(place.number, id, length + 1);
        name_body(&place, name);
        s = roll_add(&p->bodies, name, d->row[i].line, why);
    }
    return s == SW_OK ? name_unlisted(d, DECK_TURBINE, p, why) : s;
}

/* R of roll, pitch and yaw [deg]: each turns about an axis that the ones before it have turned. */
static void turn_by(const double angle[3], double R[9])
{
    const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    memcpy(R, one, sizeof one);
    for (int k = 2; k >= 0; k--) {
        double w[3] = {0, 0, 0};

        w[k] = angle[k] * PI / 180;
        attitude_turn(w, R);
    }
}

/* The centre of gravity: z, or x|y|z. */
static enum status take_centre(const struct deck *d, int i, double cg[3], struct why *why)
{
    double said[3] = {0, 0, 0};
    int n = 0;
    enum status s;

    if (d->row[i].n <= CG)
        return SW_OK;
    s = deck_numbers(d, i, CG, 3, said, &n, why);
    if (s == SW_OK && n == 2)
        return deck_fail(why, d, d->row[i].line, "column %d: one number, or x|y|z", CG + 1);
    for (int c = 0; c < 3; c++)
        cg[c] = n == 3 ? said[c] : c == 2 ? said[0] : 0;
    for (int c = 0; c < 3 && s == SW_OK; c++)
        if (!(fabs(cg[c]) <= DECK_BIG))
            s = deck_fail(why, d, d->row[i].line, "column %d: %.6g is outside of %g to %g", CG + 1,
                          cg[c], -DECK_BIG, DECK_BIG);
    return s;
}

static enum status take_body(const struct deck *d, int i, struct system_body *said,
                             struct net_body *to, struct why *why)
{
    const struct deck_row *row = &d->row[i];
    struct deck_place place;
    double angle[3];
    enum status s = deck_columns(d, i, N_BODY, LEAST_OF_BODY, why);

    if (s != SW_OK)
        return s;
    if (!deck_place(row->word[ATTACHMENT], &place) || place.hold == DECK_BODY ||
        place.hold == DECK_TURBINE)
        return deck_fail(why, d, row->line,
                         "attachment '%.60s' is not known: fixed, coupled or free",
                         row->word[ATTACHMENT]);
    if (place.hold == DECK_PINNED)
        return deck_fail(why, d, row->line,
                         "body %.60s is pinned: only bodies that are held or "
                         "free in all directions are known here",
                         row->word[ID]);
    to->held = place.hold != DECK_FREE;
    for (int c = 0; c < 3 && s == SW_OK; c++) {
        s = deck_number(d, i, X + c, -DECK_BIG, DECK_BIG, &to->x[c], why);
        if (s == SW_OK)
            s = deck_number(d, i, ROLL + c, -3600, 3600, &angle[c], why);
    }
    if (s != SW_OK)
        return s;
    turn_by(angle, to->R);
    s = deck_number(d, i, MASS, 0, 1e15, &said->mass, why);
    if (s == SW_OK)
        s = take_centre(d, i, to->cg, why);
    return s == SW_OK ? deck_number(d, i, VOLUME, 0, 1e15, &said->volume, why) : s;
}

enum status deck_take_bodies(const struct deck *d, struct system *p, struct why *why)
{
    static const double none[3] = {0, 0, 0};
    int row = -1;
    struct roll_index index = {NULL, 0};
    enum status s = roll_sort(&p->bodies, &index, why);

    free(index.at);
    for (int b = 0; b < p->bodies.n && s == SW_OK; b++) {
        struct net_body *to = &p->net.body[b];

        if (strncmp(roll_name(&p->bodies, b), "body", 4) == 0) {
            row = deck_next(d, DECK_BODIES, row);
            s = take_body(d, row, &p->body[b], to, why);
        } else {
            to->held = 1;
            turn_by(none, to->R);
            if (strncmp(roll_name(&p->bodies, b), "turbine", 7) == 0)
                s = system_pass(p, 1, why,
                                "%.400s:%d: %s is taken to stand at the origin: a deck does not "
                                "tell its place",
                                d->name, p->bodies.item[b].line, roll_name(&p->bodies, b));
        }
        if (s == SW_OK)
            s = system_take_body(p, b, why);
    }
    return s;
}

enum status deck_hold(const struct deck *d, int row, const struct deck_place *place,
                      struct system *p, int i, struct why *why)
{
    struct net_node *to = &p->net.node[i];
    char name[32];

    to->held = place->hold == DECK_FREE ? 0 : 7;
    name_body(place, name);
    if (name[0] == '\0')
        return SW_OK;
    to->body = roll_search(&p->bodies, name, strlen(name)) + 1;
    return to->body > 0
               ? SW_OK
               : deck_fail(why, d, d->row[row].line, "there is no body '%s'", place->number);
}
