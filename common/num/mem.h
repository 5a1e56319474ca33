/*
 * Checked allocation.
 *
 * All memory of Seilwerk's own code comes from here, so that a test can make the n-th request fail
 * and see that each caller gives back what it holds and returns SW_NOMEM.  Memory is freed with
 * free().  The counter, and the limit of simd.h, are the only global state of num; both are for
 * tests.
 */
#ifndef SEILWERK_NUM_MEM_H
#define SEILWERK_NUM_MEM_H

#include <stddef.h>

/* n elements of size bytes, set to zero; NULL if memory ran out or n * size overflows.  n = 0 gives
 * a pointer that may be freed. */
void *mem_zeroed(size_t n, size_t size);

/* n doubles, set to zero; NULL as above. */
double *mem_doubles(size_t n);

/* Copy of the n bytes at p; NULL as above. */
void *mem_copy(const void *p, size_t n);

/* p, grown or shrunk to n elements of size bytes, new ones not set; NULL leaves p as it was. */
void *mem_resize(void *p, size_t n, size_t size);

/* For tests: the n-th request from now on fails (n = 1: the next), and it alone; 0: none fails.
 * Returns how many were still to come before the one that was to fail: 0, it has. */
unsigned long mem_fail_at(unsigned long n);

#endif
