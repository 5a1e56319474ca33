/*
 * A structure of curved wires from its case file and tables (wirebeam(1)): names and numbers to
 * struct frame.
 */
#ifndef SEILWERK_FORM_WIRE_H
#define SEILWERK_FORM_WIRE_H

#include "form/keys.h"
#include "form/sheet.h"
#include "phys/frame.h"
#include "sys/opt.h"

enum wire_method { WIRE_EQUILIBRIUM, WIRE_LINEAR, WIRE_UPDATED };
enum wire_path { WIRE_BY_LOAD, WIRE_BY_ARC };

/* The case file. */
struct wire_case {
    double gravity[3];
    char nodes[KEYS_TEXT_BYTES], elements[KEYS_TEXT_BYTES], sections[KEYS_TEXT_BYTES];
    char supports[KEYS_TEXT_BYTES], loads[KEYS_TEXT_BYTES], springs[KEYS_TEXT_BYTES];
    int method, path; /* enum wire_method, wire_path */
    int steps, most_steps, iterations;
    double tolerance;
    int lumped;           /* consistent, lumped */
    int critical, divide; /* no, yes */
    double largest_angle; /* [deg] */
    char watch[KEYS_TEXT_BYTES];
    int points; /* of an element in the table of forces */
};

/* Which element of the table a beam is a piece of, and where it begins. */
struct wire_piece {
    int element;
    double s; /* [m] */
};

struct wire {
    struct wire_case c;
    struct sheet nodes, elements, sections, supports, loads, springs;
    struct section *section;  /* (sections.n); owned */
    struct wire_piece *piece; /* (frame.beams), in the order of the elements; owned */
    struct frame frame;       /* nodes of the table first, then those of divided elements; owned */
    int watch;                /* node, -1: none */
    int moved;                /* whether there are loads or prescribed displacements at all */
};

/* Read the case at path with its --set assignments: keys alone.  SW_FORMAT, SW_USAGE, SW_READ,
 * SW_NOMEM. */
enum status wire_case_load(const char *path, const struct opt_list *sets, struct wire_case *ret,
                           struct why *why);

/* Print the resolved case. */
void wire_case_print(const struct wire_case *c, struct out *o);

/* The tables of the case at path, and the frame that they make.  Same failures. */
enum status wire_load(const char *path, const struct wire_case *c, struct wire *ret,
                      struct why *why);

void wire_free(struct wire *p);

/* Names of a node of the table and of an element; "" for a node of a divided element. */
const char *wire_node(const struct wire *p, int i);
const char *wire_element(const struct wire *p, int i);

/* Names of the keys that --set can set, blanks between. */
void wire_name_keys(FILE *f);

#endif
