/*
 * An arrangement by exact statics: what the formulas say for small tilts of rigid slings, and what
 * they cannot say.
 */
#ifndef SEILWERK_FORM_EXACT_H
#define SEILWERK_FORM_EXACT_H

#include "form/lift.h"
#include "phys/heel.h"

enum exact_part { EXACT_PRIMARY, EXACT_SECONDARY, EXACT_PARTS };

/* SI units; NAN: has no meaning for the arrangement, or what it needs is not known. */
struct exact {
    /* Offset over tilt of the spreader, or of the load where there is none and in a pair: small
     * tilt, the worst of what was computed, edges not counted; INFINITY: nothing tilts. */
    double h;
    double load;                /* the same over the tilt of the load */
    double view[RIGGING_VIEWS]; /* h of each view that was computed */
    double contact;             /* the least of all when edges count; NAN: there are none */
    int stable;                 /* edges not counted */
    /* Stability measure without edges: the slowest mode's omega^2 [1/s2], < 0 unstable, its period,
     * its shape in words. */
    double omega2, period;
    char mode[48];
    /* At the offset, edges counted. */
    double tilt_spreader, tilt_load;
    int lost;           /* the offset takes stability away: tilts are none */
    double offset_lost; /* offset that does; INFINITY: none up to several bases */
    /* Range of one view from that equilibrium on, edges counted. */
    double capsizing, energy, moment, moment_at;
    enum heel_end end;
    /* Where it comes to rest if it is not stable: tilt of the load. */
    double rest;
    /* In one sling [N], at the offset or where it comes to rest; over its working load limit. */
    double least[EXACT_PARTS], greatest[EXACT_PARTS], use[EXACT_PARTS];
    int by_contact;    /* not stable, but slings on edges hold it within 30 degrees */
    int contacts;      /* edges leant on, at the offset or at rest */
    int slack;         /* slings */
    int indeterminate; /* forces of rigid slings that statics leave open */
};

/* SW_ADMISSIBLE: what exact statics need is not given; SW_NOCONV: no equilibrium was found.  brief:
 * without range, rest, and the offset that would be lost if the given one is not. */
enum status exact_make(const struct lift *l, int brief, struct exact *ret, struct why *why);

/* Whether a verdict must not stand on the formulas alone: there is an offset, whose tilt need not
 * be small, or slings stretch where no formula of the type, or of a pair, counts it. */
int exact_needed(const struct lift *l);

/* Whether slings stretch in that way. */
int exact_stretches(const struct lift *l);

/* The height beside that of the formula: edges count where they make it less; NULL: INFINITY. */
double exact_least(const struct exact *e);

/* "capsizes", "folds", "holds"; of what has no range "". */
const char *exact_end(const struct exact *e);

/* The view whose large tilts are computed: the one of less height, or of the narrower base; -1:
 * none is planar. */
int exact_view(const struct lift *l);

#endif
