/*
 * Arrangements of lifts: rows of a CSV table, or one from the command line, to suspensions.
 */
#ifndef SEILWERK_FORM_LIFT_H
#define SEILWERK_FORM_LIFT_H

#include "form/column.h"
#include "form/detail.h"
#include "sys/csv.h"
#include "sys/opt.h"
#include "sys/out.h"

/* One row as it is written, in SI units and radians. */
struct lift_given {
    int type[LIFT_ENDS];      /* enum rigging_type, LIFT_PAIR, LIFT_UNKNOWN */
    double x[LIFT_NUMBERS];   /* quantity * LIFT_ENDS + end, then e1, e2, offset; NAN: empty */
    double tol[LIFT_NUMBERS]; /* 0: none */
    int loose;                /* numbers that are given twice need not agree: for samples */
};

/* What is hung. */
struct lift {
    int ends; /* 1, or 2 in a pair */
    struct suspension end[2];
    struct detail detail[2]; /* of each end, for exact statics */
    int assumed[2];          /* whether their number of slings is the default */
    double share[2];         /* of the mass, sum 1 */
    double apart;            /* m, distance of the ends of a pair; NAN: not known */
    double offset;           /* m, with its tolerance; NAN: not given */
};

/* The arrangement of a row (arrange.c).  The type of an end that is not given is primary-secondary
 * with s, primary with v only, else single.  SW_ADMISSIBLE, with column and reason in why. */
enum status lift_make(const struct lift_given *g, struct lift *ret, struct why *why);

/* Write all that follows from g, from which l was made, into g: given back it makes the same l. */
void lift_resolve(const struct lift *l, struct lift_given *g);

/* A table that is read row by row, or the one arrangement of --set alone. */
struct lift_table {
    struct csv csv;         /* name NULL: no file */
    int n_file, n;          /* columns of the file; with those that --set adds */
    int done;               /* the one arrangement of the command line has been given out */
    int warned;             /* of slings that are only assumed, see lift_warn */
    struct lift_slot *slot; /* what each column is; owned */
};

/* Read the header line of in, or take the columns of sets alone if in is NULL.  Columns that are
 * nearly one of sling's, and results of sling itself, are refused; others are copied, with a
 * warning unless they are called name.  sets override the cells of every row.  SW_FORMAT, SW_USAGE,
 * SW_READ, SW_NOMEM. */
enum status lift_begin(const struct in *in, const struct opt_list *sets, struct lift_table *ret,
                       struct why *why);

/* The next row.  *ret_end: there was none.  SW_FORMAT: this row cannot be used, the next may be
 * read; SW_READ, SW_NOMEM. */
enum status lift_row(struct lift_table *t, struct lift_given *ret, int *ret_end, struct why *why);

/* "file:line: " or "--set: " before what is wrong with the present row. */
enum status lift_fail(const struct lift_table *t, struct why *why);

/* Warn, once a table, if l, the present row, has a working load limit but only the default for the
 * number of slings that it is compared by. */
void lift_warn(struct lift_table *t, const struct lift *l);

/* What is wrong without that place; points into why. */
const char *lift_reason(const struct lift_table *t, const struct why *why);

/* The cell of the column called name in the present row, or "". */
const char *lift_label(const struct lift_table *t);

/* Whether x[i] is a column of the table, or has a tolerance in it. */
int lift_has(const struct lift_table *t, int i, int tolerance);
int lift_has_ends(const struct lift_table *t);

/* Cells of the header, of the present row, with commas between and no line end. */
void lift_print_header(const struct lift_table *t, struct out *o);
void lift_print_row(const struct lift_table *t, struct out *o);

void lift_end(struct lift_table *t);

#endif
