/* Hinges. */
#include "phys/hinge.h"
#include "num/quat.h"
#include "num/vec3.h"

void hinge_end(const struct hinge *h, const struct hinge_state *s, const double node[4],
               double ret_end[4], double ret_axis[3][3])
{
    memcpy(ret_end, h->n == 3 ? s->q : node, 4 * sizeof *ret_end);
    memset(ret_axis, 0, 9 * sizeof(double));
    if (h->n == 3) {
        for (int j = 0; j < 3; j++)
            ret_axis[j][j] = 1;
        return;
    }
    for (int j = 0; j < h->n; j++) {
        double R[9], v[3], q[4];

        quat_matrix(ret_end, R);
        mat3_apply(R, h->axis[j], ret_axis[j]);
        memcpy(v, h->axis[j], sizeof v);
        vec3_scale(s->angle[j], v);
        quat_exp(v, q);
        quat_multiply(ret_end, q, ret_end);
    }
}

void hinge_move(const struct hinge *h, const double *dx, struct hinge_state *s)
{
    double q[4];

    if (h->n == 3) {
        quat_exp(dx, q);
        quat_multiply(q, s->q, s->q);
        quat_normalize(s->q);
    } else {
        for (int j = 0; j < h->n; j++)
            s->angle[j] += dx[j];
    }
}

/* Displacements and spins of the ends by the unknowns, T (12, n). */
static int lay(const struct hinge *h, double axis[2][3][3], double *T)
{
    int n = 12 + h[0].n + h[1].n, column = 12;

    memset(T, 0, (size_t)(12 * n) * sizeof *T);
    for (int i = 0; i < 12; i++)
        T[i + 12 * i] = i % 6 >= 3 && h[i / 6].n == 3 ? 0 : 1;
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < h[end].n; j++, column++)
            memcpy(T + 12 * column + 6 * end + 3, axis[end][j], 3 * sizeof *T);
    return n;
}

void hinge_ends(const struct hinge *h, double axis[2][3][3], const double *du, double ret[12])
{
    double T[12 * HINGED_MOST];
    int n = lay(h, axis, T);

    for (int i = 0; i < 12; i++) {
        ret[i] = 0;
        for (int j = 0; j < n; j++)
            ret[i] += T[i + 12 * j] * du[j];
    }
}

static void add_pair(double *K, int n, int i, int j, double x)
{
    K[i + n * j] += x;
    K[j + n * i] += x;
}

/* What the axes' turning brings: -M x a/2 of node and hinge, M.(a1 x a2)/2 of two axes. */
static void turn_axes(const struct hinge *h, double axis[3][3], const double M[3], int node,
                      int first, int n, double *K)
{
    double cross[3];

    if (h->n == 3)
        return;
    for (int j = 0; j < h->n; j++) {
        vec3_cross(M, axis[j], cross);
        for (int i = 0; i < 3; i++)
            add_pair(K, n, node + i, first + j, -cross[i] / 2);
    }
    if (h->n == 2) {
        vec3_cross(axis[0], axis[1], cross);
        add_pair(K, n, first, first + 1, vec3_dot(M, cross) / 2);
    }
}

int hinge_expand(const struct hinge *h, double axis[2][3][3], const double f[12],
                 const double K[144], double *ret_f, double *ret_K)
{
    double T[12 * HINGED_MOST], KT[12 * HINGED_MOST];
    int n = lay(h, axis, T);

    for (int j = 0; j < n; j++) {
        ret_f[j] = 0;
        for (int i = 0; i < 12; i++) {
            ret_f[j] += T[i + 12 * j] * f[i];
            KT[i + 12 * j] = 0;
            for (int l = 0; l < 12; l++)
                KT[i + 12 * j] += K[i + 12 * l] * T[l + 12 * j];
        }
    }
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            ret_K[i + n * j] = 0;
            for (int l = 0; l < 12; l++)
                ret_K[i + n * j] += T[l + 12 * i] * KT[l + 12 * j];
        }
    turn_axes(&h[0], axis[0], f + 3, 3, 12, n, ret_K);
    turn_axes(&h[1], axis[1], f + 9, 9, 12 + h[0].n, n, ret_K);
    return n;
}
