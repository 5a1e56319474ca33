/* Small vibrations of frames. */
#include "phys/vibrate.h"
#include "num/mem.h"
#include "num/pi.h"
#include "num/subspace.h"

#include <stdlib.h>
#include <string.h>

/* The mass of beam i by its unknowns, on the curve that its ends have now. */
static enum status mass_of(const struct frame *f, const struct frame_state *s, int i, double *M)
{
    const struct frame_beam *b = &f->beam[i];
    static const double nothing[12] = {0};
    struct bow bow;
    struct beam now;
    double A[2][9], dense[144], force[HINGED_MOST], axis[2][3][3], q[4];

    frame_ends(f, s, i, A[0], A[1]);
    if (!(bow_between(s->x + 3 * b->a, s->x + 3 * b->b, A[0], A[1],
                      b->beam.bow.psi[1] - b->beam.bow.psi[0], b->beam.bow.bulge, &bow) < PI / 2) ||
        beam_new(&bow, b->section, &now) != SW_OK)
        return SW_INDEFINITE;
    beam_mass(&now, b->section, dense);
    for (int k = 0; k < 144; k++) /* the mass is that of the natural length */
        dense[k] *= b->beam.length / now.length;
    hinge_end(&b->hinge[0], &s->hinge[2 * i], s->q + 4 * b->a, q, axis[0]);
    hinge_end(&b->hinge[1], &s->hinge[2 * i + 1], s->q + 4 * b->b, q, axis[1]);
    hinge_expand(b->hinge, axis, nothing, dense, force, M);
    return SW_OK;
}

enum status vibrate_mass(const struct frame *f, const struct frame_state *s,
                         const struct frame_work *w, double *M)
{
    size_t at = 0;

    memset(M, 0, w->K.entries * sizeof *M);
    for (int i = 0; i < f->beams; i++) {
        double block[HINGED_MOST * HINGED_MOST];
        int n = 12 + f->beam[i].hinge[0].n + f->beam[i].hinge[1].n;
        enum status status = mass_of(f, s, i, block);

        if (status != SW_OK)
            return status;
        for (int c = 0; c < n; c++)
            for (int r = c; r < n; r++, at++)
                if (w->at[at] >= 0)
                    M[w->at[at]] += block[r + n * c];
    }
    return SW_OK;
}

enum status vibrate(const struct frame *f, const struct frame_state *s, struct frame_work *w, int k,
                    double *lambda, double *shape)
{
    size_t n = (size_t)w->unknowns;
    double *M = mem_doubles(w->K.entries), *x = mem_doubles(n * (size_t)k);
    enum status status = M && x ? vibrate_mass(f, s, w, M) : SW_NOMEM;

    if (status == SW_OK)
        status = subspace_lowest(&w->K, M, k, lambda, x);
    for (int j = 0; j < k && status == SW_OK; j++)
        for (int i = 0; i < 6 * f->n; i++) {
            int unknown = w->dof[i];

            shape[(size_t)(6 * f->n) * (size_t)j + (size_t)i] =
                unknown >= 0 ? x[n * (size_t)j + (size_t)unknown] : 0;
        }
    free(M);
    free(x);
    return status;
}
