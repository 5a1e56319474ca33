/* Checked allocation: sizes, overflow, requests that fail when asked to. */
#include "check.h"

#include "num/mem.h"

#include <string.h>

static void zeroed(void **state)
{
    (void)state;
    for (size_t n = 0; n < 2000; n += 37) {
        unsigned char *p = mem_zeroed(n, 3);

        assert_non_null(p);
        for (size_t i = 0; i < 3 * n; i++)
            assert_int_equal(p[i], 0);
        memset(p, 0xff, 3 * n);
        free(p);
    }
}

static void doubles(void **state)
{
    double *x = mem_doubles(1000), *none = mem_doubles(0);
    (void)state;

    assert_non_null(x);
    assert_non_null(none);
    for (int i = 0; i < 1000; i++)
        assert_true(x[i] == 0);
    free(x);
    free(none);
}

static void copies(void **state)
{
    const char text[] = "a text";
    char *copy = mem_copy(text, sizeof text);
    void *none = mem_copy(NULL, 0);
    (void)state;

    assert_non_null(copy);
    assert_ptr_not_equal(copy, text);
    assert_string_equal(copy, text);
    assert_non_null(none);
    free(copy);
    free(none);
}

static void resizes(void **state)
{
    int *p = NULL, *q;
    (void)state;

    for (int n = 1; n <= 1000; n *= 10) {
        q = mem_resize(p, (size_t)n, sizeof *p);
        assert_non_null(q);
        p = q;
        for (int i = 0; i < n / 10; i++)
            assert_int_equal(p[i], i);
        for (int i = 0; i < n; i++)
            p[i] = i;
    }
    q = mem_resize(p, 0, sizeof *p);
    assert_non_null(q);
    free(q);
}

/* n * size must not wrap around; a refused resize leaves the memory as it was. */
static void overflow(void **state)
{
    int *p = mem_zeroed(1, sizeof *p);
    (void)state;

    assert_non_null(p);
    *p = 7;
    assert_null(mem_zeroed(SIZE_MAX / 2 + 1, 2));
    assert_null(mem_zeroed(SIZE_MAX, SIZE_MAX));
    assert_null(mem_doubles(SIZE_MAX / 8 + 1));
    assert_null(mem_doubles(SIZE_MAX / 4));
    assert_null(mem_resize(p, SIZE_MAX / sizeof *p + 1, sizeof *p));
    assert_int_equal(*p, 7);
    free(p);
}

/* The n-th request fails, it alone, and each function counts. */
static void failing(void **state)
{
    (void)state;
    for (unsigned long n = 1; n <= 9; n++) {
        mem_fail_at(n);
        for (unsigned long i = 1; i <= 8; i++) {
            void *p = i % 4 == 0   ? mem_zeroed(1, 1)
                      : i % 4 == 1 ? mem_doubles(1)
                      : i % 4 == 2 ? mem_copy("x", 2)
                                   : mem_resize(NULL, 1, 1);

            assert_int_equal(p == NULL, i == n);
            free(p);
        }
        mem_fail_at(0);
    }
    for (int i = 0; i < 100; i++) {
        void *p = mem_zeroed(1, 1);

        assert_non_null(p);
        free(p);
    }
}

static void failing_resize(void **state)
{
    int *p = mem_zeroed(1, sizeof *p);
    (void)state;

    assert_non_null(p);
    *p = 7;
    mem_fail_at(1);
    assert_null(mem_resize(p, 100, sizeof *p));
    assert_int_equal(*p, 7);
    free(p);
}

TEST_MAIN(cmocka_unit_test(zeroed), cmocka_unit_test(doubles), cmocka_unit_test(copies),
          cmocka_unit_test(resizes), cmocka_unit_test(overflow), cmocka_unit_test(failing),
          cmocka_unit_test(failing_resize))
