/* Types of lines from a mooring deck. */
#include "form/cable.h"
#include "form/deckparts.h"
#include "num/mem.h"
#include "sys/in.h"
#include "sys/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NAME, DIAMETER, MASS, EA, COMMON };
#define TABLE_HEADS 3 /* lines before the first pair of a file of tensions */

/* Where the rest stands, by the code that reads such decks; -1: nowhere. */
struct form {
    int columns;
    int EI, friction, cd, cd_axial;
};
static const struct form moordyn2 = {10, 5, -1, 6, 8}, moordyn1 = {9, -1, -1, 7, 8},
                         map = {9, -1, 4, 7, 8};

/* MAP++ has CB in place of BA; MoorDyn v1 has no EI. */
static const struct form *form_of(const struct deck *d)
{
    const struct deck_row *names = &d->names[DECK_TYPES];

    if (deck_find(names, "CB") == 4)
        return &map;
    if (deck_find(names, "EI") == moordyn2.EI)
        return &moordyn2;
    return deck_find(names, "Cdn") >= 0 || deck_find(names, "Cat") >= 0 ||
                   names->n == moordyn1.columns
               ? &moordyn1
               : &moordyn2;
}

enum status deck_name_types(const struct deck *d, struct system *p, struct why *why)
{
    enum status s = roll_begin(&p->types, d->name, why);

    for (int i = deck_next(d, DECK_TYPES, -1); i >= 0 && s == SW_OK;
         i = deck_next(d, DECK_TYPES, i))
        s = roll_add(&p->types, d->row[i].word[NAME], d->row[i].line, why);
    return s;
}

/* One line of a file of tensions: a pair that lies above the one before. */
static enum status take_pair(const char *name, int line, char *text, double before[2],
                             struct why *why)
{
    char *rest = NULL, *word = strtok_r(text, " \t\r\n,", &rest);
    double pair[2];

    for (int k = 0; k < 2; k++, word = strtok_r(NULL, " \t\r\n,", &rest)) {
        const char *reason = word ? number_read(word, &pair[k]) : "a number is missing";

        if (reason)
            return fail(why, SW_FORMAT, "%.400s:%d: %s; strain and tension are expected", name,
                        line, reason);
    }
    if (!(pair[0] > before[0] && pair[1] > before[1] && pair[0] <= 10 && pair[1] <= 1e18))
        return fail(why, SW_FORMAT,
                    "%.400s:%d: strain and tension must ascend, from above zero, up to 10 and "
                    "1e18 N",
                    name, line);
    memcpy(before, pair, 2 * sizeof *pair);
    return SW_OK;
}

/* The pairs of in: strains to table[0], [2], ..., tensions behind them. */
static enum status take_pairs(struct in *in, double **table, int *n, struct why *why)
{
    char text[200];
    double last[2] = {0, 0}, *more;
    enum status s = SW_OK;

    for (int line = 1; s == SW_OK && fgets(text, sizeof text, in->f); line++) {
        if (!strchr(text, '\n') && !feof(in->f))
            return fail(why, SW_FORMAT, "%.400s:%d: the line is longer than %d bytes", in->name,
                        line, (int)sizeof text - 2);
        text[strcspn(text, "#!%")] = '\0';
        if (line <= TABLE_HEADS || text[strspn(text, " \t\r\n")] == '\0')
            continue;
        if (*n == 0 && strtod(text, NULL) == 0 && strspn(text, " \t0.+,eE\r\n") == strlen(text))
            continue; /* the origin belongs to every table */
        s = take_pair(in->name, line, text, last, why);
        if (s != SW_OK)
            break;
        more = mem_resize(*table, 2 * (size_t)*n + 2, sizeof **table);
        if (!more)
            return fail_plain(why, SW_NOMEM);
        *table = more;
        memcpy(more + 2 * *n, last, sizeof last);
        ++*n;
    }
    if (s == SW_OK && ferror(in->f))
        s = fail(why, SW_READ, "%.400s: cannot be read", in->name);
    if (s == SW_OK && *n == 0)
        s = fail(why, SW_FORMAT, "%.400s: no line tells a tension", in->name);
    return s;
}

/* A file of strains and tensions beside the deck. */
static enum status take_table(const struct deck *d, int i, struct system_type *to, struct why *why)
{
    const char *file = d->row[i].word[EA];
    char *path = case_beside(d->name, file);
    double *pairs = NULL;
    int n = 0;
    struct in in = {.f = NULL};
    enum status s = path ? in_open(path, &in, why) : fail_plain(why, SW_NOMEM);

    if (s == SW_READ)
        s = deck_fail(why, d, d->row[i].line,
                      "column %d (EA): '%.60s' is neither a number nor a file", EA + 1, file);
    if (s == SW_OK)
        s = take_pairs(&in, &pairs, &n, why);
    in_close(&in);
    to->table = s == SW_OK ? mem_doubles(2 * (size_t)n) : NULL;
    if (s == SW_OK && !to->table)
        s = fail_plain(why, SW_NOMEM);
    for (int k = 0; k < n && s == SW_OK; k++) {
        to->table[k] = pairs[2 * k];
        to->table[n + k] = pairs[2 * k + 1];
    }
    if (s == SW_OK)
        to->law = (struct rope_law){.EA = to->table[n] / to->table[0],
                                    .n = n,
                                    .strain = to->table,
                                    .tension = to->table + n};
    free(pairs);
    free(path);
    return s;
}

/* EA: a number, the static one before a `|`, or the name of a file. */
static enum status take_stiffness(const struct deck *d, int i, struct system_type *to,
                                  struct why *why)
{
    const char *text = d->row[i].word[EA];
    double said[3] = {NAN};
    int n;
    enum status s;

    if (strspn(text, "+-.0123456789") == 0 && !deck_same(text, "nan") && !deck_same(text, "inf"))
        return take_table(d, i, to, why);
    s = deck_numbers(d, i, EA, 3, said, &n, why);
    to->law.EA = said[0];
    if (s == SW_OK && !(to->law.EA >= 1e-9 && to->law.EA <= 1e18))
        s = deck_fail(why, d, d->row[i].line, "column %d: EA of %.6g is outside of 1e-9 to 1e18",
                      EA + 1, said[0]);
    return s;
}

/* A coefficient of drag; MAP++ has negative ones where there is none. */
static enum status take_drag(const struct deck *d, int i, int column, int none, double *to,
                             struct why *why)
{
    enum status s = deck_number(d, i, column, none ? -1e6 : 0, 1e6, to, why);

    *to = *to < 0 ? 0 : *to;
    return s;
}

static enum status take_type(const struct deck *d, int i, const struct form *f, struct system *p,
                             struct system_type *to, struct why *why)
{
    double EI = 0;
    enum status s = deck_columns(d, i, f->columns, COMMON, why);

    to->breaking = INFINITY;
    to->friction = NAN;
    if (s == SW_OK)
        s = deck_number(d, i, DIAMETER, 0, 1e3, &to->diameter, why);
    if (s == SW_OK)
        s = deck_number(d, i, MASS, 0, DECK_BIG, &to->mass, why);
    if (s == SW_OK)
        s = take_stiffness(d, i, to, why);
    if (s == SW_OK)
        s = take_drag(d, i, f->cd, f == &map, &to->cd, why);
    if (s == SW_OK)
        s = take_drag(d, i, f->cd_axial, f == &map, &to->cd_axial, why);
    if (s == SW_OK && f->friction >= 0)
        s = deck_number(d, i, f->friction, 0, 100, &to->friction, why);
    if (s == SW_OK && f->EI < d->row[i].n && f->EI >= 0 &&
        number_read(d->row[i].word[f->EI], &EI) == NULL && EI != 0)
        s = system_pass(p, 1, why,
                        "%.400s:%d: EI of type '%.60s' is passed over: ropes do not bend", d->name,
                        d->row[i].line, d->row[i].word[NAME]);
    return s;
}

enum status deck_take_types(const struct deck *d, struct system *p, struct why *why)
{
    const struct form *f = form_of(d);
    enum status s = SW_OK;
    int t = 0;

    for (int i = deck_next(d, DECK_TYPES, -1); i >= 0 && s == SW_OK;
         i = deck_next(d, DECK_TYPES, i))
        s = take_type(d, i, f, p, &p->type[t++], why);
    return s;
}
