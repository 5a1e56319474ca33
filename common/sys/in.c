/* Input files, remembered by device and inode. */
#include "sys/in.h"

#include <errno.h>
#include <string.h>

#define MAX_INPUTS 64 /* more are read, but no longer guarded; no tool opens as many */

static struct {
    dev_t dev;
    ino_t ino;
} seen[MAX_INPUTS];
static int n_seen;

enum status in_open(const char *path, struct in *ret, struct why *why)
{
    struct stat st;

    *ret = (struct in){.f = stdin, .name = "<stdin>"};
    if (strcmp(path, "-") != 0) {
        ret->name = path;
        ret->f = fopen(path, "rb");
    }
    if (!ret->f || fstat(fileno(ret->f), &st) != 0)
        return fail(why, errno == ENOMEM ? SW_NOMEM : SW_READ, "%s: cannot be opened: %s",
                    ret->name, strerror(errno));
    if (S_ISDIR(st.st_mode)) {
        in_close(ret);
        return fail(why, SW_READ, "%s: is a directory; a file is expected", path);
    }
    if (S_ISREG(st.st_mode) && n_seen < MAX_INPUTS && !in_was_read(&st)) {
        seen[n_seen].dev = st.st_dev;
        seen[n_seen++].ino = st.st_ino;
        ret->noted = 1;
    }
    return SW_OK;
}

void in_close(struct in *in)
{
    if (in->f && in->f != stdin)
        fclose(in->f);
    in->f = NULL;
}

void in_close_replaceable(struct in *in)
{
    in_close(in);
    if (in->noted)
        n_seen--;
    in->noted = 0;
}

int in_was_read(const struct stat *st)
{
    for (int i = 0; i < n_seen; i++)
        if (seen[i].dev == st->st_dev && seen[i].ino == st->st_ino)
            return 1;
    return 0;
}
