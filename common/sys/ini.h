/*
 * INI files: sections, keys, values, line numbers; no meaning.
 *
 * Form: "[section]" or "[section label]", "key = value"; `#` or `;` start a comment at a line's
 * beginning or after a blank; leading blanks do not matter; lines up to 198 bytes.  Double keys are
 * refused with both lines.
 */
#ifndef SEILWERK_SYS_INI_H
#define SEILWERK_SYS_INI_H

#include "sys/err.h"

#include <stdio.h>

#define INI_LINE_BYTES 198 /* longest line, its end not counted */

struct ini_entry {
    char *section; /* with label, one blank between */
    char *key;
    char *value;
    int line; /* 0: given by ini_set */
};

struct ini {
    char *name; /* of the file, for messages */
    struct ini_entry *entry;
    int n;
    struct ini_entry *section; /* section headings in order; key and value NULL */
    int n_sections;
};

/* Read f; name for messages (copied).  SW_FORMAT with file and line, SW_READ, SW_NOMEM; *ret may be
 * freed in each case. */
enum status ini_read(FILE *f, const char *name, struct ini *ret, struct why *why);

/* Set SECTION.KEY=VALUE: replaces or adds; an empty value removes the key, and with
 * the last key the section.  SW_USAGE. */
enum status ini_set(struct ini *ini, const char *assignment, struct why *why);

/* The entry, or NULL. */
const struct ini_entry *ini_find(const struct ini *ini, const char *section, const char *key);

/* fail with "file:line: text", or "--set SECTION.KEY: text" for what ini_set brought; a
 * text that begins with "KEY: " loses that there. */
__attribute__((format(printf, 4, 5))) enum status ini_fail(struct why *why, const struct ini *ini,
                                                           const struct ini_entry *e,
                                                           const char *format, ...);

void ini_free(struct ini *ini);

#endif
