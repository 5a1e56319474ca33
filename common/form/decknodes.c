/* Points of a mooring deck, and the ends of rods that hold lines. */
#include "form/deckparts.h"
#include "num/pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ID, ATTACHMENT, X, Y, Z, MASS, VOLUME };
#define LEAST_OF_POINT 5

/* Where the rest stands, by the code that reads such decks; -1: nowhere. */
struct form {
    int columns, force, cda;
    int guesses; /* `#` before a number, `depth` */
};
static const struct form moordyn2 = {9, -1, 7, 0}, moordyn1 = {12, 7, 10, 0}, map = {10, 7, -1, 1};

enum {
    ROD_ID,
    ROD_TYPE,
    ROD_ATTACHMENT,
    ROD_A,
    ROD_B = ROD_A + 3,
    ROD_SEGMENTS = ROD_B + 3,
    N_ROD
};

static const struct form *form_of(const struct deck *d)
{
    const struct deck_row *names = &d->names[DECK_POINTS];
    int first = deck_next(d, DECK_POINTS, -1);

    if (deck_find(names, "FX") >= 0)
        return deck_find(names, "CdA") >= 0 ? &moordyn1 : &map;
    return names->n == 0 && first >= 0 && d->row[first].n >= moordyn1.columns ? &moordyn1
                                                                              : &moordyn2;
}

enum status deck_name_nodes(const struct deck *d, const struct deck_options *o, struct system *p,
                            struct why *why)
{
    int n = 0;
    char name[32];
    enum status s = roll_begin(&p->nodes, d->name, why);

    for (int k = 0; k <= o->copies; k++)
        for (int i = deck_next(d, DECK_POINTS, -1); i >= 0 && s == SW_OK;
             i = deck_next(d, DECK_POINTS, i)) {
            n++;
            snprintf(name, sizeof name, "%d", n);
            s = roll_add(&p->nodes, k == 0 ? d->row[i].word[ID] : name, d->row[i].line, why);
        }
    for (int i = deck_next(d, DECK_RODS, -1); i >= 0 && s == SW_OK; i = deck_next(d, DECK_RODS, i))
        for (int end = 0; end < 2 && s == SW_OK; end++) {
            const char *id = d->row[i].word[ROD_ID];

            id += strspn(id, "RODrod");
            if (snprintf(name, sizeof name, "R%s%c", id, "AB"[end]) >= (int)sizeof name)
                return deck_fail(why, d, d->row[i].line, "'%.60s' is no number of a rod", id);
            s = roll_add(&p->nodes, name, d->row[i].line, why);
        }
    return s;
}

/* A number that may be guessed: `#` or `#90`; a bare `#` leaves NAN. */
static enum status guessed(const struct deck *d, int i, int column, double most, double *ret,
                           struct why *why)
{
    char *word = d->row[i].word[column];
    enum status s;

    *ret = NAN;
    if (strcmp(word, "#") == 0)
        return SW_OK;
    d->row[i].word[column] += word[0] == '#';
    s = deck_number(d, i, column, -most, most, ret, why);
    d->row[i].word[column] = word;
    return s;
}

/* Coordinates as a number, a guess, or the depth. */
static enum status take_place(const struct deck *d, int i, const struct form *f,
                              const struct system *p, struct net_node *to, struct why *why)
{
    enum status s = SW_OK;

    for (int c = 0; c < 3 && s == SW_OK; c++) {
        if (f->guesses && c == 2 && deck_same(d->row[i].word[Z], "depth")) {
            if (isnan(p->c.depth))
                return deck_fail(why, d, d->row[i].line,
                                 "the depth stands in no such deck: set environment.depth");
            to->x[2] = -p->c.depth;
        } else if (f->guesses) {
            s = guessed(d, i, X + c, DECK_BIG, &to->x[c], why);
            if (s == SW_OK && isnan(to->x[c]) && to->held)
                s = deck_fail(why, d, d->row[i].line, "column %d: a held node needs its coordinate",
                              X + c + 1);
        } else {
            s = deck_number(d, i, X + c, -DECK_BIG, DECK_BIG, &to->x[c], why);
        }
    }
    return s;
}

/* Steady forces; the reactions of held nodes of MAP++ are no numbers. */
static enum status take_force(const struct deck *d, int i, const struct form *f, int held,
                              double force[3], struct system *p, struct why *why)
{
    const struct deck_row *row = &d->row[i], *units = &d->units[DECK_POINTS];
    int any = 0;
    enum status s = SW_OK;

    for (int c = 0; c < 3 && s == SW_OK && f->force >= 0 && f->force + c < row->n; c++) {
        if (f->guesses)
            s = guessed(d, i, f->force + c, 1e18, &force[c], why);
        else
            s = deck_number(d, i, f->force + c, -1e18, 1e18, &force[c], why);
        if (s == SW_OK && isnan(force[c])) {
            if (!held)
                return deck_fail(why, d, row->line, "column %d: a free node needs its force",
                                 f->force + c + 1);
            force[c] = 0;
        }
        any |= force[c] != 0;
    }
    if (s == SW_OK && any && deck_find(units, "(kN)") >= 0)
        s = system_pass(p, 1, why, "%.400s:%d: forces of points are taken in N, as all decks mean",
                        d->name, row->line);
    return s;
}

/* Turn x and y clockwise, seen from above. */
static void turn_back(double degrees, double v[3])
{
    double c = cos(degrees * PI / 180), s = sin(degrees * PI / 180), x = v[0], y = v[1];

    v[0] = x * c + y * s;
    v[1] = -x * s + y * c;
}

/* What record i says, to node n; k: which copy, 0: itself. */
static enum status take_point(const struct deck *d, int i, const struct form *f,
                              const struct deck_options *o, int k, struct system *p, int n,
                              struct why *why)
{
    const struct deck_row *row = &d->row[i];
    struct system_node *said = &p->node[n];
    struct net_node *to = &p->net.node[n];
    struct deck_place place;
    enum status s = deck_columns(d, i, f->columns, LEAST_OF_POINT, why);

    if (s != SW_OK)
        return s;
    if (!deck_place(row->word[ATTACHMENT], &place) || place.hold == DECK_PINNED)
        return deck_fail(why, d, row->line,
                         "attachment '%.60s' is not known: fixed, coupled, free or Body#",
                         row->word[ATTACHMENT]);
    s = deck_hold(d, i, &place, p, n, why);
    if (s == SW_OK)
        s = take_place(d, i, f, p, to, why);
    if (s == SW_OK)
        s = deck_number(d, i, MASS, 0, 1e15, &said->mass, why);
    if (s == SW_OK)
        s = deck_number(d, i, VOLUME, 0, 1e15, &said->volume, why);
    if (s == SW_OK)
        s = take_force(d, i, f, to->held, said->pull, p, why);
    if (s == SW_OK)
        s = deck_number(d, i, f->cda, 0, 1e15, &said->cda, why);
    if (s == SW_OK && k > 0) {
        turn_back(o->angle[k - 1], to->x);
        turn_back(o->angle[k - 1], said->pull);
    }
    return s == SW_OK ? system_take_node(p, n, why) : s;
}

enum status deck_take_points(const struct deck *d, const struct deck_options *o, struct system *p,
                             struct why *why)
{
    const struct form *f = form_of(d);
    enum status s = SW_OK;
    int n = 0;

    for (int k = 0; k <= o->copies && s == SW_OK; k++)
        for (int i = deck_next(d, DECK_POINTS, -1); i >= 0 && s == SW_OK;
             i = deck_next(d, DECK_POINTS, i))
            s = take_point(d, i, f, o, k, p, n++, why);
    return s;
}

/* Whether the types of rods have the name. */
static int has_rod_type(const struct deck *d, const char *name)
{
    for (int i = deck_next(d, DECK_ROD_TYPES, -1); i >= 0; i = deck_next(d, DECK_ROD_TYPES, i))
        if (strcmp(d->row[i].word[0], name) == 0)
            return 1;
    return 0;
}

/* A rod that holds still has two nodes at its ends; n: the first of them. */
static enum status take_rod(const struct deck *d, int i, struct system *p, int n, struct why *why)
{
    const struct deck_row *row = &d->row[i];
    struct deck_place place;
    double segments;
    enum status s = deck_columns(d, i, N_ROD, ROD_SEGMENTS, why);

    if (s != SW_OK)
        return s;
    if (!has_rod_type(d, row->word[ROD_TYPE]))
        return deck_fail(why, d, row->line, "there is no type of rods '%.60s'",
                         row->word[ROD_TYPE]);
    if (!deck_place(row->word[ROD_ATTACHMENT], &place))
        return deck_fail(why, d, row->line,
                         "attachment '%.60s' is not known: fixed, coupled or Body#",
                         row->word[ROD_ATTACHMENT]);
    s = deck_hold(d, i, &place, p, n, why);
    if (s != SW_OK)
        return s;
    if (place.hold == DECK_FREE || place.hold == DECK_PINNED ||
        (p->net.node[n].body > 0 && !p->net.body[p->net.node[n].body - 1].held))
        return deck_fail(why, d, row->line, "rod %.60s moves: rods only hold lines here",
                         row->word[ROD_ID]);
    p->net.node[n + 1] = p->net.node[n];
    s = deck_number(d, i, ROD_SEGMENTS, 0, 1e6, &segments, why);
    for (int c = 0; c < 3 && s == SW_OK; c++) {
        s = deck_number(d, i, ROD_A + c, -DECK_BIG, DECK_BIG, &p->net.node[n].x[c], why);
        if (s == SW_OK)
            s = deck_number(d, i, ROD_B + c, -DECK_BIG, DECK_BIG, &p->net.node[n + 1].x[c], why);
    }
    if (s == SW_OK && segments == 0) /* no length: the second end tells a direction */
        memcpy(p->net.node[n + 1].x, p->net.node[n].x, sizeof p->net.node[n].x);
    if (s == SW_OK)
        s = system_take_node(p, n, why);
    return s == SW_OK ? system_take_node(p, n + 1, why) : s;
}

enum status deck_take_rods(const struct deck *d, struct system *p, struct why *why)
{
    int n = p->nodes.n - 2 * deck_count(d, DECK_RODS);
    enum status s = SW_OK;

    for (int i = deck_next(d, DECK_RODS, -1); i >= 0 && s == SW_OK;
         i = deck_next(d, DECK_RODS, i), n += 2)
        s = take_rod(d, i, p, n, why);
    return s;
}
