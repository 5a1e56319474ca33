/* The state of a march: written, resumed, started from. */
#include "form/state.h"
#include "num/hash.h"
#include "num/mem.h"
#include "sys/in.h"
#include "sys/npy.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define VERSION 4 /* 2 and 3 are those of rowsfile.h */

enum status state_checksum(const struct cable_case *c, const char *extra, double *ret_high,
                           double *ret_low, struct why *why)
{
    struct cable_case other = *c;
    char *text = NULL;
    size_t length = 0;
    struct out o = {.slot = -1, .f = open_memstream(&text, &length)};
    uint64_t hash;

    if (!o.f)
        return fail_plain(why, SW_NOMEM);
    other.time.end = NAN;
    case_print(&other, &o);
    if (fclose(o.f) != 0) {
        free(text);
        return fail_plain(why, SW_NOMEM);
    }
    hash = hash_more(hash_more(HASH_START, text, length), extra, strlen(extra));
    free(text);
    *ret_high = (double)(hash >> 32);
    *ret_low = (double)(hash & 0xffffffff);
    return SW_OK;
}

static void put_energy(const struct energy *e, double *to)
{
    const double all[] = {e->kinetic,      e->strain,     e->supports, e->loads,
                          e->disturbances, e->dissipated, e->start,    e->power[0],
                          e->power[1],     e->power[2],   e->started,  e->time};

    memcpy(to, all, sizeof all);
}

static void take_energy(const double *from, struct energy *e)
{
    *e = (struct energy){.kinetic = from[0],
                         .strain = from[1],
                         .supports = from[2],
                         .loads = from[3],
                         .disturbances = from[4],
                         .dissipated = from[5],
                         .start = from[6],
                         .power = {from[7], from[8], from[9]},
                         .started = from[10] != 0,
                         .time = from[11]};
}

/* What the scheme of m goes on with. */
static void put_march(const struct march *m, double *all)
{
    const struct alpha *p = m->alpha;
    size_t n = model_unknowns(m->model);
    const double *part[3] = {m->V, p ? p->W : m->D, p ? p->A : m->dd};

    for (int i = 0; i < 3; i++)
        memcpy(all + STATE_HEAD + n * (size_t)i, part[i], sizeof *all * n);
    all[STATE_SCHEME] = m->options.scheme;
    if (!p)
        return;
    all[STATE_MARK] = (double)p->row;
    all[STATE_TICK] = (double)p->tick;
    all[STATE_STRIDE] = (double)p->stride;
    all[STATE_SCALE] = p->scale;
    all[STATE_PAST] = p->past;
    all[STATE_SETTLED] = p->settled;
    all[STATE_EVEN] = (double)p->even;
    all[STATE_WORST] = p->worst;
}

static void take_march(const double *all, struct march *m)
{
    struct alpha *p = m->alpha;
    size_t n = model_unknowns(m->model);
    double *part[3] = {m->V, p ? p->W : m->D, p ? p->A : m->dd};

    for (int i = 0; i < 3; i++)
        memcpy(part[i], all + STATE_HEAD + n * (size_t)i, sizeof *all * n);
    if (!p)
        return;
    p->row = (long)all[STATE_MARK];
    p->tick = (long)all[STATE_TICK];
    p->stride = (long)all[STATE_STRIDE];
    p->scale = all[STATE_SCALE];
    p->past = all[STATE_PAST];
    p->settled = all[STATE_SETTLED] != 0;
    p->even = (long)all[STATE_EVEN];
    p->worst = all[STATE_WORST];
}

enum status state_write(const char *path, const struct cable_case *c, const char *extra,
                        const struct march *m, const struct energy *e,
                        const struct progress_mark *mark, struct why *why)
{
    size_t n = model_unknowns(m->model);
    size_t size = STATE_HEAD + 3 * n + mark->n_more;
    double *all = mem_doubles(size);
    struct out o;
    enum status s = all ? state_checksum(c, extra, &all[STATE_CASE_HIGH], &all[STATE_CASE_LOW], why)
                        : fail_plain(why, SW_NOMEM);

    if (s != SW_OK) {
        free(all);
        return s;
    }
    all[STATE_VERSION] = VERSION;
    all[STATE_ELEMENTS] = m->model->n;
    all[STATE_DT] = m->options.dt;
    all[STATE_STEP] = (double)m->step;
    all[STATE_ROWS] = (double)mark->rows;
    all[STATE_BYTES] = (double)mark->bytes;
    all[STATE_FIELDS] = (double)mark->fields;
    all[STATE_SLACK_TIME] = m->slack_time;
    all[STATE_SLACK_THETA] = m->slack_theta;
    put_energy(e, all + STATE_ENERGY);
    put_march(m, all);
    if (mark->n_more > 0)
        memcpy(all + STATE_HEAD + 3 * n, mark->more, sizeof *all * mark->n_more);
    s = out_open(&o, path, why);
    if (s == SW_OK) {
        npy_write(&o, 1, size, 1, all);
        s = out_close(&o, why);
    }
    free(all);
    return s;
}

/* The numbers of path, judged by their size and version. */
static enum status read_state(const char *path, const struct model *m, struct npy *ret,
                              struct why *why)
{
    size_t n = model_unknowns(m);
    struct in in;
    enum status s = in_open(path, &in, why);

    *ret = (struct npy){.data = NULL};
    if (s != SW_OK)
        return s;
    s = npy_read(&in, ret, why);
    if (s == SW_OK &&
        (ret->columns != 1 || ret->rows < STATE_HEAD || ret->data[STATE_VERSION] != VERSION))
        s = fail(why, SW_FORMAT, "%s: is no state of diffverf", path);
    if (s == SW_OK && (ret->data[STATE_ELEMENTS] != m->n || ret->rows < STATE_HEAD + 3 * n ||
                       !(ret->data[STATE_DT] > 0)))
        s = fail(why, SW_FORMAT, "%s: is the state of %g elements; the case has %d", path,
                 ret->data[STATE_ELEMENTS], m->n);
    for (size_t i = STATE_HEAD; s == SW_OK && i < STATE_HEAD + 3 * n; i++)
        if (!isfinite(ret->data[i]))
            s = fail(why, SW_FORMAT, "%s: is damaged: a displacement is no number", path);
    in_close_replaceable(&in);
    if (s != SW_OK)
        npy_free(ret);
    return s;
}

/* Whether the counters are whole numbers that a long holds; a damaged file may hold anything. */
static int counters_are_whole(const double *all)
{
    static const int at[] = {STATE_STEP, STATE_ROWS, STATE_BYTES,  STATE_FIELDS,
                             STATE_MARK, STATE_TICK, STATE_STRIDE, STATE_EVEN};

    for (size_t i = 0; i < sizeof at / sizeof *at; i++)
        if (!(fabs(all[at[i]]) <= 9e15 && all[at[i]] == floor(all[at[i]])))
            return 0;
    return all[STATE_STEP] >= 0;
}

enum status state_resume(const char *path, const struct cable_case *c, const char *extra,
                         struct march *m, struct energy *e, struct progress_mark *mark,
                         struct why *why)
{
    size_t n = model_unknowns(m->model);
    double high, low;
    struct npy a;
    enum status s = state_checksum(c, extra, &high, &low, why);

    if (s == SW_OK)
        s = read_state(path, m->model, &a, why);
    if (s != SW_OK)
        return s;
    if (a.data[STATE_CASE_HIGH] != high || a.data[STATE_CASE_LOW] != low ||
        a.data[STATE_DT] != m->options.dt || a.rows != STATE_HEAD + 3 * n + mark->n_more) {
        s = fail(why, SW_FORMAT,
                 "%s: is the state of another case, or of other options; only time.end may change",
                 path);
    } else if (!counters_are_whole(a.data)) {
        s = fail(why, SW_FORMAT, "%s: is damaged: a counter is no whole number", path);
    } else {
        m->step = (long)a.data[STATE_STEP];
        m->slack_time = a.data[STATE_SLACK_TIME];
        m->slack_theta = a.data[STATE_SLACK_THETA];
        mark->rows = (long)a.data[STATE_ROWS];
        mark->bytes = (long)a.data[STATE_BYTES];
        mark->fields = (long)a.data[STATE_FIELDS];
        if (mark->n_more > 0)
            memcpy(mark->more, a.data + STATE_HEAD + 3 * n, sizeof *mark->more * mark->n_more);
        take_energy(a.data + STATE_ENERGY, e);
        take_march(a.data, m);
    }
    npy_free(&a);
    return s;
}

enum status state_path(const char *given, const char *result, char **ret, struct why *why)
{
    const char *path = given ? given : result;
    size_t size = path ? strlen(path) + sizeof ".state" : 0;

    *ret = NULL;
    if (!path || strcmp(path, "-") == 0)
        return SW_OK;
    *ret = mem_zeroed(size, 1);
    if (!*ret)
        return fail_plain(why, SW_NOMEM);
    snprintf(*ret, size, "%s%s", path, given ? "" : ".state");
    return SW_OK;
}

int state_due(double *saved, double seconds)
{
    struct timespec t;
    double now;

    clock_gettime(CLOCK_MONOTONIC, &t);
    now = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
    if (*saved == 0)
        *saved = now;
    if (now - *saved < seconds)
        return 0;
    *saved = now;
    return 1;
}

int state_is_there(const char *path)
{
    return access(path, R_OK) == 0;
}

enum status state_start(const char *path, const struct model *m, double *V, double *W,
                        struct why *why)
{
    size_t n = model_unknowns(m);
    struct npy a;
    enum status s = read_state(path, m, &a, why);

    if (s != SW_OK)
        return s;
    for (size_t i = 0; i < n && s == SW_OK; i++) {
        const double *at = a.data + STATE_HEAD + i;

        V[i] = at[0];
        W[i] = a.data[STATE_SCHEME] == SCHEME_ALPHA ? at[n]
                                                    : (at[n] + at[2 * n] / 2) / a.data[STATE_DT];
        if (!isfinite(W[i]))
            s = fail(why, SW_FORMAT, "%s: is damaged: a velocity is infinite", path);
    }
    npy_free(&a);
    return s;
}
