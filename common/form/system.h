/*
 * A system of ropes from its case file and tables (gapnet(1)): names and numbers to struct net.
 */
#ifndef SEILWERK_FORM_SYSTEM_H
#define SEILWERK_FORM_SYSTEM_H

#include "form/keys.h"
#include "form/sheet.h"
#include "phys/net.h"
#include "sys/opt.h"

enum system_rope { ROPE_AUTO, ROPE_CHAIN, ROPE_CATENARY };

/* The case file. */
struct system_case {
    double gravity, density;
    char nodes[KEYS_TEXT_BYTES], ropes[KEYS_TEXT_BYTES], types[KEYS_TEXT_BYTES];
    char loads[KEYS_TEXT_BYTES]; /* empty: none */
    int method;                  /* enum net_method */
    int rope;                    /* enum system_rope */
    int elements;                /* of a chain whose row says nothing */
    double tolerance;
    int steps;
    int start, start_steps; /* enum net_stiffness */
    int pull;               /* enum net_pull */
};

struct system_type {
    double diameter, mass, breaking; /* [m], [kg/m], [N] or NAN */
    struct rope_law law;
    double *table; /* strains, then tensions; owned */
};

struct system {
    struct system_case c;
    struct sheet nodes, ropes, types, loads;
    struct system_type *type; /* owned */
    int *type_of;             /* of each rope; owned */
    struct net net;           /* its node and rope are owned */
};

/* Read the case at path with its --set assignments: keys alone.  SW_FORMAT, SW_USAGE, SW_READ,
 * SW_NOMEM. */
enum status system_case_load(const char *path, const struct opt_list *sets, struct system_case *ret,
                             struct why *why);

/* Print the resolved case. */
void system_case_print(const struct system_case *c, struct out *o);

/* The tables of the case at path, and the net that they make.  Same failures, and SW_ADMISSIBLE
 * where the net is refused. */
enum status system_load(const char *path, const struct system_case *c, struct system *ret,
                        struct why *why);

void system_free(struct system *s);

/* Names of node i and rope r. */
const char *system_node(const struct system *s, int i);
const char *system_rope(const struct system *s, int r);

/* Find fault with what is admissible, but seldom meant; each finding is handed over with its place.
 * Returns their number. */
int system_lint(const struct system *s, void (*tell)(const char *text));

#endif
