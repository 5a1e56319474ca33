/* Types of ropes from their table. */
#include "form/systemtable.h"
#include "num/mem.h"

#include <math.h>
#include <string.h>

enum { TYPE, DIAMETER, MASS, EA, CD, CD_AXIAL, BREAKING, TENSION_TABLE, N_TYPE };
static const struct sheet_column type_column[N_TYPE] = {{"type", 1},       {"diameter_m", 1},
                                                        {"mass_kg_m", 1},  {"ea_N", 0},
                                                        {"cd", 0},         {"cd_axial", 0},
                                                        {"breaking_N", 0}, {"tension_table", 0}};

static const struct sheet_column strain_column[2] = {{"strain", 1}, {"tension_N", 1}};

/* The points of t to the arrays, ascending from above zero. */
static enum status take_points(const struct sheet *t, struct system_type *to, struct why *why)
{
    double before[2] = {0, 0}, point[2];
    enum status s = SW_OK;

    for (int i = 0; i < t->n && s == SW_OK; i++) {
        s = sheet_number(t, i, 0, 0, 10, NAN, &point[0], why);
        if (s == SW_OK)
            s = sheet_number(t, i, 1, 0, 1e18, NAN, &point[1], why);
        if (s == SW_OK && i == 0 && point[0] == 0 && point[1] == 0)
            continue; /* the origin belongs to every table */
        if (s == SW_OK && !(point[0] > before[0] && point[1] > before[1]))
            s = sheet_fail(why, t, i, "strain and tension must ascend, from above zero");
        if (s != SW_OK)
            return s;
        memcpy(before, point, sizeof before);
        to->table[to->law.n] = point[0];
        to->table[t->n + to->law.n++] = point[1];
    }
    return s;
}

enum status system_tension_table(const char *path, const char *beside, struct system_type *to,
                                 struct why *why)
{
    struct sheet t;
    enum status s = sheet_read(path, beside, strain_column, 2, &t, why);

    if (s != SW_OK)
        return s;
    to->table = mem_doubles(2 * (size_t)t.n);
    s = to->table ? take_points(&t, to, why) : fail_plain(why, SW_NOMEM);
    if (s == SW_OK && to->law.n == 0)
        s = fail(why, SW_FORMAT, "%.400s: no row tells a tension", t.name);
    if (s == SW_OK) {
        to->law.strain = to->table;
        to->law.tension = to->table + t.n;
        to->law.EA = to->law.tension[0] / to->law.strain[0];
    }
    sheet_free(&t);
    return s;
}

static enum status take_type(const struct sheet *t, int i, struct system_type *to, struct why *why)
{
    const char *table = sheet_text(t, i, TENSION_TABLE);
    enum status s = sheet_number(t, i, DIAMETER, 0, 1e3, NAN, &to->diameter, why);

    to->friction = NAN;
    if (s == SW_OK)
        s = sheet_number(t, i, MASS, 0, SYSTEM_BIG, NAN, &to->mass, why);
    if (s == SW_OK)
        s = sheet_number(t, i, EA, 1e-9, 1e18, -1, &to->law.EA, why);
    if (s == SW_OK)
        s = sheet_number(t, i, CD, 0, 1e6, 0, &to->cd, why);
    if (s == SW_OK)
        s = sheet_number(t, i, CD_AXIAL, 0, 1e6, 0, &to->cd_axial, why);
    if (s == SW_OK)
        s = sheet_number(t, i, BREAKING, 1e-9, 1e18, INFINITY, &to->breaking, why);
    if (s == SW_OK && (table[0] != '\0') == (to->law.EA > 0))
        s = sheet_fail(why, t, i, "give either ea_N or tension_table");
    return s == SW_OK && table[0] != '\0' ? system_tension_table(table, t->name, to, why) : s;
}

enum status system_read_types(const char *path, struct system *p, struct why *why)
{
    struct sheet t;
    enum status s = sheet_read(p->c.types, path, type_column, N_TYPE, &t, why);

    if (s != SW_OK)
        return s;
    s = sheet_roll(&t, TYPE, &p->types, why);
    p->type = mem_zeroed((size_t)t.n, sizeof *p->type);
    if (s == SW_OK && !p->type)
        s = fail_plain(why, SW_NOMEM);
    for (int i = 0; i < t.n && s == SW_OK; i++)
        s = take_type(&t, i, &p->type[i], why);
    sheet_free(&t);
    return s;
}
