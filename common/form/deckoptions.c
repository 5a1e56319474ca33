/* Options of a mooring deck: keys of a case, copies, and what is passed over. */
#include "form/cable.h"
#include "form/deck.h"
#include "form/deckparts.h"
#include "num/mem.h"
#include "sys/number.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Options that a case has, too. */
static const struct {
    const char *name, *key;
} known[] = {
    {"g", "gravity"},
    {"gravity", "gravity"},
    {"rho", "water_density"},
    {"rhoW", "water_density"},
    {"WtrDens", "water_density"},
    {"WtrDnsty", "water_density"},
    {"WtrDpth", "depth"},
    {"WtrDepth", "depth"},
    {"depth", "depth"},
    {"bed_friction", "bed_friction"},
};
#define N_KNOWN (sizeof known / sizeof *known)

/* Options that change results, but not those of other codes' statics, or that name other files;
 * words for what to do instead. */
static const struct {
    const char *name, *instead;
} passed[] = {
    {"FrictionCoefficient", "set environment.bed_friction"},
    {"mu_kT", "set environment.bed_friction"},
    {"mu_kA", "set environment.bed_friction"},
    {"Currents", "set tables.current"},
    {"WaterKin", "set tables.current"},
    {"SeafloorFile", "set environment.bed"},
    {"BathymetryFile", "set environment.bed"},
};
#define N_PASSED (sizeof passed / sizeof *passed)

static const char *key_of(const char *name)
{
    for (size_t k = 0; k < N_KNOWN; k++)
        if (deck_same(name, known[k].name))
            return known[k].key;
    return NULL;
}

static const char *instead_of(const char *name)
{
    for (size_t k = 0; k < N_PASSED; k++)
        if (deck_same(name, passed[k].name))
            return passed[k].instead;
    return NULL;
}

/* A row `value key`, or `key value` as in MAP++, where blanks in front make a comment.  Returns 0
 * where it says nothing that is known. */
static int take_option(const struct deck_row *row, const char **ret_name, const char **ret_value)
{
    if (row->n < 2)
        return 0;
    for (int k = 1; k >= 0; k--) {
        *ret_name = row->word[k];
        *ret_value = row->word[1 - k];
        if (key_of(*ret_name) || instead_of(*ret_name))
            return k == 1 || !row->indented;
    }
    return 0;
}

/* A number that nothing follows is an option cut short. */
static enum status judge_option(const struct deck *d, const struct deck_row *row, struct why *why)
{
    double number;

    if (row->n > 1 || number_read(row->word[0], &number) != NULL)
        return SW_OK;
    return deck_fail(why, d, row->line, "option: the key behind %.60s is missing", row->word[0]);
}

/* Whether the value names a file beside the deck. */
static enum status is_file(const struct deck *d, const char *value, int *ret, struct why *why)
{
    char *path = case_beside(d->name, value);

    if (!path)
        return fail_plain(why, SW_NOMEM);
    *ret = access(path, R_OK) == 0;
    free(path);
    return SW_OK;
}

/* An option that is a key: its entry, with the line where it stands. */
static enum status take_key(const struct deck *d, int line, const char *name, const char *key,
                            const char *value, struct ini *to, struct why *why)
{
    const char *reason;
    const struct ini_entry *before = ini_find(to, "environment", key);
    char text[INI_LINE_BYTES];
    double number;
    int file = 0;
    enum status s = SW_OK;

    if (before)
        return deck_fail(why, d, line, "option %s was given in line %d already", name,
                         before->line);
    reason = number_read(value, &number);
    if (reason && strcmp(key, "depth") == 0)
        s = is_file(d, value, &file, why);
    if (s != SW_OK || file)
        return s;
    if (reason)
        return deck_fail(why, d, line, "option %s: '%.60s': %s", name, value, reason);
    if (snprintf(text, sizeof text, "environment.%s=%s", key, value) >= (int)sizeof text)
        return deck_fail(why, d, line, "option %s: '%.60s' is too long", name, value);
    s = ini_set(to, text, why);
    if (s == SW_OK)
        to->entry[to->n - 1].line = line;
    return s;
}

enum status deck_sections(const char *path, struct ini *ret, struct why *why)
{
    struct deck d;
    const char *name, *value, *key;
    enum status s = deck_read(path, &d, why);

    *ret = (struct ini){.name = NULL};
    if (s != SW_OK)
        return s;
    ret->name = mem_copy(path, strlen(path) + 1);
    if (!ret->name)
        s = fail_plain(why, SW_NOMEM);
    for (int i = deck_next(&d, DECK_OPTIONS, -1); i >= 0 && s == SW_OK;
         i = deck_next(&d, DECK_OPTIONS, i)) {
        s = judge_option(&d, &d.row[i], why);
        if (s == SW_OK && take_option(&d.row[i], &name, &value) && (key = key_of(name)))
            s = take_key(&d, d.row[i].line, name, key, value, ret, why);
    }
    deck_free(&d);
    return s;
}

/* The angles of a line `repeat 120 240`. */
static enum status take_repeat(const struct deck *d, int i, struct deck_options *to,
                               struct why *why)
{
    const struct deck_row *row = &d->row[i];
    enum status s = SW_OK;

    for (int k = 1; k < row->n && s == SW_OK; k++) {
        double *angle = &to->angle[to->copies];

        if (to->copies == DECK_COPIES)
            return deck_fail(why, d, row->line, "repeat: more than %d copies", DECK_COPIES);
        s = deck_number(d, i, k, -3600, 3600, angle, why);
        for (int j = -1; j < to->copies && s == SW_OK; j++)
            if (fmod(*angle - (j < 0 ? 0 : to->angle[j]), 360) == 0)
                s = deck_fail(why, d, row->line, "repeat: lines at %.6g degrees are there already",
                              *angle);
        to->copies++;
    }
    if (s == SW_OK && row->n == 1)
        s = deck_fail(why, d, row->line, "repeat: angles are expected");
    return s;
}

enum status deck_take_options(const struct deck *d, struct deck_options *ret, struct why *why)
{
    enum status s = SW_OK;

    *ret = (struct deck_options){.copies = 0};
    for (int i = deck_next(d, DECK_OPTIONS, -1); i >= 0 && s == SW_OK;
         i = deck_next(d, DECK_OPTIONS, i))
        if (deck_same(d->row[i].word[0], "repeat") && !d->row[i].indented)
            s = take_repeat(d, i, ret, why);
    if (s == SW_OK && ret->copies > 0 && deck_count(d, DECK_RODS) > 0)
        s = deck_fail(why, d, d->opened[DECK_RODS], "rods are not repeated");
    return s;
}

#define NAME 24 /* letters of an option, and one */
#define SHORT 5 /* letters of a word that is not guessed at are fewer */

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int same_letter(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Letters put in, left out, changed or swapped with the next one between a and b, capitals or not;
 * what is too long is far. */
static int letters_apart(const char *a, const char *b)
{
    int d[NAME][NAME] = {{0}}, n = (int)strlen(a), m = (int)strlen(b);

    if (n >= NAME || m >= NAME)
        return NAME;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = least(d[i - 1][j - 1] + !same_letter(a[i - 1], b[j - 1]),
                            1 + least(d[i - 1][j], d[i][j - 1]));
            if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) &&
                same_letter(a[i - 2], b[j - 1]))
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[n][m];
}

/* The option that is meant by a word that is none, or NULL: one letter in four, at the most two,
 * may be wrong; short words are not guessed at. */
static const char *option_near(const char *word)
{
    int length = (int)strlen(word), most = least(length / 4, 2), best = most + 1;
    const char *ret = NULL;

    for (size_t k = 0; k < N_KNOWN + N_PASSED; k++) {
        const char *name = k < N_KNOWN ? known[k].name : passed[k - N_KNOWN].name;
        int apart = letters_apart(word, name);

        if (length < SHORT || strlen(name) < SHORT || apart >= best)
            continue;
        best = apart;
        /* of its names, the one that other codes read, too */
        ret = k < N_KNOWN && strcmp(known[k].key, "depth") == 0 ? "WtrDpth" : name;
    }
    return ret;
}

/* An option whose name is nearly a known one is told; the many of dynamics are not. */
static enum status pass_unknown(const struct deck *d, const struct deck_row *row, struct system *p,
                                struct why *why)
{
    for (int k = least(row->n, 2) - 1; k >= 0; k--) {
        const char *meant = k == 1 || !row->indented ? option_near(row->word[k]) : NULL;

        if (meant)
            return system_pass(p, 1, why, "%.400s:%d: option %.60s is not known; is %s meant?",
                               d->name, row->line, row->word[k], meant);
    }
    return SW_OK;
}

/* What is said of one option that is passed over, or nothing. */
static enum status pass_option(const struct deck *d, const struct deck_row *row, const char *name,
                               const char *value, struct system *p, struct why *why)
{
    const char *key = key_of(name), *instead = instead_of(name);
    double number = NAN;

    number_read(value, &number);
    if (key && isnan(number))
        return system_pass(
            p, 1, why,
            "%.400s:%d: %s: the file '%.60s' is passed over; set environment.bed, or "
            "environment.depth",
            d->name, row->line, name, value);
    if (!instead || number == 0)
        return SW_OK;
    if (strstr(instead, "bed_friction") && !isnan(p->c.friction))
        return SW_OK;
    if (strstr(instead, "current") && p->c.current[0] != '\0')
        return SW_OK;
    if (strstr(instead, "bed") && p->c.bed[0] != '\0')
        return SW_OK;
    return system_pass(p, 1, why, "%.400s:%d: %s %.60s is passed over; %s", d->name, row->line,
                       name, value, instead);
}

enum status deck_pass_options(const struct deck *d, struct system *p, struct why *why)
{
    const char *name, *value;
    enum status s = SW_OK;

    for (int i = deck_next(d, DECK_OPTIONS, -1); i >= 0 && s == SW_OK;
         i = deck_next(d, DECK_OPTIONS, i)) {
        const struct deck_row *row = &d->row[i];

        if (take_option(row, &name, &value))
            s = pass_option(d, row, name, value, p, why);
        else if (row->indented && deck_same(row->word[0], "repeat"))
            s = system_pass(p, 0, why, "%.400s:%d: repeat behind a blank is a comment", d->name,
                            row->line);
        else
            s = pass_unknown(d, row, p, why);
    }
    return s;
}
