/* The state of a march: written, resumed, started from. */
#include "form/state.h"
#include "num/mem.h"
#include "sys/in.h"
#include "sys/npy.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define VERSION 1

/* FNV-1a. */
static uint64_t mix(uint64_t hash, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)text[i]) * 1099511628211u;
    return hash;
}

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
    hash = mix(mix(14695981039346656037u, text, length), extra, strlen(extra));
    free(text);
    *ret_high = (double)(hash >> 32);
    *ret_low = (double)(hash & 0xffffffff);
    return SW_OK;
}

static void put_energy(const struct energy *e, double *to)
{
    const double all[] = {e->kinetic,      e->strain,     e->supports, e->loads,
                          e->disturbances, e->dissipated, e->start,    e->power[0],
                          e->power[1],     e->power[2],   e->started};

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
                         .started = from[10] != 0};
}

enum status state_write(const char *path, const struct cable_case *c, const char *extra,
                        const struct march *m, const struct energy *e,
                        const struct progress_mark *mark, struct why *why)
{
    size_t n = model_unknowns(m->model);
    double *all = mem_doubles(STATE_HEAD + 3 * n);
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
    memcpy(all + STATE_HEAD, m->V, sizeof *all * n);
    memcpy(all + STATE_HEAD + n, m->D, sizeof *all * n);
    memcpy(all + STATE_HEAD + 2 * n, m->dd, sizeof *all * n);
    s = out_open(&o, path, why);
    if (s == SW_OK) {
        npy_write(&o, 1, STATE_HEAD + 3 * n, 1, all);
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
    if (s == SW_OK && (ret->columns != 1 || ret->rows < STATE_HEAD ||
                       ret->data[STATE_VERSION] != VERSION || (ret->rows - STATE_HEAD) % 3 != 0))
        s = fail(why, SW_FORMAT, "%s: is no state of diffverf", path);
    if (s == SW_OK && (ret->data[STATE_ELEMENTS] != m->n || ret->rows != STATE_HEAD + 3 * n ||
                       !(ret->data[STATE_DT] > 0)))
        s = fail(why, SW_FORMAT, "%s: is the state of %g elements; the case has %d", path,
                 ret->data[STATE_ELEMENTS], m->n);
    in_close_replaceable(&in);
    if (s != SW_OK)
        npy_free(ret);
    return s;
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
        a.data[STATE_DT] != m->options.dt) {
        s = fail(why, SW_FORMAT,
                 "%s: is the state of another case, or of other options; only time.end may change",
                 path);
    } else {
        m->step = (long)a.data[STATE_STEP];
        m->slack_time = a.data[STATE_SLACK_TIME];
        m->slack_theta = a.data[STATE_SLACK_THETA];
        *mark = (struct progress_mark){(long)a.data[STATE_ROWS], (long)a.data[STATE_BYTES],
                                       (long)a.data[STATE_FIELDS]};
        take_energy(a.data + STATE_ENERGY, e);
        memcpy(m->V, a.data + STATE_HEAD, sizeof *m->V * n);
        memcpy(m->D, a.data + STATE_HEAD + n, sizeof *m->D * n);
        memcpy(m->dd, a.data + STATE_HEAD + 2 * n, sizeof *m->dd * n);
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
    for (size_t i = 0; i < n; i++) {
        const double *at = a.data + STATE_HEAD + i;

        V[i] = at[0];
        W[i] = (at[n] + at[2 * n] / 2) / a.data[STATE_DT];
    }
    npy_free(&a);
    return s;
}
