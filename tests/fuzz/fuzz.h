/*
 * What the fuzz targets share: bytes as a FILE, and a check that does not depend on NDEBUG.
 */
#ifndef SEILWERK_TESTS_FUZZ_H
#define SEILWERK_TESTS_FUZZ_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define check(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                        \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

/* The bytes as a file for reading; fmemopen refuses none of them. */
static inline FILE *bytes(const uint8_t *data, size_t size)
{
    static char nothing[1];
    FILE *f = size > 0 ? fmemopen((void *)(uintptr_t)data, size, "rb") : fmemopen(nothing, 1, "rb");

    check(f);
    if (size == 0)
        fgetc(f);
    return f;
}

#endif
