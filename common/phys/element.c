/* Hermite cable element: material, mass, internal force, tangent. */
#include "phys/element.h"

#include <math.h>

const double gauss_at[GAUSS] = {0.046910077030668003601, 0.23076534494715845448, 0.5,
                                0.76923465505284154552, 0.953089922969331996399};
const double gauss_weight[GAUSS] = {0.118463442528094543757, 0.239314335249683234021,
                                    0.284444444444444444444, 0.239314335249683234021,
                                    0.118463442528094543757};

void material_at(const struct line *s, enum law law, double theta, struct material *ret)
{
    double EA = s->cable.EA;
    struct line_point p;

    line_at(s, theta, &p);
    ret->stretch = p.stretch;
    ret->tension = p.tension;
    ret->EA = EA;
    ret->T = p.tension / p.stretch;
    ret->x1 = s->H / p.tension * p.stretch;
    ret->x2 = p.V / p.tension * p.stretch;
    if (law == LAW_HOOKE)
        ret->EA = EA / (p.stretch * p.stretch * p.stretch);
    if (law == LAW_PRINTED) { /* (A.109) differentiated as printed */
        ret->T = p.tension;
        ret->x1 = s->H / p.tension + s->H / EA;
        ret->x2 = p.V / p.tension + (s->V - s->W / 2) / EA;
    }
}

double material_tension(const struct material *m, double gamma)
{
    double static_force = m->tension / m->stretch, force = static_force + m->EA * gamma;

    return force * sqrt(fmax(0, m->stretch * m->stretch + 2 * gamma));
}

double material_tension_rate(const struct material *m)
{
    return m->EA * m->stretch + m->tension / (m->stretch * m->stretch);
}

void hermite(double h, double xi, double f[4], double f1[4])
{
    double eta = 1 - xi;

    f[0] = eta * eta * (1 + 2 * xi);
    f[1] = h * xi * eta * eta;
    f[2] = xi * xi * (1 + 2 * eta);
    f[3] = -h * xi * xi * eta;
    f1[0] = -6 * xi * eta / h;
    f1[1] = eta * (1 - 3 * xi);
    f1[2] = 6 * xi * eta / h;
    f1[3] = xi * (3 * xi - 2);
}

void element_mass(double mu, double h, double ret[16])
{
    double s = mu * h / 420;
    /* clang-format off */
    const double m[16] = {
        156,      22 * h,      54,       -13 * h,
        22 * h,   4 * h * h,   13 * h,   -3 * h * h,
        54,       13 * h,      156,      -22 * h,
        -13 * h,  -3 * h * h,  -22 * h,  4 * h * h,
    };
    /* clang-format on */

    for (int i = 0; i < 16; i++)
        ret[i] = s * m[i];
}

/* w = v,1 of the three components. */
static inline void slopes(const double f1[4], const double v[12], double w[3])
{
    for (int c = 0; c < 3; c++)
        w[c] =
            f1[0] * v[2 * c] + f1[1] * v[2 * c + 1] + f1[2] * v[2 * c + 6] + f1[3] * v[2 * c + 7];
}

static inline void watch_point(struct strain_watch *watch, const struct material *m, int point,
                               double gamma)
{
    double force = m->EA * gamma + m->T;
    double a2 = m->stretch * m->stretch;
    double stiffened = 3 * m->EA * gamma / (m->EA * a2 + m->T);

    if (!(force >= watch->least_force)) {
        watch->least_force = force;
        watch->least_point = point;
    }
    if (!(stiffened <= watch->most_stiffened))
        watch->most_stiffened = stiffened;
}

void element_force(const struct element *e, int terms, const double v[12], double F[12],
                   struct strain_watch *watch)
{
    double t1 = terms >= 1, t2 = terms >= 2, t3 = terms >= 3;

    for (int q = 0; q < GAUSS; q++) {
        const struct material *m = &e->m[q];
        double w[3], n[3], along, half_square, S, Sx;

        slopes(e->slope[q], v, w);
        along = m->x1 * w[0] + m->x2 * w[1];
        half_square = (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / 2;
        if (watch)
            watch_point(watch, m, e->first + q, along + half_square);
        /* force density EA [x'.w + (w.w)/2] x' + {T + EA [x'.w + (w.w)/2]} w, by parts */
        S = gauss_weight[q] * e->h * (m->T + m->EA * (t1 * along + t3 * half_square));
        Sx = gauss_weight[q] * e->h * m->EA * (along + t2 * half_square);
        n[0] = S * w[0] + Sx * m->x1;
        n[1] = S * w[1] + Sx * m->x2;
        n[2] = S * w[2];
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 2; k++) {
                F[2 * c + k] += e->slope[q][k] * n[c];
                F[2 * c + k + 6] += e->slope[q][k + 2] * n[c];
            }
    }
}

double element_potential(const struct element *e, int terms, const double v[12])
{
    double t2 = terms >= 2, t3 = terms >= 3, sum = 0;

    for (int q = 0; q < GAUSS; q++) {
        const struct material *m = &e->m[q];
        double w[3], along, half_square;

        slopes(e->slope[q], v, w);
        along = m->x1 * w[0] + m->x2 * w[1];
        half_square = (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / 2;
        sum += gauss_weight[q] *
               (m->T * half_square + m->EA * (along * along / 2 + t2 * along * half_square +
                                              t3 * half_square * half_square / 2));
    }
    return sum * e->h;
}

double element_strain_energy(const struct element *e, const double v[12])
{
    double sum = 0;

    for (int q = 0; q < GAUSS; q++) {
        const struct material *m = &e->m[q];
        const double *f1 = e->slope[q];
        double w[3], along;

        for (int c = 0; c < 3; c++) /* f1[0] = -f1[2]: the difference of the ends first */
            w[c] = f1[2] * (v[2 * c + 6] - v[2 * c]) + f1[1] * v[2 * c + 1] + f1[3] * v[2 * c + 7];
        along = m->x1 * w[0] + m->x2 * w[1];
        sum += gauss_weight[q] *
               (m->EA * along * along + m->T * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    }
    return sum * e->h;
}

double element_product(const double mass[16], const double v[12], const double w[12])
{
    double sum = 0;

    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++)
                sum +=
                    mass[i + 4 * j] * v[i / 2 * 6 + 2 * c + i % 2] * w[j / 2 * 6 + 2 * c + j % 2];
    return sum;
}

/* 3x3 tangent of the force density by w at one point, symmetric. */
static void density_tangent(const struct material *m, int terms, int definite, const double w[3],
                            double ret[9])
{
    double nonlinear = terms >= 1 || definite, cubic = terms >= 3 || definite;
    const double x[3] = {m->x1, m->x2, 0};
    double along = x[0] * w[0] + x[1] * w[1];
    double half_square = (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / 2;
    double diagonal = m->T + m->EA * (nonlinear * along + cubic * half_square);

    if (definite && diagonal < m->T)
        diagonal = m->T;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            ret[3 * i + j] = (i == j) * diagonal +
                             m->EA * (x[i] * x[j] + nonlinear * (x[i] * w[j] + w[i] * x[j]) +
                                      cubic * w[i] * w[j]);
}

void element_tangent(const struct element *e, int terms, int definite, const double v[12],
                     double ret[144])
{
    for (int i = 0; i < 144; i++)
        ret[i] = 0;
    for (int q = 0; q < GAUSS; q++) {
        const double *f1 = e->slope[q];
        double w[3], D[9];

        slopes(f1, v, w);
        density_tangent(&e->m[q], terms, definite, w, D);
        for (int j = 0; j < 12; j++)
            for (int i = 0; i < 12; i++) {
                int ci = i % 6 / 2, cj = j % 6 / 2;
                double fi = f1[i / 6 * 2 + i % 2], fj = f1[j / 6 * 2 + j % 2];

                ret[i + 12 * j] += gauss_weight[q] * e->h * D[3 * ci + cj] * fi * fj;
            }
    }
}
