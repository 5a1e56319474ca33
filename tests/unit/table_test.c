/* Tables of cables: columns, defaults, rows that cannot be used, memory that runs out. */
#include "textfile.h"

#include "form/table.h"
#include "num/mem.h"

#define HEAD "name,span,supports.drop,unstressed_length,mass_per_length,axial_stiffness\n"

static struct why why;
static struct cable_case c;

struct file {
    struct in in;
    struct table t;
};

static enum status begin_with(struct file *f, const char *text, const char *set)
{
    struct opt_list sets = {&set, set != NULL};
    enum status s;

    f->in = in_with(text, strlen(text));
    strcpy(why.text, "nothing");
    err_level(1, 0); /* the warnings are those of tests/cli/catenary.sh */
    s = table_begin(&f->in, &sets, &f->t, &why);
    if (s != SW_OK)
        in_close(&f->in);
    return s;
}

static void begin(struct file *f, const char *text, const char *set)
{
    if (begin_with(f, text, set) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
}

static void end(struct file *f)
{
    table_end(&f->t);
    in_close(&f->in);
}

static void row(struct file *f)
{
    if (table_row(&f->t, &c, &why) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
    assert_non_null(f->t.csv.cell);
}

static void refused(struct file *f, enum status wanted, const char *message)
{
    assert_int_equal(table_row(&f->t, &c, &why), wanted);
    assert_string_equal(why.text, message);
    strcpy(why.text, "nothing");
}

static void no_more(struct file *f)
{
    for (int i = 0; i < 2; i++) {
        assert_int_equal(table_row(&f->t, &c, &why), SW_OK);
        assert_null(f->t.csv.cell);
    }
    end(f);
}

/* The cells of the present row as printed. */
static void prints(const struct file *f, const char *wanted)
{
    char *text = NULL;
    size_t size;
    struct out o = {.f = open_memstream(&text, &size), .slot = -1};

    assert_non_null(o.f);
    table_print(&f->t, &o);
    fclose(o.f);
    assert_string_equal(text, wanted);
    free(text);
}

static void rows(void **state)
{
    struct file f;
    (void)state;

    begin(&f,
          HEAD "a,10.01,1,10,2,1e6\n\n\"b, \"\"2\"\"\", 20 ,,20.5,3,\"2e6\"\r\n"
               "c,10.01,-1,10,2,1e6",
          NULL);
    assert_int_equal(f.t.n, 6);
    prints(&f, "name,span,supports.drop,unstressed_length,mass_per_length,axial_stiffness");
    row(&f);
    assert_true(c.bare.span == 10.01 && c.bare.drop == 1 && c.bare.L0 == 10 && c.bare.mu == 2);
    assert_true(c.bare.EA == 1e6 && c.bare.g == 9.81 && !c.found);
    assert_true(c.cable.span == 10.01 && axes_are_plain(&c.axes));
    prints(&f, "a,10.01,1,10,2,1e6");
    row(&f);
    assert_int_equal(f.t.csv.line, 4);
    assert_true(c.bare.span == 20 && c.bare.drop == 0 && c.bare.EA == 2e6);
    prints(&f, "\"b, \"\"2\"\"\",20,,20.5,3,2e6");
    row(&f);
    assert_true(c.bare.drop == -1);
    no_more(&f);
}

/* --set stands for a missing column and for an empty cell, not for a full one; nothing of a row is
 * left for the next. */
static void defaults(void **state)
{
    struct file f;
    (void)state;

    begin(&f,
          "span,unstressed_length,wind,mass_per_length,axial_stiffness,drop\n"
          "10.01,10,1 2 3,2,1e6,2\n10.01,10,,2,1e6,\n",
          "supports.drop=1.5");
    row(&f);
    assert_true(c.bare.drop == 2 && c.load.wind[2] == 3 && !axes_are_plain(&c.axes));
    row(&f);
    assert_true(c.bare.drop == 1.5 && c.load.wind[2] == 0 && axes_are_plain(&c.axes));
    no_more(&f);
    begin(&f, HEAD "a,10.01,1,,2,1e6\nb,10.01,1,10,2,1e6\n", "cable.sag=0.25");
    row(&f); /* another given */
    assert_true(c.found && c.bare.L0 > 10);
    refused(&f, SW_FORMAT,
            "test:3: sag: give exactly one of unstressed_length, horizontal_force, "
            "midspan_tension, tension_left, tension_right, sag, fundamental_frequency, frequency");
    no_more(&f);
}

static void headers(void **state)
{
    static const struct {
        const char *text, *message;
    } bad[] = {
        {"", "test: is empty; a header line is expected"},
        {"\n\r\n", "test: is empty; a header line is expected"},
        {"span;drop\n1;2\n",
         "test:1: columns are separated by ';'; expected ',' (and '.' in numbers)"},
        {"name,colour\n",
         "test:1: no column is a key of a cable; a header line is expected, such as "
         "span,unstressed_length,..."},
        {"110.5,110.2\n", "test:1: no column is a key of a cable; a header line is expected, such "
                          "as span,unstressed_length,..."},
        {"span,drop,span\n", "test:1: columns 1 and 3 are both 'span'"},
        {"span,supports.span\n", "test:1: columns 1 and 2 are both 'supports.span'"},
        {"\nname,name,span\n", "test:2: columns 1 and 2 are both 'name'"},
        {"span,\"x\"y\n", "test:1: a quote is wrong: a cell is either quoted as a whole, with \"\" "
                          "for a quote inside, or not at all, and ends on its line"},
    };
    struct file f;
    (void)state;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(begin_with(&f, bad[i].text, NULL), SW_FORMAT);
        assert_string_equal(why.text, bad[i].message);
    }
    assert_int_equal(begin_with(&f, HEAD, "time.end=1"), SW_USAGE);
    assert_string_equal(why.text, "--set time.end: belongs to no section of the model");
    assert_int_equal(begin_with(&f, HEAD, "cable.area=x"), SW_USAGE);
    begin(&f, "name,colour,omega,span\n", NULL); /* no keys of the model: copied */
    for (int i = 0; i < 4; i++)
        assert_int_equal(f.t.key[i] != NULL, i == 3);
    no_more(&f);
}

/* A row that cannot be used is named by its line; the next one is as good as ever. */
static void bad_rows(void **state)
{
    struct file f;
    (void)state;

    begin(&f,
          HEAD "a,x,1,10,2,1e6\n"
               "a,10,1,10,2\n"
               "a,10,1,10,2,1e6,7\n"
               "a,nan,1,10,2,1e6\n"
               "a,\"10,5\",1,10,2,1e6\n"
               "a,1 2,1,10,2,1e6\n"
               "a,-1,1,10,2,1e6\n"
               "a,10,1,10,,1e6\n"
               "a,10,1,,2,1e6\n"
               "a,\"10,1,10,2,1e6\n"
               "\"ok\",10.01,1,10,2,1e6\n",
          NULL);
    refused(&f, SW_FORMAT, "test:2: column 2: span: 'x': not a number");
    prints(&f, "a,x,1,10,2,1e6");
    refused(&f, SW_FORMAT, "test:3: 5 cells; the header has 6");
    prints(&f, "a,10,1,10,2,");
    refused(&f, SW_FORMAT,
            "test:4: 7 cells; the header has 6 (a decimal comma, or a text with commas that is not "
            "quoted?)");
    prints(&f, "a,10,1,10,2,1e6");
    refused(&f, SW_FORMAT, "test:5: column 2: span: 'nan': not a number");
    refused(&f, SW_FORMAT,
            "test:6: column 2: span: '10,5': a decimal point is expected, not a comma");
    refused(&f, SW_FORMAT, "test:7: column 2: span: more than 1 number");
    refused(&f, SW_FORMAT, "test:8: column 2: span: -1 is outside of 1e-06 to 1e+09");
    refused(&f, SW_FORMAT, "test:9: mass_per_length: is missing");
    refused(&f, SW_FORMAT,
            "test:10: unstressed_length: is missing, and nothing that it follows from is given");
    refused(&f, SW_FORMAT,
            "test:11: a quote is wrong: a cell is either quoted as a whole, with \"\" for a quote "
            "inside, or not at all, and ends on its line");
    prints(&f, ",,,,,");
    row(&f);
    assert_int_equal(f.t.csv.line, 12);
    no_more(&f);
}

/* What only the cable as a whole shows. */
static void cables_that_are_none(void **state)
{
    struct file f;
    (void)state;

    begin(&f,
          "span,acceleration,unstressed_length,tension_left,fundamental_frequency,mass_per_length,"
          "axial_stiffness,wind\n"
          "10,0,10.5,,,2,1e6,\n"
          "10,,,1,,2,1e6,\n"
          "10,0,9,,,2,1e6,1 0 0\n"
          "10,,,,1e-3,2,1e6,\n"
          "10,,,,1.5,2,1e6,\n",
          "mesh.elements=4");
    refused(&f, SW_ADMISSIBLE,
            "test:2: without gravity the chord must be longer than the unstressed length");
    refused(&f, SW_INFEASIBLE,
            "test:3: tension_left: no length gives 1; the least possible is 148.005864");
    refused(&f, SW_FORMAT, "test:4: wind: together with the weight acts along the chord");
    assert_int_equal(table_row(&f.t, &c, &why), SW_INFEASIBLE);
    assert_non_null(strstr(why.text, "test:5: fundamental_frequency: no length gives 0.001"));
    strcpy(why.text, "nothing");
    row(&f);
    assert_true(c.found);
    no_more(&f);
}

/* A cell longer than any line of a case, and a header name of a kilobyte. */
static void long_cells(void **state)
{
    char *digits = repeat('1', 2000), *text = malloc(5000);
    struct file f;
    (void)state;

    assert_non_null(text);
    snprintf(text, 5000, "span,%s\n%s,x\n", digits, digits);
    begin(&f, text, NULL);
    assert_int_equal(table_row(&f.t, &c, &why), SW_FORMAT);
    assert_string_equal(why.text, "test:2: column 1: span: longer than 198 bytes");
    strcpy(why.text, "nothing");
    no_more(&f);
    free(digits);
    free(text);
}

static void unreadable(void **state)
{
    struct file f = {.in = {.f = fopen("/", "rb"), .name = "test"}};
    struct opt_list sets = {NULL, 0};
    (void)state;

    assert_non_null(f.in.f);
    assert_int_equal(table_begin(&f.in, &sets, &f.t, &why), SW_READ);
    assert_string_equal(why.text, "test: cannot be read");
    in_close(&f.in);
}

/* Each request for memory fails once, from the header to the last row. */
static void memory(void **state)
{
    static const char text[] =
        "span,mass_per_length,axial_stiffness,fundamental_frequency\n10,2,1e6,1.5\n10,2,1e6,3\n";
    enum status s = SW_NOMEM;
    unsigned long n;
    (void)state;

    for (n = 1; s != SW_OK; n++) {
        struct file f;

        mem_fail_at(n);
        s = begin_with(&f, text, "mesh.elements=2");
        if (s == SW_OK) {
            for (int i = 0; i < 2 && s == SW_OK; i++)
                s = table_row(&f.t, &c, &why);
            end(&f);
        }
        mem_fail_at(0);
        if (s != SW_OK) {
            assert_int_equal(s, SW_NOMEM);
            assert_non_null(strstr(why.text, "memory ran out"));
        }
        assert_true(n < 100000);
    }
    assert_true(n > 30);
}

TEST_MAIN(cmocka_unit_test(rows), cmocka_unit_test(defaults), cmocka_unit_test(headers),
          cmocka_unit_test(bad_rows), cmocka_unit_test(cables_that_are_none),
          cmocka_unit_test(long_cells), cmocka_unit_test(unreadable), cmocka_unit_test(memory))
