/* Unknowns, global stiffness and first state of systems of ropes. */
#include "phys/network.h"
#include "num/mem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WEIGHTLESS 1e-9 /* of the reference force: ropes of less load */

int net_is_bar(const struct net_rope *r)
{
    return r->rope.elements == 1 && !r->cut;
}

int net_is_placed(const struct net_rope *r)
{
    return net_is_bar(r) || r->over;
}

static int number_unknowns(const struct net *net, int *dof)
{
    int count = 0;

    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3; c++)
            dof[3 * i + c] = net->node[i].held & 1 << c ? -1 : count++;
    return count;
}

/* The places of all blocks, lower half. */
static size_t list_places(const struct net *net, const struct net_work *w, struct place *place)
{
    size_t k = 0;

    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3; c++)
            for (int d = c; d < 3; d++, k++) {
                int p = w->dof[3 * i + c], q = w->dof[3 * i + d];

                place[k] = p >= 0 && q >= 0 ? (struct place){q, p} : (struct place){0, 0};
            }
    for (int r = 0; r < net->m; r++)
        for (int c = 0; c < 3; c++)
            for (int d = 0; d < 3; d++, k++) {
                int p = w->dof[3 * net->rope[r].a + c], q = w->dof[3 * net->rope[r].b + d];

                place[k] = p >= 0 && q >= 0 ? (struct place){p > q ? p : q, p > q ? q : p}
                                            : (struct place){0, 0};
            }
    return k;
}

/* Blocks of held directions have no place. */
static void drop_held(const struct net *net, struct net_work *w)
{
    int k = 0;

    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3; c++)
            for (int d = c; d < 3; d++, k++)
                if (w->dof[3 * i + c] < 0 || w->dof[3 * i + d] < 0)
                    w->at_node[k] = -1;
    k = 0;
    for (int r = 0; r < net->m; r++)
        for (int c = 0; c < 3; c++)
            for (int d = 0; d < 3; d++, k++)
                if (w->dof[3 * net->rope[r].a + c] < 0 || w->dof[3 * net->rope[r].b + d] < 0)
                    w->at_rope[k] = -1;
}

static enum status lay_matrix(const struct net *net, struct net_work *w)
{
    size_t n = 6 * (size_t)net->n, m = 9 * (size_t)net->m;
    struct place *place = mem_zeroed(n + m, sizeof *place);
    int *at = mem_zeroed(n + m, sizeof *at);
    enum status s = SW_NOMEM;

    if (place && at) {
        s = sparse_new(w->unknowns, place, w->unknowns > 0 ? list_places(net, w, place) : 0, at,
                       &w->A);
        memcpy(w->at_node, at, n * sizeof *at);
        memcpy(w->at_rope, at + n, m * sizeof *at);
        drop_held(net, w);
    }
    free(place);
    free(at);
    return s;
}

enum status net_work_new(const struct net *net, struct net_work *w)
{
    size_t n = (size_t)net->n, m = (size_t)net->m;
    struct {
        double **to;
        size_t size;
    } vector[] = {{&w->gap, 3 * m},      {&w->bar, 3 * m}, {&w->K, SYM * m}, {&w->node_K, SYM * n},
                  {&w->residual, 3 * n}, {&w->dx, 3 * n},  {&w->dt, 3 * m},  {&w->x1, 3 * n},
                  {&w->t1, 3 * m},       {&w->rhs, 3 * n}};
    int enough = 1;

    *w = (struct net_work){.unknowns = 0};
    w->dof = mem_zeroed(3 * n, sizeof *w->dof);
    w->at_node = mem_zeroed(6 * n, sizeof *w->at_node);
    w->at_rope = mem_zeroed(9 * m, sizeof *w->at_rope);
    for (size_t i = 0; i < sizeof vector / sizeof *vector; i++) {
        *vector[i].to = mem_doubles(vector[i].size);
        enough &= *vector[i].to != NULL;
    }
    if (!w->dof || !w->at_node || !w->at_rope || !enough)
        return SW_NOMEM;
    w->unknowns = number_unknowns(net, w->dof);
    if (net->sea && net->sea->bed.kind != BED_NONE) {
        w->pull = mem_doubles(6 * m);
        w->over_K = mem_doubles(36 * m);
        w->lean = mem_doubles(n);
        w->push = mem_doubles(n);
        if (!w->pull || !w->over_K || !w->lean || !w->push)
            return SW_NOMEM;
    }
    return lay_matrix(net, w);
}

void net_work_free(struct net_work *w)
{
    free(w->dof);
    free(w->at_node);
    free(w->at_rope);
    free(w->gap);
    free(w->bar);
    free(w->K);
    free(w->node_K);
    free(w->residual);
    free(w->dx);
    free(w->dt);
    free(w->x1);
    free(w->t1);
    free(w->rhs);
    free(w->pull);
    free(w->over_K);
    free(w->lean);
    free(w->push);
    sparse_free(&w->A);
    *w = (struct net_work){.dof = NULL};
}

static void add_diagonal(const struct net_work *w, int node, const double K[SYM])
{
    for (int k = 0; k < SYM; k++)
        if (w->at_node[6 * node + k] >= 0)
            w->A.value[w->at_node[6 * node + k]] += K[k];
}

/* The symmetric part of a 6 x 6 block, column-major, of rope r. */
static void add_block(const struct net *net, const struct net_work *w, int r, const double *K)
{
    for (int end = 0; end < 2; end++) {
        double own[SYM];

        for (int i = 0, at = 0; i < 3; i++)
            for (int j = i; j < 3; j++, at++)
                own[at] =
                    (K[3 * end + i + 6 * (3 * end + j)] + K[3 * end + j + 6 * (3 * end + i)]) / 2;
        add_diagonal(w, end ? net->rope[r].b : net->rope[r].a, own);
    }
    for (int k = 0; k < 9; k++)
        if (w->at_rope[9 * r + k] >= 0)
            w->A.value[w->at_rope[9 * r + k]] +=
                (K[k / 3 + 6 * (3 + k % 3)] + K[3 + k % 3 + 6 * (k / 3)]) / 2;
}

void net_assemble(const struct net *net, struct net_work *w)
{
    static const int entry[9] = {SYM_XX, SYM_XY, SYM_XZ, SYM_XY, SYM_YY,
                                 SYM_YZ, SYM_XZ, SYM_YZ, SYM_ZZ};

    if (w->unknowns == 0)
        return;
    memset(w->A.value, 0, w->A.entries * sizeof *w->A.value);
    for (int i = 0; i < net->n; i++)
        add_diagonal(w, i, w->node_K + SYM * i);
    for (int r = 0; r < net->m; r++) {
        const double *K = w->K + SYM * r;

        if (net->rope[r].over) {
            add_block(net, w, r, w->over_K + 36 * (size_t)r);
            continue;
        }
        add_diagonal(w, net->rope[r].a, K);
        add_diagonal(w, net->rope[r].b, K);
        for (int k = 0; k < 9; k++)
            if (w->at_rope[9 * r + k] >= 0)
                w->A.value[w->at_rope[9 * r + k]] -= K[entry[k]];
    }
}

int net_node_of(const struct net *net, const struct net_work *w, int unknown)
{
    for (int i = 0; i < 3 * net->n; i++)
        if (unknown >= 0 && w->dof[i] == unknown)
            return i / 3;
    return -1;
}

double net_size(const struct net *net)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double size = 0, square = 0;

    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3; c++)
            if (net->node[i].held & 1 << c) {
                low[c] = fmin(low[c], net->node[i].x[c]);
                high[c] = fmax(high[c], net->node[i].x[c]);
            }
    for (int c = 0; c < 3; c++)
        if (high[c] > low[c])
            square += (high[c] - low[c]) * (high[c] - low[c]);
    for (int r = 0; r < net->m; r++)
        size = fmax(size, net->rope[r].rope.L0);
    return fmax(size, sqrt(square));
}

static double norm(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

double net_reference(const struct net *net)
{
    double load = 0, softest = INFINITY;
    int held = 0;

    for (int i = 0; i < net->n; i++) {
        const struct net_node *p = &net->node[i];
        double free[3];

        for (int c = 0; c < 3; c++)
            free[c] = p->held & 1 << c ? 0 : p->force[c];
        held += p->held != 0;
        load += norm(free) + (p->held & 4 ? 0 : p->area * p->height);
    }
    for (int r = 0; r < net->m; r++) {
        load += norm(net->rope[r].rope.q) * net->rope[r].rope.L0;
        softest = fmin(softest, net->rope[r].rope.law.EA);
    }
    return load > 0 ? load / (held > 0 ? held : 1) : softest / 1000;
}

void net_smooth(struct net *net, double part, double reference, double least)
{
    double small = reference;

    for (int r = 0; r < net->m; r++)
        small = fmin(small, net->rope[r].rope.law.EA / 1000);
    for (int r = 0; r < net->m; r++) {
        struct rope *p = &net->rope[r].rope;
        double load = norm(p->q) * p->L0;

        p->epsilon = fmax(least, part * (load > WEIGHTLESS * reference ? load : small));
    }
}

/* Positions of free nodes without a guess: amid those that are held. */
static void place_nodes(const struct net *net, double *x)
{
    double middle[3] = {0, 0, 0};
    int count[3] = {0, 0, 0};

    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3; c++)
            if (net->node[i].held & 1 << c) {
                middle[c] += net->node[i].x[c];
                count[c]++;
            }
    for (int i = 0; i < net->n; i++)
        for (int c = 0; c < 3; c++)
            x[3 * i + c] = !isnan(net->node[i].x[c]) ? net->node[i].x[c]
                           : count[c] > 0            ? middle[c] / count[c]
                                                     : 0;
}

/* Where bars end, a guess tells which of several equilibria is meant. */
static void keep_guesses(const struct net *net, double *dx)
{
    for (int r = 0; r < net->m; r++)
        for (int end = 0; end < 2 && net_is_bar(&net->rope[r]); end++) {
            int i = end ? net->rope[r].b : net->rope[r].a;

            for (int c = 0; c < 3; c++)
                if (!isnan(net->node[i].x[c]))
                    dx[3 * i + c] = 0;
        }
}

enum status net_begin(const struct net *net, struct net_work *w, struct net_state *s)
{
    enum status status;

    place_nodes(net, s->x);
    for (int r = 0; r < net->m; r++) {
        double load[3];

        memset(net->rope[r].rope.offset, 0, sizeof net->rope[r].rope.offset);
        rope_load(&net->rope[r].rope, load);
        for (int i = 0; i < 3; i++)
            s->t[3 * r + i] = net_is_bar(&net->rope[r]) ? 0 : load[i] / 2;
    }
    net_evaluate(net, s->x, s->t, w);
    for (int r = 0; r < net->m; r++) {
        const struct net_rope *p = &net->rope[r];
        double *K = w->K + SYM * r;

        memset(K, 0, SYM * sizeof *K);
        K[SYM_XX] = K[SYM_YY] = K[SYM_ZZ] = w->reference / p->rope.L0;
        for (int i = 0; i < 3; i++) {
            w->gap[3 * r + i] = s->x[3 * p->b + i] - s->x[3 * p->a + i];
            if (net_is_bar(p)) { /* its own force is left out */
                w->residual[3 * p->a + i] -= w->bar[3 * r + i];
                w->residual[3 * p->b + i] += w->bar[3 * r + i];
            }
        }
    }
    status = net_find_step(net, w, &s->worst);
    if (status != SW_OK)
        return status;
    keep_guesses(net, w->dx);
    for (int i = 0; i < 3 * net->n; i++)
        s->x[i] += w->dx[i];
    for (int i = 0; i < 3 * net->m; i++)
        s->t[i] += net_is_bar(&net->rope[i / 3]) ? 0 : w->dt[i];
    return SW_OK;
}
