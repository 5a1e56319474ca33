/*
 * A system of ropes: names and numbers of its files, and the struct net that they make (gapnet(1)).
 *
 * It comes from a case file with tables beside it, or from a mooring deck of another code
 * (seilwerk-deck(5)); what follows does not know from which.
 */
#ifndef SEILWERK_FORM_SYSTEM_H
#define SEILWERK_FORM_SYSTEM_H

#include "form/keys.h"
#include "form/roll.h"
#include "phys/net.h"
#include "phys/sea.h"
#include "sys/opt.h"

enum system_rope { ROPE_AUTO, ROPE_CHAIN, ROPE_CATENARY };
enum system_drag { DRAG_RENEW, DRAG_HOLD };

/* The case file, or what a deck's options say. */
struct system_case {
    int is_deck; /* path is a deck: its tables are in itself */
    double gravity, density;
    double depth, slope[2]; /* NAN: no bed; bed_slope dz/dx, dz/dy */
    double friction;        /* of the bed, for ropes whose type gives none; NAN: not given */
    char bed[KEYS_TEXT_BYTES];
    char nodes[KEYS_TEXT_BYTES], ropes[KEYS_TEXT_BYTES], types[KEYS_TEXT_BYTES];
    char loads[KEYS_TEXT_BYTES], current[KEYS_TEXT_BYTES], bodies[KEYS_TEXT_BYTES]; /* or empty */
    int method;   /* enum net_method */
    int rope;     /* enum system_rope */
    int elements; /* of a chain whose row says nothing */
    double tolerance;
    int steps;
    int start, start_steps; /* enum net_stiffness */
    int pull;               /* enum net_pull */
    int drag;               /* enum system_drag */
};

struct system_type {
    double diameter, mass, breaking; /* [m], [kg/m], [N] or INFINITY */
    double cd, cd_axial;
    double friction; /* on the bed; NAN: the case's */
    struct rope_law law;
    double *table; /* strains, then tensions; owned */
};

/* What was said of a node, beside what struct net_node needs. */
struct system_node {
    double mass, volume, cda; /* [kg], [m3], [m2] */
    double pull[3];           /* forces of tables of nodes and loads [N] */
    double given[3];          /* coordinates as they stand in the file, of the body if it has one */
};

/* What was said of a body, beside what struct net_body needs. */
struct system_body {
    double mass, volume, area; /* [kg], [m3], [m2] */
};

/* What was passed over on reading, in words for the user. */
struct system_note {
    char *text; /* owned */
    int warns;  /* it changes results */
};

struct system {
    struct system_case c;
    struct roll nodes, ropes, types, bodies;
    struct system_type *type; /* owned, like all that follows */
    int *type_of;             /* of each rope */
    int *segments;            /* of each rope in codes of dynamics; 0: not said */
    struct system_node *node;
    struct system_body *body;
    struct net net;    /* its nodes, ropes and bodies */
    struct sea sea;    /* net.sea points here where there is a bed or a current */
    double *bed_table; /* numbers of a grid */
    double *current_table;
    struct system_note *note; /* (notes) */
    int notes;
};

/* Read the case at path with its --set assignments: keys alone.  SW_FORMAT, SW_USAGE, SW_READ,
 * SW_NOMEM. */
enum status system_case_load(const char *path, const struct opt_list *sets, struct system_case *ret,
                             struct why *why);

/* The keys of an INI file, or of what a deck says in its place.  As above. */
enum status system_case_take(const struct ini *ini, struct system_case *ret, struct why *why);

/* Print the resolved case. */
void system_case_print(const struct system_case *c, struct out *o);

/* The system of the case at path: tables beside it, or the deck itself.  Same failures, and
 * SW_ADMISSIBLE where the net is refused. */
enum status system_load(const char *path, const struct system_case *c, struct system *ret,
                        struct why *why);

void system_free(struct system *s);

/* What is held inside the bed, from which no rope can begin, is refused: SW_FORMAT with the line.
 * Fixed nodes whose height was left open, or is that of the bed but for rounding, stand on it. */
enum status system_judge_bed(struct system *p, struct why *why);

/* Names of node i and rope r. */
const char *system_node(const struct system *s, int i);
const char *system_rope(const struct system *s, int r);

/* Find fault with what is admissible, but seldom meant; each finding is handed over with its place.
 * Before a solution what that will tell itself is left out: floats whose place is a guess, and that
 * there is no bed.  Returns their number. */
int system_lint(const struct system *s, int solves, void (*tell)(const char *text));

/*
 * For readers of tables and decks: from what was said to what is computed.
 */

/* Begin: all empty.  Names of nodes and so on begin with the reader. */
void system_begin(const struct system_case *c, struct system *ret);

/* Room for p->nodes.n nodes, ropes.n ropes, types.n types, bodies.n bodies.  SW_NOMEM. */
enum status system_room(struct system *p, struct why *why);

/* Node i from p->node[i] and held, x (NAN where free and not given), K, area, body of its net_node:
 * weight, buoyancy, drag, anchor, place on its body.  SW_FORMAT with its line. */
enum status system_take_node(struct system *p, int i, struct why *why);

/* Rope r from p->type_of[r] and a, b, L0 of its net_rope: weight, drag, friction, law; given:
 * number of elements in its row, -1: none. */
enum status system_take_rope(struct system *p, int r, int given, struct why *why);

/* Body i from p->body[i] and the rest of its net_body. */
enum status system_take_body(struct system *p, int i, struct why *why);

/* The last step: the bed, loads that are left, and whether the net can be solved.  SW_ADMISSIBLE.
 */
enum status system_judge(struct system *p, struct why *why);

/* Something was passed over: words for the user.  SW_NOMEM. */
__attribute__((format(printf, 4, 5))) enum status system_pass(struct system *p, int warns,
                                                              struct why *why, const char *format,
                                                              ...);

/* Names of the keys that --set can set, blanks between. */
void system_name_keys(FILE *f);

#endif
