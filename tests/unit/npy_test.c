/* .npy files: forms of the header, both orders, damage at each byte, memory that runs out. */
#include "textfile.h"

#include "num/mem.h"
#include "sys/npy.h"

static struct why why;

/* The bytes of a file. */
struct bytes {
    char b[4096];
    size_t n;
};

/* A file of the given format, dictionary and numbers; the header is padded as numpy does it. */
static struct bytes file_of(int format, const char *dictionary, const double *data, size_t n)
{
    struct bytes f = {"\x93NUMPY", format == 1 ? 10 : 12};
    size_t length = strlen(dictionary) + 1, pad = (64 - (f.n + length) % 64) % 64;

    f.b[6] = (char)format;
    f.b[8] = (char)((length + pad) & 255);
    f.b[9] = (char)((length + pad) >> 8);
    memcpy(f.b + f.n, dictionary, length - 1);
    memset(f.b + f.n + length - 1, ' ', pad);
    f.n += length + pad;
    f.b[f.n - 1] = '\n';
    if (n > 0)
        memcpy(f.b + f.n, data, n * sizeof *data);
    f.n += n * sizeof *data;
    return f;
}

static const double six[] = {1, 2, 3, -4.5, 1e-300, 6};

static struct bytes six_in(const char *order, const char *shape)
{
    char text[200];

    snprintf(text, sizeof text, "{'descr': '<f8', 'fortran_order': %s, 'shape': %s, }", order,
             shape);
    return file_of(1, text, six, 6);
}

static enum status read_file(const struct bytes *f, struct npy *ret)
{
    struct in in = in_with(f->b, f->n);
    enum status s;

    strcpy(why.text, "nothing");
    s = npy_read(&in, ret, &why);
    in_close(&in);
    if (s != SW_OK)
        assert_null(ret->data);
    return s;
}

static void good(const struct bytes *f, int dims, size_t rows, size_t columns, const double *data)
{
    struct npy a;

    if (read_file(f, &a) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
    assert_int_equal(a.dims, dims);
    assert_int_equal(a.rows, rows);
    assert_int_equal(a.columns, columns);
    assert_true(rows * columns == 0 || memcmp(a.data, data, rows * columns * sizeof *data) == 0);
    npy_free(&a);
}

static void bad(const struct bytes *f, const char *message)
{
    struct npy a;

    assert_int_equal(read_file(f, &a), SW_FORMAT);
    assert_string_equal(why.text, message);
}

static void bad_header(const char *dictionary, const char *message)
{
    struct bytes f = file_of(1, dictionary, six, 6);

    bad(&f, message);
}

static void both_orders(void **state)
{
    static const double turned[] = {1, 3, 1e-300, 2, -4.5, 6};
    struct bytes f = six_in("True", "(3, 2)"), c = six_in("False", "(3, 2)");
    struct bytes v = six_in("True", "(6,)"), w = six_in("False", "(6,)"),
                 r = six_in("False", "(1, 6)");
    (void)state;

    good(&f, 2, 3, 2, six);
    good(&c, 2, 3, 2, turned);
    good(&v, 1, 6, 1, six);
    good(&w, 1, 6, 1, six);
    good(&r, 2, 1, 6, six);
}

static void both_formats(void **state)
{
    static const char dictionary[] = "{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3), }";
    struct bytes one = file_of(1, dictionary, six, 6), two = file_of(2, dictionary, six, 6);
    struct bytes three = file_of(3, dictionary, six, 6);
    (void)state;

    good(&one, 2, 2, 3, six);
    good(&two, 2, 2, 3, six);
    bad(&three, "test: is no .npy file of format 1.0 or 2.0");
}

/* Keys in another order, other blanks: what other writers make. */
static void other_writers(void **state)
{
    struct bytes a = file_of(1, "{'shape':(2,3),'fortran_order':True,'descr':'<f8'}", six, 6);
    struct bytes b = file_of(1, "{'descr': '<f8', 'fortran_order': False, 'shape': (6,)}", six, 6);
    (void)state;

    good(&a, 2, 2, 3, six);
    good(&b, 1, 6, 1, six);
}

static void no_entries(void **state)
{
    static const char *const shape[] = {"(0,)", "(0, 3)", "(3, 0)"};
    static const size_t rows[] = {0, 0, 3}, columns[] = {1, 3, 0};
    (void)state;

    for (int i = 0; i < 3; i++)
        for (int order = 0; order < 2; order++) {
            struct bytes f = six_in(order ? "True" : "False", shape[i]);

            bad(&f, "test: more data than the header tells");
            f.n -= sizeof six;
            good(&f, i == 0 ? 1 : 2, rows[i], columns[i], six);
        }
}

/* Cut at each byte, and with a byte too many. */
static void cut(void **state)
{
    for (int format = 1; format <= 2; format++) {
        struct bytes f =
            file_of(format, "{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3), }", six, 6);
        size_t n = f.n, start = format == 1 ? 10 : 12;
        struct npy a;

        good(&f, 2, 2, 3, six);
        for (f.n = 0; f.n < n; f.n++) {
            assert_int_equal(read_file(&f, &a), SW_FORMAT);
            assert_string_equal(why.text, f.n < 10 ? "test: is no .npy file, or cut short"
                                          : f.n < n - sizeof six ? "test: the header is cut short"
                                                                 : "test: the data are cut short");
        }
        assert_true(n > sizeof six + start);
        f.n = n + 1;
        bad(&f, "test: more data than the header tells");
    }
    (void)state;
}

/* Each byte of the header changed in turn: read or refused, never worse; the first six refuse. */
static void changed(void **state)
{
    struct bytes f = six_in("True", "(2, 3)");
    (void)state;

    for (size_t i = 0; i < f.n - sizeof six; i++)
        for (int flip = 1; flip < 256; flip++) {
            struct bytes g = f;
            struct npy a;
            enum status s;

            g.b[i] = (char)(g.b[i] ^ flip);
            s = read_file(&g, &a);
            assert_true(s == SW_FORMAT || (s == SW_OK && i >= 6 && a.rows * a.columns == 6));
            if (s == SW_OK)
                npy_free(&a);
        }
}

static void wrong_headers(void **state)
{
    static const char type[] = "test: expected little-endian 64-bit floating point numbers ('<f8')";
    static const char dims[] = "test: expected an array with one or two dimensions";
    static const char keys[] = "test: the header lacks descr, fortran_order or shape";
    static const char *const other_type[] = {"'>f8'",  "'<f4'",          "'<i8'", "'|b1'",
                                             "'<c16'", "[('a', '<f8')]", "<f8"};
    static const char *const shape[] = {"(1, 2, 3)",
                                        "()",
                                        "6",
                                        "(-6,)",
                                        "(6.0,)",
                                        "(6",
                                        "( 6,)",
                                        "(a,)",
                                        "(2 3)",
                                        "(,)",
                                        "(2,,3)",
                                        "[6]",
                                        "(99999999999999999999,)",
                                        "(4294967296, 4294967296)",
                                        "(1152921504606846976,)",
                                        "(2305843009213693951, 8)"};
    char text[200];
    (void)state;

    for (size_t i = 0; i < sizeof other_type / sizeof *other_type; i++) {
        snprintf(text, sizeof text, "{'descr': %s, 'fortran_order': True, 'shape': (6,), }",
                 other_type[i]);
        bad_header(text, type);
    }
    for (size_t i = 0; i < sizeof shape / sizeof *shape; i++) {
        snprintf(text, sizeof text, "{'descr': '<f8', 'fortran_order': True, 'shape': %s, }",
                 shape[i]);
        bad_header(text, dims);
    }
    bad_header("{'fortran_order': True, 'shape': (6,), }", keys);
    bad_header("{'descr': '<f8', 'shape': (6,), }", keys);
    bad_header("{'descr': '<f8', 'fortran_order': True, }", keys);
    bad_header("", keys);
    bad_header("{'descr': '<f8', 'fortran_order': 1, 'shape': (6,), }",
               "test: fortran_order must be True or False");
}

/* A header that lies about the size, or is itself absurdly long, costs no memory. */
static void absurd_sizes(void **state)
{
    struct bytes f = six_in("True", "(100000000000, 1000)"), g = six_in("False", "(10000000000,)");
    struct bytes h = file_of(2, "{'descr': '<f8', 'fortran_order': True, 'shape': (6,), }", six, 6);
    (void)state;

    bad(&f, "test: the data are cut short");
    bad(&g, "test: the data are cut short");
    h.b[10] = 1;
    bad(&h, "test: the header is absurdly long");
    h.b[10] = 0;
    h.b[11] = (char)0xff;
    bad(&h, "test: the header is absurdly long");
}

static void no_npy(void **state)
{
    static const char text[] = "theta_m,x1_m,x2_m\n0,0,0\n";
    struct bytes f = {"", 0};
    (void)state;

    bad(&f, "test: is no .npy file, or cut short");
    memcpy(f.b, text, sizeof text - 1);
    f.n = sizeof text - 1;
    bad(&f, "test: is no .npy file, or cut short");
}

static void unreadable(void **state)
{
    struct in in = {.f = fopen("/", "rb"), .name = "test"};
    struct npy a;
    (void)state;

    assert_non_null(in.f);
    assert_int_equal(npy_read(&in, &a, &why), SW_READ);
    assert_string_equal(why.text, "test: cannot be read");
    in_close(&in);
}

/* Written and read: the same; header as the format asks for. */
static void round_trip(int dims, size_t rows, size_t columns)
{
    size_t n = rows * columns;
    double *data = malloc((n + 1) * sizeof *data);
    struct out o = {.f = tmpfile(), .slot = -1};
    struct in in = {.f = o.f, .name = "test"};
    char start[129] = "";
    struct npy a;

    assert_non_null(data);
    assert_non_null(o.f);
    for (size_t i = 0; i < n; i++)
        data[i] = i % 5 == 4 ? (double)NAN : ldexp((double)i, (int)i - 30);
    npy_write(&o, dims, rows, columns, data);
    rewind(o.f);
    assert_int_equal(fread(start, 1, 128, o.f), 128);
    assert_memory_equal(start,
                        "\x93NUMPY\1\0\x76\0{'descr': '<f8', 'fortran_order': True, 'shape': (",
                        60);
    assert_int_equal(start[127], '\n');
    assert_int_equal(fseek(o.f, 0, SEEK_END), 0);
    assert_int_equal(ftell(o.f), 128 + 8 * (long)n);
    rewind(o.f);
    assert_int_equal(npy_read(&in, &a, &why), SW_OK);
    assert_int_equal(a.dims, dims);
    assert_int_equal(a.rows, rows);
    assert_int_equal(a.columns, columns);
    assert_true(n == 0 || memcmp(a.data, data, n * sizeof *data) == 0);
    npy_free(&a);
    fclose(o.f);
    free(data);
}

static void round_trips(void **state)
{
    (void)state;
    round_trip(1, 7, 1);
    round_trip(2, 7, 1);
    round_trip(2, 3, 4);
    round_trip(2, 1, 1);
    round_trip(1, 0, 1);
    round_trip(2, 0, 5);
    round_trip(1, 65536, 1);
    round_trip(2, 601, 500); /* more than is read at once */
}

static void memory(void **state)
{
    struct bytes f = six_in("False", "(2, 3)");
    enum status s = SW_NOMEM;
    unsigned long n;
    (void)state;

    for (n = 1; s != SW_OK; n++) {
        struct npy a;

        mem_fail_at(n);
        s = read_file(&f, &a);
        mem_fail_at(0);
        if (s != SW_OK) {
            assert_int_equal(s, SW_NOMEM);
            assert_string_equal(why.text, "memory ran out");
        } else
            npy_free(&a);
    }
    assert_int_equal(n, 5); /* header, data, turned data */
}

TEST_MAIN(cmocka_unit_test(both_orders), cmocka_unit_test(both_formats),
          cmocka_unit_test(other_writers), cmocka_unit_test(no_entries), cmocka_unit_test(cut),
          cmocka_unit_test(changed), cmocka_unit_test(wrong_headers),
          cmocka_unit_test(absurd_sizes), cmocka_unit_test(no_npy), cmocka_unit_test(unreadable),
          cmocka_unit_test(round_trips), cmocka_unit_test(memory))
