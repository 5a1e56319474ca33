/*
 * The case file of one cable: sections and keys to the structs of phys, every default filled in,
 * and back (seilwerk-case(5)).
 */
#ifndef SEILWERK_FORM_CABLE_H
#define SEILWERK_FORM_CABLE_H

#include "form/keys.h"
#include "phys/march.h"
#include "sys/opt.h"
#include "sys/out.h"

#define CASE_LARGEST 1e9 /* of lengths, times and most other numbers of a case */
#define MAX_PROBES 99    /* more do not fit on a line */

enum time_start { START_STATIC, START_REST, START_MODE };

/* A number that was not given is NAN, a whole number that was not given -1. */
struct disturbance {
    double time;         /* [s] */
    int mode;            /* from 1, or -1 */
    int node;            /* 1..elements-1, or -1 */
    double amplitude[3]; /* mode: largest nodal displacement, first place; node: three */
    int kind;            /* enum kick */
};

struct time_plan {
    double end;                       /* [s], NAN if not given */
    int scheme;                       /* 0: central differences */
    double step;                      /* [s], 0: auto */
    char start_text[KEYS_TEXT_BYTES]; /* as written */
    enum time_start start;
    int start_mode; /* from 1 */
    double start_amplitude;
    double output_every;      /* [s] */
    double probe[MAX_PROBES]; /* fractions of L0, NAN behind the last */
    int n_probes;
};

struct cable_case {
    struct cable cable;          /* EA resolved */
    double youngs_modulus, area; /* NAN if axial_stiffness was given */
    int elements;
    int law;                       /* enum law */
    double alpha, beta;            /* resolved */
    double zeta[2], zeta_omega[2]; /* NAN once resolved */
    struct motion *motion;
    char (*motion_label)[KEYS_TEXT_BYTES]; /* section with label */
    int n_motions;
    struct time_plan time;
    int terms;
    struct disturbance *disturbance;
    char (*disturbance_label)[KEYS_TEXT_BYTES];
    int n_disturbances;
};

/* Read the case at path ("-": stdin), apply the --set assignments, judge and resolve it.
 * SW_FORMAT, SW_USAGE, SW_READ, SW_ADMISSIBLE, SW_NOMEM with file and line in why; *ret then owns
 * nothing. */
enum status case_load(const char *path, const struct opt_list *sets, struct cable_case *ret,
                      struct why *why);

/* The same from an open file. */
enum status case_read(FILE *f, const char *name, const struct opt_list *sets,
                      struct cable_case *ret, struct why *why);

/* Free what *c owns; a zeroed case is fine. */
void case_free(struct cable_case *c);

/* Print the resolved case in the form that case_load reads. */
void case_print(const struct cable_case *c, struct out *o);

/* Whether a and b describe the same model (the sections marked M in seilwerk-case(5)).  Returns
 * NULL, or the name of the first key whose values differ. */
const char *case_model_difference(const struct cable_case *a, const struct cable_case *b);

#endif
