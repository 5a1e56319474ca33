/*
 * Numbers that are admissible, but seldom meant: most come from a wrong unit.
 */
#ifndef SEILWERK_FORM_UNITS_H
#define SEILWERK_FORM_UNITS_H

/* Of cables and wires [kg/m3]: from ropes of fibres, air between them, or `least`, to tungsten and
 * gold with a reserve. */
#define UNITS_LIGHT 500
static inline int units_doubt_density(double density, double least)
{
    return density < least || density > 30000;
}

/* Strains [1] from here on belong to no rope or wire that is whole. */
#define UNITS_STRAIN 0.05

#endif
