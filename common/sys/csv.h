/*
 * CSV rows as RFC 4180 but LF, read line by line with exact line numbers.
 *
 * CR LF and a byte order mark are accepted; quotes close on their line; blank lines are passed
 * over, and so are rows of nothing but commas, which spreadsheets leave behind the last one; `;`
 * and tabs as separators are named in the message.
 */
#ifndef SEILWERK_SYS_CSV_H
#define SEILWERK_SYS_CSV_H

#include "sys/in.h"

#include <stddef.h>

struct csv_reader; /* parser and line buffer, private */

struct csv {
    const char *name; /* of the file, for messages; owned by the caller */
    int line;         /* of the present row, from 1 */
    int n;            /* cells in it */
    char **cell;      /* NUL-terminated, valid until the next row */
    int keep;         /* whether rows of nothing but commas count; set it after csv_begin */
    struct csv_reader *reader;
};

/* Begin to read in; nothing is read yet.  SW_NOMEM. */
enum status csv_begin(const struct in *in, struct csv *ret, struct why *why);

/* Next row; at the end of the file n is 0 and cell NULL.  SW_FORMAT (open quote, quote inside of a
 * cell, NUL byte, carriage return within the line; the row after it may be read), SW_READ,
 * SW_NOMEM. */
enum status csv_row(struct csv *c, struct why *why);

/* The header row as csv_row, refused with a hint if it seems to be separated by semicolons or
 * tabs. */
enum status csv_header(struct csv *c, struct why *why);

/* Whether the present row has n cells, as the header.  SW_FORMAT with both counts. */
enum status csv_width(const struct csv *c, int n, struct why *why);

/* Cell i as a finite number.  SW_FORMAT with file, line and column number. */
enum status csv_number(const struct csv *c, int i, double *ret, struct why *why);

/* A copy of the cells of the present row, in one piece of memory to be freed; NULL: memory ran out.
 */
char **csv_copy(const struct csv *c);

/* fail with "file:line: text". */
__attribute__((format(printf, 3, 4))) enum status csv_fail(struct why *why, const struct csv *c,
                                                           const char *format, ...);

void csv_end(struct csv *c);

#endif
