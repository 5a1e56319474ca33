/*
 * Rigid bodies of a system of ropes: their table, moves, restoring curves (gapnet(1)).
 */
#ifndef SEILWERK_FORM_NETBODIES_H
#define SEILWERK_FORM_NETBODIES_H

#include "form/system.h"
#include "sys/out.h"

/* Place, attitude and forces of all bodies about their origins. */
void net_print_bodies(const struct system *p, const struct net_state *s, struct out *o);

/* The body that is moved or stiff: by name, or the only one that is held (name NULL).  SW_USAGE. */
enum status net_choose_body(const struct system *p, const char *name, int *ret, struct why *why);

/* ROPE=TENSION: a tension that is wanted at the end that is no anchor, by the rope's length or by
 * the place of its anchor.  SW_USAGE. */
enum status net_take_target(const struct system *p, const char *text, int by_anchor,
                            struct net_target *ret, struct why *why);

/* Body moved by a displacement [m] and a rotation vector [rad] from the place that `from` has. */
void net_move_body(struct system *p, int body, const struct net_body *from, const double move[6]);

/* The restoring curve: for each row of moves at path ("-": standard input) the forces of the ropes
 * on the body about its origin, and the largest tension.  A row that is not solved has empty cells;
 * *ret_failed counts them.  SW_READ, SW_FORMAT, SW_NOMEM. */
enum status net_print_curve(struct system *p, const struct net_options *solver, int body,
                            const char *path, struct out *o, int *ret_failed, struct why *why);

#endif
