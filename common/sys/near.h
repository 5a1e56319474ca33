/*
 * Names that are nearly right: which one is meant?
 */
#ifndef SEILWERK_SYS_NEAR_H
#define SEILWERK_SYS_NEAR_H

/* Whether a and b are equal but for one letter put in, left out or changed. */
int near_word(const char *a, const char *b);

#endif
