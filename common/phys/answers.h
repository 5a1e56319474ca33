/*
 * What a designer asks of a map: the smallest dangerous amplitude of each region, and the damping
 * with which a given amplitude is safe.
 */
#ifndef SEILWERK_PHYS_ANSWERS_H
#define SEILWERK_PHYS_ANSWERS_H

#include "phys/map.h"

#define MAP_MOST_REGIONS 64

/* A region: boundaries of one period that one mode dominates by one harmonic. */
struct map_answer {
    struct map_row row; /* its lowest point */
    double factor; /* by which all damping must grow so that the lowest point lies at the task's
                      largest amplitude; NAN: no damping, or none up to 1e4 times */
};

/*
 * The regions below the task's largest amplitude on count ratios from first on, step apart, lowest
 * points refined between them to the square root of round-off; the lowest region first.
 * SW_NOMEM, SW_NOCONV, SW_INDEFINITE.
 */
enum status map_answers(const struct map *m, const struct map_task *t, double first, double step,
                        long count, int threads, struct map_answer *ret, int *ret_n);

#endif
