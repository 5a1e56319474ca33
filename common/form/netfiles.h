/*
 * Results of gapnet: tables of nodes, ropes, shapes, history and the summary (gapnet(1)).
 */
#ifndef SEILWERK_FORM_NETFILES_H
#define SEILWERK_FORM_NETFILES_H

#include "form/system.h"
#include "sys/out.h"

/* Words for the summary. */
struct net_report {
    const char *method;
    enum status status;
    double difference; /* of --verify [m], NAN: not asked for */
};

void net_print_ropes(const struct system *p, const struct net_state *s, struct out *o);

/* SW_NOMEM. */
enum status net_print_nodes(const struct system *p, const struct net_state *s, struct out *o,
                            struct why *why);
enum status net_print_shapes(const struct system *p, const struct net_state *s, struct out *o,
                             struct why *why);

void net_print_history(const struct net_state *s, struct out *o);
void net_print_summary(const struct system *p, const struct net_state *s,
                       const struct net_report *r, struct out *o);

/* All of them to the directory dir, which is made; whole or not at all, each.  SW_WRITE, SW_NOMEM.
 */
enum status net_write(const char *dir, const struct system *p, const struct net_state *s,
                      const struct net_report *r, struct why *why);

/* Stiffness K (3 k, 3 k) of chosen nodes as CSV: rows and columns node.x and so on. */
void net_print_stiffness(const struct system *p, const int *chosen, int k, const double *K,
                         struct out *o);

/* Of a rigid body: (6, 6). */
void net_print_body(const double K[36], struct out *o);

/* The same to dir/stiffness.csv and dir/stiffness.npy.  SW_WRITE. */
enum status net_write_stiffness(const char *dir, const struct system *p, const int *chosen, int k,
                                int body, const double *K, struct why *why);

/* Largest residual of a free node over the largest tension, and the node (-1: none). */
double net_unbalance(const struct system *p, const struct net_state *s, int *ret_node);

#endif
