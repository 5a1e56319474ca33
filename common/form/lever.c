/* Righting levers over the tilt. */
#include "form/lever.h"
#include "form/judge.h"
#include "form/result.h"
#include "form/tackle.h"
#include "num/pi.h"

#include <math.h>

enum { TILTS = 91 };

#define DEGREES(x) ((x) * (180 / PI))

/* Lever by the formulas over the tilt of the load; their moment of one sling (1.3.1). */
static void by_formula(const struct lift *l, enum rigging_view view, double tilt, double *ret_lever,
                       double *ret_moment)
{
    const struct suspension *a = &l->end[0];
    struct rigging_heights heights;
    struct righting at;
    double h;

    rigging_heights(a, &heights);
    h = heights.h[view];
    *ret_lever = h / heights.r * sin(tilt);
    righting_at(a, view, h, tan(tilt) / heights.r, &at);
    *ret_moment = at.moment;
}

static void print_tilt(const struct lift *l, const struct tackle *t, enum rigging_view view,
                       const struct heel *p, struct out *o)
{
    double mg = t->gear.body[t->load].mass * t->gear.g, lever, moment;
    double kilo = tackle_has_mass(l) ? 1e-3 : NAN;

    by_formula(l, view, p->tilt, &lever, &moment);
    result_cells(o,
                 (double[]){DEGREES(p->tilt),
                            t->spreader < 0 ? NAN : DEGREES(p->others[t->spreader]), p->moment / mg,
                            p->moment * kilo, p->energy * kilo, p->slack, p->contacts, lever,
                            moment * kilo},
                 9);
    putc('\n', o->f);
}

void lever_header(struct out *o)
{
    fputs("row,name,tilt_deg,tilt_spreader_deg,lever_m,moment_kNm,energy_kJ,slack,contacts,"
          "lever_formula_m,moment_sling_formula_kNm\n",
          o->f);
}

enum status lever_row(const struct lift *l, long row, const char *name, struct out *o,
                      struct why *why)
{
    enum rigging_view view;
    struct heel path[TILTS];
    struct tackle t;
    enum status s;
    int n, seen = exact_view(l);

    if (seen < 0)
        return fail(why, SW_ADMISSIBLE, "type: a pair has no lever of one view");
    view = (enum rigging_view)seen;
    s = tackle_planar(l, view, 1, &t, why);
    if (s != SW_OK)
        return s;
    s = heel_path(&t.gear, t.load, NULL, 0, PI / 2, TILTS, path, &n);
    if (s != SW_OK || n == 0)
        return fail(why, SW_NOCONV, "exact statics find no equilibrium");
    for (int i = 0; i < n; i++) {
        fprintf(o->f, "%ld,", row);
        out_cell(o, name);
        print_tilt(l, &t, view, &path[i], o);
    }
    return SW_OK;
}
