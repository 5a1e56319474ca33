/* Dampers: exact flexibility, residual modes, complex eigenproblem. */
#include "phys/damper.h"
#include "num/dense.h"
#include "num/mem.h"
#include "num/root.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Places of the dampers along the cable, ascending, each once; at[i] is that of damper i. */
static int sort_places(const struct damper *d, int n, double *place, int *at)
{
    int count = 0;

    for (int i = 0; i < n; i++) {
        int j = count;

        for (int k = 0; k < count; k++)
            if (place[k] == d[i].position)
                j = -1;
        for (; j > 0 && place[j - 1] > d[i].position; j--)
            place[j] = place[j - 1];
        if (j >= 0) {
            place[j] = d[i].position;
            count++;
        }
    }
    for (int i = 0; i < n; i++)
        for (int k = 0; k < count; k++)
            if (place[k] == d[i].position)
                at[i] = k;
    return count;
}

/* Stiffness of the points at the places, the supports held: pieces of line between them. */
static void add_pieces(const struct line *s, const double *place, int count, double *K)
{
    int order = 3 * count;

    for (int p = 0; p <= count; p++) {
        double L0 = s->cable.L0, k[9];
        struct line piece;

        line_piece(s, p > 0 ? place[p - 1] * L0 : 0, p < count ? place[p] * L0 : L0, &piece);
        line_stiffness(&piece, k);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                if (p < count)
                    K[3 * p + i + order * (3 * p + j)] += k[3 * i + j];
                if (p > 0)
                    K[3 * p - 3 + i + order * (3 * p - 3 + j)] += k[3 * i + j];
                if (p > 0 && p < count) {
                    K[3 * p + i + order * (3 * p - 3 + j)] -= k[3 * i + j];
                    K[3 * p - 3 + i + order * (3 * p + j)] -= k[3 * i + j];
                }
            }
    }
}

void damper_direction(const struct damper *d, const struct axes *axes, double ret[3])
{
    const double *x = d->direction;
    double size = hypot(hypot(x[0], x[1]), x[2]);
    const double unit[3] = {x[0] / size, x[1] / size, x[2] / size};

    axes_to_plane(axes, unit, ret);
}

enum status damper_flexibility(const struct line *s, const struct axes *axes,
                               const struct damper *d, int n, double *ret)
{
    double *place = mem_doubles((size_t)n), *K = mem_doubles(9 * (size_t)n * (size_t)n);
    int *at = mem_zeroed((size_t)n, sizeof *at), count;
    enum status status = SW_NOMEM;

    if (place && K && at) {
        count = sort_places(d, n, place, at);
        add_pieces(s, place, count, K);
        status = dense_invert(3 * count, K);
        for (int i = 0; i < n && status == SW_OK; i++)
            for (int j = 0; j < n; j++) {
                const double *block = K + 3 * at[i] + 3 * count * 3 * at[j];
                double u[3], v[3], sum = 0;

                damper_direction(&d[i], axes, u);
                damper_direction(&d[j], axes, v);
                for (int a = 0; a < 3; a++)
                    for (int b = 0; b < 3; b++)
                        sum += u[a] * block[a + 3 * count * b] * v[b];
                ret[i + n * j] = sum;
            }
    }
    free(place);
    free(K);
    free(at);
    return status;
}

static double dot(int n, const double *x, const double *y)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* ret (r, r) = psi_i^T M psi_j of the mesh's static deflections psi_i under unit forces at the
 * dampers. */
static enum status static_mass(const struct model *m, const struct damper *d, int r, double *ret)
{
    int n = 6 * m->n;
    size_t size = (size_t)n;
    struct band K = {0}, M = {0};
    struct partition k = {.support = NULL}, mass = {.support = NULL};
    struct band_factor F = {0};
    double *b = model_vector(m), *psi = mem_doubles(size * (size_t)r), *M_psi = mem_doubles(size);
    int *keep = mem_zeroed(size, sizeof *keep);
    enum status s = b && psi && M_psi && keep ? model_stiffness(m, PART_ALL, &K) : SW_NOMEM;

    if (s == SW_OK)
        s = model_mass(m, PART_ALL, &M);
    if (s == SW_OK)
        s = model_partition(m, &K, &k);
    if (s == SW_OK)
        s = model_partition(m, &M, &mass);
    if (s == SW_OK)
        s = band_cholesky(&k.free, &F);
    if (s == SW_OK)
        model_free_unknowns(m, PART_ALL, keep);
    for (int j = 0; j < r && s == SW_OK; j++) {
        double direction[3];

        damper_direction(&d[j], &m->axes, direction);
        model_point_load(m, d[j].position, direction, b);
        for (size_t i = 0; i < size; i++)
            psi[i + size * (size_t)j] = b[keep[i]];
        band_solve(&F, psi + size * (size_t)j);
        memset(M_psi, 0, sizeof *M_psi * size);
        band_multiply_add(&mass.free, 1, psi + size * (size_t)j, M_psi);
        for (int i = 0; i <= j; i++)
            ret[i + r * j] = ret[j + r * i] = dot(n, psi + size * (size_t)i, M_psi);
    }
    band_free(&K);
    band_free(&M);
    partition_free(&k);
    partition_free(&mass);
    band_factor_free(&F);
    free(b);
    free(psi);
    free(M_psi);
    free(keep);
    return s;
}

/*
 * Residual modes from flexibility R and its square by mass S, both (r, r), that the modes lack:
 * sum phi phi^T/omega^2 = R, sum phi phi^T/omega^4 = S over the new ones.  With R = U L U^T they
 * are the eigenvectors of L^{-1/2} U^T S U L^{-1/2}, whose eigenvalues are 1/omega^2.  Directions
 * in which less than 1e-9 of the whole flexibility is missing bring none; no frequency lies above
 * omega_max.
 */
static enum status add_residuals(double *R, double *S, double whole, double omega_max,
                                 struct damper_basis *b)
{
    int r = b->dampers, kept = 0;
    double *L = mem_doubles((size_t)r), *Q = mem_doubles((size_t)r * (size_t)r);
    double *square = mem_doubles((size_t)r);
    enum status s = L && Q && square ? dense_symmetric(r, R, L) : SW_NOMEM;

    for (int i = 0; i < r && s == SW_OK; i++)
        if (L[i] > 1e-9 * whole) { /* column kept of R becomes U L^{1/2} */
            for (int a = 0; a < r; a++)
                R[a + r * kept] = R[a + r * i] * sqrt(L[i]);
            L[kept++] = L[i];
        }
    for (int i = 0; i < kept && s == SW_OK; i++)
        for (int j = 0; j < kept; j++) {
            double sum = 0;

            for (int a = 0; a < r; a++)
                for (int c = 0; c < r; c++)
                    sum += R[a + r * i] * S[a + r * c] * R[c + r * j];
            Q[i + kept * j] = sum / (L[i] * L[j]);
        }
    if (s == SW_OK && kept > 0)
        s = dense_symmetric(kept, Q, square);
    for (int k = 0; k < kept && s == SW_OK; k++) {
        double omega = 1 / sqrt(fmax(square[k], 1 / (omega_max * omega_max)));

        b->omega[b->modes + k] = omega;
        for (int a = 0; a < r; a++) {
            double sum = 0;

            for (int i = 0; i < kept; i++)
                sum += R[a + r * i] * Q[i + kept * k];
            b->value[b->modes + k + (b->modes + r) * a] = sum * omega;
        }
    }
    b->n = b->modes + kept;
    free(L);
    free(Q);
    free(square);
    return s;
}

/* Values of the modes at the dampers; column j begins at j times modes + dampers. */
static void take_values(const struct model *m, const struct modes *p, const struct damper *d,
                        struct damper_basis *b, double *V)
{
    for (int k = 0; k < b->modes; k++) {
        b->omega[k] = p->omega[k];
        modes_shape(m, p, k, V);
        for (int j = 0; j < b->dampers; j++) {
            double v[3], x[3], unit[3];

            model_probe(m, d[j].position, V, v, NULL);
            axes_to_plane(&m->axes, v, x);
            damper_direction(&d[j], &m->axes, unit);
            b->value[k + (b->modes + b->dampers) * j] = dot(3, x, unit);
        }
    }
}

/* R and S less what the modes bring. */
static void subtract_modes(const struct damper_basis *b, double *R, double *S)
{
    int r = b->dampers, rows = b->modes + r;

    for (int i = 0; i < r; i++)
        for (int j = 0; j < r; j++)
            for (int k = 0; k < b->modes; k++) {
                double square = b->omega[k] * b->omega[k];
                double part = b->value[k + rows * i] * b->value[k + rows * j] / square;

                R[i + r * j] -= part;
                S[i + r * j] -= part / square;
            }
}

enum status damper_basis_new(const struct model *m, const struct modes *p, const struct damper *d,
                             int n_dampers, struct damper_basis *ret)
{
    size_t r = (size_t)n_dampers, rows = (size_t)p->k + r;
    double *V = model_vector(m), *R = mem_doubles(r * r), *S = mem_doubles(r * r), whole = 0;
    enum status s = V && R && S ? SW_OK : SW_NOMEM;

    *ret = (struct damper_basis){.modes = p->k, .n = p->k, .dampers = n_dampers};
    ret->omega = mem_doubles(rows);
    ret->value = mem_doubles(rows * r);
    ret->decay = mem_doubles((size_t)p->k);
    ret->swing = mem_doubles((size_t)p->k);
    if (!ret->omega || !ret->value || !ret->decay || !ret->swing)
        s = SW_NOMEM;
    if (s == SW_OK)
        take_values(m, p, d, ret, V);
    if (s == SW_OK && n_dampers > 0)
        s = damper_flexibility(&m->line, &m->axes, d, n_dampers, R);
    if (s == SW_OK && n_dampers > 0)
        s = static_mass(m, d, n_dampers, S);
    if (s == SW_OK && n_dampers > 0) {
        for (int i = 0; i < n_dampers; i++)
            whole = fmax(whole, R[i + n_dampers * i]);
        subtract_modes(ret, R, S);
        s = add_residuals(R, S, whole, model_omega_max(m), ret);
    }
    if (s != SW_OK)
        damper_basis_free(ret);
    free(V);
    free(R);
    free(S);
    return s;
}

void damper_basis_free(struct damper_basis *b)
{
    free(b->omega);
    free(b->value);
    free(b->decay);
    free(b->swing);
    *b = (struct damper_basis){0};
}

/* Complex modes of the first-order system in z = omega q and q': z' = omega q',
 * q'' = -omega z - C q'. */
static void fill_system(const struct damper_basis *b, double alpha, double beta,
                        const struct damper *dampers, double *A)
{
    size_t n = (size_t)b->n, order = 2 * n, rows = (size_t)(b->modes + b->dampers);

    for (size_t i = 0; i < n; i++) {
        A[i + order * (n + i)] = b->omega[i];
        A[n + i + order * i] = -b->omega[i];
        A[n + i + order * (n + i)] = -(alpha + beta * b->omega[i] * b->omega[i]);
        for (size_t j = 0; j < n; j++)
            for (size_t d = 0; d < (size_t)b->dampers; d++)
                A[n + i + order * (n + j)] -=
                    dampers[d].coefficient * b->value[i + rows * d] * b->value[j + rows * d];
    }
}

/* A complex pair or a real eigenvalue on its own. */
struct eigen {
    double re, im; /* im >= 0 */
    double *share; /* of each mode in its energy, not scaled */
};

/* How clearly eigenvalue e belongs to mode k: swinging ones before creeping ones, and of two that
 * creep alike the slower one. */
static double claim(const struct eigen *e, int k)
{
    return e->im > 0 ? 2 + e->share[k] : e->share[k] + 1e-9 / (1 - e->re);
}

/* Gives each mode the eigenvalue in which it moves most, the clearest cases first. */
static void assign(struct eigen *e, int count, struct damper_basis *b)
{
    for (int k = 0; k < b->modes; k++)
        b->decay[k] = b->swing[k] = NAN;
    for (int round = 0; round < count; round++) {
        double most = -1;
        int from = -1, to = -1;

        for (int i = 0; i < count; i++)
            for (int k = 0; k < b->modes && e[i].share; k++)
                if (isnan(b->decay[k]) && claim(&e[i], k) > most) {
                    most = claim(&e[i], k);
                    from = i;
                    to = k;
                }
        if (from < 0)
            return;
        b->decay[to] = -e[from].re;
        b->swing[to] = e[from].im;
        e[from].share = NULL;
    }
}

/* Shares of the modes in the energy of eigenvector k of x (order, order), sum 1. */
static void take_shares(const double *x, int order, int k, int pair, int modes, double *share)
{
    int n = order / 2;
    double all = 0;

    for (int i = 0; i < n; i++) {
        double sum = 0;

        for (int part = 0; part <= pair; part++)
            for (int half = 0; half < 2; half++) {
                double y = x[(size_t)(i + half * n) + (size_t)order * (size_t)(k + part)];

                sum += y * y;
            }
        all += sum;
        if (i < modes)
            share[i] = sum;
    }
    for (int i = 0; i < modes; i++)
        share[i] /= all;
}

enum status damper_solve(struct damper_basis *b, double alpha, double beta, const struct damper *d)
{
    size_t order = 2 * (size_t)b->n, modes = (size_t)b->modes;
    double *A = mem_doubles(order * order), *x = mem_doubles(order * order);
    double *re = mem_doubles(order), *im = mem_doubles(order);
    double *share = mem_doubles(order * modes);
    struct eigen *e = mem_zeroed(order, sizeof *e);
    int count = 0;
    enum status s = A && x && re && im && share && e ? SW_OK : SW_NOMEM;

    if (s == SW_OK) {
        fill_system(b, alpha, beta, d, A);
        s = dense_general((int)order, A, re, im, x);
    }
    for (size_t k = 0; k < order && s == SW_OK; k++) {
        if (im[k] < 0)
            continue;
        e[count] = (struct eigen){re[k], im[k], share + modes * (size_t)count};
        take_shares(x, (int)order, (int)k, im[k] > 0, b->modes, e[count++].share);
    }
    if (s == SW_OK)
        assign(e, count, b);
    for (int k = 0; k < b->modes; k++) /* no sign of what is round-off */
        if (fabs(b->decay[k]) < 1e-12 * hypot(b->decay[k], b->swing[k]))
            b->decay[k] = 0;
    free(A);
    free(x);
    free(re);
    free(im);
    free(share);
    free(e);
    return s;
}

double damper_ratio(const struct damper_basis *b, int k)
{
    double size = hypot(b->decay[k], b->swing[k]);

    return size > 0 ? b->decay[k] / size : b->decay[k];
}

/* What damper_best works on. */
struct search {
    struct damper_basis *b;
    double alpha, beta;
    int mode;
    struct damper *d;
    enum status status;
};

/* Minus the damping ratio for the logarithm of a coefficient. */
static double minus_ratio(double log_coefficient, void *context)
{
    struct search *f = context;

    f->d->coefficient = exp(log_coefficient);
    f->status = damper_solve(f->b, f->alpha, f->beta, f->d);
    return f->status == SW_OK ? -damper_ratio(f->b, f->mode) : NAN;
}

enum status damper_best(struct damper_basis *b, double alpha, double beta, int k, double from,
                        double to, struct damper *d)
{
    struct search f = {b, alpha, beta, k, d, SW_OK};
    double least, best = least_between(minus_ratio, &f, log(from), log(to), &least);

    d->coefficient = exp(best);
    return f.status != SW_OK ? f.status : isnan(best) ? SW_NOCONV : SW_OK;
}
