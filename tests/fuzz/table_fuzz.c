/* Any bytes as a table of cables: each row is refused with words that name its line, or a cable
 * that hangs; as many cells come out as the header has. */
#include "form/table.h"
#include "fuzz.h"
#include "phys/line.h"

#include <math.h>
#include <string.h>

/* Commas of the present row as printed, none in quotes. */
static int separators(const struct table *t)
{
    char *text = NULL;
    size_t size;
    struct out o = {.slot = -1};
    int n = 0, quoted = 0;

    o.f = open_memstream(&text, &size);
    check(o.f);
    table_print(t, &o);
    fclose(o.f);
    for (const char *p = text; *p; p++) {
        quoted ^= *p == '"';
        n += *p == ',' && !quoted;
    }
    free(text);
    return n;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct cable_case c;
    struct opt_list sets = {NULL, 0};
    struct in in = {.f = bytes(data, size), .name = "fuzz"};
    struct table t;
    struct why why = {""};
    enum status s = SW_OK;
    int line = 0, frequency = 0;

    err_level(1, 0);
    if (table_begin(&in, &sets, &t, &why) == SW_OK) {
        for (int i = 0; i < t.n; i++) /* large models take their time */
            frequency |= strstr(t.csv.cell[i], "frequency") != NULL;
        while (!frequency) {
            char place[40];

            why.text[0] = '\0';
            s = table_row(&t, &c, &why);
            if (s == SW_OK && !t.csv.cell)
                break;
            check(t.csv.line > line);
            line = t.csv.line;
            check((s == SW_OK) == (why.text[0] == '\0'));
            snprintf(place, sizeof place, "fuzz:%d: ", line);
            check(s == SW_OK || strncmp(why.text, place, strlen(place)) == 0);
            check(separators(&t) == t.n - 1);
            check(s != SW_OK || (isfinite(c.cable.L0) && !line_inadmissible(&c.cable)));
        }
        table_end(&t);
    } else {
        check(strncmp(why.text, "fuzz:", 5) == 0);
    }
    fclose(in.f);
    return 0;
}
