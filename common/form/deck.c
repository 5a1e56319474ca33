/* Mooring decks of other codes. */
#include "form/deck.h"

enum status deck_recognize(const char *path, int *ret, struct why *why)
{
    (void)path;
    (void)why;
    *ret = 0;
    return SW_OK;
}

enum status deck_sections(const char *path, struct ini *ret, struct why *why)
{
    (void)ret;
    return fail(why, SW_FORMAT, "%.400s: not yet", path);
}

enum status deck_load(const char *path, struct system *ret, struct why *why)
{
    (void)ret;
    return fail(why, SW_FORMAT, "%.400s: not yet", path);
}

enum status deck_write(const struct system *p, const struct net_state *s, struct out *o,
                       struct why *why)
{
    (void)p;
    (void)s;
    (void)o;
    return fail(why, SW_FORMAT, "not yet");
}
