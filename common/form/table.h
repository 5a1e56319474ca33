/*
 * Tables of cables: CSV with one cable a row, columns named like the keys of the model sections
 * ("span" or "supports.span"); an empty cell stands for the key's default.
 */
#ifndef SEILWERK_FORM_TABLE_H
#define SEILWERK_FORM_TABLE_H

#include "form/cable.h"
#include "sys/csv.h"

struct table {
    struct csv csv;
    const struct key **key;  /* of each column, NULL: copied only; owned */
    int n;                   /* columns */
    struct cable_case blank; /* defaults and --set */
};

/* Read the header line of in.  Unknown columns are copied, with a warning unless they are called
 * name.  SW_FORMAT, SW_USAGE, SW_READ, SW_NOMEM. */
enum status table_begin(const struct in *in, const struct opt_list *sets, struct table *ret,
                        struct why *why);

/* The next row into *ret, resolved.  At the end of the file t->csv.cell is NULL.  SW_FORMAT,
 * SW_ADMISSIBLE, SW_INFEASIBLE: the row cannot be used, the next may be read; SW_READ, SW_NOMEM. */
enum status table_row(struct table *t, struct cable_case *ret, struct why *why);

/* Print the cells of the present row, at first the header; as many as the header has, without a
 * line end. */
void table_print(const struct table *t, struct out *o);

void table_end(struct table *t);

#endif
