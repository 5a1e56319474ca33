/*
 * What exact statics ask of an arrangement beyond the formulas: hooks, edges of the load that
 * slings may lean on, how far the slings stretch, size of the load.
 */
#ifndef SEILWERK_FORM_DETAIL_H
#define SEILWERK_FORM_DETAIL_H

#include "form/column.h"

/* SI units; NAN: not given. */
struct detail {
    int hooks;                  /* 1 or 2 */
    double hook_distance;       /* of two hooks, across the view of the spreader */
    double spreader_width;      /* of a spreader that carries four slings, across its view */
    int edges;                  /* of the load on each side, from above to below */
    double half[2], height[2];  /* distance from the middle, height above the lifting points */
    double load[3];             /* the load's size lengthwise, crosswise and in height */
    double stretch[2];          /* strain of primary and secondary slings at the present load */
    double base[RIGGING_VIEWS]; /* as given */
};

/*
 * From the numbers of one end, x (LIFT_QUANTITIES), whose suspension is a; end numbers the columns
 * in messages.  Default: one hook, two of elastic slings; slings are rigid; use as it follows from
 * wll and the load, or else 1.  SW_ADMISSIBLE: sizes that are not positive, half of an edge, hooks
 * that the type does not have, two hooks of unknown distance, a strain of 1 or more.
 */
enum status detail_make(const double *x, int end, const struct suspension *a, struct detail *ret,
                        struct why *why);

#endif
