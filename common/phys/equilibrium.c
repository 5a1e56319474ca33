/* Nonlinear static equilibrium of the model for moved supports. */
#include "num/mem.h"
#include "phys/forcing.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#define MAX_STEPS 200

/*
 * First guess: nodes and slopes from the exact static line between the moved supports, which hangs
 * in the vertical plane through them (ret), minus those of the model's own line.
 */
static enum status guess(const struct model *m, const double b[6], double *V, struct line *ret)
{
    struct cable moved = m->line.cable;
    double across = b[5] - b[2], along = moved.span + b[3] - b[0], cosine, sine;
    enum status s;

    moved.span = hypot(along, across);
    moved.drop += b[4] - b[1];
    cosine = along / moved.span;
    sine = across / moved.span;
    s = line_solve(&moved, ret);
    for (int k = 0; s == SW_OK && k <= m->n; k++) {
        double theta = m->line.cable.L0 * ((double)k / m->n), *v = V + 6 * (size_t)k;
        struct line_point p, p0;
        struct material d, d0;

        line_at(ret, theta, &p);
        line_at(&m->line, theta, &p0);
        material_at(ret, LAW_HOOKE, theta, &d);
        material_at(&m->line, LAW_HOOKE, theta, &d0);
        v[0] = b[0] + cosine * p.x1 - p0.x1;
        v[1] = cosine * d.x1 - d0.x1;
        v[2] = b[1] + p.x2 - p0.x2;
        v[3] = d.x2 - d0.x2;
        v[4] = b[2] + sine * p.x1;
        v[5] = sine * d.x1;
    }
    return s;
}

/* What the iteration works on; vectors over all nodes but d, which holds free unknowns. */
struct iteration {
    const struct model *m;
    const struct forcing *forcing; /* or NULL */
    int terms, n_free;
    int *keep;     /* numbers of the free unknowns */
    double *V, *F; /* state, and internal forces less those from outside */
    double *d;     /* step */
};

static void forces(struct iteration *it)
{
    model_force(it->m, it->terms, it->V, it->F, NULL);
    if (it->forcing)
        forcing_subtract(it->m, it->forcing, 0, it->V, NULL, it->F);
}

/* d = K_t^{-1} F for the free unknowns, with the tangent kept definite or not. */
static enum status solve_step(struct iteration *it, int definite)
{
    struct band K = {0}, K_free = {0};
    struct band_factor factor = {0};
    enum status s = model_tangent(it->m, it->terms, definite, it->V, &K);

    if (s == SW_OK)
        s = band_restrict(&K, it->keep, it->n_free, &K_free);
    if (s == SW_OK)
        s = band_cholesky(&K_free, &factor);
    if (s == SW_OK) {
        for (int i = 0; i < it->n_free; i++)
            it->d[i] = it->F[it->keep[i]];
        band_solve(&factor, it->d);
    }
    band_free(&K);
    band_free(&K_free);
    band_factor_free(&factor);
    return s;
}

/* Largest free force; slopes' entries are forces times the length of an element. */
static double residual(const struct iteration *it)
{
    double most = 0;

    for (int i = 0; i < it->n_free; i++) {
        double force = fabs(it->F[it->keep[i]]) / (it->keep[i] % 2 == 1 ? it->m->h : 1);

        if (!(force <= most))
            most = force;
    }
    return most;
}

static double along_step(const struct iteration *it)
{
    double sum = 0;

    for (int i = 0; i < it->n_free; i++)
        sum += it->F[it->keep[i]] * it->d[i];
    return sum;
}

static void move(struct iteration *it, double f)
{
    for (int i = 0; i < it->n_free; i++)
        it->V[it->keep[i]] -= f * it->d[i];
    forces(it);
}

/*
 * Newton step, halved while neither the residual nor the force along the step falls.  Where the
 * tangent is not positive definite, the one that is kept so gives the direction.
 */
static enum status step(struct iteration *it)
{
    double before = residual(it), along;
    enum status s = solve_step(it, 0);

    if (s == SW_INDEFINITE)
        s = solve_step(it, 1);
    if (s != SW_OK)
        return s;
    along = along_step(it);
    move(it, 1);
    /* NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter,cert-flp30-c): halves are exact */
    for (double f = 0.5; f > 1e-3; f /= 2) {
        if (residual(it) < before || fabs(along_step(it)) < 0.9 * along)
            break;
        move(it, -f); /* back by half of what was gone */
    }
    return SW_OK;
}

/* Residual that counts as zero: 1e-10 of the largest end force, before or after the motion, and the
 * round-off of internal forces, EA epsilon times the slopes. */
static double tolerance(const struct iteration *it, const struct line *moved)
{
    const struct line *line = &it->m->line;
    double force = 0, slope = 0;

    for (int i = 0; i < 2; i++, line = moved)
        force = fmax(force, hypot(line->H, fmax(fabs(line->V), fabs(line->W - line->V))));
    for (size_t i = 1; i < model_unknowns(it->m); i += 2)
        slope = fmax(slope, fabs(it->V[i]));
    return 1e-10 * force + 64 * DBL_EPSILON * it->m->line.cable.EA * slope * (1 + slope);
}

static enum status iterate(struct iteration *it, const struct line *moved)
{
    double limit = tolerance(it, moved);
    enum status s = SW_OK;

    forces(it);
    for (int i = 0; i < MAX_STEPS && s == SW_OK && !(residual(it) <= limit); i++)
        s = step(it);
    if (s != SW_OK || !(residual(it) <= limit))
        return s != SW_OK ? s : SW_NOCONV;
    /* 1e-10 of the force may still be 1e-6 of a small displacement: one more step squares it. */
    s = step(it);
    return s == SW_OK && !(residual(it) <= limit) ? SW_NOCONV : s;
}

enum status model_equilibrium(const struct model *m, int terms, const double b[6], double *V)
{
    return forcing_equilibrium(m, NULL, terms, b, V);
}

enum status forcing_equilibrium(const struct model *m, const struct forcing *f, int terms,
                                const double b[6], double *V)
{
    size_t n_all = model_unknowns(m);
    double *work = mem_doubles(2 * n_all);
    int *keep = mem_zeroed(n_all, sizeof *keep), held[6];
    struct iteration it = {m, f, terms, 6 * m->n, keep, V, work, work + n_all};
    struct line moved = m->line;
    enum status s = work && keep ? SW_OK : SW_NOMEM;

    for (size_t i = 0; i < n_all; i++)
        V[i] = 0;
    if (s == SW_OK && terms > 0)
        s = guess(m, b, V, &moved);
    if (s == SW_OK) {
        model_free_unknowns(m, PART_ALL, keep);
        model_prescribed(m, held);
        for (int i = 0; i < 6; i++)
            V[held[i]] = b[i];
        s = iterate(&it, &moved);
    }
    free(work);
    free(keep);
    return s;
}
