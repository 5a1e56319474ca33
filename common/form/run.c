/* The files of a run. */
#include "form/run.h"
#include "sys/npy.h"

#include <stdlib.h>
#include <string.h>

static int is_file(const char *path)
{
    return path && strcmp(path, "-") != 0;
}

enum status run_prepare(struct run *r, struct why *why)
{
    enum status s = state_path(r->state_given, r->rows_path, &r->state, why);

    if (s == SW_OK && r->state_given && !r->state)
        s = fail(why, SW_USAGE, "option --state: a file is expected");
    if (s == SW_OK && r->resume && !r->state)
        s = fail(why, SW_USAGE,
                 "option --resume needs the state: give --state, or -o FILE as in the run that was "
                 "stopped");
    if (s == SW_OK && r->resume)
        s = state_resume(r->state, r->c, r->columns, r->march, r->energy, &r->mark, why);
    return s;
}

/* Numbers of one field: three of each node. */
static size_t height(const struct run *r)
{
    return 3 * ((size_t)r->march->model->n + 1);
}

/* time.end, and so the number of fields, may have changed since the run was stopped: the header is
 * always written anew. */
static enum status open_field(struct run *r, size_t fields, struct why *why)
{
    long bytes = NPY_HEADER_BYTES + r->mark.fields * (long)(height(r) * sizeof(double));
    enum status s = r->resume ? out_resume(&r->field, r->field_path, bytes, why)
                              : out_open(&r->field, r->field_path, why);

    if (s != SW_OK)
        return s;
    if (r->resume)
        rewind(r->field.f);
    npy_begin(&r->field, 2, height(r), fields);
    if (r->resume && fseek(r->field.f, bytes, SEEK_SET) != 0)
        s = fail(why, SW_WRITE, "%s: cannot be continued", r->field_path);
    return s;
}

enum status run_open(struct run *r, size_t fields, struct why *why)
{
    enum status s;

    if (r->resume && (r->mark.bytes >= 0) != is_file(r->rows_path))
        return fail(why, SW_USAGE, "%s: the run that was stopped wrote %s: go on in the same way",
                    r->state, r->mark.bytes >= 0 ? "a file, by -o" : "on standard output");
    s = r->resume && r->mark.bytes >= 0 ? out_resume(&r->rows, r->rows_path, r->mark.bytes, why)
                                        : out_open(&r->rows, r->rows_path, why);
    if (s != SW_OK)
        return s;
    if (!r->state_given && r->rows.slot < 0) { /* a device: nothing to go on from */
        free(r->state);
        r->state = NULL;
    }
    return r->field_path ? open_field(r, fields, why) : SW_OK;
}

void run_field(struct run *r)
{
    const struct model *m = r->march->model;

    for (int k = 0; k <= m->n; k++) {
        const double *node = r->march->V + 6 * (size_t)k;
        double v[3];

        axes_to_space(&m->axes, (double[3]){node[0], node[2], node[4]}, v);
        fwrite(v, sizeof *v, 3, r->field.f);
    }
    r->mark.fields++;
}

int run_failed(struct run *r)
{
    return out_failed(&r->rows) || (r->field_path && out_failed(&r->field));
}

static enum status save(struct run *r, struct why *why)
{
    r->mark.bytes = out_bytes(&r->rows);
    if (r->field_path)
        out_bytes(&r->field);
    return state_write(r->state, r->c, r->columns, r->march, r->energy, &r->mark, why);
}

enum status run_checkpoint(struct run *r, struct why *why)
{
    return r->state && state_due(&r->saved, (double)r->checkpoint) ? save(r, why) : SW_OK;
}

enum status run_stop(struct run *r, struct why *why)
{
    enum status s = SW_OK;

    if (!r->state)
        return s;
    s = save(r, why);
    if (s == SW_OK)
        s = out_keep(&r->rows, why);
    if (s == SW_OK && r->field_path)
        s = out_keep(&r->field, why);
    return s;
}

enum status run_close(struct run *r, struct why *why)
{
    enum status s = r->state_given ? save(r, why) : SW_OK;

    if (s == SW_OK)
        s = out_close(&r->rows, why);
    if (s == SW_OK && r->field_path)
        s = out_close(&r->field, why);
    if (s == SW_OK && r->state && !r->state_given)
        remove(r->state);
    free(r->state);
    r->state = NULL;
    return s;
}
