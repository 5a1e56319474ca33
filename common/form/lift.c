/* Tables of arrangements, row by row. */
#include "form/lift.h"
#include "num/mem.h"
#include "sys/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Results of sling, which its input must not have already. */
static const char *const results[] = {"c", "h_m", "z_critical_m", "verdict", "why"};

enum kind { COPIED, NUMBER, TOLERANCE, TYPE };
enum { LABEL = 1 };

struct lift_slot {
    enum kind kind;
    int index;       /* of NUMBER and TOLERANCE in x, of TYPE the end; LABEL of the name */
    char *added;     /* name of a column that --set adds; owned */
    const char *set; /* value of --set, or NULL; points into argv */
};

/* What a column is. */
static struct lift_slot slot_of(const char *name)
{
    struct lift_slot s = {COPIED, 0, NULL, NULL};
    int tolerance, i = lift_column(name, &tolerance);

    if (strncmp(name, "type", 4) == 0 &&
        (name[4] == '\0' || strcmp(name + 4, "_1") == 0 || strcmp(name + 4, "_2") == 0)) {
        s.kind = TYPE;
        s.index = name[4] ? name[5] - '0' : 0;
    } else if (i >= 0) {
        s.kind = tolerance ? TOLERANCE : NUMBER;
        s.index = i;
    } else if (strcmp(name, "name") == 0) {
        s.index = LABEL;
    }
    return s;
}

static const char *place(const struct lift_table *t, char ret[512])
{
    if (t->csv.name)
        snprintf(ret, 512, "%.400s:%d: ", t->csv.name, t->csv.line);
    else
        snprintf(ret, 512, "--set: ");
    return ret;
}

enum status lift_fail(const struct lift_table *t, struct why *why)
{
    struct why copy = *why;
    char at[512];

    return fail(why, SW_FORMAT, "%s%.500s", place(t, at), copy.text);
}

void lift_warn(struct lift_table *t, const struct lift *l)
{
    char at[512];

    for (int k = 0; k < l->ends && !t->warned; k++) {
        const struct suspension *a = &l->end[k];

        if (!l->assumed[k] || isnan(a->m_load) || (isnan(a->wll) && isnan(a->wll_secondary)))
            continue;
        warn("%sa working load limit, but slings is empty: %g assumed%s, which share the load",
             place(t, at), a->slings, l->ends == 2 ? " at an end" : "");
        t->warned = 1;
    }
}

const char *lift_reason(const struct lift_table *t, const struct why *why)
{
    char at[512];
    size_t n = strlen(place(t, at));

    return strncmp(why->text, at, n) == 0 ? why->text + n : why->text;
}

static enum status judge_name(const struct lift_table *t, int i, const char *name, struct why *why)
{
    char close[LIFT_NAME];

    for (size_t k = 0; k < sizeof results / sizeof *results; k++)
        if (strcmp(name, results[k]) == 0)
            return fail(why, SW_FORMAT, "column %d: '%s' is a result of sling; leave it out", i + 1,
                        name);
    if (lift_nearly(name, close))
        return fail(why, SW_FORMAT, "column %d: '%.60s' is no column of sling; is %s meant?", i + 1,
                    name, close);
    if (strcmp(name, "name") != 0) {
        char at[512];

        warn("%scolumn %d: '%.60s' is no column of sling; it is only copied", place(t, at), i + 1,
             name);
    }
    return SW_OK;
}

/* Columns must be different; one at least must be ours, which is asked before any is warned of. */
static enum status judge_columns(const struct lift_table *t, struct why *why)
{
    int known = 0;

    for (int i = 0; i < t->n_file; i++) {
        const struct lift_slot *slot = &t->slot[i];

        known += slot->kind != COPIED;
        for (int j = 0; j < i; j++)
            if (strcmp(t->csv.cell[i], t->csv.cell[j]) == 0 ||
                (slot->kind != COPIED && slot->kind == t->slot[j].kind &&
                 slot->index == t->slot[j].index))
                return fail(why, SW_FORMAT, "columns %d and %d are both '%.60s'", j + 1, i + 1,
                            t->csv.cell[i]);
    }
    for (int i = 0; i < t->n_file; i++)
        if (t->slot[i].kind == COPIED && (known || t->n_file == 1)) {
            enum status s = judge_name(t, i, t->csv.cell[i], why);

            if (s != SW_OK)
                return s;
        }
    if (t->n_file > 0 && known == 0)
        return fail(why, SW_FORMAT,
                    "no column is one of sling; a header line is expected, such as "
                    "type,v_m,z_m,...");
    return SW_OK;
}

static enum status take_header(struct lift_table *t, struct why *why)
{
    for (int i = 0; i < t->n_file; i++)
        t->slot[i] = slot_of(t->csv.cell[i]);
    return judge_columns(t, why);
}

/* The column that an assignment sets, added at the end if the file has none. */
static enum status take_set(struct lift_table *t, const char *text, struct why *why)
{
    const char *equals = strchr(text, '=');
    char name[LIFT_NAME + 8], close[LIFT_NAME];
    struct lift_slot s = {COPIED, 0, NULL, NULL};
    int i = 0;

    snprintf(name, sizeof name, "%.*s", equals ? (int)(equals - text) : 0, text);
    if (equals && (size_t)(equals - text) < sizeof name)
        s = slot_of(name);
    if (!equals || (s.kind == COPIED && s.index != LABEL))
        return fail(why, SW_USAGE, "--set %.60s: expected COLUMN=VALUE%s%s", text,
                    equals && lift_nearly(name, close) ? "; is this column meant: " : "",
                    equals && lift_nearly(name, close) ? close : "");
    while (i < t->n && !(t->slot[i].kind == s.kind && t->slot[i].index == s.index))
        i++;
    if (i == t->n) {
        s.added = mem_copy(name, strlen(name) + 1);
        if (!s.added)
            return fail_plain(why, SW_NOMEM);
        t->slot[t->n++] = s;
    }
    t->slot[i].set = equals + 1;
    return SW_OK;
}

enum status lift_begin(const struct in *in, const struct opt_list *sets, struct lift_table *ret,
                       struct why *why)
{
    enum status s = SW_OK;

    *ret = (struct lift_table){.n = 0};
    if (in) {
        s = csv_begin(in, &ret->csv, why);
        if (s == SW_OK)
            s = csv_header(&ret->csv, why);
        if (s != SW_OK) {
            lift_end(ret);
            return s;
        }
        ret->n = ret->n_file = ret->csv.n;
    }
    ret->slot = mem_zeroed((size_t)(ret->n + sets->n), sizeof *ret->slot);
    s = ret->slot ? take_header(ret, why) : fail_plain(why, SW_NOMEM);
    if (s == SW_FORMAT)
        lift_fail(ret, why);
    for (int i = 0; i < sets->n && s == SW_OK; i++)
        s = take_set(ret, sets->item[i], why);
    if (s != SW_OK)
        lift_end(ret);
    return s;
}

/* Text of column i in the present row. */
static const char *cell(const struct lift_table *t, int i)
{
    if (t->slot[i].set)
        return t->slot[i].set;
    return i < t->csv.n && i < t->n_file ? t->csv.cell[i] : "";
}

static enum status read_switch(const char *text, double *ret, struct why *why)
{
    static const char *const words[] = {"0", "no", "false", "1", "yes", "true"};

    for (int i = 0; i < 6; i++)
        if (strcmp(text, words[i]) == 0) {
            *ret = i / 3;
            return SW_OK;
        }
    return fail(why, SW_FORMAT, "'%.60s': expected 1, yes, 0 or no", text);
}

static enum status read_number(const struct lift_slot *s, const char *text, struct lift_given *ret,
                               struct why *why)
{
    double x = NAN;
    const char *reason;

    if (s->index < LIFT_E1 && s->index / LIFT_ENDS == LIFT_STABILIZED)
        return read_switch(text, &ret->x[s->index], why);
    reason = number_read(text, &x);
    if (reason)
        return fail(why, SW_FORMAT, "'%.60s': %s", text, reason);
    x *= lift_unit(s->index);
    if (s->kind == TOLERANCE && !(x >= 0))
        return fail(why, SW_FORMAT, "'%.60s': a tolerance must not be negative", text);
    *(s->kind == TOLERANCE ? &ret->tol[s->index] : &ret->x[s->index]) = x;
    return SW_OK;
}

/* The name of a column before what is wrong with its cell. */
static enum status fail_cell(const struct lift_slot *slot, int i, struct why *why)
{
    const char *const ends[] = {"type", "type_1", "type_2"};
    struct why copy = *why;
    char name[LIFT_NAME], column[40] = "";

    lift_name(slot->kind == TYPE ? 0 : slot->index, name);
    if (!slot->set)
        snprintf(column, sizeof column, "column %d: ", i + 1);
    return fail(why, SW_FORMAT, "%s%s%s: %.400s", column,
                slot->kind == TYPE ? ends[slot->index] : name,
                slot->kind == TOLERANCE ? "_tol" : "", copy.text);
}

static enum status read_cells(const struct lift_table *t, struct lift_given *ret, struct why *why)
{
    *ret = (struct lift_given){.type = {LIFT_UNKNOWN, LIFT_UNKNOWN, LIFT_UNKNOWN}};
    for (int i = 0; i < LIFT_NUMBERS; i++)
        ret->x[i] = NAN;
    for (int i = 0; i < t->n; i++) {
        const struct lift_slot *slot = &t->slot[i];
        const char *text = cell(t, i);
        enum status s = SW_OK;

        if (slot->kind == COPIED || text[0] == '\0')
            continue;
        s = slot->kind == TYPE ? lift_type_read(text, &ret->type[slot->index], why)
                               : read_number(slot, text, ret, why);
        if (s != SW_OK)
            return fail_cell(slot, i, why);
    }
    return SW_OK;
}

enum status lift_row(struct lift_table *t, struct lift_given *ret, int *ret_end, struct why *why)
{
    enum status s;

    *ret_end = t->done;
    if (t->csv.name) {
        s = csv_row(&t->csv, why);
        *ret_end = s == SW_OK && !t->csv.cell;
        if (s == SW_OK && !*ret_end)
            s = csv_width(&t->csv, t->n_file, why);
        if (s != SW_OK)
            return s;
    }
    t->done = 1;
    if (*ret_end)
        return SW_OK;
    s = read_cells(t, ret, why);
    return s == SW_OK ? s : lift_fail(t, why);
}

const char *lift_label(const struct lift_table *t)
{
    for (int i = 0; i < t->n; i++)
        if (t->slot[i].kind == COPIED && t->slot[i].index == LABEL)
            return cell(t, i);
    return "";
}

int lift_has(const struct lift_table *t, int i, int tolerance)
{
    for (int k = 0; k < t->n; k++)
        if (t->slot[k].kind == (tolerance ? TOLERANCE : NUMBER) && t->slot[k].index == i)
            return 1;
    return 0;
}

void lift_print_row(const struct lift_table *t, struct out *o)
{
    for (int i = 0; i < t->n; i++) {
        if (i > 0)
            putc(',', o->f);
        out_cell(o, cell(t, i));
    }
}

void lift_print_header(const struct lift_table *t, struct out *o)
{
    for (int i = 0; i < t->n; i++) {
        if (i > 0)
            putc(',', o->f);
        out_cell(o, i < t->n_file ? t->csv.cell[i] : t->slot[i].added);
    }
}

int lift_has_ends(const struct lift_table *t)
{
    for (int k = 0; k < t->n; k++)
        if ((t->slot[k].kind == TYPE && t->slot[k].index > 0) ||
            (t->slot[k].kind == NUMBER &&
             (t->slot[k].index < LIFT_E1 ? t->slot[k].index % LIFT_ENDS > 0
                                         : t->slot[k].index != LIFT_OFFSET)))
            return 1;
    return 0;
}

void lift_end(struct lift_table *t)
{
    for (int i = 0; t->slot && i < t->n; i++)
        free(t->slot[i].added);
    free(t->slot);
    t->slot = NULL;
    if (t->csv.reader)
        csv_end(&t->csv);
}
