/* CSV rows on libcsv, fed line by line: it gives no position itself. */
#include "sys/csv.h"
#include "num/mem.h"
#include "sys/number.h"

#include <csv.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define OPTIONS (CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL)

struct csv_reader {
    FILE *f;
    struct csv_parser parser;
    char *line; /* getline's buffer */
    size_t line_size;
    char *text; /* cells of the row one after another, each with its NUL */
    size_t used, size;
    size_t *start; /* of each cell in text */
    char **cell;
    int n, room;
    int no_memory;
};

enum status csv_fail(struct why *why, const struct csv *c, const char *format, ...)
{
    char text[512];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return fail(why, SW_FORMAT, "%.400s:%d: %s", c->name, c->line, text);
}

enum status csv_begin(const struct in *in, struct csv *ret, struct why *why)
{
    struct csv_reader *r = mem_zeroed(1, sizeof *r);

    *ret = (struct csv){.name = in->name, .reader = r};
    if (!r)
        return fail_plain(why, SW_NOMEM);
    r->f = in->f;
    if (csv_init(&r->parser, OPTIONS) != 0) {
        csv_end(ret);
        return fail_plain(why, SW_NOMEM);
    }
    return SW_OK;
}

static int grow(struct csv_reader *r, size_t length)
{
    if (r->used + length + 1 > r->size) {
        size_t size = 2 * (r->used + length + 1);
        char *text = mem_resize(r->text, size, 1);

        if (!text)
            return 0;
        r->text = text;
        r->size = size;
    }
    if (r->n == r->room) {
        int room = 2 * r->room + 16;
        size_t *start = mem_resize(r->start, (size_t)room, sizeof *start);
        char **cell;

        if (start)
            r->start = start;
        cell = start ? mem_resize(r->cell, (size_t)room, sizeof *cell) : NULL;
        if (!cell)
            return 0;
        r->cell = cell;
        r->room = room;
    }
    return 1;
}

static void on_cell(void *text, size_t length, void *user)
{
    struct csv_reader *r = user;

    if (r->no_memory || !grow(r, length)) {
        r->no_memory = 1;
        return;
    }
    if (length > 0)
        memcpy(r->text + r->used, text, length);
    r->text[r->used + length] = '\0';
    r->start[r->n++] = r->used;
    r->used += length + 1;
}

/* Parse one line, its end stripped. */
static enum status parse(struct csv *c, const char *line, size_t length, struct why *why)
{
    struct csv_reader *r = c->reader;
    size_t done = csv_parse(&r->parser, line, length, on_cell, NULL, r);
    int bad = done != length || csv_fini(&r->parser, on_cell, NULL, r) != 0;

    if (r->no_memory || (bad && csv_error(&r->parser) == CSV_ENOMEM))
        return fail_plain(why, SW_NOMEM);
    if (bad) {
        csv_free(&r->parser); /* the next row begins anew */
        csv_init(&r->parser, OPTIONS);
        return csv_fail(why, c,
                        "a quote is wrong: a cell is either quoted as a whole, with \"\" for "
                        "a quote inside, or not at all, and ends on its line");
    }
    return SW_OK;
}

/* Commas, and blanks between them. */
static int is_bare(const char *line)
{
    return line[strspn(line, ", \t")] == '\0' && strchr(line, ',');
}

enum status csv_row(struct csv *c, struct why *why)
{
    struct csv_reader *r = c->reader;

    c->n = 0;
    c->cell = NULL;
    for (;;) {
        ssize_t length = getline(&r->line, &r->line_size, r->f);
        char *line = r->line;
        enum status s;

        if (length < 0) {
            if (ferror(r->f))
                return fail(why, SW_READ, "%s: cannot be read", c->name);
            return feof(r->f) ? SW_OK : fail_plain(why, SW_NOMEM);
        }
        c->line++;
        if (length > 0 && line[length - 1] == '\n')
            line[--length] = '\0';
        if (length > 0 && line[length - 1] == '\r')
            line[--length] = '\0';
        if (c->line == 1 && strncmp(line, "\xef\xbb\xbf", 3) == 0) {
            line += 3;
            length -= 3;
        }
        if (strlen(line) != (size_t)length)
            return csv_fail(why, c, "a NUL byte: this is no text file");
        if (strchr(line, '\r'))
            return csv_fail(why, c, "a carriage return inside of the line");
        if (length == 0 || (!c->keep && is_bare(line)))
            continue;
        r->n = 0;
        r->used = 0;
        s = parse(c, line, (size_t)length, why);
        if (s != SW_OK)
            return s;
        for (int i = 0; i < r->n; i++)
            r->cell[i] = r->text + r->start[i];
        c->n = r->n;
        c->cell = r->cell;
        if (c->n > 0)
            return SW_OK;
    }
}

enum status csv_header(struct csv *c, struct why *why)
{
    enum status s = csv_row(c, why);

    if (s != SW_OK)
        return s;
    if (c->n == 0)
        return fail(why, SW_FORMAT, "%s: is empty; a header line is expected", c->name);
    if (c->n == 1 && strchr(c->cell[0], ';'))
        return csv_fail(why, c, "columns are separated by ';'; expected ',' (and '.' in numbers)");
    if (c->n == 1 && strchr(c->cell[0], '\t'))
        return csv_fail(why, c, "columns are separated by tabs; expected ','");
    return SW_OK;
}

enum status csv_width(const struct csv *c, int n, struct why *why)
{
    if (c->n == n)
        return SW_OK;
    return csv_fail(why, c, "%d cells; the header has %d%s", c->n, n,
                    c->n > n ? " (a decimal comma, or a text with commas that is not quoted?)"
                             : "");
}

enum status csv_number(const struct csv *c, int i, double *ret, struct why *why)
{
    const char *reason = number_read(c->cell[i], ret);

    if (reason)
        return csv_fail(why, c, "column %d: '%.60s': %s", i + 1, c->cell[i], reason);
    return SW_OK;
}

void csv_end(struct csv *c)
{
    struct csv_reader *r = c->reader;

    if (r) {
        csv_free(&r->parser);
        free(r->line);
        free(r->text);
        free(r->start);
        free(r->cell);
        free(r);
    }
    *c = (struct csv){0};
}

char **csv_copy(const struct csv *c)
{
    size_t bytes = sizeof(char *) * (size_t)c->n;
    char **ret, *at;

    for (int i = 0; i < c->n; i++)
        bytes += strlen(c->cell[i]) + 1;
    ret = mem_zeroed(bytes, 1);
    if (!ret)
        return NULL;
    at = (char *)(ret + c->n);
    for (int i = 0; i < c->n; i++) {
        size_t size = strlen(c->cell[i]) + 1;

        ret[i] = memcpy(at, c->cell[i], size);
        at += size;
    }
    return ret;
}
