/*
 * Tables of keys: what stands in the sections of an INI file, taken into structs and printed again.
 *
 * One table serves both ways.  A section may be labelled ("motion deck"); it then has a struct of
 * its own, and the offsets of its keys count from there.
 */
#ifndef SEILWERK_FORM_KEYS_H
#define SEILWERK_FORM_KEYS_H

#include "sys/ini.h"
#include "sys/out.h"

#include <stddef.h>

#define KEYS_TEXT_BYTES 200 /* room of a TEXT key, NUL included: any line of a file */
#define KEYS_LABEL_BYTES 64 /* room of a section's name with its label */

enum kind {
    NUMBERS, /* least..most numbers in [min, max] (doubles) */
    WHOLE,   /* whole number in [min, max] (int) */
    WORD,    /* one of words, its index (int) */
    TEXT     /* text of less than KEYS_TEXT_BYTES bytes */
};

struct key {
    const char *section, *name;
    enum kind kind;
    size_t at;       /* offset in the struct of the section */
    int least, most; /* how many numbers */
    double min, max;
    const char *words;    /* WORD: choices; NUMBERS: a word that stands for 0 */
    const char *fallback; /* default as text, or NULL: none */
};

/* A table of keys, those of one section together, and the file that is read by it: an INI file, or
 * one row of a table. */
struct reading {
    const struct ini *ini; /* NULL: a row of a table */
    const char *row;       /* then its "file:line" */
    const struct key *keys;
    int n_keys;
    const char *labelled; /* names of the sections that may carry a label, blanks between */
    struct why *why;
};

/* Whether section (with its label, if any) is called name. */
int section_is(const char *section, const char *name);

/* Whether sections called name may carry a label. */
int section_labelled(const struct reading *r, const char *name);

/* Refuse unknown sections and keys, labels where none belong.  SW_FORMAT or SW_USAGE, with line. */
enum status keys_judge_names(const struct reading *r);

/* All keys of one section (with its label) into base: given ones, else defaults; numbers without
 * default become NAN, whole numbers and words -1, texts empty.  SW_FORMAT or SW_USAGE, with line.
 */
enum status keys_take(const struct reading *r, const char *section, void *base);

/* One key from text (NULL: its default) into base.  SW_FORMAT with "name: what is wrong". */
enum status key_read(const struct key *k, const char *text, void *base, struct why *why);

/* The name of the file, or the row, for a message. */
const char *keys_place(const struct reading *r);

/* fail at the key's line if it was given, else at the file: "file: [section] key: text". */
enum status keys_fail(const struct reading *r, const char *section, const char *key,
                      const char *text);

/* Print heading (a section with its label) and its keys from base; what is NAN, -1 or empty is left
 * out. */
void keys_print(const struct key *keys, int n_keys, const char *heading, const void *base,
                struct out *o);

/* Names SECTION.KEY of a table, a blank before each but the first. */
void keys_name(const struct key *keys, int n_keys, FILE *f);

#endif
