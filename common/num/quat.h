/*
 * Finite rotations as unit quaternions (w, x, y, z): composed by products, never by sums of angles.
 */
#ifndef SEILWERK_NUM_QUAT_H
#define SEILWERK_NUM_QUAT_H

/* No rotation. */
#define QUAT_ONE                                                                                   \
    {                                                                                              \
        1, 0, 0, 0                                                                                 \
    }

/* q = exp(v^): the rotation by |v| about v. */
void quat_exp(const double v[3], double q[4]);

/* v with exp(v^) = q, |v| <= pi. */
void quat_log(const double q[4], double v[3]);

/* The rotation vector of q that is nearest to the given one, which it replaces: turns are counted
 * on. */
void quat_log_near(const double q[4], double v[3]);

/* c = a b: first b, then a.  c = a^-1 b.  c may be a or b. */
void quat_multiply(const double a[4], const double b[4], double c[4]);
void quat_between(const double a[4], const double b[4], double c[4]);

/* h h = q, the shorter way. */
void quat_half(const double q[4], double h[4]);

/* Length 1 again after many products. */
void quat_normalize(double q[4]);

/* R, by rows, with R x = the turned x. */
void quat_matrix(const double q[4], double R[9]);

#endif
