/*
 * The tables of wirebeam: columns, and rows taken into sections, loads, supports, springs.  Private
 * to form/wire*.c.
 */
#ifndef SEILWERK_FORM_WIRETABLES_H
#define SEILWERK_FORM_WIRETABLES_H

#include "form/wire.h"

#define WIRE_BIG 1e18

enum { NODE, NODE_X, N_NODE = NODE_X + 3 };
enum {
    ELEMENT,
    NODE_A,
    NODE_B,
    SECTION_OF,
    TANGENT,
    AXIS = TANGENT + 6,
    PSI_A = AXIS + 6,
    PSI_B,
    PSI_MID,
    HINGE_A,
    HINGE_B,
    N_ELEMENT
};
enum { SECTION, N_SECTION = 29 };
enum { HELD, HELD_U, HELD_STAGE = HELD_U + 6, N_SUPPORT };
enum { LOAD_NODE, LOAD_F, LOAD_ELEMENT = LOAD_F + 6, LOAD_Q, LOAD_STAGE = LOAD_Q + 3, N_LOAD };
enum {
    SPRING,
    SPRING_A,
    SPRING_B,
    SPRING_K,
    SPRING_AXIS = SPRING_K + 6,
    N_SPRING = SPRING_AXIS + 3
};

extern const struct sheet_column wire_node_column[N_NODE], wire_element_column[N_ELEMENT],
    wire_section_column[N_SECTION], wire_support_column[N_SUPPORT], wire_load_column[N_LOAD],
    wire_spring_column[N_SPRING];

/* Names of the rows of a table, for wire_find.  Owned. */
struct wire_names {
    struct roll roll;
    struct roll_index index;
};

/* SW_FORMAT: a name is empty or there twice; SW_NOMEM; to be freed in each case. */
enum status wire_names_new(const struct sheet *s, struct wire_names *ret, struct why *why);
void wire_names_free(struct wire_names *n);

/* Three cells as a unit vector; *ret_given: whether they are there. */
enum status wire_direction(const struct sheet *t, int row, int column, double ret[3],
                           int *ret_given, struct why *why);

/* The row called by the cell of a table; SW_FORMAT: there is none. */
enum status wire_find(const struct sheet *from, int row, int column, const char *kind,
                      const struct wire_names *in, int *ret, struct why *why);

/* Sections, supports, springs, loads of the frame; nodes and beams are there.  SW_FORMAT, SW_NOMEM.
 */
enum status wire_take_sections(struct wire *p, struct why *why);
enum status wire_take_supports(struct wire *p, const struct wire_names *nodes, struct why *why);
enum status wire_take_springs(struct wire *p, const struct wire_names *nodes, struct why *why);
enum status wire_take_loads(struct wire *p, const struct wire_names *nodes,
                            const struct wire_names *elements, struct why *why);

#endif
