/*
 * The unstressed length of a cable of which something else is known: a force, its sag, or a
 * measured frequency.
 */
#ifndef SEILWERK_PHYS_FIND_H
#define SEILWERK_PHYS_FIND_H

#include "phys/load.h"
#include "phys/model.h"

enum given {
    GIVEN_HORIZONTAL, /* component of the left end's tension along axis 1 [N] */
    GIVEN_MIDSPAN,    /* tension at half of the unstressed length [N] */
    GIVEN_LEFT,       /* tension at the left end [N] */
    GIVEN_RIGHT,      /* tension at the right end [N] */
    GIVEN_SAG,        /* below the chord, along axis 2, at half of the unstressed length [m] */
    GIVEN_FREQUENCY,  /* of one mode of the finite element model [Hz] */
    N_GIVEN
};

/* What is known.  The last four tell the mode of GIVEN_FREQUENCY. */
struct known {
    enum given given;
    double value; /* > 0 */
    int slack;    /* the slacker of two cables that have it, else the tauter one */
    enum part part;
    int mode; /* from 1, counted within the part */
    enum law law;
    int elements;
};

/* Sag along axis 2 at theta of a line that hangs in the plane of axes; its supports differ by span
 * and drop in space. */
double find_sag(const struct line *s, const struct axes *axes, double theta);

/*
 * *ret = unstressed length (before expansion) with which the cable c, its L0 ignored, has what is
 * known under the load; solved to round-off.  SW_INFEASIBLE: there is none; *ret_least is then the
 * least value that any length gives, NAN where only the slacker of two cables is missing, INFINITY
 * where a thousandfold stretch does not give so much.
 * SW_NOMEM, SW_ADMISSIBLE: the cable itself is not admissible for any length.
 */
enum status find_length(const struct cable *c, const struct load *load, const struct known *k,
                        double *ret, double *ret_least);

#endif
