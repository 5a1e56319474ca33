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

/* One value of a key: text to the place to. */
static enum status take_numbers(const struct reading *r, const struct ini_entry *e,
                                const struct key *k, const char *text, double *to)
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
    snprintf(copy, sizeof copy, "%s", text);
    for (word = strtok_r(copy, " \t", &rest); word; word = strtok_r(NULL, " \t", &rest)) {
        const char *reason;

        if (n == k->most && number_read(word, &more))
            return ini_fail(r->why, r->ini, e, "%s: '%s' is no number; units are fixed", k->name,
                            word);
        if (n == k->most)
            return ini_fail(r->why, r->ini, e, "%s: more than %d number%s", k->name, k->most,
                            k->most > 1 ? "s" : "");
        reason = number_read(word, &to[n]);
        if (reason)
            return ini_fail(r->why, r->ini, e, "%s: '%s': %s%s", k->name, word, reason,
                            strchr(word, ',') && k->most > 1 ? "; blanks separate numbers" : "");
        if (!(to[n] >= k->min && to[n] <= k->max))
            return ini_fail(r->why, r->ini, e, "%s: %s is outside of %g to %g", k->name, word,
                            k->min, k->max);
        n++;
    }
    if (n < k->least)
        return ini_fail(r->why, r->ini, e, "%s: %d numbers are expected", k->name, k->least);
    return SW_OK;
}

static enum status take_word(const struct reading *r, const struct ini_entry *e,
                             const struct key *k, const char *text, int *to)
{
    const char *p = k->words;
    size_t length = strlen(text);

    for (*to = 0; *p; (*to)++) {
        size_t l = strcspn(p, " ");

        if (l == length && strncmp(p, text, l) == 0)
            return SW_OK;
        p += l + (p[l] == ' ');
    }
    return ini_fail(r->why, r->ini, e, "%s: '%s' is not one of: %s", k->name, text, k->words);
}

static enum status take_whole(const struct reading *r, const struct ini_entry *e,
                              const struct key *k, const char *text, int *to)
{
    long value = -1;
    const char *reason = text ? integer_read(text, (long)k->min, (long)k->max, &value) : NULL;

    if (reason)
        return ini_fail(r->why, r->ini, e, "%s: '%s': %s (expected %.0f to %.0f)", k->name, text,
                        reason, k->min, k->max);
    *to = (int)value;
    return SW_OK;
}

enum status keys_take(const struct reading *r, const char *section, void *base)
{
    enum status s = SW_OK;

    for (int i = 0; i < r->n_keys && s == SW_OK; i++) {
        const struct key *k = &r->keys[i];
        const struct ini_entry *e;
        const char *text;
        char *to = (char *)base + k->at;

        if (!section_is(section, k->section))
            continue;
        e = ini_find(r->ini, section, k->name);
        text = e ? e->value : k->fallback;
        if (k->kind == WHOLE)
            s = take_whole(r, e, k, text, (int *)(void *)to);
        else if (k->kind == NUMBERS && text)
            s = take_numbers(r, e, k, text, (double *)(void *)to);
        else if (k->kind == NUMBERS)
            for (int j = 0; j < k->most; j++)
                ((double *)(void *)to)[j] = NAN;
        else if (k->kind == WORD)
            s = take_word(r, e, k, text, (int *)(void *)to);
        else if (snprintf(to, KEYS_TEXT_BYTES, "%s", text) >= KEYS_TEXT_BYTES)
            s = ini_fail(r->why, r->ini, e, "%s: longer than %d bytes", k->name,
                         KEYS_TEXT_BYTES - 1);
    }
    return s;
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
        if (strlen(e->section) >= KEYS_TEXT_BYTES)
            return ini_fail(r->why, r->ini, e, "the label is longer than %d bytes",
                            KEYS_TEXT_BYTES - 1);
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

enum status keys_fail(const struct reading *r, const char *section, const char *key,
                      const char *text)
{
    const struct ini_entry *e = ini_find(r->ini, section, key);

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

static void print_key(const struct key *k, const char *base, struct out *o)
{
    const char *at = base + k->at;
    const double *x = (const double *)(const void *)at;

    if ((k->kind == NUMBERS && isnan(x[0])) ||
        (k->kind == WHOLE && *(const int *)(const void *)at < 0))
        return;
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
    fprintf(o->f, "[%s]\n", heading);
    for (int i = 0; i < n_keys; i++)
        if (section_is(heading, keys[i].section))
            print_key(&keys[i], base, o);
}
