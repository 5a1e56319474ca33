/* Rigid bodies that carry nodes: places, forces, stiffness, balance. */
#include "num/dense.h"
#include "num/mem.h"
#include "num/vec3.h"
#include "phys/attitude.h"
#include "phys/network.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STEPS 200    /* of the bodies */
#define FAR 0.2      /* of the size, and radians: the longest step */
#define TRIALS 12    /* of a step's length */
#define LITTLE 1e-9  /* of the stiffness: for what nothing holds, a turn about a single rope */
#define GAIN 0.03    /* of what a step should take off, at the least */
#define PART 0.02    /* of a step: one that must be cut shorter leads nowhere */
#define DAMPING 1e-3 /* of the stiffness, where a step did not help */

void net_place_body(struct net *net, int body)
{
    const struct net_body *p = &net->body[body];

    for (int i = 0; i < net->n; i++)
        if (net->node[i].body == body + 1) {
            mat3_apply(p->R, net->node[i].arm, net->node[i].x);
            for (int c = 0; c < 3; c++)
                net->node[i].x[c] += p->x[c];
        }
}

/* wrench += the force f at r from its point. */
static void add_force(const double r[3], const double f[3], double wrench[6])
{
    double m[3];

    vec3_cross(r, f, m);
    for (int i = 0; i < 3; i++) {
        wrench[i] += f[i];
        wrench[3 + i] += m[i];
    }
}

/* Weight and buoyancy at the body's centres: arms from its origin in space, upward forces. */
static void own_forces(const struct net_body *p, double arm[2][3], double up[2])
{
    mat3_apply(p->R, p->cg, arm[0]);
    mat3_apply(p->R, p->cb, arm[1]);
    up[0] = -p->weight;
    up[1] = fmax(0, p->lift + p->area * (p->level - p->x[2] - arm[1][2]));
}

void net_body_forces(const struct net *net, const struct net_state *s, int body,
                     const double about[3], double lines[6], double own[6])
{
    const struct net_body *p = &net->body[body];
    double arm[2][3], up[2], r[3];

    for (int j = 0; j < 6; j++)
        lines[j] = own[j] = 0;
    for (int i = 0; i < net->n; i++)
        if (net->node[i].body == body + 1) {
            for (int c = 0; c < 3; c++)
                r[c] = s->x[3 * i + c] - about[c];
            add_force(r, s->residual + 3 * i, lines);
        }
    own_forces(p, arm, up);
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 3; c++)
            r[c] = p->x[c] + arm[k][c] - about[c];
        add_force(r, (const double[]){0, 0, up[k]}, own);
    }
}

/* Bodies whose stiffness is asked for: each a set of nodes and a point to turn about. */
struct group {
    int *node, *of; /* (k) nodes, group of each */
    int k;
    double (*about)[3];
    int n;
};

/* Displacement of a point at r for the j-th freedom: along x, y, z, about x, y, z. */
static void follow(int j, const double r[3], double ret[3])
{
    const double unit[3] = {j % 3 == 0, j % 3 == 1, j % 3 == 2};

    if (j < 3)
        memcpy(ret, unit, sizeof unit);
    else
        vec3_cross(unit, r, ret);
}

/* Of row i and column j in n columns of n. */
static size_t place(int n, int i, int j)
{
    return (size_t)i + (size_t)n * (size_t)j;
}

/* A force f on the body at r turns its lever with it: moment needed for a rotation. */
static void turn_lever(const double r[3], const double f[3], double *K, int n, int at)
{
    double dot = f[0] * r[0] + f[1] * r[1] + f[2] * r[2];

    for (int c = 0; c < 3; c++)
        for (int d = 0; d < 3; d++)
            K[place(n, at + 3 + c, at + 3 + d)] += (c == d ? dot : 0) - r[c] * f[d];
}

/* K (6 n, 6 n), column-major: force and moment that displacements and rotations of the groups need,
 * all other nodes following. */
static enum status group_stiffness(const struct net *net, const struct net_state *s,
                                   const struct group *g, double *K)
{
    size_t m = 3 * (size_t)g->k;
    int n = 6 * g->n;
    double *nodes = mem_doubles(m * m), *move = mem_doubles(6 * m);
    enum status status = nodes && move ? net_stiffness(net, s, g->node, g->k, nodes) : SW_NOMEM;

    memset(K, 0, (size_t)n * (size_t)n * sizeof *K);
    for (int i = 0; i < g->k && status == SW_OK; i++) {
        double r[3];

        for (int c = 0; c < 3; c++)
            r[c] = s->x[3 * g->node[i] + c] - g->about[g->of[i]][c];
        for (int j = 0; j < 6; j++)
            follow(j, r, move + m * (size_t)j + 3 * i);
        turn_lever(r, s->residual + 3 * g->node[i], K, n, 6 * g->of[i]);
    }
    for (int a = 0; a < 6 && status == SW_OK; a++)
        for (int b = 0; b < 6; b++)
            for (size_t i = 0; i < m; i++)
                for (size_t j = 0; j < m; j++)
                    K[place(n, 6 * g->of[i / 3] + a, 6 * g->of[j / 3] + b)] +=
                        move[m * (size_t)a + i] * nodes[i + m * j] * move[m * (size_t)b + j];
    free(nodes);
    free(move);
    return status;
}

/* Weight and buoyancy of a body that turns about its origin. */
static void add_own_stiffness(const struct net_body *p, double *K, int n, int at)
{
    double arm[2][3], up[2];

    own_forces(p, arm, up);
    for (int k = 0; k < 2; k++)
        turn_lever(arm[k], (const double[]){0, 0, up[k]}, K, n, at);
    if (up[1] > 0) {
        const double rise[6] = {0, 0, 1, arm[1][1], -arm[1][0], 0};

        for (int a = 0; a < 6; a++)
            for (int b = 0; b < 6; b++)
                K[place(n, at + a, at + b)] += p->area * rise[a] * rise[b];
    }
}

static enum status group_new(const struct net *net, struct group *g)
{
    *g = (struct group){.node = mem_zeroed((size_t)net->n, sizeof(int)),
                        .of = mem_zeroed((size_t)net->n, sizeof(int)),
                        .about = mem_zeroed((size_t)net->bodies + 1, sizeof *g->about)};
    return g->node && g->of && g->about ? SW_OK : SW_NOMEM;
}

static void group_free(struct group *g)
{
    free(g->node);
    free(g->of);
    free(g->about);
}

/* The nodes of a body as one more group, about its origin. */
static void group_add(const struct net *net, int body, struct group *g)
{
    for (int i = 0; i < net->n; i++)
        if (net->node[i].body == body + 1) {
            g->of[g->k] = g->n;
            g->node[g->k++] = i;
        }
    memcpy(g->about[g->n++], net->body[body].x, sizeof *g->about);
}

/* K (n, n) to its first 6 x 6, the rest moving freely. */
static enum status condense(int n, const double *K, double ret[36])
{
    int m = n - 6;
    double *A = mem_doubles((size_t)m * (size_t)m + 1), *B = mem_doubles((size_t)m * 6 + 1);
    enum status s = A && B ? SW_OK : SW_NOMEM;

    for (int i = 0; i < m && s == SW_OK; i++) {
        for (int j = 0; j < m; j++)
            A[i + m * j] = K[6 + i + n * (6 + j)];
        for (int j = 0; j < 6; j++)
            B[i + m * j] = K[6 + i + n * j];
    }
    if (s == SW_OK && m > 0)
        s = dense_solve(m, A, 6, B);
    for (int i = 0; i < 6 && s == SW_OK; i++)
        for (int j = 0; j < 6; j++) {
            ret[i + 6 * j] = K[i + n * j];
            for (int k = 0; k < m; k++)
                ret[i + 6 * j] -= K[i + n * (6 + k)] * B[k + m * j];
        }
    free(A);
    free(B);
    return s;
}

enum status net_body_stiffness(const struct net *net, const struct net_state *s, const int *chosen,
                               int k, const double about[3], double K[36])
{
    struct group g;
    enum status status = group_new(net, &g);
    int *taken = mem_zeroed((size_t)net->bodies + 1, sizeof *taken), first = 1;
    double *all = NULL;

    if (status == SW_OK && !taken)
        status = SW_NOMEM;
    for (int i = 0; i < k && status == SW_OK; i++) {
        g.node[g.k++] = chosen[i];
        taken[net->node[chosen[i]].body] = 1;
    }
    if (status == SW_OK) {
        memcpy(g.about[g.n++], about, sizeof *g.about);
        for (int b = 0; b < net->bodies; b++)
            if (!net->body[b].held && !taken[b + 1])
                group_add(net, b, &g);
        all = mem_doubles(36 * (size_t)g.n * (size_t)g.n);
        status = all ? group_stiffness(net, s, &g, all) : SW_NOMEM;
    }
    for (int b = 0; b < net->bodies && status == SW_OK; b++)
        if (!net->body[b].held && !taken[b + 1])
            add_own_stiffness(&net->body[b], all, 6 * g.n, 6 * first++);
    if (status == SW_OK)
        status = condense(6 * g.n, all, K);
    group_free(&g);
    free(taken);
    free(all);
    return status;
}

/* Free bodies on their way to balance. */
struct drift {
    struct net *net;
    const struct net_options *o;
    struct group g;
    int *body;               /* (g.n) */
    struct net_body *before; /* (bodies) */
    double *W, *step, *K;    /* (6 n), (6 n), (6 n, 6 n) */
    double *A;               /* (6 n, 6 n) */
};

/* Forces are compared with this: the largest tension or weight. */
static double force_scale(const struct drift *d, const struct net_state *s)
{
    double scale = s->scale;

    for (int i = 0; i < d->g.n; i++)
        scale = fmax(scale, d->net->body[d->body[i]].weight);
    return scale;
}

/* What is missing at the free bodies, to W; returns the root of the sum of its squares, moments
 * over the size, and the largest of it. */
static double missing(const struct drift *d, const struct net_state *s, double *W, double *ret_most)
{
    double sum = 0;

    *ret_most = 0;
    for (int i = 0; i < d->g.n; i++) {
        double own[6];

        net_body_forces(d->net, s, d->body[i], d->net->body[d->body[i]].x, W + 6 * i, own);
        for (int j = 0; j < 6; j++) {
            double f;

            W[6 * i + j] += own[j];
            f = fabs(W[6 * i + j]) / (j < 3 ? 1 : s->size);
            sum += f * f;
            *ret_most = fmax(*ret_most, f);
        }
    }
    return sqrt(sum);
}

/* (K + damping diagonal) step = W, not too far: shortened to *part of it. */
static enum status find_step(const struct drift *d, double damping, double size, double *part)
{
    int n = 6 * d->g.n;
    double stiff[2] = {0, 0}, far = 0;
    enum status s;

    memcpy(d->A, d->K, (size_t)n * (size_t)n * sizeof *d->A);
    memcpy(d->step, d->W, (size_t)n * sizeof *d->W);
    for (int i = 0; i < n; i++)
        stiff[i % 6 / 3] = fmax(stiff[i % 6 / 3], fabs(d->K[place(n, i, i)]));
    for (int i = 0; i < n; i++)
        d->A[place(n, i, i)] += damping * stiff[i % 6 / 3];
    s = dense_solve(n, d->A, 1, d->step);
    for (int i = 0; i < n; i++)
        far = fmax(far, fabs(d->step[i]) / (i % 6 < 3 ? size : 1));
    *part = far > FAR ? FAR / far : 1;
    for (int i = 0; i < n; i++)
        d->step[i] *= *part;
    return s;
}

static void move_bodies(const struct drift *d, double factor)
{
    memcpy(d->net->body, d->before, sizeof *d->before * (size_t)d->net->bodies);
    for (int i = 0; i < d->g.n; i++) {
        struct net_body *p = &d->net->body[d->body[i]];
        double turn[3];

        for (int c = 0; c < 3; c++) {
            p->x[c] += factor * d->step[6 * i + c];
            turn[c] = factor * d->step[6 * i + 3 + c];
        }
        attitude_turn(turn, p->R);
        net_place_body(d->net, d->body[i]);
    }
}

static enum status take_stiffness(struct drift *d, const struct net_state *s)
{
    enum status status;

    for (int i = 0; i < d->g.n; i++)
        memcpy(d->g.about[i], d->net->body[d->body[i]].x, sizeof *d->g.about);
    status = group_stiffness(d->net, s, &d->g, d->K);
    for (int i = 0; i < d->g.n && status == SW_OK; i++)
        add_own_stiffness(&d->net->body[d->body[i]], d->K, 6 * d->g.n, 6 * i);
    return status;
}

/* One step: damped the more, the less it helps.  *off: what is missing, before and after. */
static enum status step_on(struct drift *d, struct net_state *s, double *off, double *damping)
{
    enum status status = take_stiffness(d, s);

    memcpy(d->before, d->net->body, sizeof *d->before * (size_t)d->net->bodies);
    for (int k = 0; k < TRIALS && status == SW_OK; k++) {
        struct net_state now;
        double left = INFINITY, part, most;

        status = find_step(d, *damping, s->size, &part);
        if (status == SW_INDEFINITE)
            status = SW_OK; /* more damping */
        else if (status == SW_OK) {
            move_bodies(d, 1);
            status = net_solve(d->net, d->o, &now);
            if (status == SW_OK)
                left = missing(d, &now, d->W, &most);
            if (status == SW_OK && part > PART && left < *off * (1 - GAIN * part)) {
                net_state_free(s);
                *s = now;
                *off = left;
                *damping = fmax(*damping / 10, LITTLE);
                return SW_OK;
            }
            net_state_free(&now);
            if (status == SW_NOCONV || status == SW_INDEFINITE)
                status = SW_OK;
        }
        *damping = fmax(*damping * 10, DAMPING);
        move_bodies(d, 0);
        missing(d, s, d->W, &most);
    }
    return status == SW_OK ? SW_NOCONV : status;
}

static enum status new_drift(struct net *net, const struct net_options *o, struct drift *d)
{
    size_t n;
    enum status s;

    *d = (struct drift){.net = net, .o = o};
    s = group_new(net, &d->g);
    d->body = mem_zeroed((size_t)net->bodies, sizeof *d->body);
    d->before = mem_copy(net->body, sizeof *net->body * (size_t)net->bodies);
    if (s != SW_OK || !d->body || !d->before)
        return SW_NOMEM;
    for (int b = 0; b < net->bodies; b++)
        if (!net->body[b].held) {
            d->body[d->g.n] = b;
            group_add(net, b, &d->g);
        }
    n = 6 * (size_t)d->g.n;
    d->W = mem_doubles(n);
    d->step = mem_doubles(n);
    d->K = mem_doubles(n * n);
    d->A = mem_doubles(n * n);
    return d->W && d->step && d->K && d->A ? SW_OK : SW_NOMEM;
}

static void end_drift(struct drift *d)
{
    group_free(&d->g);
    free(d->body);
    free(d->before);
    free(d->W);
    free(d->step);
    free(d->K);
    free(d->A);
}

enum status net_settle(struct net *net, const struct net_options *o, struct net_state *ret)
{
    struct drift d;
    double off = 0, most = 0, damping = LITTLE;
    enum status s = net_solve(net, o, ret);
    int free_ones = 0;

    for (int b = 0; b < net->bodies; b++)
        free_ones += !net->body[b].held;
    if (s != SW_OK || free_ones == 0)
        return s;
    s = new_drift(net, o, &d);
    if (s == SW_OK)
        off = missing(&d, ret, d.W, &most);
    for (int k = 0; s == SW_OK; k++) {
        ret->adrift = most / force_scale(&d, ret);
        if (ret->adrift <= o->tolerance)
            break;
        s = k < STEPS ? step_on(&d, ret, &off, &damping) : SW_NOCONV;
        missing(&d, ret, d.W, &most);
    }
    end_drift(&d);
    return s;
}
