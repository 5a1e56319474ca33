/*
 * What the tests of systems of ropes share: parts in few words, a solution that must be there.
 */
#ifndef SEILWERK_TESTS_NETS_H
#define SEILWERK_TESTS_NETS_H

#include "check.h"
#include "phys/net.h"

static const struct net_options exact = {.tolerance = 5e-10, .steps = 1000, .split = 100};

static inline struct net_rope rope(int a, int b, double L0, double EA, double weight, int elements)
{
    return (struct net_rope){
        .a = a,
        .b = b,
        .rope = {.law = {.EA = EA}, .L0 = L0, .q = {0, 0, -weight}, .elements = elements}};
}

static inline struct net_node at(double x, double y, double z)
{
    return (struct net_node){.held = 7, .x = {x, y, z}};
}

static inline struct net_node loose(double fx, double fy, double fz)
{
    return (struct net_node){.x = {NAN, NAN, NAN}, .force = {fx, fy, fz}};
}

static inline struct net_state solve(struct net *net, const struct net_options *o)
{
    struct net_state s;

    assert_int_equal(net_solve(net, o, &s), SW_OK);
    return s;
}

static inline double size(const double t[3])
{
    return hypot(hypot(t[0], t[1]), t[2]);
}

#endif
