/*
 * What the tests of failures share: each request for memory of some work fails in turn.
 */
#ifndef SEILWERK_TESTS_FAILS_H
#define SEILWERK_TESTS_FAILS_H

#include "check.h"

#include "num/mem.h"
#include "num/status.h"

#include <dlfcn.h>
#include <string.h>
#include <suitesparse/SuiteSparse_config.h>

/* Work that makes its results, checks them if there are any, frees them and tells how it went. */
typedef enum status (*fails_work)(void *context);

/* The n-th request of work fails, n = 1, 2, ...: it must tell so each time (unless lenient: what
 * CHOLMOD asks for it can often do without), and succeed when all are met, as often as it is
 * called.  Returns their number. */
static inline unsigned long fails_count(fails_work work, void *context, int lenient)
{
    for (unsigned long n = 1; n < 100000; n++) {
        enum status s;
        unsigned long left;

        mem_fail_at(n);
        s = work(context);
        left = mem_fail_at(0);
        if (left > 0) {
            assert_int_equal(s, SW_OK);
            return n - 1;
        }
        if (s == SW_NOMEM || (lenient && s == SW_OK))
            continue;
        print_error("request %lu failed: %s\n", n, status_text(s));
        assert_int_equal(s, SW_NOMEM);
    }
    assert_true(0); /* no end */
    return 0;
}

static inline unsigned long fails_each(fails_work work, void *context)
{
    return fails_count(work, context, 0);
}

static inline void *fails_malloc(size_t n)
{
    return mem_zeroed(n, 1);
}

static inline void *fails_calloc(size_t n, size_t size)
{
    return mem_zeroed(n, size);
}

static inline void *fails_realloc(void *p, size_t n)
{
    return mem_resize(p, n, 1);
}

/* The same, requests of CHOLMOD included. */
static inline unsigned long fails_each_of_cholmod(fails_work work, void *context)
{
    struct SuiteSparse_config_struct *c = dlsym(RTLD_DEFAULT, "SuiteSparse_config"), before;
    unsigned long n;

    assert_non_null(c);
    before = *c;
    c->malloc_func = fails_malloc;
    c->calloc_func = fails_calloc;
    c->realloc_func = fails_realloc;
    n = fails_count(work, context, 1);
    *c = before;
    return n;
}

#endif
