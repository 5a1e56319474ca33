/* Turning the axes of a model's matrices and vectors. */
#include "phys/turn.h"

/* Entry (i, j) of a 6x6 block: unknowns of one node by those of the same or the next. */
static double turned(const struct axes *axes, double B[6][6], int i, int j)
{
    double sum = 0;

    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            sum += axes->e[a][i / 2] * B[2 * a + i % 2][2 * b + j % 2] * axes->e[b][j / 2];
    return sum;
}

void turn_matrix(const struct axes *axes, struct band *A)
{
    for (int column = 0; column < A->n; column += 6)
        for (int row = column; row < A->n && row <= column + 6; row += 6) {
            double B[6][6];

            for (int i = 0; i < 6; i++)
                for (int j = 0; j < 6; j++)
                    B[i][j] = band_get(A, row + i, column + j);
            for (int i = 0; i < 6; i++)
                for (int j = 0; j < 6; j++)
                    if (row + i >= column + j)
                        *band_at(A, row + i, column + j) = turned(axes, B, i, j);
        }
}

/* The three unknowns at x, x + stride, x + 2 stride. */
static void turn_three(const struct axes *axes, enum turn to, double *x, int stride)
{
    const double from[3] = {x[0], x[stride], x[2 * stride]};
    double ret[3];

    if (to == TURN_TO_SPACE)
        axes_to_space(axes, from, ret);
    else
        axes_to_plane(axes, from, ret);
    for (int i = 0; i < 3; i++)
        x[i * stride] = ret[i];
}

/* The first and the last node have slopes only. */
void turn_free(const struct axes *axes, enum turn to, int n, double *x)
{
    turn_three(axes, to, x, 1);
    for (int k = 1; k < n; k++) {
        turn_three(axes, to, x + 6 * (size_t)k - 3, 2);
        turn_three(axes, to, x + 6 * (size_t)k - 2, 2);
    }
    turn_three(axes, to, x + 6 * (size_t)n - 3, 1);
}
