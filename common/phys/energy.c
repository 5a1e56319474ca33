/* Energy balance of a march. */
#include "phys/energy.h"

#include <string.h>

static double strain_energy(const struct model *m, int terms, const double *V)
{
    double sum = 0;

    for (int k = 0; k < m->n; k++) {
        struct element e = model_element(m, k);

        sum += element_potential(&e, terms, V + 6 * (size_t)k);
    }
    return sum;
}

static double kinetic_energy(const struct model *m, const double *W)
{
    double mass[16], sum = 0;

    element_mass(m->line.cable.mu, m->h, mass);
    for (int k = 0; k < m->n; k++)
        sum += element_product(mass, W + 6 * (size_t)k, W + 6 * (size_t)k);
    return sum / 2;
}

/* What the damping forces take away at velocity W [W]. */
static double dissipation(const struct march *m, const double *W)
{
    const struct march_options *o = &m->options;
    const struct march_dampers *d = &m->dampers;
    size_t n = model_unknowns(m->model);
    double power = 2 * o->alpha * kinetic_energy(m->model, W);

    for (int k = 0; k < m->model->n && o->beta > 0; k++) {
        struct element e = model_element(m->model, k);

        power += o->beta * element_strain_energy(&e, W + 6 * (size_t)k);
    }
    for (size_t i = 0; i < (size_t)d->r; i++) {
        double speed = 0;

        for (size_t j = 0; j < n; j++)
            speed += d->b[j + n * i] * W[j];
        power += d->c[i] * speed * speed;
    }
    return power;
}

/* Work space R: forces from outside. */
static double load_power(const struct march *m, const double *W, double *R)
{
    double sum = 0;

    if (!forcing_any(&m->options.forcing))
        return 0;
    memset(R, 0, sizeof *R * model_unknowns(m->model));
    forcing_subtract(m->model, &m->options.forcing, march_time(m), m->V, W, R);
    for (size_t i = 0; i < model_unknowns(m->model); i++)
        sum -= R[i] * W[i];
    return sum;
}

static double support_power(const struct march *m, const double *W)
{
    double force[6], sum = 0;
    int held[6];

    model_prescribed(m->model, held);
    march_support_change(m, force);
    for (int i = 0; i < 6; i++)
        sum += force[i] * W[held[i]];
    return sum;
}

void energy_step(struct energy *e, struct march *m, double *work)
{
    const double *W = march_velocity(m);
    double power[3] = {support_power(m, W), load_power(m, W, work), dissipation(m, W)};
    double half = (march_time(m) - e->time) / 2;

    e->kinetic = kinetic_energy(m->model, W);
    e->strain = strain_energy(m->model, m->options.terms, m->V);
    if (e->started) {
        e->supports += half * (power[0] + e->power[0]);
        e->loads += half * (power[1] + e->power[1]);
        e->dissipated += half * (power[2] + e->power[2]);
    } else {
        e->start = e->kinetic + e->strain;
        e->started = 1;
    }
    memcpy(e->power, power, sizeof power);
    e->time = march_time(m);
}

double energy_now(struct march *m)
{
    return kinetic_energy(m->model, march_velocity(m)) +
           strain_energy(m->model, m->options.terms, m->V);
}

double energy_error(const struct energy *e)
{
    return e->kinetic + e->strain - e->start - e->supports - e->loads - e->disturbances +
           e->dissipated;
}
