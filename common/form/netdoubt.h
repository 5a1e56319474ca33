/*
 * What a user of gapnet should know of a system that was solved: warnings, each of them once.
 */
#ifndef SEILWERK_FORM_NETDOUBT_H
#define SEILWERK_FORM_NETDOUBT_H

#include "form/system.h"

/* What was told already, of many solutions of one system. */
struct net_doubt {
    const struct system *p;
    char *told; /* one for each kind and rope, node or body; owned */
};

/* SW_NOMEM. */
enum status net_doubt_new(const struct system *p, struct net_doubt *ret, struct why *why);
void net_doubt_free(struct net_doubt *d);

/* Warn of what is doubtful in the state s and was not told before; place: words in front of it,
 * such as "moves.csv:3: ". */
void net_doubt_tell(struct net_doubt *d, const struct net_state *s, const char *place);

#endif
