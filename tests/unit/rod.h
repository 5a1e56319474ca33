/*
 * What the tests of wires share: chains of curved elements along a given curve, and their solution.
 */
#ifndef SEILWERK_TESTS_ROD_H
#define SEILWERK_TESTS_ROD_H

#include "check.h"

#include "num/mem.h"
#include "num/vec3.h"
#include "phys/follow.h"

#include <string.h>

/* A curve from u = 0 to 1: its point and its section frame (rows x, y, tangent). */
typedef void (*rod_curve)(double u, double x[3], double A[9]);

struct rod {
    struct frame f;
    struct frame_state s;
    struct frame_work w;
    struct follow_path path;
    struct section section;
};

/* EA, EIx, EIy, GIt; mass per length 1. */
static inline struct section rod_section(double EA, double EIx, double EIy, double GIt)
{
    struct section s = {
        .shape = SECTION_VALUES, .E = 1, .G = 1, .area = EA, .Ixx = EIx, .Iyy = EIy, .It = GIt};

    assert_int_equal(section_complete(&s, 0), SW_OK);
    s.mass = 1;
    return s;
}

/* n elements, node 0 clamped, one stage, room for 16 loads.  Ends are seen from within: there may
 * be corners. */
static inline void rod_new(struct rod *p, int n, struct section section, rod_curve curve)
{
    *p = (struct rod){.section = section};
    p->f = (struct frame){.n = n + 1,
                          .beams = n,
                          .stages = 1,
                          .node = mem_zeroed((size_t)n + 1, sizeof *p->f.node),
                          .beam = mem_zeroed((size_t)n, sizeof *p->f.beam),
                          .load = mem_zeroed(16, sizeof *p->f.load)};
    assert_non_null(p->f.node);
    assert_non_null(p->f.beam);
    assert_non_null(p->f.load);
    p->f.node[0].held = 63;
    for (int i = 0; i <= n; i++) {
        double A[9];

        curve(i / (double)n, p->f.node[i].x, A);
    }
    for (int i = 0; i < n; i++) {
        struct frame_beam *b = &p->f.beam[i];
        struct bow bow;
        double x[3];

        b->a = i;
        b->b = i + 1;
        b->section = &p->section;
        curve(i / (double)n, x, b->A[0]);
        curve((i + 1) / (double)n * (1 - 1e-15), x, b->A[1]);
        below(bow_between(p->f.node[i].x, p->f.node[i + 1].x, b->A[0], b->A[1], 0, 0, &bow),
              PI / 2);
        assert_int_equal(beam_new(&bow, &p->section, &b->beam), SW_OK);
    }
}

static inline void rod_load(struct rod *p, int node, int stage, const double value[6])
{
    struct frame_load *l = &p->f.load[p->f.loads++];

    l->node = node;
    l->beam = -1;
    l->stage = stage;
    memcpy(l->value, value, sizeof l->value);
}

/* Prescribed displacement of one direction of a node. */
static inline void rod_hold(struct rod *p, int node, int direction, int stage, double value)
{
    p->f.node[node].held |= 1 << direction;
    p->f.node[node].given[direction] = value;
    p->f.node[node].stage[direction] = stage;
}

static inline struct follow_options rod_options(int parts)
{
    return (struct follow_options){
        .tolerance = 1e-10, .parts = parts, .steps = 1000, .iterations = 20, .watch = -1};
}

static inline void rod_begin(struct rod *p)
{
    assert_int_equal(frame_state_new(&p->f, &p->s), SW_OK);
    assert_int_equal(frame_work_new(&p->f, &p->w), SW_OK);
}

static inline enum status rod_follow(struct rod *p, const struct follow_options *o)
{
    rod_begin(p);
    return follow(&p->f, o, &p->s, &p->w, &p->path);
}

static inline void rod_solve(struct rod *p, int parts)
{
    struct follow_options o = rod_options(parts);

    assert_int_equal(rod_follow(p, &o), SW_OK);
}

static inline void rod_linear(struct rod *p)
{
    int failed;

    rod_begin(p);
    assert_int_equal(follow_linear(&p->f, &p->s, &p->w, &failed), SW_OK);
}

/* Displacement c of a node. */
static inline double rod_moved(const struct rod *p, int node, int c)
{
    return c < 3 ? p->s.x[3 * node + c] - p->f.node[node].x[c] + p->s.low[3 * node + c]
                 : p->s.turn[3 * node + c - 3];
}

static inline void rod_free(struct rod *p)
{
    follow_path_free(&p->path);
    frame_work_free(&p->w);
    frame_state_free(&p->s);
    free(p->f.node);
    free(p->f.beam);
    free(p->f.load);
}

#endif
