/* A result of many rows and its state. */
#include "form/rowsfile.h"
#include "form/state.h"
#include "sys/in.h"
#include "sys/npy.h"

#include <stdlib.h>
#include <string.h>

/* The state: a NumPy vector. */
enum { VERSION, CASE_HIGH, CASE_LOW, NEXT, BYTES, FAILED, N_STATE };

static enum status read_state(struct rows_file *f, long *bytes, struct why *why)
{
    struct npy a = {.data = NULL};
    double high, low;
    struct in in;
    enum status s = in_open(f->state, &in, why);

    if (s != SW_OK)
        return s;
    s = npy_read(&in, &a, why);
    in_close_replaceable(&in);
    if (s == SW_OK && (a.columns != 1 || a.rows != N_STATE || a.data[VERSION] != (double)f->kind))
        s = fail(why, SW_FORMAT, "%s: is no state of such a run", f->state);
    if (s == SW_OK)
        s = state_checksum(f->c, f->columns, &high, &low, why);
    if (s == SW_OK && (a.data[CASE_HIGH] != high || a.data[CASE_LOW] != low))
        s = fail(why, SW_FORMAT, "%s: is the state of another case, or of other options", f->state);
    if (s == SW_OK) {
        f->next = (long)a.data[NEXT];
        *bytes = (long)a.data[BYTES];
        f->failed = a.data[FAILED] != 0;
    }
    npy_free(&a);
    return s;
}

enum status rows_file_open(struct rows_file *f, struct why *why)
{
    long bytes = 0;
    enum status s = state_path(NULL, f->path, &f->state, why);

    if (s == SW_OK && f->resume && !f->state)
        s = fail(why, SW_USAGE, "option --resume needs -o FILE as in the run that was stopped");
    if (s == SW_OK && f->resume)
        s = read_state(f, &bytes, why);
    if (s == SW_OK)
        s = f->resume ? out_resume(&f->out, f->path, bytes, why) : out_open(&f->out, f->path, why);
    if (s == SW_OK && f->out.slot < 0) { /* a device: nothing to go on from */
        free(f->state);
        f->state = NULL;
    }
    return s;
}

static enum status save(struct rows_file *f, struct why *why)
{
    double all[N_STATE] = {(double)f->kind, 0, 0, (double)f->next, (double)out_bytes(&f->out),
                           f->failed};
    enum status s = state_checksum(f->c, f->columns, &all[CASE_HIGH], &all[CASE_LOW], why);
    struct out o;

    if (s == SW_OK)
        s = out_open(&o, f->state, why);
    if (s != SW_OK)
        return s;
    npy_write(&o, 1, N_STATE, 1, all);
    return out_close(&o, why);
}

enum status rows_file_checkpoint(struct rows_file *f, struct why *why)
{
    return f->state && state_due(&f->saved, (double)f->checkpoint) ? save(f, why) : SW_OK;
}

enum status rows_file_stop(struct rows_file *f, struct why *why)
{
    enum status s = f->state ? save(f, why) : SW_OK;

    return s == SW_OK && f->state ? out_keep(&f->out, why) : s;
}

enum status rows_file_close(struct rows_file *f, struct why *why)
{
    enum status s = out_close(&f->out, why);

    if (s == SW_OK && f->state)
        remove(f->state);
    free(f->state);
    f->state = NULL;
    return s;
}
