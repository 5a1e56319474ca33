/*
 * The proof of a solution of gapnet, from its tables alone: nodes and joints in balance, ropes that
 * reach from node to node by the law of their material, a bed that pulls at none of them.
 *
 * It shares no code with the solver but the reading of tables: element by element, continuous ropes
 * by adaptive quadrature of (1/T + 1/EA) t ds.
 */
#ifndef SEILWERK_FORM_NETPROOF_H
#define SEILWERK_FORM_NETPROOF_H

#include "sys/err.h"

#define PROOF_NAME 64

struct net_proof {
    double tension, size; /* largest tension [N], extent of all points [m] */
    double force;         /* what residuals are compared with: the largest tension, but no less than
                             its softest rope at a strain of 1e-5 and 1e-5 of a node's load [N] */
    double unbalance;     /* largest of the nodes over that force */
    double joint;         /* the same of the joints, and of ends against the table of ropes */
    double gap;           /* largest distance of a point from where its rope puts it, over size */
    double bed;           /* largest pull of the bed, which can only push, over that force */
    char node[PROOF_NAME], rope[PROOF_NAME], gap_rope[PROOF_NAME],
        bed_rope[PROOF_NAME]; /* the worst ones */
    int nodes, ropes, points;
};

/* Read nodes.csv, ropes.csv and shapes.csv in dir.  SW_READ, SW_FORMAT, SW_NOMEM. */
enum status net_prove(const char *dir, struct net_proof *ret, struct why *why);

#endif
