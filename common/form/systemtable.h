/*
 * The tables of a system of ropes, one function a table (gapnet(1)).  Private to form/system*.c.
 */
#ifndef SEILWERK_FORM_SYSTEMTABLE_H
#define SEILWERK_FORM_SYSTEMTABLE_H

#include "form/sheet.h"
#include "form/system.h"

#define SYSTEM_BIG 1e9 /* m, kg/m: the largest of what a cell may say */

/* All tables of the case p->c at path.  SW_FORMAT with file and line, SW_READ, SW_NOMEM. */
enum status system_read_tables(const char *path, struct system *p, struct why *why);

/* Types of ropes: names to p->types, numbers to p->type, which is allocated. */
enum status system_read_types(const char *path, struct system *p, struct why *why);

/* A table of tension by strain, for a type: strains, then tensions, ascending, allocated. */
enum status system_tension_table(const char *path, const char *beside, struct system_type *to,
                                 struct why *why);

/* Bodies: names to p->bodies, numbers to p->body and p->net.body, which are allocated. */
enum status system_read_bodies(const char *path, struct system *p, struct why *why);

/* Bed and current of the case: to p->sea. */
enum status system_read_sea(const char *path, struct system *p, struct why *why);

#endif
