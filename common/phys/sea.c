/* The bed and the current. */
#include "phys/sea.h"

#include <math.h>

/* Interval of the ascending list (n >= 2) in which value lies, and where in it, 0..1; *ret_out:
 * beyond the ends. */
static int interval(const double *list, int n, double value, double *ret_part, int *ret_out)
{
    int low = 0, high = n - 1;

    while (high - low > 1) {
        int middle = low + (high - low) / 2;

        if (list[middle] <= value)
            low = middle;
        else
            high = middle;
    }
    *ret_part = (value - list[low]) / (list[low + 1] - list[low]);
    *ret_out = !(*ret_part >= 0 && *ret_part <= 1);
    *ret_part = fmin(fmax(*ret_part, 0), 1);
    return low;
}

static double grid_at(const struct bed *b, double x, double y, double gradient[2])
{
    double p, q, dx, dy, z00, z10, z01, z11;
    int out_x, out_y, i = interval(b->x, b->nx, x, &p, &out_x);
    int j = interval(b->y, b->ny, y, &q, &out_y);
    const double *z = b->z + i + (long)b->nx * j;

    dx = b->x[i + 1] - b->x[i];
    dy = b->y[j + 1] - b->y[j];
    z00 = z[0];
    z10 = z[1];
    z01 = z[b->nx];
    z11 = z[b->nx + 1];
    if (gradient) {
        gradient[0] = out_x ? 0 : ((1 - q) * (z10 - z00) + q * (z11 - z01)) / dx;
        gradient[1] = out_y ? 0 : ((1 - p) * (z01 - z00) + p * (z11 - z10)) / dy;
    }
    return (1 - q) * ((1 - p) * z00 + p * z10) + q * ((1 - p) * z01 + p * z11);
}

double bed_at(const struct bed *b, double x, double y, double gradient[2])
{
    if (b->kind == BED_GRID)
        return grid_at(b, x, y, gradient);
    if (gradient) {
        gradient[0] = b->kind == BED_PLANE ? b->slope[0] : 0;
        gradient[1] = b->kind == BED_PLANE ? b->slope[1] : 0;
    }
    return b->kind == BED_PLANE ? b->level + b->slope[0] * x + b->slope[1] * y : -INFINITY;
}

void current_at(const struct current *c, double z, double U[3], double slope[3])
{
    double part = 0, rise = 0;
    int out = 1, i = c->n > 1 ? interval(c->z, c->n, z, &part, &out) : 0,
        next = c->n > 1 ? i + 1 : i;

    if (!out)
        rise = 1 / (c->z[i + 1] - c->z[i]);
    U[0] = c->n > 0 ? (1 - part) * c->u[i] + part * c->u[next] : 0;
    U[1] = c->n > 0 ? (1 - part) * c->v[i] + part * c->v[next] : 0;
    U[2] = 0;
    if (!slope)
        return;
    slope[0] = c->n > 0 ? rise * (c->u[next] - c->u[i]) : 0;
    slope[1] = c->n > 0 ? rise * (c->v[next] - c->v[i]) : 0;
    slope[2] = 0;
}

void sea_drag(double across, double along, double l, const double c[3], const double U[3],
              double ret[3])
{
    double Ut = U[0] * c[0] + U[1] * c[1] + U[2] * c[2], n[3], Un;

    for (int i = 0; i < 3; i++)
        n[i] = U[i] - Ut * c[i];
    Un = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int i = 0; i < 3; i++)
        ret[i] = l * (across * Un * n[i] + along * fabs(Ut) * Ut * c[i]);
}

/* With n = U - Ut c, Ut = U.c: d(|n| n) = |n| dn + n (n.dn)/|n|, dn = dU - (c.dU) c - (U.dc) c - Ut
 * dc, d(|Ut| Ut c) = 2 |Ut| (c.dU + U.dc) c + |Ut| Ut dc. */
void sea_drag_change(double across, double along, double l, const double c[3], const double U[3],
                     double by_c[9], double by_U[9])
{
    double Ut = U[0] * c[0] + U[1] * c[1] + U[2] * c[2], n[3], Un;

    for (int i = 0; i < 3; i++)
        n[i] = U[i] - Ut * c[i];
    Un = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int j = 0; j < 3; j++) {
        double nc = 0, nU = 0, dc[3], dU[3];

        for (int i = 0; i < 3; i++) {
            dc[i] = -U[j] * c[i] - Ut * (i == j);
            dU[i] = (i == j) - c[j] * c[i];
            nc += Un > 0 ? n[i] * dc[i] / Un : 0;
            nU += Un > 0 ? n[i] * dU[i] / Un : 0;
        }
        for (int i = 0; i < 3; i++) {
            by_c[3 * i + j] = l * (across * (Un * dc[i] + nc * n[i]) +
                                   along * fabs(Ut) * (2 * U[j] * c[i] + Ut * (i == j)));
            by_U[3 * i + j] =
                l * (across * (Un * dU[i] + nU * n[i]) + along * 2 * fabs(Ut) * c[j] * c[i]);
        }
    }
}
