/* Tables of keys: judged, taken and printed. */
#include "form/keys.h"
#include "sys/number.h"

#include <math.h>
#include <string.h>

/* Length of a section's name without its label. */
static size_t bare(const char *section)
{
    return strcspn(section, " ");
}

int section_is(const char *section, const char *name)
{
    return bare(section) == strlen(name) && strncmp(section, name, strlen(name)) == 0;
}

int section_labelled(const struct reading *r, const char *name)
{
    size_t length = bare(name);

    for (const char *p = r->labelled; *p; p += strcspn(p, " "), p += *p == ' ')
        if (strcspn(p, " ") == length && strncmp(p, name, length) == 0)
            return 1;
    return 0;
}

/* The values of a key: text to the place to. */
static enum status read_numbers(const struct key *k, const char *text, double *to, struct why *why)
{
    char copy[INI_LINE_BYTES + 1], *word, *rest = NULL;
    double more;
    int n = 0;

    for (int i = 0; i < k->most; i++)
        to[i] = NAN;
    if (k->words && strcmp(text, k->words) == 0) {
        to[0] = 0;
        return SW_OK;
    }
    if (snprintf(copy, sizeof copy, "%s", text) >= (int)sizeof copy)
        return fail(why, SW_FORMAT, "%s: longer than %d bytes", k->name, INI_LINE_BYTES);
    for (word = strtok_r(copy, " \t", &rest); word; word = strtok_r(NULL, " \t", &rest)) {
        const char *reason;

        if (n == k->most && number_read(word, &more))
            return fail(why, SW_FORMAT, "%s: '%s' is no number; units are fixed", k->name, word);
        if (n == k->most)
            return fail(why, SW_FORMAT, "%s: more than %d number%s", k->name, k->most,
                        k->most > 1 ? "s" : "");
        reason = number_read(word, &to[n]);
        if (reason)
            return fail(why, SW_FORMAT, "%s: '%s': %s%s", k->name, word, reason,
                        strchr(word, ',') && k->most > 1 ? "; blanks separate numbers" : "");
        if (!(to[n] >= k->min && to[n] <= k->max))
            return fail(why, SW_FORMAT, "%s: %s is outside of %g to %g", k->name, word, k->min,
                        k->max);
        n++;
    }
    if (n < k->least)
        return fail(why, SW_FORMAT, "%s: %d numbers are expected", k->name, k->least);
    return SW_OK;
}

static enum status read_word(const struct key *k, const char *text, int *to, struct why *why)
{
    const char *p = k->words;
    size_t length = strlen(text);

    for (*to = 0; *p; (*to)++) {
        size_t l = strcspn(p, " ");

        if (l == length && strncmp(p, text, l) == 0)
            return SW_OK;
        p += l + (p[l] == ' ');
    }
    return fail(why, SW_FORMAT, "%s: '%s' is not one of: %s", k->name, text, k->words);
}

static enum status read_whole(const struct key *k, const char *text, int *to, struct why *why)
{
    long value = -1;
    const char *reason = integer_read(text, (long)k->min, (long)k->max, &value);

    if (reason)
        return fail(why, SW_FORMAT, "%s: '%s': %s (expected %.0f to %.0f)", k->name, text, reason,
                    k->min, k->max);
    *to = (int)value;
    return SW_OK;
}

/* A key without value and default. */
static void leave_out(const struct key *k, void *to)
{
    if (k->kind == NUMBERS)
        for (int i = 0; i < k->most; i++)
            ((double *)to)[i] = NAN;
    else if (k->kind == TEXT)
        *(char *)to = '\0';
    else
        *(int *)to = -1;
}

enum status key_read(const struct key *k, const char *text, void *base, struct why *why)
{
    void *to = (char *)base + k->at;

    if (!text)
        text = k->fallback;
    if (!text) {
        leave_out(k, to);
        return SW_OK;
    }
    switch (k->kind) {
    case NUMBERS: return read_numbers(k, text, to, why);
    case WHOLE: return read_whole(k, text, to, why);
    case WORD: return read_word(k, text, to, why);
    default:
        return snprintf(to, KEYS_TEXT_BYTES, "%s", text) < KEYS_TEXT_BYTES
                   ? SW_OK
                   : fail(why, SW_FORMAT, "%s: longer than %d bytes", k->name, KEYS_TEXT_BYTES - 1);
    }
}

enum status keys_take(const struct reading *r, const char *section, void *base)
{
    for (int i = 0; i < r->n_keys; i++) {
        const struct key *k = &r->keys[i];
        const struct ini_entry *e;
        struct why why;

        if (!section_is(section, k->section))
            continue;
        e = ini_find(r->ini, section, k->name);
        if (key_read(k, e ? e->value : NULL, base, &why) != SW_OK)
            return ini_fail(r->why, r->ini, e, "%s", why.text);
    }
    return SW_OK;
}

enum status keys_judge_names(const struct reading *r)
{
    for (int i = 0; i < r->ini->n_sections; i++) {
        const struct ini_entry *e = &r->ini->section[i];
        int known = 0;

        for (int j = 0; j < r->n_keys; j++)
            known |= section_is(e->section, r->keys[j].section);
        if (!known)
            return ini_fail(r->why, r->ini, e, "unknown section [%s]", e->section);
        if (e->section[bare(e->section)] != '\0' && !section_labelled(r, e->section))
            return ini_fail(r->why, r->ini, e, "section [%s] takes no label", e->section);
        if (strlen(e->section) >= KEYS_LABEL_BYTES)
            return ini_fail(r->why, r->ini, e, "the label is longer than %d bytes",
                            KEYS_LABEL_BYTES - 1);
    }
    for (int i = 0; i < r->ini->n; i++) {
        const struct ini_entry *e = &r->ini->entry[i];
        int known = 0;

        for (int j = 0; j < r->n_keys; j++)
            known |=
                section_is(e->section, r->keys[j].section) && strcmp(e->key, r->keys[j].name) == 0;
        if (!known)
            return ini_fail(r->why, r->ini, e, "unknown key '%s' in [%s]", e->key, e->section);
    }
    return SW_OK;
}

/* Whether the section stands nowhere in the file. */
static int began_by_set(const struct ini *ini, const char *section)
{
    int by_set = 0;

    for (int i = 0; i < ini->n_sections; i++)
        if (strcmp(ini->section[i].section, section) == 0) {
            if (ini->section[i].line > 0)
                return 0;
            by_set = 1;
        }
    return by_set;
}

const char *keys_place(const struct reading *r)
{
    return r->ini ? r->ini->name : r->row;
}

enum status keys_fail(const struct reading *r, const char *section, const char *key,
                      const char *text)
{
    const struct ini_entry *e = r->ini ? ini_find(r->ini, section, key) : NULL;

    if (!r->ini)
        return fail(r->why, SW_FORMAT, "%.400s: %s: %s", r->row, key, text);
    if (e)
        return ini_fail(r->why, r->ini, e, "%s: %s", key, text);
    if (began_by_set(r->ini, section))
        return fail(r->why, SW_USAGE, "--set began a new section [%s]: %s: %s", section, key, text);
    return fail(r->why, SW_FORMAT, "%.400s: [%s] %s: %s", r->ini->name, section, key, text);
}

static void print_word(const char *words, int index, struct out *o)
{
    while (index-- > 0)
        words += strcspn(words, " ") + 1;
    fprintf(o->f, " %.*s", (int)strcspn(words, " "), words);
}

/* Whether the key has a value. */
static int is_set(const struct key *k, const char *base)
{
    const char *at = base + k->at;

    if (k->kind == NUMBERS)
        return !isnan(*(const double *)(const void *)at);
    return k->kind == TEXT ? *at != '\0' : *(const int *)(const void *)at >= 0;
}

static void print_key(const struct key *k, const char *base, struct out *o)
{
    const char *at = base + k->at;
    const double *x = (const double *)(const void *)at;

    fprintf(o->f, "%s =", k->name);
    if (k->kind == WORD)
        print_word(k->words, *(const int *)(const void *)at, o);
    else if (k->kind == WHOLE)
        fprintf(o->f, " %d", *(const int *)(const void *)at);
    else if (k->kind == TEXT)
        fprintf(o->f, " %s", at);
    else if (k->words && x[0] == 0)
        fprintf(o->f, " %s", k->words);
    else
        for (int i = 0; i < k->most && !isnan(x[i]); i++) {
            putc(' ', o->f);
            out_number(o, x[i]);
        }
    putc('\n', o->f);
}

void keys_print(const struct key *keys, int n_keys, const char *heading, const void *base,
                struct out *o)
{
    int any = 0;

    for (int i = 0; i < n_keys; i++) {
        if (!section_is(heading, keys[i].section) || !is_set(&keys[i], base))
            continue;
        if (!any++)
            fprintf(o->f, "[%s]\n", heading);
        print_key(&keys[i], base, o);
    }
}

void keys_name(const struct key *keys, int n_keys, FILE *f)
{
    for (int i = 0; i < n_keys; i++)
        fprintf(f, "%s%s.%s", i ? " " : "", keys[i].section, keys[i].name);
}
