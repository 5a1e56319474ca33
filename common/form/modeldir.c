/* The model directory, written and verified. */
#include "form/modeldir.h"
#include "num/mem.h"
#include "phys/turn.h"
#include "sys/npy.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* The arrays of a directory. */
enum { MASS, STIFFNESS, MASS_U, STIFFNESS_U, MASS_R, STIFFNESS_R, DOFS, STATIC, OMEGA, MODES };
#define N_ARRAYS 10

/* clang-format off */
static const char *const array_name[N_ARRAYS] = {
    [MASS] = "mass.npy", [STIFFNESS] = "stiffness.npy",
    [MASS_U] = "mass_support.npy", [STIFFNESS_U] = "stiffness_support.npy",
    [MASS_R] = "mass_reaction.npy", [STIFFNESS_R] = "stiffness_reaction.npy",
    [DOFS] = "dofs.npy", [STATIC] = "static.npy", [OMEGA] = "omega.npy", [MODES] = "modes.npy",
};
/* clang-format on */

struct array {
    int dims;
    size_t rows, columns;
    const double *data;
};

/* The arrays that follow from the model alone, with the memory behind them. */
struct content {
    struct partition M, K;
    double *dofs, *line;
    struct array array[N_ARRAYS];
};

static void content_free(struct content *c)
{
    partition_free(&c->M);
    partition_free(&c->K);
    free(c->dofs);
    free(c->line);
}

static enum status partitions(const struct model *m, struct content *c)
{
    struct band M = {0}, K = {0};
    enum status s = model_mass(m, PART_ALL, &M);

    if (s == SW_OK)
        s = model_stiffness(m, PART_ALL, &K);
    if (s == SW_OK && !axes_are_plain(&m->axes)) {
        turn_matrix(&m->axes, &M);
        turn_matrix(&m->axes, &K);
    }
    if (s == SW_OK)
        s = model_partition(m, &M, &c->M);
    if (s == SW_OK)
        s = model_partition(m, &K, &c->K);
    band_free(&M);
    band_free(&K);
    return s;
}

static void fill_dofs(const struct model *m, double *dofs)
{
    for (int i = 0; i < 6 * m->n; i++) /* 1, 3, 5, then all of the inner nodes, then odd ones */
        dofs[i] = i < 3 ? 2 * i + 1 : i < 6 * m->n - 3 ? i + 3 : 2 * i - 6 * m->n + 7;
}

/* theta, x1, x2, x3, T-star, T at the nodes, column-major. */
static void fill_line(const struct model *m, double *line)
{
    size_t rows = (size_t)m->n + 1;

    for (size_t k = 0; k < rows; k++) {
        double theta = m->line.cable.L0 * ((double)k / m->n);
        struct line_point p;
        struct material at;
        double x[3];

        line_at(&m->line, theta, &p);
        material_at(&m->line, m->law, theta, &at);
        axes_to_space(&m->axes, (double[3]){p.x1, p.x2, 0}, x);
        line[k] = theta;
        line[k + rows] = x[0];
        line[k + 2 * rows] = x[1];
        line[k + 3 * rows] = x[2];
        line[k + 4 * rows] = p.tension;
        line[k + 5 * rows] = at.T;
    }
}

static enum status content_new(const struct model *m, struct content *c)
{
    size_t n = 6 * (size_t)m->n, nodes = (size_t)m->n + 1;
    enum status s;

    *c = (struct content){.dofs = mem_doubles(n), .line = mem_doubles(6 * nodes)};
    s = c->dofs && c->line ? partitions(m, c) : SW_NOMEM;
    if (s != SW_OK) {
        content_free(c);
        return s;
    }
    fill_dofs(m, c->dofs);
    fill_line(m, c->line);
    c->array[MASS] = (struct array){2, 12, n, c->M.free.a};
    c->array[STIFFNESS] = (struct array){2, 12, n, c->K.free.a};
    c->array[MASS_U] = (struct array){2, n, 6, c->M.support};
    c->array[STIFFNESS_U] = (struct array){2, n, 6, c->K.support};
    c->array[MASS_R] = (struct array){2, 6, 6, c->M.reaction};
    c->array[STIFFNESS_R] = (struct array){2, 6, 6, c->K.reaction};
    c->array[DOFS] = (struct array){1, n, 1, c->dofs};
    c->array[STATIC] = (struct array){2, nodes, 6, c->line};
    return SW_OK;
}

/* dir/name, to be freed; NULL: memory ran out. */
static char *join(const char *dir, const char *name)
{
    size_t size = strlen(dir) + strlen(name) + 2;
    char *path = mem_zeroed(size, 1);

    if (path)
        snprintf(path, size, "%s/%s", dir, name);
    return path;
}

static enum status write_files(struct out out[N_ARRAYS + 1], char *path[N_ARRAYS + 1],
                               const struct content *content, const struct cable_case *c,
                               struct why *why)
{
    enum status s = SW_OK;

    for (int i = 0; i <= N_ARRAYS && s == SW_OK; i++) {
        const struct array *a = &content->array[i < N_ARRAYS ? i : 0];

        s = out_open(&out[i], path[i], why);
        if (s == SW_OK && i < N_ARRAYS)
            npy_write(&out[i], a->dims, a->rows, a->columns, a->data);
        else if (s == SW_OK)
            case_print(c, &out[i]);
        if (s == SW_OK)
            s = out_finish(&out[i], why);
    }
    for (int i = 0; i <= N_ARRAYS && s == SW_OK; i++)
        s = out_rename(&out[i], why);
    return s;
}

enum status modeldir_make(const char *dir, struct why *why)
{
    if (mkdir(dir, 0777) != 0 && errno != EEXIST)
        return fail(why, SW_WRITE, "%s: cannot be made: %s", dir, strerror(errno));
    return SW_OK;
}

enum status modeldir_write(const char *dir, const struct cable_case *c, const struct model *m,
                           const struct modes *modes, struct why *why)
{
    struct content content = {.dofs = NULL};
    struct out out[N_ARRAYS + 1];
    char *path[N_ARRAYS + 1];
    size_t n = (size_t)modes->n, k = (size_t)modes->k;
    double *phi = mem_copy(modes->phi, sizeof *phi * n * k); /* in the axes of space */
    enum status s = phi ? content_new(m, &content) : SW_NOMEM;

    if (s != SW_OK) {
        free(phi);
        return fail_plain(why, s);
    }
    for (size_t i = 0; i < k && !axes_are_plain(&m->axes); i++)
        turn_free(&m->axes, TURN_TO_SPACE, m->n, phi + n * i);
    content.array[OMEGA] = (struct array){1, k, 1, modes->omega};
    content.array[MODES] = (struct array){2, n, k, phi};
    for (int i = 0; i <= N_ARRAYS; i++) {
        path[i] = join(dir, i < N_ARRAYS ? array_name[i] : "case.ini");
        if (!path[i])
            s = fail_plain(why, SW_NOMEM);
    }
    if (s == SW_OK)
        s = write_files(out, path, &content, c, why);
    for (int i = 0; i <= N_ARRAYS; i++)
        free(path[i]);
    free(phi);
    content_free(&content);
    return s;
}

static enum status read_array(const char *dir, int i, struct npy *ret, struct why *why)
{
    char *path = join(dir, array_name[i]);
    struct in in = {0};
    enum status s = path ? in_open(path, &in, why) : fail_plain(why, SW_NOMEM);

    *ret = (struct npy){0};
    if (s == SW_OK)
        s = npy_read(&in, ret, why);
    in_close(&in);
    free(path);
    return s;
}

/* Whether array i of dir equals what the model gives, within 1e-12 of its largest entry. */
static enum status compare(const char *dir, int i, const struct array *a, struct why *why)
{
    struct npy file;
    double most = 0, error = 0;
    enum status s = read_array(dir, i, &file, why);

    if (s != SW_OK)
        return s;
    if (file.rows != a->rows || file.columns != a->columns)
        s = fail(why, SW_FORMAT, "%s/%s: has %zu x %zu numbers; %zu x %zu are expected", dir,
                 array_name[i], file.rows, file.columns, a->rows, a->columns);
    for (size_t j = 0; s == SW_OK && j < a->rows * a->columns; j++) {
        double e = fabs(file.data[j] - a->data[j]);

        most = fmax(most, fabs(a->data[j]));
        if (!(e <= error) && !isnan(error))
            error = e;
    }
    if (s == SW_OK && !(error <= 1e-12 * most))
        s = fail(why, SW_FORMAT,
                 "%s/%s: is not that of this case: an entry differs by %.3g, the "
                 "largest is %.3g",
                 dir, array_name[i], error, most);
    npy_free(&file);
    return s;
}

/* A x, and the scalar product of x and y. */
static void multiply(const struct band *A, const double *x, double *ret)
{
    for (int i = 0; i < A->n; i++)
        ret[i] = 0;
    band_multiply_add(A, 1, x, ret);
}

static double dot(int n, const double *x, const double *y)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/*
 * Frequencies ascend; each mode solves K phi = omega^2 M phi within 1e-7 of the right side and the
 * round-off of K phi, has phi^T M phi = 1, and is orthogonal to the one before it, which alone
 * could be the same vector.  work: 2 n doubles.
 */
static int modes_fit(const struct content *c, const struct modes *p, double *work)
{
    const struct band *M = &c->M.free, *K = &c->K.free;
    double *Kx = work, *Mx = work + p->n, stiffest = 0;

    for (int i = 0; i < p->n; i++)
        stiffest = fmax(stiffest, *band_at(K, i, i));
    for (int k = 0; k < p->k; k++) {
        const double *x = p->phi + (size_t)p->n * (size_t)k;
        double square = p->omega[k] * p->omega[k], rest = 0, right = 0, most = 0;

        multiply(K, x, Kx);
        multiply(M, x, Mx);
        for (int i = 0; i < p->n; i++) {
            rest = fmax(rest, fabs(Kx[i] - square * Mx[i]));
            right = fmax(right, square * fabs(Mx[i]));
            most = fmax(most, fabs(x[i]));
        }
        if (!(p->omega[k] >= 0) || !(rest <= 1e-7 * right + 1e3 * DBL_EPSILON * stiffest * most) ||
            !(fabs(dot(p->n, x, Mx) - 1) <= 1e-9))
            return 0;
        if (k > 0 &&
            (!(p->omega[k] >= p->omega[k - 1]) || !(fabs(dot(p->n, x - p->n, Mx)) <= 1e-9)))
            return 0;
    }
    return 1;
}

static enum status read_modes(const char *dir, const struct model *m, const struct content *c,
                              struct modes *ret, struct why *why)
{
    struct npy omega, phi = {0};
    double *work = mem_doubles(2 * (size_t)6 * (size_t)m->n);
    enum status s = work ? read_array(dir, OMEGA, &omega, why) : fail_plain(why, SW_NOMEM);

    if (s != SW_OK) {
        free(work);
        return s;
    }
    s = read_array(dir, MODES, &phi, why);
    *ret =
        (struct modes){.n = 6 * m->n, .k = (int)phi.columns, .omega = omega.data, .phi = phi.data};
    if (s == SW_OK && (phi.rows != (size_t)ret->n || phi.columns != omega.rows ||
                       phi.columns > phi.rows || omega.columns != 1))
        s = fail(why, SW_FORMAT, "%s: omega.npy and modes.npy do not fit the mesh or each other",
                 dir);
    if (s == SW_OK && !modes_fit(c, ret, work))
        s = fail(why, SW_FORMAT, "%s: omega.npy and modes.npy are not modes of its matrices", dir);
    for (int i = 0; i < ret->k && s == SW_OK && !axes_are_plain(&m->axes); i++)
        turn_free(&m->axes, TURN_TO_PLANE, m->n, ret->phi + (size_t)ret->n * (size_t)i);
    if (s != SW_OK)
        modes_free(ret);
    free(work);
    return s;
}

enum status modeldir_read(const char *dir, const struct cable_case *c, const struct model *m,
                          struct modes *ret, struct why *why)
{
    struct cable_case *stored = mem_zeroed(1, sizeof *stored);
    char *path = join(dir, "case.ini");
    struct content content;
    const char *differs = NULL;
    enum status s = SW_NOMEM;

    *ret = (struct modes){0};
    if (stored && path)
        s = case_load(path, NULL, stored, why);
    else
        fail_plain(why, s);
    if (s == SW_OK)
        differs = case_model_difference(c, stored);
    if (differs)
        s = fail(why, SW_FORMAT, "%s: is the model of another case: %s differs", dir, differs);
    if (stored)
        case_free(stored);
    free(stored);
    free(path);
    if (s != SW_OK)
        return s;
    s = content_new(m, &content);
    if (s != SW_OK)
        return fail_plain(why, s);
    for (int i = 0; i < OMEGA && s == SW_OK; i++)
        s = compare(dir, i, &content.array[i], why);
    if (s == SW_OK)
        s = read_modes(dir, m, &content, ret, why);
    content_free(&content);
    return s;
}
