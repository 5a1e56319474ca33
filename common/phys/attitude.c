/* Finite rotations. */
#include "phys/attitude.h"

#include <math.h>
#include <string.h>

#define SMALL 1e-4 /* angle below which series are exact to round-off */

/* Rodrigues: I + s w^ + c w^ w^, s = sin(a)/a, c = (1 - cos(a))/a^2. */
void attitude_matrix(const double w[3], double R[9])
{
    double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], a = sqrt(square);
    double s = a < SMALL ? 1 - square / 6 : sin(a) / a;
    double half = sin(a / 2), c = a < SMALL ? 0.5 - square / 24 : 2 * half * half / square;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[3 * i + j] = (i == j) * (1 - c * square) + c * w[i] * w[j];
    for (int i = 0; i < 3; i++) {
        R[3 * ((i + 1) % 3) + (i + 2) % 3] -= s * w[i];
        R[3 * ((i + 2) % 3) + (i + 1) % 3] += s * w[i];
    }
}

/* The unit quaternion of R, by its largest component (Shepperd), tells the vector. */
void attitude_vector(const double R[9], double w[3])
{
    double trace = R[0] + R[4] + R[8], q[4], most = trace, length, angle;
    int at = 3;

    for (int i = 0; i < 3; i++)
        if (R[4 * i] > most) {
            most = R[4 * i];
            at = i;
        }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double turned = R[3 * k + j] - R[3 * j + k];

        if (at == 3)
            q[i] = turned;
        else if (at == i)
            q[i] = 1 + 2 * R[4 * i] - trace;
        else
            q[i] = R[3 * i + at] + R[3 * at + i];
        if (at == i)
            q[3] = turned;
    }
    if (at == 3)
        q[3] = 1 + trace;
    length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
    angle = 2 * atan2(length, fabs(q[3]));
    for (int i = 0; i < 3; i++)
        w[i] = (q[3] < 0 ? -q[i] : q[i]) * (length > 0 ? angle / length : 0);
}

void attitude_turn(const double w[3], double R[9])
{
    double E[9], old[9];

    attitude_matrix(w, E);
    memcpy(old, R, sizeof old);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[3 * i + j] =
                E[3 * i] * old[j] + E[3 * i + 1] * old[3 + j] + E[3 * i + 2] * old[6 + j];
}

void attitude_apply(const double R[9], const double a[3], double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = R[3 * i] * a[0] + R[3 * i + 1] * a[1] + R[3 * i + 2] * a[2];
}

void attitude_undo(const double R[9], const double a[3], double ret[3])
{
    for (int i = 0; i < 3; i++)
        ret[i] = R[i] * a[0] + R[3 + i] * a[1] + R[6 + i] * a[2];
}
