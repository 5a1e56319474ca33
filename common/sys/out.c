/* Output files, signals, progress. */
#include "sys/out.h"
#include "sys/in.h"
#include "sys/number.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define MAX_OPEN 16

/* Unfinished files, for the signal handler.  The mark is set when the path is there, and before the
 * file is; it is taken away when the file is gone. */
static char unfinished[MAX_OPEN][PATH_MAX];
static volatile sig_atomic_t in_use[MAX_OPEN], deferred;
static atomic_int pending; /* the signal may come to any thread, and all ask for it */

static void remove_unfinished(void)
{
    for (int i = 0; i < MAX_OPEN; i++)
        if (in_use[i]) {
            unlink(unfinished[i]);
            in_use[i] = 0;
        }
}

static void on_signal(int sig)
{
    if (deferred && (sig == SIGINT || sig == SIGTERM)) {
        int none = 0; /* the first counts, however many come: timeout(1) sends it twice */

        atomic_compare_exchange_strong(&pending, &none, sig);
        return;
    }
    remove_unfinished();
    signal(sig, SIG_DFL);
    raise(sig);
}

void out_prepare(void)
{
    static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

    for (int fd = 0; fd <= 2; fd++) /* so that no file of ours gets their numbers */
        if (fcntl(fd, F_GETFD) == -1 && open("/dev/null", fd == 0 ? O_WRONLY : O_RDONLY) != fd)
            exit(1);
    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
        struct sigaction act = {.sa_handler = on_signal, .sa_flags = SA_RESTART};
        struct sigaction old;

        sigemptyset(&act.sa_mask);
        sigaction(ending[i], NULL, &old);
        if (old.sa_handler != SIG_IGN || ending[i] == SIGPIPE)
            sigaction(ending[i], &act, NULL);
    }
    signal(SIGXFSZ, SIG_IGN); /* write then fails with EFBIG */
    atexit(remove_unfinished);
}

void signals_defer(void)
{
    deferred = 1;
}

int signals_pending(void)
{
    return pending;
}

void signals_end(struct out *o)
{
    if (o->f && o->slot < 0)
        fflush(o->f); /* complete rows; an unfinished file vanishes instead */
    remove_unfinished();
    signal(pending, SIG_DFL);
    raise(pending);
    _exit(128 + pending);
}

/* Open o->path's FILE.part, empty or as it is, and note it as unfinished.  Its name can be guessed:
 * where others may write, too, a link or a file that they have put there must not be written to. */
static enum status open_part(struct out *o, int resumed, struct why *why)
{
    char part[PATH_MAX];
    struct stat st;
    int fd, length = snprintf(part, sizeof part, "%s.part", o->path);

    if (length >= (int)sizeof part)
        return fail(why, SW_WRITE, "%s: the path is too long", o->name);
    if (stat(part, &st) == 0 && in_was_read(&st))
        return fail(why, SW_USAGE, "%s: is an input of this run", part);
    for (int i = 0; i < MAX_OPEN; i++)
        if (in_use[i] && strcmp(unfinished[i], part) == 0)
            return fail(why, SW_USAGE, "%s: is written twice in this run", o->name);
    for (o->slot = 0; o->slot < MAX_OPEN && in_use[o->slot]; o->slot++)
        ;
    if (o->slot == MAX_OPEN) {
        o->slot = -1;
        return fail(why, SW_WRITE, "%s: too many files are open", o->name);
    }
    memcpy(unfinished[o->slot], part, (size_t)length + 1);
    in_use[o->slot] = 1;
    /* A file that was here is no file of this run; what cannot be removed is told of. */
    fd = !resumed && unlink(part) != 0 && errno != ENOENT
             ? -1
             : open(part, O_WRONLY | O_CREAT | O_NOFOLLOW | (resumed ? 0 : O_EXCL), 0666);
    o->f = fd >= 0 ? fdopen(fd, "wb") : NULL;
    if (o->f)
        return SW_OK;
    fail(why, SW_WRITE, "%s: cannot be written: %s", part, strerror(errno));
    if (fd >= 0) {
        close(fd);
        if (!resumed)
            unlink(part);
    }
    in_use[o->slot] = 0;
    o->slot = -1;
    return SW_WRITE;
}

/* Final path of name: its links followed, as far as it exists. */
static enum status resolve(struct out *o, const char *name, struct why *why)
{
    struct stat st;

    if (lstat(name, &st) == 0 && S_ISLNK(st.st_mode)) {
        if (realpath(name, o->path))
            return SW_OK;
        return fail(why, SW_WRITE, "%s: the link leads nowhere: %s", name, strerror(errno));
    }
    if (snprintf(o->path, sizeof o->path, "%s", name) >= (int)sizeof o->path)
        return fail(why, SW_WRITE, "%s: the path is too long", name);
    return SW_OK;
}

enum status out_open(struct out *o, const char *path, struct why *why)
{
    struct stat st;
    enum status s = SW_OK;

    *o = (struct out){.slot = -1};
    if (!path || strcmp(path, "-") == 0) {
        o->name = "<stdout>";
        o->f = stdout;
        if (fstat(STDOUT_FILENO, &st) == 0 && S_ISREG(st.st_mode) && in_was_read(&st))
            return fail(why, SW_USAGE, "standard output is an input of this run");
        return SW_OK;
    }
    o->name = path;
    if (stat(path, &st) == 0) {
        if (S_ISDIR(st.st_mode))
            return fail(why, SW_WRITE, "%s: is a directory; a file is expected", path);
        if (in_was_read(&st))
            return fail(why, SW_USAGE, "%s: is an input of this run", path);
        if (!S_ISREG(st.st_mode)) {
            o->f = fopen(path, "wb");
            if (!o->f)
                return fail(why, SW_WRITE, "%s: cannot be written: %s", path, strerror(errno));
            return SW_OK;
        }
    }
    s = resolve(o, path, why);
    return s == SW_OK ? open_part(o, 0, why) : s;
}

/* Copy from to a new file to. */
static int copy_file(const char *from, const char *to)
{
    FILE *in = fopen(from, "rb"), *out;
    char block[65536];
    size_t n;
    int good;

    if (!in)
        return 0;
    out = fopen(to, "wb");
    good = out != NULL;
    while (good && (n = fread(block, 1, sizeof block, in)) > 0)
        good = fwrite(block, 1, n, out) == n;
    good = good && !ferror(in);
    fclose(in);
    if (out && fclose(out) != 0)
        good = 0;
    return good;
}

enum status out_resume(struct out *o, const char *path, long bytes, struct why *why)
{
    char part[PATH_MAX + 8];
    struct stat st;
    enum status s;

    *o = (struct out){.slot = -1, .name = path};
    s = resolve(o, path, why);
    if (s != SW_OK)
        return s;
    snprintf(part, sizeof part, "%s.part", o->path);
    if (stat(part, &st) != 0 && (stat(o->path, &st) != 0 || !S_ISREG(st.st_mode)))
        return fail(why, SW_READ, "%s: neither it nor %s.part is there to be continued", path,
                    path);
    if (st.st_size < bytes)
        return fail(why, SW_READ, "%s: holds %ld bytes; the state was saved after %ld", path,
                    (long)st.st_size, bytes);
    if (stat(part, &st) != 0 && !copy_file(o->path, part)) {
        unlink(part);
        return fail(why, SW_WRITE, "%s: cannot be written: %s", part, strerror(errno));
    }
    s = open_part(o, 1, why);
    if (s != SW_OK)
        return s;
    if (ftruncate(fileno(o->f), bytes) != 0 || fseek(o->f, bytes, SEEK_SET) != 0)
        return fail(why, SW_WRITE, "%s: cannot be cut back: %s", part, strerror(errno));
    return SW_OK;
}

long out_bytes(struct out *o)
{
    if (o->slot < 0 || fflush(o->f) != 0 || fsync(fileno(o->f)) != 0)
        return -1;
    return ftell(o->f);
}

void out_number(struct out *o, double x)
{
    char text[NUMBER_SIZE];

    fwrite_unlocked(text, 1, number_print(x, text), o->f);
}

void out_row(struct out *o, const double *x, int n)
{
    for (int i = 0; i < n; i++) {
        out_number(o, x[i]);
        putc_unlocked(i < n - 1 ? ',' : '\n', o->f);
    }
    out_failed(o);
}

void out_cell(struct out *o, const char *text)
{
    int quoted = text[strcspn(text, ",\"\r\n")] != '\0';

    if (quoted)
        putc_unlocked('"', o->f);
    for (; *text; text++) {
        if (*text == '"')
            putc_unlocked('"', o->f);
        putc_unlocked(*text, o->f);
    }
    if (quoted)
        putc_unlocked('"', o->f);
}

int out_failed(struct out *o)
{
    if (o->error == 0 && ferror(o->f)) {
        int before = errno;

        errno = 0; /* other calls may have come since; another try says the reason again */
        o->error = fflush(o->f) != 0 && errno ? errno : before ? before : EIO;
    }
    return o->error != 0;
}

enum status out_finish(struct out *o, struct why *why)
{
    int error = out_failed(o) ? o->error : 0;

    if (fflush(o->f) != 0 && error == 0)
        error = errno ? errno : EIO;
    if (error == 0 && o->slot >= 0 && fsync(fileno(o->f)) != 0)
        error = errno;
    if (fclose(o->f) != 0 && error == 0)
        error = errno;
    o->f = NULL;
    if (error == 0)
        return SW_OK;
    if (o->slot >= 0) {
        unlink(unfinished[o->slot]);
        in_use[o->slot] = 0;
        o->slot = -1;
    }
    return fail(why, SW_WRITE, "%s: cannot be written: %s", o->name, strerror(error));
}

enum status out_keep(struct out *o, struct why *why)
{
    enum status s = out_finish(o, why);

    if (s == SW_OK && o->slot >= 0) {
        in_use[o->slot] = 0;
        o->slot = -1;
    }
    return s;
}

enum status out_rename(struct out *o, struct why *why)
{
    if (o->slot < 0)
        return SW_OK;
    if (rename(unfinished[o->slot], o->path) != 0)
        return fail(why, SW_WRITE, "%s: cannot be renamed to: %s", o->path, strerror(errno));
    in_use[o->slot] = 0;
    o->slot = -1;
    return SW_OK;
}

enum status out_close(struct out *o, struct why *why)
{
    enum status s = out_finish(o, why);

    return s == SW_OK ? out_rename(o, why) : s;
}

void progress(double done, const char *what)
{
    static double last;
    struct timespec t;
    double now;

    if (err_quiet() || (!err_verbose() && !isatty(STDERR_FILENO)))
        return;
    clock_gettime(CLOCK_MONOTONIC, &t);
    now = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
    if (now - last < (isatty(STDERR_FILENO) ? 0.1 : 2))
        return;
    last = now;
    fprintf(stderr, isatty(STDERR_FILENO) ? "\r%s %3.0f %%" : "%s %3.0f %%\n", what, 100 * done);
}

void progress_end(void)
{
    if (!err_quiet() && isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
}
