/*
 * Columns of sling, and the numbers of an arrangement that stand in them.
 *
 * Each quantity of struct rigging is a column named with its unit (v_m, phi_deg, m_load_t, wll_kN);
 * in a pair with the suffix _1 or _2 before the unit (v_1_m; behind it is understood, too), or
 * without one for both ends.  NAME_tol is a tolerance, plus or minus, in the same unit.
 */
#ifndef SEILWERK_FORM_COLUMN_H
#define SEILWERK_FORM_COLUMN_H

#include "phys/rigging.h"
#include "sys/err.h"

#include <stdio.h>

/* Quantities of struct rigging and struct detail, in the order of struct lift_given. */
enum lift_quantity {
    LIFT_V,
    LIFT_S,
    LIFT_Z,
    LIFT_PHI,
    LIFT_GAMMA,
    LIFT_SPREADER,
    LIFT_LOAD,
    LIFT_SLING,
    LIFT_LONG,
    LIFT_CROSS,
    LIFT_STRAIN,
    LIFT_USE,
    LIFT_WLL,
    LIFT_WLL_SECONDARY,
    LIFT_SLINGS,
    LIFT_STABILIZED,
    LIFT_STRAIN_SECONDARY, /* from here on for exact statics only, struct detail */
    LIFT_HOOKS,
    LIFT_HOOK_DISTANCE,
    LIFT_SPREADER_WIDTH,
    LIFT_EDGE_WIDTH,
    LIFT_EDGE_HEIGHT,
    LIFT_LOW_EDGE_WIDTH,
    LIFT_LOW_EDGE_HEIGHT,
    LIFT_LOAD_LONG,
    LIFT_LOAD_CROSS,
    LIFT_LOAD_HEIGHT,
    LIFT_QUANTITIES
};

#define LIFT_ENDS 3 /* the whole, end 1, end 2 */
#define LIFT_E1 (LIFT_QUANTITIES * LIFT_ENDS)
#define LIFT_E2 (LIFT_E1 + 1)
#define LIFT_OFFSET (LIFT_E1 + 2)
#define LIFT_NUMBERS (LIFT_E1 + 3)

#define LIFT_UNKNOWN -1 /* type that is not given */
#define LIFT_PAIR 4     /* type of the whole beside those of enum rigging_type */

/* Which x of end 1 or 2, 0: of the whole. */
#define LIFT_AT(quantity, end) ((quantity)*LIFT_ENDS + (end))

/* Index in x of the column called name, with *ret_tolerance set if it is one's tolerance; -1, also
 * for the tolerance of a number that may have none. */
int lift_column(const char *name, int *ret_tolerance);

/* Name of x[i]; at most LIFT_NAME bytes with the NUL.  SI units in one of the column's. */
#define LIFT_NAME 32
void lift_name(int i, char ret[LIFT_NAME]);
double lift_unit(int i);

/* Whether heights may depend on x[i]; whether it may have a tolerance. */
int lift_is_input(int i);
int lift_may_vary(int i);

/* Name of a quantity without end and unit. */
const char *lift_stem(int quantity);

/* The column that name nearly is, in ret, or NULL: the same but for case and unit, or one letter
 * wrong in a name of some length. */
const char *lift_nearly(const char *name, char ret[LIFT_NAME]);

/* Word of a type, and the type of a word; SW_FORMAT. */
const char *lift_type_name(int type);
enum status lift_type_read(const char *text, int *ret, struct why *why);

/* Names of the columns without those of single ends, blanks between. */
void lift_name_columns(FILE *f);

#endif
