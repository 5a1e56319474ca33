/* The text of a mooring deck. */
#include "form/decktext.h"
#include "num/mem.h"
#include "sys/in.h"
#include "sys/number.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define BLANKS " \t\r\f\v"
#define MOST_BYTES 100000000 /* of a deck: no mooring needs as many */

enum status deck_fail(struct why *why, const struct deck *d, int line, const char *format, ...)
{
    char text[512];
    va_list list;

    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return fail(why, SW_FORMAT, "%.400s:%d: %s", d->name, line, text);
}

int deck_same(const char *a, const char *b)
{
    return strcasecmp(a, b) == 0;
}

/* Names of sections as they stand in headings, and what becomes of them. */
static const struct {
    const char *name;
    enum deck_section section;
} heading[] = {
    {"LINE TYPES", DECK_TYPES},        {"LINE DICTIONARY", DECK_TYPES},
    {"ROD TYPES", DECK_ROD_TYPES},     {"ROD DICTIONARY", DECK_ROD_TYPES},
    {"BODIES", DECK_BODIES},           {"BODY LIST", DECK_BODIES},
    {"BODY PROPERTIES", DECK_BODIES},  {"RODS", DECK_RODS},
    {"ROD LIST", DECK_RODS},           {"ROD PROPERTIES", DECK_RODS},
    {"POINTS", DECK_POINTS},           {"POINT LIST", DECK_POINTS},
    {"POINT PROPERTIES", DECK_POINTS}, {"CONNECTION PROPERTIES", DECK_POINTS},
    {"CONNECTION LIST", DECK_POINTS},  {"NODE PROPERTIES", DECK_POINTS},
    {"NODE LIST", DECK_POINTS},        {"LINES", DECK_LINES},
    {"LINE LIST", DECK_LINES},         {"LINE PROPERTIES", DECK_LINES},
    {"OPTIONS", DECK_OPTIONS},         {"OUTPUT", DECK_OUTPUTS},
};
#define N_HEADINGS (sizeof heading / sizeof *heading)

/* Sections that would change the mooring while it is used. */
static const char *const refused[] = {"FAILURE", "CONTROL", "EXTERNAL LOADS"};

/* Whether text holds the name as whole words, but for capitals and an s at the end. */
static int holds(const char *text, const char *name)
{
    for (const char *p = strcasestr(text, name); p; p = strcasestr(p + 1, name))
        if (p == text || !isalpha((unsigned char)p[-1]))
            return 1;
    return 0;
}

int deck_heading(const char *line)
{
    const char *first = line + strspn(line, BLANKS);

    if (!strstr(line, "---") || (strncmp(first, "---", 3) != 0 && !isalpha((unsigned char)*first)))
        return -1;
    for (size_t k = 0; k < N_HEADINGS; k++)
        if (holds(line, heading[k].name))
            return (int)heading[k].section;
    return *first == '-' ? DECK_NONE : -1;
}

/* A heading that is not known: a title, the closing line, or something that must not be passed
 * over. */
static enum status judge_unknown(const struct deck *d, int line, const char *text, int begun,
                                 struct why *why)
{
    const char *word = text + strspn(text, BLANKS "-=");
    size_t length = strcspn(word, "-");

    for (size_t k = 0; k < sizeof refused / sizeof *refused; k++)
        if (holds(text, refused[k]))
            return deck_fail(why, d, line, "section %s: statics cannot honour it", refused[k]);
    while (length > 0 && strchr(BLANKS, word[length - 1]))
        length--;
    if (!begun || length == 0 || holds(word, "this line") || holds(word, "END"))
        return SW_OK;
    return deck_fail(why, d, line, "section '%.*s' is not known", length < 60 ? (int)length : 60,
                     word);
}

static int has_guesses(const struct deck *d)
{
    const struct deck_row *names = &d->names[DECK_POINTS];

    return deck_find(names, "FX") >= 0 && deck_find(names, "CdA") < 0;
}

/* Cut the line into words, which go behind those that are there. */
static struct deck_row split(const struct deck *d, enum deck_section section, int line, char *text,
                             char **to)
{
    struct deck_row row = {section, line, strspn(text, BLANKS) > 0, 0, to};
    int guesses = section == DECK_POINTS && has_guesses(d);
    char *rest = NULL, *first = text + strspn(text, BLANKS);

    text[guesses && *first != '#' ? strcspn(text, "!%") : strcspn(text, "#!%")] = '\0';
    for (char *p = strtok_r(text, BLANKS, &rest); p; p = strtok_r(NULL, BLANKS, &rest))
        to[row.n++] = p;
    return row;
}

/* Whether a line is a record where units should stand. */
static int is_record(const struct deck_row *row)
{
    double x;

    for (int k = 1; k < row->n; k++)
        if (row->word[0][0] != '(' && number_read(row->word[k], &x) == NULL)
            return 1;
    return 0;
}

struct reading {
    struct deck *d;
    enum deck_section now;
    int line, begun, heads; /* heads: how many of the lines of names and units are still to come */
    size_t words;
};

static enum status open_section(struct reading *r, const char *text, struct why *why)
{
    struct deck *d = r->d;
    int section = deck_heading(text);

    if (section == DECK_NONE) {
        r->now = DECK_NONE;
        return judge_unknown(d, r->line, text, r->begun, why);
    }
    if (d->opened[section] > 0)
        return deck_fail(why, d, r->line, "this section is there already, in line %d",
                         d->opened[section]);
    r->now = (enum deck_section)section;
    r->begun = 1;
    r->heads = section == DECK_OPTIONS || section == DECK_OUTPUTS ? 0 : 2;
    d->opened[section] = r->line;
    return SW_OK;
}

/* One line: of a heading, of names, of units, of a record, or of nothing. */
static enum status take_line(struct reading *r, char *text, struct why *why)
{
    struct deck *d = r->d;
    struct deck_row row;

    if (text[strspn(text, BLANKS)] != '#' && deck_heading(text) >= 0)
        return open_section(r, text, why);
    if (r->now == DECK_NONE || (r->heads > 0 && text[strspn(text, BLANKS)] == '\0'))
        return SW_OK;
    row = split(d, r->now, r->line, text, d->word + r->words);
    r->words += (size_t)row.n;
    if (r->heads == 2)
        d->names[r->now] = row;
    else if (r->heads == 1 && is_record(&row))
        return deck_fail(why, d, r->line,
                         "a line of units is expected below the names; this is a record");
    else if (r->heads == 1)
        d->units[r->now] = row;
    else if (row.n > 0)
        d->row[d->n++] = row;
    r->heads -= r->heads > 0;
    return SW_OK;
}

static enum status take_text(struct deck *d, size_t size, struct why *why)
{
    struct reading r = {.d = d};
    size_t lines = 1, words = 1;
    enum status s = SW_OK;
    char *p = d->text;

    if (memchr(d->text, '\0', size)) {
        for (p = d->text; *p; p++)
            lines += *p == '\n';
        return deck_fail(why, d, (int)lines, "a NUL byte: this is no text file");
    }
    for (size_t i = 0; i < size; i++) {
        lines += d->text[i] == '\n';
        words += i == 0 || isspace((unsigned char)d->text[i - 1]);
    }
    d->row = mem_zeroed(lines, sizeof *d->row);
    d->word = mem_zeroed(words, sizeof *d->word);
    if (!d->row || !d->word)
        return fail_plain(why, SW_NOMEM);
    p += strncmp(p, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (s == SW_OK && *p) {
        char *end = p + strcspn(p, "\n"), *next = end + (*end == '\n');

        *end = '\0';
        r.line++;
        s = take_line(&r, p, why);
        p = next;
    }
    d->lines = r.line;
    return s;
}

/* All of the file, with a NUL behind it. */
static enum status take_file(struct in *in, char **ret, size_t *ret_size, struct why *why)
{
    size_t room = 4096, n = 0;
    char *text = mem_zeroed(room, 1);

    while (text) {
        n += fread(text + n, 1, room - 1 - n, in->f);
        if (n < room - 1 || n >= MOST_BYTES)
            break;
        room *= 2;
        *ret = text;
        text = mem_resize(text, room, 1);
    }
    if (!text)
        return fail_plain(why, SW_NOMEM);
    text[n] = '\0';
    *ret = text;
    *ret_size = n;
    if (ferror(in->f))
        return fail(why, SW_READ, "%.400s: cannot be read", in->name);
    if (n >= MOST_BYTES)
        return fail(why, SW_FORMAT, "%.400s: longer than %d bytes", in->name, MOST_BYTES);
    return SW_OK;
}

enum status deck_read(const char *path, struct deck *ret, struct why *why)
{
    struct in in = {.f = NULL};
    size_t size = 0;
    enum status s;

    *ret = (struct deck){.name = mem_copy(path, strlen(path) + 1)};
    s = ret->name ? in_open(path, &in, why) : fail_plain(why, SW_NOMEM);
    if (s == SW_OK)
        s = take_file(&in, &ret->text, &size, why);
    in_close(&in);
    if (s == SW_OK)
        s = take_text(ret, size, why);
    if (s != SW_OK)
        deck_free(ret);
    return s;
}

void deck_free(struct deck *d)
{
    free(d->row);
    free(d->word);
    free(d->text);
    free(d->name);
    *d = (struct deck){.n = 0};
}
