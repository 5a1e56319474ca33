/* Large tilt: the path of prescribed tilt, and where it ends. */
#include "phys/heel.h"

#include "num/pi.h"
#include "num/root.h"

#include <float.h>
#include <math.h>

static const double longest = PI / 90; /* step along the path */
static const double narrowest = 1e-7;  /* range of tilt that counts as one */
static const double shortest = 1e-10;  /* step at which it is told to end */
enum { TRIES = 1000 };                 /* of one walk: a way that creeps on longer ends */
static const double jump = 0.3;        /* turn of another body that is no continuation */

struct walk {
    const struct gear *s;
    int body;
    double tilt; /* of the body, at h, counted on beyond half a turn */
    double sign; /* of the direction, if it keeps one */
    struct hang h;
};

static int jumped(const struct walk *w, const struct hang *next)
{
    for (int b = 0; b < w->s->bodies; b++) {
        double turn = pose_tilted(next->pose + b) - pose_tilted(w->h.pose + b);

        if (!(fabs(remainder(turn, 2 * PI)) <= jump))
            return 1;
    }
    return 0;
}

/* One step; 0: there is no stable continuation so far away. */
static int try_step(const struct walk *w, double angle, struct hang *ret)
{
    return hang_on(w->s, HANG_NEAR, &w->h, w->body, angle, ret) == SW_OK && ret->least > 0 &&
           !jumped(w, ret);
}

/* On to the tilt, in steps as short as it takes; 0: the path ends before, w is at its end. */
static int walk_to(struct walk *w, double tilt)
{
    double most = longest;

    for (int tries = 0; w->tilt != tilt; tries++) {
        double left = tilt - w->tilt, angle = copysign(fmin(most, fabs(left)), left);
        struct hang next;

        if (try_step(w, angle, &next)) {
            w->h = next;
            w->tilt = fabs(left) <= most ? tilt : w->tilt + angle;
            most = fmin(longest, 2 * most);
        } else if ((most = fabs(angle) / 4) < shortest || tries > TRIES) {
            return 0;
        }
    }
    return 1;
}

static int admissible(const struct gear *s, int body)
{
    return gear_check(s) == SW_OK && s->planar && body >= 0 && body < s->bodies;
}

static void tell(const struct walk *w, struct heel *ret)
{
    *ret = (struct heel){.tilt = w->tilt, .moment = w->h.moment, .energy = w->h.energy};
    for (int k = 0; k < w->s->slings; k++) {
        ret->slack += !(w->h.force[k] > 0);
        ret->contacts += w->h.contacts[k];
    }
    for (int b = 0; b < w->s->bodies; b++)
        ret->others[b] = pose_tilted(w->h.pose + b);
}

enum status heel_path(const struct gear *s, int body, const struct pose *start, double first,
                      double last, int n, struct heel *ret, int *ret_n)
{
    struct walk w = {.s = s, .body = body};
    enum status status;

    *ret_n = 0;
    if (!admissible(s, body) || !(fabs(first) <= DBL_MAX && fabs(last) <= DBL_MAX))
        return SW_ADMISSIBLE;
    status = hang(s, HANG_DOWN, start, start ? body : -1, &w.h);
    if (status != SW_OK)
        return status;
    w.tilt = pose_tilted(w.h.pose + body);
    for (int i = 0; i < n; i++) {
        if (!walk_to(&w, n > 1 ? first + (last - first) * i / (n - 1) : first))
            break;
        tell(&w, ret + i);
        *ret_n = i + 1;
    }
    for (int i = *ret_n - 1; i >= 0; i--)
        ret[i].energy -= ret[0].energy;
    return SW_OK;
}

/* Moment against the direction of the walk, farther on than from; NAN: the path ends. */
static double righting(double angle, void *context)
{
    const struct walk *from = context;
    struct walk w = *from;

    if (!walk_to(&w, from->tilt + w.sign * angle))
        return NAN;
    return w.sign * w.h.moment;
}

static double overturning(double angle, void *context)
{
    return -righting(angle, context);
}

/* The largest moment within width from the place before the largest sample on. */
static void refine_most(struct walk *from, double width, struct heel_range *ret)
{
    double least, angle = least_between(overturning, from, 0, width, &least);

    if (-least > ret->moment && isfinite(angle)) {
        ret->moment = -least;
        ret->at = from->tilt + from->sign * angle;
    }
}

/* From last, where the moment was before, to where it vanishes; it is now at w. */
static void end_at_zero(struct walk *last, double before, double now, struct walk *w)
{
    double at = root_between(righting, last, 0, before, fabs(w->tilt - last->tilt), now);

    *w = *last;
    walk_to(w, last->tilt + w->sign * at);
}

/*
 * Sample by sample until the moment vanishes, the path folds or the limit is reached; w ends there.
 * The largest sample goes to ret, the place before it to top.  The moment at the beginning is zero:
 * ever shorter first steps tell whether it rights at all, 0 if it does not.
 */
static int walk_range(struct walk *w, double limit, struct walk *top, struct heel_range *ret)
{
    struct walk last = *w;
    double step = longest, before = 0;

    while (w->tilt != limit) {
        double now;

        if (!walk_to(w, fabs(limit - w->tilt) <= step ? limit : w->tilt + w->sign * step)) {
            ret->end = HEEL_FOLDS;
            return before > 0;
        }
        now = w->sign * w->h.moment;
        if (!(now > 0) && !(before > 0)) {
            step /= 16;
            *w = last;
            if (step < narrowest)
                return 0;
            continue;
        }
        if (!(now > 0)) {
            ret->end = HEEL_CAPSIZES;
            end_at_zero(&last, before, now, w);
            return 1;
        }
        if (now > ret->moment) {
            ret->moment = now;
            ret->at = w->tilt;
            *top = last;
        }
        before = now;
        last = *w;
        step = longest;
    }
    return 1;
}

enum status heel_range(const struct gear *s, int body, const struct hang *h, double limit,
                       struct heel_range *ret)
{
    struct walk w = {.s = s, .body = body, .h = *h}, top;

    if (!admissible(s, body) || !(fabs(limit) <= DBL_MAX))
        return SW_ADMISSIBLE;
    w.tilt = pose_tilted(h->pose + body);
    w.sign = copysign(1, limit - w.tilt);
    *ret = (struct heel_range){.tilt = w.tilt, .end = HEEL_HOLDS, .at = w.tilt};
    top = w;
    if (!walk_range(&w, limit, &top, ret))
        return SW_INFEASIBLE;
    ret->capsizing = w.tilt;
    ret->energy = w.h.energy - h->energy;
    refine_most(&top, fmin(2 * longest, fabs(w.tilt - top.tilt)), ret);
    return SW_OK;
}
