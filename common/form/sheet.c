/* Whole tables in memory. */
#include "form/sheet.h"
#include "form/cable.h"
#include "num/mem.h"
#include "sys/number.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static enum status take_header(const struct csv *c, const struct sheet_column *known, int n_known,
                               struct sheet *s, struct why *why)
{
    s->at = mem_zeroed((size_t)n_known, sizeof *s->at);
    if (!s->at)
        return fail_plain(why, SW_NOMEM);
    for (int k = 0; k < n_known; k++)
        s->at[k] = -1;
    for (int i = 0; i < c->n; i++) {
        int k = 0;

        while (k < n_known && strcmp(known[k].name, c->cell[i]) != 0)
            k++;
        if (k == n_known)
            return csv_fail(why, c, "column %d: '%.60s' is not known here", i + 1, c->cell[i]);
        if (s->at[k] >= 0)
            return csv_fail(why, c, "columns %d and %d are both '%.60s'", s->at[k] + 1, i + 1,
                            c->cell[i]);
        s->at[k] = i;
    }
    for (int k = 0; k < n_known; k++)
        if (known[k].needed && s->at[k] < 0)
            return csv_fail(why, c, "the column '%s' is missing", known[k].name);
    return SW_OK;
}

static enum status take_row(const struct csv *c, int width, struct sheet *s, struct why *why)
{
    if (csv_width(c, width, why) != SW_OK)
        return SW_FORMAT;
    if (s->n == s->room) {
        int room = s->room > 0 ? 2 * s->room : 64;
        int *line = mem_resize(s->line, (size_t)room, sizeof *line);
        char ***row;

        if (line)
            s->line = line;
        row = line ? mem_resize(s->row, (size_t)room, sizeof *row) : NULL;
        if (!row)
            return fail_plain(why, SW_NOMEM);
        s->row = row;
        s->room = room;
    }
    s->line[s->n] = c->line;
    s->row[s->n] = csv_copy(c);
    if (!s->row[s->n])
        return fail_plain(why, SW_NOMEM);
    s->n++;
    return SW_OK;
}

enum status sheet_read(const char *path, const char *beside, const struct sheet_column *known,
                       int n_known, struct sheet *ret, struct why *why)
{
    struct csv c = {.reader = NULL};
    struct in in = {.f = NULL};
    int width = 0;
    enum status s;

    *ret = (struct sheet){.name = beside ? case_beside(beside, path)
                                         : mem_copy(path, strlen(path) + 1)};
    s = ret->name ? in_open(ret->name, &in, why) : fail_plain(why, SW_NOMEM);
    if (s == SW_OK)
        s = csv_begin(&in, &c, why);
    if (s == SW_OK)
        s = csv_header(&c, why);
    if (s == SW_OK) {
        width = c.n;
        s = take_header(&c, known, n_known, ret, why);
    }
    while (s == SW_OK) {
        s = csv_row(&c, why);
        if (s == SW_OK && !c.cell)
            break;
        if (s == SW_OK)
            s = take_row(&c, width, ret, why);
    }
    csv_end(&c);
    in_close(&in);
    if (s != SW_OK)
        sheet_free(ret);
    return s;
}

void sheet_free(struct sheet *s)
{
    for (int i = 0; i < s->n; i++)
        free(s->row[i]);
    free(s->row);
    free(s->line);
    free(s->at);
    free(s->name);
    *s = (struct sheet){.n = 0};
}

const char *sheet_text(const struct sheet *s, int row, int column)
{
    return s->at && s->at[column] >= 0 ? s->row[row][s->at[column]] : "";
}

enum status sheet_fail(struct why *why, const struct sheet *s, int row, const char *format, ...)
{
    char text[512];
    va_list list;

    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return fail(why, SW_FORMAT, "%.400s:%d: %s", s->name, s->line[row], text);
}

enum status sheet_number(const struct sheet *s, int row, int column, double least, double most,
                         double fallback, double *ret, struct why *why)
{
    const char *text = sheet_text(s, row, column), *reason;

    *ret = fallback;
    if (text[0] == '\0')
        return isnan(fallback)
                   ? sheet_fail(why, s, row, "column %d: a number is expected", s->at[column] + 1)
                   : SW_OK;
    reason = number_read(text, ret);
    if (reason)
        return sheet_fail(why, s, row, "column %d: '%.60s': %s", s->at[column] + 1, text, reason);
    if (!(*ret >= least && *ret <= most))
        return sheet_fail(why, s, row, "column %d: %.60s is outside of %g to %g", s->at[column] + 1,
                          text, least, most);
    return SW_OK;
}

enum status sheet_roll(const struct sheet *s, int column, struct roll *ret, struct why *why)
{
    enum status status = roll_begin(ret, s->name, why);

    for (int i = 0; i < s->n && status == SW_OK; i++)
        status = roll_add(ret, sheet_text(s, i, column), s->line[i], why);
    return status;
}
