/*
 * The case file of one cable: sections and keys to the structs of phys, every default filled in,
 * and back (seilwerk-case(5)).
 */
#ifndef SEILWERK_FORM_CABLE_H
#define SEILWERK_FORM_CABLE_H

#include "form/keys.h"
#include "phys/damper.h"
#include "phys/find.h"
#include "phys/march.h"
#include "phys/parametric.h"
#include "sys/opt.h"
#include "sys/out.h"

#define CASE_LARGEST 1e9   /* of lengths, times and most other numbers of a case */
#define CASE_SHORTEST 1e-6 /* unstressed length [m] */
#define MAX_PROBES 99      /* more do not fit on a line */

enum time_start { START_STATIC, START_REST, START_MODE, START_STATE };

/* A number that was not given is NAN, a whole number that was not given -1. */
struct disturbance {
    double time;         /* [s] */
    int mode;            /* from 1, or -1 */
    int node;            /* 1..elements-1, or -1 */
    double amplitude[3]; /* mode: largest nodal displacement, first place; node: three */
    int kind;            /* enum kick */
};

/* Sections that may name a recorded motion or force; the record is read by case_records. */
struct motion_section {
    struct motion motion;
    char file[KEYS_TEXT_BYTES]; /* empty: harmonic */
    struct series record;
};

struct force_section {
    double position; /* theta/L0; 0: all along the cable */
    double value[3]; /* [N], or [N] per unstressed metre */
    double omega, phase;
    char file[KEYS_TEXT_BYTES]; /* empty: value */
    struct series record;
};

struct time_plan {
    double end;                       /* [s], NAN if not given */
    int scheme;                       /* enum scheme */
    double step;                      /* [s], 0: auto */
    double radius, tolerance;         /* of scheme alpha, else NAN */
    char start_text[KEYS_TEXT_BYTES]; /* as written */
    enum time_start start;            /* START_STATE: start_text is the file's name */
    int start_mode;                   /* from 1 */
    double start_amplitude;
    double output_every;      /* [s] */
    double field_every;       /* [s]; NAN: as output_every */
    double probe[MAX_PROBES]; /* fractions of L0, NAN behind the last */
    int n_probes;
};

/* What may be given in place of the unstressed length; NAN or -1 once it is resolved. */
struct known_keys {
    double value[N_GIVEN];
    double fundamental;     /* frequency of the first lateral mode [Hz] */
    int mode, plane, slack; /* of value[GIVEN_FREQUENCY]; plane 0: out, 1: in */
};

#define MAX_STABILITY_MODES 40 /* as many fit on a line */

enum stability_method { METHOD_BOLOTIN, METHOD_FLOQUET };

/* [stability]: the map of parametric resonance. */
struct stability {
    int method;                        /* enum stability_method */
    int theory;                        /* enum theory */
    int quadratic;                     /* 0 or 1 */
    int undamped;                      /* ground motion */
    double modes[MAX_STABILITY_MODES]; /* as written, NAN behind the last */
    int mode[MAX_STABILITY_MODES];     /* from 0 */
    int n_modes;
    int harmonics;
    double ratio_start, ratio_end, ratio_step; /* Omega over twice the reference frequency */
    int reference;                             /* mode, from 1 */
    double amplitude_start, amplitude_end, amplitude_step; /* [m] */
};

/* [sweep]: the frequency of all harmonic motions and forces changes slowly. */
struct sweep_plan {
    struct sweep sweep; /* from NAN: none */
    double seed;        /* the first lateral mode is kept at this amplitude at least [m] */
    int window;         /* periods that make a row */
};

/* [steady]: when a motion counts as steady. */
struct steady_plan {
    double tolerance;
    int periods;
};

struct cable_case {
    struct cable bare;           /* as given, before load and expansion; L0, EA resolved */
    double youngs_modulus, area; /* NAN if axial_stiffness was given */
    struct known_keys known;
    int found; /* whether L0 was found from another quantity */
    struct load load;
    struct cable cable; /* the one that hangs in the plane of its load */
    struct axes axes;   /* of that plane */
    int elements;
    int law;                       /* enum law */
    double alpha, beta;            /* resolved */
    double zeta[2], zeta_omega[2]; /* NAN once resolved */
    struct damper *damper;
    char (*damper_label)[KEYS_LABEL_BYTES];
    int n_dampers;
    struct motion_section *motion_section;
    struct motion *motion;                  /* (n_motions), of these sections */
    char (*motion_label)[KEYS_LABEL_BYTES]; /* section with label */
    int n_motions;
    struct force_section *force_section;
    char (*force_label)[KEYS_LABEL_BYTES];
    int n_forces;
    struct force *force; /* (n_forces), of these sections */
    struct wind wind;    /* cd NAN: none */
    struct time_plan time;
    int terms;
    struct sweep_plan sweep;
    struct steady_plan steady;
    struct stability stability;
    struct disturbance *disturbance;
    char (*disturbance_label)[KEYS_LABEL_BYTES];
    int n_disturbances;
};

/* Whether the case has a [sweep]. */
int case_sweeps(const struct cable_case *c);

/* Read the case at path ("-": stdin), apply the --set assignments, judge and resolve it.
 * SW_FORMAT, SW_USAGE, SW_READ, SW_ADMISSIBLE, SW_NOMEM with file and line in why; *ret then owns
 * nothing. */
enum status case_load(const char *path, const struct opt_list *sets, struct cable_case *ret,
                      struct why *why);

/* The same from an open file. */
enum status case_read(FILE *f, const char *name, const struct opt_list *sets,
                      struct cable_case *ret, struct why *why);

/* The key of a model section ([cable], [supports], [gravity], [load], [mesh]) by its name, with or
 * without "section."; NULL: there is none. */
const struct key *case_model_key(const char *name);

/* Name of the i-th of these keys; NULL behind the last one. */
const char *case_model_name(int i);

/* Whether SECTION.KEY is a key of a case; the section may carry a label where it takes one. */
int case_knows(const char *name);

/* The model sections of *c: all defaults, then those of the --set assignments, which may set no
 * other section.  Not resolved.  SW_USAGE, SW_NOMEM. */
enum status case_model_defaults(const struct opt_list *sets, struct cable_case *c, struct why *why);

/* Read the files that sections of the case at path name, relative to its directory.  SW_READ,
 * SW_FORMAT, SW_NOMEM. */
enum status case_records(struct cable_case *c, const char *path, struct why *why);

/* file, or beside the case at path if it is relative; to be freed; NULL: memory ran out. */
char *case_beside(const char *path, const char *file);

/* The model of c with elements laid on its line.  As model_new. */
enum status case_model(const struct cable_case *c, struct model *ret);

/* Free what *c owns; a zeroed case is fine. */
void case_free(struct cable_case *c);

/* Print the resolved case in the form that case_load reads. */
void case_print(const struct cable_case *c, struct out *o);

/* Whether a and b describe the same model (the sections marked M in seilwerk-case(5)).  Returns
 * NULL, or the name of the first key whose values differ. */
const char *case_model_difference(const struct cable_case *a, const struct cable_case *b);

/* Names of the keys that --set can set, blanks between. */
void case_name_keys(FILE *f);

#endif
