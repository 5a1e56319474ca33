/*
 * Tables of parameter points: CSV with a point a row, columns named SECTION.KEY, which vary a case.
 *
 * Any key may vary but those of the model, of [sweep] and time.probes.  An empty cell leaves what
 * the case says.  A column called name is passed on.
 */
#ifndef SEILWERK_FORM_POINTS_H
#define SEILWERK_FORM_POINTS_H

#include "form/cable.h"

struct point {
    int line;
    char **cell; /* (n_columns) in the table's memory; NULL: the row is damaged */
    char *wrong; /* then: why; owned */
};

struct points {
    const char *name; /* of the file; not owned */
    char **column;    /* (n_columns); owned */
    int n_columns;
    struct point *point; /* (n); owned */
    int n, room;
    const char *case_path; /* not owned */
    char *case_text;       /* the case file; owned */
    size_t case_bytes;
    const struct opt_list *sets; /* not owned */
};

/* Read the whole table at path, and the case at case_path that it varies, with its --set.  SW_READ,
 * SW_FORMAT: also a column that no point may vary; SW_NOMEM. */
enum status points_read(const char *path, const char *case_path, const struct opt_list *sets,
                        struct points *ret, struct why *why);

void points_free(struct points *p);

/* The case of point i, resolved, its records read.  SW_FORMAT, SW_USAGE, SW_ADMISSIBLE,
 * SW_INFEASIBLE with the line of the table; SW_NOMEM. */
enum status points_case(const struct points *p, int i, struct cable_case *ret, struct why *why);

/* A checksum of table and case. */
unsigned long points_checksum(const struct points *p);

/* The columns; the cells of point i; without line end. */
void points_header(const struct points *p, struct out *o);
void points_print(const struct points *p, int i, struct out *o);

#endif
