/*
 * Open files with given bytes, for the tests of readers.
 */
#ifndef SEILWERK_TESTS_TEXTFILE_H
#define SEILWERK_TESTS_TEXTFILE_H

#include "check.h"

#include "sys/in.h"

#include <string.h>

/* A file that holds the n bytes. */
static inline FILE *file_with(const void *bytes, size_t n)
{
    FILE *f = n > 0 ? fmemopen((void *)bytes, n, "rb") : tmpfile();

    assert_non_null(f);
    return f;
}

/* The same for a text, named "test" in messages. */
static inline struct in in_with(const void *bytes, size_t n)
{
    return (struct in){.f = file_with(bytes, n), .name = "test"};
}

/* n times the character c, NUL-terminated; to be freed. */
static inline char *repeat(char c, size_t n)
{
    char *text = malloc(n + 1);

    assert_non_null(text);
    memset(text, c, n);
    text[n] = '\0';
    return text;
}

#endif
