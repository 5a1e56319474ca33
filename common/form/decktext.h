/*
 * The text of a mooring deck: sections, records, words, and the line of each (seilwerk-deck(5)).
 * Private to form/deck*.c.
 *
 * A line with "---" and a keyword opens a section; but for options and outputs, a line of names and
 * a line of units follow.  A comment begins with `#`, `!` or `%`; in the table of nodes of MAP++ a
 * `#` marks a guess and belongs to its word.
 */
#ifndef SEILWERK_FORM_DECKTEXT_H
#define SEILWERK_FORM_DECKTEXT_H

#include "sys/err.h"

#include <stddef.h>

enum deck_section {
    DECK_NONE, /* before the first section, and behind the closing line */
    DECK_TYPES,
    DECK_ROD_TYPES,
    DECK_BODIES,
    DECK_RODS,
    DECK_POINTS,
    DECK_LINES,
    DECK_OPTIONS,
    DECK_OUTPUTS,
    DECK_SECTIONS
};

struct deck_row {
    enum deck_section section;
    int line;     /* 0: there is none */
    int indented; /* blanks stand before the first word */
    int n;
    char **word; /* (n) */
};

struct deck {
    char *name; /* of the file; owned, like all that follows */
    char *text;
    char **word; /* all of them, one row after another */
    struct deck_row *row;
    int n;
    int lines;                            /* of the file */
    int opened[DECK_SECTIONS];            /* line of the heading, 0: no such section */
    struct deck_row names[DECK_SECTIONS]; /* of the columns */
    struct deck_row units[DECK_SECTIONS]; /* of the columns */
};

/* Read the deck at path.  SW_FORMAT: a section that is not known or there twice, no lines of names
 * and units; SW_READ, SW_NOMEM. */
enum status deck_read(const char *path, struct deck *ret, struct why *why);

void deck_free(struct deck *d);

/* The section that a line opens; DECK_NONE: it opens one that is not known, or the end; -1: it is
 * no heading.  The line is left as it was. */
int deck_heading(const char *line);

/* The next row of a section behind row i (-1: the first), -1: none. */
int deck_next(const struct deck *d, enum deck_section section, int i);

/* How many rows a section has. */
int deck_count(const struct deck *d, enum deck_section section);

/* Whether two words are the same but for capitals. */
int deck_same(const char *a, const char *b);

/* Where a row has this word, -1: nowhere. */
int deck_find(const struct deck_row *row, const char *word);

/* Whether row i has the columns that its section's form has; fewer will do where the line of names
 * has fewer, but not fewer than least.  SW_FORMAT. */
enum status deck_columns(const struct deck *d, int i, int columns, int least, struct why *why);

/* The number of a column in [least, most]; 0 where the row ends before.  SW_FORMAT with its line.
 */
enum status deck_number(const struct deck *d, int i, int column, double least, double most,
                        double *ret, struct why *why);

/* Text with 1 to most numbers and `|` between them.  SW_FORMAT with the line of row i. */
enum status deck_numbers(const struct deck *d, int i, int column, int most, double *ret, int *ret_n,
                         struct why *why);

/* fail with "file:line: text", SW_FORMAT. */
__attribute__((format(printf, 4, 5))) enum status deck_fail(struct why *why, const struct deck *d,
                                                            int line, const char *format, ...);

#endif
