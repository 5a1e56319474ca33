/*
 * Preloaded library that makes one call of a program fail, for the fault tests.
 *
 * SEILWERK_FAIL_ALLOC=n: the n-th malloc, calloc or realloc finds no memory; calls from within
 * OpenBLAS, libgfortran, the sanitizers and the dynamic loader do not count, they are not ours to
 * survive.
 * SEILWERK_FAIL_OUTPUT=n: the n-th open (to create), fdopen, fflush, fsync, fclose (of files to
 * write), rename or mkdir fails for want of space.
 */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static long allocations = -1, outputs = -1; /* calls still to go; negative: not read yet */

static long setting(const char *name)
{
    const char *text = getenv(name);

    return text ? strtol(text, NULL, 10) : 0;
}

/* Tell that the fault has happened, past our own open. */
static void mark(void)
{
    const char *path = getenv("SEILWERK_FAULT_MARK");

    if (path)
        syscall(SYS_close, syscall(SYS_openat, AT_FDCWD, path, O_CREAT | O_WRONLY, 0666));
}

/* Whether the call that caller made fails now. */
static int allocation_fails(void *caller)
{
    Dl_info info;

    if (allocations < 0 && environ) /* not yet there when the first libraries begin */
        allocations = setting("SEILWERK_FAIL_ALLOC");
    if (allocations <= 0 || !dladdr(caller, &info) || !info.dli_fname ||
        strstr(info.dli_fname, "blas") || strstr(info.dli_fname, "ld-linux") ||
        strstr(info.dli_fname, "gfortran") || strstr(info.dli_fname, "san.so") || --allocations > 0)
        return 0;
    mark();
    return 1;
}

static int output_fails(void)
{
    if (outputs < 0)
        outputs = setting("SEILWERK_FAIL_OUTPUT");
    if (outputs == 0 || --outputs > 0)
        return 0;
    mark();
    errno = ENOSPC;
    return 1;
}

/* The function of this name that would be called without us. */
static void *next(const char *name)
{
    void *f = dlsym(RTLD_NEXT, name);

    if (!f)
        abort();
    return f;
}

/* variable := that function, without a cast between function and object pointers. */
#define NEXT(variable, name)                                                                       \
    do {                                                                                           \
        void *found = next(name);                                                                  \
        memcpy(&(variable), &found, sizeof found);                                                 \
    } while (0)

void *malloc(size_t n)
{
    static void *(*f)(size_t);

    if (!f)
        NEXT(f, "malloc");
    return allocation_fails(__builtin_return_address(0)) ? (errno = ENOMEM, NULL) : f(n);
}

void *calloc(size_t n, size_t size)
{
    static void *(*f)(size_t, size_t);

    if (!f)
        NEXT(f, "calloc");
    return allocation_fails(__builtin_return_address(0)) ? (errno = ENOMEM, NULL) : f(n, size);
}

void *realloc(void *p, size_t n)
{
    static void *(*f)(void *, size_t);

    if (!f)
        NEXT(f, "realloc");
    return allocation_fails(__builtin_return_address(0)) ? (errno = ENOMEM, NULL) : f(p, n);
}

int open(const char *path, int flags, ...)
{
    int (*f)(const char *, int, ...);
    va_list args;
    mode_t mode;

    NEXT(f, "open");
    va_start(args, flags);
    mode = flags & O_CREAT ? va_arg(args, mode_t) : 0;
    va_end(args);
    return (flags & O_CREAT) && output_fails() ? -1 : f(path, flags, mode);
}

FILE *fdopen(int fd, const char *mode)
{
    FILE *(*f)(int, const char *);

    NEXT(f, "fdopen");
    return output_fails() ? NULL : f(fd, mode);
}

int fflush(FILE *file)
{
    int (*f)(FILE *);

    NEXT(f, "fflush");
    return output_fails() ? EOF : f(file);
}

int fsync(int fd)
{
    int (*f)(int);

    NEXT(f, "fsync");
    return output_fails() ? -1 : f(fd);
}

int fclose(FILE *file)
{
    int (*f)(FILE *);
    int fails = __fwritable(file) && output_fails(), result;

    NEXT(f, "fclose");
    result = f(file);
    return fails ? (errno = ENOSPC, EOF) : result;
}

int rename(const char *from, const char *to)
{
    int (*f)(const char *, const char *);

    NEXT(f, "rename");
    return output_fails() ? -1 : f(from, to);
}

int mkdir(const char *path, mode_t mode)
{
    int (*f)(const char *, mode_t);

    NEXT(f, "mkdir");
    return output_fails() ? -1 : f(path, mode);
}
