/* CSV rows: cells, line numbers, each refusal with its message, memory that runs out. */
#include "textfile.h"

#include "num/mem.h"
#include "sys/csv.h"

static struct why why;

struct file {
    struct in in;
    struct csv csv;
};

static void begin_bytes(struct file *f, const char *text, size_t n)
{
    f->in = in_with(text, n);
    strcpy(why.text, "nothing");
    assert_int_equal(csv_begin(&f->in, &f->csv, &why), SW_OK);
}

static void begin(struct file *f, const char *text)
{
    begin_bytes(f, text, strlen(text));
}

static void end(struct file *f)
{
    csv_end(&f->csv);
    in_close(&f->in);
}

/* The next row's cells, joined by '|'. */
static void row(struct file *f, int line, const char *cells)
{
    char joined[256] = "";
    size_t used = 0;

    if (csv_row(&f->csv, &why) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
    for (int i = 0; i < f->csv.n; i++)
        used += (size_t)snprintf(joined + used, sizeof joined - used, "%s%s", i > 0 ? "|" : "",
                                 f->csv.cell[i]);
    assert_string_equal(joined, cells);
    assert_int_equal(f->csv.line, line);
}

static void no_more(struct file *f)
{
    for (int i = 0; i < 2; i++) {
        assert_int_equal(csv_row(&f->csv, &why), SW_OK);
        assert_int_equal(f->csv.n, 0);
        assert_null(f->csv.cell);
    }
    end(f);
}

static void refused(struct file *f, const char *message)
{
    assert_int_equal(csv_row(&f->csv, &why), SW_FORMAT);
    assert_string_equal(why.text, message);
    strcpy(why.text, "nothing");
}

static void rows_and_lines(void **state)
{
    struct file f;
    (void)state;

    begin(&f, "a,b,c\n1,2.5,-3e7\n\n , x y ,\n,,0\n4");
    row(&f, 1, "a|b|c");
    row(&f, 2, "1|2.5|-3e7");
    row(&f, 4, "|x y|");
    row(&f, 5, "||0");
    assert_int_equal(f.csv.n, 3);
    row(&f, 6, "4");
    no_more(&f);
}

static void line_ends(void **state)
{
    struct file f;
    (void)state;

    begin(&f, "\xef\xbb\xbf"
              "a,b\r\n\r\n1,2\r\n\n3,4\r");
    row(&f, 1, "a|b");
    row(&f, 3, "1|2");
    row(&f, 5, "3|4");
    no_more(&f);
    begin(&f, "\xef\xbb\xbf\n\xef\xbb\xbf"
              "a\n");
    row(&f, 2,
        "\xef\xbb\xbf"
        "a");
    no_more(&f);
    begin(&f, "\xef\xbb\xbf");
    no_more(&f);
    begin(&f, "");
    no_more(&f);
    begin(&f, "\n\r\n  \n\n");
    no_more(&f);
}

static void carriage_returns(void **state)
{
    struct file f;
    (void)state;

    begin(&f, "a,b\n1,2\r3,4\n5,6\n");
    row(&f, 1, "a|b");
    refused(&f, "test:2: a carriage return inside of the line");
    row(&f, 3, "5|6");
    no_more(&f);
    begin(&f, "a,b\r1,2\r");
    refused(&f, "test:1: a carriage return inside of the line");
    end(&f);
}

static void quotes(void **state)
{
    struct file f;
    (void)state;

    begin(&f, "\"a\",\"b,c\",\"d\"\"e\"\n\"\",\" x \",\"#\"\r\n\"last\"");
    row(&f, 1, "a|b,c|d\"e");
    row(&f, 2, "| x |#");
    row(&f, 3, "last");
    no_more(&f);
}

/* An error in one row does not reach into the next. */
static void wrong_quotes(void **state)
{
    static const char *const wrong[] = {"\"open,1", "a\"b,1", "\"a\"b,1",
                                        "1,\"",     "\"\"\"", "a,b\""};
    (void)state;

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct file f;
        char text[64];

        snprintf(text, sizeof text, "a,b\n\n%s\n1,2\n", wrong[i]);
        begin(&f, text);
        row(&f, 1, "a|b");
        refused(&f, "test:3: a quote is wrong: a cell is either quoted as a whole, with \"\" for a "
                    "quote inside, or not at all, and ends on its line");
        row(&f, 4, "1|2");
        no_more(&f);
    }
}

static void nul_bytes(void **state)
{
    struct file f;
    (void)state;

    begin_bytes(&f, "a\n1\0002\n3\n", 8);
    row(&f, 1, "a");
    refused(&f, "test:2: a NUL byte: this is no text file");
    row(&f, 3, "3");
    no_more(&f);
    begin_bytes(&f, "\0", 1);
    refused(&f, "test:1: a NUL byte: this is no text file");
    end(&f);
}

static void headers(void **state)
{
    struct file f;
    (void)state;

    begin(&f, "\n\na,b\n");
    assert_int_equal(csv_header(&f.csv, &why), SW_OK);
    assert_int_equal(f.csv.n, 2);
    assert_int_equal(f.csv.line, 3);
    end(&f);
    begin(&f, "x\n1\n");
    assert_int_equal(csv_header(&f.csv, &why), SW_OK);
    end(&f);
    begin(&f, "a;b;c\n1;2;3\n");
    assert_int_equal(csv_header(&f.csv, &why), SW_FORMAT);
    assert_string_equal(why.text, "test:1: columns are separated by ';'; expected ',' (and '.' in "
                                  "numbers)");
    end(&f);
    begin(&f, "a\tb\n1\t2\n");
    assert_int_equal(csv_header(&f.csv, &why), SW_FORMAT);
    assert_string_equal(why.text, "test:1: columns are separated by tabs; expected ','");
    end(&f);
    begin(&f, "\n\n");
    assert_int_equal(csv_header(&f.csv, &why), SW_FORMAT);
    assert_string_equal(why.text, "test: is empty; a header line is expected");
    end(&f);
}

/* Rows of nothing but commas, as spreadsheets leave them, unless they are to count. */
static void bare_rows(void **state)
{
    struct file f;
    (void)state;

    begin(&f, "a,b\n,\n1,\n , \t\n,,,\n\"\",\n,");
    row(&f, 1, "a|b");
    row(&f, 3, "1|");
    row(&f, 6, "|");
    no_more(&f);
    begin(&f, "a,b\n,\n1,\n");
    f.csv.keep = 1;
    row(&f, 1, "a|b");
    row(&f, 2, "|");
    row(&f, 3, "1|");
    no_more(&f);
}

static void numbers(void **state)
{
    static const char *const message[] = {
        "test:2: column 2: 'x': not a number",
        "test:2: column 3: '': a number is missing",
        "test:2: column 4: '1,5': a decimal point is expected, not a comma",
        "test:2: column 5: 'nan': not a number",
        "test:2: column 6: '1e999': the number is too large",
    };
    struct file f;
    double x = 0;
    (void)state;

    begin(&f, "a,b,c,d,e,f\n 2.5 ,x,,\"1,5\",nan,1e999\n");
    row(&f, 1, "a|b|c|d|e|f");
    row(&f, 2, "2.5|x||1,5|nan|1e999");
    assert_int_equal(csv_number(&f.csv, 0, &x, &why), SW_OK);
    assert_true(x == 2.5);
    for (int i = 1; i < 6; i++) {
        assert_int_equal(csv_number(&f.csv, i, &x, &why), SW_FORMAT);
        assert_string_equal(why.text, message[i - 1]);
    }
    assert_true(x == 2.5);
    assert_int_equal(csv_fail(&why, &f.csv, "%d cells", 3), SW_FORMAT);
    assert_string_equal(why.text, "test:2: 3 cells");
    end(&f);
}

/* One cell of a megabyte, and a row of half a million cells. */
static void long_lines(void **state)
{
    size_t n = 1 << 20;
    char *cell = repeat('1', n), *cells = repeat(',', n);
    struct file f;
    (void)state;

    cell[n - 2] = '\n';
    begin_bytes(&f, cell, n);
    assert_int_equal(csv_row(&f.csv, &why), SW_OK);
    assert_int_equal(f.csv.n, 1);
    assert_int_equal(strlen(f.csv.cell[0]), n - 2);
    row(&f, 2, "1");
    no_more(&f);
    for (size_t i = 0; i < n; i += 2)
        cells[i] = (char)('0' + i / 2 % 10);
    cells[n - 1] = '\n';
    begin_bytes(&f, cells, n);
    assert_int_equal(csv_row(&f.csv, &why), SW_OK);
    assert_int_equal(f.csv.n, n / 2);
    for (int i = 0; i < f.csv.n; i++)
        assert_true(f.csv.cell[i][0] == '0' + i % 10 && f.csv.cell[i][1] == '\0');
    no_more(&f);
    free(cell);
    free(cells);
}

static void unreadable(void **state)
{
    struct file f;
    (void)state;

    f.in = (struct in){.f = fopen("/", "rb"), .name = "test"};
    assert_non_null(f.in.f);
    assert_int_equal(csv_begin(&f.in, &f.csv, &why), SW_OK);
    assert_int_equal(csv_row(&f.csv, &why), SW_READ);
    assert_string_equal(why.text, "test: cannot be read");
    end(&f);
}

static void memory(void **state)
{
    static const char text[] = "a,b\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20\n"
                               "a cell that is longer than all that came before it, so that memory "
                               "is asked for again\n";
    enum status s = SW_NOMEM;
    unsigned long n;
    (void)state;

    for (n = 1; s != SW_OK; n++) {
        struct in in = in_with(text, sizeof text - 1);
        struct csv c;

        mem_fail_at(n);
        s = csv_begin(&in, &c, &why);
        for (int i = 0; i < 3 && s == SW_OK; i++)
            s = csv_row(&c, &why);
        mem_fail_at(0);
        if (s != SW_OK) {
            assert_int_equal(s, SW_NOMEM);
            assert_string_equal(why.text, "memory ran out");
        }
        csv_end(&c);
        in_close(&in);
    }
    assert_true(n > 6);
}

TEST_MAIN(cmocka_unit_test(rows_and_lines), cmocka_unit_test(line_ends),
          cmocka_unit_test(carriage_returns), cmocka_unit_test(quotes),
          cmocka_unit_test(wrong_quotes), cmocka_unit_test(nul_bytes), cmocka_unit_test(headers),
          cmocka_unit_test(bare_rows), cmocka_unit_test(numbers), cmocka_unit_test(long_lines),
          cmocka_unit_test(unreadable), cmocka_unit_test(memory))
