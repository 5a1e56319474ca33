/* Lines of a mooring deck. */
#include "form/deckparts.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ID, TYPE };
#define LEAST_OF_LINE 5

/* Where the rest stands, by the code that reads such decks; -1: nowhere. */
struct form {
    int columns, end[2], length, segments;
};
static const struct form moordyn2 = {6, {2, 3}, 4, 5}, moordyn1 = {6, {4, 5}, 2, 3},
                         map = {5, {3, 4}, 2, -1};

/* Words behind a line of MAP++ that make another line of it. */
static const char *const flag[] = {"OMIT_CONTACT", "LINEAR_SPRING", "DAMAGE_TIME"};

static int begins(const char *word, const char *with)
{
    return strncasecmp(word, with, strlen(with)) == 0;
}

/* The length stands behind the ends, or before them; then segments may follow it. */
static const struct form *form_of(const struct deck *d)
{
    const struct deck_row *names = &d->names[DECK_LINES];

    if (names->n <= moordyn1.segments ||
        !(begins(names->word[moordyn1.length], "Unstr") || begins(names->word[2], "Len")))
        return &moordyn2;
    return begins(names->word[moordyn1.segments], "Num") ? &moordyn1 : &map;
}

enum status deck_name_lines(const struct deck *d, const struct deck_options *o, struct system *p,
                            struct why *why)
{
    int n = 0;
    enum status s = roll_begin(&p->ropes, d->name, why);

    for (int k = 0; k <= o->copies; k++)
        for (int i = deck_next(d, DECK_LINES, -1); i >= 0 && s == SW_OK;
             i = deck_next(d, DECK_LINES, i)) {
            char name[16];

            snprintf(name, sizeof name, "%d", ++n);
            s = roll_add(&p->ropes, k == 0 ? d->row[i].word[ID] : name, d->row[i].line, why);
        }
    return s;
}

/* The node of an end: its name, a number with letters before it, or R#A, R#B; -1: none. */
static int find_end(const struct system *p, const struct roll_index *nodes, const char *word)
{
    int found = roll_find(&p->nodes, nodes, word);
    size_t letters = 0;
    char rod[32];

    while (isalpha((unsigned char)word[letters]))
        letters++;
    if (found >= 0 || letters == 0)
        return found;
    if (strchr("Rr", word[0]) && strlen(word) < sizeof rod - 1) {
        snprintf(rod, sizeof rod, "R%s", word + letters);
        for (char *c = rod; *c; c++)
            *c = (char)toupper((unsigned char)*c);
        return roll_find(&p->nodes, nodes, rod);
    }
    return roll_find(&p->nodes, nodes, word + letters);
}

static enum status judge_flags(const struct deck *d, int i, const struct form *f, struct why *why)
{
    const struct deck_row *row = &d->row[i];

    for (int k = f->columns; f == &map && k < row->n; k++)
        for (size_t j = 0; j < sizeof flag / sizeof *flag; j++)
            if (deck_same(row->word[k], flag[j]))
                return deck_fail(why, d, row->line, "line %.60s: %s is not known to statics here",
                                 row->word[ID], flag[j]);
    return SW_OK;
}

/* What record i says, to rope r; shift: nodes between those of the record and of the copy. */
static enum status take_line(const struct deck *d, int i, const struct form *f,
                             const struct roll_index *nodes, int shift, struct system *p, int r,
                             struct why *why)
{
    const struct deck_row *row = &d->row[i];
    struct net_rope *to = &p->net.rope[r];
    int end[2], chain = p->c.rope == ROPE_CHAIN || p->c.method == NET_DISPLACEMENT;
    double segments = 0;
    enum status s = deck_columns(d, i, f->columns, LEAST_OF_LINE, why);

    if (s == SW_OK)
        s = judge_flags(d, i, f, why);
    if (s != SW_OK)
        return s;
    p->type_of[r] = roll_search(&p->types, row->word[TYPE], strlen(row->word[TYPE]));
    if (p->type_of[r] < 0)
        return deck_fail(why, d, row->line, "there is no type of lines '%.60s'", row->word[TYPE]);
    for (int k = 0; k < 2; k++) {
        end[k] = find_end(p, nodes, row->word[f->end[k]]);
        if (end[k] < 0 || end[k] + shift >= p->nodes.n) /* a copy has no copies */
            return deck_fail(why, d, row->line, "there is no point '%.60s'", row->word[f->end[k]]);
    }
    to->a = end[0] + shift;
    to->b = end[1] + shift;
    s = deck_number(d, i, f->length, 1e-9, DECK_BIG, &to->rope.L0, why);
    if (s == SW_OK)
        s = deck_number(d, i, f->segments, 1, 1e6, &segments, why);
    if (s == SW_OK && segments != floor(segments))
        s = deck_fail(why, d, row->line, "column %d: a whole number is expected", f->segments + 1);
    p->segments[r] = s == SW_OK ? (int)segments : 0;
    return s == SW_OK ? system_take_rope(p, r, chain && segments > 1 ? (int)segments : -1, why) : s;
}

enum status deck_take_lines(const struct deck *d, const struct deck_options *o, struct system *p,
                            struct why *why)
{
    const struct form *f = form_of(d);
    struct roll_index nodes = {NULL, 0}, lines = {NULL, 0};
    int points = deck_count(d, DECK_POINTS), r = 0;
    enum status s = roll_sort(&p->nodes, &nodes, why);

    if (s == SW_OK)
        s = roll_sort(&p->ropes, &lines, why);
    for (int k = 0; k <= o->copies && s == SW_OK; k++)
        for (int i = deck_next(d, DECK_LINES, -1); i >= 0 && s == SW_OK;
             i = deck_next(d, DECK_LINES, i))
            s = take_line(d, i, f, &nodes, k * points, p, r++, why);
    free(nodes.at);
    free(lines.at);
    return s;
}
