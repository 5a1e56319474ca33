/*
 * From the records of a mooring deck to a system, one function a section (seilwerk-deck(5)).
 * Private to form/deck*.c.
 */
#ifndef SEILWERK_FORM_DECKPARTS_H
#define SEILWERK_FORM_DECKPARTS_H

#include "form/decktext.h"
#include "form/system.h"

#define DECK_BIG 1e9 /* m, kg/m: the largest of what a record may say */
#define DECK_COPIES 100

/* Of what a point or an end of a rod is part. */
enum deck_hold { DECK_FREE, DECK_FIXED, DECK_COUPLED, DECK_BODY, DECK_TURBINE, DECK_PINNED };

struct deck_place {
    enum deck_hold hold;
    char number[16]; /* of a body or turbine */
};

/* The word of a column Attachment.  Returns 0 where it is not known. */
int deck_place(const char *word, struct deck_place *ret);

/* What the options say beside the keys of a case. */
struct deck_options {
    int copies;                /* of all nodes and lines: repeat of MAP++ */
    double angle[DECK_COPIES]; /* [deg], seen from above, clockwise */
};

/* SW_FORMAT. */
enum status deck_take_options(const struct deck *d, struct deck_options *ret, struct why *why);

/* Options that change results and are passed over: words for the user.  SW_NOMEM. */
enum status deck_pass_options(const struct deck *d, struct system *p, struct why *why);

/* Names, with room for their numbers; then the numbers.  SW_FORMAT, SW_READ, SW_NOMEM. */
enum status deck_name_types(const struct deck *d, struct system *p, struct why *why);
enum status deck_take_types(const struct deck *d, struct system *p, struct why *why);

/* Bodies: the vessel that carries all coupled points, those of the deck, turbines. */
enum status deck_name_bodies(const struct deck *d, struct system *p, struct why *why);
enum status deck_take_bodies(const struct deck *d, struct system *p, struct why *why);

/* Nodes: points, copies of them, ends of rods. */
enum status deck_name_nodes(const struct deck *d, const struct deck_options *o, struct system *p,
                            struct why *why);
enum status deck_take_points(const struct deck *d, const struct deck_options *o, struct system *p,
                             struct why *why);
enum status deck_take_rods(const struct deck *d, struct system *p, struct why *why);

/* Lines and copies of them. */
enum status deck_name_lines(const struct deck *d, const struct deck_options *o, struct system *p,
                            struct why *why);
enum status deck_take_lines(const struct deck *d, const struct deck_options *o, struct system *p,
                            struct why *why);

/* Put node i on what holds it; place is where the record of row says.  SW_FORMAT. */
enum status deck_hold(const struct deck *d, int row, const struct deck_place *place,
                      struct system *p, int i, struct why *why);

#endif
