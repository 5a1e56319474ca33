/* Rigid bodies from their table. */
#include "form/systemtable.h"
#include "num/mem.h"
#include "phys/attitude.h"

#include <math.h>
#include <string.h>

enum { BODY, CONDITION, X, RX = X + 3, MASS = RX + 3, VOLUME, XG, XB = XG + 3, AREA = XB + 3, N };
static const struct sheet_column column[N] = {{"body", 1},      {"condition", 1},    {"x_m", 1},
                                              {"y_m", 1},       {"z_m", 1},          {"rx_rad", 0},
                                              {"ry_rad", 0},    {"rz_rad", 0},       {"mass_kg", 0},
                                              {"volume_m3", 0}, {"xg_m", 0},         {"yg_m", 0},
                                              {"zg_m", 0},      {"xb_m", 0},         {"yb_m", 0},
                                              {"zb_m", 0},      {"waterplane_m2", 0}};

static enum status three(const struct sheet *t, int i, int first, double most, double fallback,
                         double *ret, struct why *why)
{
    enum status s = SW_OK;

    for (int c = 0; c < 3 && s == SW_OK; c++)
        s = sheet_number(t, i, first + c, -most, most, fallback, &ret[c], why);
    return s;
}

static enum status take_body(const struct sheet *t, int i, struct system_body *said,
                             struct net_body *to, struct why *why)
{
    const char *condition = sheet_text(t, i, CONDITION);
    double turn[3];
    enum status s = three(t, i, X, SYSTEM_BIG, NAN, to->x, why);

    to->held = strcmp(condition, "fixed") == 0;
    if (!to->held && strcmp(condition, "free") != 0)
        return sheet_fail(why, t, i, "condition '%.60s' is neither free nor fixed", condition);
    if (s == SW_OK)
        s = three(t, i, RX, 100, 0, turn, why);
    if (s == SW_OK)
        s = three(t, i, XG, SYSTEM_BIG, 0, to->cg, why);
    if (s == SW_OK)
        s = three(t, i, XB, SYSTEM_BIG, 0, to->cb, why);
    if (s == SW_OK)
        s = sheet_number(t, i, MASS, 0, 1e15, 0, &said->mass, why);
    if (s == SW_OK)
        s = sheet_number(t, i, VOLUME, 0, 1e15, 0, &said->volume, why);
    if (s == SW_OK)
        s = sheet_number(t, i, AREA, 0, 1e12, 0, &said->area, why);
    if (s == SW_OK)
        attitude_matrix(turn, to->R);
    return s;
}

enum status system_read_bodies(const char *path, struct system *p, struct why *why)
{
    struct sheet t;
    enum status s = sheet_read(p->c.bodies, path, column, N, &t, why);

    if (s != SW_OK)
        return s;
    s = sheet_roll(&t, BODY, &p->bodies, why);
    p->body = mem_zeroed((size_t)t.n, sizeof *p->body);
    p->net.body = mem_zeroed((size_t)t.n, sizeof *p->net.body);
    p->net.bodies = t.n;
    if (s == SW_OK && (!p->body || !p->net.body))
        s = fail_plain(why, SW_NOMEM);
    for (int i = 0; i < t.n && s == SW_OK; i++)
        s = take_body(&t, i, &p->body[i], &p->net.body[i], why);
    sheet_free(&t);
    return s;
}
