/* Attitudes of bodies. */
#include "phys/attitude.h"
#include "num/quat.h"
#include "num/vec3.h"

void attitude_matrix(const double w[3], double R[9])
{
    double q[4];

    quat_exp(w, q);
    quat_matrix(q, R);
}

/* The quaternion of R, by its largest component (Shepperd), tells the vector. */
void attitude_vector(const double R[9], double w[3])
{
    double trace = R[0] + R[4] + R[8], q[4], most = trace;
    int at = 3;

    for (int i = 0; i < 3; i++)
        if (R[4 * i] > most) {
            most = R[4 * i];
            at = i;
        }
    q[0] = 1 + trace;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double turned = R[3 * k + j] - R[3 * j + k];

        q[1 + i] = at == 3   ? turned
                   : at == i ? 1 + 2 * R[4 * i] - trace
                             : R[3 * i + at] + R[3 * at + i];
        if (at == i)
            q[0] = turned;
    }
    quat_normalize(q);
    quat_log(q, w);
}

void attitude_turn(const double w[3], double R[9])
{
    double E[9], old[9];

    attitude_matrix(w, E);
    memcpy(old, R, sizeof old);
    mat3_multiply(E, old, R);
}
