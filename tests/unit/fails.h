/*
 * What the tests of failures share: each request for memory of some work fails in turn.
 */
#ifndef SEILWERK_TESTS_FAILS_H
#define SEILWERK_TESTS_FAILS_H

#include "check.h"

#include "num/mem.h"
#include "num/status.h"

#include <string.h>

/* Work that makes its results, frees them and tells how it went. */
typedef enum status (*fails_work)(void *context);

/* The n-th request of work fails, n = 1, 2, ...: it must tell so each time, and succeed when all
 * requests are met, as often as it is called.  Returns their number. */
static inline unsigned long fails_each(fails_work work, void *context)
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
        if (s != SW_NOMEM)
            print_error("request %lu failed: %s\n", n, status_text(s));
        assert_int_equal(s, SW_NOMEM);
    }
    assert_true(0); /* no end */
    return 0;
}

#endif
