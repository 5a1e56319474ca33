/* Results of gapnet. */
#include "form/netfiles.h"
#include "form/netbodies.h"
#include "num/mem.h"
#include "sys/npy.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define STRAIN 1e-5 /* of the softest rope: with less nothing pulls */
#define SLACK 1e-8  /* of the largest tension: a rope that carries nothing */

static double size(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

static void cells(const double *x, int n, struct out *o)
{
    for (int i = 0; i < n; i++) {
        putc(',', o->f);
        out_number(o, x[i]);
    }
}

/* Ropes that carry no more are slack [N]: a part of the largest tension, where anything pulls. */
static double slack_below(const struct system *p, const struct net_state *s)
{
    double softest = INFINITY;

    for (int r = 0; r < p->net.m; r++)
        softest = fmin(softest, p->net.rope[r].rope.law.EA);
    return SLACK * fmax(s->most, STRAIN * softest);
}

/* Force of the ropes on all nodes, (n, 3), allocated; NULL: memory ran out. */
static double *rope_forces(const struct system *p, const struct net_state *s)
{
    double *f = mem_doubles(3 * (size_t)p->net.n);

    for (int r = 0; f && r < p->net.m; r++) {
        const struct net_rope *rope = &p->net.rope[r];
        double ta[3], tb[3];

        net_ends(&p->net, s, r, ta, tb);
        for (int i = 0; i < 3; i++) {
            f[3 * rope->a + i] += ta[i];
            f[3 * rope->b + i] -= tb[i];
        }
    }
    return f;
}

double net_unbalance(const struct system *p, const struct net_state *s, int *ret_node)
{
    double most = 0;

    *ret_node = -1;
    for (int i = 0; i < 3 * p->net.n; i++)
        if (!(p->net.node[i / 3].held & 1 << i % 3) && !(fabs(s->residual[i]) <= most)) {
            most = fabs(s->residual[i]);
            *ret_node = i / 3;
        }
    return s->scale > 0 ? most / s->scale : most;
}

/*
 * The load of a node is what is missing to the balance but for the ropes: residual - rope forces;
 * of a support minus the residual is its reaction.
 */
enum status net_print_nodes(const struct system *p, const struct net_state *s, struct out *o,
                            struct why *why)
{
    double *force = rope_forces(p, s);

    if (!force)
        return fail_plain(why, SW_NOMEM);
    fputs("node,x_m,y_m,z_m,fx_N,fy_N,fz_N,residual_N,load_x_N,load_y_N,load_z_N,support_x_N,"
          "support_y_N,support_z_N,held\n",
          o->f);
    for (int i = 0; i < p->net.n; i++) {
        const struct net_node *node = &p->net.node[i];
        const double *f = force + 3 * i, *missing = s->residual + 3 * i;
        double load[3], support[3], open[3];

        for (int c = 0; c < 3; c++) {
            load[c] = missing[c] - f[c];
            support[c] = node->held & 1 << c ? -missing[c] : 0;
            open[c] = f[c] + load[c] + support[c];
        }
        out_cell(o, system_node(p, i));
        cells(s->x + 3 * i, 3, o);
        cells(f, 3, o);
        putc(',', o->f);
        out_number(o, size(open));
        cells(load, 3, o);
        cells(support, 3, o);
        putc(',', o->f);
        for (int c = 0; c < 3; c++)
            if (node->held & 1 << c)
                putc("xyz"[c], o -> f);
        putc('\n', o->f);
    }
    free(force);
    return SW_OK;
}

/* slack, compression, ... */
static const char *remark_of(const struct net_outline *p, double breaking, double slack)
{
    if (p->most < 0)
        return "compression";
    if (p->most > breaking)
        return "over its breaking load";
    return p->most <= slack ? "slack" : "";
}

void net_print_ropes(const struct system *p, const struct net_state *s, struct out *o)
{
    double slack = slack_below(p, s);

    fputs("rope,tension_a_N,tension_b_N,tension_max_N,tension_min_N,length_m,length_on_bed_m,"
          "ta_x_N,ta_y_N,ta_z_N,tb_x_N,tb_y_N,tb_z_N,node_a,node_b,unstretched_m,elements,ea_N,"
          "use,lowest_z_m,remark,law\n",
          o->f);
    for (int r = 0; r < p->net.m; r++) {
        const struct net_rope *rope = &p->net.rope[r];
        double breaking = p->type[p->type_of[r]].breaking, ta[3], tb[3];
        struct net_outline line;
        int pushed;

        net_ends(&p->net, s, r, ta, tb);
        net_outline(&p->net, s, r, &line);
        pushed = line.most < 0;
        out_cell(o, system_rope(p, r));
        cells((const double[]){pushed ? line.most : size(ta), pushed ? line.most : size(tb),
                               line.most, line.least, line.length, line.flat},
              6, o);
        cells(ta, 3, o);
        cells(tb, 3, o);
        putc(',', o->f);
        out_cell(o, system_node(p, rope->a));
        putc(',', o->f);
        out_cell(o, system_node(p, rope->b));
        cells((const double[]){rope->rope.L0, line.elements, rope->rope.law.EA}, 3, o);
        putc(',', o->f);
        if (isfinite(breaking))
            out_number(o, line.most / breaking);
        cells(&line.lowest, 1, o);
        fprintf(o->f, ",%s,%s\n", remark_of(&line, breaking, slack),
                rope->rope.law.n > 0 ? "table" : "hooke");
    }
}

static void print_points(const char *name, const double *a, const struct rope_point *point, int n,
                         struct out *o)
{
    for (int k = 0; k < n; k++) {
        const double x[3] = {a[0] + point[k].x[0], a[1] + point[k].x[1], a[2] + point[k].x[2]};

        out_cell(o, name);
        fprintf(o->f, ",%d", k);
        cells(x, 3, o);
        cells((const double[]){size(point[k].t)}, 1, o);
        cells(point[k].load, 3, o);
        cells(&point[k].s, 1, o);
        cells(point[k].t, 3, o);
        cells((const double[]){point[k].strain, point[k].bed}, 2, o);
        putc('\n', o->f);
    }
}

enum status net_print_shapes(const struct system *p, const struct net_state *s, struct out *o,
                             struct why *why)
{
    int most = NET_POINTS;
    struct rope_point *point;

    for (int r = 0; r < p->net.m; r++) {
        struct net_outline line;

        net_outline(&p->net, s, r, &line);
        most = line.elements + 1 > most ? line.elements + 1 : most;
    }
    point = mem_zeroed((size_t)most, sizeof *point);
    if (!point)
        return fail_plain(why, SW_NOMEM);
    fputs("rope,joint,x_m,y_m,z_m,tension_N,load_x_N,load_y_N,load_z_N,s_m,tx_N,ty_N,tz_N,"
          "strain,bed_N\n",
          o->f);
    for (int r = 0; r < p->net.m; r++)
        print_points(system_rope(p, r), s->x + 3 * p->net.rope[r].a, point,
                     net_points(&p->net, s, r, point), o);
    free(point);
    return SW_OK;
}

void net_print_history(const struct net_state *s, struct out *o)
{
    fputs("step,mean_gap,largest_gap,residual_N,factor\n", o->f);
    for (int k = 0; k <= s->steps; k++) {
        const struct net_step *p = &s->step[k];

        fprintf(o->f, "%d", k);
        cells((const double[]){p->mean_gap, p->largest_gap, p->residual, p->factor}, 4, o);
        putc('\n', o->f);
    }
}

/* Ropes that carry nothing, are over their breaking load, are bars under compression. */
static void count_remarks(const struct system *p, const struct net_state *s, int ret[3])
{
    double slack = slack_below(p, s);

    ret[0] = ret[1] = ret[2] = 0;
    for (int r = 0; r < p->net.m; r++) {
        struct net_outline line;

        net_outline(&p->net, s, r, &line);
        ret[0] += fabs(line.most) <= slack;
        ret[1] += line.most > p->type[p->type_of[r]].breaking;
        ret[2] += line.most < -slack;
    }
}

void net_print_summary(const struct system *p, const struct net_state *s,
                       const struct net_report *r, struct out *o)
{
    const struct net_step *last = &s->step[s->steps];
    int worst, remarks[3];
    double unbalance = net_unbalance(p, s, &worst);

    count_remarks(p, s, remarks);
    fputs("status,method,nodes,ropes,steps,largest_gap,largest_residual,worst_node,"
          "largest_tension_N,size_m,slack,over_breaking,compression,verify_m\n",
          o->f);
    fprintf(o->f, "%s,%s,%d,%d,%d", r->status == SW_OK ? "solved" : "not-solved", r->method,
            p->net.n, p->net.m, s->steps);
    cells((const double[]){last->largest_gap, unbalance}, 2, o);
    putc(',', o->f);
    if (worst >= 0)
        out_cell(o, system_node(p, worst));
    cells((const double[]){s->most, s->size, remarks[0], remarks[1], remarks[2]}, 5, o);
    putc(',', o->f);
    if (!isnan(r->difference))
        out_number(o, r->difference);
    putc('\n', o->f);
}

void net_print_stiffness(const struct system *p, const int *chosen, int k, const double *K,
                         struct out *o)
{
    fputs("force_N", o->f);
    for (int i = 0; i < 3 * k; i++)
        fprintf(o->f, ",%s.%c_m", system_node(p, chosen[i / 3]), "xyz"[i % 3]);
    for (int i = 0; i < 3 * k; i++) {
        fprintf(o->f, "\n%s.%c", system_node(p, chosen[i / 3]), "xyz"[i % 3]);
        for (int j = 0; j < 3 * k; j++)
            cells(&K[i + 3 * k * j], 1, o);
    }
    putc('\n', o->f);
}

void net_print_body(const double K[36], struct out *o)
{
    static const char *const force[6] = {"fx_N", "fy_N", "fz_N", "mx_Nm", "my_Nm", "mz_Nm"};

    fputs("force,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad", o->f);
    for (int i = 0; i < 6; i++) {
        fprintf(o->f, "\n%s", force[i]);
        for (int j = 0; j < 6; j++)
            cells(&K[i + 6 * j], 1, o);
    }
    putc('\n', o->f);
}

/* DIR/name, allocated. */
static char *path_in(const char *dir, const char *name)
{
    size_t bytes = strlen(dir) + strlen(name) + 2;
    char *path = mem_zeroed(bytes, 1);

    if (path)
        snprintf(path, bytes, "%s/%s", dir, name);
    return path;
}

static enum status make_dir(const char *dir, struct why *why)
{
    if (mkdir(dir, 0777) == 0 || errno == EEXIST)
        return SW_OK;
    return fail(why, SW_WRITE, "%s: cannot be made: %s", dir, strerror(errno));
}

enum { NODES, ROPES, SHAPES, HISTORY, SUMMARY, BODIES, N_FILES };
static const char *const file_name[N_FILES] = {"nodes.csv",   "ropes.csv",   "shapes.csv",
                                               "history.csv", "summary.csv", "bodies.csv"};

static enum status print_file(int which, const struct system *p, const struct net_state *s,
                              const struct net_report *r, struct out *o, struct why *why)
{
    switch (which) {
    case NODES: return net_print_nodes(p, s, o, why);
    case ROPES: net_print_ropes(p, s, o); return SW_OK;
    case SHAPES: return net_print_shapes(p, s, o, why);
    case HISTORY: net_print_history(s, o); return SW_OK;
    case BODIES: net_print_bodies(p, s, o); return SW_OK;
    default: net_print_summary(p, s, r, o); return SW_OK;
    }
}

enum status net_write(const char *dir, const struct system *p, const struct net_state *s,
                      const struct net_report *r, struct why *why)
{
    struct out o[N_FILES];
    char *path[N_FILES] = {NULL};
    int files = p->net.bodies > 0 ? N_FILES : BODIES; /* their table is the last one */
    enum status status = make_dir(dir, why);

    for (int i = 0; i < files && status == SW_OK; i++) {
        path[i] = path_in(dir, file_name[i]);
        status = path[i] ? out_open(&o[i], path[i], why) : fail_plain(why, SW_NOMEM);
        if (status == SW_OK)
            status = print_file(i, p, s, r, &o[i], why);
        if (status == SW_OK)
            status = out_finish(&o[i], why);
    }
    for (int i = 0; i < files && status == SW_OK; i++)
        status = out_rename(&o[i], why);
    for (int i = 0; i < N_FILES; i++)
        free(path[i]);
    return status;
}

enum status net_write_stiffness(const char *dir, const struct system *p, const int *chosen, int k,
                                int body, const double *K, struct why *why)
{
    static const char *const name[2] = {"stiffness.csv", "stiffness.npy"};
    size_t n = body ? 6 : 3 * (size_t)k;
    enum status s = make_dir(dir, why);

    for (int i = 0; i < 2 && s == SW_OK; i++) {
        char *path = path_in(dir, name[i]);
        struct out o;

        s = path ? out_open(&o, path, why) : fail_plain(why, SW_NOMEM);
        if (s == SW_OK) {
            if (i == 1)
                npy_write(&o, 2, n, n, K);
            else if (body)
                net_print_body(K, &o);
            else
                net_print_stiffness(p, chosen, k, K, &o);
            s = out_close(&o, why);
        }
        free(path);
    }
    return s;
}
