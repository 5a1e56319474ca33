/* Frames when memory runs out, each request in turn, CHOLMOD's too: paths by load and by arc,
 * linear theory, the document's iteration, vibrations. */
#include "fails.h"
#include "rod.h"

#include "phys/updated.h"
#include "phys/vibrate.h"

#define N 5

static void line(double u, double x[3], double A[9])
{
    const double along_x[9] = {0, 1, 0, 0, 0, 1, 1, 0, 0};

    x[0] = u;
    x[1] = x[2] = 0;
    memcpy(A, along_x, sizeof along_x);
}

/* A shallow arch, clamped at both ends. */
static void arch(double u, double x[3], double A[9])
{
    double a = 0.8 * (u - 0.5), c = cos(a), s = sin(a);
    const double frame[9] = {-s, c, 0, 0, 0, 1, c, s, 0};

    x[0] = s;
    x[1] = c;
    x[2] = 0;
    for (int i = 0; i < 9; i++)
        A[i] = frame[i];
    A[0] = -s;
    A[1] = -c;
    A[6] = c;
    A[7] = -s;
    vec3_cross(A + 6, A, A + 3);
}

enum way { BY_LOAD, BY_ARC, LINEAR, UPDATED, VIBRATE };

struct task {
    struct rod p;
    enum way way;
    struct follow_options o;
};

/* From the natural state on; a path is what it is without faults, or there is none. */
static enum status walk(void *context)
{
    struct task *k = context;
    struct rod *p = &k->p;
    enum status s = frame_state_new(&p->f, &p->s);
    double lambda[2], shape[2 * 6 * (N + 1)];
    int failed;

    if (s != SW_OK)
        assert_null(p->s.x);
    p->w = (struct frame_work){.dof = NULL};
    p->path = (struct follow_path){.step = NULL};
    if (s == SW_OK) {
        s = frame_work_new(&p->f, &p->w);
        if (s != SW_OK)
            assert_null(p->w.dof);
    }
    if (s == SW_OK) {
        switch (k->way) {
        case LINEAR: s = follow_linear(&p->f, &p->s, &p->w, &failed); break;
        case UPDATED: s = updated(&p->f, &k->o, &p->s, &p->w, &p->path); break;
        case VIBRATE:
            frame_evaluate(&p->f, &p->s, FRAME_STILL, &p->w);
            s = vibrate(&p->f, &p->s, &p->w, 2, lambda, shape);
            if (s == SW_OK)
                assert_true(lambda[0] > 0 && lambda[1] >= lambda[0]);
            break;
        default: s = follow(&p->f, &k->o, &p->s, &p->w, &p->path);
        }
        if (s == SW_OK && k->way != VIBRATE) {
            near_abs(p->s.t, 1, 1e-9);
            assert_true(p->w.force > 0);
            if (k->way != LINEAR)
                below(p->path.step[p->path.n - 1].residual, k->o.tolerance);
        }
    }
    follow_path_free(&p->path);
    frame_work_free(&p->w);
    frame_state_free(&p->s);
    return s;
}

/* A cantilever with moments that grow along it. */
static void cantilever(struct task *k, enum way way)
{
    *k = (struct task){.way = way, .o = rod_options(2)};
    k->o.watch = N;
    if (way == UPDATED) { /* which converges slowly */
        k->o.tolerance = 1e-6;
        k->o.iterations = 100;
        k->o.parts = 16;
    }
    rod_new(&k->p, N, rod_section(100, 1, 1, 1), line);
    for (int i = 1; i <= N; i++)
        rod_load(&k->p, i, 1, (double[6]){0, 0.01, 0, 0, 0, 0.02 * i});
}

static void requests(void **state)
{
    (void)state;
    for (int way = BY_LOAD; way <= VIBRATE; way++)
        for (int library = 0; library < 2; library++) {
            struct task k;

            cantilever(&k, (enum way)way);
            if (way == BY_ARC) {
                rod_free(&k.p);
                rod_new(&k.p, N, rod_section(1e4, 1, 1, 1), arch);
                k.p.f.node[N].held = 63;
                rod_load(&k.p, 2, 1, (double[6]){0, -1, 0});
                k.o.arc = 1;
            }
            print_message("way %d %d\n", way, library);
            assert_true((library ? fails_each_of_cholmod : fails_each)(walk, &k) > 15);
            rod_free(&k.p);
        }
}

TEST_MAIN(cmocka_unit_test(requests))
