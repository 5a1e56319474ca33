/*
 * The columns that sling appends to a row: what a judgement says, and exact statics.
 */
#ifndef SEILWERK_FORM_RESULT_H
#define SEILWERK_FORM_RESULT_H

#include "form/judge.h"

struct result_asked {
    int ends, exact; /* whether the columns of a pair's ends, of exact statics are printed */
};

/* Names of the columns, with a comma before each. */
void result_header(const struct result_asked *a, struct out *o);

/* Their cells; e NULL: none of exact statics, though asked for. */
void result_row(const struct judgement *j, const struct result_asked *a, const struct exact *e,
                struct out *o);

/* Numbers as cells with a comma before each, empty for NAN. */
void result_cell(struct out *o, double x);
void result_cells(struct out *o, const double *x, size_t n);

#endif
