/* INI files on libinih, with a reader of our own that counts the lines and judges their form. */
#include "sys/ini.h"
#include "num/mem.h"

#include <ctype.h>
#include <ini.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

struct reading {
    FILE *f;
    struct ini *ini;
    struct why *why;
    enum status status;
    int line;
};

static void strip_comment(char *text)
{
    for (char *p = text; *p; p++)
        if ((*p == '#' || *p == ';') && (p == text || isspace((unsigned char)p[-1]))) {
            *p = '\0';
            return;
        }
}

static char *trim(char *text)
{
    char *end = text + strlen(text);

    while (end > text && isspace((unsigned char)end[-1]))
        *--end = '\0';
    while (isspace((unsigned char)*text))
        text++;
    return text;
}

/* Fold runs of blanks within a section's name to one, so that labels compare. */
static void fold(char *text)
{
    char *to = text;

    for (char *p = text; *p; p++)
        if (!isspace((unsigned char)*p) || !isspace((unsigned char)p[1]))
            *to++ = isspace((unsigned char)*p) ? ' ' : *p;
    *to = '\0';
}

static void free_entry(struct ini_entry *e)
{
    free(e->section);
    free(e->key);
    free(e->value);
}

static enum status push(struct ini_entry **list, int *n, const char *section, const char *key,
                        const char *value, int line)
{
    struct ini_entry *grown = *list, e = {.line = line};

    if ((*n & (*n - 1)) == 0) /* room doubles at powers of two */
        grown = mem_resize(*list, *n > 0 ? 2 * (size_t)*n : 1, sizeof **list);
    if (!grown)
        return SW_NOMEM;
    *list = grown;
    e.section = mem_copy(section, strlen(section) + 1);
    e.key = key ? mem_copy(key, strlen(key) + 1) : NULL;
    e.value = value ? mem_copy(value, strlen(value) + 1) : NULL;
    if (!e.section || (key && !e.key) || (value && !e.value)) {
        free_entry(&e);
        return SW_NOMEM;
    }
    grown[(*n)++] = e;
    return SW_OK;
}

__attribute__((format(printf, 2, 3))) static int stop(struct reading *r, const char *format, ...)
{
    char text[sizeof r->why->text];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    r->status = fail(r->why, SW_FORMAT, "%s:%d: %.900s", r->ini->name, r->line, text);
    return 0;
}

/* Judge the stripped line: inih would pass over some of this without a word.  Returns 0 when the
 * reading ends here. */
static int judge(struct reading *r, char *text)
{
    char *equals = strchr(text, '='), *colon = strchr(text, ':');

    if (text[0] == '[') {
        char *end = strchr(text, ']');

        if (!end || trim(end + 1)[0] != '\0')
            return stop(r, "a section is written [name] or [name label]");
        *end = '\0';
        memmove(text + 1, trim(text + 1), strlen(trim(text + 1)) + 1);
        fold(text + 1);
        if (text[1] == '\0')
            return stop(r, "the section has no name");
        if (push(&r->ini->section, &r->ini->n_sections, text + 1, NULL, NULL, r->line) != SW_OK) {
            r->status = fail_plain(r->why, SW_NOMEM);
            return 0;
        }
        end = strchr(text, '\0'); /* back as it was, for inih; the line was longer before */
        end[0] = ']';
        end[1] = '\0';
        return 1;
    }
    if (text[0] == '\0')
        return 1;
    if (!equals || equals == text)
        return stop(r, "expected key = value");
    if (colon && colon < equals)
        return stop(r, "a key ends with '=', not with ':'");
    strip_comment(equals + 1); /* right after the '=' */
    if (trim(equals + 1)[0] == '\0')
        return stop(r, "the key has no value");
    if (r->ini->n_sections == 0)
        return stop(r, "the key stands before any [section]");
    return 1;
}

/* inih's reader: one line, stripped, or NULL at the end or at the first error. */
static char *next_line(char *str, int num, void *stream)
{
    struct reading *r = stream;
    char raw[INI_LINE_BYTES + 6]; /* byte order mark, CR, one byte too many, NUL */
    char *text = raw;
    int c = 0, n = 0;

    if (r->status != SW_OK)
        return NULL;
    r->line++;
    while (n < (int)sizeof raw - 1 && (c = getc(r->f)) != EOF && c != '\n') {
        if (c == '\0') {
            stop(r, "a NUL byte: this is no text file");
            return NULL;
        }
        raw[n++] = (char)c;
    }
    raw[n] = '\0';
    if (ferror(r->f)) {
        r->status = fail(r->why, SW_READ, "%s: cannot be read", r->ini->name);
        return NULL;
    }
    if (n == 0 && c == EOF)
        return NULL;
    if (n > 0 && raw[n - 1] == '\r')
        raw[--n] = '\0';
    if (r->line == 1 && strncmp(raw, "\xef\xbb\xbf", 3) == 0)
        text += 3;
    if (strlen(text) > INI_LINE_BYTES || n == (int)sizeof raw - 1) {
        stop(r, "the line is longer than %d bytes", INI_LINE_BYTES);
        return NULL;
    }
    strip_comment(text);
    text = trim(text);
    if (!judge(r, text))
        return NULL;
    snprintf(str, (size_t)num, "%s\n", text);
    return str;
}

/* Called by inih right after the line was read, so that r->line is that of the key.  The section's
 * name is ours: inih cuts long ones. */
static int on_key(void *user, const char *cut_section, const char *key, const char *value)
{
    struct reading *r = user;
    const struct ini_entry *before;
    const char *section;

    (void)cut_section;
    if (r->status != SW_OK)
        return 0;
    section = r->ini->section[r->ini->n_sections - 1].section;
    before = ini_find(r->ini, section, key);
    if (before)
        return stop(r, "[%s] %s was given in line %d already", section, key, before->line);
    r->status = push(&r->ini->entry, &r->ini->n, section, key, value, r->line);
    if (r->status != SW_OK)
        fail_plain(r->why, r->status);
    return r->status == SW_OK;
}

enum status ini_read(FILE *f, const char *name, struct ini *ret, struct why *why)
{
    struct reading r = {.f = f, .ini = ret, .why = why, .status = SW_OK};
    int line;

    *ret = (struct ini){.name = mem_copy(name, strlen(name) + 1)};
    if (!ret->name)
        return fail_plain(why, SW_NOMEM);
    line = ini_parse_stream(next_line, &r, on_key, &r);
    if (r.status == SW_OK && line < 0)
        r.status = fail_plain(why, SW_NOMEM);
    if (r.status == SW_OK && line > 0)
        r.status = fail(why, SW_FORMAT, "%s:%d: expected key = value", name, line);
    return r.status;
}

/* Whether the name or value could stand in a file; cut where a comment would begin. */
static int can_stand(char *text)
{
    size_t length = strlen(text);

    strip_comment(text);
    return strlen(text) == length && !strchr(text, '\n');
}

static void drop(struct ini_entry *list, int *n, struct ini_entry *e)
{
    free_entry(e);
    memmove(e, e + 1, sizeof *e * (size_t)(list + *n - (e + 1)));
    --*n;
}

/* A section that has lost its last key is gone, too. */
static void drop_empty_section(struct ini *ini, const char *name)
{
    for (int i = 0; i < ini->n; i++)
        if (strcmp(ini->entry[i].section, name) == 0)
            return;
    for (int i = ini->n_sections - 1; i >= 0; i--)
        if (strcmp(ini->section[i].section, name) == 0)
            drop(ini->section, &ini->n_sections, &ini->section[i]);
}

enum status ini_set(struct ini *ini, const char *assignment, struct why *why)
{
    char copy[INI_LINE_BYTES + 1];
    char *equals, *dot, *section, *key, *value;
    struct ini_entry *e;
    size_t length = strlen(assignment);

    if (length > INI_LINE_BYTES)
        return fail(why, SW_USAGE, "--set: longer than %d bytes", INI_LINE_BYTES);
    memcpy(copy, assignment, length + 1);
    equals = strchr(copy, '=');
    if (equals)
        *equals = '\0';
    dot = strrchr(copy, '.');
    if (!equals || !dot)
        return fail(why, SW_USAGE, "--set %s: expected SECTION.KEY=VALUE", assignment);
    *dot = '\0';
    section = trim(copy);
    fold(section);
    key = trim(dot + 1);
    value = trim(equals + 1);
    if (*section == '\0' || *key == '\0')
        return fail(why, SW_USAGE, "--set %s: expected SECTION.KEY=VALUE", assignment);
    if (!can_stand(section) || strchr(section, ']'))
        return fail(why, SW_USAGE, "--set %s: no file could hold such a section", assignment);
    if (!can_stand(value))
        return fail(why, SW_USAGE, "--set %s: no file could hold such a value", assignment);
    e = (struct ini_entry *)ini_find(ini, section, key);
    if (e && *value != '\0') {
        char *changed = mem_copy(value, strlen(value) + 1);

        if (!changed)
            return fail_plain(why, SW_NOMEM);
        free(e->value);
        e->value = changed;
        e->line = 0;
    } else if (e) {
        drop(ini->entry, &ini->n, e);
        drop_empty_section(ini, section);
    } else if (*value != '\0' &&
               (push(&ini->section, &ini->n_sections, section, NULL, NULL, 0) != SW_OK ||
                push(&ini->entry, &ini->n, section, key, value, 0) != SW_OK))
        return fail_plain(why, SW_NOMEM);
    return SW_OK;
}

const struct ini_entry *ini_find(const struct ini *ini, const char *section, const char *key)
{
    for (int i = 0; i < ini->n; i++)
        if (strcmp(ini->entry[i].section, section) == 0 && strcmp(ini->entry[i].key, key) == 0)
            return &ini->entry[i];
    return NULL;
}

enum status ini_fail(struct why *why, const struct ini *ini, const struct ini_entry *e,
                     const char *format, ...)
{
    char text[512];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (e->line == 0) { /* the key stands in front already */
        size_t key = e->key ? strlen(e->key) : 0;
        int twice = key > 0 && strncmp(text, e->key, key) == 0 && strncmp(text + key, ": ", 2) == 0;

        return fail(why, SW_USAGE, "--set %s%s%s: %s", e->section, e->key ? "." : "",
                    e->key ? e->key : "", twice ? text + key + 2 : text);
    }
    return fail(why, SW_FORMAT, "%.400s:%d: %s", ini->name, e->line, text);
}

static void free_list(struct ini_entry *list, int n)
{
    for (int i = 0; i < n; i++)
        free_entry(&list[i]);
    free(list);
}

void ini_free(struct ini *ini)
{
    free_list(ini->entry, ini->n);
    free_list(ini->section, ini->n_sections);
    free(ini->name);
    *ini = (struct ini){0};
}
