/* The path of equilibria while a centre of gravity moves. */
#include "phys/offset.h"

#include "phys/space.h"

#include <float.h>
#include <string.h>

static const double first = 1.0 / 16; /* share of the shift */
static const double shortest = 1e-12;
enum { TRIES = 400 };           /* a way that creeps on longer than this is none */
static const double jump = 0.1; /* change of a direction in one step that is no continuation */

static int jumped(const struct gear *s, const struct hang *a, const struct hang *b)
{
    double most = 0;

    for (int i = 0; i < s->bodies; i++)
        for (int j = 0; j < 9; j++)
            most = larger(most, fabs((&a->pose[i].R[0][0])[j] - (&b->pose[i].R[0][0])[j]));
    return !(most <= jump);
}

/* s and h with the centre of gravity of body at cg, everything else of h left where it was. */
static void move(struct gear *s, int body, const double cg[3], struct hang *h)
{
    double now[3];

    pose_place(s, h->pose, body, cg, now);
    memcpy(s->body[body].cg, cg, sizeof s->body[body].cg);
    memcpy(h->pose[body].r, now, sizeof now);
}

enum status offset_shift(struct gear *s, int body, const double shift[3], struct hang *h,
                         double *ret_share)
{
    double from[3], step = first;

    *ret_share = 0;
    if (gear_check(s) != SW_OK || body < 0 || body >= s->bodies || !(dot(shift, shift) <= DBL_MAX))
        return SW_ADMISSIBLE;
    memcpy(from, s->body[body].cg, sizeof from);
    for (int tries = 0; *ret_share < 1; tries++) {
        double share = fmin(1, *ret_share + step), cg[3];
        struct gear next = *s;
        struct hang start = *h, there;

        for (int i = 0; i < 3; i++)
            cg[i] = from[i] + share * shift[i];
        move(&next, body, cg, &start);
        if (hang_on(&next, HANG_NEAR, &start, -1, 0, &there) == SW_OK && there.least > 0 &&
            !jumped(s, h, &there)) {
            *s = next;
            *h = there;
            *ret_share = share;
            step *= 2;
        } else if ((step /= 4) < shortest || tries > TRIES) {
            return SW_INFEASIBLE;
        }
    }
    return SW_OK;
}
