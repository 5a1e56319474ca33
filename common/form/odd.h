/*
 * Numbers that are admissible, but seldom meant: most come from a wrong unit.
 */
#ifndef SEILWERK_FORM_ODD_H
#define SEILWERK_FORM_ODD_H

/* Mean density of a rope [kg/m3]: lighter than polymers and wood, heavier than any metal. */
static inline int odd_density(double density)
{
    return density < 500 || density > 30000;
}

#endif
