/* Finite rotations. */
#include "num/quat.h"
#include "num/pi.h"
#include "num/vec3.h"

void quat_exp(const double v[3], double q[4])
{
    double angle = vec3_length(v), x = angle / 2;
    double part = x < 1e-4 ? (1 - x * x / 6) / 2 : sin(x) / angle; /* next term: x^4/120 */

    q[0] = cos(x);
    for (int i = 0; i < 3; i++)
        q[1 + i] = part * v[i];
}

void quat_log(const double q[4], double v[3])
{
    double sine = vec3_length(q + 1), sign = q[0] < 0 ? -1 : 1;
    double part = sine > 0 ? 2 * atan2(sine, fabs(q[0])) / sine : 2;

    for (int i = 0; i < 3; i++)
        v[i] = sign * part * q[1 + i];
}

void quat_log_near(const double q[4], double v[3])
{
    double near[3] = {v[0], v[1], v[2]}, axis[3], angle, turns;

    quat_log(q, v);
    angle = vec3_length(v);
    if (angle < 1e-8) { /* whole turns about any axis: the given one */
        double before = vec3_length(near);

        turns = floor(before / (2 * PI) + 0.5);
        if (turns > 0)
            vec3_add(2 * PI * turns / before, near, v);
        return;
    }
    for (int i = 0; i < 3; i++)
        axis[i] = v[i] / angle;
    turns = floor((vec3_dot(axis, near) - angle) / (2 * PI) + 0.5);
    vec3_add(2 * PI * turns, axis, v);
}

void quat_multiply(const double a[4], const double b[4], double c[4])
{
    const double w = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
    const double x = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
    const double y = a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3];
    const double z = a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1];

    c[0] = w;
    c[1] = x;
    c[2] = y;
    c[3] = z;
}

void quat_between(const double a[4], const double b[4], double c[4])
{
    const double inverse[4] = {a[0], -a[1], -a[2], -a[3]};

    quat_multiply(inverse, b, c);
}

void quat_half(const double q[4], double h[4])
{
    double sign = q[0] < 0 ? -1 : 1, w = sqrt((1 + fabs(q[0])) / 2);

    h[0] = w;
    for (int i = 1; i < 4; i++)
        h[i] = sign * q[i] / (2 * w);
}

void quat_normalize(double q[4])
{
    double size = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);

    for (int i = 0; i < 4; i++)
        q[i] /= size;
}

void quat_matrix(const double q[4], double R[9])
{
    double w = q[0], x = q[1], y = q[2], z = q[3];

    R[0] = 1 - 2 * (y * y + z * z);
    R[1] = 2 * (x * y - w * z);
    R[2] = 2 * (x * z + w * y);
    R[3] = 2 * (x * y + w * z);
    R[4] = 1 - 2 * (x * x + z * z);
    R[5] = 2 * (y * z - w * x);
    R[6] = 2 * (x * z - w * y);
    R[7] = 2 * (y * z + w * x);
    R[8] = 1 - 2 * (x * x + y * y);
}
