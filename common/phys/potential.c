/* Energy of weight and slings, gradient and second derivatives. */
#include "phys/potential.h"

#include "phys/path.h"

#include <math.h>
#include <string.h>

void potential_laws(const struct gear *s, const double *force, struct sling_law *law)
{
    for (int k = 0; k < s->slings; k++)
        law[k] = isinf(s->sling[k].EA) ? (struct sling_law){force[k], 0}
                                       : (struct sling_law){0, s->sling[k].EA / s->sling[k].length};
}

static double force_of(const struct sling_law *law, double stretch)
{
    return law->stiffness > 0 ? fmax(0, law->before + law->stiffness * stretch) : law->before;
}

static double energy_of(const struct sling_law *law, double stretch)
{
    double T = force_of(law, stretch);

    return law->stiffness > 0 ? T * T / (2 * law->stiffness) : T * stretch;
}

static double weight(const struct gear *s, const struct pose *pose)
{
    double sum = 0;

    for (int b = 0; b < s->bodies; b++)
        sum += s->body[b].mass * s->g * pose[b].r[2];
    return sum;
}

double potential_energy(const struct gear *s, const struct pose *pose, const struct sling_law *law)
{
    double sum = weight(s, pose);

    for (int k = 0; k < s->slings; k++) {
        struct path p;

        path_lay(s, pose, k, &p);
        sum += energy_of(law + k, p.length - s->sling[k].length);
    }
    return sum;
}

/* One sling: its energy, T grad L, and T L'' + stiffness grad L grad L^T where it is taut. */
static void add_sling(const struct gear *s, const struct pose *pose, const struct freedom *f,
                      const struct sling_law *law, int k, struct potential *ret)
{
    double *J = ret->J + k * f->n, stretch, T;
    struct path p;

    path_lay(s, pose, k, &p);
    path_gradient(&p, f, J);
    stretch = p.length - s->sling[k].length;
    T = force_of(law, stretch);
    ret->length[k] = p.length;
    ret->contacts[k] = p.n - 2;
    ret->force[k] = T;
    ret->energy += energy_of(law, stretch);
    if (T == 0)
        return;
    for (int i = 0; i < f->n; i++)
        ret->gradient[i] += T * J[i];
    path_add_hessian(&p, f, T, ret->H);
    for (int i = 0; i < f->n && law->stiffness > 0; i++)
        for (int j = 0; j < f->n; j++)
            ret->H[i + j * f->n] += law->stiffness * J[i] * J[j];
}

void potential_at(const struct gear *s, const struct pose *pose, const struct freedom *f,
                  const struct sling_law *law, struct potential *ret)
{
    ret->n = f->n;
    ret->energy = weight(s, pose);
    memset(ret->H, 0, (size_t)(f->n * f->n) * sizeof *ret->H);
    for (int i = 0; i < f->n; i++)
        ret->gradient[i] = f->axis[i] == 2 ? s->body[f->body[i]].mass * s->g : 0;
    for (int k = 0; k < s->slings; k++)
        add_sling(s, pose, f, law + k, k, ret);
}
