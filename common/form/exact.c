/* Arrangements by exact statics. */
#include "form/exact.h"
#include "form/tackle.h"
#include "num/pi.h"
#include "phys/offset.h"
#include "phys/sway.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double upright = 30 * PI / 180; /* tilt within which contact holds a load */

const char *exact_end(const struct exact *e)
{
    static const char *const words[] = {"capsizes", "folds", "holds"};

    return isnan(e->capsizing) ? "" : words[e->end];
}

double exact_least(const struct exact *e)
{
    return e ? fmin(e->h, e->contact) : INFINITY; /* fmin of NAN is the other */
}

int exact_stretches(const struct lift *l)
{
    for (int k = 0; k < l->ends; k++)
        if ((l->ends == 2 || l->end[k].type != RIGGING_ELASTIC) &&
            l->detail[k].stretch[0] + l->detail[k].stretch[1] > 0)
            return 1;
    return 0;
}

int exact_needed(const struct lift *l)
{
    return l->offset > 0 || exact_stretches(l);
}

static void clear(struct exact *e)
{
    *e = (struct exact){.h = INFINITY,
                        .load = INFINITY,
                        .view = {NAN, NAN},
                        .contact = NAN,
                        .stable = 1,
                        .omega2 = NAN,
                        .period = NAN,
                        .tilt_spreader = NAN,
                        .tilt_load = NAN,
                        .offset_lost = NAN,
                        .capsizing = NAN,
                        .energy = NAN,
                        .moment = NAN,
                        .moment_at = NAN,
                        .rest = NAN,
                        .least = {NAN, NAN},
                        .greatest = {NAN, NAN},
                        .use = {NAN, NAN}};
}

/* How a gear hangs as drawn, and its small motions. */
struct drawn {
    struct tackle t;
    struct hang h;
    struct sway m;
};

static enum status settle(struct drawn *d, struct why *why)
{
    enum status s = hang(&d->t.gear, HANG_NEAR, NULL, -1, &d->h);

    if (s == SW_OK && isnan(d->h.least))
        s = SW_NOCONV;
    if (s == SW_OK)
        s = sway_of(&d->t.gear, &d->h, &d->m);
    for (int k = 0; s == SW_OK && k < d->m.n; k++)
        if (isnan(d->m.omega2[k]))
            s = SW_NOCONV;
    return s == SW_OK ? s : fail(why, s, "exact statics find no equilibrium as drawn");
}

/* h over the tilt of the spreader, or of the load; crosswise to the gear's x always the latter. */
static double height_of(const struct drawn *d, int across, int of_load)
{
    int tilted = of_load || across || d->t.spreader < 0 ? d->t.load : d->t.spreader;

    return sway_height(&d->t.gear, &d->m, d->t.load, tilted, across);
}

/* The turn of a body about the horizontal axis across the offset. */
static double tilt_of(const struct pose *p, int across)
{
    return across ? fabs(atan2(p->R[2][1], p->R[2][2])) : fabs(pose_tilted(p));
}

static void take_heights(const struct drawn *d, int across, struct exact *e)
{
    enum rigging_view view = across != d->t.turned ? RIGGING_CROSS : RIGGING_LONG;
    double h = height_of(d, across, 0);

    e->view[view] = fmin(h, isnan(e->view[view]) ? INFINITY : e->view[view]);
    e->h = fmin(e->h, h);
    e->load = fmin(e->load, height_of(d, across, 1));
}

/* The slowest mode so far, in the load's own directions. */
static void take_mode(const struct drawn *d, int known, struct exact *e)
{
    static const enum sway_kind other[SWAY_KINDS] = {
        SWING_CROSSWISE, SWING_LENGTHWISE, HEAVE, TILT_LENGTHWISE, TILT_CROSSWISE, YAW,
    };
    enum sway_kind kind;

    e->stable &= d->h.least > 0;
    if (d->m.n == 0 || d->m.omega2[0] > e->omega2)
        return;
    kind = d->t.turned ? other[d->m.kind[0]] : d->m.kind[0];
    e->omega2 = d->m.omega2[0];
    e->period = known && e->omega2 > 0 ? 2 * PI / sqrt(e->omega2) : NAN;
    snprintf(e->mode, sizeof e->mode, "%s of the %s", sway_words(kind),
             d->m.body[0] == d->t.load ? "load" : "spreader");
}

static void take_forces(const struct lift *l, const struct tackle *t, const struct hang *h,
                        struct exact *e)
{
    int slack = 0;

    for (int k = 0; k < t->gear.slings; k++) {
        int part = t->part[k];
        const struct suspension *a = &l->end[t->end[k]];
        double force = h->force[k] * t->real[k];
        double use = force / (part ? a->wll_secondary : a->wll);

        slack += !(force > 0);
        e->contacts += h->contacts[k];
        if (!tackle_has_mass(l))
            continue;
        e->least[part] = fmin(isnan(e->least[part]) ? INFINITY : e->least[part], force);
        e->greatest[part] = fmax(isnan(e->greatest[part]) ? 0 : e->greatest[part], force);
        if (!isnan(use))
            e->use[part] = fmax(isnan(e->use[part]) ? 0 : e->use[part], use);
    }
    e->slack = slack > e->slack ? slack : e->slack;
}

/* The offset at which stability is lost, looked for up to several bases. */
static double find_lost(const struct drawn *d, int across)
{
    struct gear s = d->t.gear;
    struct hang h = d->h;
    double most = 4 * d->t.reach, shift[3] = {0}, share;

    shift[across] = most;
    return offset_shift(&s, d->t.load, shift, &h, &share) == SW_OK ? INFINITY : share * most;
}

/* Whether d keeps its offset, whose loss is told.  d goes there. */
static int keeps_offset(const struct lift *l, struct drawn *d, int across, int brief,
                        struct exact *e)
{
    double shift[3] = {0}, share, lost = brief ? INFINITY : find_lost(d, across);
    int kept = 1;

    shift[across] = isnan(l->offset) ? 0 : l->offset;
    if (shift[across] > 0)
        kept = offset_shift(&d->t.gear, d->t.load, shift, &d->h, &share) == SW_OK;
    if (!kept) {
        e->lost = 1;
        lost = share * shift[across];
    }
    if (!brief || !kept)
        e->offset_lost = fmin(isnan(e->offset_lost) ? INFINITY : e->offset_lost, lost);
    return kept;
}

/* Tilts and forces where d hangs with its offset. */
static void take_tilt(const struct lift *l, const struct drawn *d, int across, struct exact *e)
{
    take_forces(l, &d->t, &d->h, e);
    if (isnan(l->offset))
        return;
    e->tilt_load =
        fmax(isnan(e->tilt_load) ? 0 : e->tilt_load, tilt_of(d->h.pose + d->t.load, across));
    if (d->t.spreader >= 0)
        e->tilt_spreader = fmax(isnan(e->tilt_spreader) ? 0 : e->tilt_spreader,
                                tilt_of(d->h.pose + d->t.spreader, across));
}

/* Large tilts from the place where d hangs. */
static void take_range(const struct lift *l, const struct drawn *d, struct exact *e)
{
    struct heel_range r;
    int known = tackle_has_mass(l);

    if (heel_range(&d->t.gear, d->t.load, &d->h, PI / 2, &r) != SW_OK)
        return;
    e->capsizing = r.capsizing;
    e->energy = known ? r.energy : NAN;
    e->moment = known ? r.moment : NAN;
    e->moment_at = r.at;
    e->end = r.end;
}

/* Downhill from a place that is not stable. */
static void take_rest(const struct lift *l, const struct drawn *d, struct exact *e)
{
    struct hang h;

    if (hang(&d->t.gear, HANG_DOWN, NULL, -1, &h) != SW_OK)
        return;
    e->rest = tilt_of(h.pose + d->t.load, 0);
    e->contacts = e->slack = 0;
    take_forces(l, &d->t, &h, e);
    e->by_contact = e->rest < upright && (e->contacts > 0 || h.by_contact);
}

/* Large tilts of one view, its edges counted: bare is the same without them. */
static void run_large(const struct lift *l, struct drawn *bare, struct drawn *d, int brief,
                      struct exact *e)
{
    int kept = bare->h.least > 0 && keeps_offset(l, bare, 0, brief, e);

    if (d->h.least > 0 && (l->detail[0].edges == 0 || keeps_offset(l, d, 0, 1, e))) {
        if (l->detail[0].edges == 0)
            *d = *bare;
        if (kept || l->detail[0].edges > 0)
            take_tilt(l, d, 0, e);
        if (kept && !brief)
            take_range(l, d, e);
        if (!kept && l->detail[0].edges > 0)
            e->rest = tilt_of(d->h.pose + d->t.load, 0);
    } else if (!brief && !(d->h.least > 0)) {
        take_rest(l, d, e);
    }
    if (!kept && e->rest < upright && l->detail[0].edges > 0)
        e->by_contact = 1;
}

/* The planar gear of one view, first without its edges, which judges. */
static enum status run_planar(const struct lift *l, enum rigging_view view, int range, int brief,
                              struct exact *e, struct why *why)
{
    struct drawn bare, d;
    enum status s = tackle_planar(l, view, 0, &bare.t, why);

    if (s != SW_OK || (s = settle(&bare, why)) != SW_OK)
        return s;
    take_heights(&bare, 0, e);
    take_mode(&bare, tackle_has_mass(l), e);
    d = bare;
    if (l->detail[0].edges > 0) {
        if ((s = tackle_planar(l, view, 1, &d.t, why)) != SW_OK || (s = settle(&d, why)) != SW_OK)
            return s;
        e->contact = fmin(isnan(e->contact) ? INFINITY : e->contact, height_of(&d, 0, 0));
    }
    if (range)
        run_large(l, &bare, &d, brief, e);
    return SW_OK;
}

static enum status run_space(const struct lift *l, int brief, struct exact *e, struct why *why)
{
    struct drawn d;
    enum status s = tackle_space(l, &d.t, why);

    if (s == SW_INFEASIBLE)
        return SW_OK;
    if (s != SW_OK || (s = settle(&d, why)) != SW_OK)
        return s;
    take_heights(&d, 0, e);
    if (l->ends == 1)
        take_heights(&d, 1, e);
    if (l->ends == 2)
        e->h = e->load = e->view[RIGGING_CROSS] = height_of(&d, 0, 1);
    take_mode(&d, !isnan(l->apart) || l->ends == 1, e);
    e->indeterminate = d.h.indeterminate;
    for (int across = 0; across < 1 + (l->ends == 1) && d.h.least > 0; across++) {
        struct drawn at = d;

        if (keeps_offset(l, &at, across, brief, e))
            take_tilt(l, &at, across, e);
    }
    return SW_OK;
}

int exact_view(const struct lift *l)
{
    const double *T = l->end[0].T;

    if (l->ends == 2)
        return -1;
    if (l->end[0].type == RIGGING_SINGLE)
        return RIGGING_LONG;
    if (isnan(T[RIGGING_LONG]) || T[RIGGING_CROSS] < T[RIGGING_LONG])
        return RIGGING_CROSS;
    return RIGGING_LONG;
}

enum status exact_make(const struct lift *l, int brief, struct exact *ret, struct why *why)
{
    int main_view = exact_view(l), all = l->ends == 1;
    enum status s = SW_OK;

    clear(ret);
    for (int view = 0; view < RIGGING_VIEWS && all && s == SW_OK; view++)
        if (view == main_view || !isnan(l->end[0].T[view]))
            s = run_planar(l, (enum rigging_view)view, view == main_view, brief, ret, why);
    return s == SW_OK ? run_space(l, brief, ret, why) : s;
}
