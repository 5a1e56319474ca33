/*
 * Tensions that are wanted of ropes (gapnet(1), --pretension).
 */
#ifndef SEILWERK_FORM_NETTARGET_H
#define SEILWERK_FORM_NETTARGET_H

#include "form/system.h"

/* ROPE=TENSION: a tension that is wanted at the end that is no anchor, by the rope's length or by
 * the place of its anchor.  SW_USAGE. */
enum status net_take_target(const struct system *p, const char *text, int by_anchor,
                            struct net_target *ret, struct why *why);

/* Words for tensions that no length or anchor gave, in the state that came nearest: SW_NOCONV with
 * the one that is farthest off. */
enum status net_explain_targets(const struct system *p, const struct net_state *s,
                                const struct net_target *target, int k, struct why *why);

#endif
