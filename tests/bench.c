/*
 * Rates of the costly parts beside their targets, and dgemm and a triad of the same minute.
 *
 * Targets hold for one core with 35 GF/s of dgemm and are scaled by the dgemm measured here.  Each
 * figure is the median of several runs; machines are noisy: compare ratios.
 */
#include "num/mem.h"
#include "num/pi.h"
#include "phys/follow.h"
#include "phys/lanes.h"
#include "phys/map.h"
#include "phys/march.h"
#include "phys/modes.h"
#include "phys/net.h"
#include "phys/sea.h"
#include "sys/number.h"

#include <cblas.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#define RUNS 5
#define REFERENCE 35.0 /* GF/s of dgemm that the targets assume */

static const struct cable pont = {110.1897, 64.8, 2.1e11 * 8.26e-3, 9.81, 110.5, 0};
static const struct cable seil2 = {100.429, 0.704, 1.5556e11 * 8.48e-5, 9.81, 100.534, 0};

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Median of RUNS calls. */
static double median(double (*measure)(int), int argument)
{
    double x[RUNS];

    for (int i = 0; i < RUNS; i++)
        x[i] = measure(argument);
    qsort(x, RUNS, sizeof *x, ascending);
    return x[RUNS / 2];
}

static void *checked(void *p)
{
    if (!p) {
        fputs("bench: memory ran out\n", stderr);
        exit(1);
    }
    return p;
}

static void expect(enum status s)
{
    if (s != SW_OK) {
        fprintf(stderr, "bench: %s\n", status_text(s));
        exit(1);
    }
}

/* GF/s of an n x n product. */
static double dgemm(int n)
{
    size_t size = (size_t)n * (size_t)n;
    double *a = checked(mem_doubles(size)), *b = checked(mem_doubles(size));
    double *c = checked(mem_doubles(size)), t;

    for (size_t i = 0; i < size; i++)
        a[i] = b[i] = (double)(i % 7);
    t = now();
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1, a, n, b, n, 0, c, n);
    t = now() - t;
    free(a);
    free(b);
    free(c);
    return 2e-9 * n * n * n / t;
}

/* GB/s of a = b + s c, n doubles, far beyond the caches. */
static double triad(int n)
{
    double *a = checked(mem_doubles((size_t)n)), *b = checked(mem_doubles((size_t)n));
    double *c = checked(mem_doubles((size_t)n)), t;

    for (int i = 0; i < n; i++)
        a[i] = b[i] = c[i] = i;
    t = now();
    for (int i = 0; i < n; i++)
        a[i] = b[i] + 3 * c[i];
    t = now() - t;
    if (a[n - 1] != 4.0 * (n - 1))
        t = NAN;
    free(a);
    free(b);
    free(c);
    return 24e-9 * n / t;
}

/* Element-steps a second of SEIL2, all terms. */
static double rate(int n, double beta)
{
    static const struct motion deck = {SUPPORT_RIGHT, {0.05, 0, 0}, 9.124, {0, 0, 0}, 0,
                                       NULL,          NULL};
    const double b[6] = {0, 0, 0, 0.05, 0, 0};
    long steps = 8000000 / n;
    struct march_options o = {
        .alpha = 0.1095, .beta = beta, .dt = 0, .terms = 3, .motion = &deck, .n_motions = 1};
    struct model m;
    struct march a;
    double *V = checked(mem_doubles(6 * ((size_t)n + 1))), t;

    expect(model_new(&seil2, LAW_HOOKE, n, &m));
    o.dt = 0.9 * march_critical_step(&m);
    expect(march_new(&m, &o, &a));
    expect(model_equilibrium(&m, 3, b, V));
    expect(march_start(&a, V, NULL));
    t = now();
    for (long i = 0; i < steps; i++) {
        expect(march_solve(&a));
        march_advance(&a);
    }
    t = now() - t;
    march_free(&a);
    model_free(&m);
    free(V);
    return (double)steps * n / t;
}

/* Element-steps a second of SEIL2 in eight lanes, each with a frequency of its own. */
static double lanes_rate(int n, double beta, int width)
{
    struct motion deck[LANES];
    const double b[6] = {0, 0, 0, 0.05, 0, 0};
    long steps = 4000000 / n;
    struct march_options o = {.alpha = 0.1095, .beta = beta, .terms = 3, .n_motions = 1};
    struct model m;
    struct lanes p;
    double *V, t;

    expect(model_new(&seil2, LAW_HOOKE, n, &m));
    expect(lanes_new(&m, 3, beta > 0, 1, &p));
    V = checked(model_vector(&m));
    expect(model_equilibrium(&m, 3, b, V));
    o.dt = 0.9 * march_critical_step(&m);
    for (int i = 0; i < LANES; i++) {
        struct march a;

        deck[i] = (struct motion){.amplitude = {0.05, 0, 0}, .omega = 9.124 + 0.01 * i};
        o.motion = &deck[i];
        expect(march_new(&m, &o, &a));
        expect(march_start(&a, V, NULL));
        lanes_put(&p, i, &a);
        march_free(&a);
    }
    t = now();
    for (long i = 0; i < steps; i++) {
        if (i % 20 == 0)
            for (int k = 0; k < LANES; k++)
                lanes_tune(&p, k);
        lanes_step_by(&p, width);
    }
    t = now() - t;
    for (int i = 0; i < LANES; i++)
        if (lanes_negative(&p.bad, i))
            expect(SW_DIVERGED);
    lanes_free(&p);
    model_free(&m);
    free(V);
    return (double)steps * LANES * n / t;
}

static double ensemble_rate(int n)
{
    return lanes_rate(n, 3.5e-3, lanes_width());
}

static double ensemble_mass_rate(int n)
{
    return lanes_rate(n, 0, lanes_width());
}

static double ensemble_rate_avx2(int n)
{
    return lanes_rate(n, 3.5e-3, 4);
}

static double ensemble_mass_rate_avx2(int n)
{
    return lanes_rate(n, 0, 4);
}

/* Microseconds of an implicit step of SEIL2, 1/50 of the excitation's period. */
static double implicit_time(int n)
{
    static const struct motion deck = {.amplitude = {0.05, 0, 0}, .omega = 9.124};
    const double b[6] = {0, 0, 0, 0.05, 0, 0};
    int steps = 40000 / n;
    struct march_options o = {.alpha = 0.1095,
                              .beta = 3.5e-3,
                              .scheme = SCHEME_ALPHA,
                              .interval = 2 * PI / 9.124 / 50,
                              .substeps = 1,
                              .radius = 0.8,
                              .terms = 3,
                              .motion = &deck,
                              .n_motions = 1};
    struct model m;
    struct march a;
    double *V, t;

    expect(model_new(&seil2, LAW_HOOKE, n, &m));
    expect(march_new(&m, &o, &a));
    V = checked(model_vector(&m));
    expect(model_equilibrium(&m, 3, b, V));
    expect(march_start(&a, V, NULL));
    t = now();
    for (int i = 0; i < steps; i++) {
        expect(march_solve(&a));
        expect(march_advance(&a));
    }
    t = now() - t;
    march_free(&a);
    model_free(&m);
    free(V);
    return 1e6 * t / steps;
}

static double march_rate(int n)
{
    return rate(n, 3.5e-3);
}

static double mass_rate(int n)
{
    return rate(n, 0);
}

/* Microseconds of one static line: cables from taut to slack. */
static double line_time(int n)
{
    double t = now();

    for (int i = 0; i < n; i++) {
        double x = (double)i / n;
        struct cable c = {96 + 40 * x * x, 2, 1e5 + 1e7 * (1 - x), 9.81, 100, 80 * x - 40};
        struct line s;

        if (c.L0 < 100)
            c.EA = 1e6;
        expect(line_solve(&c, &s));
    }
    return 1e6 * (now() - t) / n;
}

/* Milliseconds of all modes of PONT. */
static double modes_time(int n)
{
    double t = now();
    struct model m;
    struct modes p;

    expect(model_new(&pont, LAW_HOOKE, n, &m));
    expect(modes_lowest(&m, 6 * n, SOLVER_DENSE, &p));
    modes_free(&p);
    model_free(&m);
    return 1e3 * (now() - t);
}

/* Seconds of the 20 lowest modes of PONT, by Lanczos with its Sturm count. */
static double lanczos_time(int n)
{
    double t = now();
    struct model m;
    struct modes p;

    expect(model_new(&pont, LAW_HOOKE, n, &m));
    expect(modes_lowest(&m, 20, SOLVER_LANCZOS, &p));
    if (p.counted < 20 || fabs(p.omega[0] - 7.828663161) > 1e-8)
        expect(SW_NOCONV);
    modes_free(&p);
    model_free(&m);
    return now() - t;
}

/* Seconds of a map of SEIL2 between ratios 0.4 and 1.2, in one thread. */
static double map_time(const struct map_task *t, int elements, int count, int s, double sideways)
{
    static const int mode[12] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    struct model m;
    struct modes p;
    struct map map;
    double *ratio = checked(mem_doubles((size_t)count)), start;
    struct map_rows *rows = checked(mem_zeroed((size_t)count, sizeof *rows));

    expect(model_new(&seil2, LAW_HOOKE, elements, &m));
    expect(modes_lowest(&m, 12, SOLVER_AUTO, &p));
    start = now();
    expect(map_new(&m, &p, mode, s, 0.1095, 3.5e-3, &map));
    map.alpha = 0.1095;
    map.beta = 3.5e-3;
    map.reference = p.omega[0];
    map.theory = THEORY_INDIFFERENCE;
    map.b[3] = 1;
    map.b[5] = sideways;
    for (int i = 0; i < count; i++)
        ratio[i] = 0.4 + 0.8 * i / (count - 1);
    map_rows(&map, t, ratio, count, 1, rows);
    start = now() - start;
    for (int i = 0; i < count; i++) {
        expect(rows[i].status);
        map_rows_free(&rows[i]);
    }
    free(rows);
    free(ratio);
    map_free(&map);
    modes_free(&p);
    model_free(&m);
    return start;
}

static double bolotin_time(int sideways)
{
    static const struct map_task t = {.harmonics = 9, .to = 1};

    return map_time(&t, 10, 1000, 8, sideways);
}

static double fine_time(int elements)
{
    static const struct map_task t = {.harmonics = 9, .to = 1};

    return map_time(&t, elements, 1000, 8, 0);
}

static double floquet_time(int modes)
{
    int side = modes == 12 ? 100 : 200;
    const struct map_task t = {.floquet = 1, .to = 0.1, .step = 0.1 / (side - 1)};

    return map_time(&t, 10, side, modes, 0);
}

#define TABLE "seilwerk-bench.csv"

static double random_unit(uint64_t *u)
{
    *u ^= *u << 13;
    *u ^= *u >> 7;
    *u ^= *u << 17;
    return (double)(*u >> 11) * 0x1p-53;
}

/* A cable as a row. */
static void print_cable(FILE *f, uint64_t *u)
{
    double x[3];

    for (int j = 0; j < 3; j++)
        x[j] = random_unit(u);
    fprintf(f, "%.3f,%.3f,%.4f,%.2f,%.4g\n", 50 + 200 * x[0], 80 * x[1] - 40,
            hypot(50 + 200 * x[0], 80 * x[1] - 40) * (0.999 + 0.05 * x[2]), 1 + 50 * x[1],
            1e7 + 1e9 * x[2]);
}

/* A lift with a spreader as a row. */
static void print_lift(FILE *f, uint64_t *u)
{
    double x[3];

    for (int j = 0; j < 3; j++)
        x[j] = random_unit(u);
    fprintf(f, "primary-secondary,%.3f,%.3f,%.3f,%.2f,%.2f,%.2f,%.1f\n", 2 + 6 * x[0], 2 + 8 * x[1],
            4 * x[2], 30 + 30 * x[0], 10 * x[1] - 5, 10 * x[2], 20 + 200 * x[0]);
}

/* Rows a second, reading and printing included, of a command on a file of n random rows. */
static double filter_rate(int n, const char *run, const char *header,
                          void (*print)(FILE *, uint64_t *))
{
    const char *dir = getenv("TMPDIR");
    char path[512], command[700];
    uint64_t u = 88172645463325252ULL;
    double t;
    FILE *f;

    snprintf(path, sizeof path, "%s/%d-" TABLE, dir ? dir : "/tmp", (int)getpid());
    f = checked(fopen(path, "w"));
    fputs(header, f);
    for (int i = 0; i < n; i++)
        print(f, &u);
    fclose(f);
    snprintf(command, sizeof command, "%s -o /dev/null '%s'", run, path);
    t = now();
    if (system(command) != 0)
        expect(SW_NOCONV);
    t = now() - t;
    remove(path);
    return n / t;
}

/* Seconds of diffverf --points on so many threads: 256 points of SEIL2 for 60 s each. */
static double points_time(int threads)
{
    static const char text[] = "[cable]\nunstressed_length = 100.429\nmass_per_length = 0.704\n"
                               "axial_stiffness = 13191488\n[supports]\nspan = 100.534\n"
                               "[mesh]\nelements = 10\n[damping]\nalpha = 0.1095\n"
                               "beta = 3.5e-3\n[motion]\namplitude = 0.05 0 0\nomega = 9.124\n"
                               "[time]\nend = 60\n[steady]\ntolerance = 1e-12\n";
    const char *dir = getenv("TMPDIR");
    char path[2][512], command[2048];
    double t;
    FILE *f;

    for (int i = 0; i < 2; i++)
        snprintf(path[i], sizeof path[i], "%s/%d-seilwerk-%s", dir ? dir : "/tmp", (int)getpid(),
                 i ? "points.csv" : "case.ini");
    f = checked(fopen(path[0], "w"));
    fputs(text, f);
    fclose(f);
    f = checked(fopen(path[1], "w"));
    fputs("motion.omega,motion.amplitude\n", f);
    for (int i = 0; i < 256; i++)
        fprintf(f, "%g,%g 0 0\n", 9 + 0.02 * (i % 16), 0.04 + 0.001 * (i / 16));
    fclose(f);
    snprintf(command, sizeof command, "diffverf -q --threads %d --points '%s' '%s' >/dev/null",
             threads, path[1], path[0]);
    t = now();
    if (system(command) != 0)
        expect(SW_NOCONV);
    t = now() - t;
    remove(path[0]);
    remove(path[1]);
    return t;
}

static double table_rate(int n)
{
    return filter_rate(n, "catenary --table",
                       "span,drop,unstressed_length,mass_per_length,axial_stiffness\n",
                       print_cable);
}

static double lift_rate(int n)
{
    return filter_rate(n, "sling", "type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t\n",
                       print_lift);
}

static double exact_rate(int n)
{
    return filter_rate(n, "sling --exact",
                       "type,v_m,s_m,z_m,phi_deg,gamma_deg,m_spreader_t,m_load_t\n", print_lift);
}

static struct rope steel(double length)
{
    return (struct rope){.law = {.EA = 1e6}, .L0 = length, .q = {0, 0, -1}};
}

/* Seconds of a net of side x side meshes, 2 % longer than its frame, under its own weight, from
 * nothing; two straight elements a rope. */
static double mesh_time(int side)
{
    int n = (side + 1) * (side + 1), m = 0;
    struct net net = {.n = n,
                      .node = checked(mem_zeroed((size_t)n, sizeof *net.node)),
                      .rope = checked(mem_zeroed(2 * (size_t)n, sizeof *net.rope))};
    struct net_options o = {.tolerance = 5e-10, .steps = 1000};
    struct net_state s;
    double t;

    for (int i = 0; i < n; i++) {
        int x = i % (side + 1), y = i / (side + 1);
        int edge = x == 0 || y == 0 || x == side || y == side;

        net.node[i] = edge ? (struct net_node){.held = 7, .x = {x, y, 0}}
                           : (struct net_node){.x = {NAN, NAN, NAN}};
        for (int d = 0; d < 2; d++) {
            if ((d == 0 ? x : y) == side)
                continue;
            net.rope[m] =
                (struct net_rope){.a = i, .b = i + (d ? side + 1 : 1), .rope = steel(1.02)};
            net.rope[m++].rope.elements = 2;
        }
    }
    net.m = m;
    t = now();
    expect(net_solve(&net, &o, &s));
    t = now() - t;
    net_state_free(&s);
    free(net.node);
    free(net.rope);
    return t;
}

/* Milliseconds of nine lines with three free nodes: a ring of three, two anchors each. */
static double mooring_time(int count)
{
    struct net_node node[9];
    struct net_rope rope[9];
    struct net net = {.n = 9, .m = 9, .node = node, .rope = rope};
    struct net_options o = {.tolerance = 5e-10, .steps = 1000};
    double t = now();

    for (int k = 0; k < count; k++) {
        struct net_state s;

        for (int i = 0; i < 9; i++) {
            double angle = 2 * PI * i / 6;
            int corner = i / 2;

            if (i < 6)
                node[i] =
                    (struct net_node){.held = 7, .x = {100 * cos(angle), 100 * sin(angle), 0}};
            else
                node[i] = (struct net_node){.x = {NAN, NAN, NAN}, .force = {0, 0, 400}};
            rope[i] = i < 6 ? (struct net_rope){.a = i, .b = 6 + corner, .rope = steel(110)}
                            : (struct net_rope){.a = i, .b = i < 8 ? i + 1 : 6, .rope = steel(50)};
        }
        expect(net_solve(&net, &o, &s));
        net_state_free(&s);
    }
    return 1e3 * (now() - t) / count;
}

/* Milliseconds of a chain of 410 m in 50 m of water: in closed form, or in a current of 1 m/s in
 * 100 elements. */
static double chain_time(int flows)
{
    const double z = 0, u = flows ? -1 : 0, v = 0, w = 9.80665 * (390 - 1025 * PI / 4 * 0.0635);
    struct sea sea = {.bed = {.kind = BED_PLANE, .level = -50}, .current = {flows, &z, &u, &v}};
    struct net_node node[2] = {{.held = 7, .x = {400, 0, -50}}, {.held = 7}};
    struct net_rope rope[1] = {{.a = 0,
                                .b = 1,
                                .rope = {.law = {.EA = 1.674e9}, .L0 = 410, .q = {0, 0, -w}},
                                .across = 1025 * 1.37 * 0.252 / 2,
                                .along = 1025 * 0.64 * PI * 0.252 / 2}};
    struct net net = {.n = 2, .m = 1, .node = node, .rope = rope, .sea = &sea};
    struct net_options o = {.tolerance = 5e-10, .steps = 1000, .split = 100};
    int count = flows ? 20 : 2000;
    double t = now();

    for (int k = 0; k < count; k++) {
        struct net_state s;

        expect(net_solve(&net, &o, &s));
        net_state_free(&s);
    }
    return 1e3 * (now() - t) / count;
}

/* Seconds of one load step with five iterations of a wire of n elements on supports, 100 elements a
 * span, pushed across by an eighth of a span at each of its middles. */
static double wire_time(int n)
{
    struct section section = {
        .shape = SECTION_VALUES, .E = 1, .G = 1, .area = 1e4, .Ixx = 1, .Iyy = 1, .It = 1};
    struct frame f = {.n = n + 1,
                      .beams = n,
                      .stages = 1,
                      .node = checked(mem_zeroed((size_t)n + 1, sizeof *f.node)),
                      .beam = checked(mem_zeroed((size_t)n, sizeof *f.beam)),
                      .load = checked(mem_zeroed((size_t)n / 100 + 1, sizeof *f.load))};
    const struct follow_options o = {
        .tolerance = 1e-10, .parts = 1, .steps = 1, .iterations = 20, .watch = -1};
    struct frame_state s;
    struct frame_work w;
    struct follow_path path;
    double t;

    expect(section_complete(&section, 0));
    for (int i = 0; i <= n; i++)
        f.node[i] = (struct frame_node){.x = {0.01 * i}, .held = i == 0 ? 15 : i % 100 ? 0 : 6};
    t = now();
    for (int i = 0; i < n; i++) {
        struct frame_beam *b = &f.beam[i];
        struct bow bow;

        b->a = i;
        b->b = i + 1;
        b->section = &section;
        bow_axes((const double[]){1, 0, 0}, b->A[0]);
        bow_axes((const double[]){1, 0, 0}, b->A[1]);
        bow_between(f.node[i].x, f.node[i + 1].x, b->A[0], b->A[1], 0, 0, &bow);
        expect(beam_new(&bow, &section, &b->beam));
        if (i % 100 == 50)
            f.load[f.loads++] = (struct frame_load){.node = i,
                                                    .beam = -1,
                                                    .value = {0, i / 100 % 2 ? -12 : 12},
                                                    .stage = 1};
    }
    expect(frame_state_new(&f, &s));
    expect(frame_work_new(&f, &w));
    expect(follow(&f, &o, &s, &w, &path));
    t = now() - t;
    if (path.n != 2 || !(path.step[1].residual <= 1e-10))
        expect(SW_NOCONV);
    t *= 5.0 / path.step[1].iterations;
    follow_path_free(&path);
    frame_work_free(&w);
    frame_state_free(&s);
    free(f.node);
    free(f.beam);
    free(f.load);
    return t;
}

/* Milliseconds of gapnet as a whole process: a deck of nine lines, three floats between anchors and
 * a vessel. */
static double process_time(int count)
{
    char name[] = "/tmp/seilwerk-bench-XXXXXX", command[100];
    int fd = mkstemp(name);
    FILE *f = fd >= 0 ? fdopen(fd, "w") : NULL;
    double t;

    if (!f) {
        perror(name);
        exit(1);
    }
    fputs("--- LINE TYPES ---\nName Diam Mass EA BA EI Cd Ca CdAx CaAx\n(-)\n"
          "rope 0.15 25 30e6 -1 0 1 1 0 0\n--- POINTS ---\nID Type X Y Z M V CdA Ca\n(-)\n",
          f);
    for (int i = 0; i < 3; i++) {
        double c = cos(2 * PI * i / 3), s = sin(2 * PI * i / 3);

        fprintf(f, "%d Fixed %g %g -100 0 0 0 0\n", 4 * i + 1, 200 * c, 200 * s);
        fprintf(f, "%d Free %g %g -40 100 2 0 0\n", 4 * i + 2, 45 * c, 45 * s);
        fprintf(f, "%d Vessel %g %g -21 0 0 0 0\n", 4 * i + 3, 8 * c - 3 * s, 8 * s + 3 * c);
        fprintf(f, "%d Vessel %g %g -21 0 0 0 0\n", 4 * i + 4, 8 * c + 3 * s, 8 * s - 3 * c);
    }
    fputs("--- LINES ---\nID Type A B Length Segs Out\n(-)\n", f);
    for (int i = 0; i < 3; i++)
        fprintf(f, "%d rope %d %d 168 10 -\n%d rope %d %d 45 4 -\n%d rope %d %d 45 4 -\n",
                3 * i + 1, 4 * i + 1, 4 * i + 2, 3 * i + 2, 4 * i + 2, 4 * i + 3, 3 * i + 3,
                4 * i + 2, 4 * i + 4);
    fputs("--- OPTIONS ---\n100 WtrDpth\n--- END ---\n", f);
    if (fclose(f) != 0)
        expect(SW_WRITE);
    snprintf(command, sizeof command, "gapnet -o /dev/null %s", name);
    t = now();
    for (int k = 0; k < count; k++)
        if (system(command) != 0)
            expect(SW_NOCONV);
    t = 1e3 * (now() - t) / count;
    unlink(name);
    return t;
}

/* Nanoseconds of one printed number, random bits. */
static double print_time(int n)
{
    uint64_t u = 88172645463325252ULL;
    size_t length = 0;
    double t = now();

    for (int i = 0; i < n; i++) {
        char text[NUMBER_SIZE];
        double x;

        u ^= u << 13;
        u ^= u >> 7;
        u ^= u << 17;
        memcpy(&x, &u, sizeof x);
        length += number_print(x, text);
    }
    t = now() - t;
    return length > 0 ? 1e9 * t / n : NAN;
}

/* One line; target 0: none.  A rate shall be above its target, a time below. */
static void report(const char *what, double x, const char *unit, double target, int is_rate)
{
    printf("%-44s %10.4g %-8s", what, x, unit);
    if (target > 0)
        printf(" target %10.4g  %s", target,
               (is_rate ? x >= target : x <= target) ? "met" : "MISSED");
    putchar('\n');
}

int main(void)
{
    static const int meshes[] = {10, 100, 1000, 100000}, sizes[] = {10, 100, 400};
    static const int large[] = {1000, 10000, 100000};
    static const double wanted_ms[] = {1, 50, 1500};
    double speed, scale, one;
    char what[64];
    struct rusage usage;

    print_time(1000);
    speed = median(dgemm, 1000);
    scale = speed / REFERENCE;
    printf("targets are for %.0f GF/s of dgemm, scaled by %.2f\n", REFERENCE, scale);
    report("dgemm, n = 1000", speed, "GF/s", 0, 1);
    report("static line: cables solved", 1e6 / median(line_time, 200000), "1/s", 1e6 * scale, 1);
    report("catenary --table: rows read and printed", median(table_rate, 200000), "1/s",
           1e5 * scale, 1);
    report("sling: rows read and printed", median(lift_rate, 200000), "1/s", 1e5 * scale, 1);
    report("sling --exact: rows", median(exact_rate, 200), "1/s", 0, 1);
    report("number printed", median(print_time, 1000000), "ns", 150 / scale, 0);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        snprintf(what, sizeof what, "modal, all modes, n = %d", sizes[i]);
        report(what, median(modes_time, sizes[i]), "ms", wanted_ms[i] / scale, 0);
    }
    getrusage(RUSAGE_SELF, &usage);
    report("memory for this", (double)usage.ru_maxrss / 1024, "MB", 300, 0);
    for (size_t i = 0; i < sizeof large / sizeof *large; i++) {
        snprintf(what, sizeof what, "modal --modes 20, n = %d", large[i]);
        report(what, median(lanczos_time, large[i]), "s", large[i] == 100000 ? 4 / scale : 0, 0);
    }
    getrusage(RUSAGE_SELF, &usage);
    report("memory for this", (double)usage.ru_maxrss / 1024, "MB", 1500, 0);
    for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++) {
        snprintf(what, sizeof what, "diffverf, all terms, beta > 0, n = %d", meshes[i]);
        report(what, median(march_rate, meshes[i]), "el-st/s", 6e6 * scale, 1);
    }
    for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++) {
        snprintf(what, sizeof what, "diffverf, all terms, beta = 0, n = %d", meshes[i]);
        report(what, median(mass_rate, meshes[i]), "el-st/s", 1.2e7 * scale, 1);
    }
    for (int n = 10; n <= 100; n *= 10) {
        snprintf(what, sizeof what, "ensemble in lanes, beta > 0, n = %d", n);
        report(what, median(ensemble_rate, n), "el-st/s",
               (lanes_width() == 8 ? 3.5e7 : 1.75e7) * scale, 1);
        snprintf(what, sizeof what, "ensemble in lanes, beta = 0, n = %d", n);
        report(what, median(ensemble_mass_rate, n), "el-st/s",
               (lanes_width() == 8 ? 6e7 : 3e7) * scale, 1);
    }
    if (lanes_width() == 8) {
        report("the same with AVX2 only, beta > 0, n = 10", median(ensemble_rate_avx2, 10),
               "el-st/s", 1.75e7 * scale, 1);
        report("the same with AVX2 only, beta = 0, n = 10", median(ensemble_mass_rate_avx2, 10),
               "el-st/s", 3e7 * scale, 1);
    }
    report("diffverf --points, 256 x 60 s, one thread", one = median(points_time, 1), "s", 0, 0);
    report("  speed-up by a second thread", one / median(points_time, 2), "", 2 / 1.5, 1);
    report("implicit step, n = 20", median(implicit_time, 20), "us", 580.0 / 20 / scale, 0);
    report("implicit step, n = 100", median(implicit_time, 100), "us", 2650.0 / 20 / scale, 0);
    report("stabil, 1000 frequencies, 8 modes", median(bolotin_time, 0), "s", 3 / scale, 0);
    report("stabil, the same, skew motion", median(bolotin_time, 1), "s", 6 / scale, 0);
    report("stabil, 1000 frequencies, n = 1000", median(fine_time, 1000), "s", 0, 0);
    report("stabil, Floquet 100 x 100, 12 modes", median(floquet_time, 12), "s", 3 / scale, 0);
    report("stabil, Floquet 200 x 200, 4 modes", median(floquet_time, 4), "s", 3 / scale, 0);
    report("gapnet, nine lines, three free nodes", median(mooring_time, 200), "ms", 1 / scale, 0);
    report("the same from a deck, a whole process", median(process_time, 20), "ms", 10 / scale, 0);
    report("gapnet, a chain on the bed", median(chain_time, 0), "ms", 0, 0);
    report("gapnet, a chain on the bed in a current", median(chain_time, 1), "ms", 100 / scale, 0);
    report("gapnet, net of 300 x 300 meshes", mesh_time(300), "s", 30 / scale, 0);
    for (int n = 1000; n <= 100000; n *= 10) {
        snprintf(what, sizeof what, "wirebeam, five iterations, n = %d", n);
        report(what, median(wire_time, n), "s", n == 10000 ? 2 / scale : 0, 0);
    }
    report("triad, 3 x 160 MB", median(triad, 20000000), "GB/s", 0, 1);
    return 0;
}
