/*
 * Names of things that stand in files, with the lines where they stand: what a message about them
 * needs, whatever kind of file it was.
 */
#ifndef SEILWERK_FORM_ROLL_H
#define SEILWERK_FORM_ROLL_H

#include "sys/err.h"

#include <stddef.h>

struct roll_item {
    char *name; /* owned */
    int line;
};

struct roll {
    char *file; /* owned */
    int n, room;
    struct roll_item *item; /* (n); owned */
};

/* Begin one for a file, empty.  SW_NOMEM. */
enum status roll_begin(struct roll *r, const char *file, struct why *why);

/* Append a name that may stand there already.  SW_NOMEM. */
enum status roll_add(struct roll *r, const char *name, int line, struct why *why);

void roll_free(struct roll *r);

/* "" where i is none of it. */
const char *roll_name(const struct roll *r, int i);

/* fail with "file:line: text", SW_FORMAT. */
__attribute__((format(printf, 4, 5))) enum status roll_fail(struct why *why, const struct roll *r,
                                                            int i, const char *format, ...);

/* Names in order, for roll_find. */
struct roll_index {
    int *at; /* (n) by name; owned */
    int n;
};

/* SW_FORMAT: a name is empty or there twice; SW_NOMEM. */
enum status roll_sort(const struct roll *r, struct roll_index *ret, struct why *why);

/* The item with this name, -1: none. */
int roll_find(const struct roll *r, const struct roll_index *index, const char *name);

/* The same without an index: for a few names. */
int roll_search(const struct roll *r, const char *name, size_t length);

#endif
