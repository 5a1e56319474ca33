/* Mooring decks written. */
#include "form/deck.h"

enum status deck_write(const struct system *p, const struct net_state *s, struct out *o,
                       struct why *why)
{
    (void)p;
    (void)s;
    (void)o;
    return fail(why, SW_FORMAT, "not yet");
}
