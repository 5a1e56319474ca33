/* Cross sections of wires. */
#include "phys/section.h"
#include "num/jacobi.h"
#include "num/pi.h"

#include <math.h>
#include <string.h>

#define ODD_FIFTH 1.0045237627951384 /* 1 + 1/3^5 + 1/5^5 + ... = 31/32 zeta(5) */

/*
 * Long side a, short side b:  It = a b^3 [1/3 - (64/pi^5) (b/a) sum tanh(k pi a/2b)/k^5],
 * largest stress in the middle of the long side, (G twist) b [1 - (8/pi^2) sum 1/(k^2 cosh(k pi
 * a/2b))], k odd.  1 - tanh and 1/cosh are nothing from k = 25 on.
 */
double section_rectangle_torsion(double width, double height, double *ret_Wt)
{
    double a = fmax(width, height), b = fmin(width, height), sum = ODD_FIFTH, top = 0, It;

    for (int k = 1; k < 25; k += 2) {
        double x = fmin(k * PI * a / (2 * b), 300);

        sum -= 2 / ((exp(2 * x) + 1) * pow(k, 5));
        top += 1 / ((double)k * k * cosh(x));
    }
    It = a * pow(b, 3) * (1.0 / 3 - 64 / pow(PI, 5) * (b / a) * sum);
    if (ret_Wt)
        *ret_Wt = It / (b * (1 - 8 / (PI * PI) * top));
    return It;
}

static void measure_tube(struct section *s, double inner)
{
    double D = s->diameter, fourth = pow(D, 4) - pow(inner, 4);

    s->area = PI / 4 * (D - inner) * (D + inner);
    s->Ixx = s->Iyy = PI / 64 * fourth;
    s->It = PI / 32 * fourth;
    s->ex = s->ey = D / 2;
    s->Wt = PI / 16 * fourth / D;
}

static void measure(struct section *s)
{
    switch (s->shape) {
    case SECTION_ROUND: measure_tube(s, 0); break;
    case SECTION_TUBE: measure_tube(s, s->diameter - 2 * s->wall); break;
    case SECTION_RECTANGLE:
        s->area = s->width * s->height;
        s->Ixx = s->width * pow(s->height, 3) / 12;
        s->Iyy = s->height * pow(s->width, 3) / 12;
        s->It = section_rectangle_torsion(s->width, s->height, &s->Wt);
        s->ex = s->width / 2;
        s->ey = s->height / 2;
        break;
    default: break;
    }
}

/* H = stiffness^-1, scaled to a unit diagonal first: EA and EI are of different units. */
static enum status invert(struct section *s)
{
    double A[16], scale[4];

    for (int i = 0; i < 4; i++) {
        if (!(s->stiffness[5 * i] > 0))
            return SW_INDEFINITE;
        scale[i] = 1 / sqrt(s->stiffness[5 * i]);
    }
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++)
            A[i + 4 * j] = scale[i] * s->stiffness[i + 4 * j] * scale[j];
    if (cholesky_factor(4, A, 1e-12) != SW_OK)
        return SW_INDEFINITE;
    for (int j = 0; j < 4; j++) {
        double x[4] = {0};

        x[j] = scale[j];
        cholesky_forward(4, A, x);
        cholesky_backward(4, A, x);
        for (int i = 0; i < 4; i++)
            s->flexibility[i + 4 * j] = scale[i] * x[i];
    }
    return SW_OK;
}

enum status section_complete(struct section *s, double density)
{
    if (s->shape != SECTION_GENERAL) {
        measure(s);
        memset(s->stiffness, 0, sizeof s->stiffness);
        s->stiffness[0] = s->E * s->area;
        s->stiffness[5] = s->E * s->Ixx;
        s->stiffness[10] = s->E * s->Iyy;
        s->stiffness[15] = s->G * s->It;
        s->mass = density * s->area;
        s->inertia[0] = density * s->Ixx;
        s->inertia[1] = density * s->Iyy;
        s->inertia[2] = density * (s->Ixx + s->Iyy);
    }
    return invert(s);
}

struct section_stress section_stresses(const struct section *s, const double force[4])
{
    struct section_stress t = {.axial = force[0] / s->area, .shear = fabs(force[3]) / s->Wt};

    if (s->shape == SECTION_ROUND || s->shape == SECTION_TUBE)
        t.bending = hypot(force[1], force[2]) * s->ex / s->Ixx;
    else
        t.bending = fabs(force[1]) * s->ey / s->Ixx + fabs(force[2]) * s->ex / s->Iyy;
    t.most = fabs(t.axial) + t.bending;
    t.mises = sqrt(t.most * t.most + 3 * t.shear * t.shear);
    return t;
}
