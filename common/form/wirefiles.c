/* Results of wirebeam. */
#include "form/wirefiles.h"
#include "num/mem.h"
#include "num/pi.h"
#include "num/vec3.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

void wire_result_free(struct wire_result *r)
{
    frame_state_free(&r->s);
    frame_work_free(&r->w);
    follow_path_free(&r->path);
    free(r->lambda);
    free(r->shape);
}

static void cells(const double *x, int n, struct out *o)
{
    for (int i = 0; i < n; i++) {
        putc(',', o->f);
        if (isfinite(x[i]))
            out_number(o, x[i]);
    }
}

static const char *const direction[6] = {"ux", "uy", "uz", "rx", "ry", "rz"};

void wire_print_nodes(const struct wire *p, const struct wire_result *r, struct out *o)
{
    fputs("node,x_m,y_m,z_m,ux_m,uy_m,uz_m,rx_rad,ry_rad,rz_rad,load_x_N,load_y_N,load_z_N,"
          "load_mx_Nm,load_my_Nm,load_mz_Nm,support_x_N,support_y_N,support_z_N,support_mx_Nm,"
          "support_my_Nm,support_mz_Nm,held\n",
          o->f);
    for (int i = 0; i < p->nodes.n; i++) {
        const struct frame_node *node = &p->frame.node[i];
        double u[3], support[6];
        int any = 0;

        for (int c = 0; c < 3; c++)
            u[c] = r->s.x[3 * i + c] - node->x[c] + r->s.low[3 * i + c];
        for (int c = 0; c < 6; c++)
            support[c] = node->held & 1 << c ? r->w.open[6 * i + c] : 0;
        out_cell(o, wire_node(p, i));
        cells(r->s.x + 3 * i, 3, o);
        cells(u, 3, o);
        cells(r->s.turn + 3 * i, 3, o);
        cells(r->w.load + 6 * i, 6, o);
        cells(support, 6, o);
        putc(',', o->f);
        for (int c = 0; c < 6; c++)
            if (node->held & 1 << c)
                fprintf(o->f, "%s%s", any++ ? " " : "", direction[c]);
        putc('\n', o->f);
    }
}

/* The curve of beam i as it is, or was (natural, and in linear theory). */
static void curve_of(const struct wire *p, const struct wire_result *r, int i, int natural,
                     struct bow *ret, double origin[3])
{
    const struct frame_beam *b = &p->frame.beam[i];
    double A[2][9];

    *ret = b->beam.bow;
    memcpy(origin, p->frame.node[b->a].x, 3 * sizeof *origin);
    if (natural || p->c.method == WIRE_LINEAR)
        return;
    frame_ends(&p->frame, &r->s, i, A[0], A[1]);
    bow_between(r->s.x + 3 * b->a, r->s.x + 3 * b->b, A[0], A[1], ret->psi[1] - ret->psi[0],
                ret->bulge, ret);
    memcpy(origin, r->s.x + 3 * b->a, 3 * sizeof *origin);
}

/* In linear theory the place is moved by what the ends' moves make of it: cubic between them. */
static void move_linearly(const struct wire *p, const struct wire_result *r, int i, double zeta,
                          double x[3])
{
    const struct frame_beam *b = &p->frame.beam[i];
    const double *turn[2] = {r->s.turn + 3 * b->a, r->s.turn + 3 * b->b};
    double h[2] = {1 - zeta * zeta * (3 - 2 * zeta), zeta * zeta * (3 - 2 * zeta)};

    for (int end = 0; end < 2; end++) {
        int node = end ? b->b : b->a;
        double lever[3], moved[3];

        for (int c = 0; c < 3; c++)
            lever[c] = x[c] - p->frame.node[node].x[c];
        vec3_cross(turn[end], lever, moved);
        for (int c = 0; c < 3; c++)
            x[c] += h[end] * (r->s.x[3 * node + c] - p->frame.node[node].x[c] + moved[c]);
    }
}

/* A point along a beam with its section forces. */
struct cut {
    double s, force[4], x[3], natural[3];
    struct section_stress stress;
};

static void cut_at(const struct wire *p, const struct wire_result *r, int i, double zeta,
                   struct cut *ret)
{
    const struct frame_beam *b = &p->frame.beam[i];
    struct bow now, before;
    struct bow_run along = {.zeta = 0}, run = {.zeta = 0};
    struct bow_point at;
    double origin[2][3];

    curve_of(p, r, i, 0, &now, origin[0]);
    curve_of(p, r, i, 1, &before, origin[1]);
    bow_run_to(&now, zeta, &run);
    bow_run_to(&before, zeta, &along);
    ret->s = p->piece[i].s + along.s;
    beam_section(&now, &run, r->w.end + 12 * i, r->w.end + 12 * i + 3, r->w.q + 3 * i, ret->force);
    ret->stress = section_stresses(b->section, ret->force);
    bow_at(&now, zeta, &at);
    mat3_apply_t(now.B, at.p, ret->x);
    vec3_add(1, origin[0], ret->x);
    bow_at(&before, zeta, &at);
    mat3_apply_t(before.B, at.p, ret->natural);
    vec3_add(1, origin[1], ret->natural);
    if (p->c.method == WIRE_LINEAR)
        move_linearly(p, r, i, zeta, ret->x);
}

void wire_print_forces(const struct wire *p, const struct wire_result *r, struct out *o)
{
    fputs("element,s_m,N_N,Mx_Nm,My_Nm,Mt_Nm,x_m,y_m,z_m,x0_m,y0_m,z0_m", o->f);
    fputs(r->stresses ? ",axial_Pa,bending_Pa,shear_Pa,most_Pa,mises_Pa\n" : "\n", o->f);
    for (int i = 0; i < p->frame.beams; i++)
        for (int k = p->piece[i].s > 0; k < p->c.points; k++) {
            struct cut c;

            cut_at(p, r, i, k / (p->c.points - 1.0), &c);
            out_cell(o, wire_element(p, p->piece[i].element));
            cells(&c.s, 1, o);
            cells(c.force, 4, o);
            cells(c.x, 3, o);
            cells(c.natural, 3, o);
            if (r->stresses)
                cells((const double[]){c.stress.axial, c.stress.bending, c.stress.shear,
                                       c.stress.most, c.stress.mises},
                      5, o);
            putc('\n', o->f);
        }
}

double wire_worst(const struct wire *p, const struct wire_result *r, int *ret_element)
{
    double most = -1;

    *ret_element = -1;
    for (int i = 0; i < p->frame.beams; i++)
        for (int k = 0; k < p->c.points; k++) {
            struct cut c;

            cut_at(p, r, i, k / (p->c.points - 1.0), &c);
            if (c.stress.mises > most) {
                most = c.stress.mises;
                *ret_element = p->piece[i].element;
            }
        }
    return most;
}

/* Of the farthest fibre, and of shear by torsion; what is not known counts as 0. */
static double strain_of(const struct section *s, const double force[4])
{
    double e[4] = {0};

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            e[i] += s->flexibility[i + 4 * j] * force[j];
    e[0] = fabs(e[0]);
    e[0] += s->shape == SECTION_ROUND || s->shape == SECTION_TUBE
                ? hypot(e[1], e[2]) * s->ex
                : fmax(0, fabs(e[1]) * s->ey) + fmax(0, fabs(e[2]) * s->ex);
    return fmax(e[0], fabs(e[3]) * s->It / s->Wt);
}

double wire_strain(const struct wire *p, const struct wire_result *r, int *ret_element)
{
    double most = -1;

    for (int i = 0; i < p->frame.beams; i++)
        for (int k = 0; k < p->c.points; k++) {
            struct cut c;
            double strain;

            cut_at(p, r, i, k / (p->c.points - 1.0), &c);
            strain = strain_of(p->frame.beam[i].section, c.force);
            if (strain > most) {
                most = strain;
                *ret_element = p->piece[i].element;
            }
        }
    return most;
}

void wire_print_history(const struct wire *p, const struct wire_result *r, struct out *o)
{
    fputs("step,time,iterations,residual,negative,energy_Nm", o->f);
    for (int c = 0; c < 6 && p->watch >= 0; c++)
        fprintf(o->f, ",%s_%s", direction[c], c < 3 ? "m" : "rad");
    putc('\n', o->f);
    for (int k = 0; k < r->path.n; k++) {
        const struct follow_step *t = &r->path.step[k];

        fprintf(o->f, "%d,", k);
        out_number(o, t->t);
        fprintf(o->f, ",%d", t->iterations);
        cells(&t->residual, 1, o);
        fprintf(o->f, ",%d", t->negative);
        cells(&t->energy, 1, o);
        if (p->watch >= 0)
            cells(t->watch, 6, o);
        putc('\n', o->f);
    }
}

static const char *method_name(int method)
{
    static const char *const name[] = {"equilibrium", "linear", "updated"};

    return name[method];
}

void wire_print_summary(const struct wire *p, const struct wire_result *r, struct out *o)
{
    const struct follow_step *last = r->path.n > 0 ? &r->path.step[r->path.n - 1] : NULL;
    double length = 0, mass = 0;
    int iterations = 0;

    for (int i = 0; i < p->frame.beams; i++) {
        length += p->frame.beam[i].beam.length;
        mass += p->frame.beam[i].beam.length * p->frame.beam[i].section->mass;
    }
    for (int k = 0; k < r->path.n; k++)
        iterations += r->path.step[k].iterations;
    fputs("status,method,nodes,elements,pieces,unknowns,steps,iterations,time,residual,negative,"
          "critical_time,largest_force_N,largest_moment_Nm,energy_Nm,length_m,mass_kg\n",
          o->f);
    fprintf(o->f, "%s,%s,%d,%d,%d,%d,%d,%d", r->status == SW_OK ? "solved" : "not-solved",
            method_name(p->c.method), p->nodes.n, p->elements.n, p->frame.beams, r->w.unknowns,
            r->path.n > 0 ? r->path.n - 1 : 0, iterations);
    cells(&r->s.t, 1, o);
    if (last)
        cells((const double[]){last->residual, last->negative, r->path.critical}, 3, o);
    else
        fputs(",,,", o->f);
    cells((const double[]){r->w.force, r->w.moment}, 2, o);
    putc(',', o->f);
    if (last)
        out_number(o, last->energy);
    cells((const double[]){length, mass}, 2, o);
    putc('\n', o->f);
}

void wire_print_modes(const struct wire_result *r, struct out *o)
{
    fputs("mode,omega_rad_s,frequency_Hz,period_s,lambda_1_s2\n", o->f);
    for (int k = 0; k < r->modes; k++) {
        double omega = sqrt(r->lambda[k]); /* unstable ones: NaN, an empty cell */

        fprintf(o->f, "%d", k + 1);
        cells((const double[]){omega, omega / (2 * PI), 2 * PI / omega, r->lambda[k]}, 4, o);
        putc('\n', o->f);
    }
}

/* The largest displacement component of a shape is 1. */
void wire_print_shapes(const struct wire *p, const struct wire_result *r, struct out *o)
{
    fputs("mode,node,ux,uy,uz,rx,ry,rz\n", o->f);
    for (int k = 0; k < r->modes; k++) {
        const double *shape = r->shape + (size_t)(6 * p->frame.n) * (size_t)k;
        double most = 0;

        for (int i = 0; i < 6 * p->frame.n; i++)
            if (i % 6 < 3 && fabs(shape[i]) > fabs(most) * (1 + 1e-9))
                most = shape[i];
        for (int i = 0; i < p->nodes.n; i++) {
            fprintf(o->f, "%d,", k + 1);
            out_cell(o, wire_node(p, i));
            for (int c = 0; c < 6; c++)
                cells((const double[]){shape[6 * i + c] / (most != 0 ? most : 1)}, 1, o);
            putc('\n', o->f);
        }
    }
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

enum { NODES, FORCES, HISTORY, SUMMARY, MODES, SHAPES, N_FILES };
static const char *const file_name[N_FILES] = {"nodes.csv",   "forces.csv", "history.csv",
                                               "summary.csv", "modes.csv",  "shapes.csv"};

static void print_file(int which, const struct wire *p, const struct wire_result *r, struct out *o)
{
    switch (which) {
    case NODES: wire_print_nodes(p, r, o); break;
    case FORCES: wire_print_forces(p, r, o); break;
    case HISTORY: wire_print_history(p, r, o); break;
    case SUMMARY: wire_print_summary(p, r, o); break;
    case MODES: wire_print_modes(r, o); break;
    default: wire_print_shapes(p, r, o); break;
    }
}

enum status wire_write(const char *dir, const struct wire *p, const struct wire_result *r,
                       struct why *why)
{
    struct out o[N_FILES];
    char *path[N_FILES] = {NULL};
    int n = r->modes > 0 ? N_FILES : MODES;
    enum status s = SW_OK;

    if (mkdir(dir, 0777) != 0 && errno != EEXIST)
        return fail(why, SW_WRITE, "%s: cannot be made: %s", dir, strerror(errno));
    for (int i = 0; i < n && s == SW_OK; i++) {
        path[i] = path_in(dir, file_name[i]);
        s = path[i] ? out_open(&o[i], path[i], why) : fail_plain(why, SW_NOMEM);
        if (s == SW_OK) {
            print_file(i, p, r, &o[i]);
            s = out_finish(&o[i], why);
        }
    }
    for (int i = 0; i < n && s == SW_OK; i++)
        s = out_rename(&o[i], why);
    for (int i = 0; i < n; i++)
        free(path[i]);
    return s;
}
