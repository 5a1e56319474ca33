/*
 * Results of wirebeam: tables of nodes, section forces, history, modes and the summary
 * (wirebeam(1)).
 */
#ifndef SEILWERK_FORM_WIREFILES_H
#define SEILWERK_FORM_WIREFILES_H

#include "form/wire.h"
#include "phys/follow.h"
#include "sys/out.h"

struct wire_result {
    struct frame_state s;
    struct frame_work w;
    struct follow_path path; /* of linear theory: empty */
    enum status status;
    int stresses;           /* asked for */
    int modes;              /* 0: not asked for */
    double *lambda, *shape; /* (modes), (frame.n, 6, modes) */
};

void wire_result_free(struct wire_result *r);

void wire_print_nodes(const struct wire *p, const struct wire_result *r, struct out *o);
void wire_print_forces(const struct wire *p, const struct wire_result *r, struct out *o);
void wire_print_history(const struct wire *p, const struct wire_result *r, struct out *o);
void wire_print_summary(const struct wire *p, const struct wire_result *r, struct out *o);
void wire_print_modes(const struct wire_result *r, struct out *o);
void wire_print_shapes(const struct wire *p, const struct wire_result *r, struct out *o);

/* All of them to the directory dir, which is made; whole or not at all, each.  SW_WRITE, SW_NOMEM.
 */
enum status wire_write(const char *dir, const struct wire *p, const struct wire_result *r,
                       struct why *why);

/* Largest von Mises stress and the element, -1: no section knows its extent. */
double wire_worst(const struct wire *p, const struct wire_result *r, int *ret_element);

/* Largest strain at the points of the table of forces, of the axis and, where the section knows its
 * extent, of bending or torsion with it, and the element. */
double wire_strain(const struct wire *p, const struct wire_result *r, int *ret_element);

#endif
