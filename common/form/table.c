/* Tables of cables, row by row. */
#include "form/table.h"
#include "form/resolve.h"
#include "num/mem.h"
#include "sys/near.h"

#include <stdlib.h>
#include <string.h>

/* The key that column i seems to mean, by a slip of the hand or with a unit behind it (*ret_unit),
 * and that no other column gives; NULL: none. */
static const char *meant(const struct table *t, int i, int *ret_unit)
{
    const char *dot = strchr(t->csv.cell[i], '.'), *name = dot ? dot + 1 : t->csv.cell[i];
    const char *unit = strrchr(name, '_'), *key;

    for (int k = 0; (key = case_model_name(k)) != NULL; k++) {
        int given = 0;

        *ret_unit = unit && (size_t)(unit - name) == strlen(key) &&
                    strncmp(name, key, strlen(key)) == 0 && strlen(unit + 1) <= 3;
        for (int j = 0; j < t->n; j++)
            given |= t->key[j] && t->key[j] == case_model_key(key);
        if (!given && (*ret_unit || (strlen(key) >= 4 && near_word(name, key))))
            return key;
    }
    return NULL;
}

/* A column that is no key: refused if it is nearly one, else only copied. */
static enum status take_other(const struct table *t, int i, struct why *why)
{
    int unit;
    const char *name = t->csv.cell[i], *key = meant(t, i, &unit);

    if (key && !unit)
        return csv_fail(why, &t->csv, "column %d: '%.60s' is no key of a cable; is %s meant?",
                        i + 1, name, key);
    if (strcmp(name, "name") != 0)
        warn("%s:%d: column %d: '%.60s' is no key of a cable%s%s; it is only copied", t->csv.name,
             t->csv.line, i + 1, name, key ? ", which has no unit in its name: " : "",
             key ? key : "");
    return SW_OK;
}

static enum status take_header(struct table *t, struct why *why)
{
    enum status s = SW_OK;
    int known = 0;

    for (int i = 0; i < t->n; i++)
        known += (t->key[i] = case_model_key(t->csv.cell[i])) != NULL;
    if (known == 0)
        return csv_fail(why, &t->csv,
                        "no column is a key of a cable; a header line is expected, such as "
                        "span,unstressed_length,...");
    for (int i = 0; i < t->n && s == SW_OK; i++) {
        const char *name = t->csv.cell[i];

        for (int j = 0; j < i; j++)
            if (strcmp(name, t->csv.cell[j]) == 0 || (t->key[i] && t->key[i] == t->key[j]))
                return csv_fail(why, &t->csv, "columns %d and %d are both '%.60s'", j + 1, i + 1,
                                name);
        if (!t->key[i])
            s = take_other(t, i, why);
    }
    return s;
}

enum status table_begin(const struct in *in, const struct opt_list *sets, struct table *ret,
                        struct why *why)
{
    enum status s;

    *ret = (struct table){.n = 0};
    s = case_model_defaults(sets, &ret->blank, why);
    if (s == SW_OK)
        s = csv_begin(in, &ret->csv, why);
    if (s == SW_OK)
        s = csv_header(&ret->csv, why);
    if (s == SW_OK) {
        ret->n = ret->csv.n;
        ret->key = mem_zeroed((size_t)ret->n, sizeof *ret->key);
        s = ret->key ? take_header(ret, why) : fail_plain(why, SW_NOMEM);
    }
    if (s != SW_OK)
        table_end(ret);
    return s;
}

enum status table_row(struct table *t, struct cable_case *ret, struct why *why)
{
    char place[512];
    struct reading r = {.row = place, .why = why};
    enum status s = csv_row(&t->csv, why);

    if (s != SW_OK || !t->csv.cell)
        return s;
    snprintf(place, sizeof place, "%.400s:%d", t->csv.name, t->csv.line);
    s = csv_width(&t->csv, t->n, why);
    if (s != SW_OK)
        return s;
    *ret = t->blank;
    for (int i = 0; i < t->n; i++) {
        struct why cell;

        if (t->key[i] && t->csv.cell[i][0] != '\0' &&
            key_read(t->key[i], t->csv.cell[i], ret, &cell) != SW_OK)
            return csv_fail(why, &t->csv, "column %d: %.400s", i + 1, cell.text);
    }
    return case_resolve_model(&r, ret);
}

void table_print(const struct table *t, struct out *o)
{
    for (int i = 0; i < t->n; i++) {
        if (i > 0)
            putc(',', o->f);
        if (i < t->csv.n)
            out_cell(o, t->csv.cell[i]);
    }
}

void table_end(struct table *t)
{
    csv_end(&t->csv);
    free(t->key);
    t->key = NULL;
}
