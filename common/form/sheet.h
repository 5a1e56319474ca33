/*
 * Whole tables in memory: CSV with named columns, cells as text until they are asked for.
 */
#ifndef SEILWERK_FORM_SHEET_H
#define SEILWERK_FORM_SHEET_H

#include "form/roll.h"
#include "sys/csv.h"

/* A column that a table may have. */
struct sheet_column {
    const char *name;
    int needed; /* a table without it is refused */
};

struct sheet {
    char *name;  /* of the file; owned */
    int *at;     /* where each known column stands, -1: nowhere; owned */
    int n;       /* rows */
    int *line;   /* (n); owned */
    char ***row; /* (n) cells; owned */
    int room;
};

/* Read the table at path, relative to the file `beside` unless that is NULL; columns must be among
 * the known ones, in any order.  SW_READ, SW_FORMAT, SW_NOMEM. */
enum status sheet_read(const char *path, const char *beside, const struct sheet_column *known,
                       int n_known, struct sheet *ret, struct why *why);

void sheet_free(struct sheet *s);

/* The text of a cell, "" where the column is missing. */
const char *sheet_text(const struct sheet *s, int row, int column);

/* The number of a cell in [least, most], fallback where it is empty (NAN: it must not be).
 * SW_FORMAT with file and line. */
enum status sheet_number(const struct sheet *s, int row, int column, double least, double most,
                         double fallback, double *ret, struct why *why);

/* fail with "file:line: text". */
__attribute__((format(printf, 4, 5))) enum status sheet_fail(struct why *why, const struct sheet *s,
                                                             int row, const char *format, ...);

/* The names in a column, with their lines.  SW_NOMEM. */
enum status sheet_roll(const struct sheet *s, int column, struct roll *ret, struct why *why);

#endif
