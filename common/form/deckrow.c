/* Rows of a mooring deck: their words and numbers. */
#include "form/decktext.h"
#include "sys/number.h"

#include <stdio.h>
#include <string.h>

int deck_next(const struct deck *d, enum deck_section section, int i)
{
    for (i++; i < d->n; i++)
        if (d->row[i].section == section)
            return i;
    return -1;
}

int deck_count(const struct deck *d, enum deck_section section)
{
    int n = 0;

    for (int i = 0; i < d->n; i++)
        n += d->row[i].section == section;
    return n;
}

int deck_find(const struct deck_row *row, const char *word)
{
    for (int k = 0; k < row->n; k++)
        if (deck_same(row->word[k], word))
            return k;
    return -1;
}

/* The name of a column for messages: " (Mass)", or nothing. */
static void name_column(const struct deck *d, int i, int column, char ret[40])
{
    const struct deck_row *names = &d->names[d->row[i].section];

    ret[0] = '\0';
    if (column < names->n)
        snprintf(ret, 40, " (%.30s)", names->word[column]);
}

enum status deck_columns(const struct deck *d, int i, int columns, int least, struct why *why)
{
    const struct deck_row *row = &d->row[i];
    int named = d->names[row->section].n;
    char name[40];

    if (named >= least && named < columns)
        columns = named;
    if (row->n >= columns)
        return SW_OK;
    name_column(d, i, row->n, name);
    return deck_fail(why, d, row->line, "column %d%s is missing: %d are there, %d are expected",
                     row->n + 1, name, row->n, columns);
}

static enum status read_one(const struct deck *d, int i, int column, const char *text, double *ret,
                            struct why *why)
{
    const char *reason = number_read(text, ret);
    char name[40];

    if (!reason)
        return SW_OK;
    name_column(d, i, column, name);
    return deck_fail(why, d, d->row[i].line, "column %d%s: '%.60s': %s", column + 1, name, text,
                     reason);
}

enum status deck_number(const struct deck *d, int i, int column, double least, double most,
                        double *ret, struct why *why)
{
    const struct deck_row *row = &d->row[i];
    char name[40];
    enum status s;

    *ret = 0;
    if (column < 0 || column >= row->n)
        return SW_OK;
    s = read_one(d, i, column, row->word[column], ret, why);
    if (s != SW_OK || (*ret >= least && *ret <= most))
        return s;
    name_column(d, i, column, name);
    return deck_fail(why, d, row->line, "column %d%s: %.60s is outside of %g to %g", column + 1,
                     name, row->word[column], least, most);
}

enum status deck_numbers(const struct deck *d, int i, int column, int most, double *ret, int *ret_n,
                         struct why *why)
{
    const char *p = d->row[i].word[column];
    char name[40];
    enum status s = SW_OK;

    *ret_n = 0;
    for (int more = 1; more && s == SW_OK;) {
        size_t length = strcspn(p, "|");
        char part[64];

        name_column(d, i, column, name);
        if (*ret_n == most || length >= sizeof part)
            return deck_fail(why, d, d->row[i].line,
                             "column %d%s: '%.60s': up to %d numbers with | between them are "
                             "expected",
                             column + 1, name, d->row[i].word[column], most);
        memcpy(part, p, length);
        part[length] = '\0';
        s = read_one(d, i, column, part, &ret[(*ret_n)++], why);
        more = p[length] == '|';
        p += length + (size_t)more;
    }
    return s;
}
