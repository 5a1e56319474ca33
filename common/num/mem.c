/* Checked allocation with a request that can be made to fail. */
#include "num/mem.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static unsigned long countdown;

static int refused(size_t n, size_t size)
{
    if (size != 0 && n > SIZE_MAX / size)
        return 1;
    return countdown > 0 && --countdown == 0;
}

void *mem_zeroed(size_t n, size_t size)
{
    if (refused(n, size))
        return NULL;
    return calloc(n > 0 ? n : 1, size > 0 ? size : 1);
}

double *mem_doubles(size_t n)
{
    return mem_zeroed(n, sizeof(double));
}

void *mem_copy(const void *p, size_t n)
{
    void *copy = mem_zeroed(n, 1);

    if (copy && n > 0)
        memcpy(copy, p, n);
    return copy;
}

void *mem_resize(void *p, size_t n, size_t size)
{
    if (refused(n, size))
        return NULL;
    n *= size;
    return realloc(p, n > 0 ? n : 1);
}

unsigned long mem_fail_at(unsigned long n)
{
    unsigned long left = countdown;

    countdown = n;
    return left;
}
