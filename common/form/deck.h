/*
 * Mooring decks of other codes: MoorDyn v2 and v1, MoorPy, MAP++ (seilwerk-deck(5)).
 */
#ifndef SEILWERK_FORM_DECK_H
#define SEILWERK_FORM_DECK_H

#include "form/system.h"
#include "sys/out.h"

/* Whether the file is a deck and no INI file: some line of it opens a section of a deck before any
 * stands in brackets.  SW_READ. */
enum status deck_recognize(const char *path, int *ret, struct why *why);

/* What the deck's options say, as entries of a case file.  SW_FORMAT, SW_READ, SW_NOMEM. */
enum status deck_sections(const char *path, struct ini *ret, struct why *why);

/* The system in the deck at path, up to system_judge; ret is begun.  Same failures. */
enum status deck_load(const char *path, struct system *ret, struct why *why);

/* Write a MoorDyn v2 deck with the positions that were found.  SW_ADMISSIBLE with words for what no
 * deck can say (springs, floats with a waterplane, ...); nothing is written then. */
enum status deck_write(const struct system *p, const struct net_state *s, struct out *o,
                       struct why *why);

#endif
