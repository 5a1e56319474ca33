/* Recorded motions and forces: CSV files beside the case. */
#include "form/cable.h"
#include "num/mem.h"
#include "sys/csv.h"

#include <stdlib.h>
#include <string.h>

/* Columns of a record; first time_s. */
enum { TIME, N_COLUMNS = 4 };

static const char *const motion_columns[N_COLUMNS] = {"time_s", "u1_m", "u2_m", "u3_m"};
static const char *const force_columns[N_COLUMNS] = {"time_s", "f1_N", "f2_N", "f3_N"};

/* Rows read so far; room grows. */
struct rows {
    int n, room;
    double *t, *x;
};

static enum status judge_header(const struct csv *c, const char *const names[N_COLUMNS],
                                struct why *why)
{
    for (int i = 0; i < N_COLUMNS; i++)
        if (i >= c->n || strcmp(c->cell[i], names[i]) != 0)
            return csv_fail(why, c, "the columns %s,%s,%s,%s are expected", names[0], names[1],
                            names[2], names[3]);
    return SW_OK;
}

static enum status add_row(const struct csv *c, struct rows *r, struct why *why)
{
    double number[N_COLUMNS];

    if (c->n < N_COLUMNS)
        return csv_fail(why, c, "%d cells; at least %d are expected", c->n, N_COLUMNS);
    for (int i = 0; i < N_COLUMNS; i++)
        if (csv_number(c, i, &number[i], why) != SW_OK)
            return SW_FORMAT;
    if (r->n > 0 && !(number[TIME] > r->t[r->n - 1]))
        return csv_fail(why, c, "time_s must ascend");
    if (r->n == r->room) {
        int room = 2 * r->room + 64;
        double *t = mem_resize(r->t, (size_t)room, sizeof *t), *x;

        if (t)
            r->t = t;
        x = t ? mem_resize(r->x, (size_t)room, 3 * sizeof *x) : NULL;
        if (!x)
            return fail_plain(why, SW_NOMEM);
        r->x = x;
        r->room = room;
    }
    r->t[r->n] = number[TIME];
    for (int i = 0; i < 3; i++)
        r->x[3 * r->n + i] = number[1 + i];
    r->n++;
    return SW_OK;
}

static enum status read_rows(const struct in *in, const char *const names[N_COLUMNS],
                             struct rows *r, struct why *why)
{
    struct csv c;
    enum status s = csv_begin(in, &c, why);

    if (s == SW_OK)
        s = csv_header(&c, why);
    if (s == SW_OK)
        s = judge_header(&c, names, why);
    while (s == SW_OK) {
        s = csv_row(&c, why);
        if (s == SW_OK && !c.cell)
            break;
        if (s == SW_OK)
            s = add_row(&c, r, why);
    }
    csv_end(&c);
    if (s == SW_OK && r->n < 2)
        s = fail(why, SW_FORMAT, "%s: has %d rows; at least two are expected", in->name, r->n);
    return s;
}

char *case_beside(const char *path, const char *file)
{
    const char *slash = strrchr(path, '/');
    size_t length = slash && file[0] != '/' ? (size_t)(slash - path) + 1 : 0;
    size_t rest = strlen(file) + 1;
    char *ret = mem_zeroed(length + rest, 1);

    if (ret) {
        memcpy(ret, path, length);
        memcpy(ret + length, file, rest);
    }
    return ret;
}

static enum status read_record(const char *path, const char *file,
                               const char *const names[N_COLUMNS], struct series *ret,
                               struct why *why)
{
    struct rows r = {0, 0, NULL, NULL};
    struct in in = {.f = NULL};
    char *beside = case_beside(path, file);
    enum status s = beside ? in_open(beside, &in, why) : fail_plain(why, SW_NOMEM);

    if (s == SW_OK)
        s = read_rows(&in, names, &r, why);
    if (s == SW_OK) {
        s = series_new(r.n, r.t, r.x, ret);
        if (s != SW_OK)
            fail_plain(why, s);
    }
    in_close(&in);
    free(r.t);
    free(r.x);
    free(beside);
    return s;
}

/* What is per metre before expansion counts per metre after it. */
static void scale(struct series *s, double factor)
{
    for (int i = 0; i < 3 * s->n; i++) {
        s->x[i] *= factor;
        s->slope[i] *= factor;
    }
}

enum status case_records(struct cable_case *c, const char *path, struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i < c->n_motions && s == SW_OK; i++) {
        struct motion_section *p = &c->motion_section[i];

        if (p->file[0] == '\0')
            continue;
        s = read_record(path, p->file, motion_columns, &p->record, why);
        c->motion[i].record = &p->record;
    }
    for (int i = 0; i < c->n_forces && s == SW_OK; i++) {
        struct force_section *p = &c->force_section[i];

        if (p->file[0] == '\0')
            continue;
        s = read_record(path, p->file, force_columns, &p->record, why);
        if (s == SW_OK && !(p->position > 0))
            scale(&p->record, c->bare.L0 / c->cable.L0);
        c->force[i].record = &p->record;
    }
    return s;
}
