/* The path of one point of the cable. */
#include "phys/orbit.h"

#include <math.h>

#define THIN 0.05 /* ratio of the axes from which a path counts as round */
#define SLANT 0.1 /* tangent of the angle up to which a line counts as along an axis */

void orbit_add(struct orbit_window *w, double phi, const double v[3], double tension)
{
    double c1 = cos(phi / 2), s1 = sin(phi / 2), c = c1, s = s1;

    if (w->n++ == 0) {
        w->tension = tension;
        for (int i = 0; i < 3; i++)
            w->least[i] = w->greatest[i] = v[i];
    }
    w->tension = fmax(w->tension, tension);
    for (int i = 0; i < 3; i++) {
        w->least[i] = fmin(w->least[i], v[i]);
        w->greatest[i] = fmax(w->greatest[i], v[i]);
        w->sum[i] += v[i];
    }
    for (int k = 0; k < ORBIT_ORDERS; k++) {
        double next = c * c1 - s * s1;

        for (int i = 0; i < 3; i++) {
            w->c[k][i] += c * v[i];
            w->s[k][i] += s * v[i];
        }
        s = s * c1 + c * s1;
        c = next;
    }
}

/* Ellipse of (x2, x3) = (c2, c3) cos + (s2, s3) sin: the squares of the half axes are the
 * eigenvalues of [a b; b d], their product is its determinant. */
static void ellipse(const double c[3], const double s[3], struct orbit *o)
{
    double a = c[1] * c[1] + s[1] * s[1], d = c[2] * c[2] + s[2] * s[2];
    double b = c[1] * c[2] + s[1] * s[2], area = c[1] * s[2] - s[1] * c[2];
    double radius = hypot((a - d) / 2, b);

    o->major = sqrt((a + d) / 2 + radius);
    o->minor = o->major > 0 ? fabs(area) / o->major : 0;
    o->tilt = radius > 0 ? atan2(2 * b, a - d) / 2 : 0;
    if (!(o->major > 0))
        o->plane = o->amplitude[0] > 0 ? ORBIT_IN : ORBIT_REST;
    else if (o->minor >= THIN * o->major)
        o->plane = area > 0 ? ORBIT_WHIRL_RIGHT : ORBIT_WHIRL_LEFT;
    else if (fabs(tan(o->tilt)) <= SLANT)
        o->plane = ORBIT_IN;
    else
        o->plane = fabs(tan(o->tilt)) >= 1 / SLANT ? ORBIT_LATERAL : ORBIT_INCLINED;
}

void orbit_of(const struct orbit_window *w, struct orbit *ret)
{
    double c[ORBIT_ORDERS][3], s[ORBIT_ORDERS][3], most = 0;

    *ret = (struct orbit){.tension = w->tension};
    for (int i = 0; i < 3; i++) {
        ret->least[i] = w->least[i];
        ret->greatest[i] = w->greatest[i];
        ret->amplitude[i] = (w->greatest[i] - w->least[i]) / 2;
        ret->mean[i] = w->sum[i] / w->n;
    }
    for (int k = 0; k < ORBIT_ORDERS; k++) {
        double size = 0;

        for (int i = 0; i < 3; i++) {
            c[k][i] = 2 * w->c[k][i] / w->n;
            s[k][i] = 2 * w->s[k][i] / w->n;
            ret->harmonic[k][i] = hypot(c[k][i], s[k][i]);
            ret->phase[k][i] = atan2(-s[k][i], c[k][i]);
            size += i > 0 ? ret->harmonic[k][i] * ret->harmonic[k][i] : 0;
        }
        if (size > most) {
            most = size;
            ret->order = k + 1;
        }
    }
    if (ret->order > 0)
        ellipse(c[ret->order - 1], s[ret->order - 1], ret);
    else
        ret->plane = ret->amplitude[0] > 0 ? ORBIT_IN : ORBIT_REST;
}

const char *orbit_plane_name(enum orbit_plane plane)
{
    static const char *const name[] = {"rest",     "in",        "lateral",
                                       "inclined", "whirling+", "whirling-"};

    return name[plane];
}
