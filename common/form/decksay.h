/*
 * What a mooring deck can say of a system, and how.  Private to form/deck*.c.
 */
#ifndef SEILWERK_FORM_DECKSAY_H
#define SEILWERK_FORM_DECKSAY_H

#include "form/system.h"

/* SW_ADMISSIBLE with the name of what no deck can say. */
enum status say_judge(const struct system *p, struct why *why);

/* The number of body b in the deck; 0: it is the vessel, whose points are coupled ones. */
int say_body_number(const struct system *p, int b);

/* Its place, and roll, pitch, yaw [deg]. */
void say_body_place(const struct system *p, const struct net_state *s, int b, double x[3],
                    double angle[3]);

/* Mass and volume of node i that stand for its vertical load, too. */
void say_load(const struct system *p, int i, double *ret_mass, double *ret_volume);

/* The depth; without a bed, one below all that was found. */
double say_depth(const struct system *p, const struct net_state *s);

/* The one coefficient of friction of all ropes; NAN: they differ. */
double say_friction(const struct system *p);

#endif
