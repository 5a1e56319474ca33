/* Tables of parameter points. */
#include "form/points.h"
#include "num/hash.h"
#include "num/mem.h"
#include "sys/csv.h"

#include <stdlib.h>
#include <string.h>

/* Whether points may vary this column. */
static enum status judge_column(const struct csv *csv, int i, struct why *why)
{
    const char *name = csv->cell[i];

    for (int j = 0; j < i; j++)
        if (strcmp(name, csv->cell[j]) == 0)
            return csv_fail(why, csv, "columns %d and %d are both '%.60s'", j + 1, i + 1, name);
    if (strcmp(name, "name") == 0)
        return SW_OK;
    if (!strchr(name, '.'))
        return csv_fail(why, csv, "column %d: '%.60s': expected SECTION.KEY, or name", i + 1, name);
    if (case_model_key(name))
        return csv_fail(why, csv, "column %d: '%.60s' belongs to the model, which all points share",
                        i + 1, name);
    if (strncmp(name, "sweep.", 6) == 0 || strcmp(name, "time.probes") == 0)
        return csv_fail(why, csv, "column %d: '%.60s' cannot vary from point to point", i + 1,
                        name);
    if (!case_knows(name))
        return csv_fail(why, csv, "column %d: '%.60s' is no key of a case", i + 1, name);
    return SW_OK;
}

static enum status take_header(struct csv *csv, struct points *p, struct why *why)
{
    enum status s = csv_header(csv, why);

    for (int i = 0; i < csv->n && s == SW_OK; i++)
        s = judge_column(csv, i, why);
    if (s != SW_OK)
        return s;
    p->n_columns = csv->n;
    p->column = csv_copy(csv);
    return p->column ? SW_OK : fail_plain(why, SW_NOMEM);
}

/* A row, or why it is none; s is what reading it has brought. */
static enum status take_row(const struct csv *csv, enum status s, struct points *p, struct why *why)
{
    struct point *to;

    if (s == SW_OK && csv->n != p->n_columns)
        s = csv_fail(why, csv, "%d cells; the header has %d", csv->n, p->n_columns);
    if (s == SW_READ || s == SW_NOMEM)
        return s;
    if (p->n == p->room) {
        int room = p->room > 0 ? 2 * p->room : 256;
        struct point *more = mem_resize(p->point, (size_t)room, sizeof *more);

        if (!more)
            return fail_plain(why, SW_NOMEM);
        p->point = more;
        p->room = room;
    }
    to = &p->point[p->n];
    *to = (struct point){.line = csv->line};
    if (s == SW_OK)
        to->cell = csv_copy(csv);
    else
        to->wrong = mem_copy(why->text, strlen(why->text) + 1);
    if (!to->cell && !to->wrong)
        return fail_plain(why, SW_NOMEM);
    p->n++;
    return SW_OK;
}

static enum status read_table(const char *path, struct points *p, struct why *why)
{
    struct csv csv = {.reader = NULL};
    struct in in;
    enum status s = in_open(path, &in, why);

    if (s != SW_OK)
        return s;
    p->name = in.name;
    s = csv_begin(&in, &csv, why);
    csv.keep = 1; /* a point of empty cells is the case as it is */
    if (s == SW_OK)
        s = take_header(&csv, p, why);
    while (s == SW_OK) {
        s = csv_row(&csv, why);
        if (s == SW_OK && !csv.cell)
            break;
        s = take_row(&csv, s, p, why);
    }
    csv_end(&csv);
    in_close(&in);
    return s;
}

static enum status read_text(const char *path, struct points *p, struct why *why)
{
    size_t room = 0;
    struct in in;
    enum status s = in_open(path, &in, why);

    if (s != SW_OK)
        return s;
    for (size_t got = 1; got > 0 && s == SW_OK; p->case_bytes += got) {
        if (room - p->case_bytes < 4096) {
            char *more = mem_resize(p->case_text, room += 65536, 1);

            if (!more)
                s = fail_plain(why, SW_NOMEM);
            else
                p->case_text = more;
        }
        got = s == SW_OK ? fread(p->case_text + p->case_bytes, 1, 4096, in.f) : 0;
    }
    if (s == SW_OK && ferror(in.f))
        s = fail(why, SW_READ, "%s: cannot be read", in.name);
    in_close(&in);
    return s;
}

enum status points_read(const char *path, const char *case_path, const struct opt_list *sets,
                        struct points *ret, struct why *why)
{
    enum status s;

    *ret = (struct points){.case_path = case_path, .sets = sets};
    if (strcmp(case_path, "-") == 0)
        return fail(why, SW_USAGE,
                    "option --points: the case is read again for each point: give it as a file");
    s = read_text(case_path, ret, why);
    if (s == SW_OK)
        s = read_table(path, ret, why);
    if (s != SW_OK)
        points_free(ret);
    return s;
}

void points_free(struct points *p)
{
    for (int i = 0; i < p->n; i++) {
        free(p->point[i].cell);
        free(p->point[i].wrong);
    }
    free(p->point);
    free(p->column);
    free(p->case_text);
    *p = (struct points){.n = 0};
}

/* The assignments of point i behind those of the user; *memory holds their texts. */
static enum status assignments(const struct points *p, int i, struct opt_list *ret, char **memory)
{
    size_t bytes = 1;
    char *at, *end;

    ret->n = 0;
    ret->item = mem_zeroed((size_t)(p->sets->n + p->n_columns), sizeof *ret->item);
    for (int j = 0; j < p->n_columns; j++)
        bytes += strlen(p->column[j]) + strlen(p->point[i].cell[j]) + 2;
    at = *memory = mem_zeroed(bytes, 1);
    if (!ret->item || !at)
        return SW_NOMEM;
    end = at + bytes;
    for (int j = 0; j < p->sets->n; j++)
        ret->item[ret->n++] = p->sets->item[j];
    for (int j = 0; j < p->n_columns; j++)
        if (p->point[i].cell[j][0] != '\0' && strcmp(p->column[j], "name") != 0) {
            ret->item[ret->n++] = at;
            at += snprintf(at, (size_t)(end - at), "%s=%s", p->column[j], p->point[i].cell[j]) + 1;
        }
    return SW_OK;
}

/* Say which line of the table it is; what an assignment brought needs no word of --set. */
static enum status locate(const struct points *p, int i, enum status s, struct why *why)
{
    struct why old = *why;
    const char *text = strncmp(old.text, "--set ", 6) == 0 ? old.text + 6 : old.text;

    return fail(why, s, "%.400s:%d: %.600s", p->name, p->point[i].line, text);
}

enum status points_case(const struct points *p, int i, struct cable_case *ret, struct why *why)
{
    struct opt_list all;
    char *memory = NULL;
    FILE *f = NULL;
    enum status s;

    if (!p->point[i].cell)
        return fail(why, SW_FORMAT, "%s", p->point[i].wrong);
    s = assignments(p, i, &all, &memory);
    if (s == SW_OK && p->case_bytes > 0) {
        f = fmemopen(p->case_text, p->case_bytes, "r");
        s = f ? SW_OK : SW_NOMEM;
    }
    if (s != SW_OK)
        fail_plain(why, s);
    else if (!f)
        s = fail(why, SW_FORMAT, "%s: is empty", p->case_path);
    if (s == SW_OK)
        s = case_read(f, p->case_path, &all, ret, why);
    if (s == SW_OK) {
        s = case_records(ret, p->case_path, why);
        if (s != SW_OK)
            case_free(ret);
    }
    if (f)
        fclose(f);
    free(all.item);
    free(memory);
    return s == SW_OK || s == SW_NOMEM ? s : locate(p, i, s, why);
}

unsigned long points_checksum(const struct points *p)
{
    uint64_t hash = hash_more(HASH_START, p->case_text, p->case_bytes);

    for (int j = 0; j < p->n_columns; j++)
        hash = hash_more(hash, p->column[j], strlen(p->column[j]) + 1);
    for (int i = 0; i < p->n; i++)
        for (int j = 0; j < p->n_columns && p->point[i].cell; j++)
            hash = hash_more(hash, p->point[i].cell[j], strlen(p->point[i].cell[j]) + 1);
    return hash;
}

void points_header(const struct points *p, struct out *o)
{
    for (int j = 0; j < p->n_columns; j++) {
        if (j > 0)
            putc(',', o->f);
        out_cell(o, p->column[j]);
    }
}

void points_print(const struct points *p, int i, struct out *o)
{
    for (int j = 0; j < p->n_columns; j++) {
        if (j > 0)
            putc(',', o->f);
        if (p->point[i].cell)
            out_cell(o, p->point[i].cell[j]);
    }
}
