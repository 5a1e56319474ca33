/*
 * Steady states found while a cable moves: periods of the excitation are compared, in blocks of
 * several.
 *
 * At the end of a block, with A_c the largest half span that component c has over all nodes in it,
 * and R_m,c the largest change of c at any node since m periods ago, there and a quarter of a
 * period earlier (a motion at a fraction of the frequency may happen to pass through zero at one of
 * them), the motion is periodic if, for each component,
 *
 *     |A_c - A_c before| <= tolerance A_c     and     R_m,c <= tolerance A_c,
 *
 * for some m up to STEADY_MOST_PERIODS, and no R_m,c grows above round-off: an instability that is
 * still hidden under the rest is waited for.  A component that dies, below tolerance times the
 * largest one, may do so.  Decayed: all of it has fallen below tolerance times what it once was.
 */
#ifndef SEILWERK_PHYS_STEADY_H
#define SEILWERK_PHYS_STEADY_H

#include "phys/model.h"
#include "phys/orbit.h"

#define STEADY_SAMPLES 50     /* a period */
#define STEADY_MOST_PERIODS 8 /* m */

enum steady_kind {
    STEADY_NONE,     /* no steady state so far */
    STEADY_PERIODIC, /* 1:m */
    STEADY_QUASI,    /* bounds stand still, but no period is found: told at the end only */
    STEADY_DECAYED
};

struct steady_options {
    double tolerance;
    int periods;  /* of the excitation, in a block; >= 2 */
    double begin; /* not before this time [s]: ramps, disturbances */
    int n_probes;
    const double *probe; /* fractions of L0; not owned */
};

struct steady {
    const struct model *model; /* not owned */
    struct steady_options options;
    long samples;                         /* so far */
    long blocks;                          /* so far */
    double *least, *greatest;             /* (n + 1, 3) of this block; owned */
    double *strobe;                       /* (STEADY_MOST_PERIODS + 1, 2, 3 (n + 1)) ring; owned */
    struct orbit_window *window;          /* (n_probes); owned */
    struct orbit *orbit;                  /* (n_probes) of the last whole block; owned */
    double amplitude[3], before[3], peak; /* A_c of the last two blocks; largest of all */
    double change[STEADY_MOST_PERIODS + 1][3]; /* R_m,c of the last block */
    double *history;                           /* (room, 3) A_c of all blocks; owned */
    long room;
    int judged; /* whether a block has been */
    enum steady_kind kind;
    int period;    /* m of STEADY_PERIODIC */
    double moving; /* largest relative change of the last block: of amplitudes and by R_m; else
                    * infinite */
};

/* SW_NOMEM. */
enum status steady_new(const struct model *m, const struct steady_options *o, struct steady *ret);

void steady_free(struct steady *s);

/* The displacements V over all nodes at time t [s] and phase phi of the excitation, equal steps of
 * 1/STEADY_SAMPLES of its period, the first one a step behind the start.  *ret_done: a steady state
 * is found.  SW_NOMEM. */
enum status steady_add(struct steady *s, double t, double phi, const double *V, int *ret_done);

/* No more samples: quasi-periodic or none where nothing was found. */
void steady_end(struct steady *s);

/* "periodic", ... for tables. */
const char *steady_kind_name(enum steady_kind kind);

#endif
