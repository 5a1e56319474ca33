/* What cannot be meant, and elements that meet. */
#include "form/wiredoubt.h"
#include "form/units.h"
#include "num/mem.h"
#include "num/pi.h"
#include "num/quat.h"
#include "num/vec3.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#define LIGHT 100 /* kg/m3, less than balsa */
#define NEAR 8    /* thicknesses: elements that are farther apart are not compared */

/* The lesser extent of a section [m]; NAN: not known. */
static double thickness(const struct section *s)
{
    switch (s->shape) {
    case SECTION_ROUND:
    case SECTION_TUBE: return s->diameter;
    case SECTION_RECTANGLE: return fmin(s->width, s->height);
    default: return 2 * (s->ex < s->ey ? s->ex : s->ey);
    }
}

/* Least radius of the axis of elements with a section, and the element. */
static double least_radius(const struct wire *p, const struct section *s, int *ret_element)
{
    double least = INFINITY;

    for (int i = 0; i < p->frame.beams; i++) {
        const struct frame_beam *b = &p->frame.beam[i];
        double across[3], angle;

        vec3_cross(b->A[0] + 6, b->A[1] + 6, across);
        angle = atan2(vec3_length(across), vec3_dot(b->A[0] + 6, b->A[1] + 6));
        if (b->section == s && b->beam.length / angle < least) {
            least = b->beam.length / angle;
            *ret_element = p->piece[i].element;
        }
    }
    return least;
}

void wire_doubt(const struct wire *p)
{
    const struct sheet *t = &p->sections;

    for (int i = 0; i < t->n; i++) {
        const struct section *s = &p->section[i];
        double density = s->mass / s->area, poisson = s->E / (2 * s->G) - 1, radius;
        int element = 0;

        if (s->mass > 0 && units_doubt_density(density, LIGHT))
            warn("%.400s:%d: a density of %.3g kg/m3: is the unit right?", t->name, t->line[i],
                 density);
        if (s->shape != SECTION_GENERAL && fabs(poisson) > 0.5 + 1e-6)
            warn("%.400s:%d: E_Pa and G_Pa make a Poisson ratio of %.3g, not within -0.5 and 0.5: "
                 "is the unit right?",
                 t->name, t->line[i], poisson);
        radius = least_radius(p, s, &element);
        if (thickness(s) >= radius)
            warn("%.400s:%d: %.3g m thick, but element '%.60s' has a radius of %.3g m: is the unit "
                 "right?",
                 t->name, t->line[i], thickness(s), wire_element(p, element), radius);
    }
}

/* A node as a place of elements. */
struct spot {
    const double *x; /* now [m] */
    double thick;    /* 0: not known */
    int node, element;
};

static int axis; /* of the greatest extent, along which spots are sorted */

static int by_axis(const void *a, const void *b)
{
    double xa = ((const struct spot *)a)->x[axis], xb = ((const struct spot *)b)->x[axis];

    return (xa > xb) - (xa < xb);
}

/* Spots sorted; the greatest thickness. */
static double sort_spots(const struct wire *p, const struct wire_result *r, struct spot *to)
{
    double extent[3] = {0}, most = 0;

    for (int i = 0; i < p->frame.n; i++) {
        to[i] = (struct spot){.x = r->s.x + 3 * i, .node = i};
        for (int c = 0; c < 3; c++)
            extent[c] = fmax(extent[c], fabs(to[i].x[c] - to[0].x[c]));
    }
    for (int i = 0; i < p->frame.beams; i++) {
        const struct frame_beam *b = &p->frame.beam[i];
        double thick = thickness(b->section);
        int ends[2] = {b->a, b->b};

        for (int end = 0; end < 2; end++)
            if (thick > to[ends[end]].thick) {
                to[ends[end]].thick = thick;
                to[ends[end]].element = p->piece[i].element;
            }
        most = fmax(most, thick);
    }
    axis = extent[1] > extent[0];
    axis = extent[2] > extent[axis] ? 2 : axis;
    qsort(to, (size_t)p->frame.n, sizeof *to, by_axis);
    return most;
}

/*
 * How near b came to a on its way from the natural place to the present one, as a, turning, sees
 * it: the straight way between both.  INFINITY: they were as near before, or are far apart.
 */
static double approach(const struct wire *p, const struct wire_result *r, const struct spot *a,
                       const struct spot *b, double thick)
{
    double q[4], R[9], from[3], now[3], to[3], way[3], t;

    for (int c = 0; c < 3; c++) {
        from[c] = p->frame.node[b->node].x[c] - p->frame.node[a->node].x[c];
        now[c] = b->x[c] - a->x[c];
    }
    if (!(vec3_length(from) > 0.999 * thick && vec3_length(from) < NEAR * thick))
        return INFINITY;
    quat_exp(r->s.turn + 3 * a->node, q);
    quat_matrix(q, R);
    mat3_apply_t(R, now, to);
    for (int c = 0; c < 3; c++)
        way[c] = to[c] - from[c];
    t = -vec3_dot(from, way) / fmax(vec3_dot(way, way), DBL_MIN);
    vec3_add(fmin(fmax(t, 0), 1), way, from);
    return vec3_length(from);
}

static int are_joined(const struct wire *p, int a, int b)
{
    for (int i = 0; i < p->frame.beams; i++)
        if ((p->frame.beam[i].a == a && p->frame.beam[i].b == b) ||
            (p->frame.beam[i].a == b && p->frame.beam[i].b == a))
            return 1;
    return 0;
}

static void warn_of_contact(const struct wire *p, const struct wire_result *r, struct spot *spot)
{
    double most = sort_spots(p, r, spot), worst = 1;
    const struct spot *pair[2] = {NULL, NULL};

    for (int i = 0; i < p->frame.n; i++)
        for (int k = i + 1; k < p->frame.n && spot[k].x[axis] - spot[i].x[axis] < NEAR * most;
             k++) {
            double thick = (spot[i].thick + spot[k].thick) / 2, near;

            if (!(spot[i].thick > 0 && spot[k].thick > 0))
                continue;
            near = approach(p, r, &spot[i], &spot[k], thick) / thick;
            /* strands touch from the beginning: a little less is no contact */
            if (near < 0.95 && near < worst && !are_joined(p, spot[i].node, spot[k].node)) {
                worst = near;
                pair[0] = &spot[i];
                pair[1] = &spot[k];
            }
        }
    if (pair[0])
        warn("%.400s:%d: element '%.60s' comes within %.3g m of the axis of '%.60s', or passes "
             "through it, and is %.3g m thick: contact is not computed",
             p->elements.name, p->elements.line[pair[0]->element],
             wire_element(p, pair[0]->element), worst * (pair[0]->thick + pair[1]->thick) / 2,
             wire_element(p, pair[1]->element), pair[0]->thick);
}

enum status wire_doubt_result(const struct wire *p, const struct wire_result *r)
{
    struct spot *spot;
    int element;
    double strain = wire_strain(p, r, &element);

    if (strain > UNITS_STRAIN)
        warn("%.400s:%d: a strain of %.3g %% in element '%.60s', where small ones are computed: is "
             "the unit right?",
             p->elements.name, p->elements.line[element], 100 * strain, wire_element(p, element));
    spot = mem_zeroed((size_t)p->frame.n, sizeof *spot);
    if (!spot)
        return SW_NOMEM;
    warn_of_contact(p, r, spot);
    free(spot);
    return SW_OK;
}
