/* INI files: values, line numbers, each refusal with its message, memory that runs out. */
#include "textfile.h"

#include "num/mem.h"
#include "sys/ini.h"

static struct why why;

static enum status read_bytes(const char *text, size_t n, struct ini *ret)
{
    FILE *f = file_with(text, n);
    enum status s;

    strcpy(why.text, "nothing");
    s = ini_read(f, "test", ret, &why);
    fclose(f);
    return s;
}

/* The text is read; to be freed. */
static struct ini good(const char *text)
{
    struct ini ini;

    if (read_bytes(text, strlen(text), &ini) != SW_OK)
        print_error("%s\n", why.text);
    assert_string_equal(why.text, "nothing");
    return ini;
}

static void bad_bytes(const char *text, size_t n, const char *message)
{
    struct ini ini;

    assert_int_equal(read_bytes(text, n, &ini), SW_FORMAT);
    assert_string_equal(why.text, message);
    ini_free(&ini);
}

static void bad(const char *text, const char *message)
{
    bad_bytes(text, strlen(text), message);
}

static void is(const struct ini *ini, const char *section, const char *key, const char *value,
               int line)
{
    const struct ini_entry *e = ini_find(ini, section, key);

    assert_non_null(e);
    assert_string_equal(e->value, value);
    assert_int_equal(e->line, line);
}

static void values_and_lines(void **state)
{
    struct ini ini = good("# a comment\n"
                          "\n"
                          "[cable]\n"
                          "  length = 1.5   # metres\n"
                          "mass=2;no comment\n"
                          "\t; another comment\n"
                          "\tE = a = b ; comment\n"
                          "   \n"
                          "  [ motion   deck ]  # label\n"
                          "\n"
                          "text = with several  words\n"
                          "[empty]\n"
                          "[cable]\n"
                          "last = 7");
    (void)state;

    assert_int_equal(ini.n, 5);
    is(&ini, "cable", "length", "1.5", 4);
    is(&ini, "cable", "mass", "2;no comment", 5);
    is(&ini, "cable", "E", "a = b", 7);
    is(&ini, "motion deck", "text", "with several  words", 11);
    is(&ini, "cable", "last", "7", 14);
    assert_int_equal(ini.n_sections, 4);
    assert_string_equal(ini.section[1].section, "motion deck");
    assert_int_equal(ini.section[1].line, 9);
    assert_int_equal(ini.section[3].line, 13);
    assert_null(ini_find(&ini, "cable", "text"));
    assert_null(ini_find(&ini, "motion", "text"));
    ini_free(&ini);
}

/* An indented key is a key: no continuation of the value above. */
static void indented_keys(void **state)
{
    struct ini ini = good("[a]\n  x = 1\n  y = 2\n    z = 3\n");
    (void)state;

    is(&ini, "a", "x", "1", 2);
    is(&ini, "a", "y", "2", 3);
    is(&ini, "a", "z", "3", 4);
    ini_free(&ini);
    bad("[a]\nx = 1\n  2\n", "test:3: expected key = value");
}

static void line_ends(void **state)
{
    struct ini ini = good("\xef\xbb\xbf[a]\r\n\r\n# c\r\nx = 1\r\ny = 2 # d\r\n[b c]\r\nz = 3\r\n");
    (void)state;

    is(&ini, "a", "x", "1", 4);
    is(&ini, "a", "y", "2", 5);
    is(&ini, "b c", "z", "3", 7);
    assert_int_equal(ini.n, 3);
    ini_free(&ini);
    bad("[a]\r\n\r\nx\r\n", "test:3: expected key = value");
    bad("[a]\n\xef\xbb\xbfx\n", "test:2: expected key = value");
    bad("\xef\xbb\xbf\xef\xbb\xbf[a]\n", "test:1: expected key = value");
}

/* Text of a line of n bytes: key x with a comment behind. */
static char *line_of(size_t n)
{
    char *line = repeat('c', n);

    memcpy(line, "x = 1 #", 7);
    return line;
}

/* Around the limit, with each line end, with a byte order mark, as last line. */
static void long_lines(void **state)
{
    static const char *const begin[] = {"", "\xef\xbb\xbf"};
    static const char *const end[] = {"\n", "\r\n", ""};
    (void)state;

    for (size_t b = 0; b < 2; b++)
        for (size_t e = 0; e < 3; e++)
            for (size_t n = 196; n <= 203; n++) {
                char *line = line_of(n), text[512], section[300];
                struct ini ini;

                snprintf(section, sizeof section, "%s[a] #%s", begin[b], line + 5);
                snprintf(text, sizeof text, "%s%s%s", section, end[e], e < 2 ? "x = 1\n" : "");
                assert_int_equal(strlen(section), n + strlen(begin[b]));
                assert_int_equal(read_bytes(text, strlen(text), &ini),
                                 n <= INI_LINE_BYTES ? SW_OK : SW_FORMAT);
                if (n > INI_LINE_BYTES)
                    assert_string_equal(why.text, "test:1: the line is longer than 198 bytes");
                ini_free(&ini);
                snprintf(text, sizeof text, "%s[a]\n%s%s", begin[b], line, end[e]);
                assert_int_equal(read_bytes(text, strlen(text), &ini),
                                 n <= INI_LINE_BYTES ? SW_OK : SW_FORMAT);
                if (n > INI_LINE_BYTES)
                    assert_string_equal(why.text, "test:2: the line is longer than 198 bytes");
                else
                    is(&ini, "a", "x", "1", 2);
                ini_free(&ini);
                free(line);
            }
}

/* A value that fills its line comes whole, as does a key. */
static void whole_values(void **state)
{
    char *value = repeat('v', INI_LINE_BYTES - 4), *key = repeat('k', INI_LINE_BYTES - 4);
    char text[512];
    struct ini ini;
    (void)state;

    snprintf(text, sizeof text, "[a]\nx = %s\n%s = y\n", value, key);
    ini = good(text);
    is(&ini, "a", "x", value, 2);
    is(&ini, "a", key, "y", 3);
    ini_free(&ini);
    free(value);
    free(key);
}

/* Sections are told apart by all of their names. */
static void long_sections(void **state)
{
    char *label = repeat('m', 150), text[512], one[200], two[200];
    struct ini ini;
    (void)state;

    snprintf(one, sizeof one, "%s 1", label);
    snprintf(two, sizeof two, "%s 2", label);
    snprintf(text, sizeof text, "[%s]\nx = 1\n[%s]\nx = 2\n", one, two);
    ini = good(text);
    is(&ini, one, "x", "1", 2);
    is(&ini, two, "x", "2", 4);
    ini_free(&ini);
    free(label);
}

static void refusals(void **state)
{
    (void)state;
    bad("[a\n", "test:1: a section is written [name] or [name label]");
    bad("[a] b\n", "test:1: a section is written [name] or [name label]");
    bad("[a]]\n", "test:1: a section is written [name] or [name label]");
    bad("[a #b]\n", "test:1: a section is written [name] or [name label]");
    bad("\n[]\n", "test:2: the section has no name");
    bad("[  ]\n", "test:1: the section has no name");
    bad("# c\n\nx = 1\n", "test:3: the key stands before any [section]");
    bad("[a]\nx\n", "test:2: expected key = value");
    bad("[a]\n= 1\n", "test:2: expected key = value");
    bad("[a]\nx: 1\n", "test:2: expected key = value");
    bad("[a]\nx: 1 = 2\n", "test:2: a key ends with '=', not with ':'");
    bad("[a]\nx =\n", "test:2: the key has no value");
    bad("[a]\nx = # 1\n", "test:2: the key has no value");
    bad("[a]\nx =#1\n", "test:2: the key has no value");
    bad("[a]\nx=;1\n", "test:2: the key has no value");
    bad("[a]\nx = 1\ny = 2\n\nx = 3\n", "test:5: [a] x was given in line 2 already");
    bad("[a]\nx = 1\n[b]\nx = 1\n[ a ]\nx = 1\n", "test:6: [a] x was given in line 2 already");
    bad("[a  b]\nx = 1\n[a b]\nx = 1\n", "test:4: [a b] x was given in line 2 already");
    bad("[a]\nx = 1\nx\ny\n", "test:3: expected key = value");
    bad_bytes("[a]\nx = 1\0\n", 11, "test:2: a NUL byte: this is no text file");
    bad_bytes("\0", 1, "test:1: a NUL byte: this is no text file");
    bad_bytes("\xff\xfe[\0a\0]\0", 8, "test:1: a NUL byte: this is no text file");
}

static void nothing(void **state)
{
    static const char *const texts[] = {"", "\n", "# c", "\r\n\r\n", "\xef\xbb\xbf", "; c\n  \t\n"};
    (void)state;

    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct ini ini = good(texts[i]);

        assert_int_equal(ini.n, 0);
        assert_int_equal(ini.n_sections, 0);
        ini_free(&ini);
    }
}

static void colon_in_value(void **state)
{
    struct ini ini = good("[a]\nx = 1:2\n[b:c]\nx = 3\n");
    (void)state;

    is(&ini, "a", "x", "1:2", 2);
    is(&ini, "b:c", "x", "3", 4);
    ini_free(&ini);
}

static void unreadable(void **state)
{
    struct ini ini;
    FILE *f = fopen("/", "rb");
    (void)state;

    assert_non_null(f);
    assert_int_equal(ini_read(f, "test", &ini, &why), SW_READ);
    assert_string_equal(why.text, "test: cannot be read");
    ini_free(&ini);
    fclose(f);
}

static void set(struct ini *ini, const char *assignment)
{
    if (ini_set(ini, assignment, &why) != SW_OK) {
        print_error("%s\n", why.text);
        assert_true(0);
    }
}

static void sets(void **state)
{
    struct ini ini = good("[a]\nx = 1\ny = 2\n[b c]\nx = 3\n");
    (void)state;

    set(&ini, "a.x=10");
    is(&ini, "a", "x", "10", 0);
    set(&ini, " b  c . x = 4 5 ");
    is(&ini, "b c", "x", "4 5", 0);
    set(&ini, "d.z=p=q.r");
    is(&ini, "d", "z", "p=q.r", 0);
    set(&ini, "b 1.5.x=6");
    is(&ini, "b 1.5", "x", "6", 0);
    assert_string_equal(ini.section[ini.n_sections - 1].section, "b 1.5");
    assert_int_equal(ini.section[ini.n_sections - 1].line, 0);
    set(&ini, "a.y=");
    assert_null(ini_find(&ini, "a", "y"));
    set(&ini, "a.y= ");
    set(&ini, "none.none=");
    assert_int_equal(ini.n, 4);
    set(&ini, "a.y=7");
    is(&ini, "a", "y", "7", 0);
    set(&ini, "a.y=8");
    is(&ini, "a", "y", "8", 0);
    assert_int_equal(ini.n, 5);
    ini_free(&ini);
}

static void set_refusals(void **state)
{
    static const char *const wrong[] = {"",     "a",    "a.x",   "=1",    "x=1",
                                        ".x=1", "a.=1", " .x=1", "a. =1", "a=1.5"};
    static const char *const section[] = {"a]b.x=1", "a #b.x=1", "a ;b.x=1", "[a].x=1", "#a.x=1"};
    static const char *const value[] = {"a.x=#1", "a.x=1 #b", "a.x= ;b", "a.x=1\n2"};
    struct ini ini = good("[a]\nx = 1\n");
    char *longest = repeat('1', INI_LINE_BYTES + 1), wanted[200];
    (void)state;

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_int_equal(ini_set(&ini, wrong[i], &why), SW_USAGE);
        snprintf(wanted, sizeof wanted, "--set %s: expected SECTION.KEY=VALUE", wrong[i]);
        assert_string_equal(why.text, wanted);
    }
    for (size_t i = 0; i < sizeof section / sizeof *section; i++) {
        assert_int_equal(ini_set(&ini, section[i], &why), SW_USAGE);
        snprintf(wanted, sizeof wanted, "--set %s: no file could hold such a section", section[i]);
        assert_string_equal(why.text, wanted);
    }
    for (size_t i = 0; i < sizeof value / sizeof *value; i++) {
        assert_int_equal(ini_set(&ini, value[i], &why), SW_USAGE);
        snprintf(wanted, sizeof wanted, "--set %s: no file could hold such a value", value[i]);
        assert_string_equal(why.text, wanted);
    }
    assert_int_equal(ini_set(&ini, "a.x=b=#c", &why), SW_OK);
    is(&ini, "a", "x", "b=#c", 0);
    memcpy(longest, "a.x=", 4);
    assert_int_equal(ini_set(&ini, longest, &why), SW_USAGE);
    assert_string_equal(why.text, "--set: longer than 198 bytes");
    longest[INI_LINE_BYTES] = '\0';
    assert_int_equal(ini_set(&ini, longest, &why), SW_OK);
    is(&ini, "a", "x", longest + 4, 0);
    ini_free(&ini);
    free(longest);
}

static void messages(void **state)
{
    struct ini ini = good("[a]\nx = 1\n");
    (void)state;

    set(&ini, "b.y=2");
    assert_int_equal(ini_fail(&why, &ini, ini_find(&ini, "a", "x"), "%d is odd", 1), SW_FORMAT);
    assert_string_equal(why.text, "test:2: 1 is odd");
    assert_int_equal(ini_fail(&why, &ini, ini_find(&ini, "b", "y"), "%d is even", 2), SW_USAGE);
    assert_string_equal(why.text, "--set b.y: 2 is even");
    assert_int_equal(ini_fail(&why, &ini, &ini.section[1], "unknown"), SW_USAGE);
    assert_string_equal(why.text, "--set b: unknown");
    ini_free(&ini);
}

/* Each request in turn fails: SW_NOMEM, and what there is can be freed. */
static void memory(void **state)
{
    static const char text[] = "[a]\nx = 1\ny = 2\n[b]\nz = 3\n[c d]\nx = 4\ny = 5\nz = 6\n";
    enum status s = SW_NOMEM;
    unsigned long n;
    (void)state;

    for (n = 1; s != SW_OK; n++) {
        struct ini ini;
        FILE *f = file_with(text, sizeof text - 1);

        mem_fail_at(n);
        s = ini_read(f, "test", &ini, &why);
        if (s == SW_OK)
            s = ini_set(&ini, "a.x=7", &why);
        if (s == SW_OK)
            s = ini_set(&ini, "e.x=8", &why);
        mem_fail_at(0);
        fclose(f);
        if (s != SW_OK) {
            assert_int_equal(s, SW_NOMEM);
            assert_string_equal(why.text, "memory ran out");
        }
        ini_free(&ini);
    }
    assert_true(n > 20);
}

TEST_MAIN(cmocka_unit_test(values_and_lines), cmocka_unit_test(indented_keys),
          cmocka_unit_test(line_ends), cmocka_unit_test(long_lines), cmocka_unit_test(whole_values),
          cmocka_unit_test(long_sections), cmocka_unit_test(refusals), cmocka_unit_test(nothing),
          cmocka_unit_test(colon_in_value), cmocka_unit_test(unreadable), cmocka_unit_test(sets),
          cmocka_unit_test(set_refusals), cmocka_unit_test(messages), cmocka_unit_test(memory))
