/* Rigid bodies of a system of ropes. */
#include "form/netbodies.h"
#include "form/netdoubt.h"
#include "form/netfiles.h"
#include "form/sheet.h"
#include "phys/attitude.h"

#include <math.h>
#include <string.h>

static void cells(const double *x, int n, struct out *o)
{
    for (int i = 0; i < n; i++) {
        putc(',', o->f);
        out_number(o, x[i]);
    }
}

void net_print_bodies(const struct system *p, const struct net_state *s, struct out *o)
{
    fputs("body,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm,load_x_N,"
          "load_y_N,load_z_N,load_mx_Nm,load_my_Nm,load_mz_Nm,condition\n",
          o->f);
    for (int b = 0; b < p->net.bodies; b++) {
        const struct net_body *body = &p->net.body[b];
        double turn[3], lines[6], own[6];

        attitude_vector(body->R, turn);
        net_body_forces(&p->net, s, b, body->x, lines, own);
        out_cell(o, roll_name(&p->bodies, b));
        cells(body->x, 3, o);
        cells(turn, 3, o);
        cells(lines, 6, o);
        cells(own, 6, o);
        fputs(body->held ? ",fixed\n" : ",free\n", o->f);
    }
}

enum status net_choose_body(const struct system *p, const char *name, int *ret, struct why *why)
{
    int held = 0;

    *ret = -1;
    for (int b = 0; b < p->net.bodies && !name; b++)
        if (p->net.body[b].held && held++ == 0)
            *ret = b;
    if (name)
        *ret = roll_search(&p->bodies, name, strlen(name));
    if (name && *ret < 0)
        return fail(why, SW_USAGE, "there is no body '%.60s'", name);
    if (*ret < 0)
        return fail(why, SW_USAGE, "no body is held");
    return held > 1 ? fail(why, SW_USAGE, "%d bodies are held: name one by --body", held) : SW_OK;
}

enum status net_choose_nodes(const struct system *p, const char *text, int *ret, int *ret_k,
                             struct why *why)
{
    int k = 0;

    if (!*text)
        return fail(why, SW_USAGE, "names of nodes are expected");
    while (*text) {
        size_t length = strcspn(text, ",");
        int found = roll_search(&p->nodes, text, length);

        if (found < 0)
            return fail(why, SW_USAGE, "there is no node '%.*s'", (int)length, text);
        for (int i = 0; i < k; i++)
            if (ret[i] == found)
                return fail(why, SW_USAGE, "node '%.*s' is named twice", (int)length, text);
        ret[k++] = found;
        text += length;
        text += *text == ',';
    }
    *ret_k = k;
    return SW_OK;
}

void net_move_body(struct system *p, int body, const struct net_body *from, const double move[6])
{
    struct net_body *to = &p->net.body[body];

    *to = *from;
    for (int c = 0; c < 3; c++)
        to->x[c] += move[c];
    attitude_turn(move + 3, to->R);
    net_place_body(&p->net, body);
}

enum { DX, RX = 3, N_MOVE = 6 };
static const struct sheet_column move_column[N_MOVE] = {{"dx_m", 0},   {"dy_m", 0},
                                                        {"dz_m", 0},   {"rx_rad", 0},
                                                        {"ry_rad", 0}, {"rz_rad", 0}};

/* Largest tension and its rope. */
static double largest(const struct system *p, const struct net_state *s, int *ret_rope)
{
    double most = -1;

    for (int r = 0; r < p->net.m; r++) {
        struct net_outline line;

        net_outline(&p->net, s, r, &line);
        if (line.most > most) {
            most = line.most;
            *ret_rope = r;
        }
    }
    return most;
}

/* The rest of a row: forces and tension of the solved system, or why there are none; place: of the
 * row, before what is doubtful in it. */
static enum status print_answer(struct system *p, const struct net_options *solver, int body,
                                struct net_doubt *doubt, const char *place, struct out *o,
                                struct why *why)
{
    struct net_state s = {.x = NULL};
    double lines[6], own[6], most;
    int rope = 0;
    enum status status = system_judge_bed(p, why);

    if (status == SW_OK) {
        status = net_settle(&p->net, solver, &s);
        if (status != SW_OK)
            fail(why, status, "%s", status_text(status));
    }
    if (status == SW_OK)
        status = system_judge_bed(p, why); /* free bodies */
    if (status == SW_OK)
        status = net_within_tables(p, &s, why);
    if (status == SW_OK) {
        net_body_forces(&p->net, &s, body, p->net.body[body].x, lines, own);
        most = largest(p, &s, &rope);
        cells(lines, 6, o);
        cells(&most, 1, o);
        putc(',', o->f);
        out_cell(o, system_rope(p, rope));
        fputs(",solved\n", o->f);
        net_doubt_tell(doubt, &s, place);
    } else if (status != SW_NOMEM) {
        fputs(",,,,,,,,,not-solved\n", o->f);
    }
    net_state_free(&s);
    return status;
}

/* One move: its row. */
static enum status print_move(struct system *p, const struct net_options *solver, int body,
                              const struct sheet *t, int i, struct net_doubt *doubt, struct out *o,
                              int *ret_failed, struct why *why)
{
    const struct net_body from = p->net.body[body];
    double move[N_MOVE];
    struct why reason;
    enum status s = SW_OK, solved;

    for (int c = 0; c < N_MOVE && s == SW_OK; c++)
        s = sheet_number(t, i, c, c < RX ? -1e9 : -100, c < RX ? 1e9 : 100, 0, &move[c], why);
    if (s != SW_OK)
        return s;
    net_move_body(p, body, &from, move);
    for (int c = 0; c < N_MOVE; c++) {
        if (c > 0)
            putc(',', o->f);
        out_number(o, move[c]);
    }
    sheet_fail(&reason, t, i, "%s", ""); /* FILE:LINE: */
    solved = print_answer(p, solver, body, doubt, reason.text, o, why);
    p->net.body[body] = from;
    if (solved == SW_NOMEM)
        return fail_plain(why, solved);
    if (solved != SW_OK) {
        reason = *why;
        sheet_fail(why, t, i, "not solved: %.400s", reason.text);
        report(why);
        ++*ret_failed;
    }
    return SW_OK;
}

enum status net_print_curve(struct system *p, const struct net_options *solver, int body,
                            const char *path, struct out *o, int *ret_failed, struct why *why)
{
    struct net_doubt doubt = {.told = NULL};
    struct sheet t;
    enum status s = sheet_read(path, NULL, move_column, N_MOVE, &t, why);

    *ret_failed = 0;
    if (s != SW_OK)
        return s;
    fputs("dx_m,dy_m,dz_m,rx_rad,ry_rad,rz_rad,fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm,"
          "largest_tension_N,rope,status\n",
          o->f);
    s = net_doubt_new(p, &doubt, why);
    for (int i = 0; i < t.n && s == SW_OK; i++)
        s = print_move(p, solver, body, &t, i, &doubt, o, ret_failed, why);
    net_place_body(&p->net, body);
    net_doubt_free(&doubt);
    sheet_free(&t);
    return s;
}
