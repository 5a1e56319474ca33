/* FNV-1a, to tell whether two texts are the same; not against malice. */
#ifndef SEILWERK_NUM_HASH_H
#define SEILWERK_NUM_HASH_H

#include <stddef.h>
#include <stdint.h>

#define HASH_START 14695981039346656037u

/* The hash of what came before, and of n more bytes. */
static inline uint64_t hash_more(uint64_t hash, const char *text, size_t n)
{
    for (size_t i = 0; i < n; i++)
        hash = (hash ^ (unsigned char)text[i]) * 1099511628211u;
    return hash;
}

#endif
